"""Tests terratact-console and terratact robot on one bus of a real kernel: an operator explores, probes and stops.

The operator uses an X server's keys and reacts to the programs' output, never to the clock. Run by tests/kernel/run.sh
on the guest's clock, by which no program is ever late.
"""

import collections
import pathlib
import socket
import struct
import sys
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "cli"))
from can_frames import MESSAGES  # noqa: E402
from support import Running, rows, run  # noqa: E402
from x_operator import HIDDEN, PATIENCE, Operator, begin_console, begin_display  # noqa: E402

CONSOLE = sys.argv.pop()
HEARD = 14  # answers to the console's heartbeats, ten a second; it arms after a second of a good link
WAY = 0.6  # [m] towards the step of the simulated ground; the flippers do not touch it yet
ASKED = ("Stop", "Arm", "BeginAtem", "AbortAtem", "PressFlippers", "ProbeBin")  # frames sent once per request


class Bus:
    """The frames on vcan0: their number by name, and the newest values."""

    def __init__(self):
        self.names = {message.id: name for name, message in MESSAGES.items()
                      if name in (*ASKED, "Odometry", "RobotStatus", "RobotHeartbeat", "ArmResult")}
        self.socket = socket.socket(socket.PF_CAN, socket.SOCK_RAW, socket.CAN_RAW)
        self.socket.setsockopt(socket.SOL_CAN_RAW, socket.CAN_RAW_FILTER,
                               b"".join(struct.pack("=II", number, 0x7FF) for number in self.names))
        self.socket.bind(("vcan0",))
        self.socket.setblocking(False)
        self.count, self.newest = collections.Counter(), {}

    def look(self):
        while True:
            try:
                number, content = struct.unpack("=IxxxxQ", self.socket.recv(16))
            except BlockingIOError:
                return
            name = self.names[number]
            self.count[name] += 1
            self.newest[name] = content

    def value(self, name, signal):
        """Returns a value of the newest frame; None before the first."""
        layout = MESSAGES[name].signals[signal]
        if name not in self.newest:
            return None
        raw = self.newest[name] >> layout.start & (1 << layout.length) - 1
        if layout.signed and raw >> layout.length - 1:
            raw -= 1 << layout.length
        return layout.words.get(raw, raw * layout.scale)


class BusOperator(Operator):
    """An operator who also sees the bus."""

    def __init__(self, hands, session):
        super().__init__(hands, session)
        self.bus = Bus()

    def look(self):
        self.bus.look()

    def armed(self):
        return self.bus.value("RobotStatus", "Armed") == "armed"

    def is_doing(self, activity):
        return self.bus.value("RobotStatus", "Activity") == activity

    def travelled(self):
        return self.bus.value("Odometry", "Travelled")

    def arms(self):
        self.until(lambda: self.bus.count["RobotHeartbeat"] >= HEARD, what="a robot that has heard the console")
        self.presses("m")
        self.holds("m", self.armed, what="armed")

    def drives(self, way):
        self.until(lambda: self.travelled() is not None, what="odometry")
        goal = self.travelled() + way
        self.holds("w", lambda: self.travelled() >= goal, what="the end of the way")
        self.until(lambda: self.is_doing("halted"), what="halted after the drive")

    def explores_and_probes(self):
        before = len(self.phases())

        def came(phase):
            return phase in self.phases()[before:]

        self.presses("a")
        self.until(lambda: came("proposing-probe"), what="a proposal")
        self.holds("space", lambda: self.is_doing("probing with the arm"), what="the arm")
        self.until(lambda: came("presenting"), what="an estimate with the arm")


class Programs(unittest.TestCase):
    def test_an_operator_explores_probes_and_stops(self):
        robot = Running("robot", "--can", "vcan0", "--speed", 4)
        self.addCleanup(robot.end)
        begin_display(self, *HIDDEN, size="1280x800")
        console, session, hands = begin_console(
            self, CONSOLE, "--can", "vcan0", "--transmit", "--size", "1200x680", name="vcan0 — Terratact",
            preferences=["probe-above=0.01"])  # the low threshold always proposes a probe
        operator = BusOperator(hands, session)
        self.addCleanup(operator.bus.socket.close)

        operator.until(lambda: ("link", "up", "") in operator.events(), what="telemetry")
        operator.arms()
        operator.drives(WAY)
        operator.explores_and_probes()
        operator.until(lambda: operator.bus.value("ArmResult", "Measured") == "measured", what="a measured height")
        self.assertIn("approve", operator.decisions())

        self.assertTrue(operator.armed(), "all the while")
        operator.presses("F12")
        robot.until("stopped, disarmed")
        operator.until(lambda: operator.is_doing("stopped"), what="stopped")
        operator.until(lambda: "stopped" in operator.phases(), what="STOPPED on the screen")

        robot.process.kill()
        operator.until(lambda: ("link", "lost") in [event[:2] for event in operator.events()], what="a lost link")
        operator.bus.look()
        console.terminate()
        self.assertEqual(console.wait(timeout=PATIENCE), 0)

        self.assertIn(": holds", run("session", "verify", session))
        log = session.with_suffix(".csv")
        run("session", "export", session, "--out", log, "--what", "frames")
        recorded = collections.Counter(row["id"] for row in rows(log))
        for name in ASKED:
            self.assertEqual(recorded[str(MESSAGES[name].id)], operator.bus.count[name], name)


if __name__ == "__main__":
    unittest.main()
