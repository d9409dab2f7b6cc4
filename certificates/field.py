"""Identities: rational functions of generators, with roots, angles, exponentials, powers and logarithms."""
import re
from functools import cache, reduce
from itertools import combinations_with_replacement
from operator import add, mul, sub, truediv

from flint import acb, arb, fmpq, fmpz_mpoly_ctx

from formula import Calculator, Expansion, Series, Value, Wrong, demand, dyadic, evaluate, index, keys

RULES = {"pi": "rule", "free": "rule name", "half-tangent": "rule of", "half-exponential": "rule of",
         "root": "rule of degree", "power": "rule of to", "logarithm": "rule of"}
WORTH = {"pi": lambda: arb.pi(), "half-tangent": lambda x: (x / 2).tan(), "half-exponential": lambda x: (x / 2).exp(),
         "power": pow, "logarithm": arb.log}

# Proofs that put in what does not follow from the rules, but holds where they say.
RELATIONS = {"B and C touch at Y": "there α = 3π/2 − x and x = cot α, the root of tan x = x"}


class Element(Value):
    """Polynomials above and below the line."""
    __slots__ = ("f", "above", "below")

    def __init__(self, f, above, below):
        self.f, self.above, self.below = f, above, below

    def __add__(self, y):
        return self.f.fraction(self.above * y.below + y.above * self.below, self.below * y.below)

    def __neg__(self):
        return Element(self.f, -self.above, self.below)

    def __mul__(self, y):
        return self.f.fraction(self.above * y.above, self.below * y.below)

    def __truediv__(self, y):
        demand(not self.f.is_zero(y) and self.f.differs(y), "division by zero")
        return self.f.fraction(self.above * y.below, self.below * y.above)

    def occurring(self):
        return {g for p in (self.above, self.below) for g, k in enumerate(p.degrees()) if k > 0}

    def at(self, values):
        """Its value where the generators have these."""
        over, under = (sum(reduce(mul, (x ** int(k) for x, k in zip(values, m) if k), arb(int(c))) for m, c in p.to_dict().items())
                       for p in (self.above, self.below))
        return over / under

    def number(self):
        """Its value, if it is a number."""
        return None if self.occurring() else fmpq(sum(self.above.coeffs()), sum(self.below.coeffs()))


