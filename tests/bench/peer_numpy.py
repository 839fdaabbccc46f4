#!/usr/bin/env python3
"""Does the sampler's work in efficient NumPy and SciPy; prints CPU seconds as JSON.

U training rows, d inputs, nine unknown bins of eleven.  Constants of the sampling are computed
before: L⁻¹ of every bin, the distances of fixed inputs per scene.  One sweep draws every unknown bin once in
all chains.  The draws are from a normal truncated at the ceiling (inverse of the distribution function).
"""
import json
import sys
import time

import peer_blas

peer_blas.prepare()

import numpy as np
from scipy.linalg import blas, cho_solve, cholesky, lapack, solve_triangular
from scipy.special import ndtr, ndtri

U, D, BINS, UNKNOWN = 1400, 21, 11, 9
SIGNAL, NOISE = 0.2, 0.02
SECONDS = 0.4  # minimum per result


class Bin:
    """One Gaussian process with everything a prediction needs."""

    def __init__(self, rng):
        self.X = rng.standard_normal((U, D)) / 5.0  # in length scales
        y = np.sin(self.X[:, 0]) + NOISE * rng.standard_normal(U)
        K = SIGNAL**2 * np.exp(-0.5 * squared_distances(self.X, self.X)) + NOISE**2 * np.eye(U)
        self.L = cholesky(K, lower=True)
        self.alpha = cho_solve((self.L, True), y)
        self.inverse = np.asfortranarray(lapack.dtrtri(self.L, lower=1)[0])
        self.inverse32 = self.inverse.astype(np.float32)


def squared_distances(A, B):
    return np.maximum((A * A).sum(1)[:, None] + (B * B).sum(1)[None, :] - 2.0 * A @ B.T, 0.0)


class Scene:
    """One bin at one scene: inputs 0 … m − 1 move, the rest is a weight per training row."""

    def __init__(self, gp, x, product):
        m = UNKNOWN - 1
        self.gp, self.product = gp, product
        self.X = np.ascontiguousarray(gp.X[:, :m])
        self.norm = (self.X * self.X).sum(1)[:, None]
        self.weight = -0.5 * ((gp.X[:, m:] - x[m:]) ** 2).sum(1)[:, None] + 2.0 * np.log(SIGNAL)

    def predict(self, Z):
        """Returns mean and variance at the columns of Z: m × chains."""
        distance = self.norm + (Z * Z).sum(0) - 2.0 * (self.X @ Z)
        k = np.asfortranarray(np.exp(self.weight - 0.5 * distance))
        mean = self.gp.alpha @ k
        v = self.product(self.gp, k)
        return mean, np.maximum(SIGNAL**2 + NOISE**2 - (v * v).sum(0), NOISE**2)


def by_full_product(gp, k):
    return gp.inverse @ k


def by_triangular_product(gp, k):
    return blas.dtrmm(1.0, gp.inverse, k, lower=1)


def by_triangular_vector(gp, k):
    return blas.dtrmv(gp.inverse, k[:, 0], lower=1)[:, None]


def by_solve(gp, k):
    return solve_triangular(gp.L, k, lower=True, check_finite=False)


def by_full_product32(gp, k):
    return (gp.inverse32 @ k.astype(np.float32)).astype(float)


def by_triangular_product32(gp, k):
    return blas.strmm(1.0, gp.inverse32, k.astype(np.float32), lower=1).astype(float)


def below(mean, variance, ceiling, rng):
    sd = np.sqrt(variance)
    return mean + sd * ndtri(rng.random(mean.size) * ndtr((ceiling - mean) / sd))


class Sampler:
    def __init__(self, gps, chains, product, rng):
        x = rng.standard_normal(D) / 5.0
        self.scenes = [Scene(gp, x, product) for gp in gps]
        self.states = rng.standard_normal((UNKNOWN, chains)) * 0.1
        self.rng = rng

    def sweep(self):
        for k, scene in enumerate(self.scenes):
            mean, variance = scene.predict(np.delete(self.states, k, axis=0))
            self.states[k] = below(mean, variance, 0.5, self.rng)


