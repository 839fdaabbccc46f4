"""Configures OpenBLAS for the NumPy peers, before NumPy is imported: one thread, and the fastest kernels of this processor.

Debian 12's OpenBLAS (0.3.21) treats unknown newer processors as its oldest one ("Prescott": no AVX, a fifth of the
speed here). That would be an unfair comparison, so the kernels are selected here.
"""
import ctypes
import ctypes.util
import os
import pathlib
import sys


def kernels():
    """Returns the name of the kernels in use, "unknown" for another BLAS."""
    library = ctypes.util.find_library("openblas")
    if not library:
        return "unknown"
    name = ctypes.CDLL(library).openblas_get_corename
    name.restype = ctypes.c_char_p
    return name().decode()


def prepare():
    """Restarts the program if OpenBLAS treats the processor as its oldest one."""
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
