"""Tests that no small file asks for much memory or time. As a program it prints the cost of every reader:

    tests/hostile/run.sh --texts [BUILD]
"""

import itertools
import pathlib
import sys
import tempfile
import unittest

from cost import Cost
from hostile_binaries import more_readers
from hostile_texts import all_readers
from support import CLI, SOURCE, Folder, needs_no_sanitizer

SIZE = 1_000_000
BASE_MEGABYTES, BYTES_PER_BYTE = 50.0, 30.0  # a model takes 40 MB
BASE_SECONDS, SECONDS_PER_MEGABYTE = 4.0, 2.0


def readers(folder, size):
    return itertools.chain(all_readers(folder, size, CLI, SOURCE), more_readers(folder, size, CLI, SOURCE))


class ReaderCosts(Folder):
    def test_memory_and_time_are_bounded_by_the_size(self):
        needs_no_sanitizer(self)
        for title, path, arguments in readers(self.path, SIZE):
            with self.subTest(title):
                megabytes = path.stat().st_size / 1e6
                done = Cost(CLI, *arguments)
                self.assertIn(done.code, (0, 1), done.said[-500:])
                self.assertLess(done.megabytes, BASE_MEGABYTES + BYTES_PER_BYTE * megabytes)
                self.assertLess(done.seconds, BASE_SECONDS + SECONDS_PER_MEGABYTE * megabytes)


def table(size):
    print(f"{'reader':<44} {'bytes':>8} {'status':>6} {'CPU [s]':>8} {'peak [MB]':>9}  last words")
    with tempfile.TemporaryDirectory() as name:
        for title, path, arguments in readers(pathlib.Path(name), size):
            size, done = path.stat().st_size, Cost(CLI, *arguments)
            print(f"{title:<44} {size:>8} {done.code:>6} {done.seconds:>8.2f} {done.megabytes:>9.0f}  "
                  f"{done.last_words(name)}", flush=True)


if __name__ == "__main__":
    if "--table" in sys.argv:
        table(4 * SIZE)
    else:
        unittest.main()
