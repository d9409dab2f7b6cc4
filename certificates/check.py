#!/usr/bin/env python3
"""Checks certificates with python-flint alone; nothing of it is shared with what wrote them.

    python3 check.py FOLDER [DATE]     all files of a folder; with a date, the result is recorded
    python3 check.py FOLDER --list     writes ties.csv anew

The format is described in the book, on the page "Certificates". Exit code 0 if every file is accepted.
"""
import hashlib
import json
import math
import os
import re
import sys
from functools import reduce

import latex
from flint import arb, arb_mat, arb_series, ctx as precision, fmpq, fmpz, fmpz_mpoly_ctx

precision.prec = 256


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
            elif rule == "none":
                self.rules.append(("none",))
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
                self.powers.append((radicand, self.div(self.int(1), self.int(degree)), self.g(g)))
            elif rule == "power":
                base, to = self.element(of["of"], g), self.element(of["to"], g)
                demand(self.number(base) is None, "a power of a number")
                self.rules.append(("power", base, to))
                self.powers.append((base, to, self.g(g)))
            elif rule == "logarithm":
                base = self.element(of["of"], g)
                demand(self.number(base) is None, "a logarithm of a number")
                self.rules.append(("logarithm", base))
            else:
                raise Wrong(f"no rule: {rule}")
        demand(self.rules and self.rules[0] == ("pi",), "without π")
        for u, rule in enumerate(self.rules):
            if rule[0] == "half-tangent":
                right = self.div(self.int(1), self.add(self.int(1), self.mul(self.g(u), self.g(u))))
                h = self.rules[u + 1] if u + 1 < self.n else ("none",)
                demand(h[0] == "root" and h[2] == 2 and self.same(h[1], right), "no half cosine")

    def polynomial(self, terms, below):
        known = {}
        for c, exponents in terms:
            demand(all(type(k) is int and 0 <= k < 10000 for k in exponents), "no exponents")
            demand(len(exponents) <= below and tuple(exponents) not in known and exponents[-1:] != [0], "no term")
            known[tuple(exponents)] = whole(c)
        return self.ctx.from_dict({m + (0,) * (self.n - len(m)): c for m, c in known.items()})

    def element(self, x, below=None):
        below = self.n if below is None else below
        above, number, factors = keys(x, "above", "number", "below")
        demand(whole(number) > 0 and (above or (number, factors) == ("1", [])), "no element as it is written")
        under = self.ctx.constant(whole(number))
        for factor, k in factors:
            demand(type(k) is int and 0 < k < 10000, "no power")
            under *= self.polynomial(factor, below) ** k
        x = self.fraction(self.polynomial(above, below), under)
        demand(all(self.rules[g] != ("none",) for g in self.occurring(x)), "a generator that is not declared")
        return x

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
        if self.occurring(x):
            return None
        value = lambda p: p.leading_coefficient() if p != 0 else fmpz(0)
        return fmpq(value(x[0]), value(x[1]))

    def occurring(self, x):
        return {g for p in x for g, k in enumerate(p.degrees()) if k > 0}

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
                c1, s1 = self.g(u + 1), self.mul(self.g(u + 1), self.g(u))
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
        prime = p[0].primitive()[1]
        if prime.is_constant():
            return 0, x
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
                top, bottom = (fmpz(y).root(int(n.q)) for y in (rest.p, rest.q))
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
            if k > 0:
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


def evaluate(tree, of):
    """A formula's value among numbers of any sort that `of` calculates with."""
    if isinstance(tree, str):
        if re.fullmatch(r"-?\d+", tree):
            return of.int(int(tree))
        if "*2^" in tree:
            return of.dyadic(dyadic(tree))
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


