"""Tests hostile files and folders: links that lead elsewhere, texts for the terminal, little memory."""

import csv
import io
import itertools
import os
import pathlib
import pty
import re
import stat
import subprocess
import unittest

from hostile_files import changed
from support import CLI, SOURCE, Folder, complaint, needs_no_sanitizer, run, sanitized

DEMO = f"{SOURCE}/resources/sessions/demo.tts"
FRAME = "(1793000000.000000) can0 123#00\n"
FORGED = "\nforged: yes"
ESCAPES = ("\x1b[2K\x1b]0;t\x07\u009b31m\u202egnol\u2066x\x07", "\r", FORGED)  # each is 30 commands; the last two end lines
if sanitized():
    ESCAPES = ESCAPES[:1]  # all take the same way through memory


class Scenes(Folder):
    def setUp(self):
        super().setUp()
        self.scenes = self.path / "scenes.csv"
        run("simulate", "--terrain", "varied", "--count", 2, "--seed", 5, "--out", self.scenes)

    def written(self, name, content):
        file = self.path / name
        file.write_bytes(content if isinstance(content, bytes) else content.encode())
        return file


class Links(Scenes):
    """Somebody has put a symbolic link where a command writes."""

    def setUp(self):
        super().setUp()
        self.victim = self.written("victim", "mine")

    def refused(self, link, *arguments):
        link.parent.mkdir(exist_ok=True)
        link.symlink_to(self.victim)
        self.assertIn("it is a symbolic link to", complaint(*arguments))
        self.assertEqual(self.victim.read_text(), "mine")
        self.assertTrue(link.is_symlink())
        link.unlink()

    def outputs(self):
        """Yields (option, ending of its file, command) for every option that names one output file."""
        log, own = self.written("a.log", FRAME), self.path / "own"
        simulate = "simulate", "--terrain", "varied", "--tracks", "--count", 1
        robot = "robot", "check", f"{SOURCE}/resources/robots/absolem.toml"
        truth = "truth", self.written("cloud.xyz", "0 0 0\n"), "--scenes", self.scenes, "--poses", self.scenes
        mapped = "import", log, "--mapping", f"{SOURCE}/resources/mappings/terratact.toml"
        yield from (
            ("--out", "csv", "simulate", "--terrain", "varied", "--count", 1),
            ("--out", "csv", "simulate", "--terrain", "varied", "--drives", 1),
            ("--cloud", "pcd", *simulate, "--out", own, "--poses", own.with_suffix(".csv")),
            ("--poses", "csv", *simulate, "--out", own, "--cloud", own.with_suffix(".pcd")),
            ("--recording", "mcap", *simulate, "--out", own, "--cloud", own.with_suffix(".pcd"), "--poses",
             own.with_suffix(".csv")),
            ("--out", "csv", "reconstruct", "--data", self.scenes),
            ("--out", "ttm", "train", "--data", self.scenes),
            ("--out", "ttp", "train", "--data", self.scenes, "--bins", 5),
            ("--out", "ttn", "train", "--drives", self.scenes),
            ("--out", "ttm", "merge", self.written("a.ttp", "junk")),
            ("--out", "csv", *truth),
            ("--support", "csv", *truth, "--out", own),
            ("--sheet", "png", *truth, "--out", own),
            ("--review", "ttt", *truth, "--out", own),
            ("--picture", "png", *robot),
            ("--out", "toml", *robot, "--recordings", DEMO),
            ("--csv", "csv", "can", "decode", log),
            ("--out", "csv", "session", "export", DEMO, "--what", "events"),
            ("--out", "log", "session", "export", DEMO),
            ("--out", "mcap", "session", "export", DEMO),
            ("--out", "csv", "session", "scenes", DEMO),
            ("--out", "csv", "session", "what-if", DEMO),
            *(("--out", ending, "session", "strip", DEMO) for ending in ("csv", "ply", "png")),
            *(("--out", ending, "session", "report", DEMO, *mission) for ending in ("pdf", "html")
              for mission in ((), ("--mission",))),
            *(("--out", "tts", "session", *command)
              for command in (("recover", DEMO), ("import", log), ("merge", DEMO, DEMO))),
            ("--out", "tts", *mapped),
            ("--scenes", "csv", *mapped, "--out", own.with_suffix(".tts")))

    def test_no_command_writes_through_a_link(self):
        options = set()
        for option, ending, *arguments in self.outputs():
            with self.subTest(option=option, arguments=arguments):
                file = self.path / f"out.{ending}"
                self.refused(file, *arguments, option, file)
            options.add(option)
        sources = "".join(p.read_text() for p in pathlib.Path(SOURCE, "app", "cli").rglob("*.cpp"))
        self.assertEqual(set(re.findall(r'add(?:Text|File|Folder)Output\(\s*\*?\w+, "(--\w+)"', sources)), options)

    def test_no_session_is_made_where_a_link_leads(self):
        log, link = self.written("a.log", FRAME), self.path / "out.tts"
        for arguments in (("recover", DEMO), ("import", log), ("merge", DEMO, DEMO)):
            link.symlink_to(self.path / "elsewhere.tts")
            complaint("session", *arguments, "--out", link)
            self.assertFalse((self.path / "elsewhere.tts").exists(), arguments)
            link.unlink()

    def test_no_file_of_a_folder_is_written_through_a_link(self):
        needs_no_sanitizer(self, "links are found the same")
        data, folder, part = ("--data", self.scenes), self.path / "folder", self.path / "part_1_of_1.tte"
        run("evaluate", *data, "--methods", "local", "--shard", "1/1", "--out", self.path)
        run("merge", part, "--out", self.path / "names")
        report = sorted(file.name for file in (self.path / "names").iterdir())
        for files, *arguments in (
                (report, "evaluate", *data, "--methods", "local"),
                (report, "merge", part),
                (("part_1_of_2.tte",), "evaluate", *data, "--shard", "1/2"),
                (("tracks.csv", "track_steps.csv", "missing.csv"), "evaluate", *data, "--tracks"),
                (("tradeoff.csv", "presets.csv", "tradeoff.png", "tradeoff.svg"), "tradeoff", *data),
                (("first.csv", "first.png", "second.csv", "second.png"), "demo")):
            for name in files:
                with self.subTest(name=name, arguments=arguments):
                    self.refused(folder / name, *arguments, "--out", folder)
        self.refused(self.path / "m.card.toml", "train", *data, "--out", self.path / "m.ttm")

    def test_no_card_is_updated_through_a_link(self):
        model = self.path / "m.ttm"
        model.symlink_to(f"{SOURCE}/resources/models/default.ttm")
        self.refused(self.path / "m.card.toml", "model", "card", model, "--terrain", "varied")

    def test_a_temporary_file_is_never_a_link(self):
        out = self.path / "out.csv"
        (self.path / "out.csv.tmp0").symlink_to(self.victim)
        run("reconstruct", "--data", self.scenes, "--out", out)
        self.assertEqual(self.victim.read_text(), "mine")
        self.assertFalse(out.is_symlink())


