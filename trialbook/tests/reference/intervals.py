"""Ranges of the elementary functions on intervals, from Arb: what `intervals.rs` holds the enclosures against.

Run: python3 intervals.py      writes intervals.csv
Made with Python 3.11.7, python-flint 0.9.0.

A row is: function, the bounds of its one or two arguments, the bounds of its range. Arguments are doubles and mean
exactly what they are. The bounds of the range are the largest double that is not above the infimum and the smallest that
is not below the supremum, so that a sound enclosure holds them both and the best one has them for its bounds; they are
empty where the function has no value somewhere. All doubles are written as the shortest decimals that give them back.
"""

import csv
import math
import random
from fractions import Fraction
from itertools import product
from pathlib import Path

from flint import arb, ctx

LEAST, MOST = 5e-324, 1.7976931348623157e308
INF = math.inf


def below(x):
    """The largest double that is not above the exact ball x."""
    if not x.is_finite():
        return -INF if x < 0 else MOST
    man, exp = x.man_exp()
    exact = Fraction(int(man)) * Fraction(2) ** int(exp)
    try:
        near = float(exact)
    except OverflowError:
        return MOST if exact > 0 else -INF
    return math.nextafter(near, -INF) if Fraction(near) > exact else near


def rounded(f):
    """Both neighbouring doubles of a number, which f gives as a ball."""
    bits = 128
    while bits < 20_000:
        ctx.prec = bits
        x = f()
        low = [below(x.lower()), below(x.upper())]
        high = [-below(-x.lower()), -below(-x.upper())]
        if x.is_exact() or low[0] == low[1] and high[0] == high[1]:
            return low[0], high[1]
        bits *= 2
    raise ArithmeticError("no precision tells the neighbours")


def holds_multiple(lo, hi, offset):
    """Whether (2k + offset) pi lies between lo and hi for some whole k."""
    ctx.prec = 4000
    low, high = [(arb(x) / arb.pi() - offset) / 2 for x in (lo, hi)]
    first, last = low.ceil().unique_fmpz(), high.floor().unique_fmpz()
    return first <= last


def ends(f):
    return lambda lo, hi: [lambda: f(arb(lo)), lambda: f(arb(hi))]


def waves(f, top, bottom):
    def places(lo, hi):
        found = ends(f)(lo, hi)
        found += [lambda: arb(1)] if holds_multiple(lo, hi, top) else []
        found += [lambda: arb(-1)] if holds_multiple(lo, hi, bottom) else []
        return found

    return places


def unless(bad, places):
    return lambda lo, hi: None if bad(lo, hi) else places(lo, hi)


def even(f):
    def places(lo, hi):
        return ends(f)(lo, hi) + ([lambda: f(arb(0))] if lo <= 0 <= hi else [])

    return places


def outside(low, high):
    return lambda lo, hi: lo < low or hi > high


def at_zero(lo, hi):
    return lo <= 0 <= hi


HALF, ONE = arb(1) / 2, arb(1)
# Where the range of a function on an interval has its ends: numbers among which the least and the largest are they.
UNARY = {
    "sin": waves(arb.sin, HALF, -HALF),
    "cos": waves(arb.cos, arb(0), ONE),
    "tan": unless(lambda lo, hi: holds_multiple(lo, hi, HALF) or holds_multiple(lo, hi, -HALF), ends(arb.tan)),
    "cot": unless(lambda lo, hi: holds_multiple(lo, hi, 0) or holds_multiple(lo, hi, ONE), ends(arb.cot)),
    "asin": unless(outside(-1, 1), ends(arb.asin)),
    "acos": unless(outside(-1, 1), ends(arb.acos)),
    "sinh": ends(arb.sinh),
    "cosh": even(arb.cosh),
    "tanh": ends(arb.tanh),
    "coth": unless(at_zero, ends(arb.coth)),
    "exp": ends(arb.exp),
    "exp_m1": ends(arb.expm1),
    "ln": unless(lambda lo, hi: lo <= 0, ends(arb.log)),
    "ln_1p": unless(lambda lo, hi: lo <= -1, ends(arb.log1p)),
    "sqrt": unless(lambda lo, hi: lo < 0, ends(arb.sqrt)),
    "squared": even(lambda x: x * x),
}


def quotient(x, y):
    return x / y


def power(x, y):
    return x**y


BINARY = {
    "+": lambda x, y: x + y,
    "-": lambda x, y: x - y,
    "*": lambda x, y: x * y,
    "/": quotient,
    "pow": power,
}


def corners(name, x, y):
    if name == "/" and at_zero(*y) or name == "pow" and x[0] <= 0:
        return None
    f = BINARY[name]
    return [lambda a=a, b=b: f(arb(a), arb(b)) for a, b in product(x, y)]


def close_to_quarters(count):
    """The doubles up to 1e5 that are relatively closest to multiples of pi/2."""
    ctx.prec = 200
    found = []
    for n in range(1, 63_662):
        exact = n * arb.pi() / 2
        x = float(exact.mid())
        found.append((float(abs(exact / x - 1)), x))
    return [x for _, x in sorted(found)[:count]]


