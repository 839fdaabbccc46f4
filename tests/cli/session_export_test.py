"""Tests `terratact session export` and `import`: other programs read the exports. Argument: the program make_session."""

import collections
import gzip
import json
import pathlib
import shutil
import sqlite3
import struct
import subprocess
import unittest
import xml.etree.ElementTree
import zlib

from mcap_reader import Mcap
from session_support import BEGIN, Session, frames_of, setUpModule, tearDownModule  # noqa: F401
from support import CLI, SOURCE, complaint, rows, run

try:
    import can
except ImportError:
    can = None


def read_ply(content):
    """Returns the properties and the vertices of an ASCII PLY file; refuses what the format does not allow."""
    header, _, body = content.decode("ascii").partition("end_header\n")
    lines = header.splitlines()
    assert lines[:2] == ["ply", "format ascii 1.0"], lines[:2]
    lines = [line.split() for line in lines[2:] if not line.startswith("comment ")]
    assert lines[0][:2] == ["element", "vertex"] and len(lines[0]) == 3, lines[0]
    read = {"float": float, "double": float, "uchar": int, "int": int}
    properties = []
    for keyword, kind, name in lines[1:]:
        assert keyword == "property" and kind in read, (keyword, kind)
        properties.append((name, kind))
    vertices = []
    for line in body.splitlines():
        values = line.split(" ")
        assert len(values) == len(properties), line
        vertices.append({name: read[kind](value) for (name, kind), value in zip(properties, values)})
    assert len(vertices) == int(lines[0][2])
    return properties, vertices


