"""terratact can on a bus of a real kernel, beside candump, cansend, cangen and canplayer.  To be run in tests/kernel/run.sh."""

import pathlib
import subprocess
import sys
import tempfile
import time
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "cli"))
from can_frames import line, telemetry  # noqa: E402
from support import CLI, SOURCE, rows, run  # noqa: E402

EVERYTHING = "vcan0,0:0,#FFFFFFFF"  # error frames, too
# One of every kind that cansend knows.
KINDS = ["044#2A366C2BBA", "12345678#01", "044#R", "044#R4", "12345678#R8", "7FF#", "000#", "044##1AABB",
         "044##011223344556677889900AABB", "20000004#0004000000006000", "20000088#0000080B00000000"]


def ip(*arguments):
    subprocess.run(["ip", "link", *arguments], check=True)


class OnARealBus(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.path = pathlib.Path(self.folder.name)

    def tearDown(self):
        self.folder.cleanup()

    def decoded(self, log):
        """Everything of a log's frames but their times."""
        out = self.path / "out.csv"
        run("can", "decode", log, "--summary", "--csv", out)
        return [{key: value for key, value in row.items() if key != "time_s"} for row in rows(out)]

    def test_all_dialects_of_candump_are_the_same_frames(self):
        forms = {"compact": ["-L"], "long": ["-ta"], "from zero": ["-tz"], "without times": [],
                 "with everything": ["-ta", "-x", "-e", "-a", "-d"]}
        dumps = []
        for name, options in forms.items():
            with open(self.path / name, "w") as out:
                dumps.append(subprocess.Popen(["candump", "-r", "4000000", *options, EVERYTHING], stdout=out))
        time.sleep(0.5)
        for kind in KINDS:
            subprocess.run(["cansend", "vcan0", kind], check=True)
        subprocess.run(["cangen", "vcan0", "-n", "300", "-g", "1", "-I", "r", "-L", "r", "-D", "r", "-m", "-R"], check=True)
        time.sleep(0.5)
        for dump in dumps:
            dump.terminate()
            dump.wait(timeout=10)
        frames = self.decoded(self.path / "compact")
        self.assertEqual(len(frames), len(KINDS) + 300)
        for name in forms:
            self.assertEqual(self.decoded(self.path / name), frames, name)

    def test_a_monitor_shows_what_canplayer_plays(self):
        log = self.path / "demo.log"
        log.write_text("".join(line(1000 + 0.05 * i + 0.0003 * j, content, "can7")
                               for i in range(60) for j, content in enumerate(telemetry(i))))
        player = subprocess.Popen(["canplayer", "-I", log, "vcan0=can7"])
        out = run("can", "monitor", "vcan0", "--seconds", 2.5)
        player.wait(timeout=10)
        last = out[out.rindex("vcan0 works; load "):]
        self.assertRegex(last, r"022 +Attitude +\d\d\.\d +\d\.\d\d  Pitch 0.2100 rad, Roll -0.0500 rad\n")
        self.assertRegex(last, r"ArmResult +\d\d\.\d +\d\.\d\d  not measured")
        self.assertIn("0 dropped", last)
        self.assertNotIn("(", last, "a verdict that is not fine")

    def test_a_monitor_outlives_its_interface(self):
        monitor = subprocess.Popen([CLI, "can", "monitor", "vcan0", "--seconds", "8"], stdout=subprocess.PIPE, text=True)
        time.sleep(1.5)
        ip("delete", "vcan0")
        time.sleep(2)
        ip("add", "dev", "vcan0", "type", "vcan")
        ip("set", "vcan0", "up")
        time.sleep(2.5)
        subprocess.run(["cansend", "vcan0", "123#5A"], check=True)
        out, _ = monitor.communicate(timeout=30)
        self.assertEqual(monitor.returncode, 0)
        self.assertIn("vcan0 works", out[:out.index("vcan0 does not exist")])
        self.assertIn("[1] 5A (unknown identifier)", out[out.index("vcan0 does not exist"):])

    def test_check_tells_absent_from_down_from_usable(self):
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

    def test_check_warns_a_user_whose_receive_buffer_is_small(self):
        nobody = ["setpriv", "--reuid=65534", "--clear-groups", "--inh-caps=-all", "--bounding-set=-all"]
        done = subprocess.run([*nobody, CLI, "can", "check", "vcan0"], capture_output=True, text=True)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("sudo sysctl -w net.core.rmem_max=4194304", done.stdout)


if __name__ == "__main__":
    unittest.main()
