"""What docs/clusters.md documents, and the comparison of its results with those of one run."""

import os
import pathlib
import re
import subprocess
import unittest

from support import CLI, SOURCE


def documented(heading):
    """Returns the lines that docs/clusters.md shows below a heading."""
    text = (pathlib.Path(SOURCE) / "docs/clusters.md").read_text()
    section = text.split(f"## {heading}", 1)[1].split("\n## ", 1)[0]
    return [line.strip() for line in section.splitlines() if line.startswith("    ") or not line]


def slurm_scripts():
    """Returns the documented job scripts, as {name: text}."""
    scripts, name = {}, None
    for line in documented("Slurm"):
        if line.startswith("$ "):
            name = line.removeprefix("$ cat ") if line.startswith("$ cat ") else None
        elif line and name:
            scripts[name] = f"{scripts.get(name, '')}{line}\n"
    return scripts


def slurm_commands(heading="Slurm"):
    """Returns the documented commands that submit the job scripts or combine their results."""
    return [line[2:] for line in documented(heading) if line.startswith("$ ") and not line.startswith("$ cat ")]


# What the documented jobs do together, as one run of each command.
ONE_RUN = """terratact train --data scenes.csv --out model.ttm --seed 1
terratact evaluate --model model.ttm --data scenes.csv --out evaluation
"""


class Distributed(unittest.TestCase):
    """Tests that run documented lines and compare their results."""

    def shell(self, script, folder, **variables):
        """Runs a script in a folder, with terratact in the PATH, and returns its output."""
        path = f"{pathlib.Path(CLI).parent}:{os.environ['PATH']}"
        done = subprocess.run(["sh", "-e", "-c", script], cwd=folder, capture_output=True, text=True, timeout=500,
                              env=dict(os.environ, HOME=str(pathlib.Path(folder).resolve()), PATH=path, **variables))
        self.assertEqual(done.returncode, 0, f"{script}\n{done.stdout}\n{done.stderr}")
        return done.stdout

    def assert_same_evaluation(self, one, merged):
        """Every file must be equal to the byte, except the column of measured times. Returns the number of files."""
        one, merged = pathlib.Path(one), pathlib.Path(merged)
        names = sorted(p.name for p in one.iterdir())
        self.assertEqual(names, sorted(p.name for p in merged.iterdir() if p.suffix != ".tte"))
        self.assertIn("errors.csv", names)
        self.assertIn("fig8.svg", names)
        for name in names:
            ours, theirs = (one / name).read_bytes(), (merged / name).read_bytes()
            if name == "scores.csv":
                ours, theirs = (re.sub(rb",[^,]*$", b"", text, flags=re.M) for text in (ours, theirs))
            self.assertEqual(ours, theirs, name)
        return len(names)
