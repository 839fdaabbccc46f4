"""Runs the commands of a page of docs/, in order, and compares what they print. "…" in the document stands for any text, and
alone on a line for any lines."""

import os
import pathlib
import re
import subprocess

from support import CLI, SOURCE, Folder


def examples(page):
    """Returns [command, expected output] for each "$ " line of the document."""
    found, inside = [], False
    for line in page.read_text().splitlines():
        if line.startswith("    $ "):
            found.append([line[6:], ""])
            inside = True
        elif found and inside and (line.startswith("    ") or (not line and found[-1][0].endswith("--probe"))):
            found[-1][1] += line[4:] + "\n"
        else:
            inside = False
    return found


def pattern(expected):
    text = re.escape(expected.rstrip("\n") + "\n")
    text = re.sub(r"(?m)^…\\\n", r"(?:.*\\n)*?", text)
    return text.replace("…", ".+")


class PageCommands(Folder):
    """Test of a page; self.path becomes a folder with resources/, in which the commands run."""

    def run_page(self, name, least):
        (self.path / "resources").symlink_to(pathlib.Path(SOURCE, "resources"))
        path = f"{pathlib.Path(CLI).parent}:{os.environ['PATH']}"
        commands = examples(pathlib.Path(SOURCE, "docs", name))
        self.assertGreaterEqual(len(commands), least)
        for command, expected in commands:
            with self.subTest(command):
                done = subprocess.run(["bash", "-c", command], cwd=self.path, capture_output=True, text=True,
                                      timeout=300, check=False, env={**os.environ, "PATH": path})
                # A terminal shows both as they come; here each is one text.
                wanted = re.compile(pattern(expected))
                self.assertTrue(wanted.fullmatch((done.stdout + done.stderr) or "\n")
                                or wanted.fullmatch(done.stderr + done.stdout), done.stdout + done.stderr)
