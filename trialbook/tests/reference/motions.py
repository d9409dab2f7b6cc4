"""States at an end time of some ordinary differential equations, to 30 digits: what `motions.rs` holds the integrators to.

Run: python3 motions.py      writes motions.csv
Made with Python 3.11.7, mpmath 1.3.0.

A row is: the system, its parameter, the end time, and start and end of a component each; systems of several components
have several rows, in order. Motions begin at the time 0. Parameters, times and starts are doubles and mean exactly what
they are. The ends are from Taylor series (mpmath.odefun) at 34 digits and again at 40, which must agree to 30; where there
is a closed form, it has to agree too.

    pull        v' = (1, 0) - k v/|v|                          a steady pull, and a force of constant size against v
    wave        x' = w, w' = sin t - k                         a pull that swings, while w > 0
    turn        x' = v, v' = x + 2 (v_y, -v_x) - v/|v|         in axes that turn, and a force of size 1 against v
    kepler      x' = v, v' = -x/|x|^3
    pendulum    x' = v, v' = -k sin x
    growth      x' = x (1 - x)
    vanderpol   x' = v, v' = k (1 - x^2) v - x
    lorenz      x' = 10 (y - x), y' = x (28 - z) - y, z' = x y - 8/3 z
    gauss       x' = -2 t x
    root        x' = sqrt(1 + x^2)
"""

import csv
from pathlib import Path

from mpmath import mp, mpf


def pull(k, t, x):
    v = mp.hypot(x[0], x[1])
    return [1 - k * x[0] / v, -k * x[1] / v]


def turn(k, t, x):
    v = mp.hypot(x[2], x[3])
    return [x[2], x[3], x[0] + 2 * x[3] - x[2] / v, x[1] - 2 * x[2] - x[3] / v]


def kepler(k, t, x):
    r = mp.hypot(x[0], x[1]) ** 3
    return [x[2], x[3], -x[0] / r, -x[1] / r]


LAWS = {
    "pull": pull,
    "wave": lambda k, t, x: [x[1], mp.sin(t) - k],
    "turn": turn,
    "kepler": kepler,
    "pendulum": lambda k, t, x: [x[1], -k * mp.sin(x[0])],
    "growth": lambda k, t, x: [x[0] * (1 - x[0])],
    "vanderpol": lambda k, t, x: [x[1], k * (1 - x[0] ** 2) * x[1] - x[0]],
    "lorenz": lambda k, t, x: [10 * (x[1] - x[0]), x[0] * (28 - x[2]) - x[1], x[0] * x[1] - mpf(8) / 3 * x[2]],
    "gauss": lambda k, t, x: [-2 * t * x[0]],
    "root": lambda k, t, x: [mp.sqrt(1 + x[0] ** 2)],
}
CLOSED = {
    "wave": lambda k, t, x: [x[0] + (x[1] + 1) * t - mp.sin(t) - k * t**2 / 2, x[1] + 1 - mp.cos(t) - k * t],
    "growth": lambda k, t, x: [x[0] / (x[0] + (1 - x[0]) * mp.exp(-t))],
    "gauss": lambda k, t, x: [x[0] * mp.exp(-(t**2))],
    "root": lambda k, t, x: [mp.sinh(mp.asinh(x[0]) + t)],
}
ASKED = [
    ("pull", 0.5, 2.0, [1.0, 0.5]),
    ("pull", 2.0, 0.375, [-0.5, 1.0]),
    ("pull", 1.0, 1.5, [0.0, -2.0]),
    ("wave", 0.25, 2.5, [0.0, 0.5]),
    ("wave", 0.75, 1.5, [0.0, 1.0]),
    ("turn", 0.0, 0.25, [0.5, 0.0, 0.0, 0.5]),
    ("turn", 0.0, 2.0, [1.5, 0.0, 1.0, -1.0]),
    ("turn", 0.0, 2.0, [3.0, 0.25, -0.5, 0.75]),
    ("kepler", 0.0, 3.0, [0.5, 0.0, 0.0, 1.5]),
    ("kepler", 0.0, 0.5, [0.125, 0.0, 0.0, 3.75]),
    ("pendulum", 1.0, 4.0, [3.0, 0.0]),
    ("pendulum", 9.0, 1.0, [0.0, 6.25]),
    ("growth", 0.0, 6.0, [0.0009765625]),
    ("vanderpol", 2.0, 2.5, [2.0, 0.0]),
    ("lorenz", 0.0, 0.75, [1.0, 1.0, 1.0]),
    ("gauss", 0.0, 5.0, [1.0]),
    ("root", 0.0, 5.0, [0.0]),
]


def near(one, other):
    assert all(abs(a - b) <= mpf(10) ** -30 * max(abs(a), mpf(10) ** -10) for a, b in zip(one, other, strict=True)), (one, other)


def ends(name, k, t, start):
    def solved(digits):
        with mp.workdps(digits):
            law = LAWS[name]
            return mp.odefun(lambda t, x: law(mpf(k), t, x), 0, [mpf(x) for x in start])(mpf(t))

    first, second = solved(34), solved(40)
    with mp.workdps(40):
        near(first, second)
        if name in CLOSED:
            near(second, CLOSED[name](mpf(k), mpf(t), [mpf(x) for x in start]))
    return second


def text(x):
    with mp.workdps(40):
        return mp.nstr(x, 32, strip_zeros=False, min_fixed=-40)


def main():
    rows = []
    for name, k, t, start in ASKED:
        for x, end in zip(start, ends(name, k, t, start)):
            rows.append([name, k, t, x, text(end)])
    with open(Path(__file__).with_name("motions.csv"), "w", newline="") as file:
        out = csv.writer(file, lineterminator="\n")
        out.writerow(["system", "parameter", "time", "start", "end"])
        out.writerows(rows)


main()