class OtherPrograms(Session):
    def test_a_candump_log_is_what_candump_would_write(self):
        log = self.export("drive.log").read_text().splitlines()
        frames = frames_of(self.drive)
        self.assertEqual(len(log), len(frames))
        for line, (time, identifier, data) in zip(log, frames):
            self.assertRegex(line, r"^\(\d{10}\.\d{6}\) can0 [0-9A-F]{3}#([0-9A-F]{2}){0,8}$")
            self.assertEqual(line.split()[2], f"{identifier:03X}#{data.hex().upper()}")
            self.assertAlmostEqual(float(line[1:18]), time * 1e-9, delta=1e-6)

    @unittest.skipUnless(shutil.which("log2asc"), "can-utils are not installed")
    def test_can_utils_read_both_logs(self):
        log, asc = self.export("drive.log"), self.export("drive.asc")
        there = subprocess.run(["log2asc", "-I", log, "can0"], capture_output=True, text=True, check=True).stdout
        ours = [line.split() for line in asc.read_text().splitlines()[3:]]
        # Python-can's log begins with the first frame and has no direction; its dates are in the machine's time zone.
        theirs = [line.split() for line in there.splitlines()[3:]]
        self.assertEqual(len(ours), len(theirs))
        for mine, other in zip(ours, theirs):
            self.assertEqual(mine[1:3] + mine[4:], other[1:3] + other[4:])
        back = subprocess.run(["asc2log", "-I", asc], capture_output=True, text=True, check=True).stdout
        self.assertEqual([line.split()[2] for line in back.splitlines()],
                         [line.split()[2] for line in log.read_text().splitlines()])
        directions = collections.Counter(line.split()[3] for line in back.splitlines())
        self.assertEqual(set(directions), {"R", "T"})

    @unittest.skipUnless(can, "python-can is not installed")
    def test_python_can_reads_logs_and_the_session_itself(self):
        expected = frames_of(self.drive)
        named = self.copy("drive.db")  # python-can chooses by the ending
        for path in (named, self.export("drive.log"), self.export("drive.asc")):
            with self.subTest(path=path.name):
                if path.suffix == ".asc":
                    messages = list(can.ASCReader(path, relative_timestamp=False))
                elif path.suffix == ".db":
                    messages = list(can.SqliteReader(path))
                else:
                    messages = list(can.LogReader(path))
                self.assertEqual([(m.arbitration_id, bytes(m.data)) for m in messages],
                                 [(identifier, data) for _, identifier, data in expected])
                for message, (time, _, _) in zip(messages, expected):
                    self.assertAlmostEqual(message.timestamp, time * 1e-9, delta=2e-6)
                self.assertFalse(any(m.is_extended_id or m.is_error_frame or m.is_remote_frame for m in messages))

    def test_strict_reader_opens_the_strip_point_cloud(self):
        out, table = self.path / "strip.ply", self.path / "strip.csv"
        run("session", "strip", self.drive, "--out", out)
        run("session", "strip", self.drive, "--out", table)
        names, vertices = read_ply(out.read_bytes())
        self.assertEqual(names[:3], [("x", "float"), ("y", "float"), ("z", "float")])
        bins = rows(table)
        self.assertGreaterEqual(len(vertices), 22)
        self.assertEqual(len(vertices), len(bins))
        for vertex, line in zip(vertices, bins):
            self.assertEqual(vertex["x"], float(line["plan_x_m"]))
            self.assertEqual(vertex["z"], float(line["height_m"]))
            self.assertEqual(vertex["side"], ["left", "right"].index(line["side"]))
            self.assertIn(abs(vertex["y"]), (0.1985, 0.272))

    @unittest.skipUnless(shutil.which("pcl_ply2pcd"), "pcl-tools is not installed")
    def test_pcl_reads_the_strip(self):
        out, table, made = (self.path / f"strip.{ending}" for ending in ("ply", "csv", "pcd"))
        for path in (out, table):
            run("session", "strip", self.drive, "--out", path)
        subprocess.run(["pcl_ply2pcd", "-format", "0", out, made], capture_output=True, check=True)
        header, _, body = made.read_text().partition("DATA ascii\n")
        fields = next(line.split()[1:] for line in header.splitlines() if line.startswith("FIELDS "))
        points = [dict(zip(fields, map(float, line.split()))) for line in body.splitlines()]
        bins = rows(table)
        self.assertGreaterEqual(len(bins), 22)
        self.assertEqual(len(points), len(bins))
        for point, line in zip(points, bins):
            for field, column in (("x", "plan_x_m"), ("y", "plan_y_m"), ("z", "height_m"), ("sd", "sd_m"),
                                  ("time", "time_s"), ("section", "section")):
                self.assertAlmostEqual(point[field], float(line[column]), delta=1e-6, msg=field)
            self.assertEqual(point["side"], ["left", "right"].index(line["side"]))

    def test_a_picture_of_the_strip_holds_the_profile(self):
        picture, image, table = (self.path / f"strip.{ending}" for ending in ("svg", "png", "csv"))
        for out in (picture, image, table):
            run("session", "strip", self.drive, "--out", out)
        root = xml.etree.ElementTree.parse(picture).getroot()
        space = "{http://www.w3.org/2000/svg}"
        self.assertEqual(root.tag, space + "svg")
        self.assertEqual(root.find(space + "metadata").text.strip(), table.read_text().strip())
        self.assertIn("drive.tts", root.find(space + "title").text)
        wide, high = struct.unpack(">II", image.read_bytes()[16:24])
        self.assertEqual(root.get("viewBox"), f"0 0 {wide} {high}")

    def test_strip_refuses_unknown_format_and_section(self):
        out = self.path / "strip.xyz"
        self.assertIn("expected .csv, .ply, .png", complaint("session", "strip", self.drive, "--out", out))
        self.assertIn("expected --section 1 to", complaint("session", "strip", self.drive, "--section", 99,
                                                           "--out", self.path / "strip.ply"))
        self.assertFalse(out.exists())

    def test_sqlites_own_shell_opens_it(self):
        out = subprocess.run(["sqlite3", self.drive, "PRAGMA integrity_check; SELECT count(*) FROM messages"],
                             capture_output=True, text=True, check=True).stdout.split()
        self.assertEqual(out, ["ok", str(len(frames_of(self.drive)))])

    def test_the_log_can_be_decoded_without_a_complaint(self):
        text = run("can", "decode", self.export("drive.log"), "--summary")
        self.assertRegex(text, r"frames.*: 0 with a wrong checksum|frames.*: 0 with .* checksum")

    def test_a_log_makes_a_session_with_the_same_frames(self):
        out = self.path / "back.tts"
        run("session", "import", self.export("drive.log"), "--out", out)
        self.assertEqual([frame[1:] for frame in frames_of(out)], [frame[1:] for frame in frames_of(self.drive)])
        self.assertIn("holds", run("session", "verify", out))
        again = self.path / "again.log"
        run("session", "export", out, "--out", again)
        self.assertEqual(again.read_text(), self.export("drive.log").read_text())
        self.assertIn("is never replaced", complaint("session", "import", again, "--out", out))

    def test_whole_lines_of_a_torn_log_are_imported(self):
        log = self.export("drive.log")
        log.write_text(log.read_text()[:-6])
        out = self.path / "torn.tts"
        done = subprocess.run([CLI, "session", "import", log, "--out", out], capture_output=True, text=True, check=True)
        self.assertIn("is torn: the log ends within it", done.stderr)
        self.assertEqual([frame[1:] for frame in frames_of(out)], [frame[1:] for frame in frames_of(self.drive)[:-1]])
        file = sqlite3.connect(out)
        told = file.execute("SELECT subject, text FROM event WHERE kind = 'gap'").fetchall()
        file.close()
        self.assertEqual(told, [("log", "the end of the log is torn")])

    def test_a_log_with_a_set_clock_makes_an_even_session(self):
        log, out = self.path / "back.log", self.path / "back.tts"
        times = [100000.0 + 0.05 * i - (3600.0 if i >= 4 else 0.0) for i in range(8)]
        log.write_text("".join(f"({time:.6f}) can0 500#{i:02X}FF01\n" for i, time in enumerate(times)))
        done = subprocess.run([CLI, "session", "import", log, "--out", out], capture_output=True, text=True, check=True)
        self.assertIn(f"{log}: line 5: 3599.95 s earlier than the line before", done.stderr)
        file = sqlite3.connect(out)
        ticks = [t for t, in file.execute("SELECT t FROM can_frame ORDER BY seq")]
        told = file.execute("SELECT t, text FROM event WHERE kind = 'gap'").fetchall()
        file.close()
        for got, expected in zip(ticks, (0, 50, 100, 150, 150, 200, 250, 300)):
            self.assertAlmostEqual(got * 1e-6, expected, delta=1e-3)
        self.assertEqual(len(told), 1)
        self.assertEqual(told[0], (ticks[4], "at line 5 the log's clock was set back by 3599.950000 s; "
                                             "the session continues evenly"))
        self.assertRegex(run("session", "info", out), r"lasts +0.300 s[^$]*gaps +1,")

    def test_a_clock_set_far_forward_makes_an_even_session(self):
        log, out = self.path / "far.log", self.path / "far.tts"
        far = "".join(f"({time}) can0 500#01\n" for time in ("1483389464.165", "9100000000.0", "9100000000.1"))
        log.write_text(far)
        done = subprocess.run([CLI, "session", "import", log, "--out", out], capture_output=True, text=True, check=True)
        self.assertIn("line 2: 7616610536 s later than the line before", done.stderr)
        self.assertRegex(run("session", "info", out), r"begins +2017-01-02 20:37:44\.165 UTC[^$]*lasts +0.100 s")
        log.write_text("".join(far.splitlines(keepends=True)[2:]))
        self.assertIn("line 1: begins at 9100000000 s since 1970, expected at most 9000000000 s",
                      complaint("session", "import", log, "--out", self.path / "none.tts"))
        log.write_text(" can0  500   [1]  01\n")
        self.assertIn("line 1: has no time: record with candump -L",
                      complaint("session", "import", log, "--out", self.path / "none.tts"))
        self.assertFalse((self.path / "none.tts").exists())

    def test_frames_of_can_fd_keep_all_their_bytes(self):
        log, out = self.path / "fd.log", self.path / "fd.tts"
        data = bytes(range(64)).hex().upper()
        log.write_text(f"(1000.000000) can0 50B##1{data}\n")
        run("session", "import", log, "--out", out)
        for name in ("again.log", "again.asc", "again.csv"):
            run("session", "export", out, "--out", self.path / name)
            run("session", "import", self.path / name, "--out", self.path / (name + ".tts"))
            file = sqlite3.connect(self.path / (name + ".tts"))
            self.assertEqual(file.execute("SELECT hex(data), flags FROM can_frame").fetchall(), [(data, 64 << 8 | 8)])
            file.close()

    def test_our_asc_makes_the_same_session(self):
        out = self.path / "asc.tts"
        run("session", "import", self.export("drive.asc"), "--out", out)
        self.assertEqual([frame[1:] for frame in frames_of(out)], [frame[1:] for frame in frames_of(self.drive)])

    @unittest.skipUnless(can, "python-can is not installed")
    def test_files_of_python_can_are_read(self):
        messages = [can.Message(timestamp=1e9 + 0.25 * i, arbitration_id=i, is_extended_id=i > 2, is_rx=True,
                                data=bytes(range(i)), channel=0) for i in range(1, 9)]
        for writer, name in ((can.ASCWriter, "p.asc"), (can.TRCWriter, "p.trc"), (can.CSVWriter, "p.csv"),
                             (can.CanutilsLogWriter, "p.log")):
            with writer(str(self.path / name)) as log:
                for message in messages:
                    log.on_message_received(message)
            out = self.path / (name + ".tts")
            run("session", "import", self.path / name, "--out", out)
            with self.subTest(name):
                self.assertEqual([frame[1:] for frame in frames_of(out)],
                                 [(m.arbitration_id, bytes(m.data)) for m in messages])

    def test_a_packed_log_and_a_pipe_are_read(self):
        log = self.export("drive.log").read_bytes()
        (self.path / "drive.log.gz").write_bytes(gzip.compress(log))
        for name, given in ((self.path / "drive.log.gz", b""), ("-", log), ("/dev/stdin", gzip.compress(log))):
            out = self.path / f"{len(given)}.tts"
            subprocess.run([CLI, "session", "import", name, "--out", out], input=given, check=True, capture_output=True)
            self.assertEqual(len(frames_of(out)), len(frames_of(self.drive)))


