"""A simulated drive, recorded by the program make_session, for tests of `terratact session`. Argument: that program."""

import pathlib
import re
import shutil
import sqlite3
import subprocess
import sys
import tempfile
import unittest

from support import run

MAKE = sys.argv.pop(1)
BEGIN = 1793000000  # [s since 1970] start of the sessions made by MAKE


def make(kind, path):
    subprocess.run([MAKE, kind, path], check=True, timeout=300)


def frames_of(path):
    """Returns (time [ns since 1970], identifier, data) of a session, read with SQLite only."""
    file = sqlite3.connect(f"file:{path}?mode=ro", uri=True)
    found = file.execute("SELECT t, can_id, data FROM can_frame ORDER BY seq").fetchall()
    file.close()
    return [(BEGIN * 10**9 + t, identifier, data) for t, identifier, data in found]


def change(path, sql):
    file = sqlite3.connect(path)
    file.execute(sql)
    file.commit()
    file.close()


class Session(unittest.TestCase):
    made = tempfile.TemporaryDirectory()
    drive = pathlib.Path(made.name, "drive.tts")

    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.path = pathlib.Path(self.folder.name)

    def export(self, name, *arguments):
        out = self.path / name
        run("session", "export", self.drive, "--out", out, *arguments)
        return out

    def copy(self, name="copy.tts"):
        return pathlib.Path(shutil.copy(self.drive, self.path / name))


def setUpModule():
    make("drive", Session.drive)


def tearDownModule():
    Session.made.cleanup()
