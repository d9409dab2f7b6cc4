import numpy as np
import pyslammer.analytical_sliding_block as closed
from pyslammer import GroundMotion, RigidAnalysis

frequency, yields = 1.0, 0.1
forms = {g: float(closed.find_harmonic_solution(frequency, yields, grav=g, plot=False)) for g in (9.81, 9.80665)}
for step in (1e-2, 1e-3, 1e-4, 1e-5):
    t = np.arange(0, 1 / frequency, step)
    motion = GroundMotion(np.sin(2 * np.pi * frequency * t), step)
    way = RigidAnalysis(yields, motion).max_sliding_disp
    print(f"step {step:g} s  " + "  ".join(f"off from the closed form with g = {g}: {way / form - 1:+.2e}" for g, form in forms.items()))
