"""Formulas as nested lists, and what they are worth: elements of a field, intervals, or power series of either."""
import operator
import re
from functools import reduce

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


# A name cannot be taken for a formula, nor for a part or a generator in the text of what is said, nor for another name: its letters
# are Latin, Greek that are no Latin ones in print, ℓ and Fraktur; its marks can be seen.
SIGN = "[A-Za-z0-9_ΓΔΘΛΞΠΣΦΨΩα-ξπ-ωϖℓ\U0001d51e-\U0001d537\u0300-\u030c\u2032\u2080-\u208b\u22a5]"
NAME = re.compile(f"(?!\\d|[ag]\\d+$){SIGN}+(/d{SIGN}+)?")


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


def is_name(x):
    return isinstance(x, str) and NAME.fullmatch(x)


def index(x, below):
    demand(type(x) is int and 0 <= x < below, f"no place in the list: {x!r}")
    return x


def dyadic(text):
    """A number that is written as m or m·2^e, exactly."""
    found = re.fullmatch(r"(-?\d+)(?:\*2\^(-?\d{1,5}))?", text) if isinstance(text, str) else None
    demand(found, f"no number: {text!r}")
    return fmpq(int(found[1])) * fmpq(2) ** int(found[2] or 0)


class Value:
    """What is calculated with: it has + * / and a sign."""
    __slots__ = ()

    def __sub__(self, y):
        return self + -y


class Calculator:
    """What calculates has `number`, `symbols`, `call`, `power`, `is_zero` and `whole` besides."""
    kind = "symbol"

    def symbol(self, name):
        demand(name in self.symbols, f"no {self.kind} {name}")
        return self.symbols[name]

    def known(self, tree):
        """A formula's value, where this is another one than its parts say."""
        return None

    def raised(self, x, y):
        n = self.whole(y)
        return self.power(x, y) if n is None else self.repeated(x, n)

    def repeated(self, x, n):
        """The n-th power."""
        demand(abs(n) < 1000, "too high a power")
        power = reduce(operator.mul, [x] * abs(n), self.number(1))
        return power if n >= 0 else self.number(1) / power


def evaluate(tree, of, found=None):
    """A formula's value; what stands in it twice is worked out once."""
    if isinstance(tree, str):
        return of.number(dyadic(tree)) if re.match(r"-?\d", tree) else of.symbol(tree)
    found, text = {} if found is None else found, str(tree)
    if text not in found:
        found[text] = worked_out(tree, of, found)
    return found[text]


def worked_out(tree, of, found):
    demand(isinstance(tree, list) and len(tree) in (2, 3) and isinstance(tree[0], str), "no formula")
    if (known := of.known(tree)) is not None:
        return known
    name, *operands = tree
    if len(operands) == 1:
        if name in MEANT:
            return evaluate(MEANT[name](*operands), of, found)
        x = evaluate(*operands, of, found)
        demand(name == "-" or name in FUNCTIONS, f"no function: {name}")
        return -x if name == "-" else of.call(name, x)
    demand(name == "^" or not any(str(operand).startswith("-") for operand in operands), "a number with a sign inside")
    demand(name != "*" or "0" not in operands, "0 times something")
    x, y = (evaluate(operand, of, found) for operand in operands)
    demand(name == "^" or name in OPERATIONS, f"no operation: {name}")
    demand(name not in ("+", "-") or type(x) is type(y), "a sum of unlike things")
    return of.raised(x, y) if name == "^" else OPERATIONS[name](x, y)


