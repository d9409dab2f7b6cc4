#!/usr/bin/env python3
"""A block and a ball as hybrid systems: SciPy and heyoka integrate from event to event, as their users would write it."""

import math
from types import SimpleNamespace

import heyoka as hy
import numpy as np
import scipy
from scipy.integrate import solve_ivp

import examlib as E

# A slide in the plane ends where the speed falls to this: the direction of the friction has no value at 0.
STOPPED = 1e-6


def force(s, t):
    """The pull on a resting body, but for its place."""
    return s["c"] + s["r"] * t + s["s"] * math.sin(t)


def leave(s, t, end, pull_at):
    """When static friction ceases to hold: the first moment after t at which the pull exceeds it, by scanning and halving."""
    f = E.G * s["mu"]
    over = lambda t: abs(pull_at(t)) - f
    if over(t) > 0:
        return t
    h = 0.01
    while t < end:
        if over(min(t + h, end)) > 0:
            lo, hi = t, min(t + h, end)
            for _ in range(60):
                mid = 0.5 * (lo + hi)
                lo, hi = (lo, mid) if over(mid) > 0 else (mid, hi)
            return hi
        t += h
    return None


def block(s, slide):
    """Alternates sliding and resting; `slide(t, state, sign, end)` gives the time and state at which the slide ends."""
    t, end = 0.0, s["until"]
    state = np.array([*s["x"], *s["v"]], float)
    plane = s["v"][1] != 0 or s["k"] != 0
    travelled = 0.0
    while t < end:
        if state[2] == 0 and state[3] == 0:
            k = s["k"]
            pull_at = lambda u: math.hypot(force(s, u) + k * state[0], k * state[1])
            go = leave(s, t, end, pull_at)
            if go is None:
                break
            t = go
        sign = math.copysign(1.0, state[2] if state[2] != 0 else force(s, t))
        before = state[0]
        t, state, stopped = slide(t, state, None if plane else sign, end)
        travelled += abs(state[0] - before)
        if stopped:
            state[2] = state[3] = 0.0
    return SimpleNamespace(x=state[0], y=state[1], vx=state[2], vy=state[3], travelled=travelled)


def with_way(s, run):
    """The way in the window: one more run that ends where the window begins."""
    path = run(s)
    if s["window"] < s["until"]:
        before = run(dict(s, until=s["until"] - s["window"], window=s["until"]))
        path.way, path.travelled = path.x - before.x, path.travelled - before.travelled
    return path


def scipy_simulate(s, tolerance):
    f = E.G * s["mu"]
    if s["kind"] == "ball":
        return ball(s, lambda rhs, event, y, end: scipy_arc(rhs, event, 0.0, y, end, tolerance))

    def slide(t, y, sign, end):
        def rhs(t, y):
            ax, ay = E.pull(s, t, *y)
            if sign is None:
                speed = math.hypot(y[2], y[3])
                return [y[2], y[3], ax - f * y[2] / speed, ay - f * y[3] / speed]
            return [y[2], 0.0, ax - f * sign, 0.0]

        event = (lambda t, y: math.hypot(y[2], y[3]) - STOPPED) if sign is None else (lambda t, y: sign * y[2])
        event.direction = -1
        return scipy_arc(rhs, event, t, y, end, tolerance)

    return with_way(s, lambda s: block(s, slide))


def scipy_arc(rhs, event, t, y, end, tolerance):
    event.terminal = True
    r = solve_ivp(rhs, (t, end), y, method="DOP853", rtol=max(tolerance, 3e-14), atol=tolerance * 1e-2, events=event)
    if r.status < 0:
        raise RuntimeError(r.message)
    stopped = len(r.t_events[0]) > 0
    return r.t[-1], r.y[:, -1].copy(), stopped


def ball(s, arc):
    """Along a line: x, v and the velocity at the circumference; it rolls when they agree."""
    f = E.G * s["mu"]
    rhs = lambda t, y: [y[1], -f, 2.5 * f]
    t, y, rolls = arc(rhs, lambda t, y: y[1] - y[2], [s["x"][0], s["v"][0], 0.0], s["until"])
    x = y[0] + (y[1] * (s["until"] - t) if rolls else 0.0)
    return SimpleNamespace(x=x, y=0.0, vx=y[1], vy=0.0)


COMPILED = {}


def heyoka_integrator(plane, tolerance):
    """Compiled once for a tolerance, as one does."""
    if (plane, tolerance) in COMPILED:
        return COMPILED[plane, tolerance]
    x, y, u, v = hy.make_vars("x", "y", "u", "v")
    c, r, sn, k, f, sign = (hy.par[i] for i in range(6))
    ax = c + r * hy.time + sn * hy.sin(hy.time) + k * (x + 2.0 * v)
    ay = k * (y - 2.0 * u)
    if plane:
        speed = hy.sqrt(u * u + v * v)
        eqs = [(x, u), (y, v), (u, ax - f * u / speed), (v, ay - f * v / speed)]
        event = u * u + v * v - STOPPED**2
    else:
        eqs = [(x, u), (y, 0.0 * v), (u, ax - f * sign), (v, 0.0 * v)]
        event = u
    stop = hy.t_event(event, direction=hy.event_direction.negative if plane else hy.event_direction.any)
    ta = hy.taylor_adaptive(eqs, [0.0, 0.0, 1.0, 1.0], pars=[0.0] * (5 if plane else 6), t_events=[stop], tol=tolerance)
    COMPILED[plane, tolerance] = ta
    return ta


