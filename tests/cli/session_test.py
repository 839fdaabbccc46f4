"""Tests `terratact session`: tampered files, merging, what-if, reports. Argument: the program make_session."""

import pathlib
import re
import shutil
import sqlite3
import subprocess
import unittest
import xml.dom.minidom
import zlib

from session_support import Session, change, frames_of, make, setUpModule, tearDownModule  # noqa: F401
from support import CLI, SOURCE, complaint, rows, run


class Tampering(Session):
    def test_a_valid_session_prints_its_last_link(self):
        text = run("session", "verify", self.drive)
        link = re.search(r"last link ([0-9a-f]{64})", text)[1]
        run("session", "verify", self.drive, "--link", link)
        self.assertIn("sessions do not hold", complaint("session", "verify", self.drive, "--link", "0" * 64))
        info = run("session", "info", self.drive)
        self.assertIn(link, info)
        self.assertRegex(info, r"contradict \d+ of [1-9]\d* estimates contradict their readings\n")

    def test_changes_are_found_in_their_batch(self):
        for sql in ("UPDATE can_frame SET data = x'0011223344556677' WHERE seq = 700",
                    "DELETE FROM can_frame WHERE seq = 700",
                    "UPDATE estimate_bin SET height_m = height_m + 0.1 WHERE bin = 9",
                    "UPDATE event SET shown = 'CLEAR' WHERE kind = 'decision'"):
            with self.subTest(sql=sql):
                copy = self.copy()
                change(copy, sql)
                done = run("session", "verify", copy, code=1)
                self.assertRegex(done, r"DOES NOT HOLD")
                self.assertRegex(done, r"damage +2026-10-26 .* UTC \(\d+\.\d+ s\) to \d+\.\d+ s: ")

    def test_a_broken_chain_names_its_first_broken_batch(self):
        copy = self.copy()
        change(copy, "UPDATE batch SET t_last = t_last + 1 WHERE id = 12")
        text = run("session", "verify", copy, code=1)
        self.assertRegex(text, r"broken +from batch 12 on nothing is proven: 2026-10-26 .* UTC \(\d+\.\d+ s\)")

    def test_truncation_is_found_by_the_last_link(self):
        copy = self.copy()
        link = re.search(r"last link ([0-9a-f]{64})", run("session", "verify", copy))[1]
        last, frame = sqlite3.connect(copy).execute(
            "SELECT id, frame_first FROM batch ORDER BY id DESC LIMIT 1").fetchone()
        for sql in (f"DELETE FROM can_frame WHERE seq >= {frame}", f"DELETE FROM event WHERE batch = {last}",
                    f"DELETE FROM batch WHERE id = {last}"):
            change(copy, sql)
        run("session", "verify", copy)
        self.assertIn("was cut off", run("session", "verify", copy, "--link", link, code=1))

    def test_an_export_omits_and_reports_damaged_rows(self):
        copy, out = self.copy(), self.path / "part.log"
        change(copy, "UPDATE can_frame SET can_id = 1 WHERE seq = 700")
        first, count = sqlite3.connect(copy).execute(
            "SELECT frame_first, frame_count FROM batch WHERE frame_first <= 700 ORDER BY id DESC LIMIT 1").fetchone()
        done = subprocess.run([CLI, "session", "export", copy, "--out", out], capture_output=True, text=True, check=True)
        self.assertIn("left out", done.stderr)
        whole = self.export("drive.log").read_text().splitlines()
        self.assertEqual(out.read_text().splitlines(), whole[:first - 1] + whole[first - 1 + count:])

    def test_a_session_of_a_dead_program_is_recovered(self):
        path = self.path / "open.tts"
        make("open", path)
        self.assertIn("not closed", run("session", "verify", path))
        self.assertIn("recovered", run("session", "recover", path))
        self.assertIn("was closed already", run("session", "recover", path))
        self.assertEqual([p.name for p in self.path.iterdir()], ["open.tts"])
        self.assertNotIn("not closed", run("session", "verify", path))

    def test_files_that_are_no_sessions_are_refused(self):
        path = self.path / "no.tts"
        path.write_text("no session")
        for command in ("info", "recover"):
            self.assertIn("no.tts", complaint("session", command, path))
        self.assertIn("no.tts", run("session", "verify", path, code=1))


