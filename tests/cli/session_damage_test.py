"""Tests `terratact session` with damaged files: cut, with holes, without journal, in read-only places, or hostile.
Argument: the program make_session, which records a simulated drive."""

import os
import pathlib
import shutil
import signal
import sqlite3
import stat
import subprocess
import sys
import tempfile
import time
import unittest
from concurrent.futures import ThreadPoolExecutor

import hostile_files
from cost import Cost
from support import CLI, SOURCE, complaint, run

MAKE = sys.argv.pop(1)
NOBODY = 65534


def make(kind, path):
    subprocess.run([MAKE, kind, path], check=True, timeout=300)


def frames_in(path):
    file = sqlite3.connect(f"file:{path}?mode=ro", uri=True)
    count = file.execute("SELECT count(*) FROM can_frame").fetchone()[0]
    file.close()
    return count


def setUpModule():
    make("drive", Damaged.drive)
    make("rows", Damaged.rows)


def tearDownModule():
    Damaged.made.cleanup()


def computed(pid):
    """Returns the processor time of a process [s]."""
    fields = pathlib.Path(f"/proc/{pid}/stat").read_text().rsplit(")", 1)[1].split()
    return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")


class Damaged(unittest.TestCase):
    made = tempfile.TemporaryDirectory()
    drive, rows = pathlib.Path(made.name, "drive.tts"), pathlib.Path(made.name, "rows.tts")

    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.path = pathlib.Path(self.folder.name)

    def damaged(self, change, name="hurt.tts"):
        """Returns the path of the drive after change(bytes, page size)."""
        path = self.path / name
        data = self.drive.read_bytes()
        path.write_bytes(change(bytearray(data), int.from_bytes(data[16:18], "big")))
        return path

    def recovered(self, path):
        """Returns recover's output; the new session is valid, and the old file is unchanged."""
        before = path.read_bytes()
        said = run("session", "recover", path)
        self.assertEqual(path.read_bytes(), before)
        out = path.with_name(path.stem + "-recovered.tts")
        self.assertIn(str(out), said)
        self.assertIn(": holds; ", run("session", "verify", out))
        return said, out