def identity(w, before):
    kind, title, given, generators, symbols, powers, inverses, parts, gives, equal = keys(
        w, "kind", "title", "given", "generators", "symbols", "powers", "inverses", "parts", "gives", "equal")
    demand(equal, "nothing is compared")
    demand(all(other in before for other in given), "it rests on a proof that is not there")
    f = Field(generators)
    for name, x in symbols:
        demand(name not in f.symbols and name not in f.names, "a symbol twice")
        f.symbols[name] = f.element(x)
    f.symbols.update({name: f.g(g) for name, g in f.names.items()})
    for known in powers:
        of, to, is_ = (f.element(x) for x in keys(known, "of", "to", "is"))
        n = f.number(to)
        demand(n is not None and n.p == 1 and f.same(f.power(is_, int(n.q)), of), "a power that is none")
        f.powers.append((of, to, is_))
    for known in inverses:
        function, of, is_ = keys(known, "function", "of", "is")
        of, is_ = f.element(of), f.element(is_)
        demand(function in ("arcsin", "arccos"), "no inverse function")
        demand(f.same(f.turn(is_)[function == "arcsin"], of), "an inverse that is none")
        f.inverses.append((function, of, is_))
    made = []
    demand(len(gives) == len(parts), "not as many results as parts")
    for part, result in zip(parts, gives):
        made.append(step(f, made, part))
        demand(result is None or f.same(made[-1], f.element(result)), f"{title}: a part is something else")
    for demanded in equal:
        says, left, right = keys(demanded, "says", "left", "right")
        x = made[index(left, len(made))]
        y = f.int(0) if right is None else made[index(right, len(made))]
        demand(f.same(x, y), f"{title}: {says}: not equal")
    return title


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
        demand(all(f.rules[g] in (("free",), ("none",)) for g in values), "a rate of what is not free")
        return f.derivative(get(x), values)
    if name == "series":
        tree, series, order = of
        known = {n: (start, [get(i) for i in places]) for n, start, places in series}
        return Series(f, known, order).expand(tree), Series(f, known, order)
    if name == "coefficient":
        (whole_series, of_series), k = get(of[0]), of[1]
        return of_series.at(whole_series, k)
    raise Wrong(f"no part: {name}")


# --- numbers: balls, and their Taylor series in one variable ---

def dyadic(text):
    """The number m·2^e, exactly."""
    found = re.fullmatch(r"(-?\d+)\*2\^(-?\d{1,5})", text) if isinstance(text, str) else None
    demand(found or text == "0", f"no dyadic number: {text!r}")
    return fmpq(int(found[1])) * fmpq(2) ** int(found[2]) if found else fmpq(0)


def interval(x):
    demand(isinstance(x, list) and len(x) == 2, "no interval")
    low, high = dyadic(x[0]), dyadic(x[1])
    demand(low <= high, "an interval without a number")
    return low, high


def box(x, n):
    demand(isinstance(x, list) and len(x) == n, f"not {n} intervals")
    return [interval(side) for side in x]


def ball(x):
    low, high = x
    return arb(low).union(arb(high))


class Jets:
    """Series in t about all points of a box at once, where one variable grows with t."""

    def __init__(self, names, values, along=None, terms=1):
        self.terms, self.values = terms, dict(zip(names, values))
        self.along = names[along] if along is not None else None

    def series(self, *coefficients):
        return coefficients[0] if self.terms == 1 else arb_series(list(coefficients), prec=self.terms)

    def int(self, n):
        return self.series(arb(n))

    def dyadic(self, x):
        return self.series(arb(x))

    def pi(self):
        return self.series(arb.pi())

    def symbol(self, name):
        demand(name in self.values, f"no variable {name}")
        return self.series(self.values[name], arb(1)) if name == self.along else self.series(self.values[name])

    def add(self, x, y):
        return x + y

    def sub(self, x, y):
        return x - y

    def mul(self, x, y):
        return x * y

    def neg(self, x):
        return -x

    def div(self, x, y):
        return x * float("nan") if self.first(y).contains(0) else x / y

    def first(self, x):
        return x if self.terms == 1 else x[0]

    def raised(self, x, y):
        if self.first(y).is_integer() and abs(self.first(y)) < 1000:
            n = int(self.first(y).unique_fmpz())
            return x ** n if n >= 0 else self.div(self.int(1), x ** -n)
        return (y * x.log()).exp()

    def call(self, name, x):
        demand(name in ("sin", "cos", "tan", "cot", "arcsin", "arccos", "sinh", "cosh", "exp", "ln", "√"), f"no function {name}")
        if name == "arccos":
            return self.pi() / 2 - x.asin()
        if name in ("sinh", "cosh"):
            up, down = x.exp(), (-x).exp()
            return (up - down) / 2 if name == "sinh" else (up + down) / 2
        if name == "cot":
            return x.cos() / x.sin()
        return getattr(x, {"arcsin": "asin", "ln": "log", "√": "sqrt"}.get(name, name))()


