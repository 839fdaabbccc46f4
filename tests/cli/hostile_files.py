"""Session files that attack their readers. Each is small and demands far more memory or time than its size, or prints
text that deceives an operator. As a program it makes them and prints time and peak memory of each command:

    tests/hostile/run.sh [BUILD]
"""

import hashlib
import os
import pathlib
import shutil
import sqlite3
import struct
import subprocess
import sys
import tempfile

from cost import Cost

ROW_TABLES = ("settings", "model", "scene", "scene_truth", "estimate", "reading", "estimate_bin", "proposal",
              "proposal_offer", "event")
TABLES = ROW_TABLES + ("batch", "can_frame", "estimate_draws")
OUTPUTS = {"export": "out.csv", "scenes": "out.csv", "strip": "out.csv", "report": "out.html", "merge": "out.tts",
           "recover": "out.tts"}
ESCAPE = "\x1b[2K\rholds      yes\x1b[8m"


# -- A forger who knows docs/sessions.md recomputes every hash. ---------------------------------------------------------

def canonical(value):
    """Returns a value in the canonical form of the hash chain."""
    if value is None:
        return struct.pack("<Q", 5)
    if isinstance(value, int):
        return struct.pack("<QQ", 1, value & (2**64 - 1))
    if isinstance(value, float):
        return struct.pack("<Qd", 2, value + 0.0)
    kind, data = (3, value.encode()) if isinstance(value, str) else (4, value)
    return struct.pack("<QQ", kind, len(data)) + data


def rows_hash(file, batch):
    tables = b""
    for table in ROW_TABLES:
        digest = hashlib.sha256()
        for row in file.execute(f"SELECT * FROM {table} WHERE batch = ? ORDER BY id", (batch,)):
            digest.update(b"".join(map(canonical, row)))
        tables += digest.digest()
    return hashlib.sha256(tables).digest()


def forge(file, known=None):
    """Recomputes hashes and chain. known: rows_hash of batches that need no computing."""
    meta = b"".join(canonical(key) + canonical(value)
                    for key, value in file.execute("SELECT key, value FROM meta ORDER BY key"))
    chain = hashlib.sha256(meta).digest()
    for row in file.execute("SELECT * FROM batch ORDER BY id").fetchall():
        number, first, last, frame, count = row[:5]
        frames = hashlib.sha256()
        for values in file.execute("SELECT * FROM can_frame WHERE seq >= ? AND seq < ? ORDER BY seq",
                                   (frame, frame + count)):
            frames.update(b"".join(map(canonical, values)))
        rows = (known or {}).get(number) or rows_hash(file, number)
        link = b"".join(map(canonical, (chain, number, first, last, frame, count, frames.digest(), rows)))
        chain = hashlib.sha256(link).digest()
        file.execute("UPDATE batch SET frames_hash = ?, rows_hash = ?, chain = ? WHERE id = ?",
                     (frames.digest(), rows, chain, number))
    file.commit()


def changed(base, path, *statements):
    """Returns a copy of a session after executing statements, with every hash recomputed."""
    shutil.copy(base, path)
    file = sqlite3.connect(path)
    for sql, *values in statements:
        file.execute(sql, values)
    forge(file)
    file.close()
    return path


# -- These pages would never be written by SQLite. ----------------------------------------------------------------------

def varint(value):
    out = [value & 0x7F]
    while value := value >> 7:
        out.append(value & 0x7F | 0x80)
    return bytes(reversed(out))


def record(values):
    header, body = b"", b""
    for value in values:
        if value is None:
            header += varint(0)
        elif isinstance(value, int):
            header, body = header + varint(6), body + struct.pack(">q", value)
        elif isinstance(value, float):
            header, body = header + varint(7), body + struct.pack(">d", value)
        else:
            data = value.encode() if isinstance(value, str) else value
            header, body = header + varint(12 + 2 * len(data) + isinstance(value, str)), body + data
    return varint(len(header) + 1) + header + body


