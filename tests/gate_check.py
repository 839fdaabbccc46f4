#!/usr/bin/env python3
"""Measures how well the tests cover the command gate and everything that may leave the console.

  gate_check.py coverage            line and branch coverage of gate, arming and E2E; fails below
                                    100 % of lines and 95 % of branches
  gate_check.py mutate [NAME ...]   breaks the sources in one place at a time and runs their tests;
                                    fails on a survivor that is not in EXPECTED below

NAME: command_gate (the default), arming, e2e, can_codec, command_receiver.  Needs g++, gcov and GoogleTest;
takes minutes, so ctest does not run it.  JOBS=n runs n at a time (2).
"""

import concurrent.futures
import json
import os
import pathlib
import re
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parent.parent
GATE = ["core/atem/command_gate", "core/atem/arming", "core/wire/e2e"]
BESIDE = ["core/wire/can_codec", "core/wire/frame_layout", "core/robot/measurement"]

# name: source, its test, what else it links
SUBJECTS = {
    "command_gate": ("core/atem/command_gate", "core/atem/command_gate_test", ["core/wire/e2e", *BESIDE]),
    "arming": ("core/atem/arming", "core/atem/arming_test", []),
    "e2e": ("core/wire/e2e", "core/wire/e2e_test", []),
    "can_codec": ("core/wire/can_codec", "core/wire/can_codec_test",
                  ["core/wire/e2e", "core/wire/frame_layout", "core/robot/measurement", "core/wire/dbc/dbc",
                   "core/wire/dbc/dbc_file", "core/wire/dbc/dbc_messages", "core/wire/dbc/dbc_scanner",
                   "core/wire/dbc/dbc_text", "core/store/file_read", "core/base/text"]),
    "command_receiver": ("core/wire/command_receiver", "core/wire/command_receiver_test",
                         ["core/wire/e2e", *BESIDE]),
}

# Surviving mutants, by subject and text of the line, with the reason that no test can or need kill them.
EXPECTED = {
    ("command_gate", "return value >= least - kSlack && value <= most + kSlack;"):
        "no raw number lies exactly a billionth beside a limit",
}

# Mutations of a piece of text outside comments and quoted texts.
REPLACEMENTS = [
    (r" <= ", [" < ", " >= "]), (r" >= ", [" > ", " <= "]), (r" == ", [" != "]), (r" != ", [" == "]),
    (r"(?<![<]) < ", [" <= ", " > "]), (r" > ", [" >= ", " < "]), (r" && ", [" || "]), (r" \|\| ", [" && "]),
    (r"(?<=[(&|] )!(?=\w)|(?<=\()!(?=\w)|(?<=return )!(?=\w)", [""]),
    (r"(?<=[ (,{])-(?=[\w.]+[,)])", [""]), (r" \+ ", [" - "]), (r" - ", [" + "]),
    (r" & ", [" | "]), (r" \| ", [" & "]), (r" \^ ", [" | "]), (r" << ", [" >> "]), (r" >> ", [" << "]),
    (r"\btrue\b", ["false"]), (r"\bfalse\b", ["true"]),
    (r"\b0\.0\b", ["1.0"]), (r"\b1e-9\b", ["1e-3"]),
    (r"(?<![\w.\[])(0x[0-9A-F]+|[0-9]+)U?(?![\w.])", ["({0} + 1)"]),
    (r" \? ([^:;?]+?) : ([^;?]+?);", [" ? {2} : {1};"]),
    (r"RobotActivity::Halted\b", ["RobotActivity::Driving", "RobotActivity::Pressing"]),
    (r"RobotActivity::Pressed\b", ["RobotActivity::Probing"]),
    (r"RobotActivity::Driving\b", ["RobotActivity::Pressing"]),
    (r"RobotActivity::Stopped\b", ["RobotActivity::Halted"]),
    (r"(?<!case )ArmingPhase::Armed\b", ["ArmingPhase::Requested"]),
    (r"(?<!case )ArmingPhase::Requested\b", ["ArmingPhase::Armed"]),
    (r"LinkState::Good\b", ["LinkState::Stale"]),
    (r"(?<=return )[A-Z]\w+(?=;)", ["None", "Busy"]),
    (r"^\s+if \(.*\) return .*;$", [""]), (r"^\s+if \(.*\)\n\s+return .*;$", [""]),
    (r"^\s+\w+ = [^;\n]+;$", [""]),
]


def tests_of(test):
    """Returns the files of a test: those of the gate are in two files."""
    return [f"tests/{test}"] + (["tests/core/atem/command_gate_frames_test"] if test.endswith("/command_gate_test") else [])


def run(command, **options):
    return subprocess.run(command, capture_output=True, text=True, **options)


def compiled(source, output, flags):
    made = run(["g++", "-std=c++20", f"-I{ROOT}", f'-DTERRATACT_SOURCE_DIR="{ROOT}"', "-c", str(source), "-o",
                str(output), *flags])
    if made.returncode != 0:
        raise RuntimeError(made.stderr)
    return str(output)


def objects(names, folder, flags):
    with concurrent.futures.ThreadPoolExecutor(jobs()) as pool:
        made = [pool.submit(compiled, ROOT / f"{n}.cpp", folder / (n.replace("/", "_") + ".o"), flags)
                for n in names]
        return [m.result() for m in made]


def jobs():
    return int(os.environ.get("JOBS", "2"))


def link(parts, program):
    made = run(["g++", *parts, "-lgtest_main", "-lgtest", "-lfmt", "-pthread", "--coverage", "-o", str(program)])
    if made.returncode != 0:
        raise RuntimeError(made.stderr)


