"""Imports bags that ROS's own library wrote (python3-rosbag), and a rosbag2 file that Python's sqlite3 wrote. Without the
library the tests of ROS 1 are skipped."""

import math
import pathlib
import sqlite3
import struct
import unittest

import hostile_files
from support import SOURCE, Folder, complaint, rows, run

try:
    import rosbag
    import rospy
    from nav_msgs.msg import Odometry
    from sensor_msgs.msg import Imu, JointState
    from std_msgs.msg import Float32MultiArray
except ImportError:
    rosbag = None

NAMES = ["front_left_flipper_j", "front_right_flipper_j", "rear_left_flipper_j", "rear_right_flipper_j"]
MAPPING = """name = "test robot"
[attitude]
topic = "/imu/data"
quaternion = "orientation"
[front_left_force]
topic = "/forces"
field = "data"
[odometry]
topic = "/odom"
position = "pose.pose.position"
orientation = "pose.pose.orientation"
""" + "".join(f"""[{axle}_{side}]
topic = "/joint_states"
field = "position[{axle}_{side}_flipper_j]"
[{axle}_{side}_current]
topic = "/joint_states"
field = "effort[{axle}_{side}_flipper_j]"
unit = "N m"
""" for axle in ("front", "rear") for side in ("left", "right"))


def pitch_at(i):
    return 0.2 * min(i, 50) / 50