class Pages:
    """The pages of an SQLite file, for modification."""

    def __init__(self, path):
        self.path = path
        data = path.read_bytes()
        self.size = struct.unpack(">H", data[16:18])[0]
        self.pages = [bytearray(data[i:i + self.size]) for i in range(0, len(data), self.size)]

    def add(self, page):
        self.pages.append(bytearray(page.ljust(self.size, b"\0")))
        return len(self.pages)

    def write(self):
        self.pages[0][28:32] = struct.pack(">I", len(self.pages))
        self.pages[0][24:28] = self.pages[0][92:96] = struct.pack(">I", 77)
        self.path.write_bytes(b"".join(self.pages))

    def leaf(self, cells):
        page = bytearray(self.size)
        end = self.size
        for i, cell in enumerate(cells):
            end -= len(cell)
            page[end:end + len(cell)] = cell
            page[8 + 2 * i:10 + 2 * i] = struct.pack(">H", end)
        page[0:8] = struct.pack(">BHHHB", 13, 0, len(cells), end, 0)
        return page

    def inner(self, children):
        """Writes an inner page. children: (page, largest rowid)."""
        page = bytearray(self.size)
        end = self.size
        for i, (child, row) in enumerate(children[:-1]):
            cell = struct.pack(">I", child) + varint(row)
            end -= len(cell)
            page[end:end + len(cell)] = cell
            page[12 + 2 * i:14 + 2 * i] = struct.pack(">H", end)
        page[0:12] = struct.pack(">BHHHBI", 5, 0, len(children) - 1, end, 0, children[-1][0])
        return page

    def overflow(self, data):
        """Writes a chain of overflow pages; returns the number of the first."""
        room = self.size - 4
        chunks = [data[i:i + room] for i in range(0, len(data), room)]
        first = len(self.pages) + 1
        for i, chunk in enumerate(chunks):
            self.add(struct.pack(">I", first + i + 1 if i + 1 < len(chunks) else 0) + chunk)
        return first

    def local(self, size):
        """Returns how many bytes of a payload are stored in the cell."""
        most, least = self.size - 35, (self.size - 12) * 32 // 255 - 23
        if size <= most:
            return size
        there = least + (size - least) % (self.size - 4)
        return there if there <= most else least

    def put_tree(self, root, cells):
        """Writes leaves below the root. cells: (rowid, bytes), ascending."""
        level, leaf, room = [], [], self.size - 16
        for row, cell in cells + [(None, None)]:
            if leaf and (cell is None or sum(len(c) + 2 for _, c in leaf) + len(cell) + 2 > room):
                level.append((self.add(self.leaf([c for _, c in leaf])), leaf[-1][0]))
                leaf = []
            if cell is not None:
                leaf.append((row, cell))
        fan = (self.size - 16) // 16
        while len(level) > fan:
            level = [(self.add(self.inner(level[i:i + fan])), level[min(i + fan, len(level)) - 1][1])
                     for i in range(0, len(level), fan)]
        self.pages[root - 1][:] = self.inner(level + [level[-1]] if len(level) == 1 else level)

    def repeat(self, root, leaves, depth):
        """Puts a tree below the root. Its leaves take turns, and all inner pages of a level are one page."""
        fan = (self.size - 16) // 16
        for _ in range(depth):
            leaves = [self.add(self.inner([(leaves[i % len(leaves)], 1 + i) for i in range(fan)]))]
        self.pages[root - 1][:] = self.pages[leaves[0] - 1]


def small_pages(base, path, size=1024):
    """Makes the session with small pages, so that many cells use overflow pages."""
    shutil.copy(base, path)
    file = sqlite3.connect(path)
    file.execute(f"PRAGMA page_size = {size}")
    file.execute("VACUUM")
    file.close()
    return path


def root_of(path, table):
    file = sqlite3.connect(path)
    root = file.execute("SELECT rootpage FROM sqlite_schema WHERE name = ?", (table,)).fetchone()[0]
    file.close()
    return root


