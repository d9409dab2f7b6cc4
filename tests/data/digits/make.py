"""Reference answers for the calculators and the index of values, made without any code of theirs.

Run: python3 make.py           checks the closed forms and writes the CSV files of KINDS and values.csv, in 3 minutes
     python3 make.py checks    the checks only

Made with Python 3.11, mpmath 1.4.1, gmpy2 2.3.2 (it makes mpmath faster, the digits are the same). Seed: "20 " and
the name of the kind; the same rows every time.

Inputs are doubles and taken as exact, but an angle of 3.141592653589793 is exactly pi: straight against the pull.
Numbers are the shortest decimals that give the nearest double back; an empty field is "none". Every answer is
computed at two precisions, 60 digits at least, which must agree to 25 digits of each number, or both are raised. A
case with a number beyond the range of normal doubles is left out.

The motions, from Newton's law with Coulomb friction. Forces are per unit of mass.

Constant pull A along x, friction lambda A against the velocity, v its size, theta its angle:
    dv/dt = A (cos theta - lambda),   v dtheta/dt = -A sin theta.
In s with dt = (v/A) ds this is d theta/ds = -sin theta, so tan(theta/2) = tan(theta0/2) e^-s, and cos theta =
tanh(s + c) with e^-c = tan(theta0/2). With C = cos^2(theta0/2), S = sin^2(theta0/2), E(k) = (1 - e^(-k s))/k:
    v   = v0 e^(-lambda s) (C e^s + S e^-s),   v_x the same with - S,   v_y = v0 e^(-lambda s) sin theta0,
    t   = v0/A   [C E(lambda-1) + S E(lambda+1)],
    x   = v0^2/A [C^2 E(2 lambda-2) - S^2 E(2 lambda+2)],
    y   = v0^2/A sin theta0 [C E(2 lambda-1) + S E(2 lambda+1)].
For lambda > 1 t has a limit: the stop. At theta0 = pi the angle never turns; the particle stops after
v0/(A (1+lambda)) and stays if lambda >= 1, else the pull takes it along +x.

A sphere with I = kappa m R^2 (m = R = mu g = 1), u the slip, f = u/|u|: dv/dtau = gamma x - f and, the force acting
at -z, kappa dzeta/dtau = z x f. The slip u = v + zeta x (-z) obeys du/dtau = gamma x - b f, b = 1 + 1/kappa: the
problem above with A = gamma, lambda = b/gamma. Integrating f out: from zeta = 0
    (kappa+1) zeta_x = u_y - u_y(0),   (kappa+1) zeta_y = gamma tau - u_x + u_x(0),
and the same goes on while it rolls.

A drive h(phi) with friction a forwards, b backwards: w' = h - a for w > 0, h + b for w < 0, and w stays 0 while
-b <= h <= a. The distance of two motions never grows, and a periodic one is the only one; so whatever periodic
motion is found, it is the large-time motion. For h = sin phi a slip forwards from rest at s has
    w = cos s - cos phi - a (phi - s),   way = L cos s + sin s - sin e - a L^2/2 until its end e = s + L;
one backwards is the same half a period later. Without rest the momenta of both slips vanish: a L = b (2 pi - L), so
L = 2K, K = pi b/(a+b), and the middle m of the slip forwards has sin m = a K/sin K, cos m < 0.
"""

import csv
import math
import random
import sys
import time
from pathlib import Path

from mpmath import mp, mpf

PI = math.pi
HERE = Path(__file__).parent
ROWS = 10_000
SMALLEST, LARGEST = sys.float_info.min, sys.float_info.max


# Precision.


def agree(one, other):
    """Whether two answers agree to 25 digits of every number."""
    if len(one) != len(other):
        return False
    for a, b in zip(one, other):
        if isinstance(a, mpf) and isinstance(b, mpf):
            if abs(a - b) > mpf(10) ** -25 * abs(b):
                return False
        elif a != b:
            return False
    return True