def coefficients(tree, names, values, along=None, terms=1):
    series = evaluate(tree, Jets(names, values, along, terms))
    return [series] if terms == 1 else [series[k] for k in range(terms)]


class Wide:
    """Intervals between floats, rounded outwards, with the slope by one variable, which may be unbounded at an end."""

    def __init__(self, names, cell, along):
        self.values = {n: (outwards(ball(side)), (float(i == along),) * 2) for i, (n, side) in enumerate(zip(names, cell))}

    def int(self, n):
        return outwards(arb(n)), (0.0, 0.0)

    def dyadic(self, x):
        return outwards(arb(x)), (0.0, 0.0)

    def pi(self):
        return outwards(arb.pi()), (0.0, 0.0)

    def symbol(self, name):
        demand(name in self.values, f"no variable {name}")
        return self.values[name]

    def add(self, x, y):
        return tuple((down(a[0] + b[0]), up(a[1] + b[1])) for a, b in zip(x, y))

    def neg(self, x):
        return tuple((-high, -low) for low, high in x)

    def sub(self, x, y):
        return self.add(x, self.neg(y))

    def mul(self, x, y):
        (a, da), (b, db) = x, y
        (low, high), (low2, high2) = times(a, db), times(da, b)
        return times(a, b), (down(low + low2), up(high + high2))

    def div(self, x, y):
        (low, high), _ = y
        inverse = (down(1 / high), up(1 / low)) if low > 0 or high < 0 else (-INFINITY, INFINITY)
        return self.mul(x, self.chain(y, inverse, times((-1.0, -1.0), times(inverse, inverse))))

    def chain(self, x, value, slope):
        return value, times(slope, x[1])

    def raised(self, x, y):
        demand(y[0][0] == y[0][1] == 2.0, "no power but squares")
        return self.mul(x, x)

    def call(self, name, x):
        low, high = x[0]
        at = lambda f, t: outwards(f(arb(t))) if abs(t) < INFINITY else (-INFINITY, INFINITY)
        if name in ("sin", "cos"):
            both = [at(f, low) if low == high else outwards(f(arb(low).union(arb(high)))) for f in (arb.sin, arb.cos)]
            s, c = both if max(abs(low), abs(high)) < INFINITY else [(-1.0, 1.0)] * 2
            return self.chain(x, s, c) if name == "sin" else self.chain(x, c, (-s[1], -s[0]))
        if name in ("tan", "cot"):
            s, c = self.call("sin", x), self.call("cos", x)
            return self.div(s, c) if name == "tan" else self.div(c, s)
        if name == "√":
            low, high = max(low, 0.0), max(high, 0.0)
            value = max(0.0, at(arb.sqrt, low)[0]), at(arb.sqrt, high)[1]
            return self.chain(x, value, (down(0.5 / value[1]) if value[1] else 0.0, up(0.5 / value[0]) if value[0] > 0 else INFINITY))
        demand(name in ("arcsin", "arccos"), f"no slope of {name}")
        low, high = max(low, -1.0), min(high, 1.0)
        far, near = max(low * low, high * high), 0.0 if low <= 0 <= high else min(low * low, high * high)
        steep = at(lambda t: (1 - t).rsqrt(), up(far))[1] if up(far) < 1 else INFINITY
        flat = at(lambda t: (1 - t).rsqrt(), max(0.0, down(near)))[0] if near < 1 else INFINITY
        value, slope = (at(arb.asin, low)[0], at(arb.asin, high)[1]), (flat, steep)
        if name == "arccos":
            value, slope = (at(arb.acos, high)[0], at(arb.acos, low)[1]), (-steep, -flat)
        return self.chain(x, value, slope)


