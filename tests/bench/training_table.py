#!/usr/bin/env python3
"""Copies the output of tests/bench/training.sh and adds a table of goals and results.

Exits with 1 if a goal is missed: time and memory of all rows, and error and time through the most inducing rows.
"""
import re
import sys

said = []
for line in sys.stdin:
    print(line, end="", flush=True)
    said.append(line)
text = "".join(said)


def first(pattern, of=text):
    return [float(number) for number in re.search(pattern, of).groups()]


(training,) = first(r"22 Gaussian processes on 1400 rows: ([\d.]+) s,")
growth = [[float(number) for number in row] for row in re.findall(r"^ *(\d+) +([\d.]+) +\d+ +([\d.]+)$", text, re.M)]
sparse = text.split("> sparse")[1]
few, full = (float(seconds) for seconds in re.findall(r"search on .*: ([\d.]+) CPU s", sparse))
processes = [(int(rows), float(seconds), float(error)) for rows, seconds, error
             in re.findall(r"through +(\d+) rows: made in +([\d.]+) CPU s, error ([\d.]+) m", sparse)]
made = {rows: seconds for rows, seconds, _ in processes}
off = {rows: error / processes[-1][2] for rows, _, error in processes}
bins = text.split("> sparse-bins")[1].splitlines()[1:]
columns = [int(rows) for rows in bins[0].split()[3:]]
worst = {m: max(float(row.split()[3 + k]) for row in bins[1:12]) for k, m in enumerate(columns)}
most = max(made)
all_rows = made.pop(most)
faster = {m: (full + all_rows) / (few + seconds) for m, seconds in made.items()}
rows = [("22 Gaussian processes on 1400 rows, two processors [s]", "60", f"{training:.1f}"),
        (f"memory, in squares of the rows (most, from {growth[0][0]:.0f} to {growth[-1][0]:.0f} rows)", "4",
         f"{max(row[2] for row in growth):.2f}")]
for inducing, seconds in sorted(made.items()):
    rows.append((f"{most} rows through {inducing}: error, of that through all, worst of 11 bins", "1.05",
                 f"{worst[inducing]:.3f}"))
    rows.append(("  of that through all with a search on all, one bin", "1.05", f"{off[inducing]:.3f}"))
    rows.append(("  training: all rows' time / its", "10", f"{faster[inducing]:.0f}"))
    rows.append(("  the same where all rows take the search on few", "", f"{(few + all_rows) / (few + seconds):.1f}"))
width = max(len(what) for what, _, _ in rows)
for what, target, reached in [("", "target", "reached"), *rows]:
    print(f"{what:<{width}}  {target:>7}  {reached:>7}")
if (training > 60 or max(row[2] for row in growth) > 4 or worst[max(made)] > 1.05
        or off[max(made)] > 1.05 or faster[max(made)] < 10):
    sys.exit("a target was missed")
