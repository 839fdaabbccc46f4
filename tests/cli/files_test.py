"""Tests input and output files: inputs are never overwritten, recordings never replaced; pipes, full disks, foreign
CSV."""

import os
import pathlib
import re
import shutil
import signal
import subprocess
import tempfile
import unittest

from support import CLI, SOURCE, Folder, complaint, needs_no_sanitizer, rows, run

DEMO = f"{SOURCE}/resources/sessions/demo.tts"
MODEL = f"{SOURCE}/resources/models/default.ttm"
LOG = f"{SOURCE}/docs/can_demo.log"
REFUSED = "no input is overwritten"


def shell(command, code=0):
    """Returns the result of a bash command line; `$T` is the program."""
    done = subprocess.run(["bash", "-c", command], capture_output=True, text=True, timeout=300,
                          env=os.environ | {"T": CLI}, check=False)
    assert done.returncode == code, f"{command}: exit {done.returncode}\n{done.stdout}\n{done.stderr}"
    return done


class Scenes(Folder):
    def setUp(self):
        super().setUp()
        self.scenes = self.path / "scenes.csv"
        self.scenes.write_bytes(SCENES)

    def copy(self, file, name):
        return pathlib.Path(shutil.copyfile(file, self.path / name))


def setUpModule():
    global SCENES
    with tempfile.TemporaryDirectory() as folder:
        out = pathlib.Path(folder) / "scenes.csv"
        run("simulate", "--terrain", "varied", "--count", 6, "--seed", 5, "--out", out)
        SCENES = out.read_bytes()