def heyoka_simulate(s, tolerance):
    f = E.G * s["mu"]
    if s["kind"] == "ball":
        key = "ball", tolerance
        if key not in COMPILED:
            x, v, w = hy.make_vars("x", "v", "w")
            stop = hy.t_event(v - w, direction=hy.event_direction.negative)
            COMPILED[key] = hy.taylor_adaptive([(x, v), (v, -f + 0.0 * v), (w, 2.5 * f + 0.0 * v)], [0.0, 1.0, 0.0], t_events=[stop], tol=tolerance)
        ta = COMPILED[key]

        def arc(rhs, event, y, end):
            ta.time, ta.state[:] = 0.0, y
            ta.reset_cooldowns()
            stopped = ta.propagate_until(end)[0] == hy.taylor_outcome(-1)
            return ta.time, ta.state.copy(), stopped

        return ball(s, arc)

    def slide(t, y, sign, end):
        ta = heyoka_integrator(sign is None, tolerance)
        ta.pars[:] = [s["c"], s["r"], s["s"], s["k"], f] + ([] if sign is None else [sign])
        ta.time = t
        ta.state[:] = y
        ta.reset_cooldowns()
        if y[2] == 0 and y[3] == 0:
            # Leave the event behind: the first moment in a series of its own.
            h = 1e-5
            a = force(s, t) - f * sign
            slope = s["r"] + s["s"] * math.cos(t)
            ta.time = t + h
            ta.state[2] = a * h + 0.5 * slope * h * h
            ta.state[0] += 0.5 * a * h * h + slope * h**3 / 6
        outcome = ta.propagate_until(end)[0]
        stopped = int(outcome) == -1
        return ta.time, ta.state.copy(), stopped

    return with_way(s, lambda s: block(s, slide))


def tanh_simulate(method):
    """The law as it is commonly written: friction is f tanh(|v|/v_s) against v. The knob is v_s."""

    def run(s, v_s):
        f = E.G * s["mu"]
        if s["kind"] == "ball":
            rhs = lambda t, y: [y[1], -f * math.tanh((y[1] - y[2]) / v_s), 2.5 * f * math.tanh((y[1] - y[2]) / v_s)]
            y0 = [s["x"][0], s["v"][0], 0.0]
            r = solve_ivp(rhs, (0, s["until"]), y0, method=method, rtol=1e-8, atol=1e-12)
            return SimpleNamespace(x=r.y[0, -1], y=0.0)

        def rhs(t, y):
            ax, ay = E.pull(s, t, *y)
            speed = math.hypot(y[2], y[3])
            g = f * math.tanh(speed / v_s) / speed if speed > 0 else f / v_s
            return [y[2], y[3], ax - g * y[2], ay - g * y[3]]

        n = 4096
        begin = s["until"] - s["window"]
        at = np.concatenate([[0.0], np.linspace(begin, s["until"], n + 1)]) if begin > 0 else np.linspace(0, s["until"], n + 1)
        r = solve_ivp(rhs, (0, s["until"]), [*s["x"], *s["v"]], method=method, rtol=1e-8, atol=1e-12, t_eval=at)
        if r.status < 0:
            raise RuntimeError(r.message)
        window = r.y[:, -(n + 1):]
        travelled = float(np.abs(np.diff(window[0])).sum())
        x, y, vx, vy = r.y[:, -1]
        return SimpleNamespace(x=x, y=y, vx=vx, vy=vy, travelled=travelled, way=x - window[0, 0])

    return run


if __name__ == "__main__":
    tolerances = [1e-3, 1e-5, 1e-7, 1e-9, 1e-11, 1e-13]
    hybrid = "Errors near the tolerance on each smooth piece; where pieces begin and end, and what a resting body does, its user writes."
    E.main(
        "events.json",
        [
            dict(name="SciPy with events", version=scipy.__version__, settings="solve_ivp, DOP853, terminal events", promises=hybrid, knob="tolerance", values=tolerances, simulate=scipy_simulate),
            dict(name="heyoka with events", version=hy.__version__, settings="taylor_adaptive, terminal events", promises=hybrid, knob="tolerance", values=tolerances[2:] + [1e-15], simulate=heyoka_simulate),
            dict(name="SciPy, tanh law", version=scipy.__version__, settings="solve_ivp, LSODA, 1e-8; the knob is the velocity scale", promises="A regularised law: it creeps where Coulomb's holds, with a velocity of the order of its scale.",
                 knob="velocity scale", values=[1e-1, 1e-2, 1e-3, 1e-4, 1e-5, 1e-6], simulate=tanh_simulate("LSODA")),
        ],
    )
