"""Reads MCAP files."""

import struct


class Mcap:
    """A reader of MCAP files, written from the specification without the writer's code."""

    MAGIC = b"\x89MCAP0\r\n"
    NAMES = {1: "header", 2: "footer", 3: "schema", 4: "channel", 5: "message", 6: "chunk", 7: "message index",
             8: "chunk index", 11: "statistics", 12: "metadata", 13: "metadata index", 14: "summary offset",
             15: "data end"}

    def __init__(self, path):
        self.bytes = path.read_bytes()
        assert self.bytes[:8] == self.MAGIC and self.bytes[-8:] == self.MAGIC
        self.records = list(self.split(self.bytes, 8, len(self.bytes) - 8))

    def split(self, data, at, end):
        """Yields (offset, name, content) of the records."""
        while at < end:
            opcode, length = struct.unpack_from("<BQ", data, at)
            assert at + 9 + length <= end, "a record is longer than what holds it"
            yield at, self.NAMES[opcode], data[at + 9:at + 9 + length]
            at += 9 + length
        assert at == end

    def of(self, name):
        return [(at, content) for at, n, content in self.records if n == name]

    @staticmethod
    def text(content, at):
        length, = struct.unpack_from("<I", content, at)
        assert at + 4 + length <= len(content)
        return content[at + 4:at + 4 + length].decode(), at + 4 + length

    @staticmethod
    def pairs(content, at, form):
        """Returns the content of an array or map of pairs of numbers."""
        length, = struct.unpack_from("<I", content, at)
        body = content[at + 4:at + 4 + length]
        assert len(body) == length and length % struct.calcsize(form) == 0
        return list(struct.iter_unpack(form, body)), at + 4 + length
