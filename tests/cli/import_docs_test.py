"""Runs every command of docs/import.md, and reads its example of a mapping file."""

import pathlib
import re
import subprocess
import unittest

from docs_support import PageCommands
from support import CLI, SOURCE

PAGE = pathlib.Path(SOURCE, "docs/import.md")


class Commands(PageCommands):
    def test_every_command_prints_what_the_document_says(self):
        self.run_page("import.md", 8)

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
