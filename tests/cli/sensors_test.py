"""Tests the commands for sensors: readings of the arm, sensor faults and both tracks in scenes, calibration."""

import pathlib
import tempfile
import unittest

from support import SOURCE, complaint, fault_names, rows, run


class Sensors(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.path = pathlib.Path(self.folder.name)

    def test_probes_gives_the_line_for_the_robot_file(self):
        readings = self.path / "probes.csv"
        readings.write_text("place,height_m,truth_m\na,0.10,\na,0.14,\nb,0.30,\nb,0.34,\n")
        text = run("probes", "--data", readings)
        self.assertIn("4 readings of 2 places", text)
        self.assertIn("reading_sd_m = 0.0283", text)
        readings.write_text("place,height_m,truth_m\na,0.10,\nb,0.14,\n")
        self.assertIn("no place is read twice", complaint("probes", "--data", readings))

    def test_simulate_can_add_sensor_faults(self):
        sound, stuck = self.path / "sound.csv", self.path / "stuck.csv"
        command = ("simulate", "--terrain", "boxes", "--count", 60, "--seed", 5)
        run(*command, "--out", sound)
        run(*command, "--disturb", "stuck:pitch", "--out", stuck)
        first = {}
        for row, true in zip(rows(stuck), rows(sound), strict=True):
            self.assertEqual(row["pitch_rad"], first.setdefault(row["run"], true["pitch_rad"]))
            self.assertEqual(row["front_rad"], true["front_rad"])
        self.assertIn("KIND:SENSORS", complaint(*command, "--disturb", "stuck:nose", "--out", stuck, code=2))

    def test_simulate_can_lose_sensors(self):
        out = self.path / "lost.csv"
        command = ("simulate", "--terrain", "boxes", "--count", 60, "--seed", 5, "--out", out, "--disturb")
        run(*command, "lost:front-current")
        for row in rows(out):
            self.assertEqual(row["front_current_a"], "")
            self.assertNotEqual(row["rear_current_a"], "")
        self.assertIn("only currents, forces and odometry can be lost", complaint(*command, "lost:pitch", code=2))

    def test_every_fault_changes_the_scenes(self):
        out = self.path / "scenes.csv"

        def scenes(fault):  # returns the text of scenes with the fault
            run("simulate", "--terrain", "boxes", "--count", 60, "--seed", 5, "--disturb", fault, "--out", out)
            return out.read_text()

        kinds, sensors = fault_names()
        harmless = {"offset:roll", "offset:odometry"}  # one-plane scenes have neither
        sound = scenes("none")
        # Every kind at every sensor: tests/core/sim/sensor_fault_test.cpp
        for fault in [f"{kind}:all" for kind in kinds] + [f"offset:{sensor}" for sensor in sensors]:
            with self.subTest(fault=fault):
                self.assertEqual(scenes(fault) == sound, fault in harmless)

    def test_calibrate_prints_a_robot_file_section(self):
        def volts(force):  # returns the voltage of an element of 9 kΩ at 1 N with a preload of 0.4 N
            return 5e4 / (1e4 + 9000 / (force + 0.4) ** 0.9)

        lines = [f"{side},{element},{force},{volts(force)}" for side in ("left", "right")
                 for element in range(1, 7) for force in (0, 1, 2, 4, 8, 16)]
        recording = self.path / "forces.csv"
        recording.write_text("side,element,force_n,voltage_v\n" + "\n".join(lines) + "\n")
        text = run("calibrate", "--data", recording)
        self.assertIn("72 readings", text)
        self.assertIn("median 0.000 N, worst 0.000 N", text)
        section = text[text.index("[force_calibration]"):]
        shipped = pathlib.Path(SOURCE, "resources/robots/absolem.toml").read_text()
        before, rest = shipped.split("[force_calibration]")
        robot = self.path / "mine.toml"
        robot.write_text(before + section + "\n[flipper_drive]" + rest.split("[flipper_drive]")[1])
        again = run("calibrate", "--data", recording, "--robot", robot)
        self.assertEqual(again.splitlines()[1], text.splitlines()[1])

        for line, cause in (("up,1,0,1.0", "'up', expected left or right"), ("left,7,0,1", "element is 7"),
                            ("left,1.5,0,1", "element is 1.5"), ("left,1,-1,1", "force_n is negative"),
                            ("left,1,0,nan", "voltage_v"), ("left,1,0", "has 3 fields"),
                            ("left,1,0,0", "wire broken"), ("left,1,0,1", "left element 2 has no unloaded reading")):
            recording.write_text(f"side,element,force_n,voltage_v\n{line}\n")
            self.assertIn(cause, complaint("calibrate", "--data", recording))
        recording.write_text("side,element\n")
        self.assertIn("is not the header", complaint("calibrate", "--data", recording))

    def test_simulate_records_scenes_of_two_tracks(self):
        out = self.path / "tracks.csv"
        for terrain, least_roll in (("varied", 0.1), ("hazards", 0.0), ("boxes", 0.0)):
            run("simulate", "--terrain", terrain, "--tracks", "--count", 32, "--seed", 2, "--out", out)
            scenes = rows(out)
            self.assertGreater(len(scenes), 15)
            self.assertGreater(max(abs(float(scene["roll_rad"])) for scene in scenes), least_roll)
            self.assertIn("front_right_force_6_n", scenes[0])
            self.assertIn("right_h_+0.7_m", scenes[0])
        lines = self.path / "lines.csv"
        lines.write_text("y_m,heights_m\n0.2" + ",0.05" * 60 + "\n-0.2" + ",0" * 60 + "\n")
        run("simulate", "--terrain", lines, "--tracks", "--exact-truth", "--out", out)
        for scene in rows(out):
            # 50 mm over 0.397 m between the tracks, or over 0.544 m between flippers that carry the robot
            self.assertAlmostEqual(float(scene["roll_rad"]), 0.11, delta=0.06)
            self.assertAlmostEqual(float(scene["left_h_+0.0_m"]) - float(scene["right_h_+0.0_m"]), 0.05, delta=1e-6)
        self.assertIn("column y_m", complaint("simulate", "--terrain", lines, "--out", out))
        complaint("simulate", "--terrain", "varied", "--tracks", "--disturb", "soft-ground", "--out", out, code=2)


if __name__ == "__main__":
    unittest.main()