class Tables(Session):
    def test_the_first_column_is_the_time(self):
        frames = rows(self.export("frames.csv"))
        self.assertEqual([(int(r["__time"].replace(".", "")), int(r["id"]), bytes.fromhex(r["data"])) for r in frames],
                         frames_of(self.drive))

    def test_a_time_window_selects_its_rows(self):
        part = rows(self.export("part.csv", "--from", "2", "--to", "3.5"))
        inside = [f for f in frames_of(self.drive) if 2e9 <= f[0] - BEGIN * 10**9 <= 3.5e9]
        self.assertEqual([int(r["__time"].replace(".", "")) for r in part], [f[0] for f in inside])
        self.assertGreater(len(part), 100)

    def test_signals_are_those_that_can_decode_finds(self):
        decoded = self.path / "decoded.csv"
        run("can", "decode", self.export("drive.log"), "--csv", decoded, "--summary")
        expected = [float(r["value"]) for r in rows(decoded) if (r["frame"], r["signal"]) == ("Attitude", "Pitch")]
        signals = rows(self.export("signals.csv", "--what", "signals"))
        found = [float(r["Attitude.Pitch [rad]"]) for r in signals if r["Attitude.Pitch [rad]"]]
        self.assertEqual(len(found), len(expected))
        for a, b in zip(found, expected):
            self.assertAlmostEqual(a, b, delta=1e-4)

    def test_payload_signals_have_their_columns(self):
        docs, out = pathlib.Path(SOURCE) / "docs", self.path / "payload.tts"
        run("session", "import", docs / "can_payload.log", "--out", out)
        table, dbc = self.path / "payload.csv", docs / "can_payload.dbc"
        run("session", "export", out, "--out", table, "--what", "signals", "--dbc", dbc, "--dbc", dbc)
        found = rows(table)
        self.assertEqual([r["GasSensor.CarbonMonoxide [ppm]"] for r in found if r["GasSensor.Oxygen [%]"]],
                         ["23.5", "24.3"])
        self.assertEqual([(r["Battery.Group"], r["Battery.Voltage [V]"], r["Battery.Power [W]"]) for r in found
                          if r["Battery.Group"]], [("0", "25.187", ""), ("1", "", "187.5")] * 2)
        self.assertEqual(len([r for r in found if r["Attitude.Pitch [rad]"]]), 2)
        bag = self.path / "payload.mcap"
        run("session", "export", out, "--out", bag, "--dbc", dbc)
        self.assertIn(b'{"CarbonMonoxide":23.5,"Oxygen":20.7,"Temperature":-3.5,"State":1}', bag.read_bytes())
        self.assertIn(b"/payload/GasSensor", bag.read_bytes())
        self.assertIn("holds no signals", complaint("session", "export", out, "--out", self.path / "p.log", "--dbc", dbc))
        for name, *what in (("f.csv",), ("f.csv", "--what", "frames"), ("f.csv", "--what", "events"),
                            ("f.mcap", "--what", "estimates")):
            self.assertIn("--dbc: these rows hold no signals",
                          complaint("session", "export", out, "--out", self.path / name, *what, "--dbc", dbc, code=2))
        run("session", "export", out, "--out", bag, "--what", "frames", "--dbc", dbc)
        self.assertIn(b'"name":"GasSensor","signals":{"CarbonMonoxide":23.5', bag.read_bytes())

    def test_estimates_and_events_are_those_of_the_file(self):
        file = sqlite3.connect(self.drive)
        bins = file.execute("SELECT estimate, height_m, q10_m FROM estimate_bin ORDER BY id").fetchall()
        events = file.execute("SELECT id, kind, subject, text FROM event ORDER BY id").fetchall()
        file.close()
        self.assertEqual([(int(r["estimate"]), float(r["height_m"]), float(r["q10_m"]))
                          for r in rows(self.export("estimates.csv", "--what", "estimates"))], bins)
        self.assertEqual([(int(r["event"]), r["kind"], r["subject"], r["text"])
                          for r in rows(self.export("events.csv", "--what", "events"))], events)
        self.assertTrue(any('"' in text and "," in text for _, _, _, text in events), "nothing that needs quoting")

    def test_exported_scenes_are_read_by_other_commands(self):
        scenes, out = self.path / "scenes.csv", self.path / "out"
        run("session", "scenes", self.drive, "--out", scenes)
        self.assertEqual([r["run"] for r in rows(scenes)], ["drive", "drive"])
        run("evaluate", "--data", scenes, "--out", out, "--methods", "local")
        run("reconstruct", "--data", scenes, "--out", self.path / "estimates.csv")
        self.assertIn("found 2", complaint("train", "--data", scenes, "--out", self.path / "m.ttm"))

    def test_a_log_holds_nothing_but_frames(self):
        self.assertIn("holds nothing else", complaint("session", "export", self.drive, "--out", self.path / "a.log",
                                                      "--what", "events"))
        self.assertIn("ends in none of", complaint("session", "export", self.drive, "--out", self.path / "a.txt"))
        self.assertEqual(list(self.path.iterdir()), [])

    def test_only_a_session_ends_in_tts(self):
        for command in (("export", "--format", "csv"), ("scenes",), ("strip",)):
            self.assertIn("ends in .tts, as sessions do",
                          complaint("session", *command, self.drive, "--out", self.path / "a.tts"))
        self.assertEqual(list(self.path.iterdir()), [])

    def test_a_format_that_is_named_allows_any_ending(self):
        self.assertTrue(self.export("a.txt", "--format", "csv").read_text().startswith("__time,"))
        self.assertTrue(self.export("a.log", "--format", "asc").read_text().startswith("date "))


