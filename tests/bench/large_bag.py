#!/usr/bin/python3
"""Prints time and memory of the import of a large bag: tests/bench/large_bag.py BUILD [GIGABYTES]

The bag is written by ROS's own library (python3-rosbag): telemetry at 50 Hz, and images of 1 MB, default 2 GB."""

import os
import pathlib
import sys
import tempfile

BUILD = pathlib.Path(sys.argv[1]).resolve()
os.environ["TERRATACT_CLI"] = str(BUILD / "app/terratact")
os.environ["TERRATACT_SOURCE_DIR"] = str(pathlib.Path(__file__).resolve().parents[2])
sys.path.insert(0, os.path.join(os.environ["TERRATACT_SOURCE_DIR"], "tests/cli"))

import rosbag  # noqa: E402
import rospy  # noqa: E402
from cost import Cost  # noqa: E402
from import_rosbag_test import MAPPING, NAMES  # noqa: E402
from nav_msgs.msg import Odometry  # noqa: E402
from sensor_msgs.msg import Image, Imu, JointState  # noqa: E402
from std_msgs.msg import Float32MultiArray  # noqa: E402

LINES_PER_IMAGE = 4  # 50 Hz and 12.5 Hz


def write(path, images):
    picture = Image(height=1000, width=1000, encoding="mono8", step=1000, data=os.urandom(1_000_000))
    joints = JointState(name=NAMES, position=[0.1, 0.2, 0.3, 0.4], effort=[17.0] * 4)
    imu, odometry = Imu(), Odometry()
    imu.orientation.w = odometry.pose.pose.orientation.w = 1.0
    forces = Float32MultiArray(data=[0.0, 0.0, 0.0, 0.0, 3.0, 5.0])
    with rosbag.Bag(str(path), "w") as bag:
        for i in range(images * LINES_PER_IMAGE):
            time = rospy.Time(1_700_000_000 + i // 50, (i % 50) * 20_000_000)
            for topic, message in (("/imu/data", imu), ("/joint_states", joints), ("/odom", odometry), ("/forces", forces)):
                bag.write(topic, message, time)
            if i % LINES_PER_IMAGE == 0:
                bag.write("/camera/image", picture, time)


def main():
    gigabytes = float(sys.argv[2]) if len(sys.argv) > 2 else 2.0
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        (folder / "m.toml").write_text(MAPPING)
        bag = folder / "large.bag"
        write(bag, round(1000 * gigabytes))
        for arguments in (["--probe"], ["--mapping", folder / "m.toml", "--check"],
                          ["--mapping", folder / "m.toml", "--out", folder / "large.tts"]):
            done = Cost(os.environ["TERRATACT_CLI"], "import", bag, *arguments, most_seconds=600)
            print(f"{bag.stat().st_size / 1e9:.2f} GB, import {arguments[-2] if len(arguments) > 1 else ''} {arguments[-1]}: exit {done.code}, "
                  f"{done.seconds:.1f} s of processor time, {done.megabytes:.0f} MB  {done.last_words(name)}".replace(f"{folder}/", ""))


if __name__ == "__main__":
    main()