class Overwriting(Scenes):
    def refused(self, file, *arguments, says=REFUSED):
        before = file.read_bytes()
        self.assertIn(says, complaint(*arguments))
        self.assertEqual(file.read_bytes(), before)
        self.assertFalse([p.name for p in self.path.rglob("*.tmp*")])

    def test_an_empty_name_is_refused_first(self):
        for arguments in (("reconstruct", "--data", self.scenes, "--out", ""), ("reconstruct", "--data", "", "--out", "o.csv"),
                          ("simulate", "--terrain", "", "--out", "o.csv"), ("can", "decode", ""),
                          ("reconstruct", "--data", self.scenes, "--out", "o.csv", "--model", ""),
                          ("evaluate", "--data", self.scenes, "--out", ""), ("session", "report", DEMO, "--out", "")):
            self.assertIn("the name is empty", complaint(*arguments, code=2), arguments)

    def test_a_report_names_its_formats(self):
        self.assertIn(".html", complaint("session", "report", DEMO, "--out", self.path / "a.txt"))

    def test_no_command_overwrites_what_it_reads(self):
        s, log, tts = self.scenes, self.copy(LOG, "run.log"), self.copy(DEMO, "drive.tts")
        model, robot = self.copy(MODEL, "m.ttm"), self.copy(f"{SOURCE}/resources/robots/absolem.toml", "robot.toml")
        ground = self.path / "ground.csv"
        ground.write_text("x_m,z_m\n0,0\n3,0\n")
        dbc = self.copy(f"{SOURCE}/docs/can_payload.dbc", "p.dbc")
        for file, *arguments in (
                (ground, "simulate", "--terrain", ground, "--out", ground),
                (robot, "simulate", "--terrain", "varied", "--robot", robot, "--out", robot),
                (s, "train", "--data", s, "--out", s),
                (robot, "train", "--data", s, "--robot", robot, "--out", robot),
                (s, "reconstruct", "--data", s, "--out", s),
                (model, "reconstruct", "--data", s, "--model", model, "--out", model),
                (log, "can", "decode", log, "--csv", log),
                (dbc, "can", "decode", log, "--dbc", dbc, "--csv", dbc),
                (tts, "session", "export", tts, "--out", tts, "--format", "csv"),
                (tts, "session", "scenes", tts, "--out", tts),
                (tts, "session", "report", tts, "--out", tts),
                (tts, "session", "what-if", tts, "--out", tts),
                (tts, "session", "merge", tts, "--out", tts),
                (model, "session", "what-if", tts, "--model", model, "--out", model),
                (log, "session", "import", log, "--out", log)):
            with self.subTest(arguments=arguments):
                self.refused(file, *arguments)

    def test_the_shipped_models_are_inputs_of_what_if(self):
        for name in (MODEL, MODEL.replace(".ttm", ".ttn")):
            link = self.path / pathlib.Path(name).name
            link.symlink_to(name)
            self.refused(link, "session", "what-if", DEMO, "--out", link)

    def test_a_file_is_known_by_any_name(self):
        hard, soft = self.path / "hard.csv", self.path / "soft.csv"
        os.link(self.scenes, hard)
        soft.symlink_to(self.scenes)
        for out in (hard, soft, self.path / "." / ".." / self.path.name / "scenes.csv"):
            self.refused(self.scenes, "reconstruct", "--data", self.scenes, "--out", out)
        for data in (hard, soft):
            self.refused(self.scenes, "reconstruct", "--data", data, "--out", self.scenes)

    def test_companions_of_inputs_are_not_overwritten(self):
        model, tts = self.copy(MODEL, "m.ttm"), self.copy(DEMO, "d.tts")
        card = self.copy(f"{SOURCE}/resources/models/default.card.toml", "m.card.toml")
        notes = self.path / "d.tts.notes.csv"
        notes.write_text("t_s,note\n1,mine\n")
        self.refused(card, "reconstruct", "--data", self.scenes, "--model", model, "--out", card)
        self.refused(notes, "session", "scenes", tts, "--out", notes)
        data = self.path / "n.card.toml"
        data.write_bytes(SCENES)
        self.refused(data, "train", "--data", data, "--out", self.path / "n.ttm")

    def test_files_of_a_folder_are_compared_by_name(self):
        needs_no_sanitizer(self, "names of files are compared the same")
        out = self.path / "evaluation"
        run("evaluate", "--data", self.scenes, "--methods", "local", "--out", out)
        index = self.path / "index.csv"
        index.write_text("row,class\n1,a\n")
        written = sorted(out.iterdir())
        self.assertGreater(len(written), 9)
        for file in written:
            self.refused(file, "evaluate", "--data", file, "--out", out)
        run("evaluate", "--data", self.scenes, "--methods", "local", "--classes", index, "--out", out)
        self.refused(out / "classes.csv", "evaluate", "--data", self.scenes, "--classes", out / "classes.csv", "--out", out)
        demo = self.path / "demo"
        demo.mkdir()
        model = self.copy(MODEL, "demo/first.png")
        self.refused(model, "demo", "--model", model, "--out", demo)
        presets = self.path / "presets.csv"
        presets.write_bytes(SCENES)
        self.refused(presets, "tradeoff", "--data", presets, "--out", self.path)
        part = self.path / "part_1_of_2.tte"
        part.write_bytes(SCENES)
        self.refused(part, "evaluate", "--data", part, "--shard", "1/2", "--out", self.path)

    def test_a_recording_is_never_replaced(self):
        other = self.copy(DEMO, "other.tts")
        unnamed = self.copy(DEMO, "unnamed.csv")
        damaged = self.path / "Damaged.TTS"
        damaged.write_text("no session any more")
        for file in (other, unnamed, damaged):
            for arguments in (("session", "scenes", DEMO), ("session", "export", DEMO, "--format", "csv"),
                              ("simulate", "--terrain", "varied", "--count", 1), ("train", "--data", self.scenes)):
                self.refused(file, *arguments, "--out", file, says="a recorded session is there")

    def test_a_write_protected_file_stays(self):
        out = self.path / "kept.csv"
        out.write_text("mine")
        out.chmod(0o444)
        self.refused(out, "simulate", "--terrain", "varied", "--count", 1, "--out", out, says="cannot be written")
        model = self.path / "new.ttm"
        card = self.path / "new.card.toml"
        card.write_text("mine")
        card.chmod(0o444)
        self.refused(card, "train", "--data", self.scenes, "--out", model, says="cannot be written")
        self.assertFalse(model.exists())

    def test_two_outputs_are_two_files(self):
        out, card = self.path / "m.ttm", self.path / "m.card.toml"
        out.write_text("old")
        card.symlink_to(out)
        self.assertIn("both are written", complaint("train", "--data", self.scenes, "--out", out))
        said = shell(f"$T can decode {LOG} --summary --csv {self.path}/x.csv > {self.path}/x.csv", code=1).stderr
        self.assertIn("both are written", said)
        said = shell(f"$T reconstruct --data {self.scenes} --out {self.path}/e.csv >> {self.scenes}", code=1).stderr
        self.assertIn(REFUSED, said)
        self.assertEqual(self.scenes.read_bytes(), SCENES)


    def test_every_command_declares_its_files(self):
        """Options for files must use addInput() and similar functions; files of other options are not guarded."""
        sources = list(pathlib.Path(SOURCE, "app", "cli").glob("cli_*.cpp"))
        self.assertGreater(len(sources), 3)
        for source in sources:
            bare = re.findall(r'add_option\(\s*"(?:--(?:out|csv|data|model|robot|dbc|classes)|files?|log|parts)"', source.read_text())
            self.assertEqual(bare, [], source.name)


    def test_a_model_card_replaces_only_a_card(self):
        card, data = self.path / "q.card.toml", self.path / "many.csv"
        run("simulate", "--terrain", "boxes", "--count", 40, "--out", data)
        train = ("train", "--data", data, "--out", self.path / "q.ttm")
        card.write_text("my notes")
        self.assertIn("q.card.toml: is no model card", complaint(*train))
        self.assertEqual(card.read_text(), "my notes")
        shutil.copyfile(MODEL.replace(".ttm", ".card.toml"), card)
        run(*train)
        self.assertNotEqual(card.read_bytes(), pathlib.Path(MODEL.replace(".ttm", ".card.toml")).read_bytes())

    def test_unwritable_scenes_leave_no_session(self):
        out = self.path / "x.tts"
        said = complaint("import", self.scenes, "--mapping", MODEL, "--out", out, "--scenes", self.path / "none" / "o.csv")
        self.assertIn("o.csv: cannot be written", said, "before anything is read")
        self.assertFalse(out.exists())


