#!/usr/bin/env bash
# Adds up the results in ctest's JUnit files: "N passed, N failed, N skipped". A test that could not be started counts
# as failed, not as skipped.
awk '
  /^[ \t]*<testcase .*status="run"/      { passed++ }
  /^[ \t]*<testcase .*status="fail"/     { failed++ }
  /^[ \t]*<testcase .*status="disabled"/ { skipped++ }
  /^[ \t]*<skipped message="SKIP_/       { skipped++; next }
  /^[ \t]*<skipped message="[^"D]/       { failed++ }
  END { printf "%d passed, %d failed, %d skipped\n", passed, failed, skipped }
' "$@"