def last_batch(path):
    file = sqlite3.connect(path)
    row = file.execute("SELECT id, t_last FROM batch ORDER BY id DESC LIMIT 1").fetchone()
    file.close()
    return row


def shared_texts(base, path, rows, length):
    """Makes events that share one long text: the cells of all rows use one chain of overflow pages. Every hash is
    valid."""
    small_pages(base, path)
    text = "x" * length
    number, when = last_batch(path)
    file = sqlite3.connect(path)
    first_row = file.execute("SELECT max(id) FROM event").fetchone()[0] + 1
    before = [(row[0], row) for row in file.execute("SELECT * FROM event ORDER BY id")]
    new = [(first_row + i, (first_row + i, number, when, "word", "", text, None, 0, 0, "")) for i in range(rows)]
    digest = hashlib.sha256()
    for row in [row for _, row in before if row[1] == number]:
        digest.update(b"".join(map(canonical, row)))
    prefix = {i: b"".join(map(canonical, row)) for i, row in new}
    for i, _ in new:
        digest.update(prefix[i])
    tables = b""
    for table in ROW_TABLES[:-1]:
        one = hashlib.sha256()
        for row in file.execute(f"SELECT * FROM {table} WHERE batch = ? ORDER BY id", (number,)):
            one.update(b"".join(map(canonical, row)))
        tables += one.digest()
    forge(file, {number: hashlib.sha256(tables + digest.digest()).digest()})
    file.close()

    pages = Pages(path)
    cells, chain = [], None
    for row, values in before + new:
        payload = record((None,) + values[1:])
        local = pages.local(len(payload))
        cell = varint(len(payload)) + varint(row) + payload[:local]
        if local < len(payload):
            chain = chain or pages.overflow(payload[local:])
            cell += struct.pack(">I", chain)
        cells.append((row, cell))
    pages.put_tree(root_of(path, "event"), cells)
    pages.write()
    return path


def shared_draws(base, path, count):
    """Makes estimates that share their draws: their rows use one chain of overflow pages. Every hash is valid."""
    small_pages(base, path)
    number, _ = last_batch(path)
    file = sqlite3.connect(path)
    columns = [name for _, name, *_ in file.execute("PRAGMA table_info(estimate)")]
    others = ", ".join(columns[2:])
    bins = ", ".join([name for _, name, *_ in file.execute("PRAGMA table_info(estimate_bin)")][3:])
    source, draws = file.execute("SELECT id, draws FROM estimate_draws ORDER BY length(draws) DESC LIMIT 1").fetchone()
    first = file.execute("SELECT max(id) FROM estimate").fetchone()[0] + 1
    for i in range(first, first + count):
        file.execute(f"INSERT INTO estimate SELECT {i}, {number}, {others} FROM estimate WHERE id = {source}")
        file.execute(f"INSERT INTO estimate_bin SELECT NULL, {number}, {i}, {bins} FROM estimate_bin "
                     f"WHERE estimate = {source}")
    stored = file.execute("SELECT id, draws FROM estimate_draws ORDER BY id").fetchall()
    forge(file)
    file.close()
    pages = Pages(path)
    cells, chains = [], {}
    for row, data in stored + [(i, draws) for i in range(first, first + count)]:
        payload = record((None, data))
        local = pages.local(len(payload))
        if payload not in chains:
            chains[payload] = pages.overflow(payload[local:])
        cells.append((row, varint(len(payload)) + varint(row) + payload[:local] + struct.pack(">I", chains[payload])))
    pages.put_tree(root_of(path, "estimate_draws"), cells)
    pages.write()
    return path


def shared_leaves(base, path, table, depth=6):
    """Makes a tree whose inner pages have one child, repeatedly: it has more rows than there are atoms."""
    shutil.copy(base, path)
    pages = Pages(path)
    root = root_of(path, table)
    leaf = pages.add(pages.leaf([]) if pages.pages[root - 1][0] != 13 else bytes(pages.pages[root - 1]))
    pages.repeat(root, [leaf], depth)
    pages.write()
    return path


