"""terratact-console and terratact robot on one bus of a real kernel: an operator at an X server's keys explores, probes and stops.

The operator goes by what the programs tell, never by the clock: a console that was kept waiting for 100 ms disarms itself,
which on a busy machine happens at any time, and is armed anew.  To be run in tests/kernel/run.sh.
"""

import collections
import os
import pathlib
import socket
import sqlite3
import struct
import subprocess
import sys
import tempfile
import time
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "cli"))
from can_frames import MESSAGES  # noqa: E402
from support import Running, rows, run  # noqa: E402

CONSOLE = sys.argv.pop()
PATIENCE = 200.0  # [s] for all together
WAY = 0.6  # [m] towards the step of the built-in ground, short of where the flippers feel it
ASKED = ("Stop", "Arm", "BeginAtem", "AbortAtem", "PressFlippers", "ProbeBin")  # what is sent once for each time it is wanted


class Bus:
    """What has been on vcan0: how many frames of each name, and the newest values."""

    def __init__(self):
        self.names = {message.id: name for name, message in MESSAGES.items()
                      if name in (*ASKED, "Odometry", "RobotStatus", "ArmResult")}
        self.socket = socket.socket(socket.PF_CAN, socket.SOCK_RAW, socket.CAN_RAW)
        self.socket.setsockopt(socket.SOL_CAN_RAW, socket.CAN_RAW_FILTER,
                               b"".join(struct.pack("=II", number, 0x7FF) for number in self.names))
        self.socket.bind(("vcan0",))
        self.socket.setblocking(False)
        self.count, self.newest = collections.Counter(), {}

    def look(self):
        while True:
            try:
                number, content = struct.unpack("=IxxxxQ", self.socket.recv(16))
            except BlockingIOError:
                return
            name = self.names[number]
            self.count[name] += 1
            self.newest[name] = content

    def value(self, name, signal):
        """Of the newest frame; None before there was one."""
        layout = MESSAGES[name].signals[signal]
        if name not in self.newest:
            return None
        raw = self.newest[name] >> layout.start & (1 << layout.length) - 1
        if layout.signed and raw >> layout.length - 1:
            raw -= 1 << layout.length
        return layout.words.get(raw, raw * layout.scale)


class Operator:
    """Somebody with a keyboard who sees the bus and what the console records."""

    def __init__(self, keyboard, session):
        self.keyboard, self.session, self.bus = keyboard, session, Bus()
        self.deadline = time.monotonic() + PATIENCE

    def until(self, condition, seconds=None, what="what was awaited"):
        """Whether it came about; without a limit of its own it must."""
        end = self.deadline if seconds is None else min(self.deadline, time.monotonic() + seconds)
        while True:
            self.bus.look()
            if condition():
                return True
            if time.monotonic() > end:
                assert end < self.deadline, f"never: {what}; recorded: {self.events()[-12:]}"
                return False
            time.sleep(0.02)

    def keys(self, text):
        self.keyboard.stdin.write(text + "\n")
        self.keyboard.stdin.flush()

    def presses(self, key):
        self.keys(f"key {key}")
        time.sleep(0.1)  # a second action, not a repeated key

    def holds(self, key, condition, seconds):
        self.keys(f"keydown {key}")
        came = self.until(condition, seconds)
        self.keys(f"keyup {key}")
        time.sleep(0.1)
        return came

    def events(self, *kinds):
        """(kind, subject, text) of what is recorded so far."""
        with sqlite3.connect(f"file:{self.session}?mode=ro", uri=True) as database:
            found = database.execute("SELECT kind, subject, text FROM event ORDER BY id").fetchall()
        return [event for event in found if not kinds or event[0] in kinds]

    def phases(self):
        return [subject for _, subject, _ in self.events("phase")]

    def armed(self):
        return self.bus.value("RobotStatus", "Armed") == "armed"

    def is_doing(self, activity):
        return self.bus.value("RobotStatus", "Activity") == activity

    def travelled(self):
        return self.bus.value("Odometry", "Travelled")

    def arms(self):
        while not self.armed():
            self.presses("m")
            self.holds("m", self.armed, 4)

    def drives(self, way):
        self.until(lambda: self.travelled() is not None, what="odometry")
        goal = self.travelled() + way
        while self.travelled() < goal:
            self.arms()
            self.holds("w", lambda: self.travelled() >= goal or not self.armed(), 20)
        self.until(lambda: self.is_doing("halted"), what="halted after the drive")

    def explores_and_probes(self):
        while True:
            self.arms()
            before = len(self.phases())

            def came(*phases):
                return any(phase in phases for phase in self.phases()[before:])

            self.presses("a")
            self.until(lambda: came("arm probe proposed", "exploration failed"), 20)
            if not came("arm probe proposed"):
                continue
            self.holds("space", lambda: self.is_doing("probing with the arm") or not self.armed(), 20)
            self.until(lambda: came("estimate stands", "exploration failed"), 60)
            if came("estimate stands"):
                return


