"""Tests the command line: chains of commands, files, exit codes and error messages."""

import csv
import math
import os
import pathlib
import re
import resource
import subprocess
import tempfile
import unittest
import unittest.mock

from support import CLI, SOURCE, complaint, needs_no_sanitizer, rows, run

# Of a training or a campaign: six times as long with a sanitizer.
IN_CORE = "the tests of core compute the same in less"

COLUMNS = "run,t_s,bin_m,mean_m,sd_m,q10_m,q90_m,source,ceiling_m,rhat,ess,truth_m,note,height_m,p_step,p_step_sd,two_modes,novelty,draws,ending,touch,horizon_m,verdict".split(",")


class Commands(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.path = pathlib.Path(cls.folder.name)
        cls.data, cls.model = cls.path / "scenes.csv", cls.path / "small.ttm"
        run("simulate", "--terrain", "boxes", "--count", 90, "--seed", 3, "--out", cls.data)
        cls.trained = run("train", "--data", cls.data, "--out", cls.model, "--seed", 3)

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    def reconstruct(self, *arguments, data=None):
        out = self.path / "est.csv"
        run("reconstruct", "--model", self.model, "--data", data or self.data, "--out", out, "--sweeps", 64,
            "--chains", 4, *arguments)
        return rows(out)

    def first_scenes(self, count):
        few = self.path / "few.csv"
        few.write_text("".join(self.data.read_text().splitlines(keepends=True)[: count + 1]))
        return few

    def test_every_command_prints_its_help(self):
        for command in ("simulate", "train", "reconstruct", "evaluate", "merge", "tradeoff", "contacts", "faults", "probes", "calibrate", "panel",
                        "demo", "model"):
            self.assertIn("--help", run(command, "--help"))
        self.assertIn("terratact", run("--version"))

    def test_wrong_arguments_exit_with_2(self):
        for arguments in ((), ("fly",), ("train",), ("simulate", "--terrain", "boxes"),
                          ("reconstruct", "--data", "x", "--out", "y", "--method", "pax"),
                          ("reconstruct", "--data", "x", "--out", "y", "--chains", "0")):
            self.assertTrue(complaint(*arguments, code=2))

    def test_an_unknown_word_is_named_before_a_missing_one(self):
        self.assertIn(": simulat --terrain boxes", complaint("simulat", "--terrain", "boxes", code=2))
        self.assertIn(": --bogus a b", complaint("simulate", "--out", "x", "--bogus", "a", "b", code=2))
        self.assertIn("lists", complaint("session", "lists", code=2))
        self.assertIn("--tarrain", complaint("simulate", "--tarrain", "boxes", code=2))
        self.assertIn("subcommand is required", complaint(code=2))

    def limited(self, megabytes, *arguments):
        """Returns (exit code, stderr) with limited address space (ulimit -v); a program that hangs fails the test."""
        limit = megabytes << 20
        done = subprocess.run([CLI, *map(str, arguments)], capture_output=True, text=True, timeout=100,
                              preexec_fn=lambda: resource.setrlimit(resource.RLIMIT_AS, (limit, limit)))
        return done.returncode, done.stderr

    def test_commands_without_algebra_need_little_memory(self):
        needs_no_sanitizer(self)
        demo = f"{SOURCE}/resources/sessions/demo.tts"
        # Later versions of OpenBLAS than 0.3.21 need 128 MB before the program starts.
        openblas = r"terratact: OpenBLAS needs \d+ MB of memory; this process uses .* Raise the limit"
        early = re.match(openblas, self.limited(150, "--version")[1])
        for megabytes in (400,) if early else (150, 200, 400):
            for arguments in (("--version",), ("train", "--help"), ("session", "info", demo), ("session", "verify", demo),
                              ("can", "decode", f"{SOURCE}/docs/can_demo.log")):
                self.assertEqual(self.limited(megabytes, *arguments), (0, ""), arguments)

    def test_a_command_without_memory_names_the_shortage(self):
        needs_no_sanitizer(self)
        model, codes = self.path / "limited.ttm", []
        for megabytes in (100, 150, 200, 300, 400, 600):
            code, said = self.limited(megabytes, "train", "--data", self.data, "--out", model)
            codes.append(code)
            if code:
                self.assertFalse(model.exists())
                self.assertRegex(said, r"terratact: .* needs .*memory.*; this process uses \d+ of the \d+ MB that "
                                       r"ulimit -v leaves it(, so \d+ MB are missing)?\. Raise the limit")
            model.unlink(missing_ok=True)
        self.assertEqual((codes[0], codes[-1]), (1, 0), codes)

    def test_an_estimate_has_the_reason_of_its_end(self):
        data = self.first_scenes(2)
        method = ("--method", "pa", "--full")
        self.assertEqual({(r["ending"], r["draws"]) for r in self.reconstruct(*method, data=data)}, {("sweeps", "64")})
        hurried = self.reconstruct(*method, "--seconds", "1e-9", data=data)
        self.assertEqual({(r["ending"], r["draws"]) for r in hurried}, {("time", "16")})
        self.assertIn("when time was out", hurried[0]["note"])
        self.assertEqual({r["ending"] for r in self.reconstruct("--method", "local", data=data)}, {"not sampled"})

    def test_the_time_limit_ends_the_burn_in(self):
        data = self.first_scenes(2)
        hurried = self.reconstruct("--method", "pa", "--burn-in", 1000000, "--seconds", "0.05", data=data)
        self.assertEqual({(r["ending"], r["draws"]) for r in hurried}, {("time", "16")})
        self.assertRegex(hurried[0]["note"], r"time was out \d+ sweeps before the burn-in's end")

    def test_tradeoff_measures_a_method(self):
        data, out = self.first_scenes(1), self.path / "tradeoff"
        text = run("tradeoff", "--model", self.model, "--data", data, "--methods", "pafc,local", "--reference-sweeps",
                   160, "--out", out)
        self.assertRegex(text, r"pafc +160 draws, worst R-hat \d\.\d+, worst effective draws \d+, "
                               r"error of the means \d+\.\d+ mm\n +WARNING: fewer than \d{4,} draws.*\n +WARNING: R-hat above 1.01")
        points = rows(out / "tradeoff.csv")
        self.assertEqual({(p["method"], p["varied"]) for p in points},
                         {(m, v) for m in ("pafc", "local") for v in ("fast", "balanced", "accurate", "draws")}
                         | {("pafc", v) for v in ("chains", "inducing", "precision", "early stop")})
        for p in points:
            for number in ("ms", "mean_off_mm", "quantile_off_mm", "error_mm", "crps_mm"):
                self.assertTrue(0.0 <= float(p[number]) < 1e5, p)
            self.assertLessEqual(1, int(p["used"]))
            self.assertLess(int(p["used"]), int(p["draws"]) + int(p["chains"]))
            self.assertIn(float(p["converged"]), (0.0, 1.0))  # share for one scene
        self.assertEqual({p["converged"] for p in points if p["method"] == "local"}, {"1"})
        self.assertTrue(all(float(p["quantile_off_mm"]) > 0.0 for p in points if p["method"] == "pafc"))
        self.assertIn("1", {p["front_reference"] for p in points})
        presets = rows(out / "presets.csv")
        self.assertEqual([(p["method"], p["quality"]) for p in presets],
                         [(m, q) for m in ("pafc", "local") for q in ("fast", "balanced", "accurate")])
        self.assertIn(b"<svg", (out / "tradeoff.svg").read_bytes())
        self.assertEqual((out / "tradeoff.png").read_bytes()[:4], b"\x89PNG")

    def test_contacts_shows_a_table_per_rule(self):
        text = run("contacts", "--data", self.data)
        self.assertIn("contact rule: isolated", text)
        self.assertIn("contact rule: any", text)
        self.assertEqual(len([line for line in text.splitlines() if line.split()[:1] == ["all"]]), 2)
        self.assertIn("no contact", complaint("contacts", "--data", self.data, "--threshold", 900))

    def test_faults_prints_which_faults_are_noticed(self):
        needs_no_sanitizer(self, IN_CORE)
        text = run("faults", "--model", self.model, "--drives", 1)
        rows_ = {line[:38].strip(): line[38:].split() for line in text.splitlines() if re.match(r".{38} +\d+\.\d", line)}
        self.assertEqual(float(rows_["none"][2]), 0.0, "no scene of a sound robot is suspect")
        self.assertEqual(float(rows_["pitch stuck at 0"][2]), 100.0)
        self.assertGreater(float(rows_["pitch stuck at 0"][0]), float(rows_["none"][0]))
        self.assertIn("pitch +3°: a tilt of the whole world", text.replace(" (harmless)", ""))
        self.assertRegex(text, r"\d+ of \d+ faults that harm are noticed")

    def test_training_prints_the_condition_of_its_models(self):
        shown = run("model", "show", self.model)
        for models in ("pa", "paf"):
            line = re.search(rf"least reciprocal condition number of the {models} models: .*", shown)[0]
            self.assertIn(line, self.trained)

    def test_training_repeats_to_the_bit(self):
        again = self.path / "again.ttm"
        run("train", "--data", self.data, "--out", again, "--seed", 3)
        numbers = [run("model", "show", model).split("pa models", 1)[1] for model in (self.model, again)]
        self.assertIn("residual sd", numbers[0])
        self.assertEqual(*numbers)

    def test_a_model_card_has_date_data_and_scores(self):
        model = self.path / "carded.ttm"
        model.write_bytes(self.model.read_bytes())
        shown = run("model", "show", model)
        for missing in (r"trained +unknown", r"ground +unknown; \d+ %", r"errors +unknown"):
            self.assertRegex(shown, missing)
        trained = run("model", "show", self.model)
        self.assertRegex(trained, r"trained  20\d\d-\d\d-\d\dT\d\d:\d\d:\d\dZ\nground   " + self.data.name)
        with unittest.mock.patch.dict(os.environ, SOURCE_DATE_EPOCH="86400"):
            run("evaluate", "--card", "--model", model, "--data", self.first_scenes(6), "--methods", "local,joint", "--out",
                self.path / "carded")
        run("model", "card", model, "--trained", "2026-01-02T03:04:05Z", "--terrain", "boxes")
        shown = run("model", "show", model)
        self.assertIn("trained  2026-01-02T03:04:05Z\nground   boxes; ", shown)
        for method in ("local", "joint"):
            self.assertRegex(shown, rf"errors   {method}: mean \d+\.\d mm, the 80 % band holds \d+ %; 6 scenes of .*, 1970-01-02T00:00:00Z")
        means = {row["method"]: 1000 * float(row["mean_m"]) for row in rows(self.path / "carded/scores.csv") if row.get("method") in ("local", "joint")}
        for method, mean in means.items():
            self.assertIn(f"{method}: mean {mean:.1f} mm", shown)
        self.assertEqual(len(means), 2)
        self.assertIn("not a date", complaint("model", "card", model, "--trained", "today"))
        self.assertIn("another model", complaint("model", "card", self.swapped(model), "--terrain", "boxes"))

    def swapped(self, model):
        """Makes a model beside another model's card."""
        other = self.path / "other.ttm"
        run("train", "--data", self.data, "--out", other, "--seed", 3, "--inducing", 40)
        (self.path / "other.card.toml").write_bytes(model.with_suffix(".card.toml").read_bytes())
        return other

    def test_a_sparse_model_is_marked_and_estimates(self):
        sparse = self.path / "sparse.ttm"
        run("train", "--data", self.data, "--out", sparse, "--seed", 3, "--inducing", 40)
        self.assertIn("at most 40 scenes", run("model", "show", sparse))
        self.assertNotIn("at most", run("model", "show", self.model))
        few, out = self.first_scenes(2), self.path / "sparse.csv"
        means = []
        for model, more in ((sparse, ()), (self.model, ("--inducing", 40)), (self.model, ())):
            run("reconstruct", "--model", model, "--data", few, "--out", out, "--sweeps", 64, "--chains", 4,
                "--method", "pac", *more)
            means.append([row["mean_m"] for row in rows(out)])
        self.assertEqual(means[0], means[1])
        self.assertNotEqual(means[0], means[2])

    def test_reconstruct_writes_a_row_per_scene_and_bin(self):
        few = self.first_scenes(3)
        for method in ("pa", "pac", "pafc", "pafac"):
            estimates = self.reconstruct("--method", method, data=few)
            self.assertEqual(len(estimates), 3 * 11)
            self.assertEqual(list(estimates[0]), COLUMNS)
            for row in estimates:
                self.assertTrue(math.isfinite(float(row["mean_m"])))
                self.assertIn(row["source"], ("sampled", "contact", "arm"))
                if method in ("pac",) and row["ceiling_m"]:
                    self.assertLessEqual(float(row["q90_m"]), float(row["ceiling_m"]))
            if method in ("pa", "pac"):
                self.assertEqual({row["source"] for row in estimates}, {"sampled"})

    def test_the_simulated_arm_reads_with_the_arms_noise(self):
        def arms():
            return [row for row in self.reconstruct("--method", "pafac") if row["source"] == "arm"]
        read = arms()
        self.assertGreater(len(read), 5)
        errors = [float(row["mean_m"]) - float(row["truth_m"]) for row in read]
        self.assertTrue(all(0.0 < abs(error) < 0.15 for error in errors), errors)
        self.assertTrue(0.01 < (sum(error**2 for error in errors) / len(errors))**0.5 < 0.06, errors)
        self.assertEqual({float(row["sd_m"]) for row in read}, {0.03})
        self.assertEqual(read, arms())

    def test_reconstruct_repeats_for_a_seed(self):
        few = self.first_scenes(4)
        self.assertEqual(self.reconstruct("--seed", 5, data=few), self.reconstruct("--seed", 5, data=few))
        sampled = [self.reconstruct("--method", "pafc", "--seed", seed, data=few) for seed in (5, 6)]
        self.assertNotEqual(*sampled)

    def test_batched_scenes_equal_single_scenes(self):
        """Several scenes share a pass over any number of processors; scene k uses seed + k."""
        header, *scenes = self.data.read_text().splitlines(keepends=True)[:12]
        few, one = self.first_scenes(len(scenes)), self.path / "one.csv"
        for method in ("pafac", "clearance"):
            together = self.reconstruct("--method", method, "--seed", 5, data=few)
            alone = []
            for number, scene in enumerate(scenes):
                one.write_text(header + scene)
                alone += self.reconstruct("--method", method, "--seed", 5 + number, data=one)
            self.assertEqual(together, alone)
            processors = os.sched_getaffinity(0)
            os.sched_setaffinity(0, {min(processors)})
            try:
                self.assertEqual(self.reconstruct("--method", method, "--seed", 5, data=few), together)
            finally:
                os.sched_setaffinity(0, processors)

    def test_training_reads_a_repeated_file_once(self):
        header, *scenes = self.data.read_text().splitlines(keepends=True)
        twice, model = self.path / "twice.csv", self.path / "twice.ttm"
        twice.write_text("".join([header, *scenes, *("x" + scene for scene in scenes)]))
        done = subprocess.run([CLI, "train", "--data", twice, "--out", model, "--seed", "3", "--inducing", "40"],
                              capture_output=True, text=True, timeout=500)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertRegex(done.stderr, r"\d+ scenes are there twice: their copies were left out")
        self.assertRegex(done.stdout, rf"\n{len(scenes)} scenes; ")

    def test_evaluate_reports_training_scenes(self):
        model, data = self.path / "learnt.ttm", self.first_scenes(6)
        model.write_bytes(self.model.read_bytes())
        text = data.read_text()
        near = re.sub(r"(?m)^(\d+,[^,]+),([^,]+)", lambda m: f"{m[1]},{float(m[2]) + 0.006}", text)  # another pitch
        for scenes in (text, near):
            data.write_text(scenes)
            done = subprocess.run([CLI, "evaluate", "--card", "--model", model, "--data", data, "--methods", "joint",
                                   "--out", self.path / "learnt"], capture_output=True, text=True, timeout=500)
            self.assertRegex(done.stderr, "6 of 6 scenes are training scenes of this model or near copies of them: ")
            self.assertRegex(done.stderr, r"joint: [0-6] of 6 estimates contradict their readings\n")
        self.assertEqual((self.path / "learnt.card.toml").read_text().count("training_scenes = 6\n"), 2)
        self.assertEqual(run("model", "show", model).count("; 6 of them are training scenes or near copies"), 2)

    def test_evaluate_measures_what_missing_sensors_cost(self):
        out = self.path / "missing"
        text = self.evaluate(out, "--missing", "--methods", "local", count=4)
        self.assertIn("currents and forces", text)
        table = {row["not_measured"]: row for row in rows(out / "missing.csv")}
        self.assertEqual(len(table), 12)
        self.assertEqual({row["scenes"] for row in table.values()}, {"4"})
        self.assertNotEqual(table["right array"]["mean_m"], table["none"]["mean_m"])

    def two_tracks_of_a_wrong_pitch_are_withheld(self, model, scenes):
        wrong, out = self.path / "wrong.csv", self.path / "wrong_est.csv"
        table = rows(scenes)[:20]
        for row in table:
            row["pitch_rad"] = float(row["pitch_rad"]) + 0.4
        with open(wrong, "w", newline="") as file:
            writer = csv.DictWriter(file, table[0])
            writer.writeheader()
            writer.writerows(table)
        said = run("reconstruct", "--tracks", "--model", model, "--data", wrong, "--out", out)
        count = int(re.search(r"\n(\d+) estimates contradict their readings: their verdict is withheld\n", said).group(1))
        self.assertGreater(count, 0)
        told = [row["verdict"] for row in rows(out)][::22]
        self.assertGreaterEqual(told.count("CANNOT TELL"), count)

    def test_two_tracks_are_learnt_and_evaluated(self):
        needs_no_sanitizer(self, IN_CORE)
        scenes, model, out = self.path / "two.csv", self.path / "two.ttm", self.path / "two"
        run("simulate", "--terrain", "varied", "--tracks", "--count", 160, "--seed", 3, "--out", scenes)
        said = run("train", "--data", self.data, "--tracks", scenes, "--out", model, "--seed", 3, "--inducing", 40)
        self.assertRegex(said, r"two tracks: 22 Gaussian processes for both sides; 1\d\d scenes kept")
        refused = complaint("hazards", "--memory", "--drives", 1, code=2)
        self.assertIn("--memory requires --tracks", refused)
        refused = complaint("hazards", "--tracks", "--drives", 1, "--method", "pafc")
        self.assertIn("method pafc estimates one plane, expected local or joint", refused)
        table = run("evaluate", "--tracks", "--model", model, "--data", scenes, "--methods", "local", "--out", out)
        error = {(row["approach"], row["what"]): float(row["median_m"]) for row in rows(out / "tracks.csv")}
        self.assertLess(error["two tracks", "beyond"], error["one plane", "beyond"])
        self.assertIn("two tracks", table)
        done = subprocess.run([CLI, "evaluate", "--tracks", "--missing", "--model", model, "--data", scenes, "--methods",
                               "local", "--out", out], capture_output=True, text=True, timeout=500, check=True)
        self.assertRegex(done.stderr, r"1(\d\d) of 1\1 scenes are training scenes of this model")
        width = {row["not_measured"]: float(row["width_80_m"]) for row in rows(out / "missing.csv")}
        self.assertIn("right array", width)
        self.assertNotIn(width["nothing"], [width[f"right element {e}"] for e in range(1, 7)])
        estimates = self.path / "est_two.csv"
        run("reconstruct", "--tracks", "--model", model, "--data", scenes, "--out", estimates)
        table = rows(estimates)
        self.assertEqual({row["side"] for row in table}, {"left", "right"})
        for i in range(0, len(table), 22):  # both sides of a scene
            sides, row = {table[i]["side_verdict"], table[i + 11]["side_verdict"]}, table[i]
            told = "BLOCKED" if "BLOCKED" in sides else "CLEAR" if sides == {"CLEAR"} else "CANNOT TELL"
            starts = ("left ", "both ") if row["verdict"] == told else (f"{row['verdict']} for the robot · ",)
            self.assertTrue(row["text"].startswith(starts), (sides, row))
        self.assertTrue(any(row["verdict"] != row["side_verdict"] for row in table))
        self.two_tracks_of_a_wrong_pitch_are_withheld(model, scenes)
        again = self.path / "again.ttm"
        run("train", "--plane", self.model, "--tracks", scenes, "--seed", 3, "--out", again)
        few, outs = self.first_scenes(3), []
        for source in (self.model, again):
            run("reconstruct", "--model", source, "--data", few, "--out", self.path / "one.csv")
            outs.append((self.path / "one.csv").read_bytes())
        self.assertEqual(*outs)  # one plane stays as it is
        complaint("train", "--plane", self.model, "--data", self.data, "--tracks", scenes, "--out", again, code=2)
        complaint("train", "--out", again, code=2)
        self.assertIn("train --tracks", complaint("evaluate", "--tracks", "--model", self.model, "--data", scenes, "--out", out))
        complaint("train", "--data", self.data, "--tracks", scenes, "--bins", "3", "--out", model, code=2)

    def test_scenes_with_unknown_forces_are_estimated(self):
        few = self.first_scenes(2)
        header, first, second = few.read_text().splitlines()
        fields = second.split(",")
        fields[header.split(",").index("force_3_n")] = ""
        few.write_text("\n".join((header, first, ",".join(fields))) + "\n")
        estimates = self.reconstruct("--method", "pafc", data=few)
        self.assertEqual(len(estimates), 22)
        for method in ("pafc", "local", "clearance"):
            estimates = self.reconstruct("--method", method, data=few)
            self.assertNotEqual(estimates[11]["mean_m"], "")
            self.assertIn("the force of element 3 was not measured", estimates[11]["note"])
            self.assertNotIn("not measured", estimates[0]["note"])

    def evaluate(self, out, *arguments, count=12):
        return run("evaluate", "--model", self.model, "--data", self.first_scenes(count), "--out", out, "--sweeps", 64,
                   *arguments)

    def test_evaluate_writes_its_files_and_tables(self):
        out = self.path / "evaluation"
        text = self.evaluate(out)
        self.assertEqual(sorted(p.name for p in out.iterdir()),
                         ["coverage.csv", "errors.csv", "fig8.csv", "fig8.png", "fig8.svg", "fig9.csv", "fig9.png",
                          "fig9.svg", "novelty.csv", "pit.csv", "pit.png", "pit.svg", "reliability.csv", "scores.csv", "steps.csv"])
        methods = ["pa", "pac", "pafc", "pafac", "clearance", "joint", "local", "flat", "linear", "nearest", "gp-s"]
        for method in methods:
            errors = [row for row in rows(out / "errors.csv") if row["method"] == method]
            if method == "clearance":  # declines poses with too few similar training scenes
                self.assertIn(len(errors), range(8 * 11, 12 * 11 + 1))
            else:
                self.assertEqual(len(errors), 12 * 11, method)
        self.assertEqual([row["method"] for row in rows(out / "scores.csv")], methods)
        for row in rows(out / "errors.csv"):
            self.assertGreaterEqual(float(row["crps_m"]), 0.0)
            self.assertTrue(0.0 <= float(row["pit"]) <= 1.0)
            self.assertLessEqual(int(row["in_50"]), int(row["in_95"]))
        for word in methods + ["CRPS", "Brier score", "Reliability"]:
            self.assertIn(word, text)
        self.assertEqual((out / "fig8.png").read_bytes()[:8], b"\x89PNG\r\n\x1a\n")
        self.assertIn(b"<svg", (out / "pit.svg").read_bytes())

    def test_evaluate_scores_classes_and_probes(self):
        out, index = self.path / "classes", self.path / "index.csv"
        index.write_text('row,source,kind\n1,made up,"boxes, low"\n2,made up,other\n')
        text = self.evaluate(out, "--methods", "pa", "--classes", index, "--class-column", "kind", "--probes",
                             "--step-limit", "0.15", count=6)
        self.assertEqual({row["class"] for row in rows(out / "classes.csv")}, {"boxes, low", "other"})
        self.assertEqual([row["rule"] for row in rows(out / "probes.csv")], ["sd", "variance", "step"])
        self.assertIn("step of more than 150 mm", text)
        index.write_text("row,source\n1,made up\n")
        self.assertIn("no column class", complaint("evaluate", "--model", self.model, "--data", self.data, "--out", out,
                                                   "--classes", index))

    def test_the_demo_does_the_whole_job(self):
        out = self.path / "demo"
        text = run("demo", "--out", out, "--sweeps", 320)
        self.assertIn("First estimate", text)
        self.assertIn("SIMULATED ROBOT", text)
        self.assertTrue((out / "first.csv").exists() and (out / "first.png").exists())

    def test_bad_files_are_refused_and_nothing_is_written(self):
        good = self.data.read_bytes()
        header, rest = good.split(b"\n", 1)
        cases = {
            "empty": b"",
            "torn": good[:-20],
            "no pitch": header.replace(b"pitch_rad", b"tilt") + b"\n" + rest,
            "not a number": good.replace(rest.split(b",")[2], b"abc", 1),
            "nan": good.replace(rest.split(b",")[2], b"nan", 1),
            "degrees": good.replace(rest.split(b",")[3], b"35.0", 1),
            "binary": bytes(range(256)) * 40,
        }
        for name, content in cases.items():
            bad, out = self.path / "bad.csv", self.path / "never.csv"
            bad.write_bytes(content)
            for command in (("reconstruct", "--model", self.model), ("train",)):
                with self.subTest(case=name, command=command[0]):
                    said = complaint(*command, "--data", bad, "--out", out)
                    self.assertIn("bad.csv", said)
                    self.assertEqual(said.count("\n"), 1, said)
                    self.assertFalse(out.exists())
        self.assertEqual([p.name for p in self.path.iterdir() if "never" in p.name], [])

    def test_bad_models_are_refused_in_one_sentence(self):
        good = self.model.read_bytes()
        flipped = bytearray(good)
        position = good.find(b"pitch_rad")
        flipped[position] ^= 1
        for content in (b"", good[:5000], bytes(flipped), b"no database " * 100):
            bad = self.path / "bad.ttm"
            bad.write_bytes(content)
            said = complaint("model", "show", bad)
            self.assertIn("bad.ttm", said)
            self.assertEqual(said.count("\n"), 1, said)

    def test_a_missing_directory_is_named(self):
        said = complaint("simulate", "--terrain", "boxes", "--count", 30, "--out", "/nowhere/at/all.csv")
        self.assertIn("/nowhere/at/all.csv", said)

    def test_crlf_and_any_column_order_are_read(self):
        lines = [line.split(",") for line in self.first_scenes(3).read_text().splitlines()]
        turned = self.path / "turned.csv"
        turned.write_bytes(b"".join((",".join(reversed(line)) + "\r\n").encode() for line in lines))
        self.assertEqual(self.reconstruct(data=turned), self.reconstruct(data=self.first_scenes(3)))

    def test_no_progress_is_printed_without_a_terminal(self):
        done = subprocess.run([CLI, "simulate", "--terrain", "boxes", "--count", "60", "--out", self.path / "quiet.csv"],
                              capture_output=True, check=True)
        self.assertEqual(done.stderr, b"")

    def test_the_shipped_model_shows_its_origin(self):
        text = run("model", "show", f"{SOURCE}/resources/models/default.ttm")
        for models in ("pa", "paf"):
            rcond = float(re.search(rf"least reciprocal condition number of the {models} models: (\S+)", text)[1])
            self.assertTrue(1e-12 <= rcond < 1.0, rcond)
        self.assertIn("with a jitter of 1e-06", text)
        self.assertNotIn("is singular", text)
        self.assertIn("terratact train", text)
        models = pathlib.Path(SOURCE) / "resources/models"
        self.assertLess((models / "default.ttm").stat().st_size, 10_000_000)
        self.assertLess((models / "one_plane.ttm").stat().st_size, 8_000_000)


if __name__ == "__main__":
    unittest.main()
