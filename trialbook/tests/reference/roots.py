"""Roots to 32 digits: what `roots.rs` holds the root-finders to.

Run: python3 roots.py      writes roots.csv
Made with Python 3.11.7, mpmath 1.3.0.

A row is: the function, its parameter k, the ends of a bracket and the only root in it. Parameters and ends are doubles and
mean exactly what they are. The roots are from mpmath.findroot at 60 digits, by the secant after 1100 halvings at most, and the
function has different signs 10^-40 below and above.

    cos cos x - x    exp e^x - k    lambert x e^x - k    ninth x^9 - k    log ln x + k    tan x cos x - sin x
    kepler x - k sin x - 1/1024    step tanh(1000 (x - k))    pole 1/(x - k)    far x^3 - k x - 1    flat (x - k)^5
"""

import csv
from pathlib import Path

from mpmath import mp, mpf

FUNCTIONS = {
    "cos": lambda k, x: mp.cos(x) - x,
    "exp": lambda k, x: mp.exp(x) - k,
    "lambert": lambda k, x: x * mp.exp(x) - k,
    "ninth": lambda k, x: x**9 - k,
    "log": lambda k, x: mp.log(x) + k,
    "tan": lambda k, x: x * mp.cos(x) - mp.sin(x),
    "kepler": lambda k, x: x - k * mp.sin(x) - mpf(1) / 1024,
    "step": lambda k, x: mp.tanh(1000 * (x - k)),
    "pole": lambda k, x: 1 / (x - k),
    "far": lambda k, x: x**3 - k * x - 1,
    "flat": lambda k, x: (x - k) ** 5,
}
ASKED = [
    ("cos", 0.0, 0.0, 1.0), ("exp", 1e-10, -100.0, 100.0), ("exp", 1e100, -1.0, 700.0), ("lambert", 1.0, 0.0, 1.0),
    ("lambert", 1e10, -1.0, 100.0), ("ninth", 2.0, 0.0, 2.0), ("ninth", 1e-200, 0.0, 1.0), ("log", 300.0, 1e-300, 1.0),
    ("tan", 0.0, 3.25, 4.7109375), ("kepler", 0.9990234375, 0.0, 3.0), ("kepler", 0.5, 0.0, 3.0), ("step", 0.3, -1.0, 5.0),
    ("pole", 0.7, 0.0, 2.0), ("far", 1e6, 1.0, 1e5), ("far", 3.0, 1.5, 3.0), ("flat", 0.3, -1.0, 5.0),
]


def halved(f, low, high):
    """The bracket, halved until it is narrow against the root."""
    for _ in range(1100):
        if abs(high - low) < mpf(10) ** -20 * abs(low):
            break
        middle = (low + high) / 2
        low, high = (middle, high) if f(low) * f(middle) > 0 else (low, middle)
    return low, high


def root(name, k, low, high):
    with mp.workdps(60):
        f = lambda x: FUNCTIONS[name](mpf(k), x)
        low, high = mpf(low), mpf(high)
        if name in ("pole", "step", "flat"):
            # There k is the root, or the place of the jump.
            return mp.nstr(mpf(k), 32)
        x = mp.findroot(f, halved(f, low, high), solver="secant", tol=mpf(10) ** -100, verify=False)
        near = mpf(10) ** -40 * x
        assert low < x < high and f(x - near) * f(x + near) < 0, (name, k, x)
        return mp.nstr(x, 32)


def main():
    with open(Path(__file__).with_name("roots.csv"), "w", newline="") as file:
        out = csv.writer(file, lineterminator="\n")
        out.writerow(["function", "parameter", "low", "high", "root"])
        out.writerows([name, k, low, high, root(name, k, low, high)] for name, k, low, high in ASKED)


main()
