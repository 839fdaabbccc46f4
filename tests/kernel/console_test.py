"""The console as a program on a real kernel's bus beside a robot as a program, driven by an X server's keys: from arming to
the second estimate, and STOP.  To be run in tests/kernel/run.sh:  console_test.py terratact-console"""

import os
import pathlib
import subprocess
import sys
import tempfile
import time
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "cli"))
from support import Running, run  # noqa: E402

CONSOLE = sys.argv.pop()
PATIENCE = 100.0  # [s] for what takes seconds; the guest is slow


def key(*arguments):
    subprocess.run(["xdotool", *arguments], check=True)


class Robot(Running):
    """Its newest line is what it does: "halted, armed (epoch 3)"."""

    def does(self, words, seconds=PATIENCE):
        """Whether its newest line has these words by then."""
        end = time.monotonic() + seconds
        while time.monotonic() < end:
            while self.has_said_more():
                self.line()
            if self.said and words in self.said[-1]:
                return True
            time.sleep(0.02)
        return False


class Mission(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.path = pathlib.Path(folder.name)
        display = subprocess.Popen(["Xvfb", ":7", "-screen", "0", "1280x720x24", "-nolisten", "tcp"], stderr=subprocess.DEVNULL)
        self.addCleanup(display.wait)
        self.addCleanup(display.kill)
        self.robot = Robot("robot", "--can", "vcan0", "--speed", 10)
        self.addCleanup(self.robot.end)
        os.environ |= {"DISPLAY": ":7", "QT_QPA_PLATFORM": "xcb", "XDG_RUNTIME_DIR": str(self.path)}
        end = time.monotonic() + PATIENCE
        while not pathlib.Path("/tmp/.X11-unix/X7").exists() and time.monotonic() < end:
            time.sleep(0.05)

    def start_console(self):
        self.console = subprocess.Popen([CONSOLE, "--can", "vcan0", "--transmit", "--safe-mode", "--language", "en", "--size",
                                         "1200x680", "--sessions", str(self.path / "sessions")])
        self.addCleanup(self.console.wait)
        self.addCleanup(self.console.kill)
        window = subprocess.run(["xdotool", "search", "--sync", "--onlyvisible", "--pid", str(self.console.pid)],
                                check=True, capture_output=True, text=True, timeout=PATIENCE).stdout.split()[0]
        key("windowfocus", "--sync", window)

    def holds(self, name, words, seconds=4.0):
        """Holds a key until the robot does what is wanted."""
        key("keydown", name)
        try:
            return self.robot.does(words, seconds)
        finally:
            key("keyup", name)

    def arms(self):
        """Both actions, again where the guest was too slow for one of them."""
        end = time.monotonic() + PATIENCE
        while not self.robot.does(", armed", 0.0):
            self.assertLess(time.monotonic(), end, "".join(self.robot.said))
            key("key", "m")
            time.sleep(0.3)
            self.holds("m", ", armed")

    def drives(self, seconds):
        """So far, armed anew where something has disarmed it."""
        for _ in range(10):
            self.arms()
            key("keydown", "w")
            drove = self.robot.does("driving, armed", 4.0)
            if drove:
                time.sleep(seconds)
            key("keyup", "w")
            if drove and self.robot.does("halted, armed", 4.0):
                return
        self.fail("".join(self.robot.said))

    def explores(self):
        for _ in range(10):
            self.arms()
            key("key", "a")
            if self.robot.does("front flippers pressed", 20.0) and self.holds("space", "probing with the arm", 20.0):
                return
            key("key", "Escape")
        self.fail("".join(self.robot.said))

    def test_a_whole_exploration_and_stop(self):
        self.start_console()
        self.drives(0.5)
        self.explores()
        self.assertTrue(self.robot.does("front flippers pressed"), "after the probe")
        time.sleep(2.0)  # the second estimate
        key("key", "F12")
        self.assertTrue(self.robot.does("stopped"))
        self.console.terminate()
        self.assertEqual(self.console.wait(timeout=PATIENCE), 0)
        session, = (self.path / "sessions").glob("*.tts")
        run("session", "verify", session)
        report = run("session", "info", session)
        print(report)


if __name__ == "__main__":
    unittest.main()
