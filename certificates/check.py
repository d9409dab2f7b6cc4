#!/usr/bin/env python3
"""Checks certificates with python-flint alone; nothing of it is shared with what wrote them.

    python3 check.py FOLDER     all files of a folder

The format is described in the book, on the page "Certificates". Exit code 0 if every file is accepted.
"""
import hashlib
import json
import os
import re
import sys

from flint import arb, ctx as precision, fmpq, fmpz, fmpz_mpoly_ctx


class Wrong(Exception):
    """What is wrong with a certificate."""


def demand(holds, why):
    if not holds:
        raise Wrong(why)


def whole(x):
    demand(isinstance(x, str) and re.fullmatch(r"-?\d+", x), f"no whole number: {x!r}")
    return int(x)


def index(x, below):
    demand(type(x) is int and 0 <= x < below, f"no place in the list: {x!r}")
    return x


def keys(thing, *names):
    demand(isinstance(thing, dict) and set(thing) == set(names), f"not the keys {names}")
    return [thing[name] for name in names]


def one(thing):
    demand(isinstance(thing, dict) and len(thing) == 1, "a part is one thing")
    return next(iter(thing.items()))


# --- identities: rational functions of generators, with roots, angles, exponentials, powers and logarithms ---

class Field:
    """The generators with their relations. An element is a pair of polynomials, above and below the line."""

    def __init__(self, generators):
        self.n = len(generators)
        self.ctx = fmpz_mpoly_ctx.get([f"g{i}" for i in range(self.n)], "lex")
        self.gen = self.ctx.gens()
        self.zero, self.unit = self.ctx.from_dict({}), self.ctx.constant(1)
        self.roots, self.rules, self.names = [], [], {}
        self.powers, self.inverses, self.symbols = [], [], {}
        for g, (rule, of) in enumerate([(x.get("rule"), x) for x in generators]):
            if rule == "pi":
                demand(g == 0, "π is the generator 0")
                self.rules.append(("pi",))
            elif rule == "free":
                self.rules.append(("free",))
                demand(isinstance(of["name"], str) and of["name"] not in self.names, "a name twice")
                self.names[of["name"]] = g
            elif rule in ("half-tangent", "half-exponential"):
                angle = index(of["of"], g)
                demand(self.rules[angle] == ("free",), "of a free generator")
                demand((rule, angle) not in self.rules, "declared twice")
                self.rules.append((rule, angle))
            elif rule == "root":
                radicand, degree = self.element(of["of"], g), of["degree"]
                demand(type(degree) is int and degree > 1 and not self.is_zero(radicand), "no root")
                self.rules.append(("root", radicand, degree))
                self.roots.append((g, radicand, degree))
            elif rule == "power":
                base, to = self.element(of["of"], g), self.element(of["to"], g)
                demand(self.number(base) is None, "a power of a number")
                self.rules.append(("power", base, to))
            elif rule == "logarithm":
                base = self.element(of["of"], g)
                demand(self.number(base) is None, "a logarithm of a number")
                self.rules.append(("logarithm", base))
            else:
                raise Wrong(f"no rule: {rule}")
        demand(self.rules and self.rules[0] == ("pi",), "without π")

    def polynomial(self, terms, below):
        known = {}
        for c, exponents in terms:
            demand(all(type(k) is int and 0 <= k < 10000 for k in exponents), "no exponents")
            demand(len(exponents) <= below and tuple(exponents) not in known, "no term")
            known[tuple(exponents)] = whole(c)
        return self.ctx.from_dict({m + (0,) * (self.n - len(m)): c for m, c in known.items()})

    def element(self, x, below=None):
        below = self.n if below is None else below
        above, number, factors = keys(x, "above", "number", "below")
        under = self.ctx.constant(whole(number))
        for factor, k in factors:
            demand(type(k) is int and 0 < k < 10000, "no power")
            under *= self.polynomial(factor, below) ** k
        return self.fraction(self.polynomial(above, below), under)

    def reduced(self, p):
        """A polynomial with powers of roots below their degree, and by what it was multiplied for that."""
        factor = self.unit
        for g, (a, b), degree in reversed(self.roots):
            if p.degrees()[g] < degree:
                continue
            parts = {}
            for m, c in p.to_dict().items():
                k, rest = m[g], m[:g] + (0,) + m[g + 1:]
                parts.setdefault(k, {})[rest] = c
            most, p = max(parts) // degree, self.zero
            for k, part in parts.items():
                q = k // degree
                p += self.ctx.from_dict(part) * a ** q * b ** (most - q) * self.gen[g] ** (k % degree)
            factor *= b ** most
        return p, factor

    def fraction(self, a, b):
        a, up = self.reduced(a)
        b, down = self.reduced(b)
        demand(b != 0, "division by zero")
        a, b = a * down, b * up
        for g, _, degree in self.roots:
            # No power of a root as a factor below the line.
            least = min(m[g] for m in b.to_dict())
            if least:
                fill = self.gen[g] ** (-least % degree)
                (a, up), (b, down) = self.reduced(a * fill), self.reduced(b * fill)
                a, b = a * down, b * up
        if a == 0:
            return self.zero, self.unit
        common = a.gcd(b)
        a, b = a // common, b // common
        if self.roots and any(self.reduced(x)[0] != x for x in (a, b)):
            return self.fraction(a, b)
        return (-a, -b) if b.leading_coefficient() < 0 else (a, b)

    def add(self, x, y):
        return self.fraction(x[0] * y[1] + y[0] * x[1], x[1] * y[1])

    def neg(self, x):
        return -x[0], x[1]

    def sub(self, x, y):
        return self.add(x, self.neg(y))

    def mul(self, x, y):
        return self.fraction(x[0] * y[0], x[1] * y[1])

    def div(self, x, y):
        demand(not self.is_zero(y), "division by zero")
        return self.fraction(x[0] * y[1], x[1] * y[0])

    def power(self, x, n):
        demand(abs(n) < 1000, "too high a power")
        return self.fraction(x[0] ** n, x[1] ** n) if n >= 0 else self.div(self.int(1), self.power(x, -n))

    def int(self, n):
        return self.ctx.constant(n), self.unit

    def g(self, i):
        return self.gen[i], self.unit

    def is_zero(self, x):
        return self.reduced(x[0])[0] == 0

    def same(self, x, y):
        return self.is_zero(self.sub(x, y))

    def number(self, x):
        """Its value, if it is a number."""
        if any(x[0].degrees()) or any(x[1].degrees()):
            return None
        value = lambda p: p.leading_coefficient() if p != 0 else fmpz(0)
        return fmpq(value(x[0]), value(x[1]))

    def occurring(self, x):
        return {g for p in x for g, k in enumerate(p.degrees()) if k}

    # What functions are of elements.

    def halves(self, x):
        """The multiples of 1/2 of generators of which it is the sum."""
        a, b = self.mul(x, self.int(2))
        demand(b == 1 and all(sum(m) == 1 for m in a.to_dict()), "no sum of half multiples")
        return {m.index(1): int(c) for m, c in a.to_dict().items()}

    def turn(self, x):
        """Cosine and sine."""
        c, s = self.int(1), self.int(0)
        for g, k in self.halves(x).items():
            if g == 0:
                c1, s1 = self.int(0), self.int(1)
            else:
                u = self.find(("half-tangent", g))
                h = u + 1
                right = self.div(self.int(1), self.add(self.int(1), self.mul(self.g(u), self.g(u))))
                rule = self.rules[h] if h < self.n else None
                demand(rule and rule[0] == "root" and rule[2] == 2 and self.same(rule[1], right), "no half cosine")
                c1, s1 = self.g(h), self.mul(self.g(h), self.g(u))
            demand(abs(k) < 100, "too many halves")
            for _ in range(abs(k)):
                s2 = self.neg(s1) if k < 0 else s1
                c, s = (self.sub(self.mul(c, c1), self.mul(s, s2)), self.add(self.mul(c, s2), self.mul(s, c1)))
        return c, s

    def find(self, rule):
        demand(rule in self.rules, f"not declared: {rule[0]}")
        return self.rules.index(rule)

    def exp(self, x):
        product = self.int(1)
        for g, k in self.halves(x).items():
            product = self.mul(product, self.power(self.g(self.find(("half-exponential", g))), k))
        return product

    def multiplicity(self, x, p):
        """How often the numerator of p divides x, and what p's power leaves of x."""
        prime = p[0] // self.ctx.constant(p[0].content()) if hasattr(p[0], "content") else p[0].primitive()[1]
        k = 0
        for side, sign in ((x[0], 1), (x[1], -1)):
            while side != 0 and divmod(side, prime)[1] == 0:
                side, k = divmod(side, prime)[0], k + sign
        return k, self.div(x, self.power(p, k)) if k else x

    def ln(self, x):
        total = self.int(0)
        for g, rule in enumerate(self.rules):
            if rule[0] == "logarithm":
                k, x = self.multiplicity(x, rule[1])
                total = self.add(total, self.mul(self.g(g), self.int(k)))
        demand(self.same(x, self.int(1)), "no declared logarithm")
        return total

    def raised(self, x, e):
        """x to the power e: of a whole e, or of products of declared powers."""
        n = self.number(e)
        if n is not None and n.q == 1:
            return self.power(x, int(n))
        if self.same(x, self.int(1)):
            return x
        for to in [known[1] for known in self.powers]:
            for n in [k * s for k in range(1, 9) for s in (1, -1)]:
                m = self.number(self.sub(e, self.mul(to, self.int(n))))
                if m is None or m.q != 1:
                    continue
                product = self.product(x, to)
                if product is not None:
                    return self.mul(self.power(product, n), self.power(x, int(m)))
        raise Wrong("no declared power")

    def product(self, x, to):
        """x to the power `to`, if x is a product of what is declared with this power."""
        product, numbers = self.int(1), [(self.int(1), self.int(1))]
        for base, exponent, value in self.powers:
            if not self.same(exponent, to):
                continue
            if self.number(base) is not None:
                numbers.append((base, value))
                continue
            k, x = self.multiplicity(x, base)
            product = self.mul(product, self.power(value, k))
        n = self.number(to)
        for base, value in numbers:
            rest = self.number(self.div(x, base))
            if rest is None:
                continue
            if rest == 1:
                return self.mul(product, value)
            if n is not None and n.p == 1 and rest > 0:
                top, bottom = (fmpz(y).root(int(n.q)) if hasattr(fmpz, "root") else root(y, int(n.q)) for y in (rest.p, rest.q))
                if top ** int(n.q) == rest.p and bottom ** int(n.q) == rest.q:
                    return self.mul(self.mul(product, value), self.div(self.int(top), self.int(bottom)))
        return None

    def call(self, name, x):
        if name in ("sin", "cos", "tan", "cot"):
            c, s = self.turn(x)
            return {"sin": lambda: s, "cos": lambda: c, "tan": lambda: self.div(s, c), "cot": lambda: self.div(c, s)}[name]()
        if name in ("sinh", "cosh", "tanh", "coth"):
            up, down = self.exp(x), self.exp(self.neg(x))
            c, s = (self.div(f(up, down), self.int(2)) for f in (self.add, self.sub))
            return {"sinh": lambda: s, "cosh": lambda: c, "tanh": lambda: self.div(s, c), "coth": lambda: self.div(c, s)}[name]()
        if name == "exp":
            return self.exp(x)
        if name == "ln":
            return self.ln(x)
        if name == "√":
            return self.raised(x, self.div(self.int(1), self.int(2)))
        for function, of, angle in self.inverses:
            if function == name and self.same(of, x):
                return angle
        raise Wrong(f"not declared: {name}")

    def read(self, tree):
        return evaluate(tree, self)

    def pi(self):
        return self.g(0)

    def symbol(self, name):
        demand(name in self.symbols, f"no symbol {name}")
        return self.symbols[name]

    # Derivatives and values put in.

    def derivative(self, x, rates):
        a, b = x
        da, db = self.slope(a, rates), self.slope(b, rates)
        bottom = (b, self.unit)
        return self.div(self.sub(da, self.mul(x, db)), bottom)

    def slope(self, p, rates):
        total = self.int(0)
        for g, k in enumerate(p.degrees()):
            if k:
                rate = self.rate(g, rates)
                total = self.add(total, self.mul((p.derivative(g), self.unit), rate))
        return total

    def rate(self, g, rates):
        rule, own = self.rules[g], self.g(g)
        if rule[0] == "pi":
            return self.int(0)
        if rule[0] == "free":
            return rates.get(g, self.int(0))
        if rule[0] == "half-tangent":
            return self.div(self.mul(self.add(self.int(1), self.mul(own, own)), self.rate(rule[1], rates)), self.int(2))
        if rule[0] == "half-exponential":
            return self.div(self.mul(own, self.rate(rule[1], rates)), self.int(2))
        relative = self.div(self.derivative(rule[1], rates), rule[1])
        if rule[0] == "logarithm":
            return relative
        if rule[0] == "root":
            return self.mul(own, self.div(relative, self.int(rule[2])))
        slope, growing = self.mul(rule[2], relative), self.derivative(rule[2], rates)
        if not self.is_zero(growing):
            slope = self.add(slope, self.mul(growing, self.ln(rule[1])))
        return self.mul(own, slope)

    def put(self, x, values):
        for g in self.occurring(x) - set(values):
            demand(not self.depends(g, set(values)), "a value that what hangs on it does not follow")
        for g in self.occurring(x) & set(values):
            if self.rules[g][0] == "root":
                _, radicand, degree = self.rules[g]
                demand(self.same(self.power(values[g], degree), self.put(radicand, values)), "no value of a root")
        sides = []
        for p in x:
            parts = {}
            for m, c in p.to_dict().items():
                key = tuple(m[g] for g in values)
                rest = tuple(0 if g in values else k for g, k in enumerate(m))
                parts.setdefault(key, {})[rest] = c
            total = self.int(0)
            for key, part in parts.items():
                term = (self.ctx.from_dict(part), self.unit)
                for g, k in zip(values, key):
                    term = self.mul(term, self.power(values[g], k))
                total = self.add(total, term)
            sides.append(total)
        return self.div(*sides)

    def depends(self, g, on):
        """Whether what a generator stands for contains one of these."""
        below = {x for of in self.rules[g][1:] for x in (self.occurring(of) if type(of) is tuple else ())}
        if self.rules[g][0].startswith("half"):
            below = {self.rules[g][1]}
        return bool(below & on) or any(self.depends(x, on) for x in below)