def coverage():
    with tempfile.TemporaryDirectory() as temporary:
        folder = pathlib.Path(temporary)
        tests = [test for n in GATE for test in tests_of(f"{n}_test")]
        parts = objects(GATE, folder, ["-O0", "--coverage"]) + objects(BESIDE + tests, folder, ["-O1"])
        link(parts, folder / "tests")
        if run([str(folder / "tests")], cwd=folder).returncode != 0:
            sys.exit("the tests fail")
        total = [0, 0, 0, 0]
        for name in GATE:
            counts, missed = covered(name, folder)
            total = [a + b for a, b in zip(total, counts)]
            print(f"{name + '.cpp':30} lines {counts[0]}/{counts[1]}  branches {counts[2]}/{counts[3]}")
            for line in missed:
                print(f"    not covered: {line}")
    lines, branches = total[0] / total[1], total[2] / total[3]
    print(f"{'together':30} lines {100 * lines:.1f} %  branches {100 * branches:.1f} %")
    if lines < 1.0 or branches < 0.95:
        sys.exit("below 100 % of lines or 95 % of branches")


def covered(name, folder):
    """Returns [lines run, lines, branches taken, branches] and the uncovered places. Branches of exceptions thrown by
    the standard library do not count."""
    shown = run(["gcov", "-b", "--json-format", "--stdout", str(folder / (name.replace("/", "_") + ".o"))],
                cwd=folder)
    counts, missed = [0, 0, 0, 0], []
    lines = {}
    for file in json.loads(shown.stdout)["files"]:
        if not file["file"].endswith(f"{name}.cpp"):
            continue
        for line in file["lines"]:
            lines.setdefault(line["line_number"], []).append(line)
    source = (ROOT / f"{name}.cpp").read_text().splitlines()
    for number, entries in sorted(lines.items()):
        ran = any(e["count"] > 0 for e in entries)
        branches = [b for e in entries for b in e["branches"] if not b["throw"]]
        taken = sum(b["count"] > 0 for b in branches)
        counts = [counts[0] + ran, counts[1] + 1, counts[2] + taken, counts[3] + len(branches)]
        if not ran or taken < len(branches):
            missed.append(f"{number}: {source[number - 1].strip()} ({taken} of {len(branches)} branches)")
    return counts, missed


def code_only(text):
    """Returns the text with comments, quotes and #includes blanked, at the same length."""
    blank = lambda m: re.sub(r"[^\n]", "\0", m.group())
    return re.sub(r'//[^\n]*|"[^"\n]*"|^#[^\n]*|^constexpr[^\n]*= [0-9];', blank, text, flags=re.M)


def mutants(text):
    code = code_only(text)
    seen = set()
    for pattern, substitutes in REPLACEMENTS:
        for found in re.finditer(pattern, code, flags=re.M):
            if "\0" in found.group() and not pattern.startswith("^"):
                continue
            for substitute in substitutes:
                groups = [found.group(), *found.groups()]
                if "{0}" in substitute:
                    groups[0] = found.group()
                changed = text[:found.start()] + substitute.format(*groups) + text[found.end():]
                if changed != text and changed not in seen:
                    seen.add(changed)
                    yield found.start(), text[found.start():found.end()], substitute.format(*groups), changed


def trial(folder, index, changed, parts, test_name):
    """Returns 'killed', 'survived' or 'no program'."""
    source, output, program = (folder / f"m{index}{e}" for e in (".cpp", ".o", ""))
    source.write_text(changed)
    try:
        link([compiled(source, output, ["-O0"]), *parts], program)
    except RuntimeError:
        return "no program"
    try:
        passed = run([str(program), "--gtest_brief=1"], timeout=120).returncode == 0
    except subprocess.TimeoutExpired:
        passed = False
    for file in (source, output, program):
        file.unlink()
    return "survived" if passed else "killed"


def mutate(name):
    subject, test, beside = SUBJECTS[name]
    text = (ROOT / f"{subject}.cpp").read_text()
    counts = {"killed": 0, "survived": 0, "no program": 0}
    unexpected = []
    with tempfile.TemporaryDirectory() as temporary:
        folder = pathlib.Path(temporary)
        parts = objects([*tests_of(test), *beside], folder, ["-O1"])
        if trial(folder, "sound", text, parts, test) != "survived":
            sys.exit(f"{name}: the tests fail without a mutant")
        with concurrent.futures.ThreadPoolExecutor(jobs()) as pool:
            trials = [(place, old, new, pool.submit(trial, folder, i, changed, parts, test))
                      for i, (place, old, new, changed) in enumerate(mutants(text))]
            for place, old, new, result in trials:
                verdict = result.result()
                counts[verdict] += 1
                if verdict != "survived":
                    continue
                number = text.count("\n", 0, place) + 1 + (old.startswith("\n"))
                line = text.splitlines()[number - 1].strip()
                reason = EXPECTED.get((name, line))
                print(f"  survived: {subject}.cpp:{number}: {line}\n"
                      f"            {old.strip()!r} -> {new.strip()!r}: {reason or 'NOT EXPECTED'}")
                if not reason:
                    unexpected.append(number)
    print(f"{subject}.cpp: {counts['killed']} mutants killed, {counts['survived']} survived "
          f"({counts['no program']} more do not compile)")
    return not unexpected


def main():
    if sys.argv[1:] == ["coverage"]:
        coverage()
    elif sys.argv[1:2] == ["mutate"]:
        verdicts = [mutate(name) for name in sys.argv[2:] or ["command_gate"]]
        sys.exit(0 if all(verdicts) else "a survivor is not expected")
    else:
        sys.exit(__doc__)


main()
