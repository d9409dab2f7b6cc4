#!/usr/bin/env python3
"""pySLAMMER: the 66 harmonic cases that its module of closed forms lists, by that closed form and by a time history."""

from importlib.metadata import version

import numpy as np
import pyslammer.analytical_sliding_block as closed
from pyslammer import GroundMotion, RigidAnalysis
from pyslammer.constants import G_EARTH

STEP = 0.001  # as in its own comparison, which takes one cycle of the sine
GRAVITY = 9.81  # its default for the closed form; the time history has G_EARTH built in


def history(frequency, yields):
    t = np.arange(0, 1 / frequency, STEP)
    motion = GroundMotion(np.sin(2 * np.pi * frequency * t), STEP)
    return RigidAnalysis(yields, motion).max_sliding_disp


packages = ", ".join(f"{name} {version(name)}" for name in ["pyslammer", "sympy", "mpmath", "numpy"])
with open("results/pyslammer.csv", "w") as out:
    print(f"# {packages}", file=out)
    print(f"# closed: find_harmonic_solution with grav={GRAVITY}", file=out)
    print(f"# history: RigidAnalysis of one cycle with a step of {STEP} s; g={G_EARTH}", file=out)
    print("frequency,yield,closed,history", file=out)
    for frequency, yields in closed.combinations:
        form = closed.find_harmonic_solution(frequency, yields, grav=GRAVITY, plot=False)
        print(float(frequency), float(yields), float(form), float(history(frequency, yields)), sep=",", file=out)