class Modes(Scenes):
    def mode(self, mask, out, *arguments):
        """Returns the permissions of a file that a command has written with this umask."""
        subprocess.run(["bash", "-c", f'umask {mask}; exec "$@"', "-", CLI, *arguments, "--out", out], check=True,
                       stdout=subprocess.DEVNULL)
        return stat.S_IMODE(out.stat().st_mode)

    def test_recordings_are_private_with_any_umask(self):
        log = self.written("a.log", FRAME)
        for mask in ("000", "022", "277"):
            self.assertEqual(self.mode(mask, self.path / f"{mask}.tts", "session", "import", log), 0o600, mask)

    def test_files_from_a_recording_are_private_too(self):
        for name, *arguments in (
                ("e.mcap", "session", "export", DEMO), ("e.log", "session", "export", DEMO),
                ("e.csv", "session", "export", DEMO, "--what", "events"), ("s.csv", "session", "scenes", DEMO),
                ("r.html", "session", "report", DEMO), ("x.csv", "reconstruct", "--data", self.scenes)):
            out = self.path / name
            self.assertEqual(self.mode("000", out, *arguments), 0o600, arguments)
            out.chmod(0o640)
            self.assertEqual(self.mode("000", out, *arguments), 0o640, "a replaced file keeps its mode")


