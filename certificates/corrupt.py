#!/usr/bin/env python3
"""Spoils certificates and counts those that the checker still accepts.

    python3 corrupt.py FOLDER [COUNT]     writes corrupted.txt beside itself
"""
import copy
import json
import os
import random
import re
import sys

import check

HERE = os.path.dirname(os.path.abspath(__file__))
NUMBER = re.compile(r"-?\d+(\*2\^-?\d+)?")
SIGNS = {"+": "-", "-": "+", "*": "/", "sum": "difference", "difference": "sum"}


def places(thing, path=()):
    """All leaves, with how to get there."""
    if isinstance(thing, dict):
        for key, x in thing.items():
            if key not in ("kind", "title", "says", "given", "name", "variables", "rule", "function", "end"):
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
    pairs = [p for p in sorted(pairs, key=str) if isinstance(at(c["witnesses"], p), list) and len(at(c["witnesses"], p)) == 2]
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
    return f"witnesses of {other['claim']} {other['trial']}"


def dropped(c, rng, others):
    w = rng.choice(c["witnesses"])
    lists = [w[key] for key in ("parts", "equal", "steps", "cases", "functions", "decides", "generators") if w.get(key)] + [c["witnesses"]]
    of = rng.choice(lists)
    i = rng.randrange(len(of))
    gone = of.pop(i)
    return f"left out number {i}: {json.dumps(gone, ensure_ascii=False)[:80]}"


def another(c, rng, others):
    other = rng.choice([o for o in others if o["sha256"] != c["sha256"]])
    c["sha256"] = other["sha256"]
    if rng.random() < 0.5:
        c["statement"] = other["statement"]
    return f"hash of {other['claim']}"


KINDS = [digit, sign, box, swapped, dropped, another]


def main(folder, count):
    prints = check.Prints(os.path.join(HERE, ".."))
    files = sorted(name for name in os.listdir(folder) if name.endswith(".json"))
    texts = [open(os.path.join(folder, name), encoding="utf-8").read() for name in files]
    whole = [json.loads(text) for text in texts]
    rng, made, survivors = random.Random(1), {k.__name__: 0 for k in KINDS}, []
    n = 0
    while n < count:
        i, kind = rng.randrange(len(files)), KINDS[n % len(KINDS)]
        c = json.loads(texts[i])
        try:
            what = kind(c, rng, whole)
        except IndexError:
            continue
        if c == whole[i]:
            continue
        n += 1
        made[kind.__name__] += 1
        try:
            check.check(c, files[i], prints)
            survivors.append(f"{kind.__name__}: {files[i]}: {what}")
        except Exception:
            pass
        if n % 500 == 0:
            print(n, len(survivors), flush=True)
    import flint
    versions = f"Python {sys.version.split()[0]}, python-flint {flint.__version__}, FLINT {flint.__FLINT_VERSION__}"
    with open(os.path.join(HERE, "corrupted.txt"), "w", encoding="utf-8") as out:
        out.write(f"{versions}\n{count} files spoilt, {', '.join(f'{k} {v}' for k, v in made.items())}\n")
        out.write(f"{count - len(survivors)} rejected; accepted:\n" + "".join(f"{s}\n" for s in survivors))
    print(count, "spoilt,", len(survivors), "accepted")


if __name__ == "__main__":
    main(sys.argv[1], int(sys.argv[2]) if len(sys.argv) > 2 else 10000)
