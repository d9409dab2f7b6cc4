"""Reference values for a particle on a rough turntable, for the tests of the motions:

    x'' = x + 2 v cross z - v/|v|        (axes of the table, dimensionless)

turntable-rest.csv      400 starts: rest or escape, place and time of rest
turntable-time.csv      400 starts: the state at a given time
turntable-boundary.csv   60 starts between rest and escape
constants.csv           two critical starts

A start is (rho, p, psi): position (rho, 0), velocity p (cos psi, -sin psi). Inputs are doubles and mean exactly what
they are; outputs are the doubles nearest to the result, but for A in turntable-boundary.csv and the constants, which
have 30 digits. gap is 1 - sigma, good to its own last digit; sigma, gap, tau_rest are empty for an escape.

How: Newton's law in Cartesian axes of the table, in the variable s (dtau = p ds), by Taylor series; escapes in axes at
rest, in tau, by Taylor series; the stiff motion near rest (p, |1 - rho cos psi| small) in 1 - rho, psi/p and p by Radau
collocation in tau, at last in p. None of it uses the variables (p, w, zeta), but for the series of the border of rest
(border_curve), with which A, the constants and the starts near the border are found; the motions from 1e-17, 1e-22,
1e-27 (relative) beside every A and both constants do come to rest below and escape above.

How good: 60 digits are carried, 36 asked of every step. `check` computes everything again with other orders, steps,
tolerances and places of passing from one method to the other. Worst relative difference (components of the state one by
one): constants and boundary 1e-40, rest 3e-26, time 2e-22 (p_t just before rest); the written text is the same in every
place. Explicit Taylor steps alone, down to gap 9e-5, agree with the collocation to 32 digits. A different integrator in
quadruple precision, in (ln p, 1 - rho, psi) and in Cartesian axes at rest, gives the same for 184 of the rows of rest,
181 of the rows of time, and to 27 digits for (0.9999, 0.0001, 0), whose gap is 1.2e-6.

A start is to be taken as the double it is: 0.999999, 0.000001, 0 as doubles rest at 7.45704111, as decimals at
7.45706267.

Run: python turntable.py compute [folder]; python turntable.py check [folder]
Made with Python 3.11.7, gmpy2 2.3.2, mpmath 1.4.1, numpy 2.4.6; seed 20240. Seven and ten minutes.
"""

import csv
import math
import random
import sys
from operator import mul
import gmpy2
import mpmath
import numpy
from gmpy2 import mpfr, sqrt, sin, cos, atan2


class Precision:
    def __init__(self, bits, order, tol, stages, step, slow):
        gmpy2.get_context().precision = bits
        self.bits, self.order, self.tol = bits, order, mpfr(tol)
        self.stages, self.step, self.slow = stages, mpfr(step), mpfr(slow)
        self.nodes, self.weights = radau(stages, bits)


