"""Checks manual pages and bash completion against --help: subcommands, options, choices and defaults must be equal in
both directions. Arguments: programs besides $TERRATACT_CLI, such as the console."""

import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

from support import CLI, SOURCE, fault_names

PROGRAMS = {pathlib.Path(path).name: path for path in [CLI, *sys.argv[1:]]}
sys.argv[1:] = []
COMPLETION = pathlib.Path(SOURCE, "resources/desktop/completion.bash")


def page_of(program):
    return pathlib.Path(SOURCE, f"docs/man/{program}.1")


class Option:
    """An option as in --help: its default, and its choices; "" and () if it has none. CLI11 2.3 writes a default as
    "=1", CLI11 2.4 as " [1] "; " in [1 - 3]" is a range."""

    def __init__(self, head, text):
        self.takes_value = bool(re.match(r"\S+ [A-Z]", head)) and not re.match(r"\S+ (Needs|Excludes):", head)
        head = re.sub(r" (REQUIRED|Needs:.*|Excludes:.*|\.\.\.)", "", head).rstrip()
        choices = re.search(r":\{?([\w-]+(?:[|,][\w-]+)+)\}?", head)
        self.choices = tuple(re.split("[|,]", choices[1])) if choices else ()
        default = re.search(r"=(.*)$|(?<! in) \[([^][]*)\]$", head) or re.search(r"\(default:? ([\w.-]+)", text)
        self.default = next(filter(None, default.groups()), "") if default else ""


def help_of(program, *command):
    """Returns {option: Option} and [subcommand] from the --help of a command."""
    text = subprocess.run([PROGRAMS[program], *command, "--help"], capture_output=True, text=True, timeout=60,
                          check=True).stdout
    # The text begins in column 30, or on the next line after a long head.
    entries = re.findall(r"^  (-.*)\n {30}(.*)$|^  (-.{27})(.*)$", text, re.MULTILINE)
    heads = [(long or short.rstrip(), below or beside) for long, below, short, beside in entries]
    options = {re.search(r"--[\w-]+", head)[0]: Option(head, rest) for head, rest in heads}
    listed = re.search(r"^Subcommands:\n((?:  .*\n)+)", text, re.MULTILINE)
    return options, re.findall(r"^  ([\w-]+)", listed[1], re.MULTILINE) if listed else []


def commands(program, *above):
    """Returns {"model show": {option: Option}} for every command; "" is the program itself."""
    options, below = help_of(program, *above)
    found = {" ".join(above): options}
    for name in below:
        found |= commands(program, *above, name)
    return found


HELP = {program: commands(program) for program in PROGRAMS}


def plain(roff):
    """Removes fonts, escapes and requests from roff."""
    roff = re.sub(r"\\f.", "", roff).replace(r"\-", "-")
    roff = re.sub(r"^\.(B|I|R|BR|BI|RB|RI|IR) (.*)$", lambda m: re.sub(r'"([^"]*)"|(\S+)\s?', r"\1\2", m[2]) if len(m[1]) > 1
                  else m[2], roff, flags=re.MULTILINE)
    return " ".join(roff.split())


def sections(program):
    """Returns {title: {option: paragraph}} of the page, and {title: text before the first option}."""
    options, texts = {}, {}
    for section in re.split(r"^\.S[HS] ", page_of(program).read_text(), flags=re.MULTILINE)[1:]:
        title, _, body = section.partition("\n")
        intro, *paragraphs = re.split(r"^\.TP\n", body, flags=re.MULTILINE)
        texts[title] = intro
        options[title] = {}
        for paragraph in paragraphs:
            head, _, text = paragraph.partition("\n")
            for option in re.findall(r"--[\w-]+", head.replace(r"\-", "-")):
                options[title][option] = f"{head}\n{text}"
    return options, texts


def documented(program, command):
    """Returns {option: paragraph} of a command in the page."""
    options, texts = sections(program)
    found = dict(options[command or "OPTIONS"])
    if "ESTIMATE OPTIONS" in texts.get(command, ""):
        found |= options["ESTIMATE OPTIONS"]
    if command and "--help" in options["OPTIONS"]:
        found["--help"] = ""
    return found


def completed(program, *words):
    """Returns bash's completions of the last word."""
    script = f"""
        . '{COMPLETION}'
        COMP_WORDS=("$@") COMP_CWORD=$(($# - 1))
        _terratact "$1" "${{@: -1}}" "${{@: -2:1}}"
        printf '%s\\n' "${{COMPREPLY[@]}}" """
    done = subprocess.run(["bash", "-c", script, "bash", program, *words], capture_output=True, text=True, timeout=60,
                          check=True)
    assert not done.stderr, done.stderr
    return sorted(done.stdout.split())


