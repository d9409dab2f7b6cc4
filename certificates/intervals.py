"""Intervals, and what is certified by them: roots, numbers, ranges, motions."""
import hashlib
import json
import re
from functools import reduce
from itertools import product

from flint import arb, arb_mat, ctx as precision, fmpq

from formula import Calculator, Expansion, Series, Value, Wrong, demand, dyadic, evaluate, index, is_name, keys
from latex import read

precision.prec = 512
INFINITY = arb.pos_inf()
FLINT = {"sin": arb.sin, "cos": arb.cos, "exp": arb.exp, "ln": arb.log, "√": arb.sqrt, "arcsin": arb.asin,
         "arccos": arb.acos}


class Interval(Value):
    """Between exact numbers, or infinite ones: the outermost that its ends, as Arb has them, may be."""
    __slots__ = ("low", "high")

    def __init__(self, low, high=None):
        self.low, self.high = arb(low).lower(), arb(low if high is None else high).upper()

    def __add__(self, y):
        return Interval(self.low + y.low, self.high + y.high)

    def __neg__(self):
        return Interval(-self.high, -self.low)

    def __mul__(self, y):
        """A slope is finite wherever it is multiplied by 0."""
        ends = [p * q if p != 0 and q != 0 else arb(0) for p in (self.low, self.high) for q in (y.low, y.high)]
        return Interval(reduce(arb.min, ends), reduce(arb.max, ends))

    def __truediv__(self, y):
        if y.low < 0 < y.high or y.low == y.high == 0:
            return Interval(-INFINITY, INFINITY)
        if y.high <= 0:
            return -self / -y
        return self * Interval(1 / y.high, 1 / y.low if y.low != 0 else INFINITY)

    def within(self, y):
        return y.low <= self.low and self.high <= y.high

    def sign(self):
        return 1 if self.low > 0 else -1 if self.high < 0 else 0

    def width(self):
        return self.high - self.low

    def middle(self):
        return Interval(((self.low + self.high) / 2).mid())

    def meet(self, y):
        return Interval(arb.max(self.low, y.low), arb.min(self.high, y.high))


def sine(x):
    def turns(extreme):
        """Whether one of the angles that differ from this one by whole turns lies in between."""
        before, after = (((end - extreme) / (2 * arb.pi())) for end in (x.low, x.high))
        return not before.lower().floor() == after.upper().floor()

    ends = x.low.sin(), x.high.sin()
    return Interval(-1 if turns(-arb.pi() / 2) else arb.min(*ends), 1 if turns(arb.pi() / 2) else arb.max(*ends))


class Numbers(Calculator):
    """Calculates with intervals, for names with values."""
    number, kind = Interval, "variable"

    def __init__(self, values):
        self.symbols = {**values, "π": self.number(arb.pi())}

    def is_zero(self, x):
        return x.low == x.high == 0

    def whole(self, x):
        return int(x.low.unique_fmpz()) if x.low == x.high and x.low.is_integer() and abs(x.low) < 1000 else None

    def power(self, x, y):
        return self.call("exp", y * self.call("ln", x))

    def call(self, name, x):
        if name in ("cos", "sin"):
            y = sine(x + Interval(arb.pi() / 2) if name == "cos" else x)
        elif name == "arccos":
            y = Interval(arb.pi() / 2) - self.call("arcsin", x)
        else:
            # These grow. Rounding may lead out of their domains, and no more.
            least, most = {"√": (0, INFINITY), "arcsin": (-1, 1)}.get(name, (-INFINITY, INFINITY))
            far = x.low < least - arb(2) ** -236 or x.high > most + arb(2) ** -236
            demand(not far and -INFINITY < x.low and x.high < INFINITY, f"{name} outside of its domain")
            y = Interval(FLINT[name](arb.max(x.low, least)), FLINT[name](arb.min(x.high, most)))
        demand(y.low.is_finite() and y.high.is_finite(), "no value")
        return y


def hashed(text):
    """A number between 1/10 and 6/10 that letters give."""
    digest = hashlib.sha256(text.encode()).digest()
    return fmpq(1, 10) + fmpq(int.from_bytes(digest[:6], "big"), 1 << 49)


def variables(names):
    demand(isinstance(names, list) and all(map(is_name, names)) and len(set(names)) == len(names) and "π" not in names, "no names")
    return names


