#!/usr/bin/env bash
# Adds up the results in ctest's JUnit files: "N passed, N failed, N skipped". An entry that is a whole GoogleTest program
# counts with the tests in its summary. A test that could not be started counts as failed, not as skipped.
awk '
  /^[ \t]*<testcase / { outcome = "failed"; summary = 0 }
  /^[ \t]*<testcase .*status="run"/      { outcome = "passed" }
  /^[ \t]*<testcase .*status="disabled"/ { outcome = "skipped" }
  /^[ \t]*<skipped message="SKIP_/       { outcome = "skipped" }
  /\[  (PASSED|FAILED|SKIPPED)  ?\] [0-9]+ tests?[.,]/ {
    match($0, /\] [0-9]+/)
    of[/PASSED/ ? "passed" : /FAILED/ ? "failed" : "skipped"] += substr($0, RSTART + 2, RLENGTH - 2)
    summary = 1
  }
  /<\/testcase>/ {
    if (!summary || (outcome == "failed" && !of["failed"])) { split("", of); of[outcome] = 1 }
    for (kind in of) count[kind] += of[kind]
    split("", of)
  }
  END { printf "%d passed, %d failed, %d skipped\n", count["passed"], count["failed"], count["skipped"] }
' "$@"
