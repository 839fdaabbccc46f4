"""Text files that attack their readers: each makes much of one thing that the reader has to keep or to search.

all_readers() yields (title, file, arguments of terratact) for files of about `size` bytes.
"""

import bz2
import gzip
import pathlib
import sqlite3
import struct
import subprocess

FRAME = "(1793000000.000000) can0 123#00\n"
DBC = 'VERSION ""\nBU_: Gas\n'
MESSAGE = DBC + "BO_ 291 M: 8 Gas\n"
SIGNAL = ' SG_ S : 0|8@1+ (1,0) [0|0] "" X\n'
SELECTED = "(1793000000.000000) can0 123#10\n"  # Y = 1 and X = 0 of many_ranges()


def lines(size, line):
    """Returns text of about `size` bytes. line(i): the text of line i."""
    return "".join(line(i) for i in range(size // len(line(size // 50))))


def scene_files(size, scenes):
    header, row, *_ = scenes.splitlines()
    return {
        "one long line": header[:10] + "x" * size,
        "many columns": lines(size, lambda i: f"c{i},") + "\n",
        "one column many times": "pitch_rad," * (size // 10) + "\n",
        "an open quote": header + '\n"' + "x\n" * (size // 2),
        "empty lines": header + "\n" * size,
        "empty lines above": "\n" * size + header + "\n" + row,
        "empty lines and comments above": ("#\n" + "\n" * 1000) * (size // 1002) + header + "\n" + row,
        "comments": "#\n" * (size // 2) + header + "\n" + row,
        "many scenes": header + "\n" + lines(size, lambda i: row + "\n"),
        "zeros": b"\0" * size,
        "gzip of one letter": gzip.compress(b"x" * 100 * size, 1),
    }


def profiles(size):
    return {
        "many points": "x_m,z_m\n" + lines(size, lambda i: f"{i * 1e-3:.3f},0\n"),
        "one long line": "x_m,z_m" + "x" * size,
        "one place": "x_m,z_m\n" + "0,0\n" * (size // 4),
        "tiny steps": "x_m,z_m\n" + lines(size, lambda i: f"{i}e-300,1e300\n"),
        "many columns": "x_m," + lines(size, lambda i: f"z{i}_m,") + "\n",
    }


def grounds(size):
    header = "pair,step_m,y_m,heights_m\n"
    return {
        "many heights": header + "a,0.1,0.2," + "0,1," * (size // 4) + "0\na,0.1,-0.2,0,0\n",
        "many grounds": header + lines(size, lambda i: f"p{i},0.1,0.2,0,0\np{i},0.1,-0.2,0,0\n"),
        "many lines": header + lines(size, lambda i: f"a,0.1,{i * 1e-7:.7f},0,0\n"),
    }


def logs(size):
    return {
        "many.log": lines(size, lambda i: FRAME),
        "identifiers.log": lines(size, lambda i: f"(1793000000.{i % 1000000:06d}) can0 {i:08X}#00\n"),
        "interfaces.log": lines(size, lambda i: f"(1793000000.{i % 1000000:06d}) can{i} 123#00\n"),
        "line.log": FRAME + "(" * size,
        "blank.log.gz": gzip.compress(FRAME.encode() + b"\n" * 200 * size, 1),
        "line.log.gz": gzip.compress(b"(" * 200 * size, 1),
        "identifiers.asc": "date Mon Jan 1 00:00:00 2024\nbase hex timestamps absolute\n"
                           + lines(size, lambda i: f"{i * 1e-6:.6f} {i % 250 + 1} {i:X}x Rx d 1 00\n"),
        "identifiers.trc": ";$FILEVERSION=2.1\n;$STARTTIME=45000\n;$COLUMNS=N,O,T,I,d,l,D\n"
                           + lines(size, lambda i: f"{i} {i * .1:.3f} DT {i:08X} Rx 1 00\n"),
        "identifiers.csv": "Time Stamp,ID,Extended,Dir,Bus,LEN,D1,D2,D3,D4,D5,D6,D7,D8\n"
                           + lines(size, lambda i: f"{i},{i:08X},true,Rx,0,1,00,,,,,,,\n"),
    }


def dbc_files(size):
    return {
        "many messages": DBC + lines(size, lambda i: f"BO_ {i + 1} M{i}: 8 Gas\n" + SIGNAL),
        "many signals": MESSAGE + lines(size, lambda i: f' SG_ S{i} : 0|8@1+ (1,0) [0|0] "" X\n'),
        "many comments": MESSAGE + SIGNAL + 'CM_ SG_ 291 S "c";\n' * (size // 20),
        "many values": MESSAGE + SIGNAL + "VAL_ 291 S " + lines(size, lambda i: f'{i} "a" ') + ";\n",
        "an open string": DBC + 'CM_ "' + "x" * size,
        "escaped quotes": MESSAGE + SIGNAL + 'XX_ \\"\n' * (size // 7),
        "one long name": DBC + "BO_ 291 " + "M" * size + ": 8 Gas\n",
        "many attributes": DBC + lines(size, lambda i: f'BA_DEF_ BO_ "a{i}" STRING ;\nBA_ "a{i}" BO_ 291 "x";\n'),
        "many multiplexed signals": MESSAGE + ' SG_ X M : 0|8@1+ (1,0) [0|0] "" X\n'
                                    + lines(size, lambda i: f' SG_ S{i} m{i} : 8|8@1+ (1,0) [0|0] "" X\n'),
    }


def many_ranges(size):
    """Makes a multiplexor Y, which many ranges of X select, and signals below it. None selects it in SELECTED."""
    signals = range(4000)
    return (MESSAGE + ' SG_ X M : 0|4@1+ (1,0) [0|0] "" X\n SG_ Y m1M : 4|4@1+ (1,0) [0|0] "" X\n'
            + "".join(f' SG_ S{i} m1 : 8|8@1+ (1,0) [0|0] "" X\n' for i in signals)
            + "".join(f"SG_MUL_VAL_ 291 S{i} Y 1-1;\n" for i in signals)
            + "SG_MUL_VAL_ 291 Y X " + lines(size // 2, lambda i: f"{2 * i + 1}-{2 * i + 1},") + "1-1;\n")


def repeated_texts():
    """Makes signals of one bit, of which each has a long unit and a long word."""
    signals = range(1000)
    return (MESSAGE + "".join(f' SG_ S{i} : 0|1@1+ (1,0) [0|0] "{"u" * 1000}" X\n' for i in signals)
            + "".join(f'VAL_ 291 S{i} 0 "{"w" * 300}" ;\n' for i in signals))


def toml_files(size, robot):
    return {
        "nested arrays": "a=" + "[" * size,
        "nested tables": "[" + ".".join("a" * (size // 2)) + "]\n",
        "many keys": robot + "\n[x]\n" + lines(size, lambda i: f"k{i}=1\n"),
        "many dotted keys": lines(size, lambda i: f"a.b{i}.c=1\n"),
        "one long string": robot + '\ns="' + "x" * size + '"\n',
        "one long array": "a=[" + "1," * (size // 2) + "]\n",
    }


def mcap(*records):
    """Returns an MCAP file without an index. records: (kind, content)."""
    body = b"".join(struct.pack("<BQ", kind, len(content)) + content for kind, content in records)
    return b"\x89MCAP0\r\n" + body


def mcap_text(text):
    return struct.pack("<I", len(text)) + text


def mcap_schema(number, name, text):
    return 3, struct.pack("<H", number) + mcap_text(name) + mcap_text(b"ros1msg") + mcap_text(text)


def mcap_channel(number, schema, encoding, name=None):
    name = name or b"/t%d" % number
    return 4, struct.pack("<HH", number, schema) + mcap_text(name) + mcap_text(encoding) + mcap_text(b"")


def mcap_message(channel, data):
    return 5, struct.pack("<HIQQ", channel, 0, 1, 1) + data


def mcap_chunk(*content):
    records = mcap(*content)[8:]
    packed = bz2.compress(records)
    return 6, struct.pack("<QQQI", 0, 0, len(records), 0) + mcap_text(b"bz2") + struct.pack("<Q", len(packed)) + packed


def bag_record(data, **fields):
    header = b"".join(mcap_text(name.encode() + b"=" + value) for name, value in fields.items())
    return mcap_text(header) + mcap_text(data)


def bag_chunk(size, packed):
    return bag_record(packed, op=b"\x05", compression=b"bz2", size=struct.pack("<I", size))


def bag_connection(number, definition):
    about = mcap_text(b"type=p/T") + mcap_text(b"message_definition=" + definition)
    return bag_record(about, op=b"\x07", conn=struct.pack("<I", number), topic=b"/t%d" % number)


BAG = b"#ROSBAG V2.0\n" + bag_record(b"", op=b"\x03", index_pos=bytes(8))


def definitions():
    """Makes recordings of a few kilobytes whose chunks expand to large message definitions."""
    large = b" " * ((16 << 20) - 1000)
    megabyte = (1 << 20) - 100
    fields = b"E e\n" * 9990 + b"===\nMSG: p/E\n"
    channel, message = mcap_channel(1, 0, b"json"), mcap_message(1, b"1")
    connections = [bag_connection(i, large) for i in range(4)]
    chunks = [range(first, first + 15) for first in (1, 16, 31, 46)]
    return {
        "large definitions.mcap": mcap(channel, message,
                                       *[mcap_chunk(mcap_schema(i, b"p/T", large)) for i in range(1, 5)]),
        "many definitions.mcap": mcap(channel, message,
                                      *[mcap_chunk(*[mcap_schema(i, b"p/T%d" % i, b" " * megabyte) for i in chunk])
                                        for chunk in chunks]),
        "definitions of many fields.mcap": mcap(mcap_chunk(
            *[record for i in range(1, 391) for record in (mcap_schema(i, b"p/T%d" % i, fields),
                                                           mcap_channel(i, i, b"ros1"), mcap_message(i, b""))])),
        "large definitions.bag": BAG + b"".join(bag_chunk(len(c), bz2.compress(c)) for c in connections),
    }


def recordings(size):
    def json(text):
        return mcap(mcap_channel(1, 0, b"json"), mcap_message(1, text))

    schema = mcap_schema(1, b"p/T", b"bool a\n" * (size // 14))
    empties = mcap_schema(1, b"p/T", b"E[] e\n===\nMSG: p/E\n")
    bomb = bz2.compress(b"\0" * 400 * size)
    return {
        **definitions(),
        "a long name.mcap": mcap(mcap_channel(1, 0, b"json", b"n" * (size // 2)),
                                 *[mcap_message(1, b"1")] * (size // 68)),
        "channels of a long type.mcap": mcap(mcap_schema(1, b"T" * (size // 2), b""),
                                             *[mcap_channel(i, 1, b"ros1") for i in range(size // 120)]),
        "nested arrays.mcap": json(b"[" * 60_000),
        "empty arrays.mcap": json(b"[" + b"[]," * 20_000 + b"[]]"),
        "many members.mcap": json(b"{" + b",".join(b'"a%d":1' % i for i in range(6000)) + b"}"),
        "many messages.mcap": mcap(mcap_channel(1, 0, b"json"), *[mcap_message(1, b"[1]")] * (size // 34)),
        "channels with one definition.mcap": mcap(schema, *[mcap_channel(i, 1, b"ros1") for i in range(size // 60)],
                                                  *[mcap_message(i, b"") for i in range(size // 120)]),
        "elements without bytes.mcap": mcap(empties, mcap_channel(1, 1, b"ros1"), mcap_message(1, b"\xff\xff\xff\xff"))
                                       + b"\0" * size,
        "a chunk that declares 2^60 bytes.mcap": mcap((6, b"")) + struct.pack("<BQ", 6, 1 << 60),
        "one chunk many times.mcap": mcap(*[mcap_chunk(mcap_channel(1, 0, b"json"),
                                                       *[mcap_message(1, b"1")] * 200_000)] * 20),
        "many values.mcap": mcap(mcap_channel(1, 0, b"json"),
                                 mcap_chunk(*[mcap_message(1, b"[" + b"1," * 60 + b"1]")] * 20_000)),
        "zeros in bzip2.bag": BAG + bag_chunk(400 * size, bomb) * 20,
        "many columns.csv": "t," + lines(size, lambda i: f"c{i},") + "\n" + "1," * 1000 + "\n",
        "many rows.csv": "t,a\n" + lines(size, lambda i: f"{i},1\n"),
    }


PCD = "VERSION 0.7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 1\nWIDTH {0}\nHEIGHT 1\nPOINTS {0}\nDATA {1}\n"
PLY = "ply\nformat {1} 1.0\nelement vertex {0}\nproperty float x\nproperty float y\nproperty float z\nend_header\n"


def clouds(size):
    many, grid = 4_000_000_000, lines(size, lambda i: f"{i % 1000 * .01:.2f} {i // 1000 * .01:.2f} 0\n")
    return {
        "many points.xyz": grid,
        "points far apart.xyz": lines(size, lambda i: f"{i * 1e3:.0f} {-i * 1e3:.0f} 0\n"),
        "one long line.xyz": "0 " * (size // 2),
        "one place.xyz": "0 0 0\n" * (size // 6),
        "promised points.pcd": PCD.format(many, "binary"),
        "promised points in text.pcd": PCD.format(many, "ascii") + grid,
        "promised bytes.pcd": PCD.format(many, "binary_compressed") + "\xff" * 8,
        "many fields.pcd": PCD.format(1, "ascii").replace("x y z", "x y z" + " a" * (size // 2)),
        "zeros in lzf.pcd": (PCD.format(50 * size // 12, "binary_compressed").encode()
                             + struct.pack("<II", size // 4 * 3 + 2, 50 * size // 12 * 12)
                             + b"\0\0" + b"\xe0\xff\0" * (size // 4)),
        "promised points.ply": PLY.format(many, "binary_little_endian"),
        "promised list.ply": PLY.format(1, "binary_little_endian").replace("end_header", "property list uint uchar l\nend_header")
                             + "\0" * 12 + "\xff" * 4,
        "many elements.ply": PLY.format(1, "ascii").replace(
            "end_header", lines(size, lambda i: f"element e{i} 0\nproperty float a\n") + "end_header") + "0 0 0\n",
    }


def drives(size, scenes):
    header, row, *_ = scenes.splitlines()
    return {
        "many lines": header + "\n" + lines(size, lambda i: row + "\n"),
        "many drives": header + "\n" + lines(size, lambda i: f"{i}" + row[row.index(","):] + "\n"),
        "many columns": header + lines(size, lambda i: f",c{i}") + "\n" + row + "\n",
    }


def database(path, size):
    """Makes a bag of ROS 2 with many topics, and one message whose text seems to have 4 GB."""
    with sqlite3.connect(path) as bag:
        bag.executescript(
            "CREATE TABLE topics(id INTEGER PRIMARY KEY, name TEXT, type TEXT, serialization_format TEXT, offered_qos_profiles TEXT);"
            "CREATE TABLE messages(id INTEGER PRIMARY KEY, topic_id INTEGER, timestamp INTEGER, data BLOB);")
        bag.executemany("INSERT INTO topics VALUES(?, ?, 'sensor_msgs/msg/JointState', 'cdr', '')",
                        ((i + 1, f"/t{i}") for i in range(size // 60)))
        bag.execute("INSERT INTO messages VALUES(1, 1, 0, ?)", (b"\0\1\0\0" + bytes(8) + b"\xff" * 4 + b"x" * 100,))
    return path


def all_readers(folder, size, program, source):
    """Makes the files in the folder. program: terratact. source: the source tree."""

    def written(name, content):
        path = folder / name
        path.write_bytes(content if isinstance(content, bytes) else content.encode())
        return path

    scenes, two_tracks, poses, out = folder / "few.csv", folder / "few_tracks.csv", folder / "poses.csv", folder / "out"
    subprocess.run([program, "simulate", "--terrain", "varied", "--count", "3", "--seed", "5", "--out", scenes], check=True,
                   stdout=subprocess.DEVNULL)
    subprocess.run([program, "simulate", "--terrain", "varied", "--tracks", "--count", "3", "--seed", "5", "--out", two_tracks,
                    "--cloud", folder / "cloud.pcd", "--poses", poses], check=True, stdout=subprocess.DEVNULL)
    for title, content in scene_files(size, scenes.read_text()).items():
        path = written("s.csv", content)
        yield f"scenes: {title}", path, ("contacts", "--data", path)
    for title, content in profiles(size).items():
        path = written("p.csv", content)
        yield f"profile: {title}", path, ("simulate", "--terrain", path, "--count", "1", "--out", out)
    for title, content in grounds(size).items():
        path = written("g.csv", content)
        yield f"ground: {title}", path, ("simulate", "--tracks", "--terrain", path, "--count", "1", "--out", out)
    for name, content in clouds(size).items():
        path = written(name, content.encode("latin-1") if isinstance(content, str) else content)
        yield f"cloud: {name}", path, ("truth", path, "--scenes", scenes, "--poses", poses, "--out", out)
    small_cloud = written("few.xyz", "0 0 0\n1 0 0\n")
    for title, content in {"many": lines(size, lambda i: f"{i}.0 0 0 0 0 0 0 1\n"), "one long line": "1 " * (size // 2),
                           "one time": "1.0 0 0 0 0 0 0 1\n" * (size // 18)}.items():
        path = written("poses.tum", content)
        yield f"poses: {title}", path, ("truth", small_cloud, "--scenes", scenes, "--poses", path, "--out", out)
    path = written("decisions.csv", "row,run,decision,offset_m,tilt_rad,along_m\n" + lines(size, lambda i: f"{i + 1},1,accept,0,0,0\n"))
    yield "decisions: many", path, ("truth", folder / "cloud.pcd", "--scenes", two_tracks, "--poses", poses, "--decisions", path, "--out", out)
    for kind, options in (("drives", ()), ("two-track drives", ("--tracks",))):
        few = folder / "few_drives.csv"
        subprocess.run([program, "simulate", "--drives", "1", *options, "--terrain", "varied", "--seed", "5", "--out", few],
                       check=True, stdout=subprocess.DEVNULL)
        for title, content in drives(size, few.read_text()).items():
            path = written("d.csv", content)
            yield f"{kind}: {title}", path, ("truth", small_cloud, "--scenes", path, "--poses", poses, "--out", out)
    header, row, *_ = two_tracks.read_text().splitlines()
    path = written("tracks.csv", header + "\n" + lines(size // 4, lambda i: row + "\n"))
    yield "scenes of two tracks: many", path, ("truth", folder / "cloud.pcd", "--scenes", path, "--poses", poses, "--out", out)
    for title, content in toml_files(65_000, "").items():
        path = written("m.toml", content)
        yield f"mapping: {title}", path, ("import", written("few_rows.csv", "t,a\n1,1\n"), "--mapping", path, "--check")
    yield "recording: many topics.db3", database(folder / "many topics.db3", size), ("import", folder / "many topics.db3", "--probe")
    path = written("n.ttn", pathlib.Path(source, "resources/models/default.ttn").read_bytes()[:size])
    yield "networks: cut", path, ("evaluate", "--drives", few, "--trail", path, "--methods", "trail")
    path = written("probes.csv", "place,height_m,truth_m\n" + lines(size, lambda i: f"p{i},0.1,0.1\n"))
    yield "probes: many places", path, ("probes", "--data", path)
    path = written("c.csv", "side,element,force_n,voltage_v\n" + lines(size, lambda i: "left,1,10,1.5\n"))
    yield "calibration: many rows", path, ("calibrate", "--data", path)
    path = written("classes.csv", "row,class\n" + lines(size, lambda i: f"{i + 1},c{i}\n"))
    yield "classes: many", path, ("evaluate", "--data", scenes, "--classes", path, "--methods", "local", "--out", out)
    for name, content in logs(size).items():
        path = written(name, content)
        yield f"log: {name}", path, ("can", "decode", path, "--summary")
        yield f"log to a session: {name}", path, ("session", "import", path, "--out", folder / f"{name}.tts")
    for name, content in recordings(size).items():
        path = written(name, content)
        yield f"recording: {name}", path, ("import", path, "--probe")
    log = written("small.log", FRAME)
    for title, content in dbc_files(size).items():
        path = written("d.dbc", content)
        yield f"DBC: {title}", path, ("can", "decode", log, "--summary", "--dbc", path)
    path, log = written("d.dbc", dbc_files(size)["many signals"]), written("many.log", FRAME * (size // len(FRAME)))
    yield "DBC: many signals of many frames", path, ("can", "decode", log, "--summary", "--dbc", path)
    path, log = written("d.dbc", many_ranges(size)), written("selected.log", SELECTED * 1000)
    yield "DBC: many ranges for many signals", path, ("can", "decode", log, "--dbc", path)
    path, log = written("d.dbc", repeated_texts()), written("few.log", FRAME * 5000)
    yield "DBC: repeated texts", log, ("can", "decode", log, "--dbc", path)
    yield "DBC: repeated texts in a table", log, ("can", "decode", log, "--dbc", path, "--csv", folder / "values.csv")
    robot = pathlib.Path(source, "resources/robots/absolem.toml").read_text()
    small = toml_files(65_000 - len(robot.encode()), robot)  # of at most 64 KiB
    for title, content in {**small, "too large": robot + "#" * size}.items():
        path = written("r.toml", content)
        yield f"robot: {title}", path, ("simulate", "--terrain", "varied", "--count", "1", "--robot", path, "--out", out)
        yield f"panel: {title}", path, ("panel", "check", path)
    model = written("m.ttm", pathlib.Path(source, "resources/models/default.ttm").read_bytes())
    for title, content in toml_files(size, "").items():
        yield f"card: {title}", written("m.card.toml", content), ("model", "show", model)
    session = written("n.tts", pathlib.Path(source, "resources/sessions/demo.tts").read_bytes())
    path = written("n.tts.notes.csv", "t_s,note\n" + "1,x\n" * (size // 4))
    yield "notes: many", path, ("session", "info", session)
