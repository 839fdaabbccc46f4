#!/usr/bin/python3
"""Prints the table of docs/operator_tasks.md: what a scripted operator needs for each task.

Usage: docs/operator_tasks.py build/release/app/terratact-console [--before CONSOLE] [--task PART OF A TASK'S NAME]
It uses an X server, mouse and keys as tests/app/operator_test.py does, with the simulated robot. Each letter that is typed
counts as a key. With --before, an older build of the console does the same tasks, and the table has its columns, too.
"""

import argparse
import pathlib
import shutil
import subprocess
import sys
import tempfile
import time
import unittest

ROOT = pathlib.Path(__file__).resolve().parent.parent
sys.path.insert(0, str(ROOT / "tests" / "cli"))
from x_operator import Operator, begin_console, begin_display  # noqa: E402

PATIENCE = 60  # [s]
SETTLING = 0.5  # [s] until a window that has appeared takes keys
LINK_GOOD = 1.5  # [s] arming needs a link that was good for a second
SESSION = ROOT / "resources" / "sessions" / "demo.tts"


class Counted(Operator):
    """An operator whose key presses and clicks are counted."""

    keys = clicks = 0

    def does(self, text):
        words = text.split()
        if words[0] == "type":
            self.keys += len(words[1])
        self.keys += sum(word in ("key", "keydown") for word in words)
        self.clicks += sum(word in ("click", "mousedown") for word in words)
        super().does(text)


class Tasks(unittest.TestCase):
    console = None

    def runTest(self):
        """Nothing: the table is printed by main()."""

    def begins(self, *arguments):
        begin_display(self, size="1600x1000")
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.process, session, hands = begin_console(
            self, self.console, "--size", "1600x1000", "--language", "en", *arguments, name="SIMULATED ROBOT",
            preferences=["probe-above=0.01", "theme=day"])
        self.operator = Counted(hands, session)
        self.until(lambda: any("model" in text for *_, text in self.operator.events("word")))
        time.sleep(LINK_GOOD)

    def until(self, condition, seconds=PATIENCE):
        return self.operator.until(condition, seconds)

    def phase(self, name):
        return name in self.operator.phases()

    def armed(self):
        arming = self.operator.events("arming")
        return bool(arming) and arming[-1][1] == "armed"

    def arm(self):
        self.operator.presses("m")
        return self.operator.holds("m", self.armed, PATIENCE)

    def window(self, name, seconds=PATIENCE):
        found = subprocess.run(["timeout", str(seconds), "xdotool", "search", "--sync", "--onlyvisible", "--name", name],
                               stdout=subprocess.DEVNULL, check=False)
        return found.returncode == 0

    # Tasks: each returns whether it was done.
    def first_verdict(self):
        since = len(self.operator.phases())
        while len(self.operator.phases()) == since:  # a busy machine may disarm again
            if not self.armed():
                self.arm()
            self.operator.presses("a")
            self.until(lambda: len(self.operator.phases()) > since, 2)
        return self.until(lambda: self.phase("proposing-probe") or self.phase("presenting"))

    def probe(self):
        self.operator.presses("b") if not self.phase("proposing-probe") else None
        return self.until(lambda: self.phase("proposing-probe")) and self.operator.holds(
            "space", lambda: "approve" in self.operator.decisions(), PATIENCE)

    def stop(self):
        self.operator.presses("F12")
        return self.until(lambda: self.phase("stopped"))

    def step_limit(self):
        self.operator.presses("Prior")
        return self.until(lambda: any(s == "settings" and "obstacle-limit" in t
                                      for _, s, t in self.operator.events("decision")), 10)

    def open_recording(self):
        self.operator.presses("ctrl+o")
        if not self.window("^(Recordings|Open)", 15):
            return False
        time.sleep(SETTLING)
        if subprocess.run(["xdotool", "search", "--name", "^Recordings"], stdout=subprocess.DEVNULL, check=False).returncode:
            return self.open_by_dialog()
        for key in ("Down", "Return"):  # the newest, which is being recorded, is chosen already
            self.operator.presses(key)
        return self.window("REVIEW")

    def open_by_dialog(self):
        """Older consoles ask for a file. A desktop would give their dialog the focus."""
        subprocess.run(["xdotool", "search", "--onlyvisible", "--name", "^Open", "windowfocus", "--sync"], check=False)
        self.operator.does("type demo.tts")
        self.operator.presses("Return")
        return self.window("REVIEW")

    def with_demo(self):
        shutil.copy(SESSION, pathlib.Path(self.operator.session).parent / "demo.tts")

    def snapshot(self):
        self.operator.presses("c")
        if not self.window("^Note on the snapshot", 15):
            return False
        self.operator.does("type step")
        self.operator.presses("Return")
        return self.until(lambda: any(s == "snapshot note" for _, s, _ in self.operator.events("marker")), 15)

    def look_back(self):
        self.operator.presses("ctrl+h")
        if not self.window("^Estimates of this run", 15):
            return False
        time.sleep(SETTLING)
        for key in ("Down", "Down", "Return"):
            self.operator.presses(key)
        return self.until(lambda: any("not the present one" in text for *_, text in self.operator.events("word")), 10)

    def profile(self):
        folder = pathlib.Path(self.operator.session).parent.parent / "terratact" / "profiles"
        folder.mkdir()
        (folder / "night.settings").write_text("terratact-settings = 1\nobstacle-limit = 0.2 m\n")
        self.operator.presses("ctrl+comma")
        if not self.window("^Profiles", 15):
            return False
        time.sleep(SETTLING)
        for key in ("Down", "Return", "Tab", "space"):
            self.operator.presses(key)
        return self.until(lambda: any("obstacle-limit: 0.1 → 0.2" in text for *_, text in self.operator.events()), 10)

    def connection(self):
        self.operator.presses("ctrl+l")
        if not self.window("^Connect", 15):
            return False
        time.sleep(SETTLING)
        self.operator.presses("Return")
        sessions = pathlib.Path(self.operator.session).parent
        return self.until(lambda: len(list(sessions.glob("*.tts"))) > 1, 20)


