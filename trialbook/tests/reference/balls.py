"""Values of the functions that balls offer, from Arb: what `balls.rs` holds them against.

Run: python3 balls.py      writes balls.csv
Made with Python 3.11.7, python-flint 0.9.0.

A row is: function, the bounds of its one or two arguments, bits after the point, and the bounds of its range as decimals,
cut off or rounded up at a place far behind those bits. The range is empty where the function has no value somewhere.
Arguments are doubles and mean exactly what they are; the bounds of a single number are the same.
"""

import csv
import math
import random
from itertools import product
from pathlib import Path

from flint import arb, ctx, fmpz

BITS = (53, 120, 200, 1000, 3400)


def decimals(f, digits):
    """The decimals of f, cut off and rounded up: two whole numbers of units of the last one."""
    ctx.prec = 4 * digits + 4000
    scaled = f() * arb(fmpz(10) ** digits)
    low, high = scaled.floor().unique_fmpz(), scaled.ceil().unique_fmpz()
    assert low is not None and high is not None
    return int(low), int(high)


def text(units, digits):
    sign, size = "-" if units < 0 else "", str(abs(units)).rjust(digits + 1, "0")
    return f"{sign}{size[:-digits]}.{size[-digits:]}"


def extremes(lo, hi, offset):
    """Whether an odd or even multiple of pi, moved by `offset` turns of pi, lies between."""
    ctx.prec = 4000
    low, high = [(arb(x) / arb.pi() - offset) / 2 for x in (lo, hi)]
    return low.ceil().unique_fmpz() <= high.floor().unique_fmpz()


HALF = arb(1) / 2


def places(name, x, y):
    """Numbers among which the least and the largest are the ends of the range."""
    lo, hi = x
    if name in ("+", "-", "*", "/"):
        if name == "/" and y[0] <= 0 <= y[1]:
            return None
        f = {"+": arb.__add__, "-": arb.__sub__, "*": arb.__mul__, "/": arb.__truediv__}[name]
        return [lambda a=a, b=b: f(arb(a), arb(b)) for a, b in product(x, y)]
    if name == "sqrt" and lo < 0 or name == "asin" and (lo < -1 or hi > 1):
        return None
    f = getattr(arb, name)
    found = [lambda: f(arb(lo)), lambda: f(arb(hi))]
    if name in ("sin", "cos"):
        top = HALF if name == "sin" else arb(0)
        found += [lambda: arb(1)] if extremes(lo, hi, top) else []
        found += [lambda: arb(-1)] if extremes(lo, hi, top - 1) else []
    return found


def points(rng):
    """Numbers, most of them of few bits, so that balls of few bits hold them exactly too."""
    few = [0.0, 2.0**-50, 2.0**-20, 0.125, 0.5, 0.75, 1.0, 1.5, 2.0, 3.0, 7.0, 100.5, 12345.0, 2.0**31, 2.0**32 - 1]
    few += [math.ldexp(round(math.ldexp(math.pi * k / 4, 40)), -40) for k in (1, 2, 3, 4, 6, 8, 1000)]
    few += [1 - 2.0**-k for k in (1, 3, 10, 20, 26)] + [rng.randrange(1, 2**40) / 2**38 for _ in range(10)]
    return few + [-x for x in few]


def wide(rng):
    found = [(0.25, 0.5), (-1.0, 1.0), (0.5, 4.0), (-2.0, -1.5), (1.0, 2.0), (3.0, 3.5), (0.0, 0.5), (-0.5, 1.25)]
    for _ in range(16):
        lo = rng.randrange(-(2**20), 2**20) / 2**18
        found.append((lo, lo + 2.0 ** -rng.randrange(0, 30)))
    return found


def main():
    rng = random.Random("balls")
    rows = []

    def row(name, x, y, bits):
        digits = bits * 302 // 1000 + 25
        found = places(name, x, y)
        bounds = ["", ""]
        if found is not None:
            ends = [decimals(f, digits) for f in found]
            bounds = [text(min(low for low, _ in ends), digits), text(max(high for _, high in ends), digits)]
        rows.append([name, *map(repr, x), *(map(repr, y) if y else ("", "")), bits, *bounds])

    single = [(x, x) for x in points(rng)]
    for name in ("sin", "cos", "sqrt", "asin"):
        for x in single + wide(rng):
            for bits in BITS[:3]:
                row(name, x, None, bits)
        for x in rng.sample([x for x in single if 0 <= x[0] <= 1], 4):
            for bits in BITS[3:]:
                row(name, x, None, bits)
    everything = single + wide(rng)
    for name in ("+", "-", "*", "/"):
        for _ in range(60):
            row(name, rng.choice(everything), rng.choice(everything), rng.choice(BITS[:3]))
    with open(Path(__file__).with_name("balls.csv"), "w", newline="") as file:
        out = csv.writer(file, lineterminator="\n")
        out.writerow(["function", "lo", "hi", "lo2", "hi2", "bits", "least", "most"])
        out.writerows(rows)


main()
