"""Finds heights in a public airborne laser scan that Debian's libcgal-demo ships. Exits with 77 where it is not installed.

The scan has two points on a square metre. At a twentieth of its size it is a ground that a robot can stand on: its
noise, gaps and coordinates of hundreds of kilometres are those of a real scanner."""

import pathlib
import re
import sys
import tarfile
import unittest

import numpy

from support import Folder, complaint, rows, run

DATA = pathlib.Path("/usr/share/doc/libcgal-dev/data.tar.gz")
SCAN = "data/points_3/b9_training.ply"
TYPES = {"double": "<f8", "float": "<f4", "uchar": "u1", "int": "<i4"}
BINS = [f"{-0.3 + 0.1 * i:+.1f}" for i in range(11)]
TRACK_Y, FLIPPER_Y = 0.1985, 0.272  # of the shipped robot


def points_of(ply):
    """Returns the points of a binary PLY as its header says."""
    begin = ply.index(b"end_header\n") + 11
    header = ply[:begin].decode()
    columns = [(name, TYPES[kind]) for kind, name in re.findall(r"property (\w+) (\w+)", header)]
    count = int(re.search(r"element vertex (\d+)", header)[1])
    rows_of = numpy.frombuffer(ply, dtype=columns, count=count, offset=begin)
    return numpy.stack([rows_of[axis] for axis in "xyz"], axis=1).astype(float)


def flattest(points, count):
    """Returns places where the robot stands best: middle, and height, slope ahead and slope to the left there."""
    found = []
    for middle in points[::37]:
        near = points[(abs(points[:, 0] - middle[0]) < 0.8) & (abs(points[:, 1] - middle[1]) < 0.35)]
        if len(near) < 300:
            continue
        terms = numpy.c_[near[:, :2] - middle[:2], numpy.ones(len(near))]
        plane = numpy.linalg.lstsq(terms, near[:, 2], rcond=None)[0]
        found.append(((near[:, 2] - terms @ plane).std(), middle, plane))
    found.sort(key=lambda place: place[0])
    return [(middle, plane) for _, middle, plane in found[:count]]


class PublicScan(Folder):
    def setUp(self):
        super().setUp()
        with tarfile.open(DATA) as archive:
            self.ply = archive.extractfile(SCAN).read()
        (self.path / "scan.ply").write_bytes(self.ply)
        self.points = points_of(self.ply) / 20.0
        head = b"ply\nformat binary_little_endian 1.0\nelement vertex %d\n" % len(self.points)
        head += b"".join(b"property double %s\n" % axis for axis in (b"x", b"y", b"z")) + b"end_header\n"
        (self.path / "small.ply").write_bytes(head + self.points.astype("<f8").tobytes())

    def write_scenes(self, places):
        run("simulate", "--terrain", "varied", "--tracks", "--count", 1, "--seed", 1, "--out", self.path / "form.csv")
        columns = [name for name in rows(self.path / "form.csv")[0] if "_h_" not in name]
        lines, poses = [",".join(columns)], ["t_s,x_m,y_m,z_m,qx,qy,qz,qw"]
        for i, (middle, plane) in enumerate(places):
            pitch, roll = numpy.arctan(plane[0]), numpy.arctan(plane[1])
            values = {"run": "a", "t_s": i, "pitch_rad": pitch, "roll_rad": roll}
            lines.append(",".join(str(values.get(c, 0.3 if c.endswith("_rad") else 1.0)) for c in columns))
            x, y = numpy.sin(roll / 2) * numpy.cos(pitch / 2), -numpy.cos(roll / 2) * numpy.sin(pitch / 2)
            z, w = numpy.sin(roll / 2) * numpy.sin(pitch / 2), numpy.cos(roll / 2) * numpy.cos(pitch / 2)
            poses.append(f"{i},{middle[0]},{middle[1]},{plane[2] + 0.1},{x},{y},{z},{w}")
        (self.path / "scenes.csv").write_text("\n".join(lines) + "\n")
        (self.path / "poses.csv").write_text("\n".join(poses) + "\n")

    def truth_of(self, cloud):
        return ("truth", self.path / cloud, "--scenes", self.path / "scenes.csv", "--poses", self.path / "poses.csv",
                "--max-speed", 1000, "--align", "--out", self.path / "truth.csv")

    def test_heights_are_those_of_the_points(self):
        places = flattest(self.points, 12)
        self.write_scenes(places)
        said = run(*self.truth_of("small.ply"))
        self.assertIn("22300 points of 1 clouds", said)
        apart = []
        for (middle, plane), row in zip(places, rows(self.path / "truth.csv")):
            for side, sign in (("left", 1), ("right", -1)):
                for i, name in enumerate(BINS):
                    height = row[f"{side}_h_{name}_m"]
                    y = middle[1] + sign * (TRACK_Y if i < 6 else FLIPPER_Y)
                    below = self.points[(abs(self.points[:, 0] - middle[0] + 0.3 - 0.1 * i) < 0.05)
                                        & (abs(self.points[:, 1] - y) < 0.05)]
                    if height and len(below) > 3:
                        apart.append(float(height) + plane[2] + 0.1 - numpy.median(below[:, 2]))
        self.assertGreater(len(apart), 100)
        low, middle, high = numpy.percentile(apart, [10, 50, 90])  # the middle is the IMU above the base, and the offset
        self.assertLess(high - low, 0.03)
        self.assertLess(abs(middle), 0.2)

    def test_one_sentence_says_that_the_scan_is_too_sparse(self):
        self.write_scenes([(20.0 * middle, plane * [1, 1, 20]) for middle, plane in flattest(self.points, 3)])
        said = complaint(*self.truth_of("scan.ply"))
        self.assertRegex(said, r"no bin has a known height: \d+ points lie on a square metre under the scenes, and \d+ % "
                               r"of the cells of 2 cm have one; a bin needs three of five: take a denser cloud")
        self.assertFalse((self.path / "truth.csv").exists())


if __name__ == "__main__":
    if not DATA.exists():
        print(f"skipped: {DATA} is missing; cmake/setup.sh scans installs it")
        sys.exit(77)
    unittest.main()
