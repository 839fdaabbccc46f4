"""What the command line tests share: running the program and reading its CSV files."""

import csv
import os
import queue
import subprocess
import threading

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


class Running:
    """A running terratact: what it says, line by line as it says it."""

    def __init__(self, *arguments):
        self.process = subprocess.Popen([CLI, *map(str, arguments)], stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                                        text=True)
        self.said, self.lines = [], queue.Queue()
        self.reader = threading.Thread(target=self._read)
        self.reader.start()

    def _read(self):
        for text in self.process.stdout:
            self.lines.put(text)
        self.lines.put(None)  # it has ended

    def line(self):
        """The next line it says."""
        text = self.lines.get(timeout=100)
        assert text is not None, f"it has ended, and said:\n{''.join(self.said)}"
        self.said.append(text)
        return text

    def until(self, words):
        """The next line with these words."""
        while words not in (text := self.line()):
            pass
        return text

    def has_said_more(self):
        """Than was looked at; its end counts."""
        return not self.lines.empty()

    def wait(self):
        """Its exit status."""
        self.reader.join(timeout=100)
        self.process.stdout.close()
        return self.process.wait(timeout=20)

    def end(self):
        """Ends it as Ctrl-C would; its exit status."""
        self.process.terminate()
        return self.wait()