def sure(answer, *given):
    """The answer, at a precision that is enough."""
    digits = 60
    while digits < 4000:
        with mp.workdps(digits):
            first = answer(*given)
        with mp.workdps(digits * 3 // 2):
            second = answer(*given)
            if agree(first, second):
                return second
        digits *= 2
    raise ArithmeticError(f"no precision is enough: {answer.__name__}{given}")


def text(value):
    """A field; None for a number beyond the doubles."""
    if value is None:
        return ""
    if isinstance(value, str):
        return value
    if value == 0:
        return "0.0"
    if not SMALLEST <= abs(value) <= LARGEST:
        return None
    return repr(float(value))


def root(f, low, high):
    """The root between low, where f > 0, and high, where f < 0; f gives its value and its slope. Newton's method,
    kept inside the bracket."""
    x = (low + high) / 2
    near = mpf(10) ** (-6 * mp.dps // 10)
    for _ in range(2000):
        value, slope = f(x)
        if value == 0:
            return x
        if value > 0:
            low = x
        else:
            high = x
        new = x - value / slope if slope != 0 else low
        if not low <= new <= high:
            new = (low + high) / 2
        if abs(new - x) <= near * abs(new):
            # One step more doubles the digits.
            value, slope = f(new)
            return new - value / slope
        x = new
    raise ArithmeticError("no root")


# Constant pull.


def spent(k, s):
    """E(k) = (1 - e^(-k s))/k."""
    return s if k == 0 else -mp.expm1(-k * s) / k


class Launch:
    """A launch with friction lambda, pull a, speed v0 and angle theta0 (0 and pi are for the caller)."""

    def __init__(self, lam, a, v0, theta0):
        self.lam, self.a, self.v0, self.theta0 = lam, a, v0, theta0
        self.c, self.s = mp.cos(theta0 / 2) ** 2, mp.sin(theta0 / 2) ** 2
        self.tan = mp.tan(theta0 / 2)
        self.stop = v0 / a * (self.c / (lam - 1) + self.s / (lam + 1)) if lam > 1 else None

    def time(self, s):
        return self.v0 / self.a * (self.c * spent(self.lam - 1, s) + self.s * spent(self.lam + 1, s))

    def left(self, s):
        """The time that is left until the stop."""
        k, n = self.lam - 1, self.lam + 1
        return self.v0 / self.a * (self.c * mp.exp(-k * s) / k + self.s * mp.exp(-n * s) / n)

    def speed(self, s):
        return self.v0 * (self.c * mp.exp((1 - self.lam) * s) + self.s * mp.exp((-1 - self.lam) * s))

    def velocity(self, s):
        c, d = self.c * mp.exp((1 - self.lam) * s), self.s * mp.exp((-1 - self.lam) * s)
        return self.v0 * (c - d), self.v0 * mp.sin(self.theta0) * mp.exp(-self.lam * s)

    def angle(self, s):
        return 2 * mp.atan(self.tan * mp.exp(-s))

    def place(self, s):
        """s may be infinite for lambda > 1."""

        def e(k):
            return 1 / k if s == mp.inf else spent(k, s)
        size, lam = self.v0**2 / self.a, self.lam
        x = self.c**2 * e(2 * lam - 2) - self.s**2 * e(2 * lam + 2)
        y = self.c * e(2 * lam - 1) + self.s * e(2 * lam + 1)
        return size * x, size * mp.sin(self.theta0) * y

    def when(self, t):
        """The s at a time before the stop."""
        if self.stop is not None and t > self.stop / 2:
            # The logarithm of what is left is nearly straight in s.
            wanted = mp.log(self.stop - t)

            def f(s):
                left = self.left(s)
                return mp.log(left) - wanted, -self.speed(s) / self.a / left
        else:
            wanted = mp.log(t)

            def f(s):
                passed = self.time(s)
                return wanted - mp.log(passed), -self.speed(s) / self.a / passed

        s = mpf(1) / 2
        while f(s)[0] < 0:
            s /= 2
        while f(2 * s)[0] > 0:
            s *= 2
        return root(f, s, 2 * s)


def on_line(lam, v0, a, t, backwards):
    """v, theta, stop at the time t of a launch along the pull or straight against it."""
    if not backwards:
        stop = v0 / (a * (lam - 1)) if lam > 1 else None
        still = stop is not None and stop <= t
        return mpf(0) if still else v0 + a * (1 - lam) * t, mpf(0), stop
    turn = v0 / (a * (1 + lam))
    if t < turn:
        return v0 - a * (1 + lam) * t, +mp.pi, turn if lam >= 1 else None
    if lam >= 1:
        return mpf(0), +mp.pi, turn
    return a * (1 - lam) * (t - turn), mpf(0), None


def place_on_line(lam, v0, a, t, backwards):
    """x at the time t of such a launch, piece by piece at the mean speed."""
    v, _, stop = on_line(lam, v0, a, t, backwards)
    if not backwards:
        return (v0 + v) / 2 * (t if stop is None else min(t, stop))
    turn = v0 / (a * (1 + lam))
    return -(v0 + v) / 2 * t if t < turn else v / 2 * (t - turn) - v0 / 2 * turn


def moved(lam, v0, theta0, a, at, moment):
    """v, theta, t, v_x, v_y, x, y, stop."""
    if theta0 in (0, PI):
        if at == "time":
            t = mpf(moment)
        elif moment == theta0:
            t = mpf(0)
        else:
            # It turns round and has the angle 0 from then on.
            assert theta0 == PI and moment == 0 and lam < 1
            t = v0 / (a * (1 + lam))
            return mpf(0), mpf(0), t, mpf(0), mpf(0), -v0 / 2 * t, mpf(0), None
        v, theta, stop = on_line(lam, v0, a, t, theta0 == PI)
        x = place_on_line(lam, v0, a, t, theta0 == PI)
        return v, theta, t, v if theta == 0 else -v, mpf(0), x, mpf(0), stop
    theta0 = mpf(theta0)
    launch = Launch(lam, a, v0, theta0)
    moment = mpf(moment)
    if moment == (0 if at == "time" else theta0):
        return v0, theta0, mpf(0), v0 * mp.cos(theta0), v0 * mp.sin(theta0), mpf(0), mpf(0), launch.stop
    if at == "theta":
        s, theta = mp.log(launch.tan / mp.tan(moment / 2)), moment
        t = launch.time(s)
    else:
        t = moment
        if launch.stop is not None and t >= launch.stop:
            return mpf(0), mpf(0), t, mpf(0), mpf(0), *launch.place(mp.inf), launch.stop
        s = launch.when(t)
        theta = launch.angle(s)
    return launch.speed(s), theta, t, *launch.velocity(s), *launch.place(s), launch.stop


def constant(lam, v0, theta0, a, at, moment):
    return moved(mpf(lam), mpf(v0), theta0, mpf(a), at, moment)


def sphere(gamma, u0, theta0, kappa, at, moment):
    gamma, u0, kappa = mpf(gamma), mpf(u0), mpf(kappa)
    u, theta, tau, ux, uy, _, _, rolls = moved((1 + 1 / kappa) / gamma, u0, theta0, gamma, at, moment)
    if tau == 0:
        zeta = [mpf(0), mpf(0)]
    else:
        x0 = -u0 if theta0 == PI else u0 * mp.cos(theta0)
        y0 = mpf(0) if theta0 == PI else u0 * mp.sin(theta0)
        zeta = [(uy - y0) / (kappa + 1), (gamma * tau - ux + x0) / (kappa + 1)]
    return u, theta, tau, ux, uy, *zeta, rolls


# Drives.


def slip_end(s, a):
    """Where a slip forwards ends that begins from rest at s in [0, pi], under sin phi and the friction a < 1."""

    def f(phi):
        return mp.cos(s) - mp.cos(phi) - a * (phi - s), mp.sin(phi) - a

    # From its fastest on it only slows down, and by 2 pi all is spent.
    return root(f, mp.pi - mp.asin(a), 2 * mp.pi)


def way(s, e, a):
    return mp.cos(s) * (e - s) + mp.sin(s) - mp.sin(e) - a * (e - s) ** 2 / 2


def top(s, a):
    """The largest velocity of a slip forwards."""
    phi = mp.pi - mp.asin(a)
    return mp.cos(s) - mp.cos(phi) - a * (phi - s)


def sinusoidal(lam):
    """regime, positive_start, positive_end, rest_fraction, w_max. Here w(phi + pi) = -w(phi)."""
    lam = mpf(lam)
    if lam >= 1:
        return "rest", None, None, mpf(1), mpf(0)
    if lam <= 2 / mp.sqrt(4 + mp.pi**2):
        # The momentum of half a period: 2 cos s = pi lambda; and at s the drive is above friction.
        s = mp.acos(mp.pi * lam / 2)
        return "two-zeros", s, s + mp.pi, mpf(0), top(s, lam)
    s = mp.asin(lam)
    e = slip_end(s, lam)
    return "two-rests", s, e, (mp.pi + s - e) / mp.pi, top(s, lam)


def pulse(eta, lam):
    """The same under h = 1 for the part eta of half a period, 0 for the rest, and the opposite half a period later."""
    eta, lam = mpf(eta), mpf(lam)
    if lam >= 1 or eta == 0:
        return "rest", None, None, mpf(1), mpf(0)
    if lam > eta:
        # It gains (1 - lambda) eta pi and loses it at the rate lambda.
        return "two-rests", mpf(0), mp.pi * eta / lam, 1 - eta / lam, (1 - lam) * eta * mp.pi
    # From s to s + pi: eta pi - s forwards, s of the next pulse backwards, lambda pi to friction.
    s = mp.pi * (eta - lam) / 2
    return "two-zeros", s, s + mp.pi, mpf(0), (1 - lam) * (eta * mp.pi - s)


def slips(a, b):
    """The slips of a period of the large-time motion under sin phi, in order: sign, start, end."""
    # Without rest?
    k = mp.pi * b / (a + b)
    sine = a * k / mp.sin(k)
    if sine <= 1:
        m = mp.pi - mp.asin(sine)
        s, e = m - k, m + k
        if mp.sin(s) >= a and mp.sin(e) <= -b:
            return [(1, s, e), (-1, e, s + 2 * mp.pi)]
    # From rest on, until it begins to slip from rest where it has begun so before. `turn` counts periods.
    turn, phi, found, begun = 0, mpf(0), [], {}
    while len(found) < 20_000:
        # At rest at phi, in [0, 2 pi).
        if mp.sin(phi) > a:
            sign, start, at_once = 1, phi, True
        elif mp.sin(phi) < -b:
            sign, start, at_once = -1, phi, True
        else:
            times = []
            if a < 1:
                times += [(mp.asin(a), 1), (mp.asin(a) + 2 * mp.pi, 1)]
            if b < 1:
                times += [(mp.asin(b) + mp.pi, -1), (mp.asin(b) + 3 * mp.pi, -1)]
            if not times:
                return []
            start, sign = min(pair for pair in times if pair[0] >= phi)
            at_once = False
            if start >= 2 * mp.pi:
                start, turn = start - 2 * mp.pi, turn + 1
            if sign in begun:
                index, before = begun[sign]
                assert turn == before + 1
                return found[index:]
            begun[sign] = len(found), turn
        end = slip_end(start, a) if sign > 0 else slip_end(start - mp.pi, b) + mp.pi
        found.append((sign, start + 2 * mp.pi * turn, end + 2 * mp.pi * turn))
        phi = end
        if phi >= 2 * mp.pi:
            phi, turn = phi - 2 * mp.pi, turn + 1
    raise ArithmeticError("never at rest")


def period(q, lam):
    """region, positive, negative, rest_after_positive, rest_after_negative, drift, largest |w|."""
    a, b = mpf(lam), mpf(q) * mpf(lam)
    found = slips(a, b)
    if not found:
        return "V", mpf(0), mpf(0), 2 * mp.pi, mpf(0), mpf(0), mpf(0)
    length, rest, drift, most, rests = {1: mpf(0), -1: mpf(0)}, {1: mpf(0), -1: mpf(0)}, mpf(0), mpf(0), 0
    for i, (sign, s, e) in enumerate(found):
        after = found[i + 1][1] if i + 1 < len(found) else found[0][1] + 2 * mp.pi
        friction = a if sign > 0 else b
        # Moved to begin in the first half period.
        back = 2 * mp.pi * mp.floor(s / (2 * mp.pi)) + (0 if sign > 0 else mp.pi)
        length[sign] += e - s
        if abs(after - e) > mpf(10) ** (20 - mp.dps):
            rest[sign] += after - e
            rests += 1
        drift += sign * way(s - back, e - back, friction)
        most = max(most, top(s - back, friction))
    if len(found) == 1:
        region = "IV"
    else:
        assert [sign for sign, *_ in found] in ([1, -1], [-1, 1])
        region = ("I", "II", "III")[rests]
    if a == b:
        # There and back are mirror images.
        drift = mpf(0)
    return region, length[1], length[-1], rest[1], rest[-1], drift, most


def anisotropic(q, lam):
    """The fields. The drift is what it is, also where it is below the rounding of the ways there and back; lambda- is
    the exact product."""
    return period(q, lam)[:6]


# The index of values: from the meanings.


def values():
    """id and value; those of the turntable's motion are missing: critical-radius, critical-speed, boundary."""
    third = mpf(1) / 3
    two, pi, ln, sqrt = mpf(2), +mp.pi, mp.log, mp.sqrt
    inverse, half = 1 / pi, 1 / sqrt(two)
    # B and C touch where the slip from rest at asin(1/q) ends at 3 pi/2, with friction just held: then cos s =
    # (3 pi/2 - s)/q with sin s = 1/q, so that x = 3 pi/2 - s has x = sqrt(q^2 - 1) and tan x = x.
    x = mp.findroot(lambda x: mp.sin(x) - x * mp.cos(x), mpf("4.4934"))
    q = sqrt(1 + x**2)
    # On B lambda0 q = -sin e. From Y: e = 3 pi/2 + d, 1/q - lambda0 = d^2/(2q), and the slip's equation gives
    # dq/dd = q (q+1)/x.
    contact = x**2 / (2 * q**3 * (q + 1) ** 2)
    # Escape in the laboratory: R'' = i R/|R| at late times; R = c tau^(2 + ik) has (2 + ik)(1 + ik)|c| = i, so k^2 = 2,
    # |c| = 1/(3k). Then p = rho = |c| tau^2, A^2/2 = s = |c| tau^3/3, e^alpha = 2p/A. The next term of the friction's
    # direction, exp(2i/tau), is in resonance with a shift of tau: the shift is -(3 sqrt 2/4) ln tau.
    c = 1 / (3 * sqrt(two))
    big_a = sqrt(2 * c / 3)
    # The boundary: with p = A sinh alpha, rho = A cosh alpha the motion is A' = sinh alpha, alpha' = cos psi -
    # cosh alpha/A, psi' = 2 - 2 sin psi coth 2 alpha. The line into A = 1, alpha = 0 has psi = 2 alpha + ..., A =
    # 1 - alpha + a alpha^2 with 3 a = 7/2. At other psi, to first order, A stays while d alpha/d psi = alpha
    # tan(psi/2), so that 1 - A = alpha cos^2(psi/2).
    slope, curvature = mp.cos(pi / 4) ** 2, mpf(7) / 6
    alpha = mpf(1) / 10
    near, far = mp.cos(alpha), mp.sin(alpha)
    bend = curvature * near**4 + 2 * far * near**3 - (far * near) ** 2 + 2 * far**3 * near / 3 - far**4 / 4
    return [
        ("lambda-c", 2 / sqrt(4 + pi**2)),
        ("fig-3-start", mp.acos(pi * inverse / 2)),
        ("fig-3-largest", sinusoidal(inverse)[4]),
        ("fig-4-largest", sinusoidal(half)[4]),
        ("y-q-printed", mpf(4603) / 1000),
        ("y-lambda-printed", mpf(217) / 1000),
        ("y-q", q),
        ("y-lambda", 1 / q),
        ("contact", contact),
        ("b-solid", 1 + mpf(5) / 2),
        ("b-hollow", 1 + mpf(3) / 2),
        ("slip-end", mpf(14) / 33),
        ("a-printed", 2 / sqrt(mpf(27))),
        ("a", big_a),
        ("alpha-printed", ln(4 * third) / 2),
        ("alpha", ln(2 * c / big_a)),
        ("p-printed", two / 9),
        ("p", c),
        ("s-printed", two / 27),
        ("s", c / 3),
        ("turn", mp.exp(2 * pi / sqrt(two))),
        ("delay", 3 * sqrt(two) / 4),
        ("envelope", (1 - mpf(1) / 10 / sqrt(two)) ** 2),
        ("boundary-slope", slope),
        ("phi-1", mp.asin(half)),
        ("phi-2", pi - mp.asin(half)),
        ("phi-3", pi + mp.asin(half)),
        ("phi-4", 2 * pi - mp.asin(half)),
        ("fig-3-friction", inverse),
        ("fig-4-friction", half),
        ("y-root", x),
        ("boundary-curvature", curvature),
        ("boundary-least", 1 - alpha + curvature * alpha**2),
        ("boundary-series", 1 - alpha * near**2 + bend * alpha**2),
    ]


# What is asked.


def log_uniform(rng, low, high):
    return min(max(10 ** rng.uniform(math.log10(low), math.log10(high)), low), high)


def near(rng, value, most=16):
    """value (1 +- 10^-k)."""
    return value * (1 + rng.choice((-1, 1)) * 10.0 ** -rng.randint(1, most))


def choose(rng, *weighted):
    """One of several ways to choose, by weight."""
    ways = [way for _, way in weighted]
    return rng.choices(ways, [weight for weight, _ in weighted])[0]()


def ask_size(rng):
    return choose(
        rng,
        (80, lambda: log_uniform(rng, 1e-3, 1e3)),
        (5, lambda: 1.0),
        (12, lambda: log_uniform(rng, 1e-20, 1e20)),
        (3, lambda: rng.choice((1e-20, 1e20))),
    )


def ask_theta0(rng):
    def against():
        angle = PI - 10.0 ** -rng.randint(1, 15)
        return rng.choice((angle, -angle))

    return choose(
        rng,
        (50, lambda: rng.uniform(-PI, PI)),
        (12, lambda: rng.choice((-1, 1)) * 10.0 ** -rng.randint(1, 16)),
        (8, lambda: rng.choice((-1, 1)) * 10.0 ** -rng.randint(17, 150)),
        (14, against),
        (1, lambda: rng.choice((-1, 1)) * math.nextafter(PI, 0)),
        (2, lambda: rng.choice((-1, 1)) * near(rng, PI / 2)),
        (5, lambda: 0.0),
        (8, lambda: PI),
    )


def ask_moment(rng, lam, v0, theta0, a):
    """theta or time, and which; lam may be rounded."""
    sign = math.copysign(1.0, theta0)
    if rng.random() < 0.5:
        if theta0 == 0:
            return "theta", 0.0
        if theta0 == PI:
            return "theta", rng.choice((PI, 0.0)) if lam < 1 else PI
        while True:
            theta = choose(
                rng,
                (45, lambda: theta0 * rng.random()),
                (20, lambda: theta0 * (1 - 10.0 ** -rng.randint(1, 16))),
                (20, lambda: sign * 10.0 ** -rng.randint(10, 140)),
                (10, lambda: theta0 * 10 ** -rng.uniform(0, 20)),
                (5, lambda: theta0),
            )
            if 0 < abs(theta) <= abs(theta0):
                return "theta", theta
    if theta0 == PI:
        # The stop or the turn.
        end = v0 / (a * (1 + lam))
    elif lam > 1:
        end = v0 / a * (math.cos(theta0 / 2) ** 2 / (lam - 1) + math.sin(theta0 / 2) ** 2 / (lam + 1))
    else:
        end = v0 / a
    time = choose(
        rng,
        (35, lambda: v0 / a * 10 ** rng.uniform(-3, 3)),
        (10, lambda: v0 / a * 10 ** rng.uniform(-12, 12)),
        (25, lambda: near(rng, end, 15)),
        (18, lambda: end * rng.random()),
        (9, lambda: end * 10 ** rng.uniform(0, 3)),
        (3, lambda: 0.0),
    )
    return "time", min(time, 1e40)


def ask_constant(rng):
    lam = choose(
        rng,
        (8, lambda: 0.0),
        (45, lambda: log_uniform(rng, 1e-3, 1e3)),
        (10, lambda: rng.uniform(0, 3)),
        (7, lambda: log_uniform(rng, 1e-20, 1e20)),
        (25, lambda: near(rng, 1.0)),
        (5, lambda: 1.0),
    )
    v0, theta0, a = ask_size(rng), ask_theta0(rng), ask_size(rng)
    return lam, v0, theta0, a, *ask_moment(rng, lam, v0, theta0, a)


def ask_sphere(rng):
    kappa = choose(
        rng,
        (25, lambda: 0.4),
        (10, lambda: 2 / 3),
        (10, lambda: 2.0 ** -rng.randint(0, 9)),
        (5, lambda: rng.choice((1e-3, 1.0, math.nextafter(1e-3, 1), math.nextafter(1, 0)))),
        (50, lambda: log_uniform(rng, 1e-3, 1)),
    )
    b = 1 + 1 / kappa
    gamma = choose(
        rng,
        (45, lambda: log_uniform(rng, 1e-3, 1e3)),
        (10, lambda: rng.uniform(0, 3) * b),
        (12, lambda: log_uniform(rng, 1e-15, 1e9)),
        (3, lambda: rng.choice((1e-15, 1e9))),
        (25, lambda: near(rng, b)),
        (5, lambda: b),
    )
    u0, theta0 = ask_size(rng), ask_theta0(rng)
    lam = float((1 + 1 / mpf(kappa)) / mpf(gamma))
    return gamma, u0, theta0, kappa, *ask_moment(rng, lam, u0, theta0, gamma)


def ask_sinusoidal(rng):
    lam = choose(
        rng,
        (40, lambda: log_uniform(rng, 1e-6, 1)),
        (15, lambda: rng.random()),
        (20, lambda: near(rng, 2 / math.sqrt(4 + PI**2))),
        (17, lambda: near(rng, 1.0)),
        (1, lambda: rng.choice((1e-6, 1.0, 1e6, 2 / math.sqrt(4 + PI**2)))),
        (7, lambda: log_uniform(rng, 1, 1e6)),
    )
    return (min(max(lam, 1e-6), 1e6),)


def ask_pulse(rng):
    eta = choose(
        rng,
        (60, lambda: rng.random()),
        (15, lambda: log_uniform(rng, 1e-12, 1)),
        (10, lambda: 1 - 10.0 ** -rng.randint(1, 16)),
        (10, lambda: 1.0),
        (5, lambda: 0.0),
    )
    lam = choose(
        rng,
        (35, lambda: rng.random()),
        (15, lambda: log_uniform(rng, 1e-6, 1)),
        (25, lambda: near(rng, eta)),
        (5, lambda: eta),
        (15, lambda: near(rng, 1.0)),
        (5, lambda: log_uniform(rng, 1, 1e6)),
    )
    return eta, min(max(lam, 1e-6), 1e6)


def on_b(a):
    """The q at which a slip forwards under the friction a ends where friction just holds: the curves B and E."""
    with mp.workdps(30):
        return float(-mp.sin(slip_end(mp.asin(a), mpf(a))) / a)


def on_a(q):
    """The friction up to which there is no rest: sin(m - K) = a, solved for a."""
    with mp.workdps(40):
        k = mp.pi * q / (1 + mpf(q))
        return float(mp.sin(k) / mp.sqrt(k**2 + (1 - k * mp.cot(k)) ** 2))


# The q of the point Y, where the borders B, C and E meet; its friction is 1/q.
Y = 4.6033388487517


def ask_anisotropic(rng, highest=1e3, least=1e-6, deep=15, mirrored=0.15):
    """q above 1, or its mirror image; the borders are blurred by 10^-deep at least."""

    def ratio():
        return choose(
            rng,
            (40, lambda: log_uniform(rng, 1, highest)),
            (30, lambda: rng.uniform(1, 8)),
            (12, lambda: 1 + 10.0 ** -rng.randint(1, deep)),
            (5, lambda: 1.0),
            (13, lambda: near(rng, Y, deep)),
        )

    def border_b():
        a = log_uniform(rng, max(1.3e-5, least), 0.537)
        q = on_b(a)
        return rng.choice(((q, near(rng, a, deep)), (near(rng, q, deep), a)))

    def between():
        # Between B and C: two rests.
        a = rng.uniform(0.22, 0.537)
        q = on_b(a)
        return q, rng.uniform(a, 1 / q)

    def border(curve):
        q = ratio()
        return q, near(rng, curve(q), deep)

    while True:
        q, lam = choose(
            rng,
            (15, lambda: (ratio(), log_uniform(rng, 1e-3, 1))),
            (15, lambda: (ratio(), rng.uniform(0, 1.2))),
            (8, lambda: (ratio(), log_uniform(rng, least, 1e-3))),
            (15, lambda: border(on_a)),
            (18, border_b),
            (12, lambda: border(lambda q: 1 / q)),
            (7, lambda: border(lambda q: 1.0)),
            (7, lambda: (near(rng, Y, deep), near(rng, 1 / Y, deep))),
            (8, between),
            (3, lambda: (ratio(), log_uniform(rng, 1, 1e6))),
        )
        if rng.random() < mirrored:
            q, lam = 1 / q, q * lam
        fits = (1 if mirrored == 0 else 1 / highest) <= q <= highest
        if fits and least <= lam <= 1e6 and 1e-6 <= q * lam <= 1e6:
            return q, lam


STATE = "v,theta,t,vx,vy,x,y,stop_time"
SWING = "regime,positive_start,positive_end,rest_fraction,w_max"
KINDS = [
    ("constant", ask_constant, constant, f"lambda,v0,theta0,accel,at,moment,{STATE}", ROWS),
    (
        "sphere",
        ask_sphere,
        sphere,
        "gamma,u0,theta0,kappa,at,moment,u,theta,tau,u_x,u_y,zeta_x,zeta_y,rolls_at",
        ROWS,
    ),
    ("sinusoidal", ask_sinusoidal, sinusoidal, f"lambda0,{SWING}", ROWS),
    ("pulse", ask_pulse, pulse, f"eta,lambda0,{SWING}", ROWS),
    (
        "anisotropic",
        ask_anisotropic,
        anisotropic,
        "q,lambda0,region,positive,negative,rest_after_positive,rest_after_negative,drift_per_period",
        ROWS,
    ),
]


def write(name, header, rows):
    with open(HERE / f"{name}.csv", "w", newline="") as file:
        out = csv.writer(file, lineterminator="\n")
        out.writerow(header.split(","))
        out.writerows(rows)


def make(name, ask, answer, header, count):
    rng = random.Random(f"20 {name}")
    began, rows, skipped = time.time(), [], 0
    while len(rows) < count:
        given = ask(rng)
        try:
            row = [text(x) for x in (*given, *sure(answer, *given))]
        except ArithmeticError:
            # A number that is exactly zero has no relative precision.
            row = [None]
        if None in row:
            skipped += 1
            continue
        rows.append(row)
    write(name, header, rows)
    print(f"{name}: {count} rows, {skipped} beyond the doubles, {time.time() - began:.0f} s", flush=True)


# Checks of the closed forms by the equations of motion themselves, at random places. Once, by hand, whole files were
# checked too: constant.csv and sphere.csv by the integrals v (lambda + cos theta) - A (1 - lambda^2) t and v sin theta/
# tan(theta/2)^lambda, to the rounding of the doubles; sinusoidal.csv, pulse.csv and anisotropic.csv by `stepped`, at
# frictions above 0.1, to 0.003.


def same(one, other, tolerance):
    assert all(abs(a - b) <= tolerance * max(1, abs(b)) for a, b in zip(one, other, strict=True)), (one, other)


def check_launches(rng):
    """Velocity and place by a Taylor integration of Newton's law, in the time and in s; the sphere with its spin."""
    for _ in range(24):
        lam, theta0 = mpf(rng.uniform(0, 2.5)), mpf(rng.uniform(-3.1, 3.1))
        launch = Launch(lam, mpf(1.25), mpf("0.8"), theta0)
        t = mpf(rng.uniform(0.1, 0.7)) * (launch.stop or 2)

        def law(_, state):
            vx, vy, x, y = state
            v = mp.sqrt(vx**2 + vy**2)
            return [launch.a * (1 - lam * vx / v), -launch.a * lam * vy / v, vx, vy]

        start = [launch.v0 * mp.cos(theta0), launch.v0 * mp.sin(theta0), 0, 0]
        s = launch.when(t)
        vx, vy = launch.velocity(s)
        same([vx, vy, *launch.place(s)], mp.odefun(law, 0, start)(t), mpf(10) ** -20)
        same([launch.speed(s), launch.angle(s)], [mp.hypot(vx, vy), mp.atan2(vy, vx)], mpf(10) ** -20)
    for _ in range(8):
        # To the stop, in s, where the law is linear: what is left at s = 60/(lambda - 1) is e^-60 of it.
        lam, theta0 = mpf(rng.uniform(1.4, 3)), mpf(rng.uniform(-3.1, 3.1))
        launch = Launch(lam, mpf(1), mpf(1), theta0)

        def law(_, state):
            vx, vy = state[:2]
            v = mp.sqrt(vx**2 + vy**2)
            return [v - lam * vx, -lam * vy, v, v * vx, v * vy]

        end = mp.odefun(law, 0, [mp.cos(theta0), mp.sin(theta0), 0, 0, 0])(60 / (lam - 1))
        same([0, 0, launch.stop, *launch.place(mp.inf)], end, mpf(10) ** -20)
    for _ in range(16):
        gamma, kappa, theta0 = rng.uniform(0.1, 9), rng.uniform(0.1, 1), rng.uniform(-3.1, 3.1)
        spare = 1 + 1 / kappa - gamma
        tau = 0.7 / (1 + 1 / kappa + gamma) if spare < 1 else 0.5 / (1 + 1 / kappa)

        def law(_, state):
            # v and zeta in three dimensions, m = R = mu g = 1; the lowest point is at -z.
            v, zeta = state[:3], state[3:]
            arm = [0, 0, -1]
            slip = [v[i] + cross(zeta, arm)[i] for i in range(2)]
            force = [-c / mp.hypot(*slip) for c in slip] + [0]
            pull = [force[0] + gamma, force[1], 0]
            return pull + [c / kappa for c in cross(arm, force)]

        end = mp.odefun(law, 0, [mp.cos(theta0), mp.sin(theta0), 0, 0, 0, 0])(tau)
        _, _, _, ux, uy, zx, zy, _ = sphere(gamma, 1, theta0, kappa, "time", tau)
        same([end[0] - end[4], end[1] + end[3], end[3], end[4]], [ux, uy, zx, zy], mpf(10) ** -20)


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def stepped(h, plus, minus, periods=40, n=4000):
    """Lengths forwards and backwards, way and largest |w| of the last period, by steps in which friction takes from
    w what it can (doubles, right to about a step): no event is looked for."""
    step, w = 2 * PI / n, 0.0
    for p in range(periods):
        forwards = backwards = most = travelled = 0.0
        for i in range(n):
            w += step * h((i + 0.5) * step)
            w = max(w - step * plus, 0.0) if w > 0 else min(w + step * minus, 0.0)
            if w > 0:
                forwards += step
            elif w < 0:
                backwards += step
            travelled += step * w
            most = max(most, abs(w))
    return forwards, backwards, travelled, most


def check_drives(rng):
    for _ in range(40):
        q, lam = ask_anisotropic(rng, highest=8.0, least=0.05, deep=2, mirrored=0.3)
        region, forwards, backwards, *_, drift, most = period(q, lam)
        found = stepped(math.sin, lam, q * lam)
        same(found, [forwards, backwards, drift, most], 0.02)
        # The momentum of a slip vanishes at its end and not before, its way is the integral of its velocity, and a
        # rest is one: by quadrature.
        a, b = mpf(lam), mpf(q) * mpf(lam)
        total = mpf(0)
        slipped = slips(a, b)
        for i, (sign, s, e) in enumerate(slipped):
            friction = a if sign > 0 else -b
            rate = lambda phi: mp.sin(phi) - friction
            same([mp.quad(rate, [s, (s + e) / 2, e])], [0], mpf(10) ** -20)
            assert all(sign * mp.quad(rate, [s, s + (e - s) * j / 8]) > 0 for j in range(1, 8))
            total += mp.quad(lambda phi: (e - phi) * rate(phi), [s, (s + e) / 2, e])
            until = slipped[i + 1][1] if i + 1 < len(slipped) else slipped[0][1] + 2 * mp.pi
            inside = [e + (until - e) * j / 8 for j in range(1, 8)]
            assert until - e < 1e-18 or all(-b <= mp.sin(phi) <= a for phi in inside)
        same([total], [drift], mpf(10) ** -20)
    for _ in range(16):
        lam = rng.uniform(0.05, 1.1)
        regime, start, end, rest, most = sinusoidal(lam)
        forwards, backwards, _, found = stepped(math.sin, lam, lam)
        expected = [0, 0, 0] if regime == "rest" else [end - start, end - start, most]
        same([forwards, backwards, found], expected, 0.02)
        same([1 - (forwards + backwards) / (2 * PI)], [rest], 0.02)
        eta = rng.random()
        _, start, end, rest, most = pulse(eta, lam)
        h = lambda phi: (1 if phi < PI else -1) * (1 if phi % PI < eta * PI else 0)
        forwards, backwards, _, found = stepped(h, lam, lam)
        same([1 - (forwards + backwards) / (2 * PI), found], [rest, most], 0.02)


def check_contact():
    """How B leaves C at Y, from the curve itself."""
    known = dict(values())
    d = mpf(10) ** -12
    a = known["y-lambda"] - d**2
    q = -mp.sin(slip_end(mp.asin(a), a)) / a
    found = (1 / q - a) / (q - known["y-q"]) ** 2
    same([found / known["contact"]], [1], mpf(10) ** -5)


def checks():
    with mp.workdps(30):
        rng = random.Random("20 checks")
        check_launches(rng)
        check_drives(rng)
    with mp.workdps(80):
        check_contact()
    print("the closed forms agree with the equations of motion")


def main():
    checks()
    if sys.argv[1:] == ["checks"]:
        return
    for kind in KINDS:
        make(*kind)
    with mp.workdps(80):
        write("values", "id,value", [(name, mp.nstr(x, 40, strip_zeros=False)) for name, x in values()])


main()
