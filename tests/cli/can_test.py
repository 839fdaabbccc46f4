"""Tests `terratact can` without CAN hardware: logs made from the DBC by independent code, monitor and check."""

import gzip
import pathlib
import re
import struct
import subprocess
import tempfile
import unittest

from can_frames import MESSAGES, frame, line, telemetry
from support import CLI, complaint, rows, run

BEGIN = 1436509052.249713
FLAGS = {"Measured": 1, "LeftMissing": 0, "RightMissing": 0}  # of a frame whose values were all measured


def session(lines=40, missing=()):
    """Returns a log of telemetry at 20 Hz, without the numbered lines in `missing`."""
    text = ""
    for i in range(lines):
        if i not in missing:
            text += "".join(line(BEGIN + 0.05 * i + 0.0003 * j, content) for j, content in enumerate(telemetry(i)))
    return text


def elmo(time, identifier, letters, index=0, type_byte=0x40, value=None):
    """Returns a frame of an Absolem's bus."""
    data = letters.encode() + bytes([index, type_byte]) + (value if value is not None else b"")
    return line(time, (identifier, data))


class Logs(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.path = pathlib.Path(self.folder.name)
        self.log, self.csv = self.path / "demo.log", self.path / "out.csv"

    def tearDown(self):
        self.folder.cleanup()

    def decode(self, text, *arguments):
        self.log.write_text(text)
        return run("can", "decode", self.log, *arguments)

    def values(self, text, *arguments):
        """Returns the rows of the CSV."""
        self.decode(text, "--csv", self.csv, "--summary", *arguments)
        return rows(self.csv)

    def totals(self, text):
        """Returns wrong checksums, out of sequence, gaps, other faults, unknown frames, unknown kinds."""
        found = re.search(r"frames(?: in .*)?: (\d+) with .*, (\d+) out of .*, (\d+) gaps, (\d+) otherwise .*; "
                          r"(\d+) frames of (\d+) unknown", text)
        return tuple(map(int, found.groups()))


class Decode(Logs):
    def test_every_signal_of_the_dbc_at_both_ends(self):
        text, expected = "", []
        for message in MESSAGES.values():
            for counter, end in ((1, "least"), (2, "most")):
                signals = {name: s for name, s in message.signals.items() if name not in ("Crc", "Counter")}
                values = {name: getattr(signal, end) for name, signal in signals.items()}
                if message.name == "ArmResult":  # a reading is never exact
                    values["Sd"] = max(values["Sd"], signals["Sd"].scale)
                values |= {name: value for name, value in FLAGS.items() if name in values}
                text += line(BEGIN + len(expected) * 1e-3, frame(message.name, counter, **values))
                expected += [(message, signals[name], value) for name, value in values.items() if name not in FLAGS]
        got = [row for row in self.values(text) if row["signal"]]
        self.assertEqual(len(got), len(expected))
        for row, (message, signal, value) in zip(got, expected):
            self.assertEqual((row["frame"], row["id"]), (message.name, f"{message.id:03X}"))
            self.assertEqual((row["signal"], row["unit"], row["verdict"]), (signal.name, signal.unit, "ok"))
            raw = round(value / signal.scale)
            if signal.name in ("Activity", "Refusal"):
                self.assertEqual(row["value"], signal.words[raw])
            elif signal.name == "LastCommand":
                self.assertEqual(row["value"], {0: "none", 26: "Advance"}[raw])
            elif signal.length == 1:
                self.assertEqual(row["value"], "yes" if raw else "no")
            else:
                self.assertAlmostEqual(float(row["value"]), value, delta=0.51 * signal.scale)

    def test_a_missing_current_has_no_value(self):
        text = ""
        for i, missing in enumerate(({}, {"LeftMissing": 1}, {"LeftMissing": 1, "RightMissing": 1})):
            values = {"Left": 0, "Right": 1.7, "Measured": 1} | missing
            text += line(BEGIN + 0.05 * i, frame("FrontCurrents", i, **values))
        out = self.decode(text)
        self.assertIn("#000  ok; Left 0.000 A, Right 1.700 A\n", out)
        self.assertIn("#001  ok; Right 1.700 A, LeftMissing yes\n", out)
        self.assertIn("#002  ok; LeftMissing yes, RightMissing yes\n", out)

    def test_a_sound_session_has_nothing_wrong(self):
        text = self.decode(session())
        self.assertIn("#039  ok; Pitch 0.2100 rad, Roll -0.0500 rad", text)
        self.assertIn("Activity front flippers pressed to the ground, Refusal the robot is busy, Armed yes", text)
        self.assertIn("ArmResult                  #000  ok; not measured", text)
        self.assertIn("times are since 1436509052.249713 s", text)
        self.assertEqual(self.totals(text), (0,) * 6)
        self.assertRegex(text, r"022 +Attitude +40 +20.0 +0.050 +0 +0 +0 +0\n")
        self.assertEqual(len(self.decode(session(), "--summary").splitlines()), 15)

    def test_faults_are_named_and_counted(self):
        whole = telemetry(40)
        number, data = whole[1]
        late = BEGIN + 2.0
        text = session()
        text += line(late, (number, data[:4] + bytes([data[4] ^ 1]) + data[5:]))  # a flipped bit
        text += line(late, (number, data[:7]))
        text += line(late, telemetry(39)[1])  # repeated
        text += line(late, telemetry(20)[1])  # old
        text += line(late, frame("Drive", 1, Epoch=7, Speed=0.7))  # too fast
        text += line(late, (0x123, b"\x01\x02"))
        text += f"({late:.6f}) can0 00000022#{data.hex()}\n({late:.6f}) can0 022#R8\n"
        text += f"({late:.6f}) can0 20000004#0001000000000000\n"
        stop = frame("Stop", 1)
        text += line(late, (stop[0], b"\0" + stop[1][1:]))
        out = self.decode(text)
        for words in ("Attitude                   -     wrong checksum; [8]", "not eight bytes; [7]",
                      "#039  repeated; Pitch", "#020  out of sequence; Pitch",
                      "Drive                      -     a value is beyond its range", "unknown identifier; [2] 01 02",
                      "00000022  unknown                    -     extended frame", "     remote frame", "022 remote unknown",
                      "error frame                -     controller: ", "wrong checksum; a robot still stops"):
            self.assertIn(words, out)
        self.assertEqual(self.totals(out), (2, 2, 0, 3, 3, 3))

    def test_missing_frames_are_a_gap(self):
        self.assertEqual(self.totals(self.decode(session(missing=(10,)))), (0, 0, 11, 0, 0, 0))
        out = self.decode(session(missing=range(10, 20)))
        self.assertEqual(self.totals(out), (0, 0, 11, 0, 0, 0))
        self.assertIn("ok after 0.550 s of silence", out)
        self.assertRegex(out, r"Attitude +30 +[0-9.]+ +0.550 ")

    def test_interfaces_are_separated(self):
        both = session(4) + session(4).replace("can0", "can1")
        out = self.decode(both)
        self.assertEqual(out.count(f" in {self.log}"), 2)
        self.assertEqual(out.count(": 0 with a wrong checksum, 0 out of sequence, 0 gaps"), 2)
        self.assertNotIn("can0", self.decode(both, "--interface", "can1"))
        self.assertIn("holds no frame of can7", complaint("can", "decode", self.log, "--interface", "can7"))

    def test_the_long_dialect_without_times(self):
        number, data = telemetry(3)[1]
        spaced = " ".join(f"{byte:02X}" for byte in data)
        out = self.decode(f"  can0  {number:03X}   [8]  {spaced}\n")
        self.assertIn("           - can0   022       Attitude                   #003  ok; Pitch 0.2100 rad", out)

    def test_frames_before_an_error_of_the_log_are_printed(self):
        self.log.write_text(session(2) + "(1.0) can0 22#00\n")
        done = subprocess.run([CLI, "can", "decode", self.log, "--csv", self.csv], capture_output=True, text=True)
        self.assertEqual(done.returncode, 1)
        self.assertIn("22 frames in", done.stdout)
        self.assertIn(f"{self.log}: line 23: expected an identifier", done.stderr)
        self.assertFalse(self.csv.exists(), "half a CSV would look like a whole one")
        self.log.write_text("")
        self.assertIn("holds no frame", complaint("can", "decode", self.log))
        self.assertIn("No such file", complaint("can", "decode", self.path / "none.log"))
        self.assertIn("cannot", complaint("can", "decode", self.log, "--csv", self.path / "no" / "such.csv"))

    def test_a_pipe_is_read_as_it_comes(self):
        done = subprocess.run([CLI, "can", "decode", "/dev/stdin"], input=session(3), capture_output=True, text=True)
        self.assertEqual(self.totals(done.stdout), (0,) * 6, done.stderr)

    def test_a_torn_end_is_reported_and_the_rest_read(self):
        self.log.write_text(session(2) + "(1436509053.0) can0 22")
        done = subprocess.run([CLI, "can", "decode", self.log, "--csv", self.csv, "--summary"], capture_output=True,
                              text=True)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn(f"{self.log}: line 23: is torn", done.stderr)
        self.assertIn("22 frames in", done.stdout)
        self.assertTrue(self.csv.exists())

    def test_a_clock_set_back_is_reported(self):
        text = session(4) + session(4).replace("(1436509052", "(1436505452")
        self.log.write_text(text)
        done = subprocess.run([CLI, "can", "decode", self.log], capture_output=True, text=True)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(done.stderr.count("line 45: 3600.15 s earlier than the line before"), 1, done.stderr)
        self.assertIn("the log's clock is set 1 times", done.stdout)
        self.assertIn("88 frames in 0.306 s", done.stdout)
        self.assertNotIn(" -3600", done.stdout)

    def test_packed_logs_and_standard_input_are_read(self):
        for given in (session(3).encode(), gzip.compress(session(3).encode())):
            for name in ("-", "/dev/stdin"):
                for command in (("decode", name, "--summary"), ("monitor", name), ("check", name)):
                    if command == ("check", "/dev/stdin"):
                        continue
                    done = subprocess.run([CLI, "can", *command], input=given, capture_output=True, timeout=60)
                    self.assertEqual(done.returncode, 0, done.stderr)
                    self.assertIn(b"33 frames", done.stdout)

    def test_logs_of_other_kinds_are_named(self):
        self.log.write_bytes(b"LOGG" + bytes(200))
        self.assertIn("is a binary log of Vector (.blf); expected", complaint("can", "decode", self.log))

    def test_lost_frames_of_the_recording_are_reported(self):
        out = self.decode(session(2) + "DROPCOUNT: dropped 5 CAN frames on 'can0' socket (total drops 5)\n")
        self.assertIn("5 frames were lost when the log was recorded", out)


class Absolem(Logs):
    def conversation(self):
        """Returns the requests of the robot's computer at 20 Hz and the drives' answers."""
        text = line(BEGIN, (0x000, bytes([1, 0, 0, 0])))
        for i in range(20):
            time = BEGIN + 0.05 * i
            for node, counts in ((2, 2250), (4, -2250), (5, -2250), (7, 2250)):
                text += elmo(time, 0x300 + node, "px") + elmo(time + 5e-4, 0x280 + node, "PX", type_byte=0,
                                                              value=struct.pack("<i", counts))
                text += elmo(time + 1e-3, 0x300 + node, "iq") + elmo(time + 1.5e-3, 0x280 + node, "IQ", type_byte=0x80,
                                                                     value=struct.pack("<f", 1.5))
        text += elmo(BEGIN + 1, 0x302, "sr") + elmo(BEGIN + 1, 0x282, "SR", type_byte=0, value=struct.pack("<I", 0x2010))
        text += elmo(BEGIN + 1, 0x302, "mf") + elmo(BEGIN + 1, 0x282, "MF", type_byte=0, value=struct.pack("<I", 8))
        return text + line(BEGIN + 1, (0x187, bytes([0x08, 0x00])))

    def test_angles_and_currents_in_our_signs(self):
        got = self.values(self.conversation(), "--protocol", "absolem")
        angles = {(row["frame"], row["value"]) for row in got if row["signal"] == "angle"}
        flippers = ("rear right", "front right", "rear left", "front left")
        self.assertEqual(angles, {(f"{name} flipper PX", "2.3562") for name in flippers}, "all raised by 135 degrees")
        down = {row["frame"]: float(row["value"]) for row in got if row["signal"] == "pressing down"}
        self.assertEqual(down, {"rear right flipper IQ": -1.5, "front left flipper IQ": -1.5,
                                "front right flipper IQ": 1.5, "rear left flipper IQ": 1.5})

    def test_states_in_words(self):
        out = self.decode(self.conversation(), "--protocol", "absolem")
        for words in ("SR motor on; current limit", "MF peak current exceeded", "front left flipper status",
                      "Status fault", "network command            -     in order; Command start, Node all"):
            self.assertIn(words, out)
        self.assertEqual(self.totals(out), (0,) * 6)

    def test_hostile_replies_are_counted(self):
        nan = struct.pack("<f", float("nan"))
        text = elmo(BEGIN, 0x302, "iq") + elmo(BEGIN, 0x282, "IQ", type_byte=0x80, value=nan)  # other fault
        text += elmo(BEGIN, 0x282, "PX", type_byte=0, value=bytes(4))  # not requested: out of sequence
        text += elmo(BEGIN, 0x302, "bg") + elmo(BEGIN, 0x282, "BG", value=bytes([58, 0, 0, 0]))  # refused: other fault
        text += elmo(BEGIN, 0x282, "PX", type_byte=0)  # too short: other fault
        text += line(BEGIN, (0x022, bytes(8)))  # unknown
        out = self.decode(text, "--protocol", "absolem")
        self.assertIn("refused by the drive; BG error 58", out)
        self.assertIn("a value is beyond its range; IQ nan", out)
        self.assertEqual(self.totals(out), (0, 1, 0, 3, 1, 1))


class Described(Logs):
    """Frames outside the protocol, described by a DBC file."""

    DBC = """BO_ 291 Payload: 8 Gas
 SG_ Oxygen : 7|16@0+ (0.01,0) [0|25] "%" Console
 SG_ State : 16|2@1+ (1,0) [0|2] "" Console
BO_ 34 Clash: 8 Gas
 SG_ Oxygen : 0|8@1+ (1,0) [0|25] "%" Console
VAL_ 291 State 1 "ready" ;
"""

    def setUp(self):
        super().setUp()
        self.dbc = self.path / "gas.dbc"
        self.dbc.write_text(self.DBC)

    def frames(self):
        return line(BEGIN, telemetry(0)[1]) + line(BEGIN, (0x123, bytes([0x08, 0x17, 0x01]))) + line(BEGIN, (0x124, b"1"))

    def test_dbc_files_decode_only_foreign_frames(self):
        self.log.write_text(self.frames())
        done = subprocess.run([CLI, "can", "decode", self.log, "--dbc", self.dbc, "--csv", self.csv], capture_output=True,
                              text=True, timeout=60)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("Attitude                   #000  ok; Pitch 0.2100 rad", done.stdout)
        self.assertIn("123       Payload                    -     by gas.dbc; Oxygen 20.71 %, State ready", done.stdout)
        self.assertIn("124       unknown ", done.stdout)
        self.assertEqual(self.totals(done.stdout), (0, 0, 0, 0, 1, 1))
        self.assertIn("gas.dbc: frame 022: ignored; the robot's protocol already uses this identifier", done.stderr)
        got = [row for row in rows(self.csv) if row["frame"] == "Payload"]
        self.assertEqual([(row["signal"], row["value"], row["unit"]) for row in got],
                         [("Oxygen", "20.71", "%"), ("State", "ready", "")])

    def test_dbc_signals_are_shown_by_the_monitor(self):
        self.log.write_text(self.frames())
        done = subprocess.run([CLI, "can", "monitor", self.log, "--dbc", self.dbc, "--dbc", self.dbc],
                              capture_output=True, text=True, timeout=60)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertRegex(done.stdout, r"123 +Payload .* Oxygen 20.71 %, State ready\n")
        self.assertEqual(done.stderr.count("frame 123: ignored; gas.dbc already describes it"), 1, done.stderr)

    def test_the_first_of_two_dbc_files_wins(self):
        other = self.path / "other.dbc"
        other.write_text(self.DBC.replace("Payload", "Other"))
        for files, name in (((self.dbc, other), "Payload"), ((other, self.dbc), "Other")):
            self.assertIn(f"123       {name} ", self.decode(self.frames(), "--dbc", files[0], "--dbc", files[1]))

    def test_a_bad_signal_is_named_and_the_others_kept(self):
        self.log.write_text(self.frames())
        self.dbc.write_text("// by hand\n" + self.DBC.replace("7|16@0", "60|16@0"))
        for command in ("decode", "monitor"):
            done = subprocess.run([CLI, "can", command, self.log, "--dbc", self.dbc], capture_output=True, text=True)
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertRegex(done.stderr, r"gas.dbc: line 3: the signal Oxygen is left out: it does not fit")
            self.assertIn("State ready", done.stdout)

    def test_csv_values_keep_all_their_digits(self):
        self.dbc.write_text("BO_ 1281 Serial: 8 D\n SG_ Number : 0|64@1+ (1,0) [0|0] \"\" C\n"
                            "BO_ 1282 Altitude: 8 D\n SG_ Metres : 0|64@1- (1,0) [0|0] \"m\" C\n"
                            "BO_ 1283 Status: 8 D\n SG_ State : 0|8@1+ (1,0) [0|0] \"\" C\n"
                            f"VAL_ 1283 State 1 \"{'long ' * 40}END\" ;\nSIG_VALTYPE_ 1282 Metres : 2;\n")
        number = struct.pack("<Q", 9223372036854788153)
        text = line(BEGIN, (1281, number)) + line(BEGIN, (1283, b"\x01"))
        text += "".join(line(BEGIN, (1282, struct.pack("<d", value)))
                        for value in (1234.56789012345, float("nan"), float("-inf")))
        got = {(row["signal"], row["value"]) for row in self.values(text, "--dbc", self.dbc)}
        self.assertEqual(got, {("Number", "9223372036854788153"), ("State", "long " * 40 + "END"),
                               ("Metres", "1234.56789012345"), ("Metres", "nan"), ("Metres", "-inf")})
        shown = self.decode(text, "--dbc", self.dbc)
        self.assertIn("Number 9223372036854788153", shown)
        self.assertIn("Metres nan m", shown)
        self.assertIn("long …", shown)

    def test_a_bad_dbc_file_is_refused_with_its_line(self):
        self.log.write_text(self.frames())
        self.dbc.write_text("nothing\n")
        for command in ("decode", "monitor"):
            said = complaint("can", command, self.log, "--dbc", self.dbc)
            self.assertIn("gas.dbc: describes no message", said)
            self.assertIn("line 1: expected the keyword", said)
            self.assertIn("nowhere.dbc: cannot be opened", complaint("can", command, self.log, "--dbc", "nowhere.dbc"))
        self.assertIn("no regular file", complaint("can", "decode", self.log, "--dbc", "/dev/zero"))


class Monitor(Logs):
    def test_a_replay_is_shown_with_rates_load_and_ages(self):
        self.log.write_text(session(30))
        out = run("can", "monitor", self.log)
        self.assertNotIn("\x1b", out, "no terminal, no escapes")
        last = out[out.rindex("REPLAY demo.log has ended; load "):]
        self.assertRegex(last, r"022 +Attitude +[12]\d\.\d +\d\.\d\d  Pitch 0.2100 rad, Roll -0.0500 rad")
        self.assertRegex(last, r"load \d+\.\d to \d+\.\d % of 500 kbit/s, 330 frames, 0 dropped, 0 error frames")

    def test_it_ends_after_the_seconds(self):
        self.log.write_text(line(BEGIN, telemetry(1)[1]) + line(BEGIN + 30, telemetry(2)[1]))
        out = run("can", "monitor", self.log, "--seconds", 0.3, "--bitrate", 125000)
        self.assertEqual(out.count("REPLAY demo.log, whose"), 1)
        self.assertIn("of 125 kbit/s", out)

    def test_a_silence_of_years_is_shortened_and_reported(self):
        self.log.write_text(line(BEGIN, telemetry(1)[1]) + line(BEGIN + 1e8, telemetry(2)[1]))
        done = subprocess.run([CLI, "can", "monitor", self.log], capture_output=True, text=True, timeout=60)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("line 2: follows 100000000 s of silence, which the replay shortens", done.stderr)
        self.assertIn("REPLAY demo.log has ended", done.stdout)

    def test_a_wait_for_the_next_frame_is_reported(self):
        self.log.write_text(line(BEGIN, telemetry(1)[1]) + line(BEGIN + 50, telemetry(2)[1]))
        out = run("can", "monitor", self.log, "--seconds", 0.3)
        self.assertRegex(out, r"REPLAY demo.log, whose next frame comes in (49|50) s; load")

    def test_a_terminal_gets_a_table_that_stays_in_place(self):
        self.log.write_text(session(10))
        done = subprocess.run(["script", "-qec", f"{CLI} can monitor {self.log}", "/dev/null"], stdin=subprocess.DEVNULL,
                              capture_output=True, text=True, timeout=60)
        self.assertIn("\x1b[2J", done.stdout)
        self.assertGreaterEqual(done.stdout.count("\x1b[H"), 2)
        self.assertIn("Attitude", done.stdout)

    def test_bad_interface_names_are_refused(self):
        self.assertIn("cannot be a CAN interface", complaint("can", "monitor", "a-name-of-16-byte", "--seconds", 0))
        self.log.write_text(session(1) + session(1).replace("can0", "can1"))
        self.assertIn("name the one to replay", complaint("can", "monitor", self.log))
        self.assertIn("11 frames", run("can", "monitor", self.log, "--interface", "can1", "--speed", 1000))
        complaint("can", "monitor", self.log, "--speed", 0, code=2)


class Check(unittest.TestCase):
    def test_names_the_fault_and_the_command_that_fixes_it(self):
        done = subprocess.run([CLI, "can", "check", "terratact-none"], capture_output=True, text=True)
        self.assertEqual(done.returncode, 1)
        self.assertRegex(done.stdout, r"problem +there is no interface terratact-none")
        self.assertIn("→", done.stdout)
        self.assertIn("terratact-none cannot be used", done.stderr)

    def test_prints_the_content_of_a_log(self):
        with tempfile.TemporaryDirectory() as folder:
            log = pathlib.Path(folder, "torn.log")
            log.write_text(session(2) + "(143")
            out = run("can", "check", log)
            self.assertRegex(out, r"warning +.*line 23: is torn")
            self.assertRegex(out, r"fine +it is a log of the format candump\n")
            self.assertRegex(out, r"fine +22 frames of can0\n")

    @unittest.skipUnless(pathlib.Path("/sys/class/net/lo").exists(), "sysfs is not mounted")
    def test_an_interface_of_another_kind(self):
        done = subprocess.run([CLI, "can", "check", "lo"], capture_output=True, text=True)
        self.assertEqual(done.returncode, 1)
        self.assertIn("lo is no CAN interface", done.stdout)

    def test_a_name_that_can_be_none(self):
        for name in ("a-name-of-16-byte", "can0;ls", "../can0", ""):
            self.assertIn("cannot be a CAN interface", complaint("can", "check", name))


class Help(unittest.TestCase):
    def test_every_command_prints_its_help(self):
        for command in ((), ("decode",), ("monitor",), ("check",)):
            self.assertIn("--help", run("can", *command, "--help"))
        for arguments in ((), ("decode",), ("decode", "x", "--protocol", "can"), ("monitor",), ("check",)):
            complaint("can", *arguments, code=2)


if __name__ == "__main__":
    unittest.main()