class Pages(unittest.TestCase):
    def test_subcommands_are_those_of_the_help(self):
        _, texts = sections("terratact")
        titles = [title for title in texts if title.islower()]
        self.assertEqual(sorted(titles), sorted(command for command in HELP["terratact"] if command))
        self.assertIn("simulate", titles)

    def test_options_are_those_of_the_help(self):
        for program, found in HELP.items():
            for command, options in found.items():
                with self.subTest(program=program, command=command):
                    self.assertEqual(sorted(documented(program, command)), sorted(options))
                    self.assertIn("--help", options)

    def test_defaults_and_choices_are_those_of_the_help(self):
        seen = 0
        for program, found in HELP.items():
            for command, options in found.items():
                for name, option in options.items():
                    said = plain(documented(program, command)[name])
                    with self.subTest(program=program, command=command, option=name):
                        for choice in option.choices:
                            if name not in ("--method", "--methods"):
                                self.assertRegex(said, rf"\b{choice}\b")
                        if option.default:
                            seen += 1
                            self.assertRegex(said, rf"default {re.escape(option.default)}(?![\w])")
        self.assertGreater(seen, 50 if "terratact" in HELP else 3)

    def test_the_methods_are_those_of_the_help(self):
        options = plain(page_of("terratact").read_text().split(".SH METHODS")[1].split(".SH ")[0])
        for method in HELP["terratact"]["demo"]["--method"].choices:
            self.assertRegex(options, rf"\b{method}\b")

    def test_the_version_is_the_programs(self):
        for program, path in PROGRAMS.items():
            version = subprocess.run([path, "--version"], capture_output=True, text=True, timeout=60,
                                     check=True).stdout.split()[1]
            self.assertIn(f'"Terratact {version}"', page_of(program).read_text().splitlines()[1])

    def test_the_pages_have_their_parts(self):
        for program in PROGRAMS:
            options, _ = sections(program)
            self.assertLessEqual({"NAME", "SYNOPSIS", "EXIT STATUS", "ENVIRONMENT", "FILES", "EXAMPLES"}, set(options))

    @unittest.skipUnless(shutil.which("groff") and shutil.which("man"), "groff or man is not installed")
    def test_the_pages_render_without_a_warning(self):
        for program in PROGRAMS:
            for command in (["groff", "-man", "-Tutf8", "-ww"], ["man", "--warnings", "-l"]):
                done = subprocess.run([*command, page_of(program)], capture_output=True, text=True, timeout=60,
                                      env={**os.environ, "LC_ALL": "C.UTF-8", "MANWIDTH": "100"}, check=False)
                self.assertEqual((done.returncode, done.stderr), (0, ""))
                self.assertIn("SYNOPSIS", re.sub("\x1b\\[\\d*m|.\b", "", done.stdout))


class Completion(unittest.TestCase):
    def test_subcommands_are_those_of_the_help(self):
        for command in HELP["terratact"]:
            below = [other.split()[-1] for other in HELP["terratact"]
                     if other.rpartition(" ")[0] == command and other != command]
            if below:
                self.assertEqual(completed("terratact", *command.split(), ""), sorted(below))
        self.assertEqual(completed("terratact", "si"), ["simulate"])

    def test_options_are_those_of_the_help(self):
        for program, found in HELP.items():
            for command, options in found.items():
                with self.subTest(program=program, command=command):
                    self.assertEqual(completed(program, *command.split(), "--"), sorted(options))

    def test_values_equal_the_help_and_flags_take_none(self):
        choices = flags = 0
        for program, found in HELP.items():
            for command, options in found.items():
                for name, option in options.items():
                    with self.subTest(program=program, command=command, option=name):
                        if option.choices:
                            choices += 1
                            for typed in (("",), ("=", "")):
                                proposed = completed(program, *command.split(), name, *typed)
                                begun = [word for word in proposed if word.endswith(":")]  # KIND:SENSORS
                                self.assertEqual([w for w in proposed if w not in begun], sorted(option.choices))
                        after = completed(program, *command.split(), name, "--")
                        flags += not option.takes_value
                        self.assertEqual(after, [] if option.takes_value else sorted(options))
        self.assertGreater(flags, 2)
        self.assertGreater(choices, 20 if "terratact" in HELP else -1)

    def test_a_list_goes_on_after_its_comma(self):
        self.assertEqual(completed("terratact", "evaluate", "--methods", "pa,jo"), ["pa,joint"])

    def test_faults_are_those_that_the_program_reads(self):
        kinds, sensors = fault_names()
        page = plain(page_of("terratact").read_text().split(".SH FAULTS")[1].split(".SH ")[0])
        for word in kinds + [sensor for sensor in sensors if not re.match(r"(left-|right-)?force-\d", sensor)]:
            self.assertRegex(page, rf"\b{word}\b")
        for option in (("robot", "--fault"), ("simulate", "--disturb")):
            proposed = completed("terratact", *option, "")
            self.assertLessEqual({f"{kind}:" for kind in kinds}, set(proposed))
            self.assertIn("none", proposed)
            self.assertEqual(completed("terratact", *option, "stuck", ":", ""), sorted(sensors))
            self.assertEqual(completed("terratact", *option, "stuck", ":", "pi"), ["pitch"])
            self.assertEqual(completed("terratact", *option, "stuck:pi"), ["stuck:pitch"])
            can_be_lost = sorted(s for s in sensors if re.search("current|force|odometry|all", s))
            self.assertEqual(completed("terratact", *option, "lost", ":", ""), can_be_lost)
            self.assertEqual(completed("terratact", *option, "lost:pi"), [])

    def test_files_are_those_that_fit(self):
        with tempfile.TemporaryDirectory() as folder:
            for name in ("a.ttm", "a.csv", "a.toml", "a.log", "a b.log", "a.ttp"):
                pathlib.Path(folder, name).touch()
            pathlib.Path(folder, "below").mkdir()
            start = f"{folder}/"
            fitting = {"a.ttm": [("demo", "--model"), ("model", "show")], "a.csv": [("train", "--data")],
                       "a.toml": [("demo", "--robot"), ("panel", "check")], "a.ttp": [("merge",)]}
            for name, cases in fitting.items():
                for words in cases:
                    self.assertEqual(completed("terratact", *words, start), [f"{start}{name}", f"{start}below"])
            self.assertEqual(completed("terratact", "session", "list", start), [f"{start}below"])
            logs = completed("terratact", "can", "decode", f"{start}a")
            self.assertEqual(logs, sorted(f"{start}a b.log".split() + [f"{start}a.csv", f"{start}a.log"]))
            if "terratact-console" in PROGRAMS:
                self.assertIn(f"{start}a.log", completed("terratact-console", start))


if __name__ == "__main__":
    unittest.main()
