"""Equalities and near-equalities, decided by FLINT: what `exact.rs` holds the verdicts of the exact ring against.

Run: python3 exact.py      writes exact.csv
Made with Python 3.11.7, python-flint 0.9.0.

A row is: 1 for equal and 0 for not, and the two sides. A side is written backwards, operands first, one character each:
digits are numbers, x and y positive variables, e an exponent, a and b angles, h a hyperbolic argument, p the circle's
ratio; + - * / ^ take two operands, N (negative), s c t o (sine, cosine, tangent, cotangent), S C T O (the hyperbolic ones),
E (exponential), L (logarithm), R (square root) take one. So x2^y+ is x^2 + y.

One side is made at random, the other from it by identities of school; in about half the cases one character is changed
then. None of that is the verdict. That is FLINT's: both sides are quotients of polynomials over the rationals in the sines
and cosines of half the angles, the exponential of half the argument, the roots, the logarithms, y^e, with the relations
c^2 = 1 - s^2, r^2 = 1 + y^2, q^2 = 2, and the difference is zero if its numerator is divisible by them. Arb has to agree at
a random place: its enclosure of the difference holds 0 if they are equal, and does not if not.
"""

import random
from pathlib import Path

from flint import Ordering, arb, ctx, fmpq, fmpq_mpoly_ctx

ROWS = 10_000
LONGEST = 34
# Terms of a polynomial, so that nothing takes long.
MOST = 60

CTX = fmpq_mpoly_ctx.get(["ca", "cb", "r", "q", "sa", "sb", "u", "y", "E", "P", "Lx", "Ly", "e", "a", "b", "h", "p"], Ordering.lex)
GENERATOR = dict(zip(CTX.names(), CTX.gens()))
ca, cb, r, q, sa, sb, u, y, E, P, Lx, Ly, e, a, b, h, p = CTX.gens()
RELATIONS = [ca**2 + sa**2 - 1, cb**2 + sb**2 - 1, r**2 - y**2 - 1, q**2 - 2]
ZERO, ONE = CTX.constant(0), CTX.constant(1)
# x is the square of its root u.
ATOMS = {"x": u**2, "y": y, "e": e, "a": a, "b": b, "h": h, "p": p}


class Undefined(Exception):
    """No value, or none that is asked for."""


def normal(f):
    for relation in RELATIONS:
        _, f = divmod(f, relation)
    return f


class Quotient:
    """Of polynomials, by the relations."""

    def __init__(self, above, below=ONE):
        below = normal(below)
        if below.is_zero():
            raise Undefined("division by zero")
        above = normal(above)
        if len(above.to_dict()) > MOST or len(below.to_dict()) > MOST:
            raise Undefined("too long")
        common = above.gcd(below)
        if not common.is_constant():
            above, below = divmod(above, common)[0], divmod(below, common)[0]
        self.above, self.below = above, below

    def __add__(self, other):
        return Quotient(self.above * other.below + other.above * self.below, self.below * other.below)

    def __mul__(self, other):
        return Quotient(self.above * other.above, self.below * other.below)

    def over(self, other):
        return Quotient(self.above * other.below, self.below * other.above)

    def power(self, n):
        if abs(n) > 4:
            raise Undefined("a large power")
        if n < 0:
            return Quotient(ONE).over(self).power(-n)
        return Quotient(self.above**n, self.below**n)

    def linear(self, *generators):
        """Twice the coefficients of some generators, if this is a sum of whole halves of them."""
        if not self.below.is_constant():
            raise Undefined("not linear")
        rest = self.above / self.below.leading_coefficient()
        found = []
        for g in generators:
            twice = 2 * rest.derivative(str(g))
            if not twice.is_constant():
                raise Undefined("not linear")
            c = twice.leading_coefficient() if not twice.is_zero() else fmpq(0)
            if c.q != 1 or abs(c) > 12:
                raise Undefined("not halves")
            found.append(int(c))
            rest -= g * (c / 2)
        if not rest.is_zero():
            raise Undefined("not of these")
        return found


