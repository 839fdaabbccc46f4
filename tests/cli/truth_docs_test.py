"""Runs every command of docs/truth.md, and checks what only the command line does."""

import pathlib
import unittest

from docs_support import PageCommands
from support import SOURCE, Folder, complaint, rows, run


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

    def test_drives_of_a_session_get_heights_with_their_sd(self):
        cloud, recording, session, drives, truth = (
            self.path / name for name in ("m.pcd", "d.mcap", "d.tts", "d.csv", "dt.csv"))
        mapping = pathlib.Path(SOURCE, "resources/mappings/simulated_robot.toml")
        run("simulate", "--terrain", "varied", "--tracks", "--count", 8, "--out", self.path / "k.csv", "--cloud", cloud,
            "--poses", self.path / "kp.csv", "--recording", recording)
        run("import", recording, "--mapping", mapping, "--out", session)
        run("session", "scenes", session, "--tracks", "--drives", "--out", drives)
        ways = [float(row["travelled_m"]) for row in rows(drives) if row["kind"] == "way"]
        self.assertGreater(len(ways), sum(row["kind"] == "scene" for row in rows(drives)))
        self.assertGreater(max(ways) - min(ways), 1.0)
        run("truth", cloud, "--scenes", drives, "--poses", recording, "--mapping", mapping, "--session", session,
            "--out", truth)
        lines = rows(truth)
        self.assertEqual(len(lines), len(rows(drives)))
        scenes = [line for line in lines if line["kind"] == "scene"]
        self.assertGreater(sum(line["left_h_+0.0_m"] != "" for line in scenes), len(scenes) // 2)
        for line in lines:
            self.assertEqual(line["left_h_+0.0_m"] == "", line["left_sd_+0.0_m"] == "")
        self.assertTrue(all(line["left_h_+0.0_m"] == "" for line in lines if line["kind"] == "way"))
        self.assertIn("too few scenes", complaint("train", "--track-drives", truth, "--out", self.path / "n.ttn"))

    def test_a_failure_writes_and_overwrites_nothing(self):
        scenes, cloud, poses, truth = self.files
        cloud.write_bytes(cloud.read_bytes()[:5000])
        self.assertIn("it is cut", complaint("truth", cloud, "--scenes", scenes, "--poses", poses, "--out", truth, "--sheet",
                                             self.path / "sheet.png"))
        self.assertEqual(sorted(p.name for p in self.path.iterdir()), ["c.pcd", "p.csv", "s.csv"])
        self.assertIn("s.csv", complaint("truth", cloud, "--scenes", scenes, "--poses", poses, "--out", scenes))

    def test_all_files_or_none_are_written(self):
        scenes, cloud, poses, truth = self.files
        said = complaint("truth", cloud, "--scenes", scenes, "--poses", poses, "--out", self.path / "none" / "t.csv", "--sheet",
                         self.path / "sheet.png", "--support", self.path / "support.csv", "--review", self.path / "r.truth")
        self.assertIn("none/t.csv", said)
        self.assertEqual(sorted(p.name for p in self.path.iterdir()), ["c.pcd", "p.csv", "s.csv"])

    def test_options_that_contradict_are_refused(self):
        scenes, cloud, poses, truth = self.files
        common = ["truth", cloud, "--scenes", scenes, "--poses", poses, "--out", truth]
        self.assertIn("six numbers", complaint(*common, "--sensor-mount", "1 2 3", code=2))
        self.assertIn("--scans", complaint(*common, "--scans", "--topic", "/points", code=2))
        self.assertIn("--session", complaint(*common, "--start", 5, "--session", scenes, code=2))


if __name__ == "__main__":
    unittest.main()
