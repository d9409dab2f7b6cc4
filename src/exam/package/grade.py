"""Grades a block with semi-implicit Euler steps on two tasks and all their cells: python3 grade.py [STEP]"""

import json
import math
import pathlib
import sys

HERE = pathlib.Path(__file__).parent
STEP = float(sys.argv[1]) if len(sys.argv) > 1 else 1e-3
# Of the answer or of 1: what we call right.
NEAR = 1e-2


def vector(text):
    """A size, perhaps with a direction behind an @."""
    size, _, angle = str(text).partition("@")
    return float(size) * math.cos(float(angle or 0)), float(size) * math.sin(float(angle or 0))


def follow(scene):
    """The distance from the origin at the end."""
    px, py = vector(scene.get("pull", 0))
    vx, vy = vector(scene.get("throw", 0))
    grip = scene["mu"] * scene["g"] * STEP
    how, _, end = scene["until"].partition("=")
    x = y = t = 0.0
    while t < float(end or "inf"):
        vx, vy = vx + px * STEP, vy + py * STEP
        speed = math.hypot(vx, vy)
        left = 1 - grip / speed if speed > grip else 0.0
        vx, vy = left * vx, left * vy
        x, y, t = x + vx * STEP, y + vy * STEP, t + STEP
        if how == "stop" and left == 0:
            break
    return math.hypot(x, y)


for name in ["stop-place", "creep"]:
    task = json.loads((HERE / f"{name}.json").read_text(encoding="utf-8"))
    for cell in [{"at": {}, "scene": {}, "answer": task["answer"]}] + task["cells"]:
        low, high = cell["answer"]
        found = follow(task["scene"] | cell["scene"])
        error = max(low - found, found - high, 0.0)
        right = error <= NEAR * max(1.0, high)
        print(json.dumps({"task": name, "at": cell["at"], "found": found, "error": error, "right": right}))
