"""Tests the console's command line: answers without a display, exit codes, screenshot."""

import os
import pathlib
import re
import signal
import struct
import subprocess
import sys
import tempfile
import time
import unittest
import unittest.mock

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "cli"))
from cost import Cost  # noqa: E402
from hostile_binaries import junk  # noqa: E402
from hostile_files import shared_leaves  # noqa: E402
from support import CLI, needs_no_sanitizer  # noqa: E402

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

    def test_without_a_display_it_names_the_cause(self):
        done = run()
        self.assertEqual(done.returncode, 1)
        self.assertIn("no display", done.stderr)

    def test_an_argument_is_the_log_of_a_replay(self):
        log = os.path.join(os.environ["TERRATACT_SOURCE_DIR"], "docs", "can_demo.log")
        done = run(log)  # without a display it still reads the log first
        self.assertIn("no display", done.stderr)
        for path, why in (("/nowhere/x.log", "No such file"), (CONSOLE, "is no text in UTF-8; expected a log of candump")):
            done = run(path)
            self.assertEqual(done.returncode, 1)
            self.assertRegex(done.stderr, f"^terratact-console: {path}.*({why})")

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
                                   env={**os.environ, "QT_QPA_PLATFORM": "offscreen", "XDG_CONFIG_HOME": folder,
                                        "XDG_STATE_HOME": os.path.join(folder, "state")})
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

    def said_in_one_line(self, done, words):
        """Checks a refusal: exit code 1, one line of the program, no core dump."""
        lines = [line for line in done.stderr.splitlines() if "XDG_RUNTIME_DIR" not in line]
        self.assertEqual((done.returncode, len(lines)), (1, 1), done.stderr)
        self.assertRegex(lines[0], f"^terratact-console: .*{words}")

    def test_a_display_that_does_not_exist_is_one_line(self):
        self.said_in_one_line(run(DISPLAY=":9999"), "no window can be opened: could not connect to display :9999")
        self.said_in_one_line(run(DISPLAY=":9999", QT_QPA_PLATFORM="no\x1b[8msuch"),
                              'no window can be opened: .*"no\\?\\[8msuch"')

    def test_without_fonts_it_opens_no_window(self):
        with tempfile.TemporaryDirectory() as folder:
            config, picture = pathlib.Path(folder) / "fonts.conf", pathlib.Path(folder) / "x.png"
            config.write_text("<?xml version='1.0'?><fontconfig></fontconfig>")
            done = run("--screenshot", str(picture), FONTCONFIG_FILE=str(config))
            self.said_in_one_line(done, "no font is installed")
            self.assertFalse(picture.exists())

    def test_little_memory_is_one_line(self):
        for megabytes in (200, 500):
            done = subprocess.run(["bash", "-c", f"ulimit -v {1000 * megabytes}; exec \"$@\"", "-", CONSOLE, "--screenshot",
                                   "/dev/null"], env={**os.environ, "QT_QPA_PLATFORM": "offscreen"}, text=True,
                                  capture_output=True, timeout=300, check=False)
            self.said_in_one_line(done, "(needs 700|OpenBLAS needs 135) MB of memory; .* ulimit -v")

    def test_a_truth_file_costs_what_its_size_allows(self):
        needs_no_sanitizer(self)
        with tempfile.TemporaryDirectory() as name:
            folder = pathlib.Path(name)
            scenes, cloud, poses, whole = (folder / n for n in ("s.csv", "c.pcd", "p.csv", "whole.ttt"))
            for arguments in (("simulate", "--terrain", "varied", "--tracks", "--count", "3", "--out", scenes,
                               "--cloud", cloud, "--poses", poses),
                              ("truth", cloud, "--scenes", scenes, "--poses", poses, "--out", folder / "t.csv",
                               "--review", whole)):
                subprocess.run([CLI, *arguments], check=True, capture_output=True)
            files = [shared_leaves(whole, folder / f"{table}.ttt", table) for table in ("meta", "rule", "scene")]
            for title, content in junk(1_000_000, whole.read_bytes()).items():
                files.append(folder / f"{title}.ttt")
                files[-1].write_bytes(content)
            for file in files:
                with unittest.mock.patch.dict(os.environ, QT_QPA_PLATFORM="offscreen", HOME=name, XDG_STATE_HOME=name,
                                              XDG_CONFIG_HOME=name):
                    done = Cost(CONSOLE, file, "--screenshot", folder / "x.png")
                self.assertEqual(done.code, 1, done.said)
                self.assertLess(done.megabytes, 70 + 30 * file.stat().st_size / 1e6, file.name)
                self.assertLess(done.seconds, 4, file.name)

    def test_a_picture_is_written_through_no_link(self):
        demo = os.path.join(os.environ["TERRATACT_SOURCE_DIR"], "resources", "sessions", "demo.tts")
        with tempfile.TemporaryDirectory() as folder:
            victim, link = pathlib.Path(folder) / "victim", pathlib.Path(folder) / "x.png"
            victim.write_text("mine")
            link.symlink_to(victim)
            self.said_in_one_line(run(demo, "--screenshot", str(link)), "x.png: cannot be written: it is a symbolic link")
            self.assertEqual(victim.read_text(), "mine")

    def test_a_picture_overwrites_no_input(self):
        source = pathlib.Path(os.environ["TERRATACT_SOURCE_DIR"])
        with tempfile.TemporaryDirectory() as directory:
            folder = pathlib.Path(directory)
            demo, notes, dbc = folder / "d.tts", folder / "d.tts.notes.csv", folder / "p.dbc"
            demo.write_bytes((source / "resources/sessions/demo.tts").read_bytes())
            notes.write_text("t_s,note\n1,x\n")
            dbc.write_bytes((source / "docs/can_payload.dbc").read_bytes())
            other = folder / "hard.png"
            other.hardlink_to(dbc)
            for picture, *arguments in ((notes, demo), (dbc, "--dbc", dbc, demo), (other, "--dbc", dbc, demo),
                                        (dbc, "--robot", dbc), (dbc, "--model", dbc), (dbc, "--terrain", dbc),
                                        (dbc, "--panel", dbc)):
                before = picture.read_bytes()
                done = run("--screenshot", str(picture), *map(str, arguments))
                self.said_in_one_line(done, "no input is overwritten")
                self.assertEqual(picture.read_bytes(), before)

    def test_a_file_that_is_not_there_is_named_as_such(self):
        with tempfile.TemporaryDirectory() as folder:
            self.said_in_one_line(run("--screenshot", f"{folder}/x.png", f"{folder}/no.tts"), "no.tts: .*No such file")

    def test_it_starts_without_a_home_folder(self):
        demo = os.path.join(os.environ["TERRATACT_SOURCE_DIR"], "resources", "sessions", "demo.tts")
        with tempfile.TemporaryDirectory() as folder:
            for home in ({}, {"HOME": ""}, {"HOME": "/dev/null"}, {"HOME": "relative"},
                         {"XDG_CONFIG_HOME": "/proc", "XDG_STATE_HOME": "/proc", "XDG_DATA_HOME": "/proc"}):
                picture = os.path.join(folder, "x.png")
                done = subprocess.run([CONSOLE, demo, "--screenshot", picture], capture_output=True, timeout=300,
                                      env={"PATH": os.environ["PATH"], **home}, check=False)
                self.assertEqual(done.returncode, 0, (home, done.stderr))
                os.remove(picture)

    def test_it_runs_and_writes_nothing_without_a_home(self):
        unknown = {"user": 54321, "group": 54321, "extra_groups": []} if os.geteuid() == 0 else {}
        if subprocess.run(["test", "-x", CONSOLE], **unknown, check=False).returncode != 0:
            self.skipTest("another user cannot run the program where it was built")
        with tempfile.TemporaryDirectory() as folder:
            os.chmod(folder, 0o555)
            homes = [{"HOME": folder}, {"HOME": f"{folder}/none"}, {"HOME": "/dev/null"}, {"HOME": "/proc"}]
            if unknown:  # others have a home folder in the user database
                homes += [{}, {"HOME": ""}, {"HOME": "relative"}]
            for home in homes:
                with self.subTest(home):
                    self.assertEqual(self.said_until_ended(folder, home, unknown), [])
                    self.assertEqual(os.listdir(folder), [])

    def said_until_ended(self, folder, home, user):
        """Starts the console in folder, ends it with SIGTERM once its window is shown, and returns its lines."""
        environment = {"PATH": os.environ["PATH"], "LC_ALL": "C.UTF-8", "QT_QPA_PLATFORM": "offscreen", **home}
        console = subprocess.Popen([CONSOLE], cwd=folder, env=environment, stdout=subprocess.DEVNULL,
                                   stderr=subprocess.PIPE, text=True, **user)
        try:
            status = pathlib.Path("/proc", str(console.pid), "status")
            while console.poll() is None:  # the window that handles SIGTERM is shown at once
                caught = next((line for line in status.read_text().splitlines() if line.startswith("SigCgt:")), "0 0")
                if int(caught.split()[1], 16) >> (signal.SIGTERM - 1) & 1:
                    break
                time.sleep(0.05)
            console.terminate()
            said = console.communicate(timeout=300)[1]
        finally:
            console.kill()
        self.assertEqual(console.returncode, 0, said)
        return [line for line in said.splitlines() if not re.search("XDG_RUNTIME_DIR|propagateSizeHints", line)]

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
