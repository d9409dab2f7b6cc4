"""The certified numbers to 50 and to 1000 decimals, from what they are, without any code of theirs.

Run: python3 certified.py      writes certified.csv
Made with Python 3.11.7, mpmath 1.3.0.

Every number is computed with 1100 and with 1200 digits, which must round to the same decimals.

While a particle slides forwards from rest at the phase s under sin phi and the friction a = sin s, it has gained cos s -
cos e - a (e - s) at e. From there the numbers of the drive follow; friction backwards is q times as large:
- critical: a slip from rest lasts half a period, and begins and ends at rest: s and s + pi;
- slip-end: where what was gained is spent;
- A: the slip that just begins at rest takes the part q/(1 + q) of the period, as the momenta of both slips vanish;
- B and E: the slip ends where the drive backwards just equals friction, on its way up and on its way down;
- Y: where it ends at the drive's minimum 3 pi/2, with a q = 1: then x = e - s has sin s = -cos x, and tan x = x.

Escapes, in the laboratory: R'' = i R/|R|, R = c tau^(2 + ik), so that (2 + ik)(1 + ik)|c| = i: k^2 = 2 and 3 k |c| = 1. Then
rho = p = |c| tau^2, s is its integral, A^2/2 = s, and R turns by k ln tau. For the delay see make.py.
"""

import csv
from pathlib import Path

from mpmath import mp, mpf

PLACES = (50, 1000)


def root(f, near):
    # The second place is near too: farther off there may be no value.
    x = mp.findroot(f, (mpf(near), mpf(near) * (1 + mpf(10) ** -9)), tol=mpf(10) ** (-2 * mp.dps + 40), maxsteps=100)
    assert abs(x - mpf(near)) < mpf("0.01")
    return x


def gained(s, e, a):
    return mp.cos(s) - mp.cos(e) - a * (e - s)


def critical_phase():
    return root(lambda s: gained(s, s + mp.pi, mp.sin(s)), "0.567")


def slip_end(a, near):
    s = mp.asin(a)
    e = root(lambda e: gained(s, e, a), near)
    assert mp.pi - s < e < 2 * mp.pi - s
    return e


def x_y():
    x = root(lambda x: mp.tan(x) - x, "4.4934")
    assert mp.pi < x < 3 * mp.pi / 2
    return x


def q_y():
    # sin s = -cos x = 1/q
    return -1 / mp.cos(x_y())


def contact():
    # On B a q = -sin e. From Y: e = 3 pi/2 + d, 1/q - a = d^2/(2q), and the slip's equation gives dq/dd = q (q + 1)/x.
    x, q = x_y(), q_y()
    return 1 / (2 * q) * (x / (q * (q + 1))) ** 2


def curve_a(q, near):
    length = 2 * mp.pi * q / (1 + mpf(q))
    return mp.sin(root(lambda s: gained(s, s + length, mp.sin(s)), near))


def reversal(q, end, near):
    return root(lambda a: gained(mp.asin(a), end(mp.asin(q * a)), a), near)


def up(angle):
    return mp.pi + angle


def down(angle):
    return 2 * mp.pi - angle


def values():
    k = mp.sqrt(mpf(2))
    c = 1 / (3 * k)
    return {
        "lambda-c": lambda: 2 / mp.sqrt(4 + mp.pi**2),
        "critical-phase": critical_phase,
        "fig-4-slip-end": lambda: slip_end(1 / k, "3.197"),
        "slip-end-0.6": lambda: slip_end(mpf(3) / 5, "3.523"),
        "slip-end-0.9": lambda: slip_end(mpf(9) / 10, "2.482"),
        "y-root": x_y,
        "y-q": q_y,
        "y-lambda": lambda: 1 / q_y(),
        "contact": contact,
        "curve-a-2": lambda: curve_a(2, PHASES["curve-a-2"]),
        "curve-a-6": lambda: curve_a(6, PHASES["curve-a-6"]),
        "curve-a-12": lambda: curve_a(12, PHASES["curve-a-12"]),
        "curve-b-2": lambda: reversal(2, up, FRICTIONS["curve-b-2"]),
        "curve-b-3": lambda: reversal(3, up, FRICTIONS["curve-b-3"]),
        "curve-e-6": lambda: reversal(6, down, FRICTIONS["curve-e-6"]),
        "curve-e-12": lambda: reversal(12, down, FRICTIONS["curve-e-12"]),
        "p": lambda: c,
        "s": lambda: c / 3,
        "a": lambda: mp.sqrt(2 * c / 3),
        "winding": lambda: k,
        "delay": lambda: 3 * k / 4,
        # As the paper prints them.
        "a-printed": lambda: 2 / mp.sqrt(mpf(27)),
        "p-printed": lambda: mpf(2) / 9,
        "s-printed": lambda: mpf(2) / 27,
    }


def bracketed(f, low, high):
    """A root by bisection, in doubles' precision, as a place to begin at."""
    low, high = mpf(low), mpf(high)
    assert f(low) * f(high) < 0
    for _ in range(40):
        middle = (low + high) / 2
        low, high = (middle, high) if f(low) * f(middle) > 0 else (low, middle)
    return low


def begin(q, end):
    """The only friction below 1/q at which a slip ends so."""

    def f(a):
        return gained(mp.asin(a), end(mp.asin(q * a)), a)

    return bracketed(f, mpf(10) ** -9, 1 / mpf(q))


PHASES = {f"curve-a-{q}": bracketed(lambda s, q=q: gained(s, s + 2 * mp.pi * q / (1 + q), mp.sin(s)), mpf(10) ** -9, mp.pi / 2) for q in (2, 6, 12)}
FRICTIONS = {f"curve-b-{q}": begin(q, up) for q in (2, 3)} | {f"curve-e-{q}": begin(q, down) for q in (6, 12)}


def rounded(x, places):
    units = int(mp.nint(x * mpf(10) ** places))
    text = str(abs(units)).rjust(places + 1, "0")
    return f"{'-' if units < 0 else ''}{text[:-places]}.{text[-places:]}"


def decimals(digits):
    with mp.workdps(digits):
        return {name: [rounded(value(), places) for places in PLACES] for name, value in values().items()}


def main():
    found = decimals(1100)
    assert found == decimals(1200)
    with open(Path(__file__).with_name("certified.csv"), "w", newline="") as file:
        out = csv.writer(file, lineterminator="\n")
        out.writerow(["name", "fifty", "thousand"])
        out.writerows([name, *row] for name, row in found.items())


main()