def first(tasks):
    tasks.first_verdict()


def twice(tasks):
    tasks.first_verdict()
    if tasks.phase("proposing-probe"):
        tasks.operator.presses("n")
        tasks.until(lambda: tasks.operator.phases()[-1] == "presenting")
    tasks.first_verdict()


TASKS = [  # name, what is done before and not counted, the task
    ("first verdict, from a disarmed robot", None, Tasks.first_verdict),
    ("approve a proposed probe", first, Tasks.probe),
    ("STOP", lambda tasks: tasks.arm(), Tasks.stop),
    ("change the step limit", None, Tasks.step_limit),
    ("open a recording", Tasks.with_demo, Tasks.open_recording),
    ("take a picture of the moment, with a note", None, Tasks.snapshot),
    ("look at the estimate before this one", twice, Tasks.look_back),
    ("switch to a profile of settings", None, Tasks.profile),
    ("connect to another robot", None, Tasks.connection),
]


def measured(console, before, task):
    """Returns (keys, clicks, seconds) as text."""
    Tasks.console = console
    tasks = Tasks()
    try:
        tasks.begins()
        if before:
            before(tasks)
        tasks.operator.keys = tasks.operator.clicks = 0
        begin = time.monotonic()
        done = task(tasks)
        seconds = time.monotonic() - begin
        if not done:
            return "not possible", "", ""
        return str(tasks.operator.keys), str(tasks.operator.clicks), f"{seconds:.1f}"
    finally:
        tasks.doCleanups()


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("console")
    parser.add_argument("--before")
    parser.add_argument("--task", default="")
    options = parser.parse_args()
    columns = [(options.before, "before: "), (options.console, "now: ")] if options.before else [(options.console, "")]
    names = ["task"] + [word + name for _, word in columns for name in ("keys", "clicks", "time [s]")]
    print("| " + " | ".join(names) + " |\n|" + " --- |" * len(names))
    for name, before, task in TASKS:
        if options.task not in name:
            continue
        cells = [cell for console, _ in columns for cell in measured(str(pathlib.Path(console).resolve()), before, task)]
        print(f"| {name} | " + " | ".join(cells) + " |", flush=True)


if __name__ == "__main__":
    main()
