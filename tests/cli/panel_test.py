"""Tests `terratact panel check` on a computer without an operator's panel."""

import pathlib
import tempfile
import unittest

from support import SOURCE, complaint, run

EXAMPLE = pathlib.Path(SOURCE) / "resources/panels/example.toml"
CHIPS = list(pathlib.Path("/dev").glob("gpiochip*"))


class Panel(unittest.TestCase):
    def test_help_is_printed(self):
        self.assertIn("check", run("panel", "--help"))
        self.assertIn("--watch", run("panel", "check", "--help"))

    def test_wrong_arguments_exit_with_2(self):
        for arguments in (("panel",), ("panel", "check"), ("panel", "check", EXAMPLE, "--seconds", "1"),
                          ("panel", "light", EXAMPLE)):
            self.assertTrue(complaint(*arguments, code=2))

    def test_a_missing_or_bad_file_is_named(self):
        self.assertIn("/nowhere.toml", complaint("panel", "check", "/nowhere.toml"))
        with tempfile.TemporaryDirectory() as folder:
            bad = pathlib.Path(folder) / "bad.toml"
            bad.write_text(EXAMPLE.read_text().replace("stop    =", "halt    ="))
            said = complaint("panel", "check", bad)
            line = EXAMPLE.read_text().splitlines().index("[inputs]") + 1
            self.assertIn(f"bad.toml: line {line}: the key inputs.stop is missing", said)
            self.assertEqual(said.count("\n"), 1, said)

    @unittest.skipIf(CHIPS, "this computer has GPIO chips")
    def test_a_computer_without_gpio_is_reported(self):
        for arguments in ((), ("--lamps",), ("--watch", "--seconds", "1")):
            said = complaint("panel", "check", EXAMPLE, *arguments)
            self.assertIn("no GPIO chip labelled 'pinctrl-bcm2711'", said)
            self.assertIn("this computer has none", said)
            self.assertEqual(said.count("\n"), 1, said)


if __name__ == "__main__":
    unittest.main()