class Series(Value):
    """x^start (c₀ + c₁ x + …), as far as the coefficients are known; `of` calculates with them."""

    def __init__(self, of, start, coefficients):
        self.of, self.start, self.c, self.end = of, start, coefficients, start + len(coefficients)

    def at(self, k):
        demand(k < self.end, "a coefficient that is not known")
        return self.c[k - self.start] if k >= self.start else self.of.number(0)

    def trimmed(self, why=None):
        """Without zeros at the beginning."""
        first = next((i for i, c in enumerate(self.c) if not self.of.is_zero(c)), len(self.c))
        demand(why is None or first < len(self.c), f"{why} a series without a term")
        return Series(self.of, self.start + first, self.c[first:])

    def plain(self):
        """The coefficients, if none is of a negative power."""
        demand(all(self.of.is_zero(self.at(k)) for k in range(self.start, 0)), "no series in whole powers")
        return [self.at(k) for k in range(self.end)]

    def sum(self, terms):
        return sum((a * b for a, b in terms), self.of.number(0))

    def __add__(self, y):
        start, end = min(self.start, y.start), min(self.end, y.end)
        return Series(self.of, start, [self.at(k) + y.at(k) for k in range(start, end)])

    def __neg__(self):
        return Series(self.of, self.start, [-c for c in self.c])

    def __mul__(self, y):
        x, y = self.trimmed(), y.trimmed()
        product = [self.sum(zip(x.c[:n], y.c[n - 1::-1])) for n in range(1, min(len(x.c), len(y.c)) + 1)]
        return Series(self.of, x.start + y.start, product)

    def __truediv__(self, y):
        y, q = y.trimmed("division by"), []
        for m in range(min(len(self.c), len(y.c))):
            q.append((self.c[m] - self.sum((q[k], y.c[m - k]) for k in range(m))) / y.c[0])
        return Series(self.of, self.start - y.start, q)


class Expansion(Calculator):
    """Calculates with power series, where some symbols are such."""

    def __init__(self, of, series, order):
        self.of, self.series, self.order = of, series, order

    def constant(self, x):
        return Series(self.of, 0, [x] + [self.of.number(0)] * self.order)

    def number(self, n):
        return self.constant(self.of.number(n))

    def symbol(self, name):
        return self.series[name] if name in self.series and name != "π" else self.constant(self.of.symbol(name))

    def known(self, tree):
        """The exponential of a multiple of a symbol of which only the exponential is given."""
        n, x = 1, tree[1] if tree[0] == "exp" else None
        match x:
            case ["-", of]:
                n, x = -1, of
        match x:
            case ["*", str(factor), of] if re.fullmatch(r"-?\d+", factor):
                n, x = n * int(factor), of
        known = self.series.get(f"exp {x}") if isinstance(x, str) else None
        return None if known is None else self.repeated(known, n)

    def whole(self, y):
        e, *others = y.plain()
        demand(all(self.of.is_zero(c) for c in others), "a varying exponent")
        return self.of.whole(e)

    def raised(self, x, y):
        """An exponent is known only so far, even where it is a whole number."""
        power = super().raised(x, y)
        return Series(self.of, power.start, power.c[:y.end])

    def power(self, x, y, first=None):
        """y = x^e obeys x y′ = e x′ y."""
        x, e, number, known = x.trimmed("a power of"), y.at(0), self.of.number, y.end
        start = self.of.whole(number(x.start) * e)
        demand(start is not None, "no whole powers")
        y = [first(x.c[0]) if first else self.of.raised(x.c[0], e)]
        for n in range(1, min(len(x.c), known)):
            weighted = [(e * number(k) - number(n - k)) * x.c[k] for k in range(n + 1)]
            y.append(x.sum(zip(weighted[1:], y[::-1])) / (x.c[0] * number(n)))
        return Series(self.of, start, y)

    def root(self, x):
        demand(x.trimmed().c and x.trimmed().start % 2 == 0, "no root in whole powers")
        return self.power(x, self.number(fmpq(1, 2)), lambda c: self.of.call("√", c))

    def call(self, name, x):
        if name == "√":
            return self.root(x)
        c, number = x.plain(), self.of.number
        demand(c, "a function of a series without a term")
        # (eˣ)′ = x′ eˣ, sin′ = x′ cos, cos′ = −x′ sin; each of these has its coefficients.
        names = {"sin": ("sin", "cos"), "cos": ("cos", "sin")}.get(name, (name,))
        y = [[self.of.call(f, c[0])] for f in names]
        rates = [number(k) * a for k, a in enumerate(c)]
        if name in ("ln", "arcsin", "arccos"):
            rate = Series(self.of, 0, rates) / (x if name == "ln" else self.root(self.number(1) - x * x))
            rate = -rate if name == "arccos" else rate
            return Series(self.of, 0, y[0] + [rate.at(k) / number(k) for k in range(1, rate.end)])
        for n in range(1, len(c)):
            growth = [x.sum(zip(rates[1:n + 1], of[::-1])) / number(n) for of in y]
            for f, of, g in zip(names, y, reversed(growth)):
                of.append(-g if f == "cos" else g)
        return Series(self.of, 0, y[0])
