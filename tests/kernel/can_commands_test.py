"""Tests `terratact can` on a bus of a real kernel, with candump, cansend, cangen and canplayer. Run by tests/kernel/run.sh."""

import pathlib
import re
import subprocess
import sys
import tempfile
import time
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "cli"))
from can_frames import line, telemetry  # noqa: E402
from support import CLI, SOURCE, Running, rows, run  # noqa: E402

EVERYTHING = "vcan0,0:0,#FFFFFFFF"  # includes error frames
# One frame of every kind that cansend supports.
KINDS = ["044#2A366C2BBA", "12345678#01", "044#R", "044#R4", "12345678#R8", "7FF#", "000#", "044##1AABB",
         "044##011223344556677889900AABB", "20000004#0004000000006000", "20000088#0000080B00000000"]


def ip(*arguments):
    subprocess.run(["ip", "link", *arguments], check=True)


def wait_for_listeners(count):
    """Waits until `count` sockets receive everything on vcan0."""
    def listeners():
        received = pathlib.Path("/proc/net/can/rcvlist_all").read_text()
        return sum(text.split()[:1] == ["vcan0"] for text in received.splitlines())

    deadline = time.monotonic() + 60.0
    while listeners() < count:
        assert time.monotonic() < deadline, f"{listeners()} of {count} listen"
        time.sleep(0.01)


def tables(monitor):
    """Yields the tables of a running monitor."""
    while True:
        table = ""
        while (text := monitor.line()).strip():
            table += text
        yield table


class OnARealBus(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.path = pathlib.Path(self.folder.name)

    def tearDown(self):
        self.folder.cleanup()

    def decoded(self, log):
        """Returns a log's frames without their times."""
        out = self.path / "out.csv"
        run("can", "decode", log, "--summary", "--csv", out)
        return [{key: value for key, value in row.items() if key != "time_s"} for row in rows(out)]

    def test_all_dialects_of_candump_are_the_same_frames(self):
        forms = {"compact": ["-L"], "long": ["-ta"], "from zero": ["-tz"], "without times": [],
                 "with everything": ["-ta", "-x", "-e", "-a", "-d"]}
        count, dumps = len(KINDS) + 300, []
        for name, options in forms.items():
            with open(self.path / name, "w") as out:
                dumps.append(subprocess.Popen(["candump", "-r", "4000000", "-n", str(count), *options, EVERYTHING], stdout=out))
            self.addCleanup(dumps[-1].kill)
        wait_for_listeners(len(dumps))
        for kind in KINDS:
            subprocess.run(["cansend", "vcan0", kind], check=True)
        subprocess.run(["cangen", "vcan0", "-n", "300", "-g", "1", "-I", "r", "-L", "r", "-D", "r", "-m", "-R"], check=True)
        for dump in dumps:
            self.assertEqual(dump.wait(timeout=60), 0)
        frames = self.decoded(self.path / "compact")
        self.assertEqual(len(frames), count)
        for name in forms:
            self.assertEqual(self.decoded(self.path / name), frames, name)

    def test_a_monitor_shows_what_canplayer_plays(self):
        log = self.path / "demo.log"
        log.write_text("".join(line(1000 + 0.05 * i + 0.0003 * j, content, "can7")
                               for i in range(400) for j, content in enumerate(telemetry(i))))
        monitor = Running("can", "monitor", "vcan0")
        self.addCleanup(monitor.end)
        wait_for_listeners(1)
        player = subprocess.Popen(["canplayer", "-I", log, "vcan0=can7"])
        self.addCleanup(player.wait)
        self.addCleanup(player.kill)
        for table in tables(monitor):
            self.assertIn("0 dropped", table)
            # Every verdict is ok, except delays of the player on a busy machine.
            self.assertNotRegex(table, r"\((?!ok after \d)")
            if (re.search(r"022 +Attitude +\d\d\.\d +\d\.\d\d  Pitch 0.2100 rad, Roll -0.0500 rad\n", table)
                    and re.search(r"ArmResult +\d\d\.\d +\d\.\d\d  not measured\n", table)):
                break
            self.assertIsNone(player.poll(), f"all was played, and never shown: {table}")

    def test_a_monitor_outlives_its_interface(self):
        monitor = Running("can", "monitor", "vcan0")
        self.addCleanup(monitor.end)
        monitor.until("vcan0: working")
        ip("delete", "vcan0")
        monitor.until("vcan0 does not exist")
        ip("add", "dev", "vcan0", "type", "vcan")
        ip("set", "vcan0", "up")
        wait_for_listeners(1)
        subprocess.run(["cansend", "vcan0", "123#5A"], check=True)
        monitor.until("[1] 5A (unknown identifier)")

    def test_a_monitor_ends_at_its_limit(self):
        self.assertIn("vcan0: working", run("can", "monitor", "vcan0", "--seconds", 0.5))

    def test_check_separates_absent_down_and_usable(self):
        run("can", "check", "vcan0")
        ip("set", "vcan0", "down")
        try:
            text = run("can", "check", "vcan0", code=1)
            self.assertRegex(text, r"problem +it is down\n +→ sudo ip link set vcan0 up\n")
            shown = "".join(f"    {line}\n" for line in text.splitlines())
            self.assertIn("    $ terratact can check vcan0\n" + shown, (pathlib.Path(SOURCE) / "docs/can.md").read_text())
        finally:
            ip("set", "vcan0", "up")
        self.assertIn("there is no interface can9, but vcan0", run("can", "check", "can9", code=1))

    def test_check_warns_of_a_small_receive_buffer(self):
        nobody = ["setpriv", "--reuid=65534", "--clear-groups", "--inh-caps=-all", "--bounding-set=-all"]
        done = subprocess.run([*nobody, CLI, "can", "check", "vcan0"], capture_output=True, text=True)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("sudo sysctl -w net.core.rmem_max=4194304", done.stdout)


if __name__ == "__main__":
    unittest.main()