class ClosedStreams(Scenes):
    def test_what_is_printed_goes_into_no_file(self):
        csv = self.path / "c.csv"
        csv.write_text("precious")
        for closed in ("<&- >&-", "<&- >&- 2>&-"):
            shell(f"$T can decode {LOG} --csv {csv} {closed}", code=1)
            self.assertNotIn("RobotStatus  ", csv.read_text(), closed)

    def test_the_exit_code_needs_no_place_for_messages(self):
        for command, code in (("contacts --data nofile", 1), ("foo", 2), (f"session info {DEMO}", 1)):
            for closed in (">&- 2>&-", ">/dev/full 2>/dev/full"):
                shell(f"$T {command} {closed}", code=code)

    def test_a_closed_standard_output_is_named(self):
        for command in (f"model show {MODEL}", f"can decode {LOG}", f"reconstruct --data {self.scenes} --out -"):
            for closed in (">&-", ">/dev/full"):
                self.assertIn("the standard output cannot be written", shell(f"$T {command} {closed}", code=1).stderr)


class Pipes(Scenes):
    def test_scenes_and_estimates_go_through_pipes(self):
        out = self.path / "est.csv"
        run("reconstruct", "--data", self.scenes, "--out", out)
        for command in (f"$T reconstruct --data - --out - < {self.scenes}", f"cat {self.scenes} | $T reconstruct --data - --out -",
                        f"$T reconstruct --data <(cat {self.scenes}) --out /dev/stdout",
                        f"cat {self.scenes} | $T reconstruct --data /dev/stdin --out >(cat) | grep -v ' written to '",
                        f"mkfifo {self.path}/in; cat {self.scenes} > {self.path}/in & $T reconstruct --data {self.path}/in --out -"):
            done = shell(command)
            self.assertEqual(done.stdout, out.read_text(), command)
        self.assertIn("6 scenes written to -", shell(f"$T reconstruct --data {self.scenes} --out -").stderr)
        self.assertEqual(shell("$T simulate --terrain varied --count 6 --seed 5 --out -").stdout.encode(), SCENES)

    def test_sessions_and_logs_are_exported_to_pipes(self):
        for name, arguments in (("a.csv", "--what events"), ("a.log", "--to 1"), ("a.asc", "--to 1")):
            run("session", "export", DEMO, "--out", self.path / name, *arguments.split())
            kind = {"log": "candump"}.get(name[2:], name[2:])
            self.assertEqual(shell(f"$T session export {DEMO} --out - --format {kind} {arguments}").stdout,
                             (self.path / name).read_text())
        run("can", "decode", LOG, "--csv", self.path / "v.csv")
        done = shell(f"$T can decode - --csv - < {LOG}")
        self.assertEqual(done.stdout, (self.path / "v.csv").read_text())
        self.assertIn("wrong checksum", done.stderr)

    def test_training_reads_a_pipe_once(self):
        model, piped = self.path / "a.ttm", self.path / "b.ttm"
        run("simulate", "--terrain", "boxes", "--count", 40, "--seed", 3, "--out", self.scenes)
        run("train", "--data", self.scenes, "--out", model, "--bins", "5")
        shell(f"cat {self.scenes} | $T train --data - --out {piped} --bins 5")
        data = [subprocess.run(["sqlite3", f], input="SELECT value FROM meta WHERE key = 'data_sha256'", text=True,
                               capture_output=True, check=True).stdout for f in (model, piped)] if shutil.which("sqlite3") else ["", ""]
        self.assertEqual(*data)

    def test_pipes_are_refused_where_seeking_is_needed(self):
        self.assertIn("read back and forth", shell(f"cat {DEMO} | $T session info -", code=1).stderr)
        self.assertIn("read back and forth", shell(f"cat {MODEL} | $T model show -", code=1).stderr)
        self.assertIn("several passes", complaint("train", "--data", self.scenes, "--out", "-", code=2))
        self.assertIn("several passes", complaint("session", "report", DEMO, "--out", "/dev/stdout", code=2))


