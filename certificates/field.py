"""Identities: rational functions of generators, with roots, angles, exponentials, powers and logarithms."""
import re

from flint import fmpq, fmpz, fmpz_mpoly_ctx

from formula import Expansion, Series, Wrong, demand, dyadic, evaluate, index, keys
from intervals import Interval, Numbers, hashed


class Element:
    """Polynomials above and below the line."""
    __slots__ = ("f", "above", "below")

    def __init__(self, f, above, below):
        self.f, self.above, self.below = f, above, below

    def __add__(self, y):
        return self.f.fraction(self.above * y.below + y.above * self.below, self.below * y.below)

    def __neg__(self):
        return Element(self.f, -self.above, self.below)

    def __sub__(self, y):
        return self + -y

    def __mul__(self, y):
        return self.f.fraction(self.above * y.above, self.below * y.below)

    def __truediv__(self, y):
        demand(not self.f.is_zero(y), "division by zero")
        return self.f.fraction(self.above * y.below, self.below * y.above)

    def __pow__(self, n):
        demand(abs(n) < 1000, "too high a power")
        return self.f.fraction(self.above**n, self.below**n) if n >= 0 else self.f.number(1) / self**-n

    def occurring(self):
        return {g for p in (self.above, self.below) for g, k in enumerate(p.degrees()) if k > 0}

    def number(self):
        """Its value, if it is a number."""
        value = lambda p: p.leading_coefficient() if p != 0 else fmpz(0)
        return None if self.occurring() else fmpq(value(self.above), value(self.below))