class Recover(Damaged):
    def test_refusals_of_damaged_sessions_name_recover(self):
        cut = self.damaged(lambda data, page: data[:len(data) // 2])
        hint = "; `terratact session recover` saves what is whole in it"
        for command in (["info"], ["export", "--out", self.path / "out.csv"], ["scenes", "--out", self.path / "out.csv"],
                        ["report", "--out", self.path / "out.pdf"], ["strip", "--out", self.path / "out.csv"]):
            self.assertIn("it is truncated, copy it again" + hint, complaint("session", command[0], cut, *command[1:]))
        self.assertEqual(os.listdir(self.path), [cut.name])
        newer = self.damaged(lambda data, page: data[:60] + bytes([0, 0, 0, 99]) + data[64:])
        self.assertNotIn("recover", complaint("session", "info", newer))

    def test_too_few_open_files_are_not_called_damage(self):
        live = self.path / "open.tts"
        make("open", live)
        merge = ["merge", live, self.drive, "--out", self.path / "merged.tts"]  # a sealed session needs one file alone
        for session, command in ((live, ["info", live]), (self.drive, merge)):
            said = [subprocess.run(["bash", "-c", f'ulimit -n {most}; exec "$@"', "-", CLI, "session", *command],
                                   capture_output=True, text=True, timeout=300).stderr for most in range(4, 12)]
            self.assertTrue(any("Too many open files" in one and pathlib.Path(session).name in one for one in said), said)
            self.assertNotIn("session recover", "".join(said))

    def test_a_cut_session_yields_what_is_before_the_cut(self):
        said, out = self.recovered(self.damaged(lambda data, page: data[:len(data) * 9 // 10]))
        self.assertIn("it is truncated", said)
        self.assertNotIn("session recover", said)
        self.assertRegex(said, r"lost +(\d+ batch|estimate)")
        self.assertGreater(frames_in(out), frames_in(self.drive) // 10)
        text = sqlite3.connect(out).execute("SELECT text FROM event WHERE subject = 'recovered'").fetchone()[0]
        self.assertIn("what was whole in hurt.tts", text)
        self.assertRegex(run("session", "info", out), r"source +SIMULATED ROBOT, bus can0")

    def test_holes_and_zeroed_pages_lose_only_their_rows(self):
        def hole(data, page):
            data[30 * page:31 * page] = bytes(page)
            return data
        said, out = self.recovered(self.damaged(hole))
        self.assertRegex(said, r"lost +\d+ batch|left out|draws are not whole")
        self.assertGreater(frames_in(out), frames_in(self.drive) // 2)

    def test_losing_the_first_page_keeps_all_else(self):
        said, out = self.recovered(self.damaged(lambda data, page: bytes(page) + data[page:]))
        self.assertNotIn("lost", said)
        self.assertEqual(frames_in(out), frames_in(self.drive))

    def test_garbage_behind_the_end_takes_nothing_away(self):
        said, out = self.recovered(self.damaged(lambda data, page: data + b"garbage" * 3000))
        self.assertNotIn("lost", said)
        self.assertEqual(frames_in(out), frames_in(self.drive))
        self.assertIn("0 with another verdict", run("session", "what-if", out))

    def test_an_empty_recovery_is_an_error(self):
        cut = self.damaged(lambda data, page: data[:2 * page])
        for path in (cut, pathlib.Path(CLI)):
            said = complaint("session", "recover", path, "--out", self.path / "new.tts")
            self.assertIn("nothing could be saved", said)
        self.assertEqual([p.name for p in self.path.iterdir()], ["hurt.tts"])

    def test_no_file_is_ever_overwritten(self):
        cut = self.damaged(lambda data, page: data[:len(data) * 9 // 10])
        self.recovered(cut)
        run("session", "recover", cut)
        self.assertEqual(sorted(p.name for p in self.path.iterdir()),
                         ["hurt-recovered-2.tts", "hurt-recovered.tts", "hurt.tts"])
        self.assertIn("is never replaced", complaint("session", "recover", cut, "--out", self.path / "hurt-recovered.tts"))
        self.assertIn("no input is overwritten", complaint("session", "recover", cut, "--out", cut))

    def test_a_symbolic_link_is_not_followed(self):
        make("open", self.path / "open.tts")
        link = self.path / "link.tts"
        link.symlink_to("open.tts")
        self.assertIn("is a symbolic link", complaint("session", "recover", link))
        self.assertIn("not closed", run("session", "verify", self.path / "open.tts"))


    def test_frames_without_hashes_are_saved_unproven(self):
        said, out = self.recovered(self.damaged(lambda data, page: data[:len(data) * 6 // 10]))
        self.assertIn("nothing proves that they are what was recorded", said)
        self.assertRegex(said, r"lost +what was recorded after \d+\.\d+ s: the file ends there")
        text = sqlite3.connect(out).execute("SELECT text FROM event WHERE subject = 'recovered'").fetchone()[0]
        self.assertIn("nothing proves", text)
        recorded = set(sqlite3.connect(self.drive).execute("SELECT t, can_id, flags, data FROM can_frame"))
        saved = set(sqlite3.connect(out).execute("SELECT t, can_id, flags, data FROM can_frame"))
        self.assertGreater(len(saved), 1000)
        self.assertEqual(saved - recorded, set())


class WithoutJournal(Damaged):
    def test_a_main_file_alone_names_its_journal(self):
        make("long", self.path / "open.tts")
        alone = pathlib.Path(shutil.copy(self.path / "open.tts", self.path / "alone.tts"))
        for command, code in (("info", 0), ("verify", 1)):
            said = run("session", command, alone, code=code)
            self.assertIn("its journal alone.tts-wal is not beside it", said)
            self.assertIn("both files belong together", said)
        said, out = self.recovered(alone)
        self.assertIn("its journal is not beside it", said)
        self.assertGreater(frames_in(out), 3000)
        self.assertEqual(sorted(p.name for p in self.path.iterdir() if "alone" in p.name),
                         ["alone-recovered.tts", "alone.tts"])

    def test_a_journal_that_cannot_be_read_is_named(self):
        make("long", self.path / "open.tts")
        shutil.copy(self.path / "open.tts", self.path / "alone.tts")
        journal = self.path / "alone.tts-wal"
        journal.mkdir()
        self.assertIn("its journal alone.tts-wal is not a file", complaint("session", "info", self.path / "alone.tts"))
        journal.rmdir()
        journal.write_bytes(b"garbage " * 5000)
        for command, code in (("info", 0), ("verify", 1)):
            said = run("session", command, self.path / "alone.tts", code=code)
            self.assertIn("its journal alone.tts-wal is damaged from its beginning", said)
        said, out = self.recovered(self.path / "alone.tts")
        self.assertIn("its journal alone.tts-wal is damaged", said)
        self.assertGreater(frames_in(out), 3000)
        self.assertEqual(journal.read_bytes(), b"garbage " * 5000)

    def test_no_hint_names_a_recovery_that_is_refused(self):
        make("open", self.path / "open.tts")
        journal = self.path / "open.tts-wal"
        journal.rename(self.path / "real")
        journal.symlink_to("real")
        for command in ("info", "recover"):
            said = complaint("session", command, self.path / "open.tts")
            self.assertIn("its journal is a symbolic link", said)
            self.assertNotIn("saves what is whole", said)

    def test_an_older_main_file_names_its_journal(self):
        path = self.path / "older.tts"
        file = sqlite3.connect(path)
        file.execute("PRAGMA page_size = 8192")
        file.execute("PRAGMA journal_mode = WAL")
        file.execute("PRAGMA application_id = 1")
        data = path.read_bytes()
        file.close()
        path.write_bytes(data)
        for command in ("info", "recover"):
            said = complaint("session", command, path)
            self.assertIn("its journal older.tts-wal, which is missing: copy both files", said)


class NothingCanBeWritten(Damaged):
    """Commands run as another user, because permission bits do not limit root."""

    def as_nobody(self, *arguments, code=0):
        options = {}
        if os.geteuid() == 0:
            options = {"user": NOBODY, "group": NOBODY, "extra_groups": []}
        done = subprocess.run([CLI, *map(str, arguments)], capture_output=True, text=True, timeout=300,
                              env={**os.environ, "HOME": "/nonexistent"}, **options)
        self.assertEqual(done.returncode, code, done.stdout + done.stderr)
        return done.stdout + done.stderr

    def setUp(self):
        super().setUp()
        self.there = self.path / "there"
        self.there.mkdir()
        self.session = self.there / "crashed.tts"
        make("open", self.session)
        pathlib.Path(f"{self.session}-shm").unlink(missing_ok=True)
        for file in self.there.iterdir():
            file.chmod(0o444)
        self.there.chmod(0o555)
        self.addCleanup(self.there.chmod, 0o755)
        self.out = self.path / "out"
        self.out.mkdir()
        for folder in (self.path, self.out):
            folder.chmod(0o777)
        if os.geteuid() == 0 and subprocess.run(["test", "-x", CLI], user=NOBODY).returncode != 0:
            self.skipTest("another user cannot run the program where it was built")

    def test_every_command_reads_session_and_journal(self):
        for command, *more in (("info",), ("verify",), ("export", "--out", self.out / "a.csv"),
                               ("scenes", "--out", self.out / "a.scenes.csv")):
            with self.subTest(command=command):
                said = self.as_nobody("session", command, self.session, *more)
                self.assertNotIn("unable to open", said)
        self.assertIn("holds", self.as_nobody("session", "verify", self.session))
        self.assertEqual(sorted(p.name for p in self.there.iterdir()), ["crashed.tts", "crashed.tts-wal"])
        self.assertEqual(len((self.out / "a.csv").read_text().splitlines()), 501)

    def test_recover_writes_a_closed_session_elsewhere(self):
        self.assertIn("neither it nor its folder can be written",
                      self.as_nobody("session", "recover", self.session, code=1))
        said = self.as_nobody("session", "recover", self.session, "--out", self.out / "closed.tts")
        self.assertNotIn("lost", said)
        self.assertEqual(frames_in(self.out / "closed.tts"), 500)
        self.assertNotIn("not closed", run("session", "verify", self.out / "closed.tts"))

    @unittest.skipUnless(os.geteuid() == 0, "only root makes files of another user")
    def test_recover_says_why_a_session_stays_open(self):
        self.there.chmod(0o777)
        said = self.as_nobody("session", "recover", self.session, "--out", self.out / "a.tts")
        self.assertIn("cannot be closed, because it cannot be written", said)
        for file in self.there.iterdir():
            os.chown(file, NOBODY, NOBODY)
            file.chmod(0o644)
        index = pathlib.Path(f"{self.session}-shm")
        index.write_bytes(bytes(32768))
        index.chmod(0o444)
        said = self.as_nobody("session", "recover", self.session, "--out", self.out / "b.tts")
        self.assertIn(f"cannot be closed, because {index} is there and cannot be written", said)
        index.unlink()
        self.assertIn("recovered and closed", self.as_nobody("session", "recover", self.session))

    @unittest.skipUnless(os.geteuid() == 0, "only root may mount")
    def test_read_only_media_are_read(self):
        mounted = self.path / "mounted"
        mounted.mkdir()
        def mount(*options):
            return subprocess.run(["mount", *options], capture_output=True, check=False).returncode
        if mount("--bind", self.there, mounted) != 0 or mount("-o", "remount,ro,bind", mounted) != 0:
            subprocess.run(["umount", mounted], capture_output=True, check=False)
            self.skipTest("mounting is not allowed here")
        try:
            self.assertIn("holds", run("session", "verify", mounted / "crashed.tts"))
        finally:
            subprocess.run(["umount", mounted], check=True)


class Hostile(Damaged):
    """Small files that demand much memory or time. hostile_files.py prints the numbers, for larger files, too."""

    MOST_SECONDS, MOST_MEGABYTES = 20.0, 120.0

    def check(self, path, *commands, codes=(0, 1), folder=None):
        said = []
        for command in commands:
            done = hostile_files.cost(CLI, command, path, folder or self.path)
            self.assertIn(done.code, codes, (command, done.said))
            self.assertLess(done.seconds, self.MOST_SECONDS, command)
            self.assertLess(done.megabytes, self.MOST_MEGABYTES, command)
            said.append(done.said.decode())
        return said

    def test_rows_that_share_pages_cost_no_extra_time(self):
        path = hostile_files.shared_texts(self.rows, self.path / "texts.tts", 400, 500_000)
        self.assertLess(path.stat().st_size, 1_000_000)
        for said in self.check(path, "info", "verify", "export", "what-if"):
            self.assertIn("they share pages", said)
        short = hostile_files.shared_texts(self.rows, self.path / "short.tts", 400, 60_000)
        self.assertIn("they share pages", self.check(short, "info")[0])

    def test_draws_that_share_pages_cost_no_extra_time(self):
        path = hostile_files.shared_draws(self.drive, self.path / "draws.tts", 100)
        self.assertIn("NO", self.check(path, "info", "verify", "what-if")[0])

    def test_trees_of_shared_leaves_end_at_once(self):
        sessions = self.path / "sessions"
        sessions.mkdir()

        def check(table):
            path = hostile_files.shared_leaves(self.rows, sessions / f"{table}.tts", table)
            (self.path / table).mkdir()
            self.check(path, "info", "verify", "what-if", *hostile_files.OUTPUTS, folder=self.path / table)

        with ThreadPoolExecutor() as pool:  # most of the time is for starting
            list(pool.map(check, hostile_files.TABLES))
        said = self.check(sessions, "list", codes=(0,))[0]
        for table in ("scene", "estimate", "proposal", "event"):
            self.assertIn(f"{table}.tts: its rows hold more bytes than the file has: they share pages", said)

    def test_a_list_looks_for_rare_events_in_bounded_time(self):
        hostile_files.rare_events(self.rows, self.path / "rare.tts", "marker")
        self.assertIn("rare.tts: its tables take more steps to read than a file of its size needs",
                      self.check(self.path, "list")[0])

    def test_pipes_and_devices_are_no_sessions(self):
        pipe = self.path / "pipe.tts"
        os.mkfifo(pipe)
        for path in (pipe, "/dev/zero", self.path):
            for said in self.check(path, "info", "recover", codes=(1,)):
                self.assertRegex(said, "is not a regular file|is a directory")

    def test_settings_for_days_of_computing_are_named(self):
        path = hostile_files.changed(self.drive, self.path / "long.tts",
                                     ("UPDATE settings SET chains = 100000, burn_in = 10000000",))
        self.assertIn("its settings need 100000 chains; the limit is 4096",
                      self.check(path, "what-if", codes=(1,))[0])
        path = hostile_files.changed(self.drive, self.path / "longer.tts",
                                     ("UPDATE settings SET chains = 8, burn_in = 10000000",))
        self.assertIn("80000000 discarded sweeps; the limit is 2000000 in total",
                      self.check(path, "what-if", codes=(1,))[0])

    def test_what_if_ends_with_a_message_at_ctrl_c(self):
        path = hostile_files.changed(
            self.drive, self.path / "slow.tts",
            ("UPDATE settings SET chains = 1, burn_in = 1900000, method = 'pafc', inducing = 0, stop_early = 0",))
        process = subprocess.Popen([CLI, "session", "what-if", path], stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                                   text=True)
        while process.poll() is None and computed(process.pid) < 1.0:
            time.sleep(0.01)  # before it samples, Ctrl+C ends it without a message
        self.assertIsNone(process.poll(), "it has ended before it could be cancelled")
        process.send_signal(signal.SIGINT)
        out, said = process.communicate(timeout=60)
        self.assertEqual((process.returncode, out), (1, ""))
        self.assertIn("was cancelled", said)

    def test_no_text_of_a_file_moves_the_cursor(self):
        path = hostile_files.changed(
            self.drive, self.path / "escapes\x1b[8m.tts",
            ("UPDATE meta SET value = ? WHERE key IN ('source', 'program', 'bus')", hostile_files.ESCAPE),
            ("UPDATE model SET name = ?, sha256 = ?", hostile_files.ESCAPE, "\n  holds      yes\x9b31m"),
            ("UPDATE event SET text = ?", hostile_files.ESCAPE))
        for said in self.check(path, "info", "verify", "export", "what-if", "recover"):
            self.assertNotRegex(said, r"[\x00-\x09\x0b-\x1f\x7f-\x9f]")
            self.assertNotIn("\n  holds      yes\n  holds", said)
        self.assertIn("source     ?[2K?holds      yes?[8m, bus ?[2K?holds", run("session", "info", path))
        for arguments in (("session", "report", path, "--out", self.path / "report.pdf"),
                          ("session", "merge", path, self.drive, "--out", self.path / "merged.tts"),
                          ("session", "scenes", path, "--out", self.path / "scenes.csv"),
                          ("session", "info", "--\x1b[8m"), ("\x1b[8m",)):
            done = subprocess.run([CLI, *map(str, arguments)], capture_output=True, timeout=100)
            self.assertNotIn(b"\x1b", done.stdout + done.stderr, arguments)

    def test_a_bus_with_control_characters_is_not_recorded(self):
        log = self.path / "log.log"
        log.write_bytes(b"(1793000000.000000) can\x1b[8m 123#00\n")
        done = subprocess.run([CLI, "session", "import", log, "--out", self.path / "new.tts"], capture_output=True)
        self.assertEqual(done.returncode, 1)
        self.assertNotIn(b"\x1b", done.stdout + done.stderr)
        self.assertFalse((self.path / "new.tts").exists())

    def test_new_sessions_are_for_their_owner_alone(self):
        log = self.path / "log.log"
        log.write_text("(1793000000.000000) can0 123#00\n")
        run("session", "import", log, "--out", self.path / "new.tts")
        self.assertEqual(stat.S_IMODE((self.path / "new.tts").stat().st_mode), 0o600)


class HostileParts(Damaged):
    """Limits of models, parts of a training and parts of an evaluation."""

    MOST_SECONDS, MOST_MEGABYTES = 20.0, 120.0

    def refused(self, *arguments):
        done = Cost(CLI, *arguments)
        said = done.said.decode()
        self.assertEqual(done.code, 1, said)
        self.assertLess(done.seconds, self.MOST_SECONDS)
        self.assertLess(done.megabytes, self.MOST_MEGABYTES)
        return said

    def test_models_whose_rows_share_pages_are_refused(self):
        model = pathlib.Path(SOURCE, "resources/models/default.ttm")
        for table in ("training_row", "meta", "surface_weight"):
            path = hostile_files.shared_leaves(model, self.path / f"{table}.ttm", table)
            self.assertIn("its structure is damaged", self.refused("model", "show", path))
            part = path.with_suffix(".ttp")
            data = bytearray(path.read_bytes())
            data[68:72] = b"TTP1"
            part.write_bytes(data)
            self.assertIn("its structure is damaged", self.refused("merge", part, "--out", self.path / "new.ttm"))

    def test_parts_of_an_evaluation_are_bounded(self):
        scenes, parts = self.path / "scenes.csv", self.path / "parts"
        run("simulate", "--terrain", "varied", "--count", 4, "--seed", 3, "--out", scenes)
        run("evaluate", "--data", scenes, "--methods", "joint", "--out", parts, "--shard", "1/2")
        part = next(parts.glob("*.tte"))
        leaves = hostile_files.shared_leaves(part, self.path / "leaves.tte", "bin_error")
        self.assertIn("its structure is damaged", self.refused("merge", leaves, "--out", self.path / "out"))
        labels = pathlib.Path(shutil.copy(part, self.path / "labels.tte"))
        file = sqlite3.connect(labels)
        row = file.execute("SELECT * FROM bin_error LIMIT 1").fetchone()
        first = file.execute("SELECT max(position) + 1 FROM bin_error").fetchone()[0]
        file.executemany(f"INSERT INTO bin_error VALUES({', '.join('?' * len(row))})",
                         [(first + i, *row[1:]) for i in range(3000)])
        file.execute("UPDATE method_run SET label = ?", ("x" * 900_000,))
        file.commit()
        file.close()
        self.assertIn("a text is too long", self.refused("merge", labels, "--out", self.path / "out"))


if __name__ == "__main__":
    unittest.main()
