#!/usr/bin/env python3
"""W7 - what an explorer answers: one coin on the turntable from a start to its rest, with the curve that is drawn.

The start is rho = 0.8, against the table (-0.6, 0.4). The peer follows it by solve_ivp as in w6 and takes 400 points. Ours is
the module that the book's pages run, by Node.js (explorer.mjs); the book must have been written.
"""
import argparse
import subprocess
import sys

import numpy as np
from scipy.integrate import solve_ivp

import benchlib as B


def turntable(t, y):
    x, z, u, w = y
    s = np.hypot(u, w)
    return [u, w, x + 2*w - u/s, z - 2*u - w/s]


def stops(t, y):
    return np.hypot(y[2], y[3]) - 1e-9


stops.terminal, stops.direction = True, -1


def answer():
    s = solve_ivp(turntable, (0, 50), [0.8, 0, -0.6, 0.4], method="DOP853", rtol=1e-9, atol=1e-11, events=stops, dense_output=True)
    y = s.sol(np.linspace(0, s.t[-1], 400))
    return np.hypot(y[0, -1], y[1, -1]), y


def main():
    ap = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    ap.add_argument("--peer", default="scipy", choices=["scipy", "slipbook"])
    ap.add_argument("--repeats", type=int, default=20)
    a = ap.parse_args()
    if a.peer == "slipbook":
        return subprocess.run(["node", "explorer.mjs", str(a.repeats)]).returncode
    (radius, _), times = B.timeit(answer, a.repeats)
    B.emit("W7", a.peer, 1, times, {"radius at rest": radius}, loc=B.loc_of(turntable, stops, answer), versions=B.versions("numpy", "scipy"))


if __name__ == "__main__":
    sys.exit(main())