class FullDisks(Scenes):
    def test_every_command_notices_a_full_standard_output(self):
        for command in ("--help", "--version", f"session info {DEMO}", f"session verify {DEMO}", f"model show {MODEL}",
                        f"model show {MODEL} --csv", f"session what-if {DEMO}", f"session recover {self.copy(DEMO, 'r.tts')}",
                        f"contacts --data {self.scenes}", f"can decode {LOG}",
                        f"simulate --terrain varied --count 1 --out -", f"session export {DEMO} --out - --format candump"):
            with self.subTest(command=command):
                self.assertIn("written" if "--help" not in command else "", shell(f"$T {command} > /dev/full", code=1).stderr
                              .replace("cannot write", "written"))
        self.assertIn("disk full", complaint("simulate", "--terrain", "varied", "--count", 1, "--out", "/dev/full"))


    def test_files_of_one_command_are_written_all_or_none(self):
        def too_large(most, command):
            shell(f"trap '' XFSZ; ulimit -f {most}; cd {self.path}; $T {command}", code=1)
            return sorted(p.name for p in self.path.rglob("*") if p.is_file())

        command = "simulate --tracks --terrain varied --count 8 --cloud c.pcd --poses p.csv --out s.csv"
        self.assertEqual(too_large(100, command), ["scenes.csv"])
        (self.path / "p.csv").write_text("old")
        self.assertEqual(too_large(100, command), ["p.csv", "scenes.csv"])
        self.assertEqual((self.path / "p.csv").read_text(), "old")
        nowhere = command.replace("s.csv", "none/s.csv --recording r.mcap")
        self.assertEqual(too_large("unlimited", nowhere), ["p.csv", "scenes.csv"])
        self.assertEqual(too_large(30, "evaluate --data scenes.csv --methods local --out ev"), ["p.csv", "scenes.csv"])

    def test_a_full_disk_is_named_with_a_remedy(self):
        if os.geteuid() != 0:
            self.skipTest("only root mounts a small disk")
        if subprocess.run(["unshare", "-m", "true"], capture_output=True, check=False).returncode != 0:
            self.skipTest("no disk of its own can be mounted here, as in a folder that chroot made the root")
        small = self.path / "small"
        small.mkdir()
        done = subprocess.run(["unshare", "-m", "bash", "-c", f"mount -t tmpfs -o size=64k none {small} || exit 77; "
                               f"$T session import {LOG} --out {small}/a.tts"], capture_output=True, text=True,
                              env=os.environ | {"T": CLI}, timeout=300, check=False)
        if done.returncode == 77:
            self.skipTest("no small disk can be mounted here")
        self.assertEqual(done.returncode, 1, done.stderr)
        self.assertIn(f"{small}/a.tts", done.stderr)
        self.assertIn("the disk is full: free space on it, or name a file on another disk", done.stderr)


