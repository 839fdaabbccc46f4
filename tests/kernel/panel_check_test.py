"""Tests `terratact panel check` on a gpio-sim chip, inside the kernel of run.sh, which makes the chip."""

import glob
import pathlib
import subprocess
import sys
import tempfile
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).parent.parent / "cli"))
from support import CLI, Running, complaint, run  # noqa: E402

LABEL = "panel"
INPUTS, OUTPUTS = ("atem", "approve", "refuse", "stop"), ("link_lamp", "armed_lamp", "probing_lamp", "buzzer")
LIVE = pathlib.Path("/sys/kernel/config/gpio-sim/panel/live")


def line(name):
    """Returns the path to the outside of a line of the present chip."""
    index = (INPUTS + OUTPUTS).index(name)
    return pathlib.Path(glob.glob(f"/sys/devices/platform/gpio-sim.*/gpiochip*/sim_gpio{index}")[0])


def close(contact, closed=True):
    (line(contact) / "pull").write_text("pull-down" if closed else "pull-up")


def lit(lamp):
    return (line(lamp) / "value").read_text().strip() == "1"


class PanelCheck(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.file = pathlib.Path(self.folder.name) / "panel.toml"
        self.write()
        for contact in INPUTS:
            close(contact, contact == "stop")

    def tearDown(self):
        self.folder.cleanup()

    def write(self, label=LABEL, **names):
        lines = [f'name = "Simulated"\n[chip]\nlabel = "{label}"\n[inputs]\n']
        for n in INPUTS:
            lines.append(f'{n} = {{ line = "{names.get(n, n)}", closes_to = "ground", resistor = "external" }}\n')
        lines.append("[outputs]\n")
        for n in OUTPUTS:
            lines.append(f'{n} = {{ line = "{names.get(n, n)}", lit_when = "high" }}\n')
        self.file.write_text("".join(lines))

    def test_it_shows_what_it_found(self):
        said = run("panel", "check", self.file)
        self.assertIn("[panel], 8 lines, /dev/gpiochip", said)
        self.assertRegex(said, r"input +atem +line 0 +atem +open\n")
        self.assertRegex(said, r"input +stop +line 3 +stop +closed: STOP is released\n")
        self.assertRegex(said, r"output +buzzer +line 7 +buzzer\n")
        close("stop", False)
        self.assertIn("open: STOP is asserted", run("panel", "check", self.file))

    def test_a_button_that_is_held_is_a_failure(self):
        close("refuse")
        self.assertIn("button refuse was held", complaint("panel", "check", self.file))

    def test_what_is_missing_is_named_with_what_there_is(self):
        self.write(label="elsewhere")
        self.assertRegex(complaint("panel", "check", self.file), r"labelled 'elsewhere': there is gpiochip\d+ \[panel\]")
        self.write(stop="halt")
        self.assertIn("no line named 'halt': it has atem, approve,", complaint("panel", "check", self.file))

    def test_each_lamp_is_lit_alone_and_left_dark(self):
        check = Running("panel", "check", self.file, "--lamps")
        for lamp in OUTPUTS:
            check.until(f"lit     {lamp}")
            self.assertEqual([name for name in OUTPUTS if lit(name)], [lamp])
        self.assertEqual(check.wait(), 0)
        self.assertFalse(any(lit(name) for name in OUTPUTS))

    def test_it_prints_what_changes(self):
        watch = Running("panel", "check", self.file, "--watch")
        watch.until("watching")
        close("approve")
        watch.until("approve  closed: pressed")
        close("approve", False)
        watch.until("approve  open")
        close("stop", False)
        watch.until("stop     open: STOP is asserted")
        LIVE.write_text("0")
        self.assertIn("gone", watch.until("the panel is absent"))
        LIVE.write_text("1")
        watch.until("all is well")
        self.assertEqual(watch.end(), 0)

    def test_a_second_program_gets_the_holder_of_the_panel(self):
        watch = Running("panel", "check", self.file, "--watch")
        watch.until("watching")
        self.assertIn("'terratact' holds it", complaint("panel", "check", self.file))
        self.assertEqual(watch.end(), 0)
        run("panel", "check", self.file)

    @unittest.skipUnless(all(folder.stat().st_mode & 0o1 for folder in pathlib.Path(CLI).absolute().parents),
                         "the sources are in a folder that other users may not enter")
    def test_a_user_without_permission_gets_the_remedy(self):
        self.file.chmod(0o644)
        pathlib.Path(self.folder.name).chmod(0o755)
        done = subprocess.run([CLI, "panel", "check", self.file], capture_output=True, text=True, user=65534)
        self.assertEqual(done.returncode, 1)
        self.assertIn("Permission denied", done.stderr)
        self.assertIn("usermod -aG gpio", done.stderr)


if __name__ == "__main__":
    unittest.main()