class Merging(Session):
    def test_sessions_of_different_sources_do_not_merge(self):
        imported = self.path / "imported.tts"
        run("session", "import", self.export("drive.log"), "--out", imported)
        out = self.path / "both.tts"
        self.assertIn("is of", complaint("session", "merge", self.drive, imported, "--out", out))
        self.assertFalse(out.exists())

    def test_two_drives_that_follow_each_other(self):
        later = self.path / "later.tts"
        make("later", later)
        out = self.path / "both.tts"
        text = run("session", "merge", later, self.drive, "--out", out)
        self.assertIn("2 sessions", text)
        frames = frames_of(self.drive)
        self.assertEqual(frames_of(out), frames + [(t + 60 * 10**9, i, d) for t, i, d in frames])
        self.assertIn(" holds", run("session", "verify", out))
        info = {path: run("session", "info", path) for path in (self.drive, out)}
        counts = {path: [int(n) for n in re.search(r"rows +(\d+) scenes, (\d+) estimates, (\d+) probes", text).groups()]
                  for path, text in info.items()}
        self.assertEqual(counts[out], [2 * n for n in counts[self.drive]])
        merged = sqlite3.connect(out).execute(
            "SELECT text FROM event WHERE kind = 'session' AND subject = 'merged' ORDER BY id").fetchall()
        link = re.search(r"last link ([0-9a-f]{64})", run("session", "verify", self.drive))[1]
        self.assertIn("drive.tts", merged[0][0])
        self.assertIn(link, merged[0][0])
        self.assertIn("later.tts", merged[1][0])
        run("session", "what-if", out, "--estimate", 4)

    def test_sessions_that_overlap_are_not_one_drive(self):
        out = self.path / "both.tts"
        self.assertIn("overlap", complaint("session", "merge", self.drive, self.copy(), "--out", out))
        self.assertFalse(out.exists())


