"""Runs every command of docs/truth.md, and checks what only the command line does."""

import unittest

from docs_support import PageCommands
from support import Folder, complaint, rows, run


class Commands(PageCommands):
    def test_every_command_prints_what_the_document_says(self):
        self.run_page("truth.md", 5)


class Outputs(Folder):
    def setUp(self):
        super().setUp()
        self.files = [self.path / name for name in ("s.csv", "c.pcd", "p.csv", "t.csv")]
        scenes, cloud, poses, _ = self.files
        run("simulate", "--terrain", "boxes", "--count", 56, "--exact-truth", "--out", scenes, "--cloud", cloud, "--poses", poses)

    def test_scenes_of_one_plane_train_a_model(self):
        scenes, cloud, poses, truth = self.files
        run("truth", cloud, "--scenes", scenes, "--poses", poses, "--out", truth)
        known = [row for row in rows(truth) if all(row[name] for name in row if name.startswith("h_"))]
        self.assertGreater(len(known), 20)
        for exact, found in zip(rows(scenes), rows(truth)):
            for name in exact:
                if name.startswith("h_") and found[name]:
                    self.assertAlmostEqual(float(exact[name]), float(found[name]), delta=0.1)
        run("train", "--data", truth, "--out", self.path / "m.ttm")

    def test_a_failure_writes_and_overwrites_nothing(self):
        scenes, cloud, poses, truth = self.files
        cloud.write_bytes(cloud.read_bytes()[:5000])
        self.assertIn("it is cut", complaint("truth", cloud, "--scenes", scenes, "--poses", poses, "--out", truth, "--sheet",
                                             self.path / "sheet.png"))
        self.assertEqual(sorted(p.name for p in self.path.iterdir()), ["c.pcd", "p.csv", "s.csv"])
        self.assertIn("s.csv", complaint("truth", cloud, "--scenes", scenes, "--poses", poses, "--out", scenes))

    def test_options_that_contradict_are_refused(self):
        scenes, cloud, poses, truth = self.files
        common = ["truth", cloud, "--scenes", scenes, "--poses", poses, "--out", truth]
        self.assertIn("six numbers", complaint(*common, "--sensor-mount", "1 2 3", code=2))
        self.assertIn("--scans", complaint(*common, "--scans", "--topic", "/points", code=2))
        self.assertIn("--session", complaint(*common, "--start", 5, "--session", scenes, code=2))


if __name__ == "__main__":
    unittest.main()