class Ranges(Scenes):
    def test_an_export_of_nothing_is_an_error(self):
        out = self.path / "a.csv"
        export = ("session", "export", DEMO, "--out", out)
        for wrong in (("--from", "11", "--to", "8"), ("--from", "nan"), ("--to", "NaN"), ("--from", "x"),
                      ("--from", "inf")):
            complaint(*export, *wrong, code=2)
        self.assertIn("nothing was recorded from 1000 s on: the session lasts 82.6 s", complaint(*export, "--from", "1000"))
        self.assertIn("nothing was recorded until -5 s", complaint(*export, "--to", "-5"))
        self.assertIn("no estimates", complaint(*export, "--what", "estimates", "--from", "0", "--to", "1"))
        self.assertFalse(out.exists())
        self.assertIn("is a directory", complaint("session", "info", self.path))


class Numbers(Scenes):
    def test_options_refuse_what_is_no_number_in_range(self):
        out = self.path / "a.csv"
        simulate = ("simulate", "--terrain", "varied", "--count", "2", "--out", out)
        for wrong in (("--step", "nan"), ("--soft-drives", "NaN"), ("--seed", "-1"), ("--seed", "99999999999999999999999"),
                      ("--tracks", "--cloud", self.path / "m.pcd", "--poses", self.path / "p.csv", "--cloud-noise", "nan")):
            with self.subTest(wrong=wrong):
                self.assertIn(wrong[-2] + ": " + wrong[-1], complaint(*simulate, *wrong, code=2))
        self.assertFalse(out.exists())
        run(*simulate, "--seed", "18446744073709551615")

    def test_the_limit_of_file_sizes_is_an_error(self):
        for command in (f"session export {DEMO} --out {self.path}/a.csv", f"session import {LOG} --out {self.path}/a.tts"):
            with self.subTest(command=command):
                said = shell(f"ulimit -f 8; $T {command}", code=1).stderr
                self.assertIn("a.", said)
                self.assertRegex(said, "ulimit -f|File too large|disk full")
                self.assertEqual([p.name for p in self.path.iterdir() if p.name.startswith("a.")], [], said)


def heed_signals():
    """A shell without job control lets what it starts in the background ignore SIGINT."""
    for stop in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP):
        signal.signal(stop, signal.SIG_DFL)


class Interrupted(Scenes):
    def test_a_signal_leaves_nothing_half_written(self):
        line = pathlib.Path(LOG).read_text().splitlines()[0] + "\n"
        for stop in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP):
            for command in (("can", "decode", "-", "--csv", "a.csv"), ("session", "import", "-", "--out", "a.tts")):
                with self.subTest(stop=stop, command=command):
                    process = subprocess.Popen([CLI, *command], stdin=subprocess.PIPE, stdout=subprocess.DEVNULL,
                                               stderr=subprocess.DEVNULL, cwd=self.path, text=True,
                                               preexec_fn=heed_signals)
                    begun = lambda: [p.name for p in self.path.iterdir() if p.name.startswith("a.")]
                    while not begun():  # until it has begun to write
                        process.stdin.write(line)
                        process.stdin.flush()
                    process.send_signal(stop)
                    self.assertEqual(process.wait(60), -stop)
                    process.stdin.close()
                    self.assertEqual(begun(), [])


