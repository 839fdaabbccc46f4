#!/usr/bin/env python3
"""Prints a table of two builds' benchmarks: the least CPU time of each over the rounds of tests/bench/paired.sh.

The folder holds old-ROUND.json and new-ROUND.json of google-benchmark. Exits with 1 if the ratio new / old of a
benchmark exceeds the limit. Also exits with 1 if no benchmark is in both builds.
"""
import argparse
import json
import pathlib
import sys

from table import UNITS


def least(paths):
    """Returns name → least CPU seconds per iteration over the files."""
    seconds = {}
    for path in paths:
        for row in json.loads(path.read_text())["benchmarks"]:
            measured = row["cpu_time"] * UNITS[row["time_unit"]]
            seconds[row["name"]] = min(measured, seconds.get(row["name"], measured))
    return seconds


def main():
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("--limit", type=float, default=1.05)
    given = parser.parse_args()
    old, new = (least(sorted(given.folder.glob(f"{build}-*.json"))) for build in ("old", "new"))
    names = list(dict.fromkeys([*old, *new]))
    title = "least CPU time [µs]"
    width = max(map(len, [title, *names]))
    print(f"{title:<{width}} {'old':>14} {'new':>14} {'ratio':>7}")
    slower = []
    for name in names:
        times = [f"{1e6 * build[name]:.3f}" if name in build else "-" for build in (old, new)]
        ratio = new[name] / old[name] if name in old and name in new else None
        print(f"{name:<{width}} {times[0]:>14} {times[1]:>14} {'-' if ratio is None else format(ratio, '.3f'):>7}")
        if ratio is not None and ratio > given.limit:
            slower.append(name)
    if not old.keys() & new.keys():
        sys.exit("no benchmark is in both builds")
    if slower:
        sys.exit(f"more than {given.limit:g} times as long: {', '.join(slower)}")


main()
