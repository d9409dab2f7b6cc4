"""Identities: rational functions of generators, with roots, angles, exponentials, powers and logarithms."""
import json
import random
import re
from functools import cache, reduce
from itertools import product
from operator import add, mul, sub, truediv

from flint import acb, arb, fmpq, fmpz_mpoly_ctx

from formula import Calculator, Expansion, Series, Value, Wrong, demand, dyadic, evaluate, index, is_name, keys
from latex import Reader, name
from transcript import plain

RULES = {"pi": "rule", "free": "rule name", "half-tangent": "rule of", "half-exponential": "rule of",
         "root": "rule of degree", "power": "rule of to", "logarithm": "rule of"}
WORTH = {"pi": lambda: arb.pi(), "half-tangent": lambda x: (x / 2).tan(), "half-exponential": lambda x: (x / 2).exp(),
         "power": pow, "logarithm": arb.log}
# At so many places what is said of signs and branches has to hold, of so many that are looked at.
PLACES, TRIES = 3, 3000
# What has to hold everywhere is looked at for the signs of so many of the free generators in it, each in so many tries.
SIGNS, EACH = 7, 24


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

    def __init__(self, generators, symbols, powers, inverses, conditions=()):
        self.n = len(generators)
        self.ctx = fmpz_mpoly_ctx.get([f"g{i}" for i in range(self.n)], "lex")
        self.one = self.ctx.constant(1)
        self.g = [Element(self, g, self.one) for g in self.ctx.gens()]
        # A root is a power; of roots, radicand and degree are known too.
        self.rules, self.roots, self.powers, self.inverses, self.symbols = [], {}, [], [], {"π": self.g[0]}
        self.half, self.places, self.divisors = self.number(fmpq(1, 2)), None, []
        for g, x in enumerate(generators):
            self.rules.append(self.rule(g, x))
        demand(self.rules and self.rules[0] == ("pi",), "without π")
        for u, rule in enumerate(self.rules):
            if rule[0] == "half-tangent":
                of, degree = self.roots.get(u + 1, (None, None))
                right = self.number(1) / (self.number(1) + self.g[u] * self.g[u])
                demand(degree == 2 and self.same(of, right), "no half cosine")
        for name, x in symbols:
            demand(is_name(name) and name not in self.symbols, "a symbol twice, or no name")
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
        self.branches = [("power", is_) for _, _, is_ in self.powers[own:]] + [(f, is_) for f, _, is_ in self.inverses]
        self.positive = self.conditions(conditions)
        self.declared = self.powers[own:]
        # Nothing that may be written otherwise decides where we look.
        draw, tried = random.Random(self.n), range(TRIES)
        of = ((draw.choices(range(self.n), k=2 * i // TRIES + i % 3), 4 * i // TRIES - 1) for i in tried)
        places = filter(None, (self.principal(draw, *signs_and_size) for signs_and_size in of))
        self.places = [place for place, _ in zip(places, range(PLACES))]
        demand(len(self.places) == PLACES, "roots or angles that are on their principal branches nowhere together")
        # What was divided by before there were places.
        demand(all(map(self.differs, self.divisors)), "division by zero")

    def conditions(self, texts):
        """What is positive by the claim's conditions, as far as these are inequalities between what occurs here; and whether it
        may be zero."""
        symbols, found = {name(x): x for x in self.symbols}, []
        spelled = lambda tree: [tree[0], *map(spelled, tree[1:])] if isinstance(tree, list) else symbols.get(tree, tree)
        for text in texts:
            for left, sign, right in inequalities(text):
                try:
                    left, right = (evaluate(spelled(*Reader(side).sides()), self) for side in (left, right))
                except (Wrong, TypeError):  # it cannot be read, or is about something else
                    continue
                found.append((right - left if "<" in sign or "l" in sign else left - right, sign in "<>"))
        return found

    def principal(self, draw, minus, most):
        """Values of the generators at random, up to an order of magnitude, some of them negative: if there the conditions hold,
        and what is known are positive roots of positive numbers, and angles on their principal branches."""
        values = []
        for g, (rule, *of) in enumerate(self.rules):
            if rule in ("power", "logarithm") and not (of[0].at(values) > 0 or self.is_imaginary(g)):
                return None
            if rule == "half-tangent" and not self.is_within(values[of[0]]):
                return None
            size = fmpq(draw.getrandbits(40) + 1, 1 << 40) * fmpq(2) ** draw.randint(-3, most)
            values.append(arb(-size if g in minus else size) if rule == "free" else self.worth(g, values))
        within = {"arcsin": lambda x: 2 * abs(x) <= arb.pi(), "arccos": lambda x: 0 <= x <= arb.pi()}
        angles = all(within[function](is_.at(values)) for function, _, is_ in self.inverses)
        positive = [is_ for _, _, is_ in self.declared] + [x for x, _ in self.positive]
        return values if angles and all(x.at(values) > 0 for x in positive) else None

    def worth(self, g, values):
        """What a generator is worth by its rule, where those before it have these values."""
        rule, *of = self.rules[g]
        of = [x.at(values) if isinstance(x, Element) else values[x] for x in of]
        return WORTH[rule](*(map(acb, of) if self.is_imaginary(g) else of))

    @staticmethod
    def is_within(angle):
        """Whether half an angle has a positive cosine, as it is taken to have."""
        return not isinstance(angle, acb) and bool(abs(angle) < arb.pi())

    def is_imaginary(self, g):
        """Whether a generator is a root of a negative number: no formula has such a root."""
        n = self.roots[g][0].number() if g in self.roots else None
        return n is not None and n < 0

    def differs(self, x):
        """Whether an element differs from 0 somewhere on the principal branches, once these are known."""
        if self.places is None:
            self.divisors.append(x)
            return True
        return any(not x.at(place).contains(0) for place in self.places)

    @cache
    def with_signs(self, free, minus):
        """Places where these of the free generators are negative and the other ones are not; the rest is left to chance."""
        draw, others = random.Random(self.n), [g for g in range(self.n) if g not in free]
        of = ([*minus, *draw.choices(others, k=i % 3)] for i in range(EACH))
        return [place for signs in of if (place := self.principal(draw, signs, 2))]

    def everywhere(self, holds, *of):
        """Whether something holds of a place wherever we are on the principal branches, whatever the signs of what these are made of."""
        free = tuple(g for g in sorted(set().union(*map(self.made_of, of))) if self.rules[g] == ("free",))[:SIGNS]
        signs = product(*[(False, True)] * len(free))
        minus = [tuple(g for g, negative in zip(free, some) if negative) for some in signs]
        places = [place for some in minus for place in self.with_signs(free, some)]
        return all(map(holds, self.places + places))

    def exceeds_zero(self, x):
        """Whether an element is a positive number, or such a multiple of what is positive by a condition."""
        of = [(x / y).number() for y, strictly in [(self.number(1), True), *self.positive] if strictly and not self.is_zero(y)]
        return any(n is not None and n > 0 for n in of)

    def rule(self, g, x):
        """A generator's rule, of earlier ones."""
        demand(x["rule"] in RULES, f"no rule: {x['rule']}")
        match keys(x, RULES[x["rule"]]):
            case ["pi"]:
                demand(g == 0, "π is the generator 0")
                return ("pi",)
            case ["free", name]:
                demand(is_name(name) and name not in self.symbols, "a name twice, or no name")
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

    def exceeds(self, x, imaginary):
        """Whether an element is positive everywhere, or imaginary if it may be."""
        return self.everywhere(lambda place: imaginary if isinstance(y := x.at(place), acb) else y > 0, x)

    def moved(self, place, values):
        """Where one is from a place when these values are put in, by the rules; nowhere if the values are not by the rules."""
        there = []
        for g, (rule, *_) in enumerate(self.rules):
            own = place[g] if rule in ("pi", "free") else self.worth(g, there)
            there.append(values[g].at(place) if g in values else own)
            if g in values and rule not in ("pi", "free") and not there[g].overlaps(own):
                return None
        return there

    def keeps(self, g, all_, alone):
        """Whether a generator has the value that its rule gives it, where these values are put in; alone, it may have any."""
        rule, *of = self.rules[g]
        new, imaginary = all_[g], rule == "half-exponential"
        positive = rule not in ("half-exponential", "power") or self.exceeds(new, imaginary)
        if alone and rule != "power" or rule in ("pi", "free"):
            return positive
        of = [all_[x] if type(x) is int else self.value(x, all_, self) for x in of]
        match rule:
            case "half-tangent":
                # By cosine and sine of the whole angle.
                square = new * new
                cosine, sine = ((self.number(1) - square) / (self.number(1) + square), (new + new) / (self.number(1) + square))
                return self.everywhere(lambda place: self.is_within(of[0].at(place)), *of) and all(map(self.same, self.turn(*of), (cosine, sine)))
            case "half-exponential":
                return positive and self.same(self.call("exp", *of), new * new)
            case "logarithm":
                return self.same(self.call("ln", *of), new)
        if self.is_zero(of[0]):
            return self.is_zero(new) and self.exceeds_zero(of[1])
        if g in self.roots:
            return positive and self.same(self.repeated(new, self.roots[g][1]), of[0])
        return positive and self.same(self.power(*of), new)

    def put(self, x, values):
        """An element with values for some of the generators in it. What these are made of goes along where it occurs too, by the
        rules; what does not occur need not be said, if one generator alone is made of it."""
        demand(0 not in values, "π is no other number")
        all_, there = [values.get(g, own) for g, own in enumerate(self.g)], x.occurring()
        of = {g: self.made_of(self.g[g]) - {g} for g in self.made_of(x)}
        result = self.value(x, all_, self)
        for g in of:
            if g in values or of[g] & values.keys():
                others = [h for h in there - {g} if of[g] & (of[h] | {h}) and g not in of[h]]
                demand(self.keeps(g, all_, g in values and not others), "a value against a rule")
        # What is known of other roots and angles holds there too.
        beyond = {"arcsin": lambda x: 2 * abs(x) > arb.pi(), "arccos": lambda x: x < 0 or x > arb.pi(), "power": lambda x: x < 0}
        made_of = lambda of: set().union(*map(self.made_of, of))
        for function, is_ in self.branches:
            if self.made_of(is_) & made_of(self.g[g] for g in values):
                of_it = {g: y for g, y in values.items() if self.made_of(is_) & self.made_of(self.g[g])}

                def inside(place):
                    there = self.moved(place, of_it)
                    x = there and is_.at(there)
                    return x is not None and x.is_finite() and not beyond[function](x)

                demand(self.everywhere(inside, is_, *of_it.values()), "a value beyond a branch")
        return result


def inequalities(text):
    """A condition that is one, or several in a row, and says nothing else: left side, sign and right side of each."""
    latex = re.fullmatch(r"\$([^$]*)\$", text)
    sides = re.split(r"(<|>|\\leq?(?![a-z])|\\geq?(?![a-z]))", latex[1]) if latex else []
    return list(zip(sides[::2], sides[1::2], sides[2::2]))


def identity(w, before, conditions=()):
    """Some stand in several files; each is looked at once."""
    given = w.get("given", [])
    demand(all(isinstance(other, str) and other in before for other in given), "it rests on a proof that is not there")
    return carried_out(json.dumps(w), tuple(conditions))


@cache
def carried_out(text, conditions):
    w = json.loads(text)
    _, title, _, generators, symbols, powers, inverses, parts, gives, equal, fails = keys(
        w, "kind title given generators symbols powers inverses parts gives equal fails")
    demand(type(fails) is bool and len(equal) >= fails, "nothing is compared")
    f = Field(generators, symbols, powers, inverses, conditions)
    demand(len(gives) == len(parts), "not as many results as parts")
    made, used = [], set()
    for part, result in zip(parts, gives):
        made.append(step(f, made, part, used))
        as_said = result is None or f.same(made[-1], f.element(result, worked_out=True))
        demand(as_said, f"{title}: a part is something else")
    difference = lambda left, right: made[index(left, len(made))] - (f.number(0) if right is None else made[index(right, len(made))])
    for i, demanded in enumerate(equal):
        says, left, right = keys(demanded, "says left right")
        sides = [i for i in (left, right) if i is not None]
        demand(not plain(w, sides), "something is compared with itself")
        nothing = [any(f.is_zero(made[j]) for j in parts[i].get("product", ())) for i in sides]
        demand(nothing != [True, True], "0 times something")
        used |= {left, right} - {None}
        off = difference(left, right)
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
            # Rates of what does not occur say just that.
            absent = name == "derivative" and not values.keys() & there
            demand(values and len(values) == len(pairs) and (absent or values.keys() <= there), "an idle value")
            free = all(f.rules[g] == ("free",) for g in values)
            demand(free or name == "put", "a rate of what is not free")
            return f.put(x, values) if name == "put" else f.derivative(x, values)
        case "series", [tree, known]:
            demand(all(type(start) is int for _, start, _ in known), "no lowest power")
            demand_names(f, tree, [n for n, *_ in known])
            return expanded(f, tree, {n: Series(f, start, [get(i) for i in places]) for n, start, places in known})
        case "coefficient", [i, power]:
            demand(type(power) is int, "no power")
            return get(i)(power)
    raise Wrong(f"no part: {name}")


def symbols_in(tree):
    return set().union(*map(symbols_in, tree[1:])) if isinstance(tree, list) else {tree}


def demand_names(f, tree, names):
    """Only of names are there series, and of what is made of them nothing stays constant."""
    demand(len(set(names)) == len(names), "two series of one name")
    for n in names:
        of = n.removeprefix("exp ") if isinstance(n, str) else n
        demand(is_name(of) and of != "π" and (of == n or of not in f.symbols and of not in names), "a series of no name")
    vary = set().union(*(f.made_of(f.symbols[n]) for n in names if n in f.symbols))
    constant = [f.symbols[n] for n in symbols_in(tree) - set(names) if n in f.symbols and n != "π"]
    demand(not any(vary & f.made_of(x) for x in constant), "something constant that is made of what varies")


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