class Formulas(Scenes):
    """No text of a file becomes a formula of a spreadsheet in any CSV that is written from it."""

    FORMULA = "=1+1"

    def written_by(self, *arguments):
        """Runs a command in the folder. Returns the text of what it has written to out.csv."""
        subprocess.run([CLI, *map(str, arguments)], cwd=self.path, check=True, capture_output=True)
        return self.harmless(self.path / "out.csv")

    def harmless(self, file):
        text = file.read_text()
        for field in itertools.chain.from_iterable(csv.reader(io.StringIO(text, newline=""))):
            if field.startswith(tuple("=+-@\t\uff1d\uff0b\uff0d\uff20")):
                self.assertTrue(is_number(field), (file.name, field))
        return text

    def named(self, file):
        """Gives each run of a scenes CSV a name that is a formula."""
        header, *lines = file.read_text().splitlines()
        return self.written("named_" + file.name, "\n".join([header] + [self.FORMULA + line for line in lines] + [""]))

    def test_exports_of_a_session(self):
        session = self.path / "=1+1.tts"
        changed(DEMO, session,
                ("UPDATE event SET subject = ?, text = ?, shown = ?", self.FORMULA, "@SUM(A1)", "\uff1d1"),
                ("UPDATE model SET name = ?", self.FORMULA))
        for what in ("estimates", "signals", "frames"):
            self.written_by("session", "export", session.name, "--what", what, "--out", "out.csv")
        self.written_by("session", "strip", session.name, "--out", "out.csv")
        events = self.written_by("session", "export", session.name, "--what", "events", "--out", "out.csv")
        self.assertIn(",'=1+1,'@SUM(A1),", events)
        for command in (("scenes",), ("scenes", "--tracks"), ("scenes", "--drives"), ("what-if",)):
            text = self.written_by("session", *command, session.name, "--out", "out.csv")
            self.assertIn("\n'=1+1", text, command)

    def test_values_of_a_log(self):
        self.written("d.dbc", 'BU_: G\nBO_ 291 M: 8 G\n SG_ S : 0|8@1+ (1,0) [0|0] "=1+1" X\n'
                     'VAL_ 291 S 0 "=2+2" ;\n')
        self.written("=a.log", FRAME.replace("can0", "=can0"))
        text = self.written_by("can", "decode", "=a.log", "--dbc", "d.dbc", "--csv", "out.csv")
        self.assertIn(",'=can0,123,M,,by d.dbc,S,'=2+2,'=1+1\n", text)
        run("session", "import", self.path / "=a.log", "--out", self.path / "a.tts")
        self.written_by("session", "export", "a.tts", "--what", "signals", "--dbc", "d.dbc", "--out", "out.csv")

    def test_runs_of_scenes(self):
        tracks, recording = self.path / "tracks.csv", self.path / "=1+1.mcap"
        run("simulate", "--terrain", "varied", "--tracks", "--count", 2, "--out", tracks, "--recording", recording,
            "--cloud", self.path / "cloud.pcd", "--poses", self.path / "poses.csv")
        poses = self.named(self.path / "poses.csv")
        truth = "truth", "cloud.pcd", "--scenes", self.named(tracks), "--poses", poses
        for command in (("reconstruct", "--data", self.named(self.scenes), "--out", "out.csv"),
                        ("reconstruct", "--tracks", "--data", self.named(tracks), "--out", "out.csv"),
                        (*truth, "--out", "out.csv"), (*truth, "--out", "truth.csv", "--support", "out.csv"),
                        ("import", recording.name, "--mapping", f"{SOURCE}/resources/mappings/simulated_robot.toml",
                         "--out", "=1+1.tts", "--scenes", "out.csv")):
            self.assertIn("\n'=1+1", self.written_by(*command), command)

    def test_files_of_an_evaluation(self):
        needs_no_sanitizer(self, "formulas are found the same")
        _, *lines = self.scenes.read_text().splitlines()
        runs = {line.split(",", 1)[0] for line in lines}
        classes = self.written("classes.csv", "row,class\n"
                               + "".join(f"{self.FORMULA}{name},@SUM(A1)\n" for name in runs))
        folder = self.path / "evaluation"
        run("evaluate", "--data", self.named(self.scenes), "--classes", classes, "--methods", "local", "--out", folder)
        texts = {file.name: self.harmless(file) for file in folder.glob("*.csv")}
        self.assertIn("\n'=1+1", texts["errors.csv"])
        self.assertIn("'@SUM(A1)", texts["classes.csv"])


def is_number(text):
    try:
        float(text)
    except ValueError:
        return False
    return True


