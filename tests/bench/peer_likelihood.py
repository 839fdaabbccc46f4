"""Compares NLML and gradient of a hand-written NumPy/SciPy implementation with ours, interleaved, one thread each.

Usage: peer_likelihood.py path/to/terratact-bench-likelihood [rows] [inputs] [rounds]
Prints CPU milliseconds of both (fastest and median of the rounds) and their ratio. Prints the differences of value and
gradient.
"""

import os
import struct
import subprocess
import sys
import tempfile
import time

import peer_blas

peer_blas.prepare()

import numpy as np
from scipy.linalg import lapack


def problem(rows, inputs):
    rng = np.random.default_rng(1)
    X = rng.standard_normal((rows, inputs))
    y = 0.1 * np.sin(X[:, 0]) + 0.02 * rng.standard_normal(rows)
    return X, y, np.linspace(2.0, 9.0, inputs), 0.1, 0.02


def negative_log_likelihood(X, y, scale, signal, noise):
    """Returns value and gradient with respect to log scale, log signal, log noise (Rasmussen & Williams, eq. 2.30 and 5.9)."""
    U = len(y)
    Z = X / scale
    norms = np.einsum("ij,ij->i", Z, Z)
    S = Z @ Z.T
    S -= 0.5 * norms[:, None]
    S -= 0.5 * norms
    np.exp(S, out=S)
    S *= signal**2
    K = np.array(S, order="F")
    K[np.diag_indices(U)] += noise**2
    L, info = lapack.dpotrf(K, lower=1, overwrite_a=1, clean=0)
    if info:
        raise np.linalg.LinAlgError("not positive definite")
    alpha = lapack.dpotrs(L, y, lower=1)[0]
    value = 0.5 * y @ alpha + np.log(np.diagonal(L)).sum() + 0.5 * U * np.log(2.0 * np.pi)
    inverse = lapack.dpotri(L, lower=1, overwrite_c=1)[0]  # the lower triangle
    trace = np.trace(inverse) - alpha @ alpha
    M = np.tril(inverse, -1)
    M -= np.tril(np.outer(alpha, alpha), -1)
    M *= S
    # sum over i > j of M_ij (z_i - z_j)^2, column by column of Z
    MZ = M @ Z
    squares = M.sum(axis=1) @ Z**2 + M.sum(axis=0) @ Z**2 - 2.0 * np.einsum("ij,ij->j", Z, MZ)
    return value, np.concatenate([squares, [2.0 * M.sum() + signal**2 * trace, noise**2 * trace]])


def write(path, X, y, scale, signal, noise):
    with open(path, "wb") as file:
        file.write(struct.pack("<qq", *X.shape))
        for part in (X, y, scale, [signal, noise]):
            file.write(np.asarray(part, dtype="<f8").tobytes())


def main():
    ours = sys.argv[1]
    rows, inputs, rounds = (int(a) for a in (sys.argv[2:] + ["1400", "22", "9"][len(sys.argv) - 2:]))
    data = problem(rows, inputs)
    peer_ms, our_ms = [], []
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "problem")
        write(path, *data)
        negative_log_likelihood(*data)
        for _ in range(rounds):
            start = time.process_time()
            value, gradient = negative_log_likelihood(*data)
            peer_ms.append(1e3 * (time.process_time() - start))
            words = subprocess.run([ours, "data", path, "2"], check=True, capture_output=True, text=True).stdout.split()
            our_ms.append(float(words[0]))
    got = np.array([float(w) for w in words[1:]])
    print(f"U = {rows}, d = {inputs}, one thread, OpenBLAS's kernels for {peer_blas.kernels()}, "
          f"CPU ms of {rounds} interleaved rounds: fastest, median")
    print(f"  NumPy/SciPy  {min(peer_ms):8.1f} {np.median(peer_ms):8.1f}")
    print(f"  Terratact    {min(our_ms):8.1f} {np.median(our_ms):8.1f}")
    print(f"  ratio        {min(our_ms) / min(peer_ms):8.3f} {np.median(our_ms) / np.median(peer_ms):8.3f}")
    print(f"  value apart by {abs(got[0] - value) / abs(value):.1e} of it, "
          f"gradient by {np.max(np.abs(got[1:] - gradient)) / np.max(np.abs(gradient)):.1e} of its largest entry")


if __name__ == "__main__":
    main()
