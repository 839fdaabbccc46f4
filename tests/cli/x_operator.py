"""An operator at the console: uses an X server's keys and mouse, and sees the recorded session and the screen."""

import os
import pathlib
import sqlite3
import struct
import subprocess
import tempfile
import time

import numpy as np

PATIENCE = 200.0  # [s] for all waits together
# Arguments of an X server in the guest of tests/kernel/run.sh: it leaves no lock and no socket among the host's files.
HIDDEN = ("-nolock", "-nolisten", "unix")


class Operator:
    def __init__(self, hands, session):
        """hands: a running `xdotool -` whose standard input is text."""
        self.hands, self.session = hands, session
        self.deadline = time.monotonic() + PATIENCE

    def look(self):
        """Reads other state; called while waiting."""

    def until(self, condition, seconds=None, what="what was awaited"):
        """Returns whether the condition came true; without a limit of its own it must."""
        end = self.deadline if seconds is None else min(self.deadline, time.monotonic() + seconds)
        while True:
            self.look()
            if condition():
                return True
            if time.monotonic() > end:
                assert end < self.deadline, f"never: {what}; recorded: {self.events()[-12:]}"
                return False
            time.sleep(0.02)

    def does(self, text):
        self.hands.stdin.write(text + "\n")
        self.hands.stdin.flush()

    def presses(self, key):
        self.does(f"key {key}")
        time.sleep(0.1)  # makes a second action, not key repeat

    def holds(self, key, condition, seconds=None, what="what was awaited"):
        self.does(f"keydown {key}")
        came = self.until(condition, seconds, what)
        self.does(f"keyup {key}")
        time.sleep(0.1)
        return came

    def events(self, *kinds):
        """Returns (kind, subject, text) of the events recorded so far."""
        with sqlite3.connect(f"file:{self.session}?mode=ro", uri=True) as database:
            found = database.execute("SELECT kind, subject, text FROM event ORDER BY id").fetchall()
        return [event for event in found if not kinds or event[0] in kinds]

    def phases(self):
        return [subject for _, subject, _ in self.events("phase")]

    def decisions(self):
        return [subject for _, subject, _ in self.events("decision")]


def begin(test, *command, **options):
    """Starts a process that ends with the test."""
    process = subprocess.Popen(command, **options)
    test.addCleanup(process.wait)
    test.addCleanup(process.kill)
    return process


def begin_display(test, *arguments, size):
    """Starts Xvfb as the test's DISPLAY. arguments: further arguments of Xvfb."""
    ready, told = os.pipe()
    begin(test, "Xvfb", *arguments, "-screen", "0", f"{size}x24", "-noreset", "-displayfd", str(told), pass_fds=[told])
    os.close(told)
    with os.fdopen(ready) as number:
        os.environ["DISPLAY"] = f":{number.readline().strip()}"


def begin_console(test, *command, name, preferences):
    """Starts a console and waits until its window of this name has the focus. Returns the process, its session, and
    hands for an Operator. preferences: lines of its file."""
    folder = tempfile.TemporaryDirectory(dir="/dev/shm")
    test.addCleanup(folder.cleanup)
    path = pathlib.Path(folder.name)
    config = path / "terratact" / "console.ini"
    config.parent.mkdir()
    config.write_text("\n".join(["[General]", "schema=1", *preferences, ""]))
    environment = os.environ | {"QT_QPA_PLATFORM": "xcb", "XDG_CONFIG_HOME": str(path), "XDG_RUNTIME_DIR": str(path)}
    console = begin(test, *command, "--sessions", path / "sessions", env=environment)
    subprocess.run(["xdotool", "search", "--sync", "--onlyvisible", "--name", name, "windowfocus", "--sync"],
                   check=True, timeout=PATIENCE, stdout=subprocess.DEVNULL)
    session, = (path / "sessions").glob("*.tts")
    hands = begin(test, "xdotool", "-", stdin=subprocess.PIPE, text=True)
    test.addCleanup(hands.stdin.close)
    return console, session, hands


class Screen:
    """The screen of an Xvfb started with -fbdir."""

    def __init__(self, folder):
        self.file = pathlib.Path(folder) / "Xvfb_screen0"

    def pixels(self):
        """Returns 0xRRGGBB row by row, from an XWD file of 24 bits in words of 32."""
        data = self.file.read_bytes()
        header = struct.unpack(">25I", data[:100])
        size, width, height, row, colours = header[0], header[4], header[5], header[12], header[19]
        begin = size + 12 * colours
        words = np.frombuffer(data, "<u4", count=height * row // 4, offset=begin).reshape(height, row // 4)
        return words[:, :width] & 0xFFFFFF

    def middle_of(self, colour):
        """Returns (x, y), the middle of the largest area of one uninterrupted colour, such as a button's; None: no area
        is 40 pixels wide."""
        longest = []
        for y, row in enumerate(self.pixels() == colour):
            edges = np.flatnonzero(np.diff(np.concatenate(([0], row.view(np.int8), [0]))))
            begins, ends = edges[::2], edges[1::2]
            if len(begins):
                i = int(np.argmax(ends - begins))
                longest.append((int(ends[i] - begins[i]), int(begins[i] + ends[i]) // 2, y))
        if not longest:
            return None
        most = max(longest)[0]
        rows = [(x, y) for length, x, y in longest if length > 0.8 * most]
        if most < 40 or len(rows) < 4:
            return None
        return rows[0][0], (rows[0][1] + rows[-1][1]) // 2
