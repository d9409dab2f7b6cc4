"""Integrals to 28 digits: what `integrals.rs` holds the quadrature to.

Run: python3 integrals.py      writes integrals.csv
Made with Python 3.11.7, mpmath 1.3.0.

A row is: the integrand, its parameter k, the ends and the integral. Parameters and ends are doubles and mean exactly what
they are. Each integral is from mpmath.quad at 34 digits and again at 44, with the hard places as ends of pieces, which
must agree to 28; where there is a closed form, it has to agree too.

    peak k/(k^2 + x^2)    wave sin(k x)    power x^k    log ln x    bell exp(-k x^2)    exp e^(k x)    kink |x - k|
    arc sqrt(1 - x^2)     beat cos(k cos x)    small x^2 e^(-x)/(1 + k x)    steep tanh(k x)
"""

import csv
from pathlib import Path

from mpmath import mp, mpf

INTEGRANDS = {
    "peak": lambda k, x: k / (k**2 + x**2),
    "wave": lambda k, x: mp.sin(k * x),
    "power": lambda k, x: x**k,
    "log": lambda k, x: mp.log(x),
    "bell": lambda k, x: mp.exp(-k * x**2),
    "exp": lambda k, x: mp.exp(k * x),
    "kink": lambda k, x: abs(x - k),
    "arc": lambda k, x: mp.sqrt(1 - x**2),
    "beat": lambda k, x: mp.cos(k * mp.cos(x)),
    "small": lambda k, x: x**2 * mp.exp(-x) / (1 + k * x),
    "steep": lambda k, x: mp.tanh(k * x),
}
CLOSED = {
    "peak": lambda k, a, b: mp.atan(b / k) - mp.atan(a / k),
    "wave": lambda k, a, b: (mp.cos(k * a) - mp.cos(k * b)) / k,
    "power": lambda k, a, b: (b ** (k + 1) - a ** (k + 1)) / (k + 1),
    "log": lambda k, a, b: b * mp.log(b) - b - (a * mp.log(a) - a if a else 0),
    "exp": lambda k, a, b: (mp.exp(k * b) - mp.exp(k * a)) / k,
    "kink": lambda k, a, b: ((k - a) ** 2 + (b - k) ** 2) / 2,
    "bell": lambda k, a, b: mp.sqrt(mp.pi / k) / 2 * (mp.erf(mp.sqrt(k) * b) - mp.erf(mp.sqrt(k) * a)),
    "arc": lambda k, a, b: (mp.asin(b) + b * mp.sqrt(1 - b**2) - mp.asin(a) - a * mp.sqrt(1 - a**2)) / 2,
    "steep": lambda k, a, b: (mp.log(mp.cosh(k * b)) - mp.log(mp.cosh(k * a))) / k,
}
ASKED = [
    ("peak", 0.0625, -1.0, 1.0), ("peak", 1e-3, -1.0, 2.0), ("peak", 1e-6, 0.0, 1.0), ("peak", 1e-4, -1.0, 1.5),
    ("wave", 1.0, 0.0, 3.0), ("wave", 100.0, 0.0, 1.0), ("wave", 1000.0, 0.0, 0.78125),
    ("power", -0.5, 0.0, 1.0), ("power", -0.875, 0.0, 2.0), ("power", 0.5, 0.0, 1.0), ("power", 17.5, 0.0, 1.0), ("power", -0.5, 1e-12, 1.0),
    ("log", 0.0, 0.0, 1.0), ("log", 0.0, 1e-9, 3.0), ("bell", 1.0, -8.0, 8.0), ("bell", 1e4, -1.0, 1.0), ("bell", 1e6, -0.25, 1.0),
    ("exp", 1.0, 0.0, 1.0), ("exp", -50.0, 0.0, 4.0), ("exp", 300.0, 0.0, 1.0), ("kink", 0.375, 0.0, 1.0), ("kink", 0.1, -1.0, 1.0),
    ("arc", 0.0, -1.0, 1.0), ("arc", 0.0, 0.0, 1.0), ("beat", 1.0, 0.0, 3.0), ("beat", 40.0, 0.0, 3.0), ("small", 1.0, 0.0, 1.0),
    ("small", 1e6, 0.0, 1.0), ("small", 0.5, 0.0, 40.0), ("steep", 1.0, 0.0, 2.0), ("steep", 1000.0, 0.0, 1.0),
]


def pieces(name, k, a, b):
    """The ends, and the hard places between."""
    if name == "kink":
        inner = [k]
    elif name in ("peak", "bell", "steep", "small"):
        width = 1 / mp.sqrt(k) if name == "bell" else k if name == "peak" else 1 / k
        inner = [sign * width * mpf(4) ** j for j in range(-1, 12) for sign in (1, -1)] + [mpf(0)]
    else:
        count = int(abs(k) * (b - a) / 8) + 4 if name in ("wave", "beat", "exp") else 4
        inner = [a + (b - a) * mpf(j) / count for j in range(1, count)]
    return [a, *sorted(x for x in set(inner) if a < x < b), b]


def integral(name, k, a, b):
    def found(digits):
        with mp.workdps(digits):
            given = [mpf(x) for x in (k, a, b)]
            if name in ("power", "log", "arc"):
                # The closed form, which quad cannot reach at singular ends.
                return CLOSED[name](*given)
            return mp.quad(lambda x: INTEGRANDS[name](given[0], x), pieces(name, *given))

    first, second = found(34), found(44)
    with mp.workdps(44):
        assert abs(first / second - 1) < mpf(10) ** -28, (name, k, first, second)
        if name in CLOSED:
            closed = CLOSED[name](mpf(k), mpf(a), mpf(b))
            assert abs(closed / second - 1) < mpf(10) ** -28, (name, k, closed, second)
        return mp.nstr(second, 32, strip_zeros=False)


def main():
    rows = [[name, k, a, b, integral(name, k, a, b)] for name, k, a, b in ASKED]
    with open(Path(__file__).with_name("integrals.csv"), "w", newline="") as file:
        out = csv.writer(file, lineterminator="\n")
        out.writerow(["integrand", "parameter", "low", "high", "integral"])
        out.writerows(rows)


main()