class Field(Calculator):
    """The generators with their relations."""

    def __init__(self, generators, symbols, powers, inverses):
        self.n = len(generators)
        self.ctx = fmpz_mpoly_ctx.get([f"g{i}" for i in range(self.n)], "lex")
        self.one = self.ctx.constant(1)
        self.g = [Element(self, g, self.one) for g in self.ctx.gens()]
        # A root is a power; of roots, radicand and degree are known too.
        self.rules, self.roots, self.powers, self.inverses, self.symbols = [], {}, [], [], {"π": self.g[0]}
        self.half, self.values = self.number(fmpq(1, 2)), None
        for g, x in enumerate(generators):
            self.rules.append(self.rule(g, x))
        demand(self.rules and self.rules[0] == ("pi",), "without π")
        for u, rule in enumerate(self.rules):
            if rule[0] == "half-tangent":
                of, degree = self.roots.get(u + 1, (None, None))
                right = self.number(1) / (self.number(1) + self.g[u] * self.g[u])
                demand(degree == 2 and self.same(of, right), "no half cosine")
        for name, x in symbols:
            demand(name not in self.symbols, "a symbol twice")
            self.symbols[name] = self.element(x)
        own = len(self.powers)
        for known in powers:
            of, to, is_ = map(self.element, keys(known, "of to is"))
            n = to.number()
            demand(n is not None and n.p == 1 and self.same(self.repeated(is_, int(n.q)), of), "a power that is none")
            demand(not any(self.same(of, x) and self.same(to, y) for x, y, _ in self.powers), "a power twice")
            self.powers.append((of, to, is_))
        for known in inverses:
            function, *pair = keys(known, "function of is")
            of, is_ = map(self.element, pair)
            demand(function in ("arcsin", "arccos"), "no inverse function")
            demand(self.same(self.turn(is_)[function == "arcsin"], of), "an inverse that is none")
            self.inverses.append((function, of, is_))
        self.idle = {known[2] for known in self.powers[own:] + self.inverses}
        choices = combinations_with_replacement(range(self.n), 2)
        self.values = next(filter(None, (self.principal(self.powers[own:], minus) for minus in choices)), None)
        demand(self.values, "roots or angles that are on their principal branches nowhere together")

    def principal(self, roots, minus):
        """Values of the generators where all symbols are small and positive, but for two, which may be negative: if there what
        is known are positive roots of positive numbers, and angles on their principal branches."""
        values = []
        for g, (rule, *of) in enumerate(self.rules):
            if rule in ("power", "logarithm") and not (of[0].at(values) > 0 or self.is_imaginary(g)):
                return None
            values.append(arb(-1 if g in minus else 1) / (9 + g * g) if rule == "free" else self.worth(g, values))
        within = {"arcsin": lambda x: 2 * abs(x) <= arb.pi(), "arccos": lambda x: 0 <= x <= arb.pi()}
        angles = all(within[function](is_.at(values)) for function, _, is_ in self.inverses)
        return values if angles and all(is_.at(values) > 0 for _, _, is_ in roots) else None

    def worth(self, g, values):
        """What a generator is worth by its rule, where those before it have these values."""
        rule, *of = self.rules[g]
        of = [x.at(values) if isinstance(x, Element) else values[x] for x in of]
        return WORTH[rule](*(map(acb, of) if self.is_imaginary(g) else of))

    def is_imaginary(self, g):
        """Whether a generator is a root of a negative number: no formula has such a root."""
        n = self.roots[g][0].number() if g in self.roots else None
        return n is not None and n < 0

    def differs(self, x):
        """Whether an element differs from 0 somewhere on the principal branches, once these are known."""
        return self.values is None or not x.at(self.values).contains(0)

    def rule(self, g, x):
        """A generator's rule, of earlier ones."""
        demand(x["rule"] in RULES, f"no rule: {x['rule']}")
        match keys(x, RULES[x["rule"]]):
            case ["pi"]:
                demand(g == 0, "π is the generator 0")
                return ("pi",)
            case ["free", name]:
                demand(isinstance(name, str) and name not in self.symbols, "a name twice")
                self.symbols[name] = self.g[g]
                return ("free",)
            case ["half-tangent" | "half-exponential" as rule, of]:
                demand(self.rules[index(of, g)] == ("free",) and (rule, of) not in self.rules, "no half")
                return rule, of
            case ["root", of, degree]:
                of = self.element(of, g)
                demand(type(degree) is int and degree > 1 and not self.is_zero(of), "no root")
                self.roots[g] = of, degree
                of = [of, self.number(fmpq(1, degree))]
            case [_, *of]:
                of = [self.element(y, g) for y in of]
                demand(of[0].number() is None, "of a number")
        if len(of) == 1:
            return "logarithm", *of
        if not self.is_imaginary(g):
            self.powers.append((*of, self.g[g]))
        return "power", *of

    def polynomial(self, terms, below):
        known = {}
        for c, exponents in terms:
            fine = re.fullmatch(r"-?[1-9]\d*", c) and all(type(k) is int and 0 <= k < 10000 for k in exponents)
            m = tuple(exponents) + (0,) * (self.n - len(exponents))
            demand(fine and len(exponents) <= below and m not in known and exponents[-1:] != [0], "no term")
            known[m] = int(c)
        return self.ctx.from_dict(known)

    def element(self, x, below=None, worked_out=False):
        """An element as it is written: factors have a positive leading coefficient; worked out, powers of roots are
        below twice their degree."""
        above, number, factors = keys(x, "above number below")
        below = self.n if below is None else below
        demand(dyadic(number) > 0 and (above or (number, factors) == ("1", [])), "no element as it is written")
        over, under = self.polynomial(above, below), self.ctx.constant(int(number))
        for factor, k in factors:
            demand(type(k) is int and 0 < k < 10000 and not factor[-1][0].startswith("-"), "no power")
            under *= self.polynomial(factor, below) ** k
        small = all(over.degrees()[g] < 2 * degree for g, (_, degree) in self.roots.items())
        demand(small or not worked_out, "a power of a root")
        demand(under.is_constant() or self.differs(Element(self, under, self.one)), "division by zero")
        return self.fraction(over, under)

    def reduced(self, p):
        """A polynomial with powers of roots below their degree, and by what it was multiplied for that."""
        factor = self.one
        for g, (root, degree) in reversed(self.roots.items()):
            if p.degrees()[g] < degree:
                continue
            parts = {}
            for m, c in p.to_dict().items():
                parts.setdefault(m[g] // degree, {})[m[:g] + (m[g] % degree,) + m[g + 1:]] = c
            most = max(parts)
            p = sum(self.ctx.from_dict(parts[k]) * root.above**k * root.below ** (most - k) for k in parts)
            factor *= root.below**most
        return p, factor

    def fraction(self, a, b):
        (a, up), (b, down) = self.reduced(a), self.reduced(b)
        demand(b != 0, "division by zero")
        if a == 0:
            return Element(self, a, self.one)
        a, b = a * down, b * up
        common = a.gcd(b)
        common = common if b.leading_coefficient() > 0 else -common
        return Element(self, a // common, b // common)

    def is_zero(self, x):
        return self.reduced(x.above)[0] == 0

    def same(self, x, y):
        return self.is_zero(x - y)

    # What formulas need.

    def number(self, n):
        n = fmpq(n)
        return Element(self, self.ctx.constant(n.p), self.ctx.constant(n.q))

    def whole(self, x):
        n = x.number()
        return int(n.p) if n is not None and n.q == 1 else None

    def halves(self, x):
        """The multiples of 1/2 of generators of which it is the sum."""
        twice = x + x
        demand(twice.below == 1 and all(sum(m) == 1 for m in twice.above.monoms()), "no sum of half multiples")
        return {m.index(1): int(c) for m, c in twice.above.to_dict().items()}

    def find(self, *rule):
        demand(rule in self.rules, f"not declared: {rule[0]}")
        return self.rules.index(rule)

    def turn(self, x):
        """Cosine and sine."""
        c, s = self.number(1), self.number(0)
        for g, k in self.halves(x).items():
            c1, s1 = self.number(0), self.number(1)
            if g:
                u = self.find("half-tangent", g)
                c1, s1 = self.g[u + 1], self.g[u + 1] * self.g[u]
            demand(abs(k) < 100, "too many halves")
            s1 = s1 if k > 0 else -s1
            for _ in range(abs(k)):
                c, s = c * c1 - s * s1, s * c1 + c * s1
        return c, s

    def multiplicity(self, x, p):
        """How often the numerator of p divides x, and what p's power leaves of x."""
        prime, k = p.above.primitive()[1], 0
        if not prime.is_constant():
            for side, sign in ((x.above, 1), (x.below, -1)):
                while side != 0 and divmod(side, prime)[1] == 0:
                    side, k = side // prime, k + sign
        return k, x / self.repeated(p, k) if k else x

    def power(self, x, e):
        """x to the power e, by products of declared powers."""
        if self.same(x, self.number(1)):
            return x
        for to in [known[1] for known in self.powers]:
            for n in [k * s for k in range(1, 9) for s in (1, -1)]:
                m = self.whole(e - to * self.number(n))
                if m is not None and (product := self.product(x, to)) is not None:
                    return self.repeated(product, n) * self.repeated(x, m)
        raise Wrong("no declared power")

    def product(self, x, to):
        """x to the power `to`, if x is a product of what is declared with this power."""
        product, numbers = self.number(1), [(self.number(1), self.number(1))]
        for base, exponent, value in self.powers:
            if self.same(exponent, to):
                if base.number() is not None:
                    numbers.append((base, value))
                    continue
                k, x = self.multiplicity(x, base)
                if k:
                    self.idle.discard(value)
                    product = product * self.repeated(value, k)
        n = to.number()
        for base, value in numbers:
            rest = (x / base).number()
            if rest is None or rest != 1 and (n is None or n.p != 1 or rest < 0):
                continue
            degree = 1 if rest == 1 else int(n.q)
            root = fmpq(rest.p.root(degree), rest.q.root(degree))
            if root**degree == rest:
                self.idle.discard(value)
                return product * value * self.number(root)
        return None

    def call(self, name, x):
        if name in ("sin", "cos"):
            return self.turn(x)[name == "sin"]
        if name == "√":
            return self.power(x, self.half)
        if name == "exp":
            powers = [self.repeated(self.g[self.find("half-exponential", g)], k) for g, k in self.halves(x).items()]
            return reduce(mul, powers, self.number(1))
        if name == "ln":
            total = self.number(0)
            for g, (rule, *of) in enumerate(self.rules):
                if rule == "logarithm":
                    k, x = self.multiplicity(x, *of)
                    total += self.g[g] * self.number(k)
            demand(self.same(x, self.number(1)), "no declared logarithm")
            return total
        for function, of, angle in self.inverses:
            if function == name and self.same(of, x):
                self.idle.discard(angle)
                return angle
        demand(self.is_zero(x), f"not declared: {name}")
        return x if name == "arcsin" else self.g[0] * self.half

    # Derivatives, and values put in.

    def made_of(self, x):
        """The generators on which an element depends."""
        found, new = set(), x.occurring()
        while new:
            found |= new
            of = [part for g in new for part in self.rules[g][1:]]
            new = set().union(*({part} if type(part) is int else part.occurring() for part in of)) - found
        return found

    def derivative(self, x, rates):
        of = lambda p: Element(self, p, self.one)
        rate = lambda p, g: of(p.derivative(g)) * self.rate(g, rates)
        slope = lambda p: sum((rate(p, g) for g, k in enumerate(p.degrees()) if k), self.number(0))
        return (slope(x.above) - x * slope(x.below)) / of(x.below)

    def rate(self, g, rates):
        own = self.g[g]
        match self.rules[g]:
            case ["half-tangent", of]:
                return (self.number(1) + own * own) * self.rate(of, rates) * self.half
            case ["half-exponential", of]:
                return own * self.rate(of, rates) * self.half
            case ["logarithm", of]:
                return self.derivative(of, rates) / of
            case ["power", of, to]:
                growing, rate = self.derivative(to, rates), to * self.derivative(of, rates) / of
                return own * (rate if self.is_zero(growing) else rate + growing * self.call("ln", of))
        return rates.get(g, self.number(0))

    def value(self, x, values, of):
        """What an element is worth where the generators have these values."""
        powers = lambda m: [of.repeated(values[g], k) for g, k in enumerate(m) if k]
        side = lambda p: sum((reduce(mul, powers(m), of.number(c)) for m, c in p.to_dict().items()), of.number(0))
        return side(x.above) / side(x.below)

    def keeps(self, x, values):
        """Whether what occurs keeps to the rules of the generators where values are put in: if all that one is made of goes, it
        may be anything."""
        new, there = [], x.occurring() | values.keys()
        for g, (rule, *_) in enumerate(self.rules):
            own = self.values[g] if rule == "free" else self.worth(g, new)
            new.append(values[g].at(self.values) if g in values else own)
            if rule != "free" and g in there and (g not in values or self.made_of(self.g[g]) & there - {g}):
                if not (new[g] - (own if g in values else self.values[g])).contains(0):
                    return False
        return True

    def put(self, x, values):
        all_ = [values.get(g, own) for g, own in enumerate(self.g)]
        for g in self.roots.keys() & values.keys():
            radicand, degree = self.roots[g]
            demand(self.same(self.repeated(values[g], degree), self.value(radicand, all_, self)), "no value of a root")
        return self.value(x, all_, self)


def identity(w, before):
    _, title, given, generators, symbols, powers, inverses, parts, gives, equal, fails = keys(
        w, "kind title given generators symbols powers inverses parts gives equal fails")
    demand(equal and type(fails) is bool, "nothing is compared")
    demand(all(isinstance(other, str) and other in before for other in given), "it rests on a proof that is not there")
    f = Field(generators, symbols, powers, inverses)
    f.title = title
    demand(len(gives) == len(parts), "not as many results as parts")
    made, used = [], set()
    for part, result in zip(parts, gives):
        made.append(step(f, made, part, used))
        as_said = result is None or f.same(made[-1], f.element(result, worked_out=True))
        demand(as_said, f"{title}: a part is something else")
    for i, demanded in enumerate(equal):
        says, left, right = keys(demanded, "says left right")
        demand(left != right, "something is compared with itself")
        used |= {left, right} - {None}
        off = made[index(left, len(made))] - (f.number(0) if right is None else made[index(right, len(made))])
        if fails and i + 1 == len(equal):
            demand(not f.is_zero(off) and f.differs(off), f"{title}: {says}: equal, which it is not to be")
        else:
            demand(f.is_zero(off), f"{title}: {says}: not equal")
    demand(used == set(range(len(parts))), "an idle part")
    demand(not f.idle, "something known that is not needed")
    return title


def step(f, made, part, used):
    """One element, from those before it."""
    demand(isinstance(part, dict) and len(part) == 1, "a part is one thing")
    (name, of), = part.items()

    def get(i):
        used.add(index(i, len(made)))
        return made[i]

    binary = {"sum": add, "difference": sub, "product": mul, "quotient": truediv, "raised": f.raised}
    if name in binary:
        return binary[name](*map(get, of))
    match name, of:
        case "element", _:
            return f.element(of)
        case "read", _:
            return evaluate(of, f)
        case "negative", _:
            return -get(of)
        case ("derivative" | "put"), [i, pairs]:
            x, values = get(i), {index(g, f.n): get(j) for g, j in pairs}
            there = x.occurring() if name == "put" else f.made_of(x)
            demand(len(values) == len(pairs) and values.keys() <= there, "an idle value")
            free = all(f.rules[g] == ("free",) for g in values)
            demand(free or name == "put", "a rate of what is not free")
            demand(name != "put" or f.title in RELATIONS or f.keeps(x, values), "a value against a rule")
            return f.put(x, values) if name == "put" else f.derivative(x, values)
        case "series", [tree, known]:
            demand(all(type(start) is int for _, start, _ in known), "no lowest power")
            return expanded(f, tree, {n: Series(f, start, [get(i) for i in places]) for n, start, places in known})
        case "coefficient", [i, power]:
            demand(type(power) is int, "no power")
            return get(i)(power)
    raise Wrong(f"no part: {name}")


def expanded(f, tree, series):
    """The coefficients of a formula's power series, as far as they are asked for."""
    to = cache(lambda order: evaluate(tree, Expansion(f, series, order)))

    def coefficient(power):
        for order in range(max(power, 0), max(power, 0) + 20):
            try:
                return to(order).at(power)
            except Wrong as wrong:
                why = wrong
        raise why

    return coefficient
