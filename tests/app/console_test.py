"""The console's command line: what it answers without a display, its exit codes, its screenshot."""

import os
import struct
import subprocess
import sys
import tempfile
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
        done = run(log)  # as far as it gets without a display: the log is read before
        self.assertIn("no display", done.stderr)
        for path, why in (("/nowhere/x.log", "No such file"), (CONSOLE, "needs a log of candump -L")):
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

    def test_a_fault_that_is_none_is_named_and_needs_the_built_in_robot(self):
        done = run("--fault", "hiccups@3")
        self.assertEqual(done.returncode, 1)
        self.assertIn("hiccups@3", done.stderr)
        self.assertIn("slow-arm", done.stderr)
        for other in ("--can", "--replay"):
            self.assertEqual(run("--fault", "silence", other, "x").returncode, 2, other)

    def test_a_picture_that_cannot_be_written_is_named(self):
        done = run("--screenshot", "/nowhere/x.png")
        self.assertEqual(done.returncode, 1)
        self.assertIn("/nowhere/x.png", done.stderr)

    def test_the_screenshot_has_the_size_asked_for(self):
        with tempfile.TemporaryDirectory() as directory:
            picture = os.path.join(directory, "console.png")
            done = run("--screenshot", picture, "--size", "1280x720")
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertEqual(png_size(picture), (1280, 720))
            self.assertEqual(os.listdir(directory), ["console.png"])


if __name__ == "__main__":
    unittest.main()