INFINITY = float("inf")


def down(x):
    return math.nextafter(x, -INFINITY) if x == x else -INFINITY


def up(x):
    return math.nextafter(x, INFINITY) if x == x else INFINITY


def outwards(x):
    exact = x.is_exact() and arb(float(x.mid())) == x
    return (float(x.mid()),) * 2 if exact else (down(down(float(x.lower()))), up(up(float(x.upper()))))


def times(a, b):
    """A product of intervals; a slope is finite wherever it is multiplied by 0."""
    if (0.0, 0.0) in (a, b):
        return 0.0, 0.0
    all_ = [0.0 if 0.0 in (x, y) else x * y for x in a for y in b]
    return down(min(all_)), up(max(all_))


def variables(names):
    demand(isinstance(names, list) and all(isinstance(n, str) for n in names) and len(set(names)) == len(names), "no names")
    return names


def image(names, functions, c, cell):
    """Krawczyk's image of a box: m − C f(m) + (1 − C f′) (X − m)."""
    n = range(len(names))
    x = [ball(side) for side in cell]
    m = [arb((low + high) / 2) for low, high in cell]
    f = [coefficients(g, names, m)[0] for g in functions]
    slopes = [[coefficients(g, names, x, j, 2)[1] for j in n] for g in functions]
    product = [[sum((c[i][k] * slopes[k][j] for k in n), arb(0)) for j in n] for i in n]
    return [m[i] - sum((c[i][j] * f[j] for j in n), arb(0))
            + sum(((int(i == j) - product[i][j]) * (x[j] - m[j]) for j in n), arb(0)) for i in n]


def inside(x, side):
    return x > arb(side[0]) and x < arb(side[1])


def root(w, before):
    _, names, functions, within, c, found = keys(
        w, "kind", "variables", "functions", "within", "preconditioner", "root")
    n = len(variables(names))
    demand(n > 0 and len(functions) == n and len(c) == n and all(len(row) == n for row in c), "not as many functions as variables")
    within, found = box(within, n), box(found, n)
    c = [[arb(dyadic(x)) for x in row] for row in c]
    # The preconditioner has 20 bits after the point: those of the inverse in the middle.
    middle = [arb((low + high) / 2) for low, high in within]
    slopes = arb_mat([[coefficients(g, names, middle, j, 2)[1] for j in range(n)] for g in functions]).inv()
    for i in range(n):
        for j in range(n):
            demand((c[i][j] * 2 ** 20).is_integer() and abs(c[i][j] - slopes[i, j]) < arb(2) ** -20, "another preconditioner")
    for (low, high), (a, b) in zip(within, found):
        demand(low < a and b < high, "the root is not inside the box")
    # In the box there is exactly one root; and there is one in the smaller box.
    for cell in (within, found):
        demand(all(inside(k, side) for k, side in zip(image(names, functions, c, cell), cell)), "the image is not inside the box")
    return names, [ball(side) for side in found]


def number(w, before):
    _, place, stated, found, within = keys(w, "kind", "root", "stated", "found", "within")
    at = before[index(place, len(before))]
    demand(isinstance(at, tuple), "the number is not that of a root")
    stated, found = (coefficients(tree, *at)[0] for tree in (stated, found))
    demand(abs(stated - found) <= coefficients(within, *at)[0], "the numbers differ")


def holds(condition, names, cell, deeper=8):
    """Whether a condition is plain on a box, or on all parts of it."""
    if fulfilled(condition, names, cell):
        return True
    widest = max(range(len(cell)), key=lambda i: cell[i][1] - cell[i][0])
    low, high = cell[widest]
    if deeper == 0 or low == high:
        return False
    parts = [cell[:widest] + [side] + cell[widest + 1:] for side in ((low, (low + high) / 2), ((low + high) / 2, high))]
    return all(holds(condition, names, part, deeper - 1) for part in parts)