class Field:
    """The generators with their relations."""

    def __init__(self, generators, symbols, powers, inverses):
        n = self.n = len(generators)
        self.ctx = fmpz_mpoly_ctx.get([f"g{i}" for i in range(n)], "lex")
        self.one = self.ctx.constant(1)
        self.g = [Element(self, g, self.one) for g in self.ctx.gens()]
        self.rules, self.roots, self.powers, self.inverses, self.symbols, self.met = [], [], [], [], {}, set()
        half = self.number(1) / self.number(2)
        for g, x in enumerate(generators):
            rule, *rest = [x[key] for key in sorted(x, key=["rule", "name", "of", "to", "degree"].index)]
            own = self.g[g]
            if rule == "pi":
                demand(g == 0, "π is the generator 0")
            elif rule == "free":
                demand(isinstance(rest[0], str) and rest[0] not in self.symbols, "a name twice")
                self.symbols[rest[0]] = own
            elif rule in ("half-tangent", "half-exponential"):
                demand(self.rules[index(rest[0], g)] == ("free",) and (rule, *rest) not in self.rules, "no half")
                self.rules.append((rule, *rest))
                continue
            else:
                demand(rule in ("root", "power", "logarithm"), f"no rule: {rule}")
                rest[0] = self.element(rest[0], g)
                if rule == "root":
                    degree = rest[1]
                    demand(type(degree) is int and degree > 1 and not self.is_zero(rest[0]), "no root")
                    self.roots.append((g, rest[0], degree))
                    self.powers.append((rest[0], self.number(fmpq(1, degree)), own))
                else:
                    demand(rest[0].number() is None, "of a number")
                    if rule == "power":
                        rest[1] = self.element(rest[1], g)
                        self.powers.append((*rest, own))
            self.rules.append((rule, *rest) if rule != "free" else ("free",))
        demand(self.rules and self.rules[0] == ("pi",), "without π")
        for u, rule in enumerate(self.rules):
            if rule[0] == "half-tangent":
                h = self.rules[u + 1] if u + 1 < n else ("none",)
                right = self.number(1) / (self.number(1) + self.g[u] ** 2)
                demand(h[0] == "root" and h[2] == 2 and self.same(h[1], right), "no half cosine")
        for name, x in symbols:
            demand(name not in self.symbols, "a symbol twice")
            self.symbols[name] = self.element(x)
        own = len(self.powers)
        for known in powers:
            of, to, is_ = map(self.element, keys(known, "of to is"))
            n = to.number()
            demand(n is not None and n.p == 1 and self.same(is_ ** int(n.q), of), "a power that is none")
            self.powers.append((of, to, is_))
        for known in inverses:
            function, *pair = keys(known, "function of is")
            of, is_ = map(self.element, pair)
            demand(function in ("arcsin", "arccos"), "no inverse function")
            demand(self.same(self.turn(is_)[function == "arcsin"], of), "an inverse that is none")
            self.inverses.append((function, of, is_))
        self.idle = {("power", i) for i in range(own, len(self.powers))} | {("inverse", i) for i in range(len(inverses))}
        self.half = half

    def polynomial(self, terms, below):
        known = {}
        for c, exponents in terms:
            demand(re.fullmatch(r"-?[1-9]\d*", c) and all(type(k) is int and 0 <= k < 10000 for k in exponents), "no term")
            demand(len(exponents) <= below and tuple(exponents) not in known and exponents[-1:] != [0], "no term")
            known[tuple(exponents)] = int(c)
        return self.ctx.from_dict({m + (0,) * (self.n - len(m)): c for m, c in known.items()})

    def element(self, x, below=None, worked_out=False):
        """An element as it is written: factors have a positive leading coefficient; worked out, powers of roots are below twice their degree."""
        above, number, factors = keys(x, "above number below")
        below = self.n if below is None else below
        demand(dyadic(number) > 0 and (above or (number, factors) == ("1", [])), "no element as it is written")
        over, under = self.polynomial(above, below), self.ctx.constant(int(number))
        for factor, k in factors:
            demand(type(k) is int and 0 < k < 10000 and not factor[-1][0].startswith("-"), "no power")
            under *= self.polynomial(factor, below) ** k
        demand(not worked_out or all(over.degrees()[g] < 2 * degree for g, _, degree in self.roots), "a power of a root")
        return self.fraction(over, under)

    def reduced(self, p):
        """A polynomial with powers of roots below their degree, and by what it was multiplied for that."""
        factor = self.one
        for g, root, degree in reversed(self.roots):
            if p.degrees()[g] < degree:
                continue
            parts = {}
            for m, c in p.to_dict().items():
                parts.setdefault(m[g], {})[m[:g] + (0,) + m[g + 1:]] = c
            most, p = max(parts) // degree, self.one * 0
            for k, part in parts.items():
                q = k // degree
                p += self.ctx.from_dict(part) * root.above**q * root.below ** (most - q) * self.g[g].above ** (k % degree)
            factor *= root.below**most
        return p, factor

    def fraction(self, a, b):
        (a, up), (b, down) = self.reduced(a), self.reduced(b)
        demand(b != 0, "division by zero")
        a, b = a * down, b * up
        for g, _, degree in self.roots:
            # No power of a root as a factor below the line.
            least = min(m[g] for m in b.to_dict())
            if least:
                fill = self.g[g].above ** (-least % degree)
                (a, up), (b, down) = self.reduced(a * fill), self.reduced(b * fill)
                a, b = a * down, b * up
        if a == 0:
            return Element(self, a, self.one)
        common = a.gcd(b)
        a, b = a // common, b // common
        if self.roots and any(self.reduced(x)[0] != x for x in (a, b)):
            return self.fraction(a, b)
        return Element(self, a, b) if b.leading_coefficient() > 0 else Element(self, -a, -b)

    def is_zero(self, x):
        return self.reduced(x.above)[0] == 0

    def same(self, x, y):
        return self.is_zero(x - y)

    # What formulas need.

    def number(self, n):
        n = fmpq(n)
        return Element(self, self.ctx.constant(n.p), self.ctx.constant(n.q))

    def pi(self):
        return self.g[0]

    def symbol(self, name):
        demand(name in self.symbols, f"no symbol {name}")
        return self.symbols[name]

    def whole(self, x):
        n = x.number()
        return int(n.p) if n is not None and n.q == 1 else None

    def known(self, tree):
        return None

    def halves(self, x):
        """The multiples of 1/2 of generators of which it is the sum."""
        twice = x * self.number(2)
        demand(twice.below == 1 and all(sum(m) == 1 for m in twice.above.to_dict()), "no sum of half multiples")
        return {m.index(1): int(c) for m, c in twice.above.to_dict().items()}

    def find(self, rule):
        demand(rule in self.rules, f"not declared: {rule[0]}")
        return self.rules.index(rule)

    def turn(self, x):
        """Cosine and sine."""
        c, s = self.number(1), self.number(0)
        for g, k in self.halves(x).items():
            c1, s1 = self.number(0), self.number(1)
            if g:
                u = self.find(("half-tangent", g))
                c1, s1 = self.g[u + 1], self.g[u + 1] * self.g[u]
            demand(abs(k) < 100, "too many halves")
            for _ in range(abs(k)):
                c, s = (c * c1 + s * s1, s * c1 - c * s1) if k < 0 else (c * c1 - s * s1, s * c1 + c * s1)
        return c, s

    def multiplicity(self, x, p):
        """How often the numerator of p divides x, and what p's power leaves of x."""
        prime = p.above.primitive()[1]
        k = 0
        if not prime.is_constant():
            for side, sign in ((x.above, 1), (x.below, -1)):
                while side != 0 and divmod(side, prime)[1] == 0:
                    side, k = side // prime, k + sign
        return k, x / p**k if k else x

    def raised(self, x, e):
        """x to the power e: of a whole e, or of products of declared powers."""
        n = self.whole(e)
        if n is not None:
            return x**n
        if self.same(x, self.number(1)):
            return x
        for to in [known[1] for known in self.powers]:
            for n in [k * s for k in range(1, 9) for s in (1, -1)]:
                m = self.whole(e - to * self.number(n))
                if m is not None and (product := self.product(x, to)) is not None:
                    return product**n * x**m
        raise Wrong("no declared power")

    def product(self, x, to):
        """x to the power `to`, if x is a product of what is declared with this power."""
        product, numbers = self.number(1), [(None, self.number(1), self.number(1))]
        for i, (base, exponent, value) in enumerate(self.powers):
            if self.same(exponent, to):
                if base.number() is not None:
                    numbers.append((i, base, value))
                    continue
                k, x = self.multiplicity(x, base)
                if k:
                    self.met.add(("power", i))
                    product = product * value**k
        n = to.number()
        for i, base, value in numbers:
            rest = (x / base).number()
            if rest is None or rest != 1 and (n is None or n.p != 1 or rest < 0):
                continue
            top, bottom = (rest.p, rest.q) if rest == 1 else (fmpz(y).root(int(n.q)) for y in (rest.p, rest.q))
            if rest == 1 or fmpq(top, bottom) ** int(n.q) == rest:
                self.met.add(("power", i))
                return product * value * self.number(fmpq(top, bottom))
        return None

    def call(self, name, x):
        if name in ("sin", "cos"):
            return self.turn(x)[name == "sin"]
        if name == "√":
            return self.raised(x, self.half)
        total = self.number(name == "exp")
        if name == "exp":
            for g, k in self.halves(x).items():
                total = total * self.g[self.find(("half-exponential", g))] ** k
            return total
        if name == "ln":
            for g, rule in enumerate(self.rules):
                if rule[0] == "logarithm":
                    k, x = self.multiplicity(x, rule[1])
                    total = total + self.g[g] * self.number(k)
            demand(self.same(x, self.number(1)), "no declared logarithm")
            return total
        for i, (function, of, angle) in enumerate(self.inverses):
            if function == name and self.same(of, x):
                self.met.add(("inverse", i))
                return angle
        demand(self.is_zero(x), f"not declared: {name}")
        return x if name == "arcsin" else self.pi() * self.half

    # Derivatives, and values put in.

    def made_of(self, x):
        """The generators on which an element depends."""
        found, new = set(), x.occurring()
        while new:
            found |= new
            of = [part for g in new for part in self.rules[g][1:]]
            new = {part for part in of if type(part) is int and part < self.n}.union(*(p.occurring() for p in of if isinstance(p, Element))) - found
        return found

    def derivative(self, x, rates):
        slope = lambda p: sum((Element(self, p.derivative(g), self.one) * self.rate(g, rates) for g, k in enumerate(p.degrees()) if k), self.number(0))
        return (slope(x.above) - x * slope(x.below)) / Element(self, x.below, self.one)

    def rate(self, g, rates):
        (rule, *of), own = self.rules[g], self.g[g]
        if rule in ("pi", "free"):
            return rates.get(g, self.number(0))
        if rule == "half-tangent":
            return (self.number(1) + own * own) * self.rate(of[0], rates) * self.half
        if rule == "half-exponential":
            return own * self.rate(of[0], rates) * self.half
        relative = self.derivative(of[0], rates) / of[0]
        if rule == "logarithm":
            return relative
        if rule == "root":
            return own * relative / self.number(of[1])
        growing = self.derivative(of[1], rates)
        more = self.number(0) if self.is_zero(growing) else growing * self.call("ln", of[0])
        return own * (of[1] * relative + more)

    def put(self, x, values):
        for g in set(values):
            if self.rules[g][0] == "root":
                _, radicand, degree = self.rules[g]
                demand(self.same(values[g] ** degree, self.put(radicand, values)), "no value of a root")

        def into(p):
            parts, total = {}, self.number(0)
            for m, c in p.to_dict().items():
                rest = tuple(0 if g in values else k for g, k in enumerate(m))
                parts.setdefault(tuple(m[g] for g in values), {})[rest] = c
            for powers, part in parts.items():
                term = Element(self, self.ctx.from_dict(part), self.one)
                for g, k in zip(values, powers):
                    term = term * values[g] ** k
                total = total + term
            return total

        return into(x.above) / into(x.below)

    def somewhere(self, x, salt):
        """An element's value where free generators have some values: an interval."""
        of, values = Numbers({}), []

        def value(x):
            sides = []
            for p in (x.above, x.below):
                total = of.number(0)
                for m, c in p.to_dict().items():
                    term = of.number(c)
                    for g, k in enumerate(m):
                        term = term * of.raised(values[g], of.number(k)) if k else term
                    total = total + term
                sides.append(total)
            return sides[0] / sides[1]

        for g, (rule, *rest) in enumerate(self.rules):
            if rule in ("pi", "free"):
                values.append(of.number(hashed(f"{salt}{g}")) if g else of.pi())
            elif rule == "half-tangent":
                angle = values[rest[0]] / of.number(2)
                values.append(of.call("sin", angle) / of.call("cos", angle))
            elif rule == "half-exponential":
                values.append(of.call("exp", values[rest[0]] / of.number(2)))
            elif rule == "logarithm":
                values.append(of.call("ln", value(rest[0])))
            else:
                to = of.number(fmpq(1, rest[1])) if rule == "root" else value(rest[1])
                values.append(of.raised(value(rest[0]), to))
        return value(x)


