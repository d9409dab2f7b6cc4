"""Intervals, and what is certified by them: roots, numbers, ranges, motions.

An interval's ends are whole numbers of units of 2⁻²⁵⁶, rounded outwards, or infinite.
"""
import hashlib
from functools import reduce

from flint import arb, arb_mat, ctx as precision, fmpq, fmpz

from formula import Expansion, Series, Wrong, demand, dyadic, evaluate, index, keys

BITS = 256
ONE = 1 << BITS
INFINITY = float("inf")
precision.prec = 2 * BITS


def shifted(x, up=False):
    """A product of units in units."""
    return x if isinstance(x, float) else -(-x >> BITS) if up else x >> BITS


def times(x, y):
    """A slope is finite wherever it is multiplied by 0."""
    return x * y if x and y else 0


class Interval:
    __slots__ = ("low", "high")

    def __init__(self, low, high):
        self.low, self.high = low, high

    def __add__(self, y):
        return Interval(self.low + y.low, self.high + y.high)

    def __neg__(self):
        return Interval(-self.high, -self.low)

    def __sub__(self, y):
        return Interval(self.low - y.high, self.high - y.low)

    def __mul__(self, y):
        a, b, c, d = self.low, self.high, y.low, y.high
        if a >= 0 and c >= 0 and b < INFINITY and d < INFINITY:
            return Interval(a * c >> BITS, -(-b * d >> BITS))
        ends = [times(p, q) for p in (a, b) for q in (c, d)]
        return Interval(shifted(min(ends)), shifted(max(ends), True))

    def __truediv__(self, y):
        if y.low < 0 < y.high or y.low == y.high == 0:
            return Interval(-INFINITY, INFINITY)
        if y.high <= 0:
            return -self / -y
        over = lambda n, up: INFINITY if n == 0 else 0 if n == INFINITY else -(-ONE * ONE // n) if up else ONE * ONE // n
        return self * Interval(over(y.high, False), over(y.low, True))

    def __contains__(self, x):
        return self.low <= x <= self.high

    def within(self, y, strictly=0):
        return y.low + strictly <= self.low and self.high <= y.high - strictly

    def sign(self):
        return 1 if self.low > 0 else -1 if self.high < 0 else 0

    def middle(self):
        return Interval(*[(self.low + self.high) // 2] * 2)

    def hull(self, y):
        return Interval(min(self.low, y.low), max(self.high, y.high))


def enclosing(low, high):
    """An interval about numbers."""
    low, high = fmpq(low) * ONE, fmpq(high) * ONE
    return Interval(int(low.floor()), int(high.ceil()))


def by_arb(f, x):
    """A function's value at a number of units."""
    value = f(arb(fmpz(x)) / ONE) * ONE
    demand(value.is_finite(), "no value")
    return Interval(int(value.lower().floor().unique_fmpz()), int(value.upper().ceil().unique_fmpz()))


def sine(x):
    if x.high - x.low >= 7 * ONE:
        return Interval(-ONE, ONE)
    y = by_arb(arb.sin, x.low).hull(by_arb(arb.sin, x.high))
    quarter = by_arb(lambda t: t / arb.pi() + arb(1) / 2, x.low).low // ONE, by_arb(lambda t: t / arb.pi() + arb(1) / 2, x.high).high // ONE
    for n in range(quarter[0] + 1, quarter[1] + 1):
        # An extreme, at (n − 1/2) π.
        y = y.hull(Interval(*[ONE if n % 2 else -ONE] * 2))
    return Interval(max(y.low, -ONE), min(y.high, ONE))


class Numbers:
    """Calculates with intervals, for names with values."""

    def __init__(self, values):
        self.values = values

    def number(self, n):
        return enclosing(n, n)

    def pi(self):
        return by_arb(lambda t: t + arb.pi(), 0)

    def symbol(self, name):
        demand(name in self.values, f"no variable {name}")
        return self.values[name]

    def is_zero(self, x):
        return x.low == x.high == 0

    def whole(self, x):
        return x.low // ONE if x.low == x.high and x.low % ONE == 0 and abs(x.low) < 1000 * ONE else None

    def exponential(self, tree):
        return None

    def raised(self, x, y):
        n = self.whole(y)
        if n is None:
            return self.call("exp", y * self.call("ln", x))
        power = reduce(lambda power, _: power * x, range(abs(n)), self.number(1))
        return power if n >= 0 else self.number(1) / power

    def call(self, name, x):
        if name == "cos":
            return sine(x + self.pi() / self.number(2))
        if name == "sin":
            return sine(x)
        if name == "arccos":
            return self.pi() / self.number(2) - self.call("arcsin", x)
        # These grow. Rounding may lead out of their domains, and no more.
        least, most = {"√": (0, INFINITY), "arcsin": (-ONE, ONE)}.get(name, (-INFINITY, INFINITY))
        far = Interval(x.low, x.high).within(Interval(least - 2**20, most + 2**20))
        demand(far and -INFINITY < x.low and x.high < INFINITY, f"{name} outside of its domain")
        f = {"√": arb.sqrt, "arcsin": arb.asin, "exp": arb.exp, "ln": arb.log}[name]
        return Interval(by_arb(f, max(x.low, least)).low, by_arb(f, min(x.high, most)).high)


def hashed(text):
    """A number between 1/10 and 6/10 that letters give."""
    digest = hashlib.sha256(text.encode()).digest()
    x = fmpq(1, 10) + fmpq(int.from_bytes(digest[:6], "big"), 1 << 48) * fmpq(1, 2)
    return enclosing(x, x)


def variables(names):
    demand(isinstance(names, list) and all(isinstance(n, str) for n in names) and len(set(names)) == len(names), "no names")
    return names


def box(x, n):
    demand(isinstance(x, list) and len(x) == n and all(isinstance(side, list) and len(side) == 2 for side in x), "no box")
    ends = [[dyadic(end) for end in side] for side in x]
    demand(all(low <= high for low, high in ends), "an interval without a number")
    return [enclosing(*side) for side in ends]


def coefficients(tree, names, cell, by=0, power=0):
    """Taylor's coefficients of a formula by one variable, about all points of a box at once."""
    of = Numbers(dict(zip(names, cell)))
    if power == 0:
        return [evaluate(tree, of)]
    series = {name: Series(of, 0, [x, of.number(1)] + [of.number(0)] * (power - 1)) for name, x in zip(names, cell) if name == names[by]}
    value = evaluate(tree, Expansion(of, series, power))
    return [value.at(k) for k in range(power + 1)]


def nearest(value, text, unit, room=fmpq(1, 64)):
    """Whether a number in an interval is, in units, nearest to a whole number."""
    n = dyadic(text)
    demand(n.q == 1, "no whole number of units")
    return value.within(enclosing((n - fmpq(1, 2) - room) * unit, (n + fmpq(1, 2) + room) * unit))


STORED = fmpq(1, 1 << 30)


def root(w, before):
    _, names, functions, within, corners, c, found = keys(
        w, "kind variables functions within corners preconditioner root")
    n = range(len(variables(names)))
    demand(names and len(functions) == len(c) == len(found) == len(names), "not as many functions as variables")
    within = box(within, len(names))
    for corner, values in zip(([Interval(x.low, x.low) for x in within], [Interval(x.high, x.high) for x in within]), corners, strict=True):
        for f, value in zip(functions, values, strict=True):
            demand(nearest(coefficients(f, names, corner)[0], value, STORED), "another value at a corner")
    slopes = lambda cell: [[coefficients(f, names, cell, j, 1)[1] for j in n] for f in functions]
    # The preconditioner has 20 bits after the point: those of the inverse in the middle.
    inverse = arb_mat([[arb(x.low) / ONE for x in row] for row in slopes([x.middle() for x in within])]).inv()
    for i in n:
        demand(len(c[i]) == len(names), "no matrix")
        for j in n:
            demand((dyadic(c[i][j]) * 2**20).q == 1 and abs(arb(dyadic(c[i][j])) - inverse[i, j]) < arb(2) ** -20, "another preconditioner")
    c = [[enclosing(dyadic(x), dyadic(x)) for x in row] for row in c]
    zero, one = Interval(0, 0), Interval(ONE, ONE)

    def image(x):
        """Krawczyk's image of a box: m − C f(m) + (1 − C f′) (X − m)."""
        m, of = [side.middle() for side in x], slopes(x)
        f = [coefficients(g, names, m)[0] for g in functions]
        rest = lambda i, j: (one if i == j else zero) - sum((c[i][k] * of[k][j] for k in n), zero)
        return [m[i] - sum((c[i][j] * f[j] for j in n), zero) + sum((rest(i, j) * (x[j] - m[j]) for j in n), zero) for i in n]

    x = image(within)
    demand(all(k.within(side, 1) for k, side in zip(x, within)), "the image is not inside the box")
    # That is the only root in the box; now its digits.
    for _ in range(30):
        x = [Interval(max(a.low, b.low), min(a.high, b.high)) for a, b in zip(x, image(x))]
    for side, text in zip(x, found):
        unit = fmpq(2) ** int(text.partition("*2^")[2] or 0)
        demand(nearest(side, text.partition("*")[0], unit), "the root is elsewhere")
    return names, x


def number(w, before):
    _, place, stated, found = keys(w, "kind root stated found")
    at = before[index(place, len(before))]
    demand(isinstance(at, tuple), "the number is not that of a root")
    off = coefficients(stated, *at)[0] - coefficients(found, *at)[0]
    half = 0
    if isinstance(stated, list) and stated[0] == "/" and str(stated[2]).strip("0") == "1":
        # A decimal, rounded to its last digit.
        half = ONE // (2 * int(stated[2]))
    demand(off.within(Interval(-half, half)) if half else 0 in off and off.high - off.low < ONE >> 200, "the numbers differ")


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
    except (Wrong, OverflowError):
        pass
    i = max(range(len(cell)), key=lambda i: cell[i].high - cell[i].low)
    low, high = cell[i].low, cell[i].high
    if deeper == 0 or high - low < 2:
        return False
    middle = (low + high) // 2
    return all(holds(condition, names, cell[:i] + [half] + cell[i + 1:], deeper - 1) for half in (Interval(low, middle), Interval(middle, high)))


def covered(range_, parts):
    """Whether boxes leave no gap in a range."""
    if any(all(side.within(x) for side, x in zip(range_, part)) for part in parts):
        return True
    for i, side in enumerate(range_):
        cuts = sorted({end for part in parts for end in (part[i].low, part[i].high) if side.low < end < side.high})
        if cuts:
            cut = cuts[len(cuts) // 2]
            halves = [range_[:i] + [half] + range_[i + 1:] for half in (Interval(side.low, cut), Interval(cut, side.high))]
            touching = lambda half: [p for p in parts if all(x.low < y.high and y.low < x.high or y.low == y.high and y.low in x for x, y in zip(p, half))]
            return all(covered(half, touching(half)) for half in halves)
    return False


def range_(w, before):
    _, names, within, cases, parts = keys(w, "kind variables within cases parts")
    n = len(variables(names))
    within, parts = box(within, n), [(box(at, n), by) for at, by in (keys(part, "at by") for part in parts)]
    cells = [at for at, _ in parts]
    demand(covered(within, cells), "the parts leave a gap")
    volume = lambda cell: reduce(lambda v, side: v * (side.high - side.low), cell, 1)
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
            tree, by_, power, sign = condition
            if (place, i) not in used:
                index(power, 10), index(by_, n if power else 1)
                demand(type(sign) is int and abs(sign) == 1, "no sign")
                values = coefficients(tree, names, [x.middle() for x in at], by_, power)
                demand(all(nearest(v, text, STORED) for v, text in zip(values, middle, strict=True)), "another value in the middle")
            used.add((place, i))
            demand(holds(condition, names, at), "a condition that is not fulfilled")
    demand(len(used) == sum(len(conditions) for _, _, conditions in cases), "an idle condition")


def which(of, n):
    if of == "rest":
        return lambda part: True
    demand(isinstance(of, dict) and len(of) == 1, "no choice of parts")
    (kind, (i, at)), = of.items()
    i, at = index(i, n), dyadic(at) * ONE
    demand(kind in ("from", "below") and at.q == 1, "no choice of parts")
    return (lambda part: part[i].low == at.p) if kind == "from" else (lambda part: part[i].high < at.p)


# --- motions ---

ORDER = 17
WALL, STATE = ONE >> 20, ONE >> 44
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


def expansion(state, order):
    """Taylor coefficients of p, w, ζ and of their derivatives by the start, row by row, from the law."""
    c, zero = [[x] for x in state], Interval(0, 0)
    for k in range(order):
        by = lambda i, j: sum((c[i][m] * c[j][k - m] for m in range(k + 1)), zero)
        rates = [-by(0, 1), -by(2, 2), by(1, 2) - c[0][k] - c[2][k]]
        for row in (lambda p, w, z: -(by(p, 1) + by(0, w)), lambda p, w, z: -(by(2, z) + by(2, z)),
                    lambda p, w, z: by(w, 2) + by(1, z) - c[p][k] - c[z][k]):
            rates += [row(3 + i, 6 + i, 9 + i) for i in range(3)]
        for x, rate in zip(c, rates):
            x.append(Interval(rate.low // (k + 1), -(-rate.high // (k + 1))))
    return c


def extended(state):
    return state + [Interval(ONE, ONE) if i == j else Interval(0, 0) for i in range(3) for j in range(3)]


def close(x, cell, unit):
    """Whether an interval lies in another one between whole units that is hardly wider."""
    return cell.low % unit == cell.high % unit == 0 and x.within(cell) and cell.low + 2 * unit > x.low and cell.high - 2 * unit < x.high


def motion(w, before):
    _, names, law, given, from_, start, steps, end, decides = keys(w, "kind variables law numbers from start steps end decides")
    demand(names == [P, W, Z] and law == LAW, "another law of motion")
    demand(end in ENOUGH and decides in ENOUGH[end], "that decides nothing")
    state = box(start, 3)
    given = {name: coefficients(x, [], [])[0] for name, x in given}
    for tree, side in zip(from_, state, strict=True):
        demand(close(coefficients(tree, list(given), given.values())[0], side, STATE), "the start is elsewhere")
    for step in steps:
        length, walls, then = keys(step, "length walls state")
        h, walls, then = dyadic(length) * 2**20, box(walls, 3), box(then, 3)
        demand(h > 0 and h.q == 1, "no length of a step")
        state = taken(state, enclosing(h / 2**20, h / 2**20), walls)
        demand(all(close(x, side, STATE) for x, side in zip(state, then)), "the motion ends elsewhere")
        state = then
    for tree, sign in decides:
        demand(coefficients(tree, names, state)[0].sign() == sign, "what is to decide is not so")


def taken(state, h, walls):
    """The state after a step that does not leave the walls."""
    begin, during = extended(state), Interval(0, h.high)
    reached = lambda walls: [x + during * rate[1] for x, rate in zip(begin, expansion(walls, 1))]
    demand(all(close(x, wall, WALL) for x, wall in zip(reached(extended(walls)), walls)), "a motion leaves its walls, or they are far")
    own = begin[3:]
    for _ in range(50):
        next_ = reached(walls + own)[3:]
        if all(a.within(b) for a, b in zip(next_, own)):
            break
        more = lambda x: (x.high - x.low) // 5 + WALL // 1000
        own = [Interval(x.low - more(x), x.high + more(x)) for x in next_]
    else:
        raise Wrong("derivatives without bounds")
    rest = [c[ORDER] for c in expansion(walls + own, ORDER)]
    middle = [x.middle() for x in state]

    def sums(start):
        series, total = expansion(start, ORDER - 1), rest
        for k in reversed(range(ORDER)):
            total = [t * h + c[k] for t, c in zip(total, series)]
        return total

    all_, centre, then = sums(begin), sums(extended(middle)), []
    for i in range(3):
        x = centre[i] + sum((all_[3 + 3 * i + j] * (state[j] - middle[j]) for j in range(3)), Interval(0, 0))
        then.append(Interval(max(x.low, all_[i].low), min(x.high, all_[i].high)))
    return then