def seconds_per_call(call):
    call()
    start = time.process_time()
    calls = 0
    while calls < 2 or time.process_time() - start < SECONDS:
        call()
        calls += 1
    return (time.process_time() - start) / calls


def fastest(ways, measure):
    """Returns name and seconds of the fastest variant on this machine."""
    return min(((way.__name__, measure(way)) for way in ways), key=lambda pair: pair[1])


def one_scene(gps, product, rng):
    """Samples one scene: K = 1000 kept draws in 16 chains, 50 sweeps of burn-in."""
    sampler = Sampler(gps, 16, product, rng)
    kept = []
    for sweep in range(50 + 63):
        sampler.sweep()
        if sweep >= 50:
            kept.append(sampler.states.copy())
    return np.quantile(np.concatenate(kept, axis=1), [0.1, 0.9], axis=1)


def likelihood_and_gradient(X, y):
    D2 = squared_distances(X, X)
    signal = SIGNAL**2 * np.exp(-0.5 * D2)
    K = signal + NOISE**2 * np.eye(U)
    L = cholesky(K, lower=True, check_finite=False)
    alpha = cho_solve((L, True), y, check_finite=False)
    value = 0.5 * y @ alpha + np.log(np.diag(L)).sum() + 0.5 * U * np.log(2.0 * np.pi)
    inverse = lapack.dpotri(L, lower=1)[0]
    inverse = np.tril(inverse) + np.tril(inverse, -1).T
    W = inverse - np.outer(alpha, alpha)
    noise = NOISE**2 * np.trace(W)
    W *= signal
    sums = W.sum(1)
    scales = (sums[:, None] * X * X).sum(0) - (X * (W @ X)).sum(0)
    return value, np.concatenate([scales, [sums.sum(), noise]])


def check(gps, rng):
    """Checks that every variant gives the same answer, before it is timed."""
    Z = rng.standard_normal((UNKNOWN - 1, 1))
    x = rng.standard_normal(D)
    answers = [Scene(gps[0], x, way).predict(Z)[1][0]
               for way in (by_full_product, by_triangular_product, by_triangular_vector, by_solve)]
    assert np.ptp(answers) < 1e-9 * answers[0], answers
    for way in (by_full_product32, by_triangular_product32):
        assert abs(Scene(gps[0], x, way).predict(Z)[1][0] - answers[0]) < 1e-5
    X, y = rng.standard_normal((U, D)) / 5.0, rng.standard_normal(U)
    value, gradient = likelihood_and_gradient(X, y)
    longer = X.copy()
    longer[:, 2] *= np.exp(1e-4)
    assert abs((likelihood_and_gradient(longer, y)[0] - value) / 1e-4 + gradient[2]) < 1e-2 * abs(gradient[2])


def main():
    rng = np.random.default_rng(1)
    gps = [Bin(rng) for _ in range(UNKNOWN)]
    check(gps, rng)
    result = {"numpy": np.__version__, "kernels": peer_blas.kernels()}

    def sweeps(chains, ways, name):
        way, seconds = fastest(ways, lambda w: seconds_per_call(Sampler(gps, chains, w, rng).sweep))
        result[name] = seconds / chains
        print(f"{name}: {way}", file=sys.stderr)
        return globals()[way]

    sweeps(1, (by_full_product, by_triangular_vector, by_solve), "sweep/1")
    ways = (by_full_product, by_triangular_product, by_solve)
    best = sweeps(16, ways, "sweep/16")
    sweeps(64, ways, "sweep/64")
    ways = (by_full_product32, by_triangular_product32)
    sweeps(16, ways, "sweep/16/f32")
    sweeps(64, ways, "sweep/64/f32")
    result["oneScene"] = seconds_per_call(lambda: one_scene(gps, best, rng))
    X, y = gps[0].X, rng.standard_normal(U)
    result["likelihoodAndGradient"] = seconds_per_call(lambda: likelihood_and_gradient(X, y))
    json.dump(result, sys.stdout)


main()
