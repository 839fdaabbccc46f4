"""Tests `terratact simulate`: scenes and drives of simulated robots."""

import pathlib
import tempfile
import unittest

from support import complaint, rows, run


class Simulated(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.path = pathlib.Path(cls.folder.name)
        cls.data = cls.path / "scenes.csv"
        run("simulate", "--terrain", "boxes", "--count", 90, "--seed", 3, "--out", cls.data)

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    def test_simulation_repeats_for_a_seed(self):
        again, other = self.path / "again.csv", self.path / "other.csv"
        run("simulate", "--terrain", "boxes", "--count", 90, "--seed", 3, "--out", again)
        run("simulate", "--terrain", "boxes", "--count", 90, "--seed", 4, "--out", other)
        self.assertEqual(self.data.read_bytes(), again.read_bytes())
        self.assertNotEqual(self.data.read_bytes(), other.read_bytes())

    def test_disturbances_change_scenes_but_not_drives(self):
        dead, soft = self.path / "dead.csv", self.path / "soft.csv"
        for name, out in (("dead-element", dead), ("soft-ground", soft)):
            run("simulate", "--terrain", "boxes", "--count", 90, "--seed", 3, "--disturb", name, "--out", out)
        self.assertEqual({row["force_4_n"] for row in rows(dead)}, {"0"})
        self.assertEqual([row["force_5_n"] for row in rows(dead)], [row["force_5_n"] for row in rows(self.data)])
        self.assertNotEqual([row["pitch_rad"] for row in rows(soft)], [row["pitch_rad"] for row in rows(self.data)])
        complaint("simulate", "--terrain", "boxes", "--disturb", "earthquake", "--out", dead, code=2)

    def test_soft_drives_are_a_share_of_the_drives(self):
        none, all_soft = self.path / "firm.csv", self.path / "soft_drives.csv"
        run("simulate", "--terrain", "boxes", "--count", 90, "--seed", 3, "--soft-drives", 0, "--out", none)
        run("simulate", "--terrain", "boxes", "--count", 90, "--seed", 3, "--soft-drives", 1, "--out", all_soft)
        self.assertEqual(self.data.read_bytes(), none.read_bytes())
        # A sunken robot is nearer to the ground.
        below = [[float(row["h_+0.0_m"]) for row in rows(file)] for file in (self.data, all_soft)]
        self.assertGreater(sum(below[1]) / len(below[1]), sum(below[0]) / len(below[0]) + 0.005)
        complaint("simulate", "--terrain", "boxes", "--soft-drives", 1.5, "--out", none, code=2)

    def test_drives_have_telemetry_between_scenes(self):
        out = self.path / "drives.csv"
        drives = ("simulate", "--terrain", "varied", "--drives", 2, "--seed", 3, "--out", out)
        said = run(*drives, "--spacing", 0.6, "--slip", 0, "--gap", 1)
        lines = rows(out)
        scenes = sum(row["kind"] == "scene" for row in lines)
        self.assertIn(f"2 drives over varied with {len(lines)} lines and {scenes} scenes", said)
        self.assertGreater(len(lines), 10 * scenes)
        self.assertTrue(all((row["h_+0.7_m"] != "") == (row["kind"] == "scene") for row in lines))
        level = [float(row["pitch_rad"]) for row in lines]
        run(*drives, "--spacing", 0.6, "--slip", 0, "--gap", 1, "--pitch-bias", 3)
        tilted = [float(row["pitch_rad"]) for row in rows(out)]
        self.assertTrue(all(abs(b - a - 0.05236) < 2e-5 for a, b in zip(level, tilted, strict=True)))
        run(*drives, "--spacing", 0.6, "--press-share", 0, "--tracks")
        self.assertEqual({row["kind"] for row in rows(out)}, {"way"})
        self.assertIn("left_h_+0.7_m", rows(out)[0])
        self.assertIn("--drives", complaint("simulate", "--terrain", "boxes", "--drives", 2, "--out", out, code=2))
        complaint(*drives, "--count", 5, code=2)
        complaint("simulate", "--terrain", "varied", "--gap", 2, "--out", out, code=2)

    def test_a_slip_common_to_the_drive_scales_its_odometry(self):
        plain, slipped = self.path / "plain.csv", self.path / "slipped.csv"
        drives = ("simulate", "--terrain", "varied", "--drives", 2, "--seed", 3, "--spacing", 0.6)
        run(*drives, "--out", plain)
        run(*drives, "--drive-slip", 0.5, "--out", slipped)
        factors = {}
        for before, after in zip(rows(plain), rows(slipped), strict=True):
            way, scaled = float(before.pop("travelled_m")), float(after.pop("travelled_m"))
            self.assertEqual(before, after)
            if way > 1:
                factors.setdefault(before["run"], []).append(scaled / way)
        self.assertEqual(len(factors), 2)
        for of_drive in factors.values():
            self.assertLess(max(of_drive) - min(of_drive), 1e-4)
        self.assertNotAlmostEqual(factors["1"][0], factors["2"][0], places=3)
        for wrong in (-0.1, 1.5, "much"):
            self.assertIn("--drive-slip", complaint(*drives, "--drive-slip", wrong, "--out", plain, code=2))
        self.assertIn("--drives", complaint("simulate", "--terrain", "varied", "--drive-slip", 0.1, "--out", plain,
                                            code=2))

    def test_a_press_torque_replaces_that_of_each_drive(self):
        full, light = self.path / "full.csv", self.path / "light.csv"
        drives = ("simulate", "--terrain", "varied", "--drives", 2, "--seed", 3, "--spacing", 0.6)
        run(*drives, "--out", full)
        run(*drives, "--press-torque", 4, "--out", light)
        means = []
        for file in (full, light):
            currents = [float(row["front_current_a"]) for row in rows(file) if row["kind"] == "scene"]
            means.append(sum(currents) / len(currents))
        self.assertLess(means[1], 0.5 * means[0])
        for wrong in (0, 61, "hard"):
            self.assertIn("--press-torque", complaint(*drives, "--press-torque", wrong, "--out", light, code=2))
        self.assertIn("--drives", complaint("simulate", "--terrain", "varied", "--press-torque", 4, "--out", light,
                                            code=2))

    def test_real_profiles_of_both_formats_are_driven(self):
        points = self.path / "points.csv"
        points.write_text("x,z\n0,0\n2,0\n2,0.2\n5,0.2\n")
        heights = self.path / "heights.csv"
        heights.write_text("0,0.01,0.02,0,0,0.1,0.1,0.1,0,0,0,0\n" * 3)
        for file in (points, heights):
            out = self.path / "driven.csv"
            run("simulate", "--terrain", file, "--exact-truth", "--out", out)
            self.assertGreaterEqual(len(rows(out)), 3)


if __name__ == "__main__":
    unittest.main()