def points(rng):
    """Numbers of every size, and what is hard."""
    sizes = [LEAST, 2.2250738585072014e-308, 1e-300, 1e-160, 1e-20, 1e-8, 1e-3, 0.36, 0.5, 0.75, 1.0, 1.5, 2.0, 3.0, 7.0]
    sizes += [20.0, 88.0, 699.0, 700.0, 709.7, 745.0, 99_999.5, 1e5, 123_456.7, 1e10, 1e22, 1e290, 1e300, MOST]
    sizes += [math.pi * k / 4 for k in range(1, 9)]
    sizes += [math.nextafter(x, way) for x in (0.75, 1.0, math.pi) for way in (0, INF)]
    sizes += [1 - 10.0**-k for k in (2, 5, 10, 15)] + [1 + 10.0**-k for k in (2, 5, 10, 15)]
    # Worst for the reduction in a binary64: 6381956970095103 2^797, and a known one of its smaller kin.
    sizes += [math.ldexp(6381956970095103, 797), 5.319372648326541e255]
    sizes += [rng.uniform(0, 1) for _ in range(12)] + [rng.uniform(0, 30) for _ in range(12)]
    sizes += [10 ** rng.uniform(-300, 300) for _ in range(12)] + [rng.uniform(0, 700) for _ in range(8)]
    return sizes + [-x for x in sizes] + [0.0]


def wide(rng):
    found = [(0.0, 1.0), (-1.0, 1.0), (0.5, 0.75), (-0.8, 0.9), (1.0, 2.0), (1.0, 1.5), (4.0, 5.0), (-0.1, 0.1), (3.0, 4.0)]
    found += [(0.0, 7.0), (-3.0, 3.0), (1.5, 4.7), (1.0, 700.0), (-700.0, 700.0), (1e-300, 1e300), (2.0, 3.0), (-3.0, -2.0)]
    found += [(0.0, 3.2), (0.0, 6.2), (6.3, 12.5), (-1e5, -1e5 + 1), (99_990.0, 99_991.0), (0.0, LEAST), (-LEAST, 1e300)]
    for turn in (0.5, 1.0, 1.5, 2.0, 5000.0, -1.0, -2.5):
        # Up to the extreme, and a place beyond it.
        x = math.pi * turn
        for end in (math.nextafter(x, 0), x, math.nextafter(x, 2 * x)):
            found.append(tuple(sorted((end, end - 0.25))))
            found.append(tuple(sorted((end, end + 0.25))))
    for _ in range(30):
        x = rng.uniform(-20, 20)
        found.append((x, x + 10 ** rng.uniform(-12, 0.7)))
        x = rng.uniform(-1, 1)
        found.append((x, min(1.0, x + 10 ** rng.uniform(-12, 0))))
        x = 10 ** rng.uniform(-8, 8)
        found.append((x, x * (1 + 10 ** rng.uniform(-12, 1))))
    return found


def range_of(places):
    if places is None:
        return "", ""
    bounds = [rounded(place) for place in places]
    return min(low for low, _ in bounds), max(high for _, high in bounds)


def text(x):
    return x if isinstance(x, str) else repr(x + 0.0)


def main():
    rng = random.Random("intervals")
    rows = []
    given = [(x, x) for x in points(rng)]
    quarters = [(sign * x, sign * x) for x in close_to_quarters(40) for sign in (1, -1)]
    for name, places in UNARY.items():
        asked = given + wide(rng) + (quarters if name in ("sin", "cos", "tan", "cot") else [])
        for x in asked:
            # Beyond, there is nothing but overflow, or a number so close to 1 that it takes long to tell it from 1.
            if name in ("sinh", "cosh", "exp", "exp_m1") and max(map(abs, x)) > 1e4:
                continue
            if name in ("tanh", "coth") and max(map(abs, x)) > 1e3:
                continue
            rows.append((name, *x, "", "", *range_of(places(*x))))
    mixed = points(rng) + [3.0, 1 / 3, 1e-170, 2.0**-1074 * 3, 2.0**600, 0.1, 1 + 2.0**-42]
    pairs = wide(rng) + [(x, x) for x in mixed]
    for name in BINARY:
        for _ in range(250):
            x, y = rng.choice(pairs), rng.choice(pairs)
            if name == "pow":
                x = tuple(sorted(map(abs, x)))
                if max(map(abs, y)) > 1e4 or x[0] > 0 and max(abs(b * math.log(a)) for a in x for b in y) > 1e4:
                    continue
            rows.append((name, *x, *y, *range_of(corners(name, x, y))))
    with open(Path(__file__).with_name("intervals.csv"), "w", newline="") as file:
        out = csv.writer(file, lineterminator="\n")
        out.writerow(["function", "lo", "hi", "lo2", "hi2", "least", "most"])
        out.writerows([name, *map(text, row)] for name, *row in rows)


main()