def identity(w, before):
    _, title, given, generators, symbols, powers, inverses, parts, gives, equal, fails = keys(
        w, "kind title given generators symbols powers inverses parts gives equal fails")
    demand(equal and type(fails) is bool, "nothing is compared")
    demand(all(other in before for other in given), "it rests on a proof that is not there")
    f = Field(generators, symbols, powers, inverses)
    demand(len(gives) == len(parts), "not as many results as parts")
    made, used = [], set()
    for part, result in zip(parts, gives):
        made.append(step(f, made, part, used))
        demand(result is None or f.same(made[-1], f.element(result, worked_out=True)), f"{title}: a part is something else")
    for i, demanded in enumerate(equal):
        says, left, right = keys(demanded, "says left right")
        demand(left != right, "something is compared with itself")
        used |= {left, right} - {None}
        off = made[index(left, len(made))] - (f.number(0) if right is None else made[index(right, len(made))])
        if fails and i + 1 == len(equal):
            demand(any(f.somewhere(off, salt).sign() for salt in "abcdefgh"), f"{title}: {says}: equal, which it is not to be")
        else:
            demand(f.is_zero(off), f"{title}: {says}: not equal")
    demand(used == set(range(len(parts))), "an idle part")
    demand(f.idle <= f.met, "something known that is not needed")
    return title


