"""Runs the Slurm lines of docs/clusters.md on a Slurm of one node; its results equal those of one run.

Exits with 77 if Slurm is not installed or starts no job. shards_test.py runs the lines without it.
"""

import hashlib
import os
import pathlib
import re
import sys
import tempfile
import time
import unittest

import one_node_slurm
from cluster_support import ONE_RUN, Distributed, slurm_commands, slurm_scripts


def sha256(path):
    return hashlib.sha256(path.read_bytes()).hexdigest()


class Slurm(Distributed):
    def setUp(self):
        made = tempfile.TemporaryDirectory()
        self.addCleanup(made.cleanup)
        self.path = pathlib.Path(made.name)
        self.path.chmod(0o755)
        for name in ("cluster", "distributed", "whole"):
            (self.path / name).mkdir()
        self.shell("terratact simulate --terrain boxes --count 90 --seed 3 --out scenes.csv", self.path)
        for name in ("distributed", "whole"):
            (self.path / name / "scenes.csv").write_bytes((self.path / "scenes.csv").read_bytes())

    def submit(self, slurm, commands):
        """Runs commands that submit jobs and returns their output."""
        return self.shell(commands, self.path / "distributed", SLURM_CONF=str(slurm.configuration))

    def assert_completed(self, slurm, job):
        """Waits for a job and checks that it and all jobs before it have completed. Returns their number."""
        self.submit(slurm, f"sbatch --wait --dependency=afterany:{job} --output /dev/null --wrap true")
        states = re.findall(r"JobState=(\S+)", self.submit(slurm, "scontrol show jobs"))
        said = "\n".join(p.read_text() for p in (self.path / "distributed").glob("slurm-*.out"))
        self.assertEqual(set(states), {"COMPLETED"}, f"{said}\n{slurm.logs()}")
        return len(states)

    def run_documented_jobs(self, slurm):
        """Runs the documented jobs and returns their number of tasks."""
        self.submit(slurm, "sbatch --wait --cpus-per-task=1 --output limit --wrap nproc")
        self.assertEqual((self.path / "distributed/limit").read_text(), "1\n", "a job sees more than its processors")
        commands = slurm_commands()
        self.assertEqual(len(commands), 4)
        submitted = self.submit(slurm, "\n".join(commands))
        last = re.fullmatch(r"Submitted batch job (\d+)\n", submitted).group(1)
        before = 3  # the two jobs that waited and the one that saw one processor
        return self.assert_completed(slurm, last) - before

    def run_a_task_again(self, slurm):
        """Loses a part of the evaluation and the merged result, and runs the documented lines that repair it."""
        evaluation = self.path / "distributed/evaluation"
        for path in evaluation.iterdir():
            if path.suffix != ".tte" or path.name == "part_7_of_32.tte":
                path.unlink()
        self.assertEqual(len(list(evaluation.iterdir())), 31)
        self.submit(slurm, "\n".join(slurm_commands("A Slurm task that failed")))

    def test_documented_jobs_equal_one_run(self):
        distributed, whole = self.path / "distributed", self.path / "whole"
        self.shell(ONE_RUN, whole)
        scripts = slurm_scripts()
        self.assertEqual(len(scripts), 2)
        for name, text in scripts.items():
            (distributed / name).write_text(text)
        processors = max(2, os.cpu_count())
        with one_node_slurm.OneNodeSlurm(self.path / "cluster", processors) as slurm:
            begin = time.monotonic()
            tasks = self.run_documented_jobs(slurm)
            print(f"Slurm {one_node_slurm.version()}, one node of {processors} processors: "
                  f"{tasks} tasks of the documented jobs completed in {time.monotonic() - begin:.0f} s")
            merged = distributed / "model.ttm"
            self.assertEqual(sha256(whole / "model.ttm"), sha256(merged))
            print(f"model.ttm: {merged.stat().st_size} bytes, equal to one run's; SHA-256 {sha256(merged)}")
            files = self.assert_same_evaluation(whole / "evaluation", distributed / "evaluation")
            print(f"evaluation: {files} files, equal to one run's except for measured times")
            self.run_a_task_again(slurm)
            self.assert_same_evaluation(whole / "evaluation", distributed / "evaluation")
            print("evaluation: equal again after task 7 was lost and submitted alone")


if __name__ == "__main__":
    if reason := one_node_slurm.unfit():
        print(reason)
        sys.exit(77)
    unittest.main()
