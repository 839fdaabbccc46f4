"""Models, networks, parts, sessions, logs and compressed recordings that attack their readers, and files from which a
command computes much.

more_readers() yields the same as all_readers() of hostile_texts.
"""

import pathlib
import shutil
import struct
import subprocess

from hostile_files import shared_leaves
from hostile_texts import BAG, bag_record, clouds, lines, mcap, mcap_channel, mcap_message, mcap_schema, mcap_text

ZEROS = 128 << 10  # bytes of one block of a zstd frame
POINT_CLOUD = b"""Header header
uint32 height
uint32 width
PointField[] fields
bool is_bigendian
uint32 point_step
uint32 row_step
uint8[] data
bool is_dense
===
MSG: std_msgs/Header
uint32 seq
time stamp
string frame_id
===
MSG: sensor_msgs/PointField
string name
uint32 offset
uint8 datatype
uint32 count
"""


def zstd_zeros(blocks):
    """Returns a zstd frame of 4 bytes for each 128 KiB of zeros."""
    block = struct.pack("<I", ZEROS << 3 | 1 << 1)[:3] + b"\0"  # one byte, repeated
    last = struct.pack("<I", ZEROS << 3 | 1 << 1 | 1)[:3] + b"\0"
    return b"\x28\xb5\x2f\xfd" + b"\0" + b"\x38" + block * (blocks - 1) + last


def lz4_zeros(blocks):
    """Returns an LZ4 frame of 270 bytes for each 65 050 zeros."""
    block = b"\x1f\0\1\0" + b"\xff" * 254 + b"\xff\0" + b"\x50" + bytes(5)
    return b"\x04\x22\x4d\x18\x60\x40\x82" + (struct.pack("<I", len(block)) + block) * blocks + bytes(4)


def mcap_packed(method, packed, size):
    return 6, struct.pack("<QQQI", 0, 0, size, 0) + mcap_text(method) + struct.pack("<Q", len(packed)) + packed