def rare_events(base, path, kind, leaves=40):
    """Makes a tree of shared leaves of events: one event is of the kind in so many leaves."""
    shutil.copy(base, path)
    pages, (number, when) = Pages(path), last_batch(path)

    def leaf(kind, rows):
        payload = record((None, number, when, kind, "", "", None, 0, 0, "", "", ""))
        return pages.add(pages.leaf([varint(len(payload)) + varint(1 + i) + payload for i in range(rows)]))

    pages.repeat(root_of(path, "event"), [leaf("word", 80)] * (leaves - 1) + [leaf(kind, 1)], 6)
    pages.write()
    return path


def many_rows(base, path, count):
    """Makes as many small rows as fit, to measure the memory of the largest values."""
    shutil.copy(base, path)
    file = sqlite3.connect(path)
    number, when = last_batch(path)
    file.executemany("INSERT INTO event VALUES(NULL, ?, ?, 'word', '', '', NULL, 0, 0, '', '', '')", [(number, when)] * count)
    forge(file)
    file.close()
    return path


def make_all(folder, rows, drive, large):
    """Returns (name, file, commands) of each hostile file."""
    factor = 10 if large else 1
    escape = changed(rows, folder / "escapes.tts",
                     ("UPDATE meta SET value = ? WHERE key IN ('source', 'program', 'bus')", ESCAPE),
                     ("UPDATE model SET name = ?", ESCAPE))
    changed(drive, folder / "what-if.tts", ("UPDATE settings SET chains = 100000, burn_in = 10000000, method = 'pafc'",))
    shutil.copy(rows, folder / "cut.tts")
    os.truncate(folder / "cut.tts", os.path.getsize(rows) * 2 // 3)
    os.mkfifo(folder / "fifo.tts")
    every = ("info", "verify", "export", "what-if", "recover")
    return [
        ("texts that share pages", shared_texts(rows, folder / "texts.tts", 400 * factor, 500_000), every),
        ("short texts that share pages", shared_texts(rows, folder / "short.tts", 400 * factor, 60_000), every),
        ("draws that share pages", shared_draws(drive, folder / "draws.tts", 300 * factor), every),
        *((f"a tree of shared leaves: {table}", shared_leaves(rows, folder / f"{table}.tts", table), every)
          for table in TABLES),
        ("many small rows", many_rows(rows, folder / "many.tts", 20_000 * factor), ("info", "verify", "recover")),
        ("settings for days of computing", folder / "what-if.tts", ("what-if",)),
        ("escapes for the terminal", escape, ("info", "verify", "export", "recover")),
        ("a cut file", folder / "cut.tts", ("info", "recover")),
        ("a pipe", folder / "fifo.tts", ("info", "recover")),
        ("an endless device", pathlib.Path("/dev/zero"), ("info", "recover")),
    ]


def cost(program, command, file, folder):
    """Returns the cost of a session command. What it writes replaces OUTPUTS of the folder."""
    if command not in OUTPUTS:
        return Cost(program, "session", command, file)
    out = folder / OUTPUTS[command]
    out.unlink(missing_ok=True)
    return Cost(program, "session", command, file, "--out", out)


def main():
    program, make = sys.argv[1:3]
    large = "--large" in sys.argv
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        for kind in ("rows", "drive"):
            subprocess.run([make, kind, folder / f"{kind}.tts"], check=True)
        files = make_all(folder, folder / "rows.tts", folder / "drive.tts", large)
        print(f"{'file':<34} {'bytes':>9} {'command':<8} {'status':>6} {'CPU [s]':>8} {'peak [MB]':>9}  last words")
        for title, file, commands in files:
            for command in commands:
                run = cost(program, command, file, folder)
                print(f"{title:<34} {file.stat().st_size:>9} {command:<8} {run.code:>6} {run.seconds:>8.2f} "
                      f"{run.megabytes:>9.0f}  {run.last_words(name)}", flush=True)


if __name__ == "__main__":
    sys.exit(main())