def box(x, n):
    sides = isinstance(x, list) and len(x) == n and all(isinstance(side, list) and len(side) == 2 for side in x)
    demand(sides, "no box")
    ends = [[dyadic(end) for end in side] for side in x]
    demand(all(low <= high for low, high in ends), "an interval without a number")
    return [Interval(*side) for side in ends]


def halves(cell, i, at):
    """The parts of a box below and above a cut."""
    return [cell[:i] + [half] + cell[i + 1:] for half in (Interval(cell[i].low, at), Interval(at, cell[i].high))]


def coefficients(tree, names, cell, by=0, power=0):
    """Taylor's coefficients of a formula by one variable, about all points of a box at once."""
    of = Numbers(dict(zip(names, cell)))
    if power == 0:
        return [evaluate(tree, of)]
    series = Series(of, 0, [of.symbols[names[by]], of.number(1)] + [of.number(0)] * (power - 1))
    value = evaluate(tree, Expansion(of, {names[by]: series}, power))
    return [value.at(k) for k in range(power + 1)]


def nearest(value, text, unit=fmpq(1, 1 << 30)):
    """Whether a number in an interval is, in units, nearest to a whole number."""
    n, room = dyadic(text), fmpq(1, 2) + fmpq(1, 64)
    demand(n.q == 1, "no whole number of units")
    return value.within(Interval((n - room) * unit, (n + room) * unit))


def root(w, before):
    _, names, functions, within, corners, c, found = keys(
        w, "kind variables functions within corners preconditioner root")
    n, zero, one = range(len(variables(names))), Interval(0), Interval(1)
    demand(names and len(functions) == len(c) == len(found) == len(names), "not as many functions as variables")
    within = box(within, len(names))
    values = lambda cell: [coefficients(f, names, cell)[0] for f in functions]
    slopes = lambda cell: [[coefficients(f, names, cell, j, 1)[1] for j in n] for f in functions]
    for end, texts in zip(("low", "high"), corners, strict=True):
        found_there = values([Interval(getattr(x, end)) for x in within])
        demand(len(texts) == len(names) and all(map(nearest, found_there, texts)), "another value at a corner")
    demand(all(len(row) == len(names) for row in c), "no matrix")
    c = [[dyadic(x) for x in row] for row in c]
    # The preconditioner has 20 bits after the point: those of the inverse in the middle.
    inverse = arb_mat([[x.low for x in row] for row in slopes([x.middle() for x in within])]).inv()
    near = lambda x, y: (x * 2**20).q == 1 and abs(x - y) < arb(2) ** -20
    demand(all(map(near, sum(c, []), inverse.entries())), "another preconditioner")
    c = [[Interval(x) for x in row] for row in c]

    def image(x):
        """Krawczyk's image of a box: m − C f(m) + (1 − C f′) (X − m)."""
        m, of = [side.middle() for side in x], slopes(x)
        f = values(m)
        rest = lambda i, j: (one if i == j else zero) - sum((c[i][k] * of[k][j] for k in n), zero)
        return [m[i] - sum((c[i][j] * f[j] - rest(i, j) * (x[j] - m[j]) for j in n), zero) for i in n]

    x = image(within)
    demand(all(b.low < a.low and a.high < b.high for a, b in zip(x, within)), "the image is not inside the box")
    # That is the only root in the box; now its digits.
    for _ in range(30):
        x = list(map(Interval.meet, x, image(x)))
    for side, text in zip(x, found):
        whole, _, power = text.partition("*2^")
        near = int(power or 0) <= -32 and nearest(side, whole, fmpq(2) ** int(power))
        demand(near, "the root is elsewhere")
    return names, x


def number(w, before):
    _, place, stated, found = keys(w, "kind root stated found")
    at = before[index(place, len(before))]
    demand(isinstance(at, tuple), "the number is not that of a root")
    demand(stated != found, "something is compared with itself")
    off = coefficients(stated, *at)[0] - coefficients(found, *at)[0]
    same = Interval(0).within(off) and off.width() < arb(2) ** -200
    if isinstance(stated, list) and stated[0] == "/" and re.fullmatch(r"\d+/10+", "/".join(map(str, stated[1:]))):
        # A decimal, rounded to its last digit.
        same = off.within(Interval(fmpq(-1, 2 * int(stated[2])), fmpq(1, 2 * int(stated[2]))))
    demand(same, "the numbers differ")


