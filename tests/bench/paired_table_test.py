"""Tests that two builds are compared by the least time of their benchmarks: tests/bench/paired.sh and its table."""
import json
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

BENCH = pathlib.Path(os.environ["TERRATACT_SOURCE_DIR"], "tests/bench")

# A program in place of terratact-bench: it notes its build, and takes as long as the build's file says.
PROGRAM = """#!/bin/sh
build=$(dirname "$(dirname "$0")")
basename "$build" >>"$build/../order"
cat "$build/result.json"
"""


def result(**times):
    rows = [{"name": name, "run_name": name, "cpu_time": time, "time_unit": "us"} for name, time in times.items()]
    return json.dumps({"benchmarks": rows})


class PairedTable(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.path = pathlib.Path(self.folder.name)

    def tearDown(self):
        self.folder.cleanup()

    def table(self, *options, **files):
        """Writes old_1=… as old-1.json and so on. Returns exit code, rows by name and the complaint."""
        for name, content in files.items():
            (self.path / (name.replace("_", "-") + ".json")).write_text(content)
        done = subprocess.run([sys.executable, "-B", BENCH / "paired_table.py", *options, self.path],
                              capture_output=True, text=True, check=False)
        rows = {line.split()[0]: line.split()[1:] for line in done.stdout.splitlines()[1:]}
        return done.returncode, rows, done.stderr

    def test_the_least_time_of_the_rounds_counts(self):
        code, rows, _ = self.table(old_1=result(draw=2.0), old_2=result(draw=4.0), new_1=result(draw=9.0),
                                   new_2=result(draw=2.0))
        self.assertEqual((code, rows), (0, {"draw": ["2.000", "2.000", "1.000"]}))

    def test_a_slower_benchmark_is_named(self):
        files = {"old_1": result(draw=100.0, sweep=100.0), "new_1": result(draw=104.0, sweep=106.0)}
        code, rows, complaint = self.table(**files)
        self.assertEqual((code, rows["sweep"][2]), (1, "1.060"))
        self.assertEqual(complaint, "more than 1.05 times as long: sweep\n")
        self.assertEqual(self.table("--limit", "1.1", **files)[0], 0)

    def test_units_are_converted(self):
        slow = json.dumps({"benchmarks": [{"name": "draw", "cpu_time": 0.5, "time_unit": "ms"}]})
        self.assertEqual(self.table(old_1=result(draw=500.0), new_1=slow)[1], {"draw": ["500.000", "500.000", "1.000"]})

    def test_a_benchmark_of_one_build_has_no_ratio(self):
        code, rows, _ = self.table(old_1=result(draw=1.0, gone=2.0), new_1=result(draw=1.0, added=3.0))
        self.assertEqual(code, 0)
        self.assertEqual((rows["gone"], rows["added"]), (["2.000", "-", "-"], ["-", "3.000", "-"]))

    def test_builds_without_a_common_benchmark_fail(self):
        code, _, complaint = self.table(old_1=result(gone=1.0), new_1=result(added=1.0))
        self.assertEqual((code, complaint), (1, "no benchmark is in both builds\n"))


class Paired(unittest.TestCase):
    def paired(self, *arguments, **environment):
        return subprocess.run([BENCH / "paired.sh", *arguments], capture_output=True, text=True, check=False,
                              env=os.environ | environment)

    def test_the_builds_take_turns(self):
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder)
            for name, time in (("before", 1.0), ("after", 2.0)):
                program = path / name / "tests/terratact-bench"
                program.parent.mkdir(parents=True)
                program.write_text(PROGRAM)
                program.chmod(0o755)
                (path / name / "result.json").write_text(result(draw=time))
            (path / "cmake").write_text("#!/bin/sh\n")
            (path / "cmake").chmod(0o755)
            done = self.paired(path / "before", path / "after", PATH=f"{path}:{os.environ['PATH']}")
            order = (path / "order").read_text().split()
        self.assertEqual(order, ["before", "after", "after", "before"] * 3)
        self.assertEqual(done.returncode, 1, done.stderr)
        self.assertRegex(done.stdout, r"draw +1\.000 +2\.000 +2\.000")

    def test_too_few_rounds_are_refused(self):
        self.assertEqual(self.paired("before", "after", "5").returncode, 2)
        self.assertEqual(self.paired("before").returncode, 2)


if __name__ == "__main__":
    unittest.main()
