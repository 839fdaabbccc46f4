"""Runs every command of docs/import.md, in order, and compares what it prints. "…" in the document stands for any text, and
alone on a line for any lines."""

import os
import pathlib
import re
import subprocess
import unittest

from support import CLI, SOURCE, Folder

PAGE = pathlib.Path(SOURCE, "docs/import.md")


def examples():
    """Returns [command, expected output] for each "$ " line of the document."""
    found, inside = [], False
    for line in PAGE.read_text().splitlines():
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


class Commands(Folder):
    def test_every_command_prints_what_the_document_says(self):
        (self.path / "resources").symlink_to(pathlib.Path(SOURCE, "resources"))
        path = f"{pathlib.Path(CLI).parent}:{os.environ['PATH']}"
        commands = examples()
        self.assertGreater(len(commands), 6)
        for command, expected in commands:
            with self.subTest(command):
                done = subprocess.run(["bash", "-c", command], cwd=self.path, capture_output=True, text=True,
                                      timeout=300, check=False, env={**os.environ, "PATH": path})
                # A terminal shows both as they come; here each is one text.
                wanted = re.compile(pattern(expected))
                self.assertTrue(wanted.fullmatch((done.stdout + done.stderr) or "\n")
                                or wanted.fullmatch(done.stderr + done.stdout), done.stdout + done.stderr)

    def test_every_key_of_the_example_is_known(self):
        page = PAGE.read_text()
        block = re.search(r"## The mapping file\n\n((?:    .*\n|\n)+)", page)[1]
        mapping = re.sub(r"(?m)^    ", "", block)
        joints = [f'[{axle}_{side}]\nfield = "a"\n' for axle, side in (("front", "right"), ("rear", "left"), ("rear", "right"))]
        (self.path / "m.toml").write_text(mapping + "".join(joints))
        (self.path / "a.csv").write_text("t,a\n0,1\n")
        done = subprocess.run([CLI, "import", "a.csv", "--mapping", "m.toml", "--check"], cwd=self.path,
                              capture_output=True, text=True, timeout=60, check=False)
        self.assertIn("the file has no such topic", done.stderr)


if __name__ == "__main__":
    unittest.main()
