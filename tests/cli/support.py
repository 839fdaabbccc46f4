"""Helpers of the command line tests: running the program and reading its CSV files."""

import csv
import os
import pathlib
import queue
import re
import subprocess
import tempfile
import threading
import unittest

CLI = os.environ["TERRATACT_CLI"]
SOURCE = os.environ["TERRATACT_SOURCE_DIR"]


def run(*arguments, code=0):
    """Runs terratact and returns its stdout. An exit code other than `code` fails the test."""
    done = subprocess.run([CLI, *map(str, arguments)], capture_output=True, text=True, timeout=500)
    assert done.returncode == code, f"{arguments}: exit {done.returncode}\n{done.stdout}\n{done.stderr}"
    return done.stdout


def complaint(*arguments, code=1):
    """Runs terratact, which must fail, and returns its stderr."""
    done = subprocess.run([CLI, *map(str, arguments)], capture_output=True, text=True, timeout=500)
    assert done.returncode == code, f"{arguments}: exit {done.returncode}\n{done.stdout}\n{done.stderr}"
    return done.stderr


def fault_names():
    """Returns the kinds and the sensors of the faults that the program reads."""
    said = complaint("simulate", "--disturb", "no:such", "--out", os.devnull, code=2)
    names = re.search(r"KIND one of ([\w -]+), SENSORS one of ([\w -]+)", said)
    assert names, said
    return names[1].split(), names[2].split()


def sanitized():
    """Whether the program was built with a sanitizer, which needs more address space than this."""
    done = subprocess.run(["bash", "-c", 'ulimit -v 1000000; exec "$@"', "-", CLI, "--version"], capture_output=True,
                          timeout=300, check=False)
    return done.returncode != 0


def needs_no_sanitizer(test, why="a sanitizer needs the address space"):
    """Skips a test of little memory, or of a long computation, if the program was built with a sanitizer."""
    if sanitized():
        test.skipTest(why)


class Folder(unittest.TestCase):
    """Tests with a folder of their own, self.path."""

    def setUp(self):
        made = tempfile.TemporaryDirectory()
        self.addCleanup(made.cleanup)
        self.path = pathlib.Path(made.name)


def rows(path):
    with open(path, newline="") as file:
        return list(csv.DictReader(file))


class Running:
    """A running terratact whose output is read line by line."""

    def __init__(self, *arguments):
        self.process = subprocess.Popen([CLI, *map(str, arguments)], stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                                        text=True)
        self.said, self.lines = [], queue.Queue()
        self.reader = threading.Thread(target=self._read)
        self.reader.start()

    def _read(self):
        for text in self.process.stdout:
            self.lines.put(text)
        self.lines.put(None)  # end of the output

    def line(self):
        """Returns the next line of output."""
        text = self.lines.get(timeout=100)
        assert text is not None, f"it has ended, and said:\n{''.join(self.said)}"
        self.said.append(text)
        return text

    def until(self, words):
        """Returns the next line that contains these words."""
        while words not in (text := self.line()):
            pass
        return text

    def wait(self):
        """Waits for the end and returns the exit status."""
        self.reader.join(timeout=100)
        self.process.stdout.close()
        return self.process.wait(timeout=20)

    def end(self):
        """Interrupts it like Ctrl-C and returns the exit status."""
        self.process.terminate()
        return self.wait()
