"""Makes frames of our protocol from resources/dbc/terratact.dbc, independently of the product's code."""

import pathlib
import re

from support import SOURCE

DBC = pathlib.Path(SOURCE) / "resources/dbc/terratact.dbc"


class Signal:
    def __init__(self, match):
        self.name, self.unit = match[1], match[9]
        self.start, self.length, self.signed = int(match[2]), int(match[3]), match[4] == "-"
        self.scale, self.least, self.most = float(match[5]), float(match[7]), float(match[8])
        self.words = {}


class Message:
    def __init__(self, number, name, sender):
        self.id, self.name, self.sender = int(number), name, sender
        self.signals, self.comment, self.data_id, self.cycle_ms = {}, "", 0, 0


def messages():
    """Returns the DBC's messages by name."""
    found, text = {}, DBC.read_text()
    for line in text.splitlines():
        if match := re.match(r"BO_ (\d+) (\w+): 8 (\w+)", line):
            message = Message(*match.groups())
            found[message.id] = message
        elif match := re.match(
                r' SG_ (\w+) : (\d+)\|(\d+)@1([+-]) \(([^,]+),([^)]+)\) \[([^|]+)\|([^\]]+)\] "([^"]*)"', line):
            message.signals[match[1]] = Signal(match)
        elif match := re.match(r'BA_ "E2eDataId" BO_ (\d+) (\d+);', line):
            found[int(match[1])].data_id = int(match[2])
        elif match := re.match(r'BA_ "GenMsgCycleTime" BO_ (\d+) (\d+);', line):
            found[int(match[1])].cycle_ms = int(match[2])
        elif match := re.match(r'CM_ BO_ (\d+) "(.*)";', line):
            found[int(match[1])].comment = match[2]
        elif match := re.match(r"VAL_ (\d+) (\w+) (.*) ;", line):
            words = {int(raw): word for raw, word in re.findall(r'(\d+) "([^"]*)"', match[3])}
            found[int(match[1])].signals[match[2]].words = words
    return {message.name: message for message in found.values()}


MESSAGES = messages()


def crc16(data):
    crc = 0xFFFF
    for byte in data:
        crc ^= byte << 8
        for _ in range(8):
            crc = (crc << 1 ^ 0x1021 if crc & 0x8000 else crc << 1) & 0xFFFF
    return crc


def frame(name, counter, **values):
    """Returns (identifier, eight bytes) with counter and checksum of AUTOSAR E2E Profile 5."""
    message = MESSAGES[name]
    word = (counter & 0xFF) << 16
    for signal, value in values.items():
        layout = message.signals[signal]
        word |= (round(value / layout.scale) & (1 << layout.length) - 1) << layout.start
    data = bytearray(word.to_bytes(8, "little"))
    data[0:2] = crc16(bytes(data[2:]) + message.data_id.to_bytes(2, "little")).to_bytes(2, "little")
    return message.id, bytes(data)


def line(time, content, interface="can0"):
    """Returns a line in the format of candump -L; an identifier beyond 11 bits is extended (29 bits)."""
    identifier = f"{content[0]:03X}" if content[0] < 0x800 else f"{content[0]:08X}"
    return f"({time:017.6f}) {interface} {identifier}#{content[1].hex().upper()}\n"


def telemetry(counter, pitch=0.21, **status):
    """Returns all frames that a robot sends every 50 ms. status: values of RobotStatus."""
    status = {"Epoch": 7, "Activity": 3, "Refusal": 2, "Armed": 1, "LastCommand": 23, "LastCounter": 4} | status
    pair = {"Left": -0.3, "Right": -0.31, "Measured": 1}
    current = {"Left": 1.6, "Right": 1.7, "Measured": 1}
    low = {"Element1": 0.5, "Element2": 1.0, "Element3": 1.5, "Measured": 1}
    high = {"Element4": 0.5, "Element5": 1.0, "Element6": 1.5, "Measured": 1}
    return [frame("RobotStatus", counter, **status),
            frame("Attitude", counter, Pitch=pitch, Roll=-0.05, Measured=1),
            frame("FrontAngles", counter, **pair), frame("RearAngles", counter, **pair),
            frame("FrontCurrents", counter, **current), frame("RearCurrents", counter, **current),
            frame("LeftForces1To3", counter, **low), frame("LeftForces4To6", counter, **high),
            frame("RightForces1To3", counter, **low), frame("RightForces4To6", counter, **high),
            frame("ArmResult", counter)]
