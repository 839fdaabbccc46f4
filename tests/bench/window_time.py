#!/usr/bin/env python3
"""Measures how soon terratact-console has a window under an X server, with recording and the shipped model.

  xvfb-run -a -s '-screen 0 1920x1200x24' tests/bench/window_time.py PROGRAM [LIMIT]

Starts PROGRAM ten times and prints the times from the process's start until its window was mapped and painted. Fails if
one was painted later than LIMIT [s].
"""

import ctypes
import os
import subprocess
import sys
import tempfile
import time

STARTS = 10
PATIENCE = 60.0  # [s] for a window to open, and to close
PATCH = 64  # [px] square of a window; it counts as painted with more than one colour there
SUBSTRUCTURE_NOTIFY, MAP_NOTIFY, MAP_EVENT_WINDOW, Z_PIXMAP = 1 << 19, 19, 5, 2

X = ctypes.CDLL("libX11.so.6")
X.XOpenDisplay.restype = X.XDefaultRootWindow.restype = X.XGetImage.restype = ctypes.c_void_p
X.XGetPixel.restype = ctypes.c_ulong


class Screen:
    """Watches for new windows. It stays connected, so that the server is not reset between two starts."""

    def __init__(self):
        self.display = ctypes.c_void_p(X.XOpenDisplay(None) or sys.exit("no display"))
        X.XSelectInput(self.display, ctypes.c_void_p(X.XDefaultRootWindow(self.display)), ctypes.c_long(SUBSTRUCTURE_NOTIFY))
        X.XSync(self.display, 1)
        # A window may be gone when its pixels are requested.
        self.ignore = ctypes.CFUNCTYPE(ctypes.c_int, ctypes.c_void_p, ctypes.c_void_p)(lambda display, error: 0)
        X.XSetErrorHandler(self.ignore)

    def mapped(self):
        """Returns the window mapped since the last call; None: there is none."""
        event = (ctypes.c_long * 24)()
        while X.XPending(self.display):
            X.XNextEvent(self.display, event)
            if event[0] & 0xFFFFFFFF == MAP_NOTIFY:
                return ctypes.c_ulong(event[MAP_EVENT_WINDOW])
        return None

    def painted(self, window):
        image = X.XGetImage(self.display, window, 0, 0, PATCH, PATCH, ctypes.c_ulong(~0), Z_PIXMAP)
        if not image:
            return False
        image = ctypes.c_void_p(image)
        colours = {X.XGetPixel(image, at, at) for at in range(PATCH)}
        X.XDestroyImage(image)
        return len(colours) > 1

    def until(self, what, began):
        """Returns the result, and the time since `began`."""
        while not (result := what()):
            if time.monotonic() - began > PATIENCE:
                sys.exit("there is no window")
            time.sleep(0.001)
        return result, time.monotonic() - began


def start(screen, program):
    """Returns the seconds until the window of one start was mapped, and painted."""
    with tempfile.TemporaryDirectory() as folder:
        environment = os.environ | {"QT_QPA_PLATFORM": "xcb", "XDG_CONFIG_HOME": folder, "XDG_STATE_HOME": folder,
                                    "XDG_RUNTIME_DIR": folder}
        began = time.monotonic()
        console = subprocess.Popen([program], env=environment)
        try:
            window, mapped = screen.until(screen.mapped, began)
            _, painted = screen.until(lambda: screen.painted(window), began)
        finally:
            console.terminate()
            console.wait(timeout=PATIENCE)
        screen.mapped()
    return mapped, painted


def main(program, limit="60"):
    screen = Screen()
    times = [start(screen, program) for _ in range(STARTS)]
    for what, seconds in zip(("mapped", "painted"), zip(*times)):
        seconds = sorted(seconds)
        print(f"a window {what} {seconds[STARTS // 2]:.3f} s after the process began, {seconds[-1]:.3f} s at most of {STARTS} starts")
    sys.exit(0 if max(painted for _, painted in times) <= float(limit) else f"later than {limit} s")


main(*sys.argv[1:])