class Texts(Scenes):
    """Names and texts of files are printed without what moves a cursor, changes a colour or the reading direction.

    None of them begins a line, so that none can be taken for what the program says.
    """

    RAW = re.compile(r"[\x00-\x08\x0b-\x1f\x7f-\x9f\u200e\u200f\u202a-\u202e\u2066-\u2069]")

    def printed(self, *arguments):
        done = subprocess.run([CLI, *map(str, arguments)], capture_output=True, timeout=100, stdin=subprocess.DEVNULL)
        text = (done.stdout + done.stderr).decode(errors="replace")
        self.assertIsNone(self.RAW.search(text), (arguments, ascii(text)))
        self.assertNotIn(FORGED, text, arguments)
        return text

    def test_names_of_files_are_printed_without_escapes(self):
        for escape in ESCAPES:
            name = f"a{escape}b"
            missing, log = self.path / f"{name}.none", self.written(f"{name}.log", FRAME)
            scenes = self.written(f"{name}.csv", self.scenes.read_bytes())
            for arguments in (
                    ("reconstruct", "--data", missing, "--out", self.path / "o.csv"), ("train", "--data", missing, "--out", missing),
                    ("simulate", "--terrain", missing, "--out", missing), ("simulate", "--terrain", "varied", "--robot", missing),
                    ("model", "show", missing), ("can", "decode", log), ("can", "decode", log, "--dbc", missing),
                    ("can", "check", log), ("can", "check", missing), ("session", "info", missing), ("panel", "check", missing),
                    ("probes", "--data", scenes), ("calibrate", "--data", scenes), ("contacts", "--data", scenes),
                    ("reconstruct", "--data", scenes, "--out", self.path / f"{name}.out.csv"),
                    ("session", "import", log, "--out", self.path / f"{name}.tts"), ("session", "info", self.path / f"{name}.tts"),
                    (name,), ("reconstruct", f"--{name}"), ("evaluate", "--data", scenes, "--methods", name)):
                self.printed(*arguments)

    def test_texts_of_files_are_printed_without_escapes(self):
        plain = pathlib.Path(SOURCE, "resources/robots/absolem.toml").read_text()
        for escape in ESCAPES:
            quoted = escape.replace(FORGED, "").replace("\r", "")
            dbc = self.written("d.dbc", f'VERSION "{escape}"\nBU_: Gas\nBO_ 291 Gas{quoted}: 8 Gas\n SG_ Oxygen : 0|8@1+ (1,0) '
                               f'[0|0] "{escape}" X\nCM_ SG_ 291 Oxygen "{escape}";\nVAL_ 291 Oxygen 0 "{escape}" ;\n')
            log = self.written("d.log", FRAME)
            self.printed("can", "decode", log, "--dbc", dbc)
            self.printed("can", "decode", log, "--dbc", dbc, "--summary")
            self.printed("can", "check", self.written("i.log", f"(1793000000.000000) c{quoted}n 123#00\n"))
            self.printed("can", "decode", self.path / "i.log")
            header, *lines = self.scenes.read_text().splitlines()
            run_name = self.written("r.csv", "\n".join([header] + [quoted + line for line in lines]) + "\n")
            self.printed("reconstruct", "--data", run_name, "--out", self.path / "o.csv")
            self.printed("contacts", "--data", run_name)
            self.printed("contacts", "--data", self.written("h.csv", f'"a{escape}",b\n1,2\n'))
            self.printed("probes", "--data", self.written("p.csv", f'place,height_m,truth_m\n"{escape}",0.1,0.2\n'))
            robot = self.written("r.toml", plain.replace('name = "', f'name = "{quoted}'))
            self.printed("simulate", "--terrain", "varied", "--count", 1, "--robot", robot, "--out", self.path / "o.csv")
            self.printed("panel", "check", self.written("n.toml", f'chip = "{quoted}"\n"{quoted}" = 1\n'))

    def test_no_name_forges_a_line_of_a_longer_text(self):
        recording, scenes = self.path / f"a{FORGED}.mcap", self.path / f"a{FORGED}.csv"
        run("session", "export", DEMO, "--out", recording)
        self.assertIn(" topics, ", self.printed("import", recording, "--probe"))
        cloud, poses, out = self.path / "c.pcd", self.path / "p.csv", self.path / "o.csv"
        run("simulate", "--tracks", "--terrain", "varied", "--count", 3, "--seed", 5, "--cloud", cloud, "--poses", poses,
            "--out", scenes)
        said = self.printed("truth", cloud, "--scenes", scenes, "--poses", poses, "--out", out)
        self.assertIn("against the heights that ", said)
        classes = self.written("k.csv", f'row,class\n1,"a{FORGED}"\n2,b\n')
        self.assertIn("By class", self.printed("evaluate", "--data", self.scenes, "--classes", classes, "--methods", "local",
                                               "--out", self.path / "e"))
        model = self.written(f"m{FORGED}.ttm", pathlib.Path(SOURCE, "resources/models/default.ttm").read_bytes())
        card = pathlib.Path(SOURCE, "resources/models/default.card.toml").read_text().split("[[", 1)[0]
        for held_out in ("2 files", r"2 files\nforged: yes"):
            self.written(f"m{FORGED}.card.toml", f'{card}[generated]\nweight = 0.5\nheld_out = "{held_out}"\n'
                         "mean_errors_m = [[0.5, 0.02]]\n")
            self.assertRegex(self.printed("model", "show", model), "held out in 2 files|held_out is not a text|control character")