def radau(s, bits):
    """Nodes and matrix of the Radau IIA method of s stages on [0, 1]; its last row holds the weights."""
    with mpmath.workprec(2 * bits + 100):
        def poly(x):
            return mpmath.legendre(s, x) - mpmath.legendre(s - 1, x)
        c = numpy.polynomial.legendre.legroots([0] * (s - 1) + [-1, 1])
        tol = mpmath.mpf(2) ** (-2 * bits)
        c = [mpmath.findroot(poly, mpmath.mpf(float(x)), tol=tol) for x in sorted(c)[:-1]] + [mpmath.mpf(1)]
        c = [(1 + x) / 2 for x in c]
        a = mpmath.zeros(s, s)
        for j in range(s):  # integrate the Lagrange polynomials
            l = [mpmath.mpf(1)]
            for k in range(s):
                if k != j:
                    d = c[j] - c[k]
                    l = [(u - c[k] * v) / d for u, v in zip([mpmath.mpf(0)] + l, l + [mpmath.mpf(0)])]
            for i in range(s):
                a[i, j] = mpmath.polyval([v / (k + 1) for k, v in reversed(list(enumerate(l)))] + [0], c[i])
        text = lambda v: mpfr(mpmath.nstr(v, bits // 3))
        return [text(v) for v in c], [[text(a[i, j]) for j in range(s)] for i in range(s)]


def evaluate(series, h):
    total = mpfr(0)
    for c in reversed(series):
        total = total * h + c
    return total


def reach(series, scales, tol):
    """The step at which the last terms are smaller than tol."""
    n = len(series[0]) - 1
    h = []
    for j in (n, n - 1):
        big = max(abs(c[j]) / s for c, s in zip(series, scales))
        if big > 0:
            h.append((tol / big) ** (mpfr(1) / j))
    return min(h) * mpfr("0.9")


def table_series(x, y, a, b, order):
    """Taylor coefficients in s, where dtau = p ds, of position (x, y), velocity (a, b), speed p: axes of the table."""
    X, Y, A, B, P = [x], [y], [a], [b], [sqrt(a * a + b * b)]
    C, D, Q = [x + 2 * b], [y - 2 * a], [a * a + b * b]
    for n in range(order):
        p, m = P[::-1], n + 1
        X.append(sum(map(mul, p, A)) / m)
        Y.append(sum(map(mul, p, B)) / m)
        a1, b1 = (sum(map(mul, p, C)) - A[n]) / m, (sum(map(mul, p, D)) - B[n]) / m
        A.append(a1)
        B.append(b1)
        C.append(X[m] + 2 * b1)
        D.append(Y[m] - 2 * a1)
        q = sum(map(mul, A, A[::-1])) + sum(map(mul, B, B[::-1])) - sum(map(mul, P[1:], p[:-1]))
        P.append(q / (2 * P[0]))
    return X, Y, A, B, P


def room_series(x, y, u, v, order):
    """Taylor coefficients in tau in axes at rest: friction 1 against the velocity relative to the table."""
    X, Y, U, V = [x], [y], [u], [v]
    E, F = [u + y], [v - x]
    Q = [sqrt(E[0] ** 2 + F[0] ** 2)]
    M, N = [E[0] / Q[0]], [F[0] / Q[0]]
    for n in range(order):
        m = n + 1
        X.append(U[n] / m)
        Y.append(V[n] / m)
        U.append(-M[n] / m)
        V.append(-N[n] / m)
        E.append(U[m] + Y[m])
        F.append(V[m] - X[m])
        q = Q[:0:-1]
        square = sum(map(mul, E, E[::-1])) + sum(map(mul, F, F[::-1]))
        Q.append((square - sum(map(mul, Q[1:], q))) / (2 * Q[0]))
        q = Q[:0:-1]
        M.append((E[m] - sum(map(mul, M, q))) / Q[0])
        N.append((F[m] - sum(map(mul, N, q))) / Q[0])
    return X, Y, U, V, Q


def release_series(rho, order):
    """Taylor coefficients in tau of (x, y) and of velocity/tau, for a particle at rest at (rho, 0), rho > 1."""
    X, Y, A, B, G = [rho], [mpfr(0)], [rho - 1], [mpfr(0)], [rho - 1]
    M, N = [mpfr(1)], [mpfr(0)]  # the direction of the velocity
    # velocity = tau (A, B): (n+1) A_n = x_n + 2 B_{n-1} - M_n, (n+1) B_n = y_n - 2 A_{n-1} - N_n
    for n in range(1, order):
        X.append(A[n - 2] / n if n > 1 else mpfr(0))
        Y.append(B[n - 2] / n if n > 1 else mpfr(0))
        # |g|^2: G_n = A_n + r with r known; M_n G_0 = A_n - G_n - rest = -r - rest; N_n = (B_n - rest) / G_0
        r = sum(map(mul, A[1:], A[:0:-1])) + sum(map(mul, B[1:], B[:0:-1])) - sum(map(mul, G[1:], G[:0:-1]))
        r /= 2 * G[0]
        mn = (-r - sum(map(mul, M[1:], G[:0:-1]))) / G[0]
        nr = sum(map(mul, N[1:], G[:0:-1]))
        a = (X[n] + 2 * B[n - 1] - mn) / (n + 1)
        b = (Y[n] - 2 * A[n - 1] + nr / G[0]) / (n + 1 + 1 / G[0])
        A.append(a)
        B.append(b)
        G.append(a + r)
        M.append(mn)
        N.append((b - nr) / G[0])
    return X, Y, A, B


def sinc(x):
    return sin(x) / x if x else mpfr(1)


def slow_rates(delta, p, phi):
    """w, Psi = dpsi/dtau, and the rate of the azimuth, for psi = p phi."""
    psi, rho = p * phi, 1 - delta
    half = sin(psi / 2)
    w = delta + 2 * rho * half * half
    c = phi * sinc(psi)
    return w, 2 - p * p * c / rho - rho * c, -p * p * c / rho, cos(psi)


def by_time(x, y, k):
    """Residuals with tau as the variable; y = (delta, phi, p), k their rates."""
    w, Psi, _, c = slow_rates(y[0], y[2], y[1])
    return k[0] + y[2] * c, y[2] * k[1] - Psi - y[1] * w, k[2] + w


def by_speed(x, y, k):
    """Residuals with the speed as the variable; y = (delta, phi, tau)."""
    w, Psi, _, c = slow_rates(y[0], x, y[1])
    return k[0] * w - x * c, w * (y[1] + x * k[1]) + Psi, k[2] * w + 1


def collocate(residual, x, y, h, k, scales, prec):
    """One step of length h from (x, y); k is a guess of the rates. Newton's method with a Jacobian in doubles."""
    s, A = prec.stages, prec.weights
    K = [list(k) for _ in range(s)]
    xs = [x + h * c for c in prec.nodes]
    eps = mpfr(2) ** (-prec.bits // 2)
    for turn in range(60):
        cols = list(zip(*K))
        Y = [[y[m] + h * sum(map(mul, A[i], cols[m])) for m in range(3)] for i in range(s)]
        R = [residual(xs[i], Y[i], K[i]) for i in range(s)]
        if turn < 3:
            J = numpy.zeros((s, 3, s, 3))
            for i in range(s):
                for m in range(3):
                    d = eps * scales[m][0]
                    yy = list(Y[i])
                    yy[m] += d
                    dy = [float((u - v) / d * scales[m][1] * h) for u, v in zip(residual(xs[i], yy, K[i]), R[i])]
                    d = eps * scales[m][1]
                    kk = list(K[i])
                    kk[m] += d
                    dk = [float((u - v) / d * scales[m][1]) for u, v in zip(residual(xs[i], Y[i], kk), R[i])]
                    for q in range(3):
                        J[i, q, i, m] += dk[q]
                        for j in range(s):
                            J[i, q, j, m] += dy[q] * float(A[i][j])
            rows = 1 / numpy.abs(J).reshape(s * 3, s * 3).max(axis=1)
            inverse = numpy.linalg.inv(J.reshape(s * 3, s * 3) * rows[:, None])
            rows = [mpfr(v) for v in rows]
        flat = [v * r for v, r in zip((v for r in R for v in r), rows)]
        big = max(abs(v) for v in flat)
        if big == 0:
            break
        step = inverse @ numpy.array([float(v / big) for v in flat])
        size = float(numpy.abs(step).max()) * big
        for i in range(s):
            for m in range(3):
                K[i][m] -= mpfr(step[3 * i + m]) * big * scales[m][1]
        if size < prec.tol * mpfr("1e-4"):
            break
    else:
        raise ArithmeticError("no convergence")
    cols = list(zip(*K))
    Y = [[y[m] + h * sum(map(mul, A[i], cols[m])) for m in range(3)] for i in range(s)]
    return xs, Y, K[-1]


class Run:
    """The motion from (rho, p, psi) to rest, to escape, or to the time `until`."""

    def __init__(self, rho, p, psi, prec, until=None):
        gmpy2.get_context().precision = prec.bits
        self.prec, self.until = prec, None if until is None else mpfr(until)
        rho, p, psi = mpfr(rho), mpfr(p), mpfr(psi)
        self.tau, self.steps, self.collocations = mpfr(0), 0, 0
        self.state = [rho, mpfr(0), p * cos(psi), -p * sin(psi)]
        self.outcome = None
        if until == 0:
            return
        if p == 0:
            if rho <= 1:
                self.rest_at(1 - rho, self.tau)
                return
            self.release(rho)
        entered, s = None, mpfr(0)
        while not self.done():
            rho, p, w = self.measures()
            delta = 1 - rho
            if until is None and w <= 0:
                self.outcome = "escape"
                return
            if w < 0 and p > mpfr("0.5"):
                self.room()
                return
            if p < 0.05 and abs(w) < 0.05:
                entered = s if entered is None else entered
            else:
                entered = None
            if entered is not None and s - entered > 85 and p < prec.slow and abs(w) < 1.5 * prec.slow:
                self.slow()
                entered = None
                continue
            if delta > 0 and w > 0 and p < mpfr("0.7") * delta:
                r, tol = p / w, mpfr("1e-25")
                late = r * (p / delta ** 2 + abs(w - delta) / delta)
                if late < tol * (self.tau + r) and p * r < tol * min(delta, rho):
                    if until is None or self.tau + r * (1 + tol) < self.until:
                        self.rest_at(delta, self.tau + r)
                        return
            s += self.step()

    @classmethod
    def at(cls, state, prec):
        """Not yet under way, at the position and velocity given."""
        gmpy2.get_context().precision = prec.bits
        run = cls.__new__(cls)
        run.prec, run.until, run.state, run.tau, run.outcome, run.steps = prec, None, list(state), mpfr(0), None, 0
        return run

    def measures(self):
        x, y, a, b = self.state
        rho, p = sqrt(x * x + y * y), sqrt(a * a + b * b)
        return rho, p, 1 - (x * a + y * b) / p

    def done(self):
        return self.outcome is not None or (self.until is not None and self.tau >= self.until)

    def rest_at(self, gap, tau):
        x, y = self.state[:2]
        rho = sqrt(x * x + y * y)
        self.outcome, self.gap, self.rest = "rest", gap, tau
        if rho:
            self.state = [x / rho * (1 - gap), y / rho * (1 - gap), mpfr(0), mpfr(0)]

    def step(self, limit=None):
        """One Taylor step, at most `limit` and not beyond the time `until`; its length in s."""
        self.steps += 1
        X, Y, A, B, P = series = table_series(*self.state, self.prec.order)
        h = reach(series[:4], [P[0]] * 4, self.prec.tol)
        h = h if limit is None else min(h, limit)
        T = [mpfr(0)] + [c / (k + 1) for k, c in enumerate(P)]
        if self.until is not None and self.tau + evaluate(T, h) > self.until:
            lo, hi, goal = mpfr(0), h, self.until - self.tau
            h = goal / P[0]
            for _ in range(200):
                f = evaluate(T, h) - goal
                lo, hi = (lo, h) if f > 0 else (h, hi)
                new = h - f / evaluate(P, h)
                new = new if lo < new < hi else (lo + hi) / 2
                if abs(new - h) <= h * mpfr(2) ** (-self.prec.bits + 10):
                    break
                h = new
            self.tau = self.until
        else:
            self.tau += evaluate(T, h)
        self.state = [evaluate(c, h) for c in series[:4]]
        return h

    def release(self, rho):
        series, g = release_series(rho, self.prec.order), rho - 1
        h = reach(series, [g] * 4, self.prec.tol)
        if self.until is None:
            self.outcome = "escape"
            return
        h = min(h, self.until)
        x, y, a, b = (evaluate(c, h) for c in series)
        self.state, self.tau = [x, y, a * h, b * h], h

    def room(self):
        """From here to the time `until` in axes at rest, which coincide with those of the table now."""
        x, y, a, b = self.state
        state, t, end = [x, y, a - y, b + x], mpfr(0), self.until - self.tau
        while t < end:
            self.steps += 1
            *series, Q = room_series(*state, self.prec.order)
            h = min(reach(series, [Q[0]] * 4, self.prec.tol), end - t)
            state = [evaluate(c, h) for c in series]
            t = end if h == end - t else t + h
        x, y, u, v = state
        c, s = cos(t), sin(t)
        turn = lambda x, y: [c * x + s * y, c * y - s * x]
        self.state, self.tau = turn(x, y) + turn(u + y, v - x), self.until

    def slow(self):
        """Collocation while p and w are small: variables delta = 1 - rho, phi = psi/p, p."""
        prec = self.prec
        x, y, a, b = self.state
        rho, p = sqrt(x * x + y * y), sqrt(a * a + b * b)
        delta, theta = 1 - rho, atan2(y, x)
        psi = atan2(a * y - b * x, a * x + b * y)
        Y, K = [delta, psi / p, p], [-p, mpfr(0), -delta]
        while True:
            delta, phi, p = Y
            w = slow_rates(delta, p, phi)[0]
            if p > mpfr("1.2") * prec.slow or abs(w) > 2 * prec.slow:
                break
            if self.until is None and w <= 0:
                self.outcome = "escape"
                return
            if self.until is not None and self.tau >= self.until:
                break
            if 4 * p < w:
                return self.finish(delta, phi, p, theta)
            h = prec.step
            if self.until is not None:
                h = min(h, self.until - self.tau)
            size = abs(w) + p
            scales = [(size, size), (mpfr(1), mpfr(1)), (p, size)]
            xs, Ys, K = collocate(by_time, self.tau, Y, h, K, scales, prec)
            theta += h * sum(map(mul, prec.weights[-1], [slow_rates(v[0], v[2], v[1])[2] for v in Ys]))
            last = self.until is not None and h == self.until - self.tau
            self.tau = self.until if last else self.tau + h
            Y = Ys[-1]
            self.collocations += 1
        self.cartesian(*Y, theta)

    def cartesian(self, delta, phi, p, theta):
        rho, chi = 1 - delta, theta - p * phi
        self.state = [rho * cos(theta), rho * sin(theta), p * cos(chi), p * sin(chi)]

    def finish(self, delta, phi, p, theta):
        """To rest, or to the time `until`, with the speed as the variable."""
        prec = self.prec
        w = slow_rates(delta, p, phi)[0]
        scales = [(w, mpfr(1)), (mpfr(1), 1 / w), (mpfr(1), 1 / w)]

        def to(end):
            k = [p / w, mpfr(0), -1 / w]
            xs, Ys, _ = collocate(by_speed, p, [delta, phi, mpfr(0)], end - p, k, scales, prec)
            rates = [slow_rates(v[0], q, v[1]) for q, v in zip(xs, Ys)]
            return Ys[-1], (end - p) * sum(map(mul, prec.weights[-1], [-r[2] / r[0] for r in rates]))

        self.collocations += 1
        (d, f, t), turn = to(mpfr(0))
        if self.until is None or self.tau + t < self.until:
            self.cartesian(d, f, mpfr(0), theta + turn)
            self.rest_at(d, self.tau + t)
            return
        goal = self.until - self.tau
        end = p - w * goal
        end = end if 0 < end else p * (1 - goal / t)
        for _ in range(60):
            (d, f, t), turn = to(end)
            step = (t - goal) * slow_rates(d, end, f)[0]
            end += step
            if abs(step) < end * prec.tol:
                break
        (d, f, t), turn = to(end)
        self.cartesian(d, f, end, theta + turn)
        self.tau = self.until

    def polar(self):
        x, y, a, b = self.state
        rho, p = sqrt(x * x + y * y), sqrt(a * a + b * b)
        psi = atan2(a * y - b * x, a * x + b * y) if p else mpfr(0)
        return rho, p, psi


# --- the border of rest ---------------------------------------------------------------------------------------------

def border_curve(p):
    """w on the border of rest for small p, on the slow motion: the series of p w w' = z^2, p w z' = p + z - w z."""
    w, z = [mpfr(0), mpfr(1)], [mpfr(0), mpfr(-1)]
    total, last = p, p
    for n in range(2, 150):
        zn = sum(w[i] * (n - i + 1) * z[n - i] for i in range(1, n))
        wn = (sum(z[i] * z[n + 1 - i] for i in range(2, n)) - 2 * zn) / (n + 1)
        wn -= sum(w[i] * w[n + 1 - i] for i in range(2, n)) / 2
        w.append(wn)
        z.append(zn)
        term = wn * p ** n
        if abs(term) > last:
            break
        total, last = total + term, abs(term)
    return total


def side(start, prec):
    """1 for a start (x, y, vx, vy) that comes to rest, -1 for one that escapes."""
    run = Run.at(start, prec)
    entered, s = None, mpfr(0)
    while True:
        rho, p, w = run.measures()
        if w <= 0:
            return -1
        if p < mpfr("0.7") * (1 - rho):  # the way left is shorter than (1 - rho)/2
            return 1
        entered = (s if entered is None else entered) if p < 0.05 and w < 0.05 else None
        if entered is not None and s - entered > 60 and p < 0.02:
            return 1 if w > border_curve(p) else -1
        s += run.step()


def border(start, lo, hi, prec, digits=35):
    """The value between lo (rest) and hi (escape, or the reverse) at which start(value) passes from one to the other."""
    gmpy2.get_context().precision = prec.bits
    lo, hi = mpfr(lo), mpfr(hi)
    low = side(start(lo), prec)
    assert side(start(hi), prec) != low
    while abs(hi - lo) > abs(hi) * mpfr("1e-8"):
        mid = (lo + hi) / 2
        lo, hi = (mid, hi) if side(start(mid), prec) == low else (lo, mid)

    def excess(value, end):
        """w minus its border at the time s = end; without end, at a good moment, with that moment."""
        run = Run.at(start(value), prec)
        entered, s = None, mpfr(0)
        while True:
            _, p, w = run.measures()
            if end is None:
                entered = (s if entered is None else entered) if p < 0.05 and abs(w) < 0.05 else None
                if entered is not None and s - entered > 90 and p < 0.0105:
                    return s
            elif s == end:
                return w - border_curve(p)
            s += run.step(None if end is None else end - s)

    end = excess((lo + hi) / 2, None)
    a, b = lo, hi
    fa, fb = excess(a, end), excess(b, end)
    for _ in range(12):
        new = b - fb * (b - a) / (fb - fa)
        a, fa = b, fb
        b, fb = new, excess(new, end)
        if fb == fa or abs(b - a) <= abs(b) * mpfr(10) ** -digits:
            return b
    raise ArithmeticError("no border")


# --- the files ------------------------------------------------------------------------------------------------------

def vector(rho, p, psi):
    rho, p, psi = mpfr(rho), mpfr(p), mpfr(psi)
    return rho, mpfr(0), p * cos(psi), -p * sin(psi)


def start_on_hyperbola(alpha, psi):
    alpha = mpfr(alpha)
    return lambda a: vector(a * gmpy2.cosh(alpha), a * gmpy2.sinh(alpha), psi)


def put_down(rho):
    return rho, mpfr(0), mpfr(0), -rho


def launched(p):
    return mpfr(0), mpfr(0), p, mpfr(0)


def generic(rng):
    return rng.uniform(0, 1.5), rng.uniform(0, 2), rng.uniform(-math.pi, math.pi)


def decades(rng, low, high):
    return 10 ** rng.uniform(low, high)


def close(rng, kind):
    """Near rest at rho = 1: p much smaller than, comparable to, or somewhat larger than 1 - rho."""
    rho = 1 - decades(rng, -12, -1)
    factors = [decades(rng, -8, -0.5), rng.uniform(0.3, 1), rng.uniform(0.99, 1.01), rng.uniform(1, 3), decades(rng, 0, 2)]
    p = (1 - rho) * factors[kind % 5]
    angles = [0.0, 2 * p * rng.uniform(0, 2), rng.uniform(-math.pi, math.pi), rng.gauss(0, 1) * math.sqrt(1 - rho),
              rng.uniform(-math.pi, math.pi)]
    return rho, p, angles[kind // 5 % 5]


def critical(rng, prec):
    """Near the border of rest, from afar: relative distance 1e-14 to 1e-3."""
    offset = 1 + rng.choice([-1, 1]) * decades(rng, -14, -3)
    while True:
        if rng.random() < 0.5:
            _, p, psi = generic(rng)
            low, high, start = 0.0, 3.0, lambda v: (v, p, psi)
        else:
            rho, _, psi = generic(rng)
            low, high, start = 1e-3, 5.0, lambda v: (rho, v, psi)
        if side(vector(*start(low)), prec) != side(vector(*start(high)), prec):
            return start(float(border(lambda v: vector(*start(v)), low, high, prec, 20) * mpfr(offset)))


def rest_starts(rng, prec):
    starts = [generic(rng) for _ in range(200)]
    starts += [close(rng, kind) for kind in range(100)]
    starts += [critical(rng, prec) for _ in range(50)]
    for kind in range(25):
        rho = [rng.uniform(0, 1), rng.uniform(1, 1.5), rng.uniform(0, 1), 1.0, rng.uniform(0, 1)][kind % 5]
        starts.append((rho, decades(rng, -30, -3), rng.uniform(-math.pi, math.pi)))
    for kind in range(25):
        rho = 0.0 if kind % 5 == 0 else decades(rng, -16, -1)
        p = rho * rng.uniform(0, 2) if kind % 5 == 1 else rng.uniform(0, 2)
        starts.append((rho, p, rng.uniform(-math.pi, math.pi)))
    starts[-1], starts[-26], starts[-27] = (0.7, 0.0, 0.5), (1.0, 0.0, 0.0), (1.25, 0.0, 1.0)
    return starts


def time_starts(rng, prec):
    starts = [generic(rng) for _ in range(110)]
    starts += [close(rng, kind) for kind in range(130)]
    starts += [critical(rng, prec) for _ in range(60)]
    starts += [(1 + decades(rng, -12, 0.3), 0.0, rng.uniform(-math.pi, math.pi)) for _ in range(58)]
    starts += [(0.8, 0.0, 1.0), (1.0, 0.0, 0.0)]
    rows = [(start, moment(rng, start, prec, k)) for k, start in enumerate(starts)]
    while len(rows) < 400:
        start = (1 + decades(rng, -6, 0.3), 0.0, 0.0) if len(rows) % 4 == 0 else generic(rng)
        if Run(*start, prec).outcome == "escape":
            rows.append((start, 1e5 if len(rows) % 3 == 0 else decades(rng, 2, 3)))
    return rows


def moment(rng, start, prec, k):
    run = Run(*start, prec)
    if run.outcome == "escape" or run.rest == 0:
        return decades(rng, -1, 1.3) if k % 2 else decades(rng, 0, 3)
    factors = [rng.uniform(0.05, 0.95), 1 - mpfr(decades(rng, -12, -1)), rng.uniform(0.5, 1), 1 + mpfr(decades(rng, -9, 0))]
    return float(run.rest * factors[k % 4])


def rest_row(start, prec):
    run = Run(*start, prec)
    if run.outcome == "escape":
        return "escape", "", "", ""
    return "rest", 1 - run.gap, run.gap, run.rest


def time_row(start, time, prec):
    run = Run(*start, prec, time)
    return *run.state, *run.polar()


def boundary_starts(rng):
    starts = [(alpha, psi) for alpha in (1e-6, 1e-3, 0.5, 10.0) for psi in (0.0, math.pi / 2, -math.pi / 2, math.pi)]
    return starts + [(decades(rng, -6, 1), rng.uniform(-math.pi, math.pi)) for _ in range(44)]


CONSTANTS = [("critical-radius", put_down, 1e-3, 1), ("critical-speed", launched, 1e-3, 10)]


def text(value):
    return value if isinstance(value, str) else repr(float(value))


def digits(value):
    return "{0:.30g}".format(value)


def write(path, header, rows):
    with open(path, "w", newline="") as file:
        csv.writer(file, lineterminator="\n").writerows([header, *rows])
    print(path, len(rows), flush=True)


def compute(folder):
    prec, rng = Precision(200, 50, "1e-36", 12, "0.2", "0.02"), random.Random(20240)
    write(f"{folder}/constants.csv", ["name", "value"],
          [(name, digits(border(start, low, high, prec))) for name, start, low, high in CONSTANTS])
    write(f"{folder}/turntable-boundary.csv", ["alpha", "psi", "A"],
          [(repr(a), repr(b), digits(border(start_on_hyperbola(a, b), "1e-8", 1, prec)))
           for a, b in boundary_starts(rng)])
    write(f"{folder}/turntable-rest.csv", ["rho", "p", "psi", "outcome", "sigma", "gap", "tau_rest"],
          [[*map(repr, start), *map(text, rest_row(start, prec))] for start in rest_starts(rng, prec)])
    columns = ["rho", "p", "psi", "time", "x", "y", "vx", "vy", "rho_t", "p_t", "psi_t"]
    write(f"{folder}/turntable-time.csv", columns,
          [[*map(repr, start), repr(time), *map(text, time_row(start, time, prec))]
           for start, time in time_starts(rng, prec)])


def check(folder):
    """Everything again, as `compute` does it and with other orders and steps."""
    first = Precision(200, 50, "1e-36", 12, "0.2", "0.02")
    second = Precision(260, 64, "1e-41", 16, "0.15", "0.012")

    def read(name):
        with open(f"{folder}/{name}", newline="") as file:
            return list(csv.reader(file))[1:]

    def compare(name, old, new, written):
        """Worst relative difference of the two calculations, and whether the second gives the same text."""
        nonlocal worst, differ
        for u, v, w in zip(old, new, written):
            if isinstance(v, str) or v == 0 or u == 0:
                differ += w not in (v, text(u), text(v)) or u != v
                continue
            worst = max(worst, abs(float((u - v) / v)))
            if w not in (text(v), digits(v)):
                differ += 1
                print(name, "differs", w, digits(u), digits(v))

    for name, job in [
        ("constants.csv", lambda r, q: [border(*[c[1:] for c in CONSTANTS if c[0] == r[0]][0], q)]),
        ("turntable-boundary.csv", lambda r, q: [border(start_on_hyperbola(float(r[0]), float(r[1])), "1e-8", 1, q)]),
        ("turntable-rest.csv", lambda r, q: rest_row([float(v) for v in r[:3]], q)),
        ("turntable-time.csv", lambda r, q: time_row([float(v) for v in r[:3]], float(r[3]), q)),
    ]:
        worst, differ, rows = 0.0, 0, read(name)
        for row in rows:
            old = job(row, first)
            new = job(row, second)
            compare(name, old, new, row[len(row) - len(new):])
        print(f"{name}: {len(rows)} rows, worst relative difference {worst:.1e}, other text {differ}", flush=True)


if __name__ == "__main__":
    folder = sys.argv[2] if len(sys.argv) > 2 else "."
    {"compute": compute, "check": check}[sys.argv[1]](folder)