def fulfilled(condition, names, cell):
    kind, of = one(condition)
    if kind in ("all", "any"):
        demand(isinstance(of, list) and of, "no conditions")
        return (all if kind == "all" else any)(fulfilled(c, names, cell) for c in of)
    x, m = [ball(side) for side in cell], [arb((low + high) / 2) for low, high in cell]
    sign = of[-1]
    demand(sign in (1, -1), "no sign")
    by = index(of[1], len(names)) if kind == "slope" else 0
    if kind in ("slope", "sign"):
        low, high = evaluate(of[0], Wide(names, cell, by))[kind == "slope"]
        if low > 0 if sign > 0 else high < 0:
            return True
    if kind == "slope":
        value = coefficients(of[0], names, x, by, 2)[1]
    elif kind == "coefficient":
        demand(len(names) == 1 and type(of[1]) is int and 0 < of[1] < 10, "no coefficient")
        value = coefficients(of[0], names, x, 0, of[1] + 1)[of[1]]
    else:
        demand(kind == "sign" and len(of) == 2, f"no condition: {kind}")
        # By the slopes: f(m) + f′ (X − m).
        slopes = [coefficients(of[0], names, x, j, 2)[1] for j in range(len(names))]
        value = sum((s * (a - b) for s, a, b in zip(slopes, x, m)), coefficients(of[0], names, m)[0])
    return bool(value * sign > 0)


