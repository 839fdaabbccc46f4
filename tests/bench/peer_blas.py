"""OpenBLAS on one thread and as fast as this processor allows, for the peers that NumPy is: before it is imported.

Debian 12's OpenBLAS (0.3.21) takes processors newer than itself for the oldest one it knows ("Prescott": no AVX, a
fifth of the speed here).  Nobody would measure against that, so it is told which kernels to use.
"""
import ctypes
import ctypes.util
import os
import pathlib
import sys


def kernels():
    """Name of the kernels in use, "unknown" for another BLAS."""
    library = ctypes.util.find_library("openblas")
    if not library:
        return "unknown"
    name = ctypes.CDLL(library).openblas_get_corename
    name.restype = ctypes.c_char_p
    return name().decode()


def prepare():
    """Starts the program again where OpenBLAS knows the processor only by its oldest features."""
    os.environ["OPENBLAS_NUM_THREADS"] = "1"
    if "OPENBLAS_CORETYPE" in os.environ or kernels() != "Prescott":
        return
    flags = next((line.split() for line in pathlib.Path("/proc/cpuinfo").read_text().splitlines()
                  if line.startswith("flags")), [])
    if {"avx512f", "avx512dq", "avx512bw", "avx512vl"} <= set(flags):
        core = "SkylakeX"
    elif {"avx2", "fma"} <= set(flags):
        core = "Haswell"
    else:
        return
    os.execve(sys.executable, [sys.executable, "-B", *sys.argv], os.environ | {"OPENBLAS_CORETYPE": core})
