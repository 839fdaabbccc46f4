"""Compares our Gaussian processes and Gibbs sampler with NumPy and SciPy, using only `model show --csv`."""

import csv
import io
import pathlib
import tempfile
import unittest

import numpy
import scipy.linalg
import scipy.special

from support import rows, run

BINS = [f"h_{(i - 3) / 10:+.1f}_m" for i in range(11)]
FEATURES = {"pa": 3, "paf": 11}


class PeerModel:
    """The eleven conditionals of one feature set, rebuilt from the CSV."""

    def __init__(self, table, name):
        mine = [row for row in table if row["set"] == name]
        data = [row for row in table if row["set"] == "row"]
        columns = list(dict.fromkeys(row["name"] for row in data))
        self.columns = columns[: 11 + FEATURES[name]]
        value = {(row["bin_m"], row["name"]): float(row["value"]) for row in mine}
        self.mean = numpy.array([value["", f"mean {c}"] for c in self.columns])
        self.sd = numpy.array([value["", f"sd {c}"] for c in self.columns])
        U = int(data[-1]["bin_m"])
        raw = numpy.array([float(row["value"]) for row in data]).reshape(U, len(columns))[:, : len(self.columns)]
        self.heights = raw[:, :11]
        z = (raw - self.mean) / self.sd
        self.bins = []
        for i in range(11):
            key = f"{(i - 3) / 10:+.1f}"
            X = numpy.delete(z, i, axis=1)
            ell = numpy.array([value[key, f"length_scale {c}"] for k, c in enumerate(self.columns) if k != i])
            signal2, noise2 = value[key, "signal_sd_m"] ** 2, value[key, "noise_sd_m"] ** 2
            A = X / ell
            d2 = ((A[:, None, :] - A[None, :, :]) ** 2).sum(-1)
            K = signal2 * numpy.exp(-0.5 * d2) + noise2 * numpy.eye(U)
            L = scipy.linalg.cholesky(K, lower=True)
            alpha = scipy.linalg.cho_solve((L, True), self.heights[:, i] - self.mean[i])
            self.bins.append((A, ell, signal2, noise2, L, alpha))

    def predict(self, i, inputs):
        """Returns mean and sd of bin i for raw inputs n × (11 + f)."""
        A, ell, signal2, noise2, L, alpha = self.bins[i]
        x = numpy.delete((inputs - self.mean) / self.sd, i, axis=1) / ell
        k = signal2 * numpy.exp(-0.5 * ((x[:, None, :] - A[None, :, :]) ** 2).sum(-1))
        v = scipy.linalg.solve_triangular(L, k.T, lower=True)
        return self.mean[i] + k @ alpha, numpy.sqrt(signal2 + noise2 - (v**2).sum(0))


def raw_inputs(scene, model):
    return numpy.array([float(scene[c]) for c in model.columns])


def gibbs(model, scene, ceiling, rng, chains=48, burn_in=80, sweeps=250):
    """Returns the means of the free bins and their Monte-Carlo standard errors, from parallel chains."""
    state = numpy.repeat(raw_inputs(scene, model)[None, :], chains, axis=0)
    state[:, :11] = model.mean[:11] + model.sd[:11] * rng.standard_normal((chains, 11))
    state[:, :11] = numpy.minimum(state[:, :11], ceiling)
    kept = []
    for sweep in range(burn_in + sweeps):
        for i in range(11):
            mean, sd = model.predict(i, state)
            top = scipy.special.ndtr((ceiling[i] - mean) / sd)
            state[:, i] = mean + sd * scipy.special.ndtri(rng.uniform(size=chains) * top)
        if sweep >= burn_in:
            kept.append(state[:, :11].copy())
    chain_means = numpy.array(kept).mean(axis=0)
    return chain_means.mean(axis=0), chain_means.std(axis=0, ddof=1) / numpy.sqrt(chains)


class Peer(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        path = pathlib.Path(cls.folder.name)
        cls.data, cls.test, cls.model = path / "train.csv", path / "test.csv", path / "peer.ttm"
        run("simulate", "--terrain", "varied", "--count", 160, "--seed", 5, "--out", cls.data)
        run("simulate", "--terrain", "varied", "--count", 50, "--seed", 6, "--exact-truth", "--out", cls.test)
        run("train", "--data", cls.data, "--out", cls.model)
        table = list(csv.DictReader(io.StringIO(run("model", "show", cls.model, "--csv"))))
        cls.peer = {name: PeerModel(table, name) for name in FEATURES}
        cls.scenes = rows(cls.test)

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    def test_conditionals_agree_to_a_nanometre(self):
        ours = list(csv.DictReader(io.StringIO(run("model", "predict", self.model, "--data", self.test))))
        self.assertEqual(len(ours), 50 * 2 * 11)
        worst = 0.0
        for k, row in enumerate(ours):
            model = self.peer[row["set"]]
            i = k % 11
            mean, sd = model.predict(i, raw_inputs(self.scenes[k // 22], model)[None, :])
            worst = max(worst, abs(mean[0] - float(row["mean_m"])), abs(sd[0] - float(row["sd_m"])))
        print(f"largest difference of a mean or sd: {worst:.2e} m")
        self.assertLess(worst, 1e-9)

    def test_gibbs_means_agree_within_monte_carlo_error(self):
        few = pathlib.Path(self.folder.name) / "few.csv"
        lines = self.test.read_text().splitlines(keepends=True)
        few.write_text("".join([lines[0], *lines[1::17]]))
        rng = numpy.random.default_rng(3)
        for method in ("pa", "pac"):
            out = few.with_suffix(f".{method}.csv")
            run("reconstruct", "--model", self.model, "--data", few, "--method", method, "--hazard-rate", 0, "--sweeps", 24000,
                "--chains", 48, "--burn-in", 100, "--out", out)
            ours = rows(out)
            for k, scene in enumerate(rows(few)):
                mine = ours[11 * k: 11 * k + 11]
                bound = [float(r["ceiling_m"]) if method == "pac" and r["ceiling_m"] else numpy.inf for r in mine]
                mean, error = gibbs(self.peer["pa"], scene, numpy.array(bound), rng)
                for i, r in enumerate(mine):
                    own = float(r["sd_m"]) / numpy.sqrt(float(r["ess"]))
                    limit = 5.0 * numpy.hypot(own, error[i])
                    self.assertLess(abs(float(r["mean_m"]) - mean[i]), limit,
                                    f"{method} scene {k} bin {BINS[i]}: ours {r['mean_m']}, peer {mean[i]} ± {error[i]}")


if __name__ == "__main__":
    unittest.main()