class Programs(unittest.TestCase):
    def begin(self, *command, **options):
        """A process that ends with the test."""
        process = subprocess.Popen(command, **options)
        self.addCleanup(process.wait)
        self.addCleanup(process.kill)
        return process

    def start_display(self):
        """An X server of this kernel only: no lock and no socket among the host's files."""
        os.environ["DISPLAY"] = ":7"
        ready, told = os.pipe()
        self.begin("Xvfb", ":7", "-screen", "0", "1280x800x24", "-nolock", "-nolisten", "unix", "-noreset", "-displayfd", str(told),
                   pass_fds=[told])
        os.close(told)
        with os.fdopen(ready) as number:
            self.assertEqual(number.readline(), "7\n")

    def start_console(self):
        """(Its process, its session), with an X server's focus."""
        folder = tempfile.TemporaryDirectory(dir="/dev/shm")
        self.addCleanup(folder.cleanup)
        path = pathlib.Path(folder.name)
        config = path / "terratact" / "console.ini"
        config.parent.mkdir()
        config.write_text("[General]\nschema=1\nprobe-above=0.01\n")  # there is always something to probe
        environment = os.environ | {"QT_QPA_PLATFORM": "xcb", "XDG_CONFIG_HOME": str(path), "XDG_RUNTIME_DIR": str(path)}
        console = self.begin(CONSOLE, "--can", "vcan0", "--transmit", "--sessions", path / "sessions", "--size", "1200x680",
                             env=environment)
        subprocess.run(["xdotool", "search", "--sync", "--onlyvisible", "--name", "Terratact — vcan0", "windowfocus", "--sync"],
                       check=True, timeout=PATIENCE, stdout=subprocess.DEVNULL)
        session, = (path / "sessions").glob("*.tts")
        return console, session

    def test_an_operator_explores_probes_and_stops(self):
        robot = Running("robot", "--can", "vcan0", "--speed", 4)
        self.addCleanup(robot.end)
        self.start_display()
        console, session = self.start_console()
        keyboard = self.begin("xdotool", "-", stdin=subprocess.PIPE, text=True)
        self.addCleanup(keyboard.stdin.close)
        operator = Operator(keyboard, session)
        self.addCleanup(operator.bus.socket.close)

        operator.until(lambda: ("link", "up", "") in operator.events(), what="telemetry")
        operator.drives(WAY)
        operator.explores_and_probes()
        operator.until(lambda: operator.bus.value("ArmResult", "Measured") == "measured", what="a measured height")
        self.assertIn("approve", [subject for _, subject, _ in operator.events("decision")])

        operator.arms()
        operator.presses("F12")
        robot.until("stopped, disarmed")
        operator.until(lambda: operator.is_doing("stopped"), what="stopped")
        operator.until(lambda: "STOPPED" in operator.phases(), what="STOPPED on the screen")

        robot.process.kill()
        operator.until(lambda: ("link", "lost") in [event[:2] for event in operator.events()], what="a lost link")
        operator.bus.look()
        console.terminate()
        self.assertEqual(console.wait(timeout=PATIENCE), 0)

        self.assertIn(": holds", run("session", "verify", session))
        log = session.with_suffix(".csv")
        run("session", "export", session, "--out", log, "--what", "frames")
        recorded = collections.Counter(row["id"] for row in rows(log))
        for name in ASKED:
            self.assertEqual(recorded[str(MESSAGES[name].id)], operator.bus.count[name], name)


if __name__ == "__main__":
    unittest.main()
