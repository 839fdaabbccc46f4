"""Tests `terratact train --drives` and `evaluate --drives`: networks that remember a drive."""

import pathlib
import re
import subprocess
import tempfile
import unittest

from support import CLI, complaint, needs_no_sanitizer, run


class TrailNetworks(unittest.TestCase):
    def test_networks_learn_from_drives_and_are_evaluated(self):
        needs_no_sanitizer(self, "the tests of core compute the same in less")
        path = pathlib.Path(self.enterContext(tempfile.TemporaryDirectory()))
        scenes, model = path / "scenes.csv", path / "small.ttm"
        run("simulate", "--terrain", "boxes", "--count", 90, "--seed", 3, "--out", scenes)
        run("train", "--data", scenes, "--out", model, "--seed", 3)
        drives, tracks, networks = (path / name for name in ("way.csv", "tracks.csv", "small.ttn"))
        simulate = ("simulate", "--terrain", "varied", "--drives", 22, "--spacing", 0.1, "--exact-truth", "--seed", 4)
        run(*simulate, "--out", drives)
        run(*simulate, "--tracks", "--out", tracks)
        train = ("train", "--drives", drives, "--track-drives", tracks, "--networks", 1, "--epochs", 2)
        self.assertIn("1 of one plane, 1 of two tracks", run(*train, "--out", networks))
        learnt = networks.read_bytes()
        run(*train, "--out", networks)
        self.assertEqual(learnt, networks.read_bytes(), "the same drives and seed")
        header, *lines = drives.read_text().splitlines(keepends=True)
        first_drives = path / "first_drives.csv"
        first_drives.write_text(header + "".join([line for line in lines if line.split(",")[0] in {"1", "2", "3"}][1:]))
        for data, count in ((drives, 22), (tracks, 22), (first_drives, 3)):
            done = subprocess.run([CLI, "evaluate", "--drives", data, "--trail", networks], capture_output=True,
                                  text=True, timeout=500, check=True)
            self.assertIn(f"the networks have learnt from {count} of {count} drives", done.stderr)
            text = done.stdout
            self.assertRegex(text, rf"{count} drives\n\n\d+ scenes after 0.85 m")
            for method in ("local", "trail"):
                self.assertRegex(text, rf"\n{method} +\d+\.\d\d +\d+\.\d\d +\d+\.\d ")
        again = path / "again.csv"
        again.write_text("".join([header, *("again " + line for line in lines[:-1])]))
        train = (CLI, "train", "--drives", drives, again, "--networks", "1", "--epochs", "1", "--out", networks)
        done = subprocess.run(train, capture_output=True, text=True, timeout=500, check=True)
        self.assertIn("22 drives are there twice: their copies were left out", done.stderr)
        pitch, rows = header.split(",").index("pitch_rad"), [line.split(",") for line in lines]
        for row in rows:
            row[0], row[pitch] = "again " + row[0], str(float(row[pitch]) + 0.004)
        again.write_text(header + "".join(",".join(row) for row in rows))
        done = subprocess.run(train, capture_output=True, text=True, timeout=500, check=True)
        self.assertNotIn("there twice", done.stderr)
        repeats = re.search(r"(\d+) scenes repeat a place of an earlier drive", done.stderr)
        self.assertTrue(repeats, done.stderr)
        self.assertGreater(2 * int(repeats[1]), sum("scene" in row for row in rows))
        self.assertIn("two tracks", complaint("train", "--drives", tracks, "--out", networks))
        self.assertIn("not trail networks", complaint("evaluate", "--drives", drives, "--trail", model))
        complaint("evaluate", "--drives", drives, "--data", scenes, code=2)
        complaint("evaluate", "--data", scenes, code=2)


if __name__ == "__main__":
    unittest.main()