class Terminals(Scenes):
    """A terminal gets no escapes of a file, a pipe gets every byte."""

    def shown(self, *arguments):
        master, slave = pty.openpty()
        with subprocess.Popen([CLI, *map(str, arguments)], stdin=subprocess.DEVNULL, stdout=slave,
                              stderr=subprocess.DEVNULL) as process:
            os.close(slave)
            output = b""
            while piece := read_terminal(master):
                output += piece
            self.assertEqual(process.wait(timeout=100), 0)
        os.close(master)
        return output.replace(b"\r\n", b"\n").decode()

    def test_a_csv_is_printed_without_escapes(self):
        log = self.written("d.log", FRAME)
        for escape in ("\x1b[2K", "\u009b31m", "\u202e"):
            dbc = self.written("d.dbc", f'BU_: G\nBO_ 291 M: 8 G\n SG_ S : 0|8@1+ (1,0) [0|0] "{escape}" X\n')
            session = self.written(f"k{escape}.tts", pathlib.Path(DEMO).read_bytes())
            for command in (("can", "decode", log, "--dbc", dbc, "--csv", "-"),
                            ("session", "what-if", session, "--estimate", 1, "--out", "-")):
                shown = self.shown(*command)
                self.assertIsNone(Texts.RAW.search(shown), command)
                piped = subprocess.run([CLI, *map(str, command)], capture_output=True, check=True).stdout.decode()
                self.assertEqual(shown, Texts.RAW.sub("?", piped), command)
        self.assertIn(escape, piped)


def read_terminal(master):
    try:
        return os.read(master, 65536)
    except OSError:  # its other end is closed
        return b""


class NoFonts(Folder):
    def test_a_picture_without_a_font_is_not_drawn(self):
        config = self.path / "fonts.conf"
        config.write_text("<?xml version='1.0'?><fontconfig></fontconfig>")
        done = subprocess.run([CLI, "session", "report", DEMO, "--out", self.path / "r.pdf"], capture_output=True, text=True,
                              timeout=100, env=os.environ | {"FONTCONFIG_FILE": str(config)}, check=False)
        self.assertEqual(done.returncode, 1)
        self.assertRegex(done.stderr.splitlines()[-1], "r.pdf: cannot be drawn: no font is installed, .*; install one")
        self.assertFalse((self.path / "r.pdf").exists())


class NoHome(unittest.TestCase):
    @unittest.skipUnless(os.geteuid() == 0, "only root acts as a user who is not in the user database")
    def test_the_list_of_recordings_says_what_is_missing(self):
        unknown = {"user": 54321, "group": 54321, "extra_groups": []}
        if subprocess.run(["test", "-x", CLI], **unknown, check=False).returncode != 0:
            self.skipTest("another user cannot run the program where it was built")
        for home in ({}, {"HOME": "relative", "XDG_STATE_HOME": "state"}):
            done = subprocess.run([CLI, "session", "list"], capture_output=True, text=True, timeout=100, env=home,
                                  check=False, **unknown)
            self.assertEqual((done.returncode, done.stderr), (
                1, "terratact: there is no home folder that may hold recordings: name a folder, or set HOME or XDG_STATE_HOME\n"))


class LittleMemory(Scenes):
    def test_each_limit_is_one_sentence(self):
        needs_no_sanitizer(self)
        for megabytes in (100, 200, 500, 1000):
            for arguments in (("session", "info", DEMO), ("reconstruct", "--data", self.scenes, "--out", self.path / "o.csv"),
                              ("evaluate", "--data", self.scenes, "--methods", "local", "--out", self.path / "e")):
                done = subprocess.run(["bash", "-c", f'ulimit -c 0 -v {1000 * megabytes}; exec "$@"', "-", CLI, *arguments],
                                      capture_output=True, text=True, timeout=300, check=False)
                self.assertIn(done.returncode, (0, 1), (megabytes, arguments, done.stderr))
                if done.returncode:
                    last = done.stderr.splitlines()[-1]
                    self.assertRegex(last, "^terratact: .*memory.*ulimit -v", (megabytes, arguments))
                self.assertNotRegex(done.stderr, "bad_alloc|terminate")


if __name__ == "__main__":
    unittest.main()