class WhatIf(Session):
    def test_recorded_estimates_are_reproduced_bit_for_bit(self):
        text = run("session", "what-if", self.drive)
        self.assertEqual(text.count("reproduced bit for bit"), text.count(": estimate "))
        self.assertIn("later probes against the bands before them", text)
        self.assertIn("against the truth", text)

    def test_the_shipped_sessions_are_reproduced(self):
        shipped = sorted(pathlib.Path(SOURCE, "resources/sessions").glob("*.tts"))
        self.assertTrue(shipped)
        for session in shipped:
            with self.subTest(session.name):
                text = run("session", "what-if", session)
                self.assertGreaterEqual(text.count(": estimate "), 2)
                self.assertEqual(len(re.findall(r"reproduced (?:bit for bit|but for the last bits)", text)),
                                 text.count(": estimate "))

    def test_another_method_shows_both_sides(self):
        shown = run("session", "what-if", f"{SOURCE}/resources/sessions/two_tracks.tts", "--estimate", "2", "--method",
                    "joint", "--out", self.path / "sides.csv")
        self.assertRegex(shown, r"\n  left\n   bin(?s:.*)\n  right\n   bin")
        self.assertRegex(shown, r"moved most at \S+ m (left|right), by .* either side \d+ %\) now")
        lines = (self.path / "sides.csv").read_text().splitlines()
        self.assertEqual(lines[0].rsplit(",", 1)[1], "side")
        self.assertEqual([line.rsplit(",", 1)[1] for line in lines[1:]], ["left"] * 11 + ["right"] * 11)

    def test_scenes_of_both_sides_are_written_and_read(self):
        demo = f"{SOURCE}/resources/sessions/two_tracks.tts"
        tracks, plane = self.path / "tracks.csv", self.path / "plane.csv"
        self.assertIn("1 scenes with 22 known heights", run("session", "scenes", demo, "--tracks", "--out", tracks))
        self.assertIn("roll_rad", tracks.read_text().splitlines()[0])
        self.assertIn("1 scenes with 11 known heights", run("session", "scenes", demo, "--out", plane))
        self.assertNotIn("roll_rad", plane.read_text())
        self.assertIn("known in 1 scenes", complaint("session", "scenes", demo, "--out", plane, code=0))
        self.assertEqual(complaint("session", "scenes", demo, "--tracks", "--out", tracks, code=0), "")
        run("reconstruct", "--tracks", "--data", tracks, "--out", self.path / "estimates.csv")
        rows = (self.path / "estimates.csv").read_text().splitlines()[1:]
        self.assertEqual([row.split(",")[2] for row in rows], ["left"] * 11 + ["right"] * 11)

    def test_a_scene_of_means_has_equal_sides(self):
        tracks = self.path / "equal.csv"
        run("session", "scenes", f"{SOURCE}/resources/sessions/demo.tts", "--tracks", "--out", tracks)
        names, values = (line.split(",") for line in tracks.read_text().splitlines())
        scene = dict(zip(names, values))
        for name in names:
            if name.startswith("left_h"):
                self.assertEqual(scene[name], scene[name.replace("left", "right")])
        self.assertEqual(scene["roll_rad"], "0")

    def test_the_report_has_both_sides(self):
        page = self.path / "sides.html"
        run("session", "report", f"{SOURCE}/resources/sessions/two_tracks.tts", "--out", page)
        text = page.read_text()
        self.assertEqual(text.count("<svg"), 2)
        self.assertEqual(text.count("<tr>"), 1 + 22)
        for fact in ("left", "right", "either side", "cross slope"):
            self.assertIn(f"<dt>{fact}</dt>", text)

    def test_bands_are_judged_by_later_measurements(self):
        folder = self.path / "folder"
        folder.mkdir()
        make("moves", folder / "a.tts")
        title = "contacts and probes at later poses against the bands that odometry took there"
        one = run("session", "what-if", folder)
        self.assertRegex(one, title + r"\n.*bands\n  then +[1-9]\d* .*\n  now +[1-9]\d* .*\n$")
        make("moves-later", folder / "b.tts")
        both = run("session", "what-if", folder)
        lines = [line for line in both[both.index(title):].splitlines() if line.startswith("  then")]
        self.assertEqual([line.rsplit("/", 1)[-1] for line in lines[:2]], ["a.tts", "b.tts"])
        counts = [int(line.split()[1]) for line in lines]
        self.assertEqual(counts[2], counts[0] + counts[1])

    def test_other_settings_show_the_differences(self):
        out = self.path / "what_if.csv"
        text = run("session", "what-if", self.drive, "--estimate", 1, "--method", "local", "--out", out)
        self.assertIn("pafc: now local", text)
        moved = [abs(float(r["height_now_m"]) - float(r["height_then_m"])) for r in rows(out)]
        self.assertEqual(len(moved), 11)
        worst = 1000 * max(moved)
        self.assertIn("moved most at", text)
        self.assertIn(f"by {worst:.0f} mm", text)

    def test_a_falsified_estimate_is_found(self):
        """The recorder itself writes a false estimate, so all hashes are valid."""
        path = self.path / "lie.tts"
        make("lie", path)
        run("session", "verify", path)
        self.assertIn("NOT reproduced", run("session", "what-if", path, "--estimate", 2, code=1))

    def test_a_missing_model_is_requested(self):
        make("rows", self.path / "rows.tts")
        self.assertIn("rows.tts", complaint("session", "what-if", self.path / "rows.tts"))

    def test_a_folder_is_all_its_sessions(self):
        shutil.copy(self.drive, self.path / "a.tts")
        make("later", self.path / "b.tts")
        text = run("session", "what-if", self.path, "--method", "local")
        self.assertIn("of 2 sessions", text)
        self.assertRegex(text, r"a\.tts: estimate 1 [\s\S]*b\.tts: estimate 1 ")

    def test_a_copy_of_a_session_is_judged_once(self):
        copy = self.path / "other_name.tts"
        shutil.copy(self.drive, copy)
        twice = subprocess.run([CLI, "session", "what-if", self.drive, copy, self.drive], capture_output=True, text=True,
                               timeout=500, check=True)
        self.assertEqual(twice.stdout, run("session", "what-if", self.drive))
        self.assertEqual(twice.stderr.count("which is the same recording: they are taken once"), 2)


