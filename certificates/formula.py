"""Formulas as nested lists, and what they are worth: among elements of a field, intervals, or power series of either.

Whatever calculates has `number`, `pi`, `symbol`, `call`, `raised`, `is_zero` and `whole`, and values with + - * /.
"""
import operator
import re

from flint import fmpq

FUNCTIONS = {"sin", "cos", "exp", "ln", "√", "arcsin", "arccos"}
MEANT = {
    "tan": lambda x: ["/", ["sin", x], ["cos", x]],
    "cot": lambda x: ["/", ["cos", x], ["sin", x]],
    "sinh": lambda x: ["/", ["-", ["exp", x], ["exp", ["-", x]]], "2"],
    "cosh": lambda x: ["/", ["+", ["exp", x], ["exp", ["-", x]]], "2"],
    "tanh": lambda x: ["/", ["sinh", x], ["cosh", x]],
    "coth": lambda x: ["/", ["cosh", x], ["sinh", x]],
}
OPERATIONS = {"+": operator.add, "-": operator.sub, "*": operator.mul, "/": operator.truediv}


class Wrong(Exception):
    """What is wrong with a certificate."""


def demand(holds, why):
    if not holds:
        raise Wrong(why)


def keys(thing, names):
    """The values of an object that has exactly these keys."""
    names = names.split()
    demand(isinstance(thing, dict) and sorted(thing) == sorted(names), f"not the keys {names}")
    return [thing[name] for name in names]


def index(x, below):
    demand(type(x) is int and 0 <= x < below, f"no place in the list: {x!r}")
    return x


def dyadic(text):
    """A number that is written as m or m·2^e, exactly."""
    found = re.fullmatch(r"(-?\d+)(?:\*2\^(-?\d{1,5}))?", text) if isinstance(text, str) else None
    demand(found, f"no number: {text!r}")
    return fmpq(int(found[1])) * fmpq(2) ** int(found[2] or 0)


def evaluate(tree, of):
    """A formula's value."""
    if isinstance(tree, str):
        if tree == "π":
            return of.pi()
        return of.number(dyadic(tree)) if re.match(r"-?\d", tree) else of.symbol(tree)
    demand(isinstance(tree, list) and len(tree) in (2, 3) and isinstance(tree[0], str), "no formula")
    name, *operands = tree
    if len(operands) == 1:
        if name in MEANT:
            return evaluate(MEANT[name](*operands), of)
        if (known := of.known(tree)) is not None:
            return known
        x = evaluate(*operands, of)
        demand(name == "-" or name in FUNCTIONS, f"no function: {name}")
        return -x if name == "-" else of.call(name, x)
    demand(name == "^" or not any(str(operand).startswith("-") for operand in operands), "a number with a sign inside")
    x, y = (evaluate(operand, of) for operand in operands)
    demand(name == "^" or name in OPERATIONS, f"no operation: {name}")
    return of.raised(x, y) if name == "^" else OPERATIONS[name](x, y)


class Series:
    """x^start (c₀ + c₁ x + …), as far as the coefficients are known; `of` calculates with them."""

    def __init__(self, of, start, coefficients):
        self.of, self.start, self.c = of, start, coefficients

    def at(self, k):
        demand(k < self.start + len(self.c), "a coefficient that is not known")
        return self.c[k - self.start] if k >= self.start else self.of.number(0)

    def trimmed(self):
        """Without zeros at the beginning."""
        first = next((i for i, c in enumerate(self.c) if not self.of.is_zero(c)), len(self.c))
        return Series(self.of, self.start + first, self.c[first:])

    def plain(self):
        """The coefficients, if none is of a negative power."""
        demand(all(self.of.is_zero(self.at(k)) for k in range(self.start, 0)), "no series in whole powers")
        return [self.at(k) for k in range(self.start + len(self.c))]

    def sum(self, terms):
        return sum((a * b for a, b in terms), self.of.number(0))

    def __add__(self, y):
        start, end = min(self.start, y.start), min(self.start + len(self.c), y.start + len(y.c))
        return Series(self.of, start, [self.at(k) + y.at(k) for k in range(start, end)])

    def __neg__(self):
        return Series(self.of, self.start, [-c for c in self.c])

    def __sub__(self, y):
        return self + -y

    def __mul__(self, y):
        x, y = self.trimmed(), y.trimmed()
        n = min(len(x.c), len(y.c))
        return Series(self.of, x.start + y.start, [self.sum((x.c[k], y.c[m - k]) for k in range(m + 1)) for m in range(n)])

    def __truediv__(self, y):
        y, q = y.trimmed(), []
        demand(y.c, "division by a series without a term")
        for m in range(min(len(self.c), len(y.c))):
            q.append((self.c[m] - self.sum((q[k], y.c[m - k]) for k in range(m))) / y.c[0])
        return Series(self.of, self.start - y.start, q)


