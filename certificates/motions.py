#!/usr/bin/env python3
"""Follows the motions whose ends the command has proved by enclosing them, once more, with nothing but Python.

    python3 certificates/motions.py target/debug/slipbook
    python3 certificates/motions.py target/debug/slipbook 'A = 0.58'     (those in whose name that is)

The command says where they start and how they end. Here Newton's law is integrated as it stands, in Cartesian coordinates on the
table, by Taylor's series of numbers with an error bound, in so many digits that nothing has to be done against the growth of the
bounds. Exit code 1 if a motion is not certain to end as is said, 2 if the command gives none.
"""
import json
import subprocess
import sys
from fractions import Fraction
from math import factorial

CLAIM = "s4-envelope-is-boundary"
BITS, TERMS, STEPS = 256, 32, 4000
ONE = 1 << BITS
# A step leaves out so much.
ACCURACY = 1 << 100


class Ball:
    """All numbers no farther than `r` from `m`, in units of 2^-BITS."""
    __slots__ = "m", "r"

    def __init__(self, m, r=0):
        self.m, self.r = m, r

    def __add__(self, y):
        return Ball(self.m + y.m, self.r + y.r)

    def __sub__(self, y):
        return Ball(self.m - y.m, self.r + y.r)

    def __mul__(self, y):
        return dot([self], [y])

    def __truediv__(self, n):
        return Ball(self.m // n, self.r // n + 2)

    def twice(self):
        return Ball(2 * self.m, 2 * self.r)

    def within(self, y):
        return abs(self.m - y.m) + self.r <= y.r

    def positive(self):
        return self.m > self.r

    def __lt__(self, y):
        return (y - self).positive()


def dot(xs, ys):
    """The sum of products, rounded once."""
    m = sum(x.m * y.m for x, y in zip(xs, ys))
    r = sum((abs(x.m) + x.r) * y.r + x.r * abs(y.m) for x, y in zip(xs, ys))
    return Ball(m >> BITS, (r >> BITS) + 2)


def number(x):
    """A fraction, or the decimal of this text."""
    x = Fraction(x)
    return Ball((x.numerator << BITS) // x.denominator, 1)


def series(x, terms):
    """Σ cₖ xᵏ/k! for |x| ≤ 4, |cₖ| ≤ 1: what is left out is less than twice its first term."""
    power, total = Ball(ONE), Ball(0)
    for k, c in enumerate(terms):
        total += Ball(c * power.m, abs(c) * power.r)
        power = power * x / (k + 1)
    return total + Ball(0, 2 * (abs(power.m) + power.r))


def exp(x):
    return series(x, [1] * BITS)


def cos(x):
    return series(x, [1, 0, -1, 0] * (BITS // 4))


def sin(x):
    return series(x, [0, 1, 0, -1] * (BITS // 4))


def expansion(state, order):
    """Taylor's coefficients of place, velocity and speed on the table, by s with dτ = p ds.

    Newton's law in units of μg and Ω: the force along the radius, r, that across the velocity, and friction, −v/p.
    """
    x, y, u, v, p = c = [[value] for value in state]
    to, across = [], []
    for k in range(order):
        to.append(x[k] + v[k].twice())
        across.append(y[k] - u[k].twice())
        back = p[::-1]
        rates = [dot(u, back), dot(v, back), dot(to, back) - u[k], dot(across, back) - v[k],
                 dot(x, u[::-1]) + dot(y, v[::-1]) - p[k]]
        for series_, rate in zip(c, rates):
            series_.append(rate / (k + 1))
    return c


def walls(state, h):
    """What no motion leaves within a step, by Picard's iteration; nothing if none is found."""
    during, box = Ball(h.m // 2 + 1, h.m // 2 + 1), state
    for _ in range(12):
        reached = [x + during * c[1] for x, c in zip(state, expansion(box, 1))]
        if all(map(Ball.within, reached, box)):
            return reached
        box = [Ball(x.m, x.r + x.r // 5 + (1 << 20)) for x in reached]
    return None


def step(state, h):
    """The state after a step; nothing if it is too long."""
    box = walls(state, h)
    if box is None:
        return None
    after = []
    for own, rest in zip(expansion(state, TERMS - 1), expansion(box, TERMS)):
        left_out = rest[TERMS]
        for _ in range(TERMS):
            left_out = left_out * h
        if left_out.r > ACCURACY:
            return None
        total = Ball(0)
        for c in reversed(own):
            total = total * h + c
        after.append(total + left_out)
    return after


def end(state):
    """What is certain of all motions from here, as the book proves it: p + ρ < 1 is rest; ρ² − p² > 1, ξ > 1, or a velocity in the
    laboratory against that on the table with 1 − ξ < p, escape. ξ is the place along the velocity."""
    x, y, u, v, p = state
    one = Ball(ONE)
    if not p.positive():
        return None
    square, along, about = x * x + y * y, x * u + y * v, x * v - y * u
    if p < one and square < (one - p) * (one - p):
        return "rest"
    turned = ((p * p).twice() + about) < Ball(0) and p - along < p * p
    if one < square - p * p or p < along or turned:
        return "escape"
    return None


def followed(state):
    """How all motions from a state end, and after how many steps that is certain."""
    h = ONE // 8
    for steps in range(STEPS):
        known = end(state)
        if known:
            return known, steps
        after = None
        while after is None:
            if h < ONE >> 20:
                return "nothing certain", steps
            after = step(state, Ball(h))
            h = h * 3 // 4 if after is None else h
        state, h = after, min(h * 5 // 4, ONE)
    return "nothing certain", STEPS


def moving(a, alpha, psi):
    """p = A sinh α, ρ = A cosh α, and ψ from the velocity to the place."""
    a, alpha, psi = map(number, (a, alpha, psi))
    grows, falls = exp(alpha), exp(Ball(-alpha.m, alpha.r))
    p, rho, zero = a * (grows - falls) / 2, a * (grows + falls) / 2, Ball(0)
    return [rho * cos(psi), rho * sin(psi), p, zero, p]


def starts(slipbook):
    """Name, start, and how it is said to end."""
    def asked(*words):
        return json.loads(subprocess.run([slipbook, *words, "--json"], check=True, capture_output=True).stdout)

    for evidence in asked("show", CLAIM)["claims"][0]["evidence"]:
        if evidence["route"] == "certified":
            if evidence["points"] != len(evidence["samples"]):
                sys.exit(f"{evidence['trial']} does not say all of its starts")
            for pair in evidence["samples"]:
                given = [part.split(" = ")[1] for part in pair["at"].split(", ")]
                yield pair["at"], moving(*given), {1: "rest", 0: "escape"}[pair["found"]]


def main():
    if len(sys.argv) < 2 or sys.argv[1].startswith("-"):
        sys.exit(__doc__)
    slipbook, *wanted = sys.argv[1:]
    wrong = seen = 0
    for name, start, said in starts(slipbook):
        if wanted and not any(part in name for part in wanted):
            continue
        found, steps = followed(start)
        print(f"{name}: {found}, after {steps} steps" + ("" if found == said else f", and not {said}"), flush=True)
        wrong, seen = wrong + (found != said), seen + 1
    print(f"{seen} motions, {wrong} of them not as the command says")
    return 2 if seen == 0 else min(wrong, 1)


if __name__ == "__main__":
    sys.exit(main())