def valuation(f, g):
    """How often g divides f, and what is left."""
    n = 0
    if f.is_zero():
        raise Undefined("zero")
    while True:
        quotient, rest = divmod(f, g)
        if not rest.is_zero():
            return n, f
        n, f = n + 1, quotient


def circular(x):
    m, n, k = x.linear(a, b, p)
    cosine, sine = ONE, ZERO
    for count, c, s in ((m, ca, sa), (n, cb, sb), (k, ZERO, ONE)):
        s = -s if count < 0 else s
        for _ in range(abs(count)):
            cosine, sine = normal(cosine * c - sine * s), normal(sine * c + cosine * s)
    return Quotient(cosine), Quotient(sine)


def exponential(x):
    [n] = x.linear(h)
    return Quotient(E).power(n)


def logarithm(x):
    m, above = valuation(x.above, u)
    n, above = valuation(above, y)
    k, below = valuation(x.below, u)
    j, below = valuation(below, y)
    if m % 2 or k % 2 or normal(above - below) != 0:
        raise Undefined("no logarithm")
    return Quotient(Lx * ((m - k) // 2) + Ly * (n - j))


def square_root(x):
    m, above = valuation(x.above, u)
    n, above = valuation(above, y**2 + 1)
    k, below = valuation(x.below, u)
    j, below = valuation(below, y**2 + 1)
    if not (above.is_constant() and below.is_constant()) or (m - k) % 2 or above.is_zero():
        raise Undefined("no root")
    c = above.leading_coefficient() / below.leading_coefficient()
    for factor, root in ((1, ONE), (2, q)):
        square = c / factor
        if square > 0 and square.p.is_square() and square.q.is_square():
            number = fmpq(square.p.isqrt(), square.q.isqrt())
            # By the half power of x, whole or not.
            return Quotient(u).power((m - k) // 2) * Quotient(r).power(n - j) * Quotient(root * number)
    raise Undefined("no root of this number")


def raised(x, n):
    if n.below.is_constant() and n.above.is_constant():
        value = n.above.leading_coefficient() / n.below.leading_coefficient() if not n.above.is_zero() else fmpq(0)
        if value.q == 1:
            return x.power(int(value))
    if x.above != y or x.below != ONE:
        raise Undefined("a power of another base")
    one = Quotient(n.above - 0, n.below)
    if not one.below.is_constant():
        raise Undefined("an exponent that is no sum")
    rest = one.above / one.below.leading_coefficient()
    k = rest.derivative("e")
    rest -= k * e
    numbers = [c.leading_coefficient() if not c.is_zero() else fmpq(0) for c in (k, rest) if c.is_constant()]
    if len(numbers) != 2 or any(c.q != 1 or abs(c) > 6 for c in numbers):
        raise Undefined("an exponent that is no sum")
    return Quotient(P).power(int(numbers[0])) * Quotient(y).power(int(numbers[1]))


def over(f, g):
    return f.over(g)


MINUS = Quotient(-ONE)
FLINT = {
    "+": lambda f, g: f + g,
    "-": lambda f, g: f + MINUS * g,
    "*": lambda f, g: f * g,
    "/": over,
    "^": raised,
    "N": lambda f: MINUS * f,
    "s": lambda f: circular(f)[1],
    "c": lambda f: circular(f)[0],
    "t": lambda f: over(*reversed(circular(f))),
    "o": lambda f: over(*circular(f)),
    "S": lambda f: over(exponential(f) + MINUS * exponential(MINUS * f), Quotient(2 * ONE)),
    "C": lambda f: over(exponential(f) + exponential(MINUS * f), Quotient(2 * ONE)),
    "T": lambda f: over(FLINT["S"](f), FLINT["C"](f)),
    "O": lambda f: over(FLINT["C"](f), FLINT["S"](f)),
    "E": exponential,
    "L": logarithm,
    "R": square_root,
}
ARB = {
    "+": arb.__add__, "-": arb.__sub__, "*": arb.__mul__, "/": arb.__truediv__, "^": arb.__pow__, "N": arb.__neg__,
    "s": arb.sin, "c": arb.cos, "t": arb.tan, "o": arb.cot, "S": arb.sinh, "C": arb.cosh, "T": arb.tanh, "O": arb.coth,
    "E": arb.exp, "L": arb.log, "R": arb.sqrt,
}
TWO = "+-*/^"


def evaluate(text, atom, operations):
    stack = []
    for token in text:
        if token in operations:
            count = 2 if token in TWO else 1
            operands = stack[-count:]
            del stack[-count:]
            stack.append(operations[token](*operands))
        else:
            stack.append(atom(token))
    [value] = stack
    return value


def by_flint(text):
    return evaluate(text, lambda t: Quotient(CTX.constant(int(t)) if t.isdigit() else ATOMS[t]), FLINT)


def by_arb(text, place):
    ctx.prec = 300
    return evaluate(text, lambda t: arb(int(t)) if t.isdigit() else place[t], ARB)


# Making one side, and another from it. Trees are tuples (token, operands…).


def written(tree):
    return "".join(map(written, tree[1:])) + tree[0]


def number(rng):
    return (rng.choice("1223345"),)


def angle(rng):
    one = (rng.choice("aab"),)
    return rng.choice([one, one, ("*", ("2",), one), ("/", one, ("2",)), ("+", ("a",), ("b",)), ("-", ("a",), ("b",)), ("+", one, ("/", ("p",), ("2",))), ("-", ("p",), one), ("*", ("3",), one)])


def argument(rng):
    return rng.choice([("h",), ("h",), ("*", ("2",), ("h",)), ("/", ("h",), ("2",)), ("N", ("h",))])


def leaf(rng):
    kind = rng.randrange(12)
    if kind < 4:
        return (rng.choice("xxyyepah"),)
    if kind < 5:
        return number(rng)
    if kind < 8:
        return (rng.choice("ssccto"), angle(rng))
    if kind < 10:
        return (rng.choice("SCTOE"), argument(rng))
    return rng.choice([
        ("R", ("x",)), ("R", ("2",)), ("R", ("+", ("1",), ("^", ("y",), ("2",)))), ("R", ("*", ("2",), ("x",))), ("L", ("x",)), ("L", ("*", ("x",), ("y",))),
        ("L", ("/", ("x",), ("y",))), ("^", ("y",), ("e",)), ("^", ("y",), ("+", ("e",), ("1",))), ("^", ("y",), ("N", ("e",))),
    ])


def tree(rng, depth):
    if depth == 0 or rng.random() < 0.15:
        return leaf(rng)
    kind = rng.randrange(10)
    if kind < 8:
        return (rng.choice("++--**/"), tree(rng, depth - 1), tree(rng, depth - 1))
    return ("^", tree(rng, depth - 1), (rng.choice("223"),))


def rewritten(t, rng):
    """The same by an identity that fits, or as it is."""
    one, two = ("1",), ("2",)
    way = rng.randrange(4)
    match t:
        case ("*", f, ("+" | "-" as o, g, k)) | ("*", ("+" | "-" as o, g, k), f):
            return (o, ("*", f, g), ("*", f, k))
        case ("/", ("+" | "-" as o, g, k), f):
            return (o, ("/", g, f), ("/", k, f))
        case ("^", ("+" | "-" as o, f, g), ("2",)):
            return ("+", (o, ("^", f, two), ("*", two, ("*", f, g))), ("^", g, two))
        case ("-", ("^", f, ("2",)), ("^", g, ("2",))):
            return ("*", ("+", f, g), ("-", f, g))
        case ("^", ("s", f), ("2",)):
            return [("-", one, ("^", ("c", f), two)), ("/", ("-", one, ("c", ("*", two, f))), two)][way % 2]
        case ("^", ("c", f), ("2",)):
            return [("-", one, ("^", ("s", f), two)), ("/", ("+", one, ("c", ("*", two, f))), two)][way % 2]
        case ("^", ("C", f), ("2",)):
            return ("+", one, ("^", ("S", f), two))
        case ("^", ("R", f), ("2",)):
            return f
        case ("^", f, ("2",)):
            return ("*", f, f)
        case ("^", f, ("3",)):
            return ("*", f, ("^", f, two))
        case ("s", ("+" | "-" as o, f, g)):
            return (o, ("*", ("s", f), ("c", g)), ("*", ("c", f), ("s", g)))
        case ("c", ("+" | "-" as o, f, g)):
            return ("-" if o == "+" else "+", ("*", ("c", f), ("c", g)), ("*", ("s", f), ("s", g)))
        case ("s", ("*", ("2",), f)):
            return ("*", two, ("*", ("s", f), ("c", f)))
        case ("c", ("*", ("2",), f)):
            return [("-", one, ("*", two, ("^", ("s", f), two))), ("-", ("^", ("c", f), two), ("^", ("s", f), two))][way % 2]
        case ("t", ("/", f, ("2",))):
            return ("/", ("s", f), ("+", one, ("c", f)))
        case ("t", f):
            return ("/", ("s", f), ("c", f)) if way else ("/", one, ("o", f))
        case ("o", f):
            return ("/", ("c", f), ("s", f))
        case ("S", ("*", ("2",), f)):
            return ("*", two, ("*", ("S", f), ("C", f)))
        case ("S", f):
            return ("/", ("-", ("E", f), ("E", ("N", f))), two)
        case ("C", f):
            return ("/", ("+", ("E", f), ("/", one, ("E", f))), two)
        case ("T", f):
            return ("/", ("S", f), ("C", f))
        case ("O", f):
            return ("/", one, ("T", f))
        case ("E", ("*", ("2",), f)):
            return ("^", ("E", f), two)
        case ("L", ("*", f, g)):
            return ("+", ("L", f), ("L", g))
        case ("L", ("/", f, g)):
            return ("-", ("L", f), ("L", g))
        case ("R", ("*", f, g)):
            return ("*", ("R", f), ("R", g))
        case ("^", ("y",), ("+", f, ("1",))):
            return ("*", ("^", ("y",), f), ("y",))
        case ("^", ("y",), ("N", f)):
            return ("/", one, ("^", ("y",), f))
        case ("+", ("/", f, g), ("/", k, m)):
            return ("/", ("+", ("*", f, m), ("*", k, g)), ("*", g, m))
        case ("+" | "*" as o, f, g):
            return (o, g, f)
        case ("-", f, g):
            return ("+", f, ("N", g))
        case ("/", f, g):
            return ("*", f, ("^", g, ("N", one))) if way else t
    return t


def other_side(t, rng):
    t = (t[0], *(other_side(part, rng) for part in t[1:]))
    return rewritten(t, rng) if rng.random() < 0.7 else t


SWAPS = ["0123456789", "xy", "abhpe", "+-", "*/", "scto", "SCTO"]


def spoilt(text, rng):
    i = rng.randrange(len(text))
    kin = next((group for group in SWAPS if text[i] in group), text[i])
    return text[:i] + rng.choice(kin) + text[i + 1 :]


def main():
    rng = random.Random("exact")
    rows, seen, equal = [], set(), 0
    while len(rows) < ROWS:
        start = tree(rng, rng.choice((1, 2, 2, 3)))
        left, right = written(start), written(other_side(start, rng))
        # As many of the one as of the other.
        if 2 * equal > len(rows):
            right = spoilt(right, rng)
        if left == right or max(len(left), len(right)) > LONGEST or (left, right) in seen:
            continue
        try:
            difference = by_flint(left) + MINUS * by_flint(right)
        except Undefined:
            continue
        verdict = difference.above.is_zero()
        place = {name: arb(rng.randrange(1, 2**60)) / 2**59 + arb(1) / 7 for name in ATOMS} | {"p": arb.pi()}
        found = by_arb(left, place) - by_arb(right, place)
        if not found.is_finite() or found.rad() > arb(10) ** -30:
            continue
        assert found.contains(0) == verdict, (left, right, verdict, found)
        seen.add((left, right))
        equal += verdict
        rows.append(f"{int(verdict)},{left},{right}\n")
    Path(__file__).with_name("exact.csv").write_text("verdict,left,right\n" + "".join(rows))
    print(equal, "are equal")


main()