class McapFile(Session):
    def setUp(self):
        super().setUp()
        self.file = Mcap(self.export("drive.mcap"))

    def test_records_stand_in_their_order(self):
        names = [name for _, name, _ in self.file.records]
        self.assertEqual((names[0], names[-1]), ("header", "footer"))
        end = names.index("data end")
        self.assertNotIn("message", names, "messages are in chunks")
        self.assertEqual(set(names[end + 1:-1]),
                         {"schema", "channel", "statistics", "chunk index", "metadata index", "summary offset"})
        self.assertLess(names.index("channel"), names.index("chunk"))

    def test_chunks_match_their_crc_and_index(self):
        counts, first, last = collections.Counter(), 2**64, 0
        indexes = {}
        for at, content in self.file.of("chunk index"):
            begin, end, chunk_at, chunk_length = struct.unpack_from("<4Q", content)
            offsets, at = self.file.pairs(content, 32, "<HQ")
            index_length, = struct.unpack_from("<Q", content, at)
            compression, at = self.file.text(content, at + 8)
            indexes[chunk_at] = (begin, end, chunk_length, dict(offsets), index_length, compression,
                                 *struct.unpack_from("<2Q", content, at))
        chunks = self.file.of("chunk")
        self.assertEqual(sorted(indexes), [at for at, _ in chunks])
        self.assertGreater(len(chunks), 5)
        for at, content in chunks:
            begin, end, size, crc = struct.unpack_from("<3QI", content)
            compression, place = self.file.text(content, 28)
            stored, = struct.unpack_from("<Q", content, place)
            body = content[place + 8:]
            self.assertEqual((compression, stored, len(body)), ("", size, size))
            self.assertEqual(crc, zlib.crc32(body))
            self.assertLess(size, 64 * 1024)
            found = collections.defaultdict(list)
            for offset, name, message in self.file.split(body, 0, size):
                self.assertEqual(name, "message")
                channel, sequence, time, published = struct.unpack_from("<HIQQ", message)
                self.assertEqual((sequence, published), (counts[channel], time))
                self.assertTrue(begin <= time <= end)
                json.loads(message[22:])
                counts[channel] += 1
                first, last = min(first, time), max(last, time)
                found[channel].append((time, offset))
            index = indexes[at]
            self.assertEqual(index[:3] + index[5:], (begin, end, 9 + len(content), "", size, size))
            after = at + 9 + len(content)
            for channel, place in index[3].items():
                _, message_index = next(r for r in self.file.of("message index") if r[0] == place)
                self.assertEqual(struct.unpack_from("<H", message_index)[0], channel)
                self.assertEqual(self.file.pairs(message_index, 2, "<QQ")[0], found.pop(channel))
                after = max(after, place + 9 + len(message_index))
            self.assertEqual(after - at - 9 - len(content), index[4])
            self.assertFalse(found, "messages that are in no index")
        (_, statistics), = self.file.of("statistics")
        self.assertEqual(struct.unpack_from("<QHIIIIQQ", statistics),
                         (sum(counts.values()), 4, 4, 0, 1, len(chunks), first, last))
        self.assertEqual(dict(self.file.pairs(statistics, 42, "<HQ")[0]), dict(counts))

    def test_the_summary_is_at_the_offset_of_the_footer(self):
        (_, footer), = self.file.of("footer")
        summary, offsets, crc = struct.unpack("<QQI", footer)
        self.assertEqual(crc, zlib.crc32(self.file.bytes[summary:-12]))
        self.assertEqual(self.file.records[[n for _, n, _ in self.file.records].index("data end") + 1][0], summary)
        self.assertEqual(self.file.of("summary offset")[0][0], offsets)
        for _, content in self.file.of("summary offset"):
            opcode, begin, length = struct.unpack("<BQQ", content)
            group = list(self.file.split(self.file.bytes, begin, begin + length))
            self.assertEqual({name for _, name, _ in group}, {Mcap.NAMES[opcode]})

    def test_messages_match_their_schemas(self):
        schemas = {}
        for _, content in self.file.of("schema"):
            identifier, = struct.unpack_from("<H", content)
            name, at = self.file.text(content, 2)
            encoding, at = self.file.text(content, at)
            self.assertEqual(encoding, "jsonschema")
            schemas[identifier] = json.loads(self.file.text(content, at)[0])
        channels = {}
        for _, content in self.file.of("channel"):
            identifier, schema = struct.unpack_from("<HH", content)
            topic, at = self.file.text(content, 4)
            self.assertEqual(self.file.text(content, at)[0], "json")
            channels[identifier] = (topic, schemas[schema])
        self.assertEqual(sorted(topic for topic, _ in channels.values()), ["/can", "/estimate", "/event", "/measurement"])
        kinds = {"integer": int, "number": (int, float), "string": str, "boolean": bool, "array": list, "object": dict}
        got = collections.defaultdict(list)
        for _, content in self.file.of("chunk"):
            _, place = self.file.text(content, 28)
            for _, _, message in self.file.split(content[place + 8:], 0, len(content) - place - 8):
                channel, _, time, _ = struct.unpack_from("<HIQQ", message)
                topic, schema = channels[channel]
                value = json.loads(message[22:])
                for key, part in value.items():
                    self.assertIsInstance(part, kinds[schema["properties"][key]["type"]], f"{topic} {key}")
                got[topic].append((time, value))
        self.assertEqual([(time, value["id"], bytes(value["data"])) for time, value in got["/can"]],
                         frames_of(self.drive))
        pitch = [value["signals"]["Pitch"] for _, value in got["/can"] if value.get("name") == "Attitude"]
        measured = [value["pitch"] for _, value in got["/measurement"]]
        self.assertGreater(len(measured), 50)
        for _, value in got["/measurement"]:
            for left, right, mean in zip(value["front_left_force"], value["front_right_force"], value["force"], strict=True):
                self.assertAlmostEqual((left + right) / 2, mean, places=9)
            self.assertNotIn("rear_left_force", value)
            self.assertNotIn("differential", value)
        self.assertTrue(any(value["front_left_force"] != value["front_right_force"] for _, value in got["/measurement"]))
        self.assertEqual(set(measured) - set(pitch), set())
        self.assertEqual([len(value["bins"]) for _, value in got["/estimate"]], [11] * len(got["/estimate"]))


if __name__ == "__main__":
    unittest.main()