class Recordings(Scenes):
    def test_a_recording_from_a_pipe_is_refused(self):
        self.assertIn("save it as a file first",
                      shell(f"printf 't,pitch\\n0,0\\n' | cat | $T import - --probe", code=1).stderr)


class Csv(Scenes):
    def estimated(self, content):
        """Returns the estimates of the scenes in a file with this content."""
        data, out = self.path / "data.csv", self.path / "est.csv"
        data.write_bytes(content)
        run("reconstruct", "--data", data, "--out", out)
        return out.read_text()

    def test_scenes_of_spreadsheets_are_the_same_scenes(self):
        plain, text = self.estimated(SCENES), SCENES.decode()
        quoted = "\n".join(",".join(f'"{field}"' for field in line.split(",")) for line in text.splitlines())
        for content in (quoted, text.replace(",", ";").replace(".", ",").replace("h_-0,", "h_-0.").replace("h_+0,", "h_+0."),
                        text.replace(",", "\t"), "\ufeff" + text.replace("\n", "\r\n"), text.replace(",", ", ") + "\n\n",
                        "# " + text):
            self.assertEqual(self.estimated(content.encode()), plain, content[:200])

    def test_files_that_are_not_text_are_named(self):
        for content, says in ((SCENES.decode().encode("utf-16"), "UTF-16"), (b"PK\x03\x04" + SCENES, "workbook"),
                              (b"\x1f\x8b" + SCENES, "gzip"), (pathlib.Path(DEMO).read_bytes(), "session scenes")):
            self.scenes.write_bytes(content)
            self.assertIn(says, complaint("reconstruct", "--data", self.scenes, "--out", self.path / "est.csv"))

    def test_no_text_becomes_a_formula(self):
        session, out, estimates = self.copy(DEMO, "=cmd.tts"), self.path / "s.csv", self.path / "e.csv"
        run("session", "scenes", session, "--out", out)
        self.assertEqual(rows(out)[0]["run"], "'=cmd")
        run("reconstruct", "--data", out, "--out", estimates)
        self.assertEqual({r["run"] for r in rows(estimates)}, {"'=cmd"})

    def test_scenes_of_a_copy_are_taken_once(self):
        a, b = self.copy(DEMO, "a.tts"), self.copy(DEMO, "b.tts")
        done = shell(f"$T session scenes {a} {a} {b} --out {self.path}/s.csv")
        self.assertEqual(len(rows(self.path / "s.csv")), 1)
        self.assertEqual(done.stderr.count("the same recording"), 2)

    def test_probes_that_all_agree_are_named(self):
        readings = self.path / "probes.csv"
        for text, says in (("a,0.1,0.1\n" * 3 + "b,0.2,0.2\n" * 3, "all readings of a place are the same"),
                           ("a,0.1,\n" * 3, "all readings of a place are the same"),
                           ("a,0.1,0.11\n" * 2 + "b,0.2,0.18\n" * 2, "are they rounded, or copied?"),
                           ("a,0.1,\n" * 4 + "a,0.1001,\n", "the same, or nearly (sd below 0.05 mm)"),
                           ("a,0.1,0.1\nb,0.2,\n", "fewer than two readings have a truth"),
                           ("a,0.1,0\na,0.2,0.5\n", "line 3: truth_m of place 'a' is 0.5, and 0 in line 2"),
                           ("a,0.1,0.1\nb,0.2,0.2\n", "differs from its truth by the same")):
            readings.write_text("place,height_m,truth_m\n" + text)
            self.assertIn(says, complaint("probes", "--data", readings))


if __name__ == "__main__":
    unittest.main()