def root(n, degree):
    """The whole root of a whole number, rounded down."""
    low, high = 0, int(n) + 1
    while low + 1 < high:
        middle = (low + high) // 2
        low, high = (middle, high) if middle ** degree <= n else (low, middle)
    return low


def evaluate(tree, of):
    """A formula's value among numbers of any sort that `of` calculates with."""
    if isinstance(tree, str):
        if re.fullmatch(r"-?\d+", tree):
            return of.int(int(tree))
        return of.pi() if tree == "π" else of.symbol(tree)
    demand(isinstance(tree, list) and len(tree) in (2, 3) and isinstance(tree[0], str), "no formula")
    name, *operands = tree
    x, *more = [evaluate(operand, of) for operand in operands]
    if not more:
        return of.neg(x) if name == "-" else of.call(name, x)
    names = {"+": of.add, "-": of.sub, "*": of.mul, "/": of.div, "^": of.raised}
    demand(name in names, f"no operation: {name}")
    return names[name](x, more[0])


class Series:
    """Power series with coefficients in a field: (lowest power, coefficients)."""

    def __init__(self, field, symbols, order):
        self.f, self.symbols, self.order = field, symbols, order

    def constant(self, x):
        return 0, [x] + [self.f.int(0)] * self.order

    def int(self, n):
        return self.constant(self.f.int(n))

    def pi(self):
        return self.constant(self.f.pi())

    def symbol(self, name):
        return self.symbols[name] if name in self.symbols else self.constant(self.f.symbol(name))

    def at(self, x, k):
        start, c = x
        demand(k < start + len(c), "a coefficient that is not known")
        return c[k - start] if k >= start else self.f.int(0)

    def trimmed(self, x):
        start, c = x
        while c and self.f.is_zero(c[0]):
            start, c = start + 1, c[1:]
        return start, c

    def add(self, x, y):
        start, end = min(x[0], y[0]), min(x[0] + len(x[1]), y[0] + len(y[1]))
        return start, [self.f.add(self.at(x, k), self.at(y, k)) for k in range(start, end)]

    def neg(self, x):
        return x[0], [self.f.neg(c) for c in x[1]]

    def sub(self, x, y):
        return self.add(x, self.neg(y))

    def sum(self, terms):
        total = self.f.int(0)
        for a, b in terms:
            total = self.f.add(total, self.f.mul(a, b))
        return total

    def mul(self, x, y):
        (i, a), (j, b) = self.trimmed(x), self.trimmed(y)
        n = min(len(a), len(b))
        return i + j, [self.sum((a[k], b[m - k]) for k in range(m + 1)) for m in range(n)]

    def div(self, x, y):
        j, b = self.trimmed(y)
        demand(b, "division by a series without a term")
        q = []
        for m in range(min(len(x[1]), len(b))):
            rest = self.f.sub(x[1][m], self.sum((q[k], b[m - k]) for k in range(m)))
            q.append(self.f.div(rest, b[0]))
        return x[0] - j, q

    def raised(self, x, y):
        e = self.at(y, 0)
        demand(y[0] >= 0 or all(self.f.is_zero(self.at(y, k)) for k in range(y[0], 0)), "a varying exponent")
        demand(all(self.f.is_zero(self.at(y, k)) for k in range(1, y[0] + len(y[1]))), "a varying exponent")
        return self.power(x, e)

    def power(self, x, e):
        start, c = self.trimmed(x)
        demand(c, "a power of a series without a term")
        shift = self.f.number(self.f.mul(self.f.int(start), e)) if start else fmpq(0)
        demand(shift is not None and shift.q == 1, "no whole powers")
        y = [self.f.raised(c[0], e)]
        for n in range(1, len(c)):
            weights = (self.f.sub(self.f.mul(e, self.f.int(k)), self.f.int(n - k)) for k in range(1, n + 1))
            total = self.sum((self.f.mul(w, c[k]), y[n - k]) for k, w in enumerate(weights, 1))
            y.append(self.f.div(total, self.f.mul(c[0], self.f.int(n))))
        return int(shift.p), y

    def split(self, x):
        demand(all(self.f.is_zero(self.at(x, k)) for k in range(x[0], 0)), "no series in whole powers")
        return [self.at(x, k) for k in range(x[0] + len(x[1]))]

    def pair(self, x, sign):
        x = self.split(x)
        if sign < 0:
            c, s = self.f.turn(x[0])
        else:
            c, s = self.f.call("cosh", x[0]), self.f.call("sinh", x[0])
        c, s = [c], [s]
        for n in range(1, len(x)):
            kx = [self.f.mul(x[k], self.f.int(k)) for k in range(n + 1)]
            to_s = self.sum((kx[k], c[n - k]) for k in range(1, n + 1))
            to_c = self.sum((kx[k], s[n - k]) for k in range(1, n + 1))
            s.append(self.f.div(to_s, self.f.int(n)))
            c.append(self.f.div(to_c, self.f.int(sign * n)))
        return (0, c), (0, s)

    def integral(self, start, x, y):
        """start + ∫ dx/y"""
        rate = self.div((0, [self.f.mul(c, self.f.int(k)) for k, c in enumerate(self.split(x))]), y)
        return 0, [start] + [self.f.div(self.at(rate, k), self.f.int(k)) for k in range(1, rate[0] + len(rate[1]))]

    def call(self, name, x):
        half = self.f.div(self.f.int(1), self.f.int(2))
        if name == "√":
            return self.power(x, half)
        if name == "ln":
            return self.integral(self.f.ln(self.split(x)[0]), x, x)
        if name in ("arcsin", "arccos"):
            first = self.split(x)[0]
            if self.f.is_zero(first):
                start = self.f.int(0) if name == "arcsin" else self.f.mul(self.f.pi(), half)
            else:
                start = self.f.call(name, first)
            slope = self.power(self.sub(self.int(1), self.mul(x, x)), half)
            return self.integral(start, x, slope if name == "arcsin" else self.neg(slope))
        c, s = self.pair(x, -1 if name in ("sin", "cos", "tan", "cot") else 1)
        return {"s": lambda: s, "c": lambda: c, "t": lambda: self.div(s, c), "o": lambda: self.div(c, s),
                "e": lambda: self.add(c, s)}["o" if name in ("cot", "coth") else name[0]]()

    def expand(self, tree):
        """As `evaluate`, but where only the exponential of a symbol is given, under the name `exp …`."""
        if isinstance(tree, list) and len(tree) == 2 and tree[0] in ("sinh", "cosh", "tanh", "coth", "exp"):
            n, name = (1, tree[1]) if isinstance(tree[1], str) else (tree[1][1], tree[1][2]) if tree[1][0] == "*" else (1, "")
            known = self.symbols.get(f"exp {name}") if isinstance(name, str) else None
            if known:
                n = int(n)
                up, down = (self.power(known, self.f.int(k)) for k in (n, -n))
                two = self.int(2)
                c, s = self.div(self.add(up, down), two), self.div(self.sub(up, down), two)
                return {"sinh": lambda: s, "cosh": lambda: c, "tanh": lambda: self.div(s, c),
                        "coth": lambda: self.div(c, s), "exp": lambda: up}[tree[0]]()
        if isinstance(tree, str):
            return evaluate(tree, self)
        name, *operands = tree
        values = [self.expand(operand) for operand in operands]
        if len(values) == 1:
            return self.neg(values[0]) if name == "-" else self.call(name, values[0])
        return {"+": self.add, "-": self.sub, "*": self.mul, "/": self.div, "^": self.raised}[name](*values)


