#!/usr/bin/env python3
"""Puts roots and inequalities of certificates to LeanCert, whose checker is proved in Lean.

    python3 lean.py FOLDER [DATE]     needs leancert 0.3.2, and numpy; with a date, the result is recorded in lean.csv

A sign on a part of a range becomes bounds on boxes of rational numbers, halved where need be. A root becomes three signs: that of
the function at either end of its box, and that of its slope in between. π is a variable between two decimals. What has roots or
inverse functions is left out: roots of long numbers take it minutes, and its arctangent is enclosed by [-2, 2].
"""
import json
import math
import os
import sys
from fractions import Fraction

import leancert

# Exact numbers of the checker are long.
sys.set_int_max_str_digits(0)
HERE = os.path.dirname(os.path.abspath(__file__))
PI = Fraction(31415926535897932384, 10**19), Fraction(31415926535897932385, 10**19)
CONFIG = leancert.Config(taylor_depth=25)
SMALL = Fraction(1, 2**80)


def dyadic(text):
    mantissa, _, exponent = text.partition("*2^")
    return Fraction(int(mantissa)) * Fraction(2) ** int(exponent or 0)


def about(tree, at):
    """A formula's value at a point, roughly."""
    if isinstance(tree, str):
        return float(at[tree] if tree in at else dyadic(tree))
    name, *operands = tree
    x, *more = [about(operand, at) for operand in operands]
    if more:
        return {"+": x + more[0], "-": x - more[0], "*": x * more[0], "/": x / more[0] if more[0] else math.nan}[name]
    return {"-": lambda: -x, "sin": lambda: math.sin(x), "cos": lambda: math.cos(x)}[name]()


def expression(tree, at):
    """A formula in LeanCert's terms, angles less the multiple of π that is near them at a point: beyond π nothing is known there."""
    if isinstance(tree, str):
        number = tree.lstrip("-")[:1].isdigit()
        return leancert.const(dyadic(tree)) if number else leancert.var(tree)
    name, *operands = tree
    x, *more = [expression(operand, at) for operand in operands]
    if name in ("sin", "cos"):
        turns = round(about(operands[0], at) / math.pi)
        x = x - turns * leancert.var("π") if turns else x
        y = leancert.sin(x) if name == "sin" else leancert.cos(x)
        return -y if turns % 2 else y
    if more:
        y, = more
        return {"+": lambda: x + y, "-": lambda: x - y, "*": lambda: x * y, "/": lambda: x / y}[name]()
    return {"-": lambda: -x}[name]()


def slope(tree, by):
    """The derivative of a formula."""
    if isinstance(tree, str):
        return "1" if tree == by else "0"
    name, x, *more = tree
    dx = slope(x, by)
    if not more:
        return {"-": lambda: ["-", dx], "sin": lambda: ["*", ["cos", x], dx], "cos": lambda: ["-", ["*", ["sin", x], dx]]}[name]()
    y, = more
    dy = slope(y, by)
    return {"+": lambda: ["+", dx, dy], "-": lambda: ["-", dx, dy], "*": lambda: ["+", ["*", dx, y], ["*", x, dy]],
            "/": lambda: ["-", ["/", dx, y], ["/", ["*", x, dy], ["*", y, y]]]}[name]()


def verified(tree, names, box, sign, deeper=8):
    """How many bounds LeanCert verifies for a sign on a box; nothing if it does not for one of them."""
    domain = dict(zip(names, box)) | {"π": PI}
    bound = {"lower": SMALL} if sign > 0 else {"upper": -SMALL}
    at = {name: (low + high) / 2 for name, (low, high) in domain.items()}
    if isinstance(leancert.verify_bound(expression(tree, at), domain, config=CONFIG, **bound), leancert.Verified):
        return 1
    i = max(range(len(box)), key=lambda i: box[i][1] - box[i][0])
    low, high = box[i]
    if deeper == 0 or low == high:
        return None
    halves = [verified(tree, names, box[:i] + [half] + box[i + 1:], sign, deeper - 1) for half in ((low, (low + high) / 2), ((low + high) / 2, high))]
    return None if None in halves else sum(halves)


def signs(w):
    """The signs on boxes that a witness comes down to."""
    names = w["variables"]
    if w["kind"] == "root":
        tree, = w["functions"]
        (low, high), = [[dyadic(end) for end in side] for side in w["within"]]
        first, last = (1 if int(values[0]) > 0 else -1 for values in w["corners"])
        yield tree, names, [(low, low)], first
        yield tree, names, [(high, high)], last
        yield slope(tree, names[0]), names, [(low, high)], last
        return
    for part in w["parts"]:
        box = [tuple(map(dyadic, side)) for side in part["at"]]
        ends = {"from": lambda i, at: box[i][0] == dyadic(at), "below": lambda i, at: box[i][1] < dyadic(at)}
        case = next(case for case in w["cases"] if case["of"] == "rest" or all(ends[k](*of) for k, of in case["of"].items()))
        for condition in [case["conditions"][part["by"]]] if case["choice"] else case["conditions"]:
            tree = condition["formula"]
            for _ in range(condition["power"]):
                tree = slope(tree, names[condition["by"]])
            yield tree, names, box, condition["sign"]


def main(folder, date=None):
    rows, distinct = [], set()
    for name in sorted(name for name in os.listdir(folder) if name.endswith(".json")):
        with open(os.path.join(folder, name), encoding="utf-8") as file:
            witnesses = json.load(file)["witnesses"]
        for place, w in enumerate(witnesses):
            if w["kind"] not in ("root", "range"):
                continue
            try:
                counts = [verified(*sign) for sign in signs(w)]
                bounds = None if None in counts else sum(counts)
            except (KeyError, ValueError):
                bounds = None
            rows.append(f"{name},{place},{w['kind']},{bounds or 'beyond'}\n")
            if bounds:
                distinct.add(json.dumps(w))
            print(rows[-1], end="", flush=True)
    done = sum(not row.endswith("beyond\n") for row in rows)
    head = f"leancert {leancert.__version__}: {done} of {len(rows)} roots and ranges verified, {len(distinct)} of them different"
    print(head)
    if date:
        with open(os.path.join(HERE, "lean.csv"), "w", encoding="utf-8") as out:
            out.write(f"{date},{head}\n" + "".join(rows))


if __name__ == "__main__":
    main(*sys.argv[1:3])
