"""Same seed, same bytes: builds same_draws.cpp by several compilers and optimisations and compares what the
programs print, each in 1 and 4 threads.  The kernels are the baseline ones, which every processor runs.  BLAS
has one thread, as the console and the command line set it: OpenBLAS adds in another order with more.
--native builds the kernels of every instruction set, and the fastest that this processor has are compared.

same_draws_test.py [--native] [--builds g++-12:-O0 g++-12:-O2 clang++-14:-O0 clang++-14:-O2]
same_draws_test.py --programs build/release/tests/same_draws build/dev/tests/same_draws
    compares programs that are built already, with the kernels that they choose here
"""

import argparse
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor

ROOT = pathlib.Path(os.environ.get("TERRATACT_SOURCE_DIR", pathlib.Path(__file__).parents[3]))
PROGRAM = "tests/core/infer/same_draws.cpp"
INCLUDE = re.compile(r'^#include "(core/[^"]+)\.h"', re.MULTILINE)
FLAGS = ["-std=c++20", f"-I{ROOT}", "-Wno-psabi", "-ffp-contract=off"]


def sources():
    """Returns the program and, header by header, every source it needs."""
    found, waiting = [], [PROGRAM]
    seen = set()
    while waiting:
        path = waiting.pop()
        if path in seen or not (ROOT / path).exists():
            continue
        seen.add(path)
        if path.endswith(".cpp"):
            found.append(path)
        for stem in INCLUDE.findall((ROOT / path).read_text()):
            waiting += [stem + ".h", stem + ".cpp"]
    return found


def pkg_config(*arguments):
    packages = ["eigen3", "lapacke", "libhwy", "openblas", "fmt", "nlopt"]
    out = subprocess.run(["pkg-config", *arguments, *packages], check=True, capture_output=True, text=True)
    return out.stdout.split()


def compile_all(compiler, level, native, folder):
    cache = ["ccache"] if shutil.which("ccache") else []
    macros = [] if native else ["-DHWY_COMPILE_ONLY_STATIC"]
    objects, commands = [], []
    for path in sources():
        target = folder / (path.replace("/", ".") + ".o")
        objects.append(target)
        commands.append([*cache, compiler, level, *FLAGS, *macros, *pkg_config("--cflags"), "-c",
                         str(ROOT / path), "-o", str(target)])
    with ThreadPoolExecutor(os.cpu_count()) as pool:
        list(pool.map(lambda command: subprocess.run(command, check=True), commands))
    program = folder / "same_draws"
    subprocess.run([compiler, *map(str, objects), "-o", str(program), *pkg_config("--libs"), "-pthread"],
                   check=True)
    return program


def printed(program, threads):
    environment = {**os.environ, "OPENBLAS_NUM_THREADS": "1"}
    out = subprocess.run([str(program), str(threads)], check=True, capture_output=True, text=True,
                         env=environment)
    return out.stdout


def built_and_run(build, native):
    compiler, level = build.split(":")
    with tempfile.TemporaryDirectory() as folder:
        program = compile_all(compiler, level, native, pathlib.Path(folder))
        return {f"{build}, {n} threads": printed(program, n) for n in (1, 4)}


def main():
    parser = argparse.ArgumentParser(description="Same seed, same bytes.")
    parser.add_argument("--native", action="store_true")
    parser.add_argument("--builds", nargs="+",
                        default=["g++-12:-O0", "g++-12:-O2", "clang++-14:-O0", "clang++-14:-O2"])
    parser.add_argument("--programs", nargs="+")
    options = parser.parse_args()
    results = {f"{program}, {n} threads": printed(program, n) for program in options.programs or [] for n in (1, 4)}
    for build in [] if options.programs else options.builds:
        if shutil.which(build.split(":")[0]):
            results |= built_and_run(build, options.native)
        else:
            print(f"{build}: the compiler is not installed, not compared")
    for name, text in results.items():
        print(f"{name:<28} {' '.join(text.split())}")
    if len(results) < 3 or len({name.split(":")[0] for name in results}) < 2:
        print("SKIPPED: there is only one build, or one compiler")
        return 77 if len(set(results.values())) <= 1 else 1
    return 0 if len(set(results.values())) == 1 else 1


if __name__ == "__main__":
    sys.exit(main())