def identity(w, titles):
    kind, title, given, generators, symbols, powers, inverses, parts, equal = keys(
        w, "kind", "title", "given", "generators", "symbols", "powers", "inverses", "parts", "equal")
    demand(equal, "nothing is compared")
    demand(all(other in titles for other in given), "it rests on a proof that is not there")
    f = Field(generators)
    for name, x in symbols:
        demand(name not in f.symbols, "a symbol twice")
        f.symbols[name] = f.element(x)
    for name, g in f.names.items():
        demand(name in f.symbols and f.same(f.symbols[name], f.g(g)), f"the symbol {name} is not itself")
    for known in powers:
        of, to, is_ = (f.element(x) for x in keys(known, "of", "to", "is"))
        n = f.number(to)
        if n is not None and n.p == 1:
            demand(f.same(f.power(is_, int(n.q)), of), "a power that is none")
        else:
            own = [g for g in range(f.n) if f.rules[g][0] == "power" and f.same(is_, f.g(g))]
            demand(own and f.same(f.rules[own[0]][1], of) and f.same(f.rules[own[0]][2], to), "a power that is none")
        f.powers.append((of, to, is_))
    for known in inverses:
        function, of, is_ = keys(known, "function", "of", "is")
        of, is_ = f.element(of), f.element(is_)
        demand(function in ("arcsin", "arccos"), "no inverse function")
        demand(f.same(f.turn(is_)[function == "arcsin"], of), "an inverse that is none")
        f.inverses.append((function, of, is_))
    made = []
    for part in parts:
        made.append(step(f, made, part))
    for demanded in equal:
        says, left, right = keys(demanded, "says", "left", "right")
        x = made[index(left, len(made))]
        y = f.int(0) if right is None else made[index(right, len(made))]
        demand(f.same(x, y), f"{title}: {says}: not equal")


