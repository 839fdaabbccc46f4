"""Reads clouds that the tools of the Point Cloud Library wrote (pcl-tools). Without them the test is skipped."""

import shutil
import subprocess
import unittest

from support import Folder, rows, run


@unittest.skipUnless(shutil.which("pcl_convert_pcd_ascii_binary"), "pcl-tools is not installed")
class CloudsOfPcl(Folder):
    def setUp(self):
        super().setUp()
        self.scenes, self.cloud, self.poses = (self.path / name for name in ("s.csv", "c.pcd", "p.csv"))
        run("simulate", "--terrain", "boxes", "--tracks", "--count", 12, "--seed", 3, "--out", self.scenes,
            "--cloud", self.cloud, "--poses", self.poses)
        self.wanted = self.heights(self.cloud)

    def heights(self, cloud):
        out = self.path / f"{cloud.name}.csv"
        run("truth", cloud, "--scenes", self.scenes, "--poses", self.poses, "--out", out)
        return [{name: row[name] for name in row if "_h_" in name} for row in rows(out)]

    def convert(self, *command):
        subprocess.run([str(part) for part in command], check=True, capture_output=True, timeout=120)

    def assert_same_heights(self, cloud):
        found = self.heights(cloud)
        self.assertEqual(len(found), len(self.wanted))
        for want, got in zip(self.wanted, found):
            for name in want:
                self.assertEqual(want[name] == "", got[name] == "", name)
                if want[name]:
                    self.assertAlmostEqual(float(want[name]), float(got[name]), delta=0.001)

    def test_every_kind_of_pcd_gives_the_same_heights(self):
        self.assertGreater(sum(value != "" for row in self.wanted for value in row.values()), 100)
        for kind, name in enumerate(("ascii", "binary", "compressed")):
            with self.subTest(name):
                made = self.path / f"{name}.pcd"
                self.convert("pcl_convert_pcd_ascii_binary", self.cloud, made, kind)
                self.assert_same_heights(made)

    def test_every_kind_of_ply_gives_the_same_heights(self):
        for kind, name in enumerate(("ascii", "binary")):
            with self.subTest(name):
                made = self.path / f"{name}.ply"
                self.convert("pcl_pcd2ply", "-format", kind, self.cloud, made)
                self.assert_same_heights(made)


if __name__ == "__main__":
    unittest.main()
