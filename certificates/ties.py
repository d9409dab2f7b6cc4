"""Which formulas of a statement are among those that its certificate speaks of."""
import json

import latex
from formula import Wrong, demand, evaluate
from intervals import Interval, Numbers, hashed

# What vectors are, in the formulas of the certificates: the components, or other vectors (definitions of the paper).
PLANE = {x: [f"{x}_x", f"{x}_y", "0"] for x in "vAFνc"} | {"r\u0307": ["v_x", "v_y", "0"], "R": ["0", "0", ["-", "R"]], "ω": ["ω_x", "ω_y", "ω_z"]}
SLIP = ["+", ["vector", "r\u0307"], ["×", ["vector", "ω"], ["vector", "R"]]]
FRICTION = ["*", "μ", "g"]
SPHERE = PLANE | {
    "u": ["*", ["/", "1", ["√", ["*", FRICTION, "R"]]], SLIP],
    "γ": ["/", ["vector", "A"], FRICTION],
    "ζ": ["*", ["√", ["/", "R", FRICTION]], ["vector", "ω"]],
    "ρ\u0307": ["/", ["/", ["vector", "r\u0307"], "R"], ["√", ["/", FRICTION, "R"]]],
}
TABLE = {"r": ["x", "y", "0"], "ρ": ["x", "y", "0"], "r\u0307": ["u", "v", "0"], "ρ\u0307": ["u", "v", "0"]}
TABLE["ρ\u0308"] = ["-", ["+", ["vector", "ρ"], ["*", "2", ["×", ["vector", "ρ\u0307"], ["unit", "z"]]]],
                    ["/", ["vector", "ρ\u0307"], ["| |", ["vector", "ρ\u0307"]]]]
# Names that are spelled out in certificates.
SPELLED = {latex.name(name): tree for name, tree in {
    "φ_1": ["arcsin", "λ₀"], "φ_3": ["+", "π", ["arcsin", "λ₀"]], "φ̃_1": ["arccos", ["/", ["*", "π", "λ₀"], "2"]],
    "ψ_1": "q", "ψ_2": ["-", "π", "q"], "qλ₀": ["*", "q", "λ₀"],
}.items()}


class Anything(dict):
    """Names with the values that their letters give."""

    def __init__(self, salt):
        super().__init__()
        self.salt = salt

    def __contains__(self, name):
        return True

    def __missing__(self, name):
        name = latex.name(name)
        return evaluate(SPELLED[name], Numbers(self)) if name in SPELLED else Interval(hashed(self.salt + name))


def worth(tree, vectors, of):
    """A formula's value: an interval, or three for a vector."""
    if isinstance(tree, str):
        # A vector's letter alone is its absolute value.
        return worth(["| |", ["vector", tree]], vectors, of) if tree in vectors and tree != "R" else evaluate(tree, of)
    name, *operands = tree
    if name == "unit":
        return [of.number(int(axis == operands[0])) for axis in "xyz"]
    if name == "vector":
        demand(operands[0] in vectors, "an unknown vector")
        known = vectors[operands[0]]
        return [evaluate(x, of) for x in known] if known[-1] == "0" or known[0] == "0" or known[0] == "ω_x" else worth(known, vectors, of)
    x, *more = [worth(operand, vectors, of) for operand in operands]
    scale = lambda v, factor: [factor * c for c in v]
    inner = lambda a, b: sum((p * q for p, q in zip(a, b)), of.number(0))
    if name == "| |":
        return of.call("√", inner(x, x)) if isinstance(x, list) else x if x.low > 0 else -x
    y = more[0] if more else None
    plain = not isinstance(x, list) and not isinstance(y, list)
    if plain:
        joined = {"·": "*", "×": "*"}.get(name, name)
        given = {"first": x, "second": y}
        return evaluate([joined, "first"] if y is None else [joined, "first", "second"], Numbers(given))
    if name == "-" and y is None:
        return scale(x, of.number(-1))
    if name in "+-":
        demand(isinstance(x, list) and isinstance(y, list), "a sum of unlike things")
        return [p + q if name == "+" else p - q for p, q in zip(x, y)]
    if name == "·":
        return inner(x, y)
    if name == "×":
        return [x[i - 2] * y[i - 1] - x[i - 1] * y[i - 2] for i in range(3)]
    demand(name in "*/" and not (isinstance(x, list) and isinstance(y, list)), "no operation on vectors")
    if name == "/":
        return scale(x, of.number(1) / y)
    return scale(x, y) if isinstance(x, list) else scale(y, x)


def value(tree, salt, vectors=None):
    """What a formula is worth where each name has the value that its letters give; or nothing."""
    try:
        return worth(tree, vectors or {}, Numbers(Anything(salt)))
    except (Wrong, ValueError, OverflowError, TypeError, IndexError):
        return None


def subtrees(tree):
    yield tree
    if isinstance(tree, list):
        for part in tree[1:]:
            yield from subtrees(part)


def formulas(w):
    if w["kind"] == "identity":
        return [of if name == "read" else of[0] for part in w["parts"] for name, of in part.items() if name in ("read", "series")]
    if w["kind"] == "root":
        return w["functions"]
    if w["kind"] == "number":
        return [w["stated"]]
    return [c["formula"] for case in w.get("cases", []) for c in case["conditions"]]


def sides(statement):
    """The sides of the formulas of a statement that can be read, but for mere names and numbers; and whether any can be."""
    read = []
    for text in latex.statements(statement):
        try:
            read += [side for sides in [latex.Reader(text).sides()] for side in sides if side is not None]
        except (Wrong, RecursionError):
            continue
    return [side for side in read if isinstance(side, list) and side[0] not in ("vector", "unit")], bool(read)


def tied(statement, witnesses):
    """Whether a side of the printed formula, or one of its components, is among the formulas that the witnesses speak of."""
    if "$" in statement:
        return "words"
    wanted, read = sides(statement)
    if not wanted:
        return "mere names" if read else "not read"
    inside = {json.dumps(tree): tree for w in witnesses for formula in formulas(w) for tree in subtrees(formula) if isinstance(tree, list)}
    known = [pair for tree in inside.values() if None not in (pair := [value(tree, salt) for salt in "ab"])]
    understood = False
    for side in wanted:
        for vectors in [{}, PLANE, SPHERE, TABLE] if r"\bm" in statement else [{}]:
            pair = [value(side, salt, vectors) for salt in "ab"]
            if None in pair:
                continue
            understood = True
            pair = [x if isinstance(x, list) else [x] for x in pair]
            for x, y in zip(*pair):
                if x.sign() and any(0 in (x - a if sign else x + a) and 0 in (y - b if sign else y + b) for a, b in known for sign in (True, False)):
                    return "formula"
    return "elsewhere" if understood else "not read"


def outline(witnesses):
    """What a certificate consists of, in short."""
    of = lambda w: f"{w['title']} ({len(w['equal'])})" if w["kind"] == "identity" else f"{w['kind']} of {' '.join(w.get('variables', []))}"
    return "; ".join(map(of, witnesses))
