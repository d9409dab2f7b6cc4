#!/usr/bin/env python3
"""Spoils certificates and counts those that the checker still accepts.

    python3 corrupt.py FOLDER FROM TO     spoils files number FROM to TO, and says what is still accepted, or refused by transcript.txt alone
"""
import copy
import json
import os
import random
import re
import sys

import check
import ties
from formula import FUNCTIONS, MEANT

HERE = os.path.dirname(os.path.abspath(__file__))
NUMBER = re.compile(r"-?\d+(\*2\^-?\d+)?")
SIGNS = {"+": "-", "-": "+", "*": "/", "sum": "difference", "difference": "sum"}


def places(thing, path=()):
    """All leaves, with how to get there."""
    if isinstance(thing, dict):
        for key, x in thing.items():
            if key not in ("kind", "title", "says", "given", "name", "variables", "rule", "function", "end", "choice", "fails"):
                yield from places(x, path + (key,))
    elif isinstance(thing, list):
        for i, x in enumerate(thing):
            yield from places(x, path + (i,))
    else:
        yield path, thing


def at(thing, path):
    for key in path:
        thing = thing[key]
    return thing


def digit(c, rng, others):
    leaves = [(p, x) for p, x in places(c["witnesses"]) if type(x) is int or isinstance(x, str) and NUMBER.fullmatch(x)]
    path, x = rng.choice(leaves)
    text = str(x)
    i = rng.choice([i for i, letter in enumerate(text) if letter.isdigit()])
    if text[i - 2:i] == "*2" or text[i:].startswith("2^"):
        i = 0 if text[0] != "-" else 1
    new = text[:i] + rng.choice([d for d in "0123456789" if d != text[i]]) + text[i + 1:]
    at(c["witnesses"], path[:-1])[path[-1]] = int(new) if type(x) is int else new
    return f"{path}: {x} became {new}"


def sign(c, rng, others):
    leaves = [(p, x) for p, x in places(c["witnesses"]) if x in SIGNS or isinstance(x, str) and re.fullmatch(r"-?[1-9]\d*", x) or x in (1, -1) and type(x) is int]
    path, x = rng.choice(leaves)
    whole = at(c["witnesses"], path[:-1])
    if x in SIGNS and path[-1] == 0 and len(whole) == 2:
        whole[:] = ["+", "0", whole[1]]
    else:
        whole[path[-1]] = SIGNS[x] if x in SIGNS else -x if type(x) is int else x[1:] if x[0] == "-" else "-" + x
    return f"{path}: {x} turned"


def box(c, rng, others):
    pairs = {p[:-1] for p, x in places(c["witnesses"]) if isinstance(x, str) and "*2^" in x and type(p[-1]) is int and p[-1] < 2}
    pairs = [p for p in sorted(pairs, key=str) if [type(end) for end in at(c["witnesses"], p)] == [str, str]]
    if not pairs:
        return digit(c, rng, others)
    path = rng.choice(pairs)
    pair = at(c["witnesses"], path)
    end = rng.randrange(2)
    before = pair[end]
    m, e = before.split("*2^") if "*" in before else ("1", "-20")
    pair[end] = f"{int(m) * 16 + rng.choice([-5, -1, 1, 5])}*2^{int(e) - 4}" if rng.random() < 0.5 else f"{m}*2^{int(e) + rng.choice([-1, 1])}"
    return f"{path}: {before} became {pair[end]}"


def swapped(c, rng, others):
    other = rng.choice([o for o in others if o["witnesses"] != c["witnesses"]])
    c["witnesses"] = copy.deepcopy(other["witnesses"])
    return f"witnesses of {other['claim']} {other['proof']}"


def dropped(c, rng, others):
    w = rng.choice(c["witnesses"])
    lists = [w[key] for key in ("parts", "equal", "steps", "cases", "functions", "decides", "generators") if w.get(key)] + [c["witnesses"]]
    of = rng.choice(lists)
    i = rng.randrange(len(of))
    gone = of.pop(i)
    return f"left out number {i}: {json.dumps(gone, ensure_ascii=False)[:80]}"


def another(c, rng, others):
    other = rng.choice([o for o in others if o["statement"] != c["statement"]])
    c["statement"] = other["statement"]
    return f"statement of {other['claim']}"


KINDS = [digit, sign, box, swapped, dropped, another]


def same(c, d):
    """Whether two files differ, if at all, in how formulas are written and not in what they are worth."""
    if isinstance(c, dict) and isinstance(d, dict) and c.keys() == d.keys():
        return all(same(c[key], d[key]) for key in c)
    if isinstance(c, list) and isinstance(d, list) and len(c) == len(d):
        if c != d and c and c[0] in ["+", "-", "*", "/", "^", *FUNCTIONS, *MEANT]:
            worth = [[ties.value(tree, salt) for salt in "ab"] for tree in (c, d)]
            return None not in sum(worth, []) and all(0 in x - y for x, y in zip(*worth))
        return all(map(same, c, d))
    return c == d


def spoilt(n, whole):
    """The file number n, and what was done to it."""
    rng, kind = random.Random(n), KINDS[n % len(KINDS)]
    while True:
        i = rng.randrange(len(whole))
        c = copy.deepcopy(whole[i])
        try:
            what = kind(c, rng, whole)
        except IndexError:
            continue
        if not same(c, whole[i]):
            return i, c, f"{kind.__name__}: {what}"


def main(folder, first, last):
    prints = check.Prints(os.path.join(HERE, ".."))
    files = sorted(name for name in os.listdir(folder) if name.endswith(".json"))
    whole = [json.load(open(os.path.join(folder, name), encoding="utf-8")) for name in files]
    accepted = listed = 0
    for n in range(first, last):
        i, c, what = spoilt(n, whole)
        try:
            check.check(c, files[i], prints)
            accepted += 1
        except Exception as error:  # whatever a broken file brings about
            if "not what is listed" not in str(error):
                continue
            listed += 1
            what = f"by the list alone: {what}"
        print(f"{n}: {files[i]}: {what}", flush=True)
    print(f"{last - first} spoilt, {accepted} accepted, {listed} refused by the list alone")


if __name__ == "__main__":
    main(sys.argv[1], *map(int, sys.argv[2:4]))
