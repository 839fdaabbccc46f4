"""What the command line tests share: running the program and reading its CSV files."""

import csv
import os
import subprocess

CLI = os.environ["TERRATACT_CLI"]
SOURCE = os.environ["TERRATACT_SOURCE_DIR"]


def run(*arguments, code=0):
    """Runs terratact; its stdout. Any other exit code than `code` fails the test."""
    done = subprocess.run([CLI, *map(str, arguments)], capture_output=True, text=True, timeout=500)
    assert done.returncode == code, f"{arguments}: exit {done.returncode}\n{done.stdout}\n{done.stderr}"
    return done.stdout


def complaint(*arguments, code=1):
    """Runs terratact, which must fail; what it says on stderr."""
    done = subprocess.run([CLI, *map(str, arguments)], capture_output=True, text=True, timeout=500)
    assert done.returncode == code, f"{arguments}: exit {done.returncode}\n{done.stdout}\n{done.stderr}"
    return done.stderr


def rows(path):
    with open(path, newline="") as file:
        return list(csv.DictReader(file))
