"""Tests `terratact session` with sessions whose program died and whose journal is damaged. Argument: make_session."""

import os
import pathlib
import random
import shutil
import sqlite3
import tempfile
import unittest

from session_support import make
from support import Folder, run

HEAD, FRAME = 32, 24 + 8192  # [bytes] header and frames of a journal


def setUpModule():
    make("long", Crashed.session)


def tearDownModule():
    Crashed.made.cleanup()


class Crashed(Folder):
    made = tempfile.TemporaryDirectory()
    session = pathlib.Path(made.name, "crashed.tts")

    def damaged(self, at, data, index=True):
        """Returns a copy of the crashed session whose journal holds this data at byte `at`; index: with its index."""
        for end in ("", "-wal", "-shm") if index else ("", "-wal"):
            shutil.copy(f"{self.session}{end}", self.path / f"hurt.tts{end}")
        path = self.path / "hurt.tts-wal"
        journal = bytearray(path.read_bytes())
        journal[at:at + len(data)] = data
        path.write_bytes(journal)
        return self.path / "hurt.tts"

    def contents(self):
        return {path.name: path.read_bytes() for path in self.path.iterdir() if path.suffix != ".tts-shm"}

    def check(self, path, said):
        """Every command says this of the journal, none changes or adds a file, and recover saves the rest."""
        before, names = self.contents(), sorted(os.listdir(self.path))
        info = run("session", "info", path)
        self.assertRegex(info, f"damage .*: {said}\n")
        self.assertRegex(info, "holds +NO")
        self.assertRegex(run("session", "verify", path, code=1), said)
        self.assertRegex(run("session", "list", self.path), f"  torn  .*  hurt.tts: {said}\n")
        self.assertEqual(sorted(os.listdir(self.path)), names)
        recovered = run("session", "recover", path)
        self.assertRegex(recovered, f"hurt.tts: is damaged: {said}\n")
        self.assertEqual({name: data for name, data in self.contents().items() if name in before}, before)
        saved = self.path / "hurt-recovered.tts"
        self.assertIn(": holds; ", run("session", "verify", saved))
        file = sqlite3.connect(saved)
        frames = file.execute("SELECT count(*) FROM can_frame").fetchone()[0]
        file.close()
        saved.unlink()
        return frames

    def test_a_damaged_journal_is_named_and_kept(self):
        journal = pathlib.Path(f"{self.session}-wal").read_bytes()
        noise = random.Random(1).randbytes(len(journal) - HEAD)
        at = HEAD + 3 * FRAME
        for data in (bytes(8192), noise[:8192]):
            for index in (False, True):
                path = self.damaged(at, data, index)
                self.assertGreater(self.check(path, f"its journal hurt.tts-wal is damaged from byte {at}: "
                                                    r"\d+ pages in it are not read"), 5000)
        pages = (len(journal) - HEAD) // FRAME
        for data in (bytes(len(noise)), noise):
            path = self.damaged(HEAD, data)
            self.assertEqual(self.check(path, f"its journal hurt.tts-wal is damaged from byte {HEAD}: "
                                              f"{pages} pages in it are not read"), 5000)

    def test_a_broken_journal_is_named_at_each_reading(self):
        size = os.path.getsize(f"{self.session}-wal")
        for index in (False, True):
            path = self.damaged(0, random.Random(2).randbytes(size), index)
            for _ in range(2):
                self.check(path, "its journal hurt.tts-wal is damaged from its beginning: .*")

    def test_older_pages_and_a_cut_end_are_no_damage(self):
        for kept in (None, HEAD + 5 * FRAME + 1000):
            path = self.damaged(0, b"", index=False)
            names = sorted(os.listdir(self.path))
            with open(f"{path}-wal", "r+b") as journal:
                journal.truncate(kept or os.path.getsize(f"{path}-wal"))
            self.assertRegex(run("session", "info", path), "holds +yes")
            self.assertEqual(sorted(os.listdir(self.path)), names)
            self.assertIn("recovered and closed", run("session", "recover", path))
            path.unlink()


if __name__ == "__main__":
    unittest.main()
