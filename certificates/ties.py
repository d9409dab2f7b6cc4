"""Which formulas of a statement are among those that its certificate speaks of."""
import json

from flint import arb, arb_mat

from formula import Wrong, demand, evaluate
from intervals import FLINT, Numbers, hashed
from latex import Reader, name, read, statements

# What vectors are, in the formulas of the certificates: the components, or other vectors (definitions of the paper).
PLANE = {x: (f"{x}_x", f"{x}_y", "0") for x in "vAFνc"}
PLANE |= {"r\u0307": ("v_x", "v_y", "0"), "R": ("0", "0", ["-", "R"]), "ω": ("ω_x", "ω_y", "ω_z")}
SPHERE = PLANE | {
    "u": read(r"\frac{1}{\sqrt{\mu gR}}(\dot{\bm r} + \bm\omega\times\bm R)"),
    "γ": read(r"\bm A/(\mu g)"),
    "ζ": read(r"\sqrt{R/(\mu g)}\bm\omega"),
    "ρ\u0307": read(r"\dot{\bm r}/R/\sqrt{\mu g/R}"),
}
TABLE = {x: ("x", "y", "0") for x in "rρ"} | {x + "\u0307": ("u", "v", "0") for x in "rρ"}
TABLE["ρ\u0308"] = read(r"-(\bm\rho + 2(\dot{\bm\rho}\times\hat{\bm z})) - \dot{\bm\rho}/\vert\dot{\bm\rho}\vert")
# Names that are spelled out in certificates.
SPELLED = {name(x): read(spelled) for x, spelled in {
    "φ_1": r"\sin^{-1}\lambda_0", "φ_3": r"\pi + \sin^{-1}\lambda_0", "φ̃_1": r"\cos^{-1}(\pi\lambda_0/2)",
    "ψ_1": "q", "ψ_2": r"\pi - q", "qλ₀": r"q\lambda_0",
}.items()}


class Letters(Numbers):
    """Calculates with numbers, and with vectors, where each name has the value that its letters give."""
    number = arb

    def __init__(self, salt, vectors):
        super().__init__({})
        self.salt, self.vectors = salt, vectors

    def symbol(self, x):
        if x in self.vectors and x != "R":
            # A vector's letter alone is its absolute value.
            return evaluate(["| |", ["vector", x]], self)
        x = name(x)
        if x in self.symbols:
            return self.symbols[x]
        return evaluate(SPELLED[x], self) if x in SPELLED else arb(hashed(self.salt + x))

    def whole(self, x):
        return int(x.unique_fmpz()) if x.is_integer() and abs(x) < 1000 else None

    def known(self, tree):
        """What is of vectors only."""
        match tree:
            case ["unit", axis]:
                return arb_mat(3, 1, [int(axis == other) for other in "xyz"])
            case ["vector", x]:
                demand(x in self.vectors, "an unknown vector")
                of = self.vectors[x]
                return arb_mat(3, 1, [evaluate(c, self) for c in of]) if isinstance(of, tuple) else evaluate(of, self)
            case ["| |" | "·" | "×" as sign, *operands]:
                x, y = (evaluate(operands[i], self) for i in (0, -1))
                if isinstance(x, arb) and isinstance(y, arb):
                    return abs(x) if sign == "| |" else x * y
                x, y = x.entries(), y.entries()
                if sign == "×":
                    return arb_mat(3, 1, [x[i - 2] * y[i - 1] - x[i - 1] * y[i - 2] for i in range(3)])
                inner = sum((p * q for p, q in zip(x, y)), arb(0))
                return inner if sign == "·" else inner.sqrt()

    def call(self, f, x):
        return FLINT[f](x)


def value(tree, salt, vectors=None):
    """What a formula is worth where each name has the value that its letters give; or nothing."""
    try:
        x = evaluate(tree, Letters(salt, vectors or {}))
        return x if isinstance(x, arb_mat) or x.is_finite() else None
    except (Wrong, ValueError, TypeError, AttributeError, KeyError):
        return None


def subtrees(tree):
    if isinstance(tree, list):
        yield tree
        for part in tree[1:]:
            yield from subtrees(part)


def formulas(w):
    parts = w.get("parts", [])
    found = [part.get("read") or part["series"][0] for part in parts if part.keys() & {"read", "series"}]
    found += [c["formula"] for case in w.get("cases", []) for c in case["conditions"]]
    return found + w.get("functions", []) + ([w["stated"]] if "stated" in w else [])


def sides(statement):
    """The sides of a statement's formulas that can be read, but for mere names and numbers; and whether any can be."""
    found = [side for text in statements(statement) for side in Reader(text).sides() if side is not None]
    return [side for side in found if isinstance(side, list) and side[0] not in ("vector", "unit")], bool(found)


def tied(statement, witnesses):
    """Whether a side of the printed formula, or a component of it, is among the formulas that witnesses speak of."""
    if "$" in statement:
        return "words"
    wanted, readable = sides(statement)
    if not wanted:
        return "mere names" if readable else "not read"
    trees = {json.dumps(tree): tree for w in witnesses for formula in formulas(w) for tree in subtrees(formula)}
    pairs = [[value(tree, salt) for salt in "ab"] for tree in trees.values()]
    # What differs by its sign counts as well.
    known = [(a * sign, b * sign) for a, b in pairs if None not in (a, b) for sign in (1, -1)]
    understood = False
    for side in wanted:
        for vectors in [{}, PLANE, SPHERE, TABLE] if r"\bm" in statement else [{}]:
            pair = [value(side, salt, vectors) for salt in "ab"]
            if None in pair:
                continue
            understood = True
            for x, y in zip(*(x.entries() if isinstance(x, arb_mat) else [x] for x in pair)):
                if 0 not in x and any(0 in x - a and 0 in y - b for a, b in known):
                    return "formula"
    return "elsewhere" if understood else "not read"
