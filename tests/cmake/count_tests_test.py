"""cmake/count_tests.sh adds up ctest's results: programs of many tests, single tests, crashes, skips."""

import os
import pathlib
import subprocess
import tempfile
import unittest

SOURCE = pathlib.Path(os.environ["TERRATACT_SOURCE_DIR"])


def entry(status, output="", inside=""):
    return f'\t<testcase name="a" status="{status}">\n{inside}\t\t<system-out>{output}</system-out>\n\t</testcase>\n'


def counted(*entries):
    with tempfile.TemporaryDirectory() as folder:
        results = pathlib.Path(folder, "tests.xml")
        results.write_text("<testsuite>\n" + "".join(entries) + "</testsuite>\n")
        return subprocess.run([SOURCE / "cmake/count_tests.sh", results], capture_output=True, text=True,
                              check=True).stdout.strip()


class CountTests(unittest.TestCase):
    def test_counts_the_tests_of_a_program(self):
        output = "[==========] Running 57 tests from 3 test suites.\n[  PASSED  ] 56 tests.\n" \
                 "[  SKIPPED ] 1 test, listed below:\n[  SKIPPED ] A.b\n"
        self.assertEqual(counted(entry("run", output)), "56 passed, 0 failed, 1 skipped")

    def test_counts_an_entry_of_another_kind_once(self):
        self.assertEqual(counted(entry("run", "ok"), entry("fail", "no")), "1 passed, 1 failed, 0 skipped")

    def test_counts_failures_of_a_program(self):
        output = "[  PASSED  ] 3 tests.\n[  FAILED  ] 2 tests, listed below:\n[  FAILED  ] A.b\n"
        self.assertEqual(counted(entry("fail", output)), "3 passed, 2 failed, 0 skipped")

    def test_a_crash_or_a_timeout_is_a_failure(self):
        crash = entry("fail", "[ RUN      ] A.b")
        late = entry("fail", "[  PASSED  ] 3 tests.", '\t\t<failure message="Timeout"/>\n')
        self.assertEqual(counted(crash, late), "0 passed, 2 failed, 0 skipped")

    def test_a_program_that_cannot_start_is_a_failure(self):
        missing = entry("notrun", "", '\t\t<skipped message="Unable to find executable"/>\n')
        skipped = entry("notrun", "", '\t\t<skipped message="SKIP_RETURN_CODE=77"/>\n')
        self.assertEqual(counted(missing, skipped), "0 passed, 1 failed, 1 skipped")


if __name__ == "__main__":
    unittest.main()
