"""Measures processor time and peak memory of a command."""

import pathlib
import subprocess
import sys
import tempfile

# Linux counts the memory of the starting process for the new program, so this small process starts it.
STARTER = """import os, sys
program = os.posix_spawnp(sys.argv[2], sys.argv[2:], os.environ)
_, status, usage = os.wait4(program, 0)
with open(sys.argv[1], "w") as out:
    print(os.waitstatus_to_exitcode(status), usage.ru_utime + usage.ru_stime, usage.ru_maxrss / 1024, file=out)
"""


class Cost:
    """Runs a command. Keeps its exit status (137: killed after most_seconds), output, processor seconds and megabytes."""

    def __init__(self, *arguments, most_seconds=120):
        command = ["timeout", "-s", "KILL", str(most_seconds), *map(str, arguments)]
        with tempfile.NamedTemporaryFile() as facts:
            self.said = subprocess.run([sys.executable, "-S", "-c", STARTER, facts.name, *command], check=True,
                                       stdout=subprocess.PIPE, stderr=subprocess.STDOUT, stdin=subprocess.DEVNULL).stdout
            code, seconds, megabytes = pathlib.Path(facts.name).read_text().split()
        self.code, self.seconds, self.megabytes = int(code), float(seconds), float(megabytes)

    def last_words(self, folder):
        """Returns the last line of output, without the folder's name."""
        lines = self.said.decode(errors="replace").splitlines()[-1:] or [""]
        return ascii(lines[0].replace(f"{folder}/", ""))[1:-1][:90]