def step(f, made, part):
    """One element, from those before it."""
    name, of = one(part)
    get = lambda i: made[index(i, len(made))]
    if name == "element":
        return f.element(of)
    if name == "read":
        return f.read(of)
    if name == "negative":
        return f.neg(get(of))
    binary = {"sum": f.add, "difference": f.sub, "product": f.mul, "quotient": f.div, "raised": f.raised}
    if name in binary:
        return binary[name](get(of[0]), get(of[1]))
    if name in ("derivative", "put"):
        x, values = of
        values = {index(g, f.n): get(i) for g, i in values}
        if name == "put":
            return f.put(get(x), values)
        demand(all(f.rules[g] == ("free",) for g in values), "a rate of what is not free")
        return f.derivative(get(x), values)
    if name == "series":
        tree, series, order = of
        known = {n: (start, [get(i) for i in places]) for n, start, places in series}
        return Series(f, known, order).expand(tree), Series(f, known, order)
    if name == "coefficient":
        (whole_series, of_series), k = get(of[0]), of[1]
        return of_series.at(whole_series, k)
    raise Wrong(f"no part: {name}")


# --- files ---

KINDS = {"identity": identity}


def check(path):
    """Raises `Wrong` unless the certificate in the file is right."""
    with open(path, encoding="utf-8") as file:
        certificate = json.load(file)
    version, claim, statement, sha256, about, trial, says, witnesses = keys(
        certificate, "format", "claim", "statement", "sha256", "about", "trial", "says", "witnesses")
    demand(version == 1, "another version of the format")
    demand(hashlib.sha256(statement.encode()).hexdigest() == sha256, "the hash is not that of the statement")
    demand(witnesses, "no witness")
    titles = set()
    for w in witnesses:
        demand(w.get("kind") in KINDS, f"no kind of witness: {w.get('kind')}")
        KINDS[w["kind"]](w, titles)
        titles.add(w.get("title"))


def main(folder):
    files = sorted(name for name in os.listdir(folder) if name.endswith(".json"))
    accepted, rejected = 0, []
    for name in files:
        try:
            check(os.path.join(folder, name))
            accepted += 1
        except Exception as error:  # whatever a broken file brings about
            rejected.append(f"{name}: {type(error).__name__}: {error}")
    print("\n".join(rejected))
    print(f"{accepted} of {len(files)} files accepted")
    return 1 if rejected or not files else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1]))