@unittest.skipIf(rosbag is None, "python3-rosbag, python3-sensor-msgs or python3-nav-msgs is not installed")
class Ros1Bags(Folder):
    def write(self, name, compression="none"):
        """Writes 10 s: the robot pitches for 5 s, then stands and presses."""
        with rosbag.Bag(str(self.path / name), "w", compression=compression, chunk_threshold=20_000) as bag:
            for i in range(100):
                time = rospy.Time(1_700_000_000, 100_000_000 * (i % 10)) + rospy.Duration(i // 10)
                imu = Imu()
                imu.header.stamp = time
                imu.orientation.y = -math.sin(pitch_at(i) / 2)  # ROS: nose down positive
                imu.orientation.w = math.cos(pitch_at(i) / 2)
                bag.write("/imu/data", imu, time)
                joints = JointState(name=NAMES, position=[0.1, 0.2, 0.3, 0.4], effort=[17.0 if i > 50 else 0.0] * 4)
                bag.write("/joint_states", joints, time)
                odometry = Odometry()
                odometry.pose.pose.position.x = 0.01 * min(i, 50)
                odometry.pose.pose.orientation.w = 1.0
                bag.write("/odom", odometry, time)
                bag.write("/forces", Float32MultiArray(data=[0.0, 0.0, 0.0, 0.0, 3.0, 5.0]), time)
        return self.path / name

    def imported(self, bag):
        (self.path / "m.toml").write_text(MAPPING)
        out, scenes = bag.with_suffix(".tts"), bag.with_suffix(".csv")
        said = run("import", bag, "--mapping", self.path / "m.toml", "--out", out, "--scenes", scenes)
        run("session", "verify", out)
        return said, rows(scenes)

    def test_every_compression_gives_the_same_session(self):
        for compression in ("none", "bz2", "lz4"):
            with self.subTest(compression):
                said, scenes = self.imported(self.write(f"{compression}.bag", compression))
                self.assertIn("100 lines of telemetry in 9.900 s, 1200 frames and 1 scenes", said)
                self.assertAlmostEqual(float(scenes[0]["pitch_rad"]), 0.2, 4)
                self.assertAlmostEqual(float(scenes[0]["front_rad"]), 0.15, 4)
                self.assertAlmostEqual(float(scenes[0]["front_current_a"]), 3.0, 3)  # 17 N m
                self.assertAlmostEqual(float(scenes[0]["force_6_n"]), 5.0, 1)

    def test_probe_lists_fields_and_proposes_a_mapping(self):
        said = run("import", self.write("a.bag"), "--probe")
        self.assertIn("a.bag: ROS 1 bag, 4 topics, 400 messages", said)
        self.assertRegex(said, r"position\[rear_right_flipper_j\] +0\.4 to 0\.4")
        self.assertIn('field = "position[front_left_flipper_j]"', said)
        self.assertIn('[attitude]\ntopic = "/imu/data"', said)
        proposal = said.split("---- proposed mapping ----\n")[1]
        (self.path / "p.toml").write_text(proposal)
        run("import", self.path / "a.bag", "--mapping", self.path / "p.toml", "--out", self.path / "p.tts")

    def test_a_bag_without_index_or_end_is_read_in_part(self):
        whole = self.write("whole.bag", "lz4").read_bytes()
        for share in (0.3, 0.6, 0.9):
            torn = self.path / f"torn{share}.bag"
            torn.write_bytes(whole[:int(share * len(whole))])
            (self.path / "m.toml").write_text(MAPPING)
            run("import", torn, "--mapping", self.path / "m.toml", "--out", torn.with_suffix(".tts"))

    def test_shipped_absolem_mapping_reads_its_layout(self):
        mapping = pathlib.Path(SOURCE, "resources/mappings/ctu_absolem.toml")
        run("import", self.write("a.bag"), "--mapping", mapping, "--out", self.path / "a.tts")


class Ros2Bags(Folder):
    def test_a_bag_in_sqlite_becomes_a_session(self):
        bag = self.path / "a.db3"
        with sqlite3.connect(bag) as file:
            file.executescript("""
                CREATE TABLE topics(id INTEGER PRIMARY KEY, name TEXT NOT NULL, type TEXT NOT NULL,
                  serialization_format TEXT NOT NULL, offered_qos_profiles TEXT NOT NULL);
                CREATE TABLE messages(id INTEGER PRIMARY KEY, topic_id INTEGER NOT NULL, timestamp INTEGER NOT NULL,
                  data BLOB NOT NULL);
                INSERT INTO topics VALUES(1, '/angles', 'std_msgs/msg/Float64MultiArray', 'cdr', '');""")
            for i in range(50):
                # CDR, little-endian: an empty layout (dimensions, offset), then five numbers at a multiple of eight.
                data = b"\0\1\0\0" + struct.pack("<IIIxxxx5d", 0, 0, 5, pitch_at(i), 0.1, 0.2, 0.3, 0.4)
                file.execute("INSERT INTO messages(topic_id, timestamp, data) VALUES(1, ?, ?)", (10 ** 18 + i * 10 ** 8, data))
        fields = ("pitch", "front_left", "front_right", "rear_left", "rear_right")
        (self.path / "m.toml").write_text('name = "m"\n' + "".join(
            f'[{name}]\ntopic = "/angles"\nfield = "data[{i}]"\n' for i, name in enumerate(fields)))
        said = run("import", bag, "--mapping", self.path / "m.toml", "--out", self.path / "a.tts")
        self.assertIn("50 lines of telemetry in 4.900 s", said)
        self.assertIn("ROS 2 bag (SQLite), 1 topic, 50 messages", run("import", bag, "--probe"))

    def test_topics_that_share_pages_are_refused(self):
        base = self.path / "base.db3"
        with sqlite3.connect(base) as file:
            file.executescript("""
                CREATE TABLE topics(id INTEGER, name TEXT, type TEXT, serialization_format TEXT);
                CREATE TABLE messages(id INTEGER PRIMARY KEY, topic_id INTEGER, timestamp INTEGER, data BLOB);
                INSERT INTO topics VALUES(1, '/angles', 'std_msgs/msg/Float64MultiArray', 'cdr');""")
        file.close()
        bag = hostile_files.shared_leaves(base, self.path / "a.db3", "topics")
        self.assertIn("its tables take more steps to read than a file of its size needs",
                      complaint("import", bag, "--probe"))

    def test_a_session_is_no_recording(self):
        session = pathlib.Path(SOURCE, "resources/sessions/demo.tts")
        self.assertIn("is a recorded session already; open it in the review", complaint("import", session, "--probe"))


if __name__ == "__main__":
    unittest.main()
