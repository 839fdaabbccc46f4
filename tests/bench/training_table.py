#!/usr/bin/env python3
"""Passes on what tests/bench/training.sh prints, and says at its end what was aimed at and what was reached."""
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
(search,) = first(r"search on .*: ([\d.]+) CPU s", sparse)
made = {int(rows): (float(seconds), float(error))
        for rows, seconds, error in re.findall(r"through +(\d+) rows: made in +([\d.]+) CPU s, error ([\d.]+) m", sparse)}
most = max(made)
seconds, error = made.pop(most)
rows = [("22 Gaussian processes on 1400 rows, two processors [s]", "60", f"{training:.1f}"),
        (f"memory, in squares of the rows (most, from {growth[0][0]:.0f} to {growth[-1][0]:.0f} rows)", "4",
         f"{max(row[2] for row in growth):.2f}")]
for inducing, (less, worse) in sorted(made.items()):
    rows.append((f"{most} rows through {inducing}: error, of that through all", "1.05", f"{worse / error:.3f}"))
    if growth[-1][0] == most:  # train without --inducing searches on all rows: many evaluations, of which this is one
        rows.append(("  training: all rows' time, with one evaluation of its search, / its", "10",
                     f"> {(1e-3 * growth[-1][1] + seconds) / (search + less):.0f}"))
    rows.append(("  the same where all rows take the search on few", "", f"{(search + seconds) / (search + less):.1f}"))
width = max(len(what) for what, _, _ in rows)
for what, target, reached in [("", "target", "reached"), *rows]:
    print(f"{what:<{width}}  {target:>7}  {reached:>7}")
