"""Tests distributed work: train --bins and evaluate --shard, combined by merge, equal one run."""

import os
import pathlib
import re
import shlex
import shutil
import subprocess
import tempfile
import unittest

from cluster_support import ONE_RUN, Distributed, documented, slurm_commands, slurm_scripts
from support import SOURCE, complaint, run


def job_array():
    """Returns the documented commands for GNU parallel."""
    return [line for line in documented("GNU parallel") if line]


# A stand-in for Slurm's sbatch. It runs a job at once and its array tasks one after another. Scripts must not rely on
# their order. It refuses a job before its dependencies.
SBATCH = r"""#!/bin/sh -e
parsable= script= array=
while [ $# -gt 0 ]; do
  case $1 in
    --parsable) parsable=1 ;;
    --dependency=afterok:*) grep -qx "${1##*:}" jobs ;;
    --wrap) printf '#!/bin/sh\n%s\n' "$2" >wrapped.sh; script=wrapped.sh; shift ;;
    -*) echo "sbatch: $1 is not known" >&2; exit 1 ;;
    *) script=$1 ;;
  esac
  shift
done
array=$(sed -n 's/^#SBATCH .*--array=\([0-9]*-[0-9]*\).*/\1/p' "$script")
first=${array%-*} last=${array#*-}
if [ "$array" ]; then
  for SLURM_ARRAY_TASK_ID in $(seq "$last" -1 "$first"); do
    export SLURM_ARRAY_TASK_ID SLURM_ARRAY_TASK_COUNT=$((last - first + 1))
    sh -e "$script" >&2
  done
else
  sh -e "$script" >&2
fi
echo job >>jobs
id=$(wc -l <jobs)
sed -i "s/^job$/$id/" jobs
if [ "$parsable" ]; then echo "$id"; else echo "Submitted batch job $id"; fi
"""