def pdf_objects(content):
    """Returns a PDF with its compressed streams unpacked behind it: cairo 1.18 compresses objects, too."""
    streams = re.findall(rb"stream\r?\n(.*?)\r?\nendstream", content, re.DOTALL)
    return content + b"".join(zlib.decompressobj().decompress(stream) for stream in streams if stream[:1] == b"x")


class Report(Session):
    def test_one_page_in_each_format(self):
        for ending, begin in (("pdf", b"%PDF"), ("svg", b"<?xml"), ("png", b"\x89PNG"), ("html", b"<!DOCTYPE html>")):
            out = self.path / f"report.{ending}"
            run("session", "report", self.drive, "--out", out)
            content = out.read_bytes()
            self.assertTrue(content.startswith(begin), ending)
            if ending == "pdf":
                self.assertEqual(len(re.findall(rb"/Type /Page\b(?!s)", pdf_objects(content))), 1)
            if ending == "svg":
                xml.dom.minidom.parseString(content)

    def test_the_page_shows_the_content_of_the_session(self):
        out = self.path / "report.html"
        run("session", "report", self.drive, "--scene", 2, "--out", out)
        page = out.read_text()
        link = re.search(r"last link ([0-9a-f]{64})", run("session", "verify", self.drive))[1]
        for words in ("method local", "approve", "on the screen: sd", link, "default.ttm", "every hash holds", "Absolem"):
            self.assertIn(words, page)
        self.assertIn("no scene 9", complaint("session", "report", self.drive, "--scene", 9, "--out", out))

    def test_the_mission_report_holds_the_whole_session(self):
        source = f"{SOURCE}/resources/sessions/two_tracks.tts"
        out = self.path / "mission.html"
        text = run("session", "report", source, "--mission", "--out", out)
        self.assertNotIn("in place of", text)
        page = out.read_text()
        info = run("session", "info", source)
        link = re.search(r"last link +([0-9a-f]{64})", info)[1]
        for words in ("Strip of felt ground", "Active settings", "No alarm was raised", "probe proposed on estimate 1",
                      "operator: approve", "error against the truth", "Every hash holds", link):
            self.assertIn(words, page)
        self.assertNotRegex(page, r"<script|https?://(?!www\.w3\.org/)")
        names = re.findall(r'\bid="([^"]*)"', page)
        self.assertEqual(len(names), len(set(names)))
        self.assertIn("in place of the file there", run("session", "report", source, "--mission", "--out", out))

    def test_the_mission_report_has_the_same_bytes_again(self):
        pages = []
        for name in ("a.pdf", "b.pdf"):
            run("session", "report", self.drive, "--mission", "--out", self.path / name)
            pages.append((self.path / name).read_bytes())
        self.assertTrue(pages[0].startswith(b"%PDF"))
        self.assertEqual(pages[0], pages[1])
        self.assertNotIn(b"CreationDate", pdf_objects(pages[0]))
        out = self.path / "mission.png"
        self.assertIn(".pdf or .html", complaint("session", "report", self.drive, "--mission", "--out", out))
        self.assertFalse(out.exists())


if __name__ == "__main__":
    unittest.main()
