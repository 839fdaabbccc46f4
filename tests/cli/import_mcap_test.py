"""Imports MCAP files that Foxglove's library wrote (tests/data/recordings), whole and damaged."""

import math
import pathlib
import unittest

from support import SOURCE, Folder, complaint, rows, run

RECORDINGS = pathlib.Path(SOURCE, "tests/data/recordings")
MAPPING = """name = "test robot"
[attitude]
topic = "/imu/data"
quaternion = "orientation"
[odometry]
topic = "/odom"
position = "pose.pose.position"
orientation = "pose.pose.orientation"
""" + "".join(f"""[{axle}_{side}]
topic = "/joint_states"
field = "position[{axle}_{side}_j]"
[{axle}_{side}_current]
topic = "/joint_states"
field = "effort[{axle}_{side}_j]"
unit = "N m"
""" for axle in ("front", "rear") for side in ("left", "right"))


class McapOfFoxglove(Folder):
    def setUp(self):
        super().setUp()
        self.mapping = self.path / "m.toml"
        self.mapping.write_text(MAPPING)

    def write(self, content):
        (self.path / "a.mcap").write_bytes(content)
        return self.path / "a.mcap"

    def importing(self, recording):
        return ("import", recording, "--mapping", self.mapping, "--out", self.path / f"{recording.stem}.tts")

    def test_a_file_becomes_a_session_with_its_scene(self):
        for name in ("zstd.mcap", "lz4_unindexed.mcap"):
            with self.subTest(name):
                scenes = self.path / f"{name}.csv"
                said = run(*self.importing(RECORDINGS / name), "--scenes", scenes)
                self.assertIn("60 lines of telemetry in 5.900 s, 720 frames and 1 scenes", said)
                scene = rows(scenes)[0]
                self.assertAlmostEqual(float(scene["pitch_rad"]), 0.2, 4)
                self.assertAlmostEqual(float(scene["rear_rad"]), 0.35, 4)
                self.assertAlmostEqual(float(scene["front_current_a"]), 3.0, 3)  # 17 N m

    def test_its_clouds_give_the_scene_heights(self):
        for name in ("zstd.mcap", "lz4_unindexed.mcap"):
            with self.subTest(name):
                scenes, truth = self.path / "s.csv", self.path / "truth.csv"
                run(*self.importing(RECORDINGS / name), "--scenes", scenes)
                said = run("truth", RECORDINGS / name, "--topic", "/points", "--poses", RECORDINGS / name,
                           "--mapping", self.mapping, "--start", 1_700_000_000, "--scenes", scenes, "--align",
                           "--out", truth)
                self.assertIn("960 points of 3 clouds", said)
                self.assertIn("1 of 1 scenes have heights", said)
                heights = [rows(truth)[0][f"h_{-0.3 + 0.1 * i:+.1f}_m"] for i in range(11)]
                self.assertNotIn("", heights)
                for i, height in enumerate(heights):
                    rise = math.tan(0.2) * 0.1 * (i - 3)
                    self.assertAlmostEqual(float(height) - float(heights[3]), rise, 2)

    def test_probe_lists_topics_and_proposes_a_mapping(self):
        said = run("import", RECORDINGS / "zstd.mcap", "--probe")
        self.assertIn("zstd.mcap: MCAP, 4 topics, 183 messages", said)
        self.assertIn('field = "position[rear_right_j]"', said)
        self.mapping.write_text(said.split("---- proposed mapping ----\n")[1])
        run(*self.importing(RECORDINGS / "zstd.mcap"))

    def test_a_cut_file_is_read_as_far_as_it_goes(self):
        whole = (RECORDINGS / "lz4_unindexed.mcap").read_bytes()
        told = run(*self.importing(self.write(whole[:len(whole) * 2 // 3])))
        self.assertRegex(told, r"[1-5]\d lines of telemetry")

    def test_a_file_with_only_a_cut_chunk_is_one_sentence(self):
        told = complaint(*self.importing(self.write((RECORDINGS / "zstd.mcap").read_bytes()[:2000])))
        self.assertRegex(told.splitlines()[-1], r"a\.mcap: ends within the record at byte \d+")
        self.assertFalse((self.path / "a.tts").exists())

    def test_names_the_second_of_two_files_joined_by_cat(self):
        content = (RECORDINGS / "zstd.mcap").read_bytes()
        recording = self.write(content + content)
        self.assertIn("60 lines of telemetry", run(*self.importing(recording)))
        said = run("import", recording, "--mapping", self.mapping, "--check", code=1)
        self.assertIn("bytes behind it are not read: if files were joined, split them there", said)


if __name__ == "__main__":
    unittest.main()