def holds(condition, names, cell, deeper=8):
    """Whether a coefficient has its sign on a box, or on all parts of it."""
    tree, by, power, sign = condition
    try:
        value = coefficients(tree, names, cell, by, power)[power]
        if value.sign() != sign and power == 0:
            # By the slopes: f(m) + f′ (X − m).
            value = coefficients(tree, names, [x.middle() for x in cell])[0]
            for j, x in enumerate(cell):
                if x.low < x.high:
                    value += coefficients(tree, names, cell, j, 1)[1] * (x - x.middle())
        if value.sign() == sign:
            return True
    except Wrong:
        pass
    i = max(range(len(cell)), key=lambda i: cell[i].width())
    if deeper == 0 or cell[i].width() == 0:
        return False
    return all(holds(condition, names, half, deeper - 1) for half in halves(cell, i, cell[i].middle().low))


def covered(cell, parts):
    """Whether boxes leave no gap in a box, which is cut at their ends."""
    if any(all(map(Interval.within, cell, part)) for part in parts):
        return True
    parts = [part for part in parts if all(x.low <= y.high and y.low <= x.high for x, y in zip(part, cell))]
    for i, side in enumerate(cell):
        cuts = sorted(end for part in parts for end in (part[i].low, part[i].high) if side.low < end < side.high)
        if cuts:
            return all(covered(half, parts) for half in halves(cell, i, cuts[len(cuts) // 2]))
    return False


def range_(w, before, accepted=set()):
    """Some stand in several files; each is looked at once."""
    text = json.dumps(w)
    if text not in accepted:
        everywhere(w)
        accepted.add(text)


def everywhere(w):
    _, names, within, cases, parts = keys(w, "kind variables within cases parts")
    n = len(variables(names))
    within = box(within, n)
    demand(all(side.low < side.high for side in within), "no range")
    parts = [(box(at, n), by) for at, by in (keys(part, "at by") for part in parts)]
    cells = [at for at, _ in parts]
    demand(covered(within, cells), "the parts leave a gap")
    volume = lambda cell: reduce(lambda v, side: v * side.width(), cell, arb(1))
    demand(sum(map(volume, cells)) == volume(within), "the parts overlap")
    cases = [(which(of, n), choice, [keys(c, "formula by power sign middle") for c in conditions])
             for of, choice, conditions in (keys(case, "of choice conditions") for case in cases)]
    used = set()
    for at, by in parts:
        place = next((i for i, (of, _, _) in enumerate(cases) if of(at)), None)
        demand(place is not None, "a part without a condition")
        _, choice, conditions = cases[place]
        demand(type(choice) is bool and choice == (by is not None) and conditions, "no choice")
        for i in [index(by, len(conditions))] if choice else range(len(conditions)):
            *condition, middle = conditions[i]
            if (place, i) not in used:
                tree, by_, power, sign = condition
                index(by_, n if index(power, 10) else 1)
                demand(type(sign) is int and abs(sign) == 1, "no sign")
                values = coefficients(tree, names, [x.middle() for x in at], by_, power)
                near = len(values) == len(middle) and all(map(nearest, values, middle))
                demand(near, "another value in the middle")
            used.add((place, i))
            demand(holds(condition, names, at), "a condition that is not fulfilled")
    demand(len(used) == sum(len(conditions) for _, _, conditions in cases), "an idle condition")


def which(of, n):
    """Whether a case is for a part."""
    if of == "rest":
        return lambda part: True
    demand(isinstance(of, dict) and len(of) == 1 and of.keys() <= {"from", "below"}, "no choice of parts")
    (kind, (i, at)), = of.items()
    i, at = index(i, n), arb(dyadic(at))
    demand(at.is_exact(), "no choice of parts")
    return (lambda part: part[i].low == at) if kind == "from" else (lambda part: part[i].high < at)


# --- motions ---

ORDER = 17
# Bits after the point.
WALL, STATE = 20, 44
# The derivatives by the start, at the start.
UNIT = [Interval(int(i == j)) for i, j in product(range(3), repeat=2)]
P, W, Z = "p", "w", "ζ"
LAW = [read("-pw"), read("-ζζ"), read("wζ-p-ζ")]
# What decides, as the book proves it: p + ρ < 1 for rest; ρ² − p² > 1, w < 0, or ζ < −p and w < p for escape.
# Here ξ is 1 − w, and ρ² is ξ² + (p − ζ)².
ENOUGH = {
    "rest": [[[P, 1], [read("1-p"), 1], [read("(1-p)(1-p)-((1-w)(1-w)+(p-ζ)(p-ζ))"), 1]]],
    "escape": [[[P, 1], [read("(1-w)(1-w)+ζ(ζ-p-p)-1"), 1]], [[P, 1], [W, -1]],
               [[P, 1], [read("ζ+p"), -1], [read("p-w"), 1]]],
}


def expansion(state, order):
    """Taylor coefficients of p, w, ζ and, one after the other, of their derivatives by those at the start."""
    c, zero = [[x] for x in state], Interval(0)
    p, w, z = c[:3]
    for k in range(order):
        by = lambda x, y: sum((x[m] * y[k - m] for m in range(k + 1)), zero)
        for i in range(0, len(c), 3):
            # The products' rates; with what moves itself in place of its derivatives, they are twice the products.
            p1, w1, z1 = c[i:i + 3]
            rates = [-by(p, w1) - by(p1, w), -by(z, z1) - by(z1, z), by(w, z1) + by(w1, z)]
            rates = rates if i else [x / Interval(2) for x in rates]
            rates[2] -= p1[k] + z1[k]
            for x, rate in zip((p1, w1, z1), rates):
                x.append(rate / Interval(k + 1))
    return c


def close(x, cell, bits):
    """Whether an interval lies in another one between whole units that is hardly wider."""
    unit = arb(2) ** -bits
    whole = (cell.low / unit).is_integer() and (cell.high / unit).is_integer()
    return whole and x.within(cell) and cell.low + 2 * unit > x.low and cell.high - 2 * unit < x.high


def motion(w, before):
    _, names, law, given, from_, start, steps, end, decides = keys(
        w, "kind variables law numbers from start steps end decides")
    demand(names == [P, W, Z] and law == LAW, "another law of motion")
    demand(end in ENOUGH and decides in ENOUGH[end], "that decides nothing")
    state = box(start, 3)
    given = {name: coefficients(x, [], [])[0] for name, x in given}
    for tree, side in zip(from_, state, strict=True):
        demand(close(coefficients(tree, list(given), given.values())[0], side, STATE), "the start is elsewhere")
    for step in steps:
        length, walls, then = keys(step, "length walls state")
        h, walls, then = dyadic(length), box(walls, 3), box(then, 3)
        demand(h > 0 and (h * 2**20).q == 1, "no length of a step")
        state = taken(state, Interval(h), walls)
        demand(all(close(x, side, STATE) for x, side in zip(state, then)), "the motion ends elsewhere")
        state = then
    for tree, sign in decides:
        demand(coefficients(tree, names, state)[0].sign() == sign, "what is to decide is not so")


def taken(state, h, walls):
    """The state after a step that does not leave the walls."""
    begin, during = state + UNIT, Interval(0, h.high)
    reached = lambda walls: [x + during * rate[1] for x, rate in zip(begin, expansion(walls, 1))]
    inside = all(close(x, wall, WALL) for x, wall in zip(reached(walls), walls))
    demand(inside, "a motion leaves its walls, or they are far")
    own = begin[3:]
    for _ in range(50):
        next_ = reached(walls + own)[3:]
        if all(map(Interval.within, next_, own)):
            break
        more = [x.width() / 5 + arb(2) ** -30 for x in next_]
        own = [Interval(x.low - m, x.high + m) for x, m in zip(next_, more)]
    else:
        raise Wrong("derivatives without bounds")
    rest = [c[ORDER] for c in expansion(walls + own, ORDER)]

    middle = [x.middle() for x in state]

    def sums(start):
        """Taylor's series, with the rest that holds within the walls."""
        series, total = expansion(start, ORDER - 1), rest
        for k in reversed(range(ORDER)):
            total = [t * h + c[k] for t, c in zip(total, series)]
        return total

    all_, centre = sums(begin), sums(middle + UNIT)
    off = [[all_[3 + 3 * j + i] * (state[j] - middle[j]) for j in range(3)] for i in range(3)]
    return [sum(off[i], centre[i]).meet(all_[i]) for i in range(3)]
