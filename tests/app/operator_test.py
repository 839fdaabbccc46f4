"""Tests terratact-console on its simulated robot with an X server's mouse and keys, at font scales of 100 and 200 %.

The operator reacts to what the console records and shows. Explorations are run by tests/kernel/run.sh on the guest's
clock, by which the console is never late.
"""

import os
import pathlib
import subprocess
import sys
import tempfile
import time
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "cli"))
from x_operator import HIDDEN, Operator, Screen, begin, begin_console, begin_display  # noqa: E402

CONSOLE = sys.argv.pop()
APPROVE = 0x5A1490  # colour of the button in widgets/base/palette.h
PROPOSED, STANDS = "proposing-probe", "presenting"


class Console(unittest.TestCase):
    SERVER = ()  # further arguments of the X server

    def begins(self, *arguments, size="1600x1000"):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        begin_display(self, "-fbdir", folder.name, *self.SERVER, size=size)
        self.screen = Screen(folder.name)
        self.console, session, hands = begin_console(
            self, CONSOLE, "--size", size, "--language", "en", *arguments, name="SIMULATED ROBOT — Terratact",
            preferences=["probe-above=0.01", "theme=day"])  # the low threshold always proposes a probe
        self.operator = Operator(hands, session)
        self.operator.until(lambda: any("model" in text for *_, text in self.operator.events("word")), what="a model")

    def ends_well(self):
        self.console.terminate()
        self.assertEqual(self.console.wait(timeout=60), 0)


class Explorations(Console):
    """Of a robot in the console's process."""

    SERVER = HIDDEN

    def begins(self, *arguments, size="1600x1000"):
        super().begins(*arguments, size=size)
        self.operator.until(lambda: ("link", "up", "") in self.operator.events(), what="telemetry")
        time.sleep(1.5)  # of the guest's clock: arming needs a good link for a second

    def came(self, phase, since):
        return phase in self.operator.phases()[since:]

    def is_armed(self):
        arming = self.operator.events("arming")
        return bool(arming) and arming[-1][1] == "armed"

    def arms(self):
        self.operator.presses("m")
        self.operator.holds("m", self.is_armed, what="armed")

    def begins_to_explore(self):
        """Requests an exploration. Returns the number of earlier phases."""
        operator, since = self.operator, len(self.operator.phases())
        if not self.is_armed():
            self.arms()
        operator.presses("a")
        operator.until(lambda: len(operator.phases()) > since, what="an exploration")
        return since

    def at_a_proposal(self, does):
        """Explores until a probe is proposed, then does it."""
        since = self.begins_to_explore()
        self.until(since, lambda: self.came(PROPOSED, since), "a proposal")
        self.until(since, lambda: self.screen.middle_of(APPROVE), "a button to approve")
        does(since)

    def until(self, since, condition, what):
        """Waits for the condition, in an exploration with this number of earlier phases."""
        def ends():
            self.assertFalse(self.came("failed", since), self.operator.events()[-12:])
            return condition()
        self.operator.until(ends, what=what)

    def refuses_after_short_holds(self, since):
        operator = self.operator
        operator.does("keydown space")
        time.sleep(0.4)
        operator.does("keyup space")
        x, y = self.button(since)
        operator.does(f"mousemove {x} {y} mousedown 1")
        time.sleep(0.4)
        operator.does("mouseup 1")
        operator.does(f"mousedown 1 mousemove 5 {y}")
        time.sleep(2.0)
        operator.does("mouseup 1")
        self.assertNotIn("approve", operator.decisions(), "let go early, or elsewhere")
        asked, decided = len(operator.phases()), len(operator.decisions())
        operator.presses("n")
        self.until(since, lambda: "refuse" in operator.decisions()[decided:], "a refusal")
        self.until(since, lambda: self.came(STANDS, asked), "an estimate that is certain without the arm")

    def approves_then_stops(self, since):
        operator = self.operator
        decided = len(operator.decisions())
        x, y = self.button(since)
        operator.does(f"mousemove {x} {y} mousedown 1")
        self.until(since, lambda: "approve" in operator.decisions()[decided:], "an approval by mouse")
        operator.does("mouseup 1")
        operator.presses("F12")
        operator.until(lambda: self.came("stopped", since), what="STOPPED")

    def button(self, since):
        """Returns the middle of the button to approve."""
        self.until(since, lambda: self.screen.middle_of(APPROVE), "a button to approve")
        return self.screen.middle_of(APPROVE)

    def test_mouse_and_keys_answer_a_proposal(self):
        for letters in (100, 200):
            with self.subTest(letters=letters):
                self.begins("--font-scale", str(letters))
                operator = self.operator

                self.at_a_proposal(self.refuses_after_short_holds)
                self.at_a_proposal(self.approves_then_stops)
                operator.presses("ctrl+shift+q")  # a key without meaning
                since = len(operator.phases())
                operator.holds("r", lambda: len(operator.phases()) > since, what="STOP released by a hold")
                self.ends_well()

    def test_proposals_expire_and_explorations_abort(self):
        self.begins()
        operator = self.operator
        self.begins_to_explore()
        operator.presses("Escape")
        operator.until(lambda: operator.events("phase")[-1][1] in ("idle", "failed"), what="the end of it")
        self.at_a_proposal(
            lambda since: self.until(since, lambda: self.came(STANDS, since), "a proposal that expires"))
        self.assertNotIn("approve", operator.decisions())
        self.ends_well()


class Windows(Console):
    def test_colours_change_at_once(self):
        self.begins()

        def blue():
            """Returns the share of blue pixels; the night theme has none."""
            return float(((self.screen.pixels() & 0xFF) > 0x80).mean())

        self.operator.until(lambda: blue() > 0.5, what="day")
        self.operator.presses("ctrl+5")
        self.operator.until(lambda: blue() < 0.01, what="night, in reds alone")
        self.operator.presses("ctrl+4")
        self.operator.until(lambda: blue() > 0.5, what="day again")
        self.ends_well()

    def test_file_refusals_are_shown_in_the_language(self):
        begin_display(self, size="1280x800")
        with tempfile.TemporaryDirectory() as folder:
            broken = pathlib.Path(folder) / "broken.log"
            broken.write_text("nothing that candump has written\n")
            console = begin(self, CONSOLE, "--errors-in-window", "--safe-mode", "--language", "de", broken,
                            stderr=subprocess.PIPE, text=True, env=os.environ | {"QT_QPA_PLATFORM": "xcb"})
            subprocess.run(["xdotool", "search", "--sync", "--onlyvisible", "--name",
                            "Terratact konnte das nicht öffnen", "windowfocus", "--sync"],
                           check=True, timeout=60, stdout=subprocess.DEVNULL)
            subprocess.run(["xdotool", "key", "Escape"], check=True, timeout=60)
            self.assertEqual(console.wait(timeout=60), 1)
            self.assertIn(str(broken), console.stderr.read(), "and to whoever has a terminal")


if __name__ == "__main__":
    unittest.main()