def covered(range_, parts):
    """Whether boxes leave no gap in a range."""
    if any(all(a <= low and high <= b for (low, high), (a, b) in zip(range_, part)) for part in parts):
        return True
    # Cut where a part ends.
    for i, (low, high) in enumerate(range_):
        cuts = sorted({end for part in parts for end in part[i] if low < end < high})
        if not cuts:
            continue
        cut = cuts[len(cuts) // 2]
        halves = [(low, cut), (cut, high)]
        for half in halves:
            side = range_[:i] + [half] + range_[i + 1:]
            touching = [p for p in parts if all(a < h and l < b or l == h and a <= l <= b for (l, h), (a, b) in zip(side, p))]
            if not covered(side, touching):
                return False
        return True
    return False


def range_(w, before):
    _, names, within, cases, parts = keys(w, "kind", "variables", "within", "cases", "parts")
    n = len(variables(names))
    within = box(within, n)
    parts = [box(part, n) for part in parts]
    demand(covered(within, parts), "the parts leave a gap")
    volume = lambda cell: reduce(lambda v, side: v * (side[1] - side[0]), cell, fmpq(1))
    demand(sum(map(volume, parts), fmpq(0)) == volume(within), "the parts overlap")
    cases = [(which(where, n), condition) for where, condition in cases]
    for part in parts:
        chosen = [condition for where, condition in cases if where(part)]
        demand(chosen, "a part without a condition")
        demand(holds(chosen[0], names, part), "a condition that is not fulfilled")


def which(where, n):
    if where == "rest":
        return lambda part: True
    kind, (i, at) = one(where)
    i, at = index(i, n), dyadic(at)
    demand(kind in ("from", "below"), "no choice of parts")
    return (lambda part: part[i][0] == at) if kind == "from" else (lambda part: part[i][1] < at)


# --- motions: intervals of whole numbers of units ---

UNIT = 200
ORDER = 17
ONE = 1 << UNIT
SHORT = ONE >> 20
P, W, Z = "p", "w", "ζ"
XI = ["-", "1", W]
LAW = [["-", ["*", P, W]], ["-", ["*", Z, Z]], ["-", ["-", ["*", W, Z], P], Z]]
# What decides, as the book proves it: p + ρ < 1 for rest; ρ² − p² > 1, w < 0, or ζ < −p and w < p for escape.
RHO2 = ["+", ["*", XI, XI], ["*", ["-", P, Z], ["-", P, Z]]]
ENOUGH = {
    "rest": [[[P, 1], [["-", "1", P], 1], [["-", ["*", ["-", "1", P], ["-", "1", P]], RHO2], 1]]],
    "escape": [[[P, 1], [["-", ["+", ["*", XI, XI], ["*", Z, ["-", ["-", Z, P], P]]], "1"], 1]],
               [[P, 1], [W, -1]], [[P, 1], [["+", Z, P], -1], [["-", P, W], 1]]],
}


def units(x):
    return tuple(int((side * ONE).floor() if up_ == 0 else (side * ONE).ceil()) for up_, side in enumerate(x))


def plus(a, b):
    return a[0] + b[0], a[1] + b[1]


def product(a, b):
    all_ = [x * y for x in a for y in b]
    return min(all_) >> UNIT, -(-max(all_) >> UNIT)


def within_(a, b):
    return b[0] <= a[0] and a[1] <= b[1]


def expansion(state, order):
    """Taylor coefficients of p, w, ζ and of their derivatives by the start, from the law p′ = −pw, w′ = −ζ², ζ′ = wζ − p − ζ."""
    c = [[x] for x in state]

    def sum_(i, j, k):
        low = high = 0
        for m in range(k + 1):
            a, b = product(c[i][m], c[j][k - m])
            low, high = low + a, high + b
        return low, high

    minus = lambda a: (-a[1], -a[0])
    for k in range(order):
        rates = [minus(sum_(0, 1, k)), minus(sum_(2, 2, k)), plus(sum_(1, 2, k), minus(plus(c[0][k], c[2][k])))]
        for i in range(3):
            p, w, z = 3 + i, 6 + i, 9 + i
            rates.append((i, minus(plus(sum_(p, 1, k), sum_(0, w, k))), minus(plus(sum_(2, z, k), sum_(2, z, k))),
                          plus(plus(sum_(w, 2, k), sum_(1, z, k)), minus(plus(c[p][k], c[z][k])))))
        own, by = rates[:3], rates[3:]
        rates = own + [column[1 + row] for row in range(3) for column in by]
        for i, (low, high) in enumerate(rates):
            c[i].append((low // (k + 1), -(-high // (k + 1))))
    return c


def extended(state):
    return state + [(ONE, ONE) if i == j else (0, 0) for i in range(3) for j in range(3)]


def motion(w, before):
    _, names, law, from_, start, steps, end, decides = keys(
        w, "kind", "variables", "law", "from", "start", "steps", "end", "decides")
    demand(names == [P, W, Z] and law == LAW, "another law of motion")
    demand(end in ENOUGH and decides in ENOUGH[end], "that decides nothing")
    cell = box(start, 3)
    for tree, side in zip(from_, cell):
        x = coefficients(tree, [], [])[0]
        demand(x >= arb(side[0]) and x <= arb(side[1]), "the start is elsewhere")
    demand(len(from_) == 3, "no start")
    state = [units(side) for side in cell]
    for step_ in steps:
        length, walls, then = keys(step_, "length", "walls", "state")
        h, walls, cell = dyadic(length), [units(side) for side in box(walls, 3)], box(then, 3)
        demand(h > 0, "a step backwards")
        h = units((h, h))
        begin = extended(state)
        reached = lambda walls: [plus(x, product((0, h[1]), rate[1])) for x, rate in zip(begin, expansion(walls, 1))]
        for x, (low, high) in zip(reached(extended(walls)), walls):
            # Short numbers, and no wider than they need be.
            demand(low % SHORT == high % SHORT == 0, "walls of too many digits")
            demand(low <= x[0] < low + 2 * SHORT and high - 2 * SHORT < x[1] <= high, "a motion leaves its walls, or they are far")
        own = begin[3:]
        for _ in range(50):
            next_ = reached(walls + own)[3:]
            if all(within_(a, b) for a, b in zip(next_, own)):
                break
            own = [(a - (b - a) // 5 - SHORT // 1000, b + (b - a) // 5 + SHORT // 1000) for a, b in next_]
        else:
            raise Wrong("derivatives without bounds")
        walls = walls + own
        rest = [c[ORDER] for c in expansion(walls, ORDER)]
        middle = [((a + b) // 2,) * 2 for a, b in state]
        sums = []
        for series in (expansion(begin, ORDER - 1), expansion(extended(middle), ORDER - 1)):
            total = rest
            for k in reversed(range(ORDER)):
                total = [plus(product(t, h), c[k]) for t, c in zip(total, series)]
            sums.append(total)
        all_, centre = sums
        for i, side in enumerate(cell):
            x = centre[i]
            for j in range(3):
                x = plus(x, product(all_[3 + 3 * i + j], (state[j][0] - middle[j][1], state[j][1] - middle[j][0])))
            x = max(x[0], all_[i][0]), min(x[1], all_[i][1])
            demand(within_(x, units(side)), "the motion ends elsewhere")
        state = [units(side) for side in cell]
    for tree, sign in decides:
        low, high = evaluate(tree, Wide(names, cell, 0))[0]
        demand(low > 0 if sign > 0 else high < 0, "what is to decide is not so")


# --- files ---

KINDS = {"identity": identity, "root": root, "number": number, "range": range_, "motion": motion}


def plain(text):
    """A formula without what does not belong to it: spaces, the last full stop, columns."""
    text = re.sub(r"^(\\text\{)?[A-E]:\}?", "", text).replace(r"\mbox", r"\text").replace("&", "")
    return re.sub(r"\s+", "", text).rstrip(".,;").replace(r"\quad", "").replace(r"\,", "")


class Prints:
    """The statements as they stand in the repository: the numbered equations, and the rows of the claims."""

    def __init__(self, root_):
        self.root = root_
        lines = open(os.path.join(root_, "tests/data/equations.md"), encoding="utf-8").read().splitlines()
        cells = [[cell.strip() for cell in line.split(" | ")] for line in lines if re.match(r"\| \d", line)]
        self.equations = {"eq-" + c[0].strip("| "): " | ".join(c[3:]).rstrip("| ").strip("`") for c in cells}
        rows = ""
        for folder, _, names in sorted(os.walk(os.path.join(root_, "src/claims"))):
            rows += "".join(open(os.path.join(folder, n), encoding="utf-8").read() for n in sorted(names) if n.endswith(".rs"))
        self.rows = re.sub(r"\\\n\s*", "", rows)
        with open(os.path.join(root_, "certificates/ties.csv"), encoding="utf-8") as file:
            self.ties = dict(line.rstrip("\n").split(",", 1) for line in file)

    def has(self, claim, statement, corrected):
        if claim in self.equations and not corrected:
            return plain(self.equations[claim]) == plain(statement)
        quoted = statement.replace("\\", "\\\\")
        return any(f'"{text}"' in self.rows for text in (statement, quoted))


def outline(witnesses):
    """What a certificate consists of, in short."""
    of = lambda w: f"{w['title']} ({len(w['equal'])})" if w["kind"] == "identity" else f"{w['kind']} of {' '.join(w.get('variables', []))}"
    return "; ".join(map(of, witnesses))


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
    trees = lambda c: [t for name, of in c.items() for t in ([x for y in of for x in trees(y)] if name in ("all", "any") else [of[0]])]
    return [t for _, c in w.get("cases", []) for t in trees(c)]


def value(tree, salt):
    """A formula's value where each name stands for a number that its letters give."""
    class Names(dict):
        def __missing__(self, key):
            digest = hashlib.sha256((salt + latex.name(key)).encode()).digest()
            return arb(int.from_bytes(digest[:6], "big")) / 2 ** 49 + arb(1) / 4

        def __contains__(self, key):
            return True
    jets = Jets([], [])
    jets.values = Names()
    try:
        x = evaluate(tree, jets)
    except (Wrong, ValueError):
        return None
    return x if x.is_finite() else None


def tied(statement, witnesses):
    """Whether a side of the printed formula is among the formulas that the witnesses speak of."""
    if "$" in statement:
        return "words"
    try:
        sides = [side for sides in latex.Reader(statement).sides() for side in sides if isinstance(side, list)]
    except (latex.Unread, RecursionError):
        sides = []
    if not sides:
        return "not read"
    inside_ = [tree for w in witnesses for formula in formulas(w) for tree in subtrees(formula) if isinstance(tree, list)]
    for side in sides:
        wanted = [value(side, salt) for salt in "ab"]
        if None in wanted:
            continue
        for tree in inside_:
            for sign in (1, -1):
                if all((x := value(tree, salt)) is not None and (sign * x).overlaps(y) for salt, y in zip("ab", wanted)):
                    return "formula"
    return "elsewhere"


def check(certificate, name, prints):
    """Raises `Wrong` unless the certificate is right."""
    version, claim, statement, sha256, about, trial, says, witnesses = keys(
        certificate, "format", "claim", "statement", "sha256", "about", "trial", "says", "witnesses")
    demand(version == 1, "another version of the format")
    demand(name == f"{claim}-{trial.replace('::', '-')}.json", "another file's name")
    demand(hashlib.sha256(statement.encode()).hexdigest() == sha256, "the hash is not that of the statement")
    demand(prints.has(claim, statement, "corrected" in about), "the statement is not printed so")
    demand(witnesses, "no witness")
    before = []
    for w in witnesses:
        demand(w.get("kind") in KINDS, f"no kind of witness: {w.get('kind')}")
        before.append(KINDS[w["kind"]](w, before))
    tie = f"{tied(statement, witnesses)},{sha256[:16]},{outline(witnesses)}"
    demand(name in prints.ties, "a file that is not listed")
    demand(prints.ties[name] == tie, f"not what is listed: {tie}")
    return tie.split(",")[0]


def record(path, date, accepted):
    """Writes who accepted what, and when."""
    import flint
    versions = f"Python {sys.version.split()[0]}, python-flint {flint.__version__}, FLINT {flint.__FLINT_VERSION__}"
    with open(path, "w", encoding="utf-8") as out:
        out.write(f"{date},{versions}\n" + "".join(f"{claim},{trial},{tie}\n" for claim, trial, tie in accepted))


def listed(folder, files):
    """The table of what each file has to be about: to be read before it is committed."""
    for name in files:
        with open(os.path.join(folder, name), encoding="utf-8") as file:
            c = json.load(file)
        yield f"{name},{tied(c['statement'], c['witnesses'])},{c['sha256'][:16]},{outline(c['witnesses'])}\n"


def main(folder, date=None):
    prints = Prints(os.path.join(os.path.dirname(os.path.abspath(__file__)), ".."))
    files = sorted(name for name in os.listdir(folder) if name.endswith(".json"))
    if date == "--list":
        with open(os.path.join(prints.root, "certificates/ties.csv"), "w", encoding="utf-8") as out:
            out.writelines(listed(folder, files))
        return 0
    accepted, rejected = [], []
    for name in files:
        try:
            with open(os.path.join(folder, name), encoding="utf-8") as file:
                certificate = json.load(file)
            accepted.append((certificate["claim"], certificate["trial"], check(certificate, name, prints)))
        except Exception as error:  # whatever a broken file brings about
            rejected.append(f"{name}: {type(error).__name__}: {error}")
    missing = sorted(set(prints.ties) - set(files))
    print("\n".join(rejected + [f"{name}: missing" for name in missing]))
    ties = [tie for _, _, tie in accepted]
    print(f"{len(accepted)} of {len(files)} files accepted; the printed formula is", {tie: ties.count(tie) for tie in sorted(set(ties))})
    if date and not rejected and not missing:
        record(os.path.join(prints.root, "snapshots/certificates.csv"), date, accepted)
    return 1 if rejected or missing or not files else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:3]))
