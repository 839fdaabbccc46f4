"""Tests the console's command line: answers without a display, exit codes, screenshot."""

import os
import pathlib
import struct
import subprocess
import sys
import tempfile
import time
import unittest

CONSOLE = sys.argv.pop()


def run(*arguments, **environment):
    clean = {k: v for k, v in os.environ.items()
             if k not in ("DISPLAY", "WAYLAND_DISPLAY", "QT_QPA_PLATFORM")}
    return subprocess.run([CONSOLE, *arguments], env={**clean, **environment}, capture_output=True,
                          text=True, timeout=300, check=False)


def png_size(path):
    with open(path, "rb") as file:
        head = file.read(24)
    assert head[:8] == b"\x89PNG\r\n\x1a\n", "not a PNG"
    return struct.unpack(">II", head[16:24])


class Console(unittest.TestCase):
    def test_help_and_version_need_no_display(self):
        for flag, words in (("--help", "--screenshot"), ("--version", "terratact-console ")):
            done = run(flag)
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertIn(words, done.stdout)

    def test_wrong_arguments_end_with_2(self):
        for arguments in (["--no-such"], ["--seed", "x"], ["--size", "12x"], ["--size", "99999x900"],
                          ["--size", "1280x720x3"], ["one.log", "two.log"], ["one.log", "--can", "vcan0"]):
            done = run(*arguments)
            self.assertEqual(done.returncode, 2, arguments)
            self.assertTrue(done.stderr, arguments)

    def test_without_a_display_it_says_so(self):
        done = run()
        self.assertEqual(done.returncode, 1)
        self.assertIn("no display", done.stderr)

    def test_an_argument_is_the_log_of_a_replay(self):
        log = os.path.join(os.environ["TERRATACT_SOURCE_DIR"], "docs", "can_demo.log")
        done = run(log)  # without a display it still reads the log first
        self.assertIn("no display", done.stderr)
        for path, why in (("/nowhere/x.log", "No such file"), (CONSOLE, "this is no log of CAN frames as text")):
            done = run(path)
            self.assertEqual(done.returncode, 1)
            self.assertRegex(done.stderr, f"^terratact-console: {path}.*{why}")

    def test_files_that_cannot_be_read_are_named(self):
        for option in ("--model", "--robot", "--terrain"):
            with tempfile.TemporaryDirectory() as directory:
                picture = os.path.join(directory, "x.png")
                done = run("--screenshot", picture, option, "/nowhere/x")
                self.assertEqual(done.returncode, 1, option)
                self.assertIn("/nowhere/x", done.stderr)
                self.assertEqual(os.listdir(directory), [])

    def test_faults_are_checked_and_need_the_simulation(self):
        done = run("--fault", "hiccups@3")
        self.assertEqual(done.returncode, 1)
        self.assertIn("hiccups@3", done.stderr)
        self.assertIn("slow-arm", done.stderr)
        for other in ("--can", "--replay"):
            self.assertEqual(run("--fault", "silence", other, "x").returncode, 2, other)

    def started(self, folder, *arguments, until):
        """Starts the console with its preferences in folder, and ends it once until() is true."""
        console = subprocess.Popen([CONSOLE, *arguments], stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL,
                                   env={**os.environ, "QT_QPA_PLATFORM": "offscreen", "XDG_CONFIG_HOME": folder})
        try:
            deadline = time.monotonic() + 60
            while not until() and time.monotonic() < deadline:
                time.sleep(0.05)
            time.sleep(0.5)
            self.assertIsNone(console.poll(), "the console has ended")
        finally:
            console.kill()
            console.wait()

    def test_no_preferences_stand_in_the_way_of_a_start(self):
        for content in (b"\0\xff" * 999, b"[General]\nschema=1\nrobot=/nowhere/r\nmodel=/nowhere/m\nfont-scale=x\ndbc=/nowhere/d\n"):
            with tempfile.TemporaryDirectory() as folder:
                file = pathlib.Path(folder) / "terratact" / "console.ini"
                file.parent.mkdir()
                file.write_bytes(content)
                bad = file.with_suffix(".ini.bad")
                begun = time.monotonic()
                self.started(folder, "--safe-mode", until=lambda: time.monotonic() > begun + 2)
                self.assertEqual(file.read_bytes(), content, "safe mode leaves it alone")
                garbage = content.startswith(b"\0")
                begun = time.monotonic()
                self.started(folder, until=lambda: bad.exists() if garbage else time.monotonic() > begun + 2)
                self.assertEqual(bad.exists(), garbage)

    def test_a_picture_that_cannot_be_written_is_named(self):
        done = run("--screenshot", "/nowhere/x.png")
        self.assertEqual(done.returncode, 1)
        self.assertIn("/nowhere/x.png", done.stderr)

    def test_the_screenshot_has_the_size_asked_for(self):
        with tempfile.TemporaryDirectory() as directory:
            picture = os.path.join(directory, "console.png")
            done = run("--screenshot", picture, "--size", "1280x720", "--dbc", "/nowhere/x.dbc")
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertIn("/nowhere/x.dbc: cannot be opened", done.stderr, "and stands in nobody's way")
            self.assertEqual(png_size(picture), (1280, 720))
            self.assertEqual(os.listdir(directory), ["console.png"])


if __name__ == "__main__":
    unittest.main()
