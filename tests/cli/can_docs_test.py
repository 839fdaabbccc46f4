"""Checks docs/can.md against the DBC and the program. The frame table is generated from the DBC, and examples show the
real output. --write updates the document and the logs beside it."""

import pathlib
import re
import struct
import subprocess
import sys
import unittest

from can_frames import MESSAGES, frame, line, telemetry
from support import CLI, SOURCE

DOCS = pathlib.Path(SOURCE) / "docs"
PAGE = DOCS / "can.md"
BEGIN, END = "<!-- from the DBC -->\n", "<!-- end -->\n"


def number(value):
    return f"{value:.10g}"


def content(message):
    parts = []
    for signal in message.signals.values():
        if signal.name in ("Crc", "Counter", "Measured"):
            continue
        if signal.length == 1:
            parts.append(signal.name)
        elif signal.words:
            parts.append(f"{signal.name} ({', '.join(f'{raw} {word}' for raw, word in signal.words.items())})")
        else:
            parts.append(f"{signal.name} {number(signal.least)} … {number(signal.most)} {signal.unit}".rstrip())
    return ", ".join(parts)


def table():
    text = "| id | frame | from | every | content | meaning |\n| --- | --- | --- | --- | --- | --- |\n"
    for message in MESSAGES.values():
        every = f"{message.cycle_ms} ms" if message.cycle_ms else ""
        text += (f"| {message.id:03X} | {message.name} | {message.sender.lower()} | {every} | {content(message)} "
                 f"| {message.comment} |\n")
    return text


def demo_log():
    """Returns a third of a second of traffic: telemetry, heartbeats, an obeyed press, a damaged frame, a stop."""
    begin = 1767225600
    statuses = [{"Activity": 0, "LastCommand": 18, "LastCounter": 0}] + 4 * [{"Activity": 2, "LastCounter": 0}]
    statuses += [{"Activity": 3, "LastCounter": 0}, {"Activity": 5, "Armed": 0, "Epoch": 8, "LastCommand": 16, "LastCounter": 0}]
    frames = []
    for i, status in enumerate(statuses):
        for j, sent in enumerate(telemetry(i, pitch=0.0521 + 0.0013 * i, Refusal=0, **status)):
            if (i, j) == (3, 1):  # an Attitude frame with one flipped bit
                sent = (sent[0], sent[1][:5] + bytes([sent[1][5] ^ 4]) + sent[1][6:])
            frames.append((begin + 0.05 * i + 0.0003 * j, sent))
        if i % 2 == 0:
            token = 9301 * (i + 1) % 65536
            frames.append((begin + 0.05 * i + 0.02, frame("ConsoleHeartbeat", i // 2, Token=token)))
            frames.append((begin + 0.05 * i + 0.021, frame("RobotHeartbeat", i // 2, Token=token, Challenge=311 + i // 2)))
    frames.append((begin + 0.03, frame("PressFlippers", 0, Epoch=7, Torque=34, Challenge=311)))
    frames.append((begin + 0.28, frame("Stop", 0)))
    return "".join(line(time, sent) for time, sent in sorted(frames))


def absolem_log():
    """Returns the requests of the robot's computer in one loop, and the answers of the flippers' drives."""
    text, time = "", 1767225600.0

    def ask(node, letters, value, float_bit=0):
        nonlocal text, time
        text += line(time, (0x300 + node, letters.lower().encode() + b"\0\x40"))
        text += line(time + 0.0004, (0x280 + node, letters.encode() + bytes([0, float_bit]) + value))
        time = round(time + 0.001, 6)

    for node, counts in ((7, 573), (4, -573), (5, -1500), (2, 1500)):
        ask(node, "PX", struct.pack("<i", counts))
        ask(node, "IQ", struct.pack("<f", -1.25 if node == 7 else 1.25 if node == 4 else 0.0), 0x80)
    ask(7, "SR", struct.pack("<I", 0x2292))
    ask(7, "MF", struct.pack("<I", 0))
    return text


def payload_log():
    """Returns frames of a gas sensor and a battery on the robot's bus, as described by docs/can_payload.dbc."""
    begin, battery, text = 1767225600, 0x18FED101, ""
    for i in range(2):
        now = begin + 0.1 * i
        air = struct.pack(">HBHB", 235 + 8 * i, 207 - i, (-35 & 0xFFF) << 4, 1)
        text += line(now, (0x500, air))
        text += line(now + 0.001, telemetry(i)[1])
        text += line(now + 0.01, (battery, struct.pack("<BBHxxxx", 0, 171, 25187)))
        text += line(now + 0.02, (battery, struct.pack("<Bxxxf", 1, 187.5)))
    return text + line(begin + 0.2, (0x501, b"\x01\x02"))


LOGS = {"can_demo.log": demo_log, "can_absolem.log": absolem_log, "can_payload.log": payload_log}


def printed(command):
    """Returns the output of a command in the document, with the document's indentation."""
    done = subprocess.run(command.replace("terratact", f"'{CLI}'", 1), shell=True, capture_output=True, text=True, cwd=DOCS,
                          timeout=60)
    assert done.returncode == 0, done.stderr
    return "".join(f"    {text}".rstrip() + "\n" for text in done.stdout.strip("\n").splitlines())


def blocks(page):
    """Returns (command, whole block) of every example that runs on any machine."""
    for match in re.finditer(r"    \$ (terratact can (?:decode|monitor).*)\n((?:    .*\n|\n(?=    ))*)", page):
        yield match[1], match[0]


def without_times(text):
    """Replaces rates, ages and load of a monitor, which depend on the machine."""
    return re.sub(r" *\d+\.\d+", " N", text)


def last_table(block):
    """Returns the command and the last table of a monitor. A busy machine prints more than one."""
    command, tables = block.split("\n", 1)
    return command + "\n" + tables[tables.rindex("    REPLAY "):]


def rewritten(page):
    for command, block in list(blocks(page)):
        page = page.replace(block, f"    $ {command}\n{printed(command)}")
    begin, end = page.index(BEGIN) + len(BEGIN), page.index(END)
    return page[:begin] + table() + page[end:]


class Page(unittest.TestCase):
    def test_the_table_is_the_dbc(self):
        page = PAGE.read_text()
        self.assertEqual(page[page.index(BEGIN) + len(BEGIN):page.index(END)], table())
        self.assertEqual(table().count("\n"), 2 + 30)

    def test_the_logs_are_those_of_this_file(self):
        for name, make in LOGS.items():
            self.assertEqual((DOCS / name).read_text(), make())

    def test_the_examples_print_what_they_show(self):
        found = list(blocks(PAGE.read_text()))
        self.assertGreaterEqual(len(found), 3)
        for command, block in found:
            shown, now = block, f"    $ {command}\n{printed(command)}"
            if "monitor" in command:
                shown, now = without_times(shown), without_times(last_table(now))
            self.assertEqual(shown.rstrip("\n"), now.rstrip("\n"))


if __name__ == "__main__":
    if "--write" in sys.argv:
        for log, make in LOGS.items():
            (DOCS / log).write_text(make())
        PAGE.write_text(rewritten(PAGE.read_text()))
    else:
        unittest.main()