def packed_recordings(size):
    """Makes chunks that expand to many empty records, to more than a reader takes, or to more than they declare."""
    start = mcap_channel(1, 0, b"json"), mcap_message(1, b"1")
    zstd, lz4 = zstd_zeros(126), lz4_zeros(252)  # almost 16 MiB, and a whole number of records of 9 bytes
    large_zstd, large_lz4 = zstd_zeros(400 * size // ZEROS), lz4_zeros(size // 540)
    zstd_size, lz4_size = 126 * ZEROS, 252 * 65_050

    def bag_lz4(packed, declared):
        return bag_record(packed, op=b"\x05", compression=b"lz4", size=struct.pack("<I", declared))

    return {
        "empty records in zstd.mcap": mcap(*start, *[mcap_packed(b"zstd", zstd, zstd_size)] * 400),
        "empty records in lz4.mcap": mcap(*start, *[mcap_packed(b"lz4", lz4, lz4_size)] * (size // 2 // len(lz4))),
        "empty records in lz4.bag": BAG + bag_lz4(lz4, lz4_size) * (size // 2 // len(lz4)),
        "zeros in zstd.mcap": mcap(*start, *[mcap_packed(b"zstd", large_zstd, 400 * size)] * 20),
        "more in zstd than declared.mcap": mcap(*start, *[mcap_packed(b"zstd", large_zstd, 10)] * 20),
        "more in lz4 than declared.mcap": mcap(*start, *[mcap_packed(b"lz4", large_lz4, 10)] * 2),
        "2^60 bytes declared in zstd.mcap": mcap(*start, *[mcap_packed(b"zstd", large_zstd, 1 << 60)] * 20),
        "zeros in lz4.bag": BAG + bag_lz4(large_lz4, size // 540 * 65_050) * 2,
    }


def more_logs(size):
    return {
        "identifiers_1_1.trc": ";$FILEVERSION=1.1\n;$STARTTIME=45000\n"
                               + lines(size, lambda i: f"{i}) {i * .1:.1f} Rx {i:08X} 1 00\n"),
        "columns.trc": ";$FILEVERSION=2.1\n;$STARTTIME=45000\n;$COLUMNS=" + "N," * (size // 2)
                       + "T\n1 1 DT 1 Rx 1 00\n",
        "python_can.csv": "timestamp,arbitration_id,extended,remote,error,dlc,data\n"
                          + lines(size, lambda i: f"{i}.0,0x{i:x},1,0,0,8,AAAAAAAAAAA=\n"),
        "headless.csv": lines(size, lambda i: f"{i},{i:08X},true,Rx,0,1,00,,,,,,,\n"),
    }


def point_clouds(size):
    """Makes recordings of PointCloud2 messages."""
    fields = b"".join(mcap_text(name) + struct.pack("<IBI", 4 * i, 7, 1) for i, name in enumerate((b"x", b"y", b"z")))

    def recording(rows, columns, step, count, data=bytes(16)):
        message = (struct.pack("<III", 0, 1, 0) + mcap_text(b"map") + struct.pack("<II", rows, columns)
                   + struct.pack("<I", 3) + fields + b"\0" + struct.pack("<II", step, step * columns & 0xFFFFFFFF)
                   + mcap_text(data) + b"\1")
        return mcap(mcap_schema(1, b"sensor_msgs/PointCloud2", POINT_CLOUD), mcap_channel(1, 1, b"ros1", b"/c"),
                    *[mcap_message(1, message)] * count)

    return {"no bytes per point": recording(65535, 65535, 0, 200),
            "promised points": recording(65535, 65535, 12, 200),
            "no points": recording(0, 0, 12, size // 200), "many points": recording(1, size // 12, 12, 1, bytes(size))}


def other_times(recording, times):
    """Returns an MCAP without chunks whose n-th message has the time times(n) [ns]."""
    out, position, count = bytearray(recording), 8, 0
    while position + 9 <= len(out):
        kind, length = struct.unpack_from("<BQ", out, position)
        if kind == 5:
            struct.pack_into("<Q", out, position + 15, times(count))
            count += 1
        position += 9 + length
    return bytes(out)


def junk(size, begin):
    """Returns contents of files that SQLite would have to read. begin: a whole file."""
    return {"junk": b"\xff" * size, "a header and junk": begin[:100] + b"\xff" * size,
            "half of a file": begin[:len(begin) // 2]}


def more_readers(folder, size, program, source):
    """Makes the files in the folder. program: terratact. source: the source tree."""
    resources = pathlib.Path(source, "resources")

    def written(name, content):
        path = folder / name
        path.write_bytes(content if isinstance(content, bytes) else content.encode())
        return path

    def made(*arguments):
        subprocess.run([program, *map(str, arguments)], check=True, capture_output=True)

    scenes, tracks, drives, out = folder / "one.csv", folder / "two.csv", folder / "drives.csv", folder / "out.csv"
    cloud, poses, recording = folder / "cloud.pcd", folder / "poses.csv", folder / "drive.mcap"
    made("simulate", "--terrain", "boxes", "--count", 40, "--seed", 3, "--out", scenes)
    made("simulate", "--terrain", "varied", "--tracks", "--count", 3, "--seed", 5, "--out", tracks, "--cloud", cloud,
         "--poses", poses, "--recording", recording, "--floor-poses")
    made("simulate", "--terrain", "varied", "--drives", 1, "--seed", 5, "--out", drives)
    made("train", "--data", scenes, "--bins", 5, "--out", folder / "p.ttp")
    header, row, *_ = scenes.read_text().splitlines()
    few = written("few.csv", f"{header}\n{row}\n")
    made("evaluate", "--data", few, "--methods", "local", "--shard", "1/1", "--out", folder)

    def merge(path):
        return "merge", path, "--out", folder / "merged.ttm"

    def show(path):
        return "model", "show", path

    def trail(path):
        return "evaluate", "--drives", drives, "--methods", "trail", "--trail", path

    part, model = folder / "part_1_of_1.tte", resources / "models/default.ttm"
    for base, tables, command in (
            (part, ("scene", "bin_error", "meta", "content"), merge),
            (folder / "p.ttp", ("training_row", "scanned_row"), merge),
            (model, ("training_row", "side_row", "surface_input"), show),
            (resources / "models/default.ttn", ("error", "layer"), trail)):
        for title, content in junk(size, base.read_bytes()).items():
            path = written("junk" + base.suffix, content)
            yield f"{base.suffix}: {title}", path, command(path)
        for table in tables:
            path = shared_leaves(base, folder / ("tree" + base.suffix), table)
            yield f"{base.suffix}: a tree of shared leaves: {table}", path, command(path)
    shutil.copy(model, folder / "m.ttm")
    for title, content in {"many": "model,method\n" + lines(size, lambda i: f"m{i},local\n"),
                           "one long line": "m," * (size // 2)}.items():
        path = written("m.presets.csv", content)
        yield f"presets: {title}", path, ("reconstruct", "--data", few, "--model", folder / "m.ttm",
                                          "--quality", "fast", "--out", out)

    for name, content in more_logs(size).items():
        path = written(name, content)
        yield f"log: {name}", path, ("can", "decode", path, "--summary")
        yield f"log to a session: {name}", path, ("session", "import", path, "--out", folder / f"{name}.tts")

    mapping = resources / "mappings/simulated_robot.toml"
    for name, content in packed_recordings(size).items():
        path = written(name, content)
        yield f"recording: {name}", path, ("import", path, "--probe")
        yield f"mapped recording: {name}", path, ("import", path, "--mapping", mapping, "--check")
    whole = recording.read_bytes()
    for title, times in {"one time": lambda i: 5, "years apart": lambda i: i * 10**15,
                         "backwards": lambda i: (1 << 62) - i, "the last time": lambda i: (1 << 64) - 1}.items():
        path, session = written("times.mcap", other_times(whole, times)), folder / f"{title}.tts"
        yield f"mapped recording: {title}", path, ("import", path, "--mapping", mapping, "--out", session,
                                                   "--scenes", out)
        if session.exists():
            yield f"robot check: {title}", session, ("robot", "check", resources / "robots/absolem.toml",
                                                     "--recordings", session)

    way = written("way.tum", "".join(f"{i / 10} {i / 30} 0 0 0 0 0 1\n" for i in range(200)))
    truth = "--scenes", tracks, "--poses", way, "--out", out
    for title, content in point_clouds(size).items():
        path = written("clouds.mcap", content)
        yield f"PointCloud2: {title}", path, ("truth", path, "--topic", "/c", *truth)
    for name in ("many points.xyz", "points far apart.xyz", "promised points.pcd"):
        path = written("scan_0.5" + pathlib.Path(name).suffix, clouds(size)[name])
        yield f"laser scan: {name}", path, ("truth", path, "--scans", *truth)

    header, row, *_ = drives.read_text().splitlines()
    path = written("many.csv", header + "\n" + lines(size, lambda i: row + "\n"))
    yield "training: one place of many drives", path, ("train", "--drives", path, "--epochs", 1, "--networks", 1,
                                                       "--out", folder / "t.ttn")
    plane = "--plane", resources / "models/one_plane.ttm"
    for title, data, training, options in (("one plane", scenes, ("--data",), ()),
                                           ("two tracks", tracks, (*plane, "--tracks"), ("--tracks",))):
        header, row, *_ = data.read_text().splitlines()
        path = written("many.csv", header + "\n" + lines(size // 2, lambda i: row + "\n"))
        yield f"training: one scene many times, {title}", path, ("train", *training, path, "--out", folder / "t.ttm")
        yield f"estimates of one scene many times, {title}", path, (
            "reconstruct", "--data", path, *options, "--quality", "fast", "--out", out)

    demo = resources / "sessions/demo.tts"
    for title, content in junk(size, demo.read_bytes()).items():
        path = written("junk.tts", content)
        for command, file in (("report", "r.pdf"), ("strip", "s.csv"), ("scenes", "s.csv"), ("merge", "m.tts")):
            yield f"session {command}: {title}", path, ("session", command, path, "--out", folder / file)