class Expansion:
    """Calculates with power series, where some symbols are such."""

    def __init__(self, of, series, order):
        self.of, self.series, self.order = of, series, order

    def constant(self, x):
        return Series(self.of, 0, [x] + [self.of.number(0)] * self.order)

    def number(self, n):
        return self.constant(self.of.number(n))

    def pi(self):
        return self.constant(self.of.pi())

    def symbol(self, name):
        return self.series[name] if name in self.series else self.constant(self.of.symbol(name))

    def is_zero(self, x):
        return not x.trimmed().c

    def known(self, tree):
        """That of a multiple of a symbol of which only the exponential is given."""
        n, name = 1, tree[1] if tree[0] == "exp" else []
        if isinstance(name, list) and name and name[0] == "-" and len(name) == 2:
            n, name = -1, name[1]
        if isinstance(name, list) and name and name[0] == "*" and re.fullmatch(r"-?\d+", str(name[1])):
            n, name = n * int(name[1]), name[2]
        known = self.series.get(f"exp {name}") if isinstance(name, str) else None
        return None if known is None else self.raised(known, self.number(n))

    def raised(self, x, y):
        e, *others = y.plain()
        demand(all(self.of.is_zero(c) for c in others), "a varying exponent")
        n = self.of.whole(e)
        if n is not None:
            power = self.number(1)
            for _ in range(abs(n)):
                power = power * x
            return power if n >= 0 else self.number(1) / power
        return self.power(x, e)

    def power(self, x, e):
        """y = x^e obeys x y′ = e x′ y."""
        x = x.trimmed()
        demand(x.c, "a power of a series without a term")
        start, number = self.of.whole(self.of.number(x.start) * e), self.of.number
        demand(start is not None, "no whole powers")
        y = [self.of.raised(x.c[0], e)]
        for n in range(1, len(x.c)):
            weights = [e * number(k) - number(n - k) for k in range(n + 1)]
            y.append(x.sum((weights[k] * x.c[k], y[n - k]) for k in range(1, n + 1)) / (x.c[0] * number(n)))
        return Series(self.of, start, y)

    def root(self, x):
        x = x.trimmed()
        demand(x.c and x.start % 2 == 0, "no root in whole powers")
        y = [self.of.call("√", x.c[0])]
        for n in range(1, len(x.c)):
            y.append((x.c[n] - x.sum((y[k], y[n - k]) for k in range(1, n))) / (y[0] * self.of.number(2)))
        return Series(self.of, x.start // 2, y)

    def integral(self, start, x, y):
        """start + ∫ dx/y"""
        number = self.of.number
        rate = Series(self.of, 0, [c * number(k) for k, c in enumerate(x.plain())]) / y
        return Series(self.of, 0, [start] + [rate.at(k) / number(k) for k in range(1, rate.start + len(rate.c))])

    def call(self, name, x):
        if name == "√":
            return self.root(x)
        c = x.plain()
        demand(c, "a function of a series without a term")
        first = self.of.call(name, c[0])
        if name == "ln":
            return self.integral(first, x, x)
        if name in ("arcsin", "arccos"):
            slope = self.root(self.number(1) - x * x)
            return self.integral(first, x, slope if name == "arcsin" else -slope)
        # (eˣ)′ = x′ eˣ, sin′ = x′ cos, cos′ = −x′ sin.
        other = {"sin": "cos", "cos": "sin"}.get(name)
        y, z = [first], [self.of.call(other, c[0])] if other else None
        sign = {"sin": 1, "cos": -1}.get(name)
        for n in range(1, len(c)):
            rates = [c[k] * self.of.number(k) / self.of.number(n) for k in range(n + 1)]
            by = lambda other: x.sum((rates[k], other[n - k]) for k in range(1, n + 1))
            if other is None:
                y.append(by(y))
            else:
                up, down = by(z), by(y)
                y.append(up if sign > 0 else -up)
                z.append(-down if sign > 0 else down)
        return Series(self.of, 0, y)