class Shards(Distributed):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.path = pathlib.Path(cls.folder.name)
        cls.before = os.getcwd()
        os.chdir(cls.path)
        run("simulate", "--terrain", "boxes", "--count", 90, "--seed", 3, "--out", "scenes.csv")
        cls.few("few.csv", 23)
        run("train", "--data", "scenes.csv", "--out", "model.ttm", "--seed", 3)
        for number, bins in enumerate(("0-3", "4,8-10", "5-7")):
            run("train", "--data", "scenes.csv", "--bins", bins, "--out", f"{number}.ttp", "--seed", 3)

    @classmethod
    def tearDownClass(cls):
        os.chdir(cls.before)
        cls.folder.cleanup()

    @classmethod
    def few(cls, name, count):
        lines = pathlib.Path("scenes.csv").read_text().splitlines(keepends=True)
        pathlib.Path(name).write_text("".join(lines[: count + 1]))

    def assert_same_words(self, one, merged):
        """The text must be equal, except times and the directory's name."""
        def timeless(text):
            text = re.sub(r"[0-9.e+-]+ ms per scene", "", text)
            text = re.sub(r"written to \S+:", "", text)
            return re.sub(r" +[0-9.]+$", "", text, flags=re.M)
        self.assertEqual(timeless(one), timeless(merged))

    def test_a_merged_model_equals_one_run_to_the_byte(self):
        os.makedirs("merged", exist_ok=True)
        os.chdir("merged")  # the model stores the name it was written to
        try:
            said = run("merge", "--out", "model.ttm", "../2.ttp", "../0.ttp", "../1.ttp")
            self.assertEqual(pathlib.Path("model.ttm").read_bytes(), pathlib.Path("../model.ttm").read_bytes())
            content = re.search(r"content\s+(\w{64})", run("model", "show", "../model.ttm")).group(1)
            self.assertIn(content, said)
        finally:
            os.chdir("..")

    def test_an_incomplete_training_is_not_merged(self):
        for arguments, words in (
            (("0.ttp", "2.ttp"), ("never.ttm: ", "bins 4,8-10 are in no part", "expected 0-10")),
            (("0.ttp", "1.ttp", "2.ttp", "1.ttp"), ("1.ttp: holds bins 4,8-10 a second time",)),
            (("0.ttp", "1.ttp", "gone.ttp"), ("gone.ttp: cannot be opened",)),
            (("0.ttp", "1.ttp", "model.ttm"), ("model.ttm: is a whole model, expected a part",)),
            (("0.ttp", "1.ttp", "scenes.csv"), ("scenes.csv: is not an SQLite file",)),
        ):
            said = complaint("merge", "--out", "never.ttm", *arguments)
            for word in words:
                self.assertIn(word, said)
            self.assertEqual(said.count("\n"), 1)
            self.assertFalse(os.path.exists("never.ttm"))

    def test_parts_of_another_training_are_refused(self):
        for option, word in ((("--seed", 4), "--seed 4"), (("--seed", 3, "--conditional-rows", 60), "--conditional-rows")):
            run("train", "--data", "scenes.csv", "--bins", "5-7", "--out", "other.ttp", *option)
            said = complaint("merge", "--out", "never.ttm", "0.ttp", "1.ttp", "other.ttp")
            self.assertIn("other.ttp: is a part of another training: its command is", said)
            self.assertIn(word, said)
        shutil.copy("scenes.csv", "saved.csv")
        try:
            self.few("scenes.csv", 80)
            run("train", "--data", "scenes.csv", "--bins", "5-7", "--out", "other.ttp", "--seed", 3)
        finally:
            os.replace("saved.csv", "scenes.csv")
        said = complaint("merge", "--out", "never.ttm", "0.ttp", "1.ttp", "other.ttp")
        self.assertIn("other.ttp: is a part of another training: its scenes' SHA-256 is", said)
        robot = pathlib.Path(SOURCE, "resources/robots/absolem.toml").read_text()
        pathlib.Path("robot.toml").write_text(robot + "# a remark\n")
        said = complaint("merge", "--robot", "robot.toml", "--out", "never.ttm", "0.ttp", "1.ttp", "2.ttp")
        self.assertIn("0.ttp: was trained for another robot", said)

    def test_a_part_of_a_model_estimates_nothing(self):
        said = complaint("reconstruct", "--model", "0.ttp", "--data", "few.csv", "--out", "never.csv")
        self.assertIn("0.ttp: is a part of a model; `terratact merge` makes a model of all parts", said)

    def test_a_merged_evaluation_is_the_one_of_one_run(self):
        pathlib.Path("index.csv").write_text('row,kind\n1,"boxes, low"\n2,other\n')
        evaluate = ("evaluate", "--model", "model.ttm", "--data", "few.csv", "--sweeps", 64, "--probes", "--seed", 5,
                    "--classes", "index.csv", "--class-column", "kind")
        one = run(*evaluate, "--out", "one")
        for number in (3, 1, 2):
            self.assertIn("of 23 scenes", run(*evaluate, "--out", "parts", "--shard", f"{number}/3"))
        parts = sorted(map(str, pathlib.Path("parts").iterdir()))
        self.assertEqual(parts, [f"parts/part_{k}_of_3.tte" for k in (1, 2, 3)])
        merged = run("merge", "--out", "together", *reversed(parts))
        self.assert_same_evaluation("one", "together")
        self.assert_same_words(one, merged)
        self.assertTrue(os.path.exists("together/classes.csv") and os.path.exists("together/probes.csv"))

    def test_an_incomplete_evaluation_is_not_merged(self):
        evaluate = ("evaluate", "--model", "model.ttm", "--data", "few.csv", "--methods", "local", "--out", "pieces")
        for shard in ("1/2", "2/2", "2/3"):
            run(*evaluate, "--shard", shard)
        run(*evaluate[:-1], "foreign", "--shard", "2/2", "--seed", 2)
        one, two = "pieces/part_1_of_2.tte", "pieces/part_2_of_2.tte"
        for parts, words in (
            ((one,), ("never: cannot be made: expected 2 parts", "missing 2/2")),
            ((one, two, one), (f"{one}: is part 1 of 2 a second time",)),
            ((one, "pieces/part_2_of_3.tte"), ("part_2_of_3.tte: ", "number of parts is 3, expected 2")),
            ((one, "foreign/part_2_of_2.tte"), ("foreign/part_2_of_2.tte: is a part of another evaluation", "--seed 2")),
            ((one, two, "0.ttp"), ("0.ttp: ", "not a part of an evaluation")),
            ((one, "gone.tte"), ("gone.tte: cannot be opened",)),
        ):
            said = complaint("merge", "--out", "never", *parts)
            for word in words:
                self.assertIn(word, said)
            self.assertEqual(said.count("\n"), 1)
            self.assertFalse(os.path.exists("never"))
        self.assertIn("few.csv: has 23 scenes, expected at least 24", complaint(*evaluate, "--shard", "1/24"))

    def test_wrong_shares_exit_with_2(self):
        for bins in ("", "11", "3-1", "1,1", "x"):
            complaint("train", "--data", "scenes.csv", "--out", "never.ttp", "--bins", bins, code=2)
        for shard in ("", "0/2", "3/2", "2", "1/0"):
            complaint("evaluate", "--data", "few.csv", "--out", "never", "--shard", shard, code=2)
        complaint("merge", "--out", "never.ttm", code=2)

    def test_documented_gnu_parallel_jobs_equal_one_run(self):
        self.assertTrue(shutil.which("parallel"), "GNU parallel is not installed: cmake/setup.sh test installs it")
        for name in ("array", "alone"):
            os.makedirs(name)
            shutil.copy("scenes.csv", name)
        self.shell("\n".join(job_array()), "array")
        parallel = [shlex.split(line) for line in job_array() if line.startswith("parallel ")]
        self.assertEqual([words[words.index("terratact") + 1] for words in parallel], ["train", "evaluate"])
        for words in parallel:  # the same work without the share, as GNU parallel would run it
            alone = words[words.index("terratact"): words.index(":::")]
            share = alone.index("--bins" if "--bins" in alone else "--shard")
            alone[share: share + 2] = []
            self.shell(shlex.join(alone).replace("'part_{}.ttp'", "model.ttm"), "alone")
        self.assertEqual(pathlib.Path("array/model.ttm").read_bytes(), pathlib.Path("alone/model.ttm").read_bytes())
        self.assert_same_evaluation("alone/evaluation", "array/evaluation")

    def test_documented_slurm_jobs_equal_one_run(self):
        os.makedirs("slurm/bin")
        shutil.copy("scenes.csv", "slurm")
        sbatch = pathlib.Path("slurm/bin/sbatch")
        sbatch.write_text(SBATCH)
        sbatch.chmod(0o755)
        scripts, commands = slurm_scripts(), slurm_commands()
        self.assertEqual((len(scripts), len(commands)), (2, 4))
        for name, text in scripts.items():
            few = text.replace("--array=1-32", "--array=1-3").replace("ID/32", "ID/3")  # each task fits the baselines again
            pathlib.Path("slurm", name).write_text(few)
        self.shell("PATH=$PWD/bin:$PATH\n" + "\n".join(commands), "slurm")
        os.makedirs("whole")
        shutil.copy("scenes.csv", "whole")
        self.shell(ONE_RUN, "whole")
        self.assertEqual(pathlib.Path("slurm/model.ttm").read_bytes(), pathlib.Path("whole/model.ttm").read_bytes())
        self.assert_same_evaluation("whole/evaluation", "slurm/evaluation")


if __name__ == "__main__":
    unittest.main()