def step(f, made, part, used):
    """One element, from those before it."""
    demand(isinstance(part, dict) and len(part) == 1, "a part is one thing")
    (name, of), = part.items()

    def get(i):
        used.add(index(i, len(made)))
        return made[i]

    if name == "element":
        return f.element(of)
    if name == "read":
        return evaluate(of, f)
    if name == "negative":
        return -get(of)
    binary = {"sum": lambda x, y: x + y, "difference": lambda x, y: x - y, "product": lambda x, y: x * y,
              "quotient": lambda x, y: x / y, "raised": f.raised}
    if name in binary:
        return binary[name](*map(get, of))
    if name in ("derivative", "put"):
        x, values = get(of[0]), {index(g, f.n): get(i) for g, i in of[1]}
        demand(len(values) == len(of[1]) and values.keys() <= (x.occurring() if name == "put" else f.made_of(x)), "an idle value")
        if name == "put":
            return f.put(x, values)
        demand(all(f.rules[g] == ("free",) for g in values), "a rate of what is not free")
        return f.derivative(x, values)
    if name == "series":
        return Expanded(f, of[0], {n: Series(f, start, [get(i) for i in places]) for n, start, places in of[1]})
    demand(name == "coefficient", f"no part: {name}")
    return get(of[0]).coefficient(of[1])


class Expanded:
    """A formula's power series, as far as it is asked for."""

    def __init__(self, f, tree, series):
        self.f, self.tree, self.series, self.known = f, tree, series, {}

    def coefficient(self, power):
        for order in range(max(power, 0), max(power, 0) + 20):
            try:
                if order not in self.known:
                    self.known[order] = evaluate(self.tree, Expansion(self.f, self.series, order))
                return self.known[order].at(power)
            except Wrong as wrong:
                why = wrong
        raise why
