"""The part of the exam that an engine with bodies and forces can sit, the same for every candidate.

A candidate is a function `simulate(spec, step)` that returns a `Path`. `spec` says what is to be set up:

  kind    "block" (it must not turn) or "ball" (solid, radius 1/2)
  mu      coefficient of friction; gravity is 10, the mass 1
  x, v    place and velocity at the start, along the floor
  pull    the acceleration that acts at the centre: [c + r t + s sin t + k (x + 2 v_y), k (y - 2 v_x)]
  until   how long
  window  how long before the end the way is counted

Cost is the processor's time of this process, since the machine is shared. Every candidate takes its commands from Python (Rapier
from JavaScript), one call or a few for each step, as its users do; that is part of the cost.
"""

import argparse
import datetime
import json
import math
import pathlib
import platform
import time

HERE = pathlib.Path(__file__).parent
ANSWERS = {t["task"]: t["answer"] for t in json.loads((HERE / "exam.json").read_text())["tasks"]}

G = 10.0
RADIUS = 0.5
TAU = 2 * math.pi


def spec(kind="block", mu=0.1, x=(0.0, 0.0), v=(0.0, 0.0), c=0.0, r=0.0, s=0.0, k=0.0, until=1.0, window=None):
    return dict(kind=kind, mu=mu, x=x, v=v, c=c, r=r, s=s, k=k, until=until, window=window or until)


# task: (set-up, how the answer is read, coarsest step)
TASKS = {
    "stop-place": (spec(mu=0.15, v=(0.0, 1.0), c=1.0, until=2.0), lambda p: math.hypot(p.x, p.y), 1 / 64),
    "turning": (spec(mu=0.05, v=(0.0, 1.0), c=1.0, until=2.0), lambda p: p.vy, 1 / 64),
    "creep": (spec(mu=0.1, c=0.95, until=10.0), lambda p: math.hypot(p.x, p.y), 1 / 64),
    "breakaway": (spec(mu=0.1, r=0.5, until=4.0), lambda p: p.x, 1 / 64),
    # Energy is force times way; that needs no velocity below which a body is said to rest.
    "heat": (spec(mu=0.08, s=1.0, until=4 * TAU, window=TAU), lambda p: 0.8 * p.travelled, TAU / 512),
    "drift": (spec(mu=0.045, s=1.0, c=0.15, until=16 * TAU, window=TAU), lambda p: p.way / TAU, TAU / 512),
    "ball-place": (spec(kind="ball", mu=0.1, v=(1.0, 0.0), until=1.0), lambda p: p.x, 1 / 64),
    "place-of-rest": (spec(mu=0.1, x=(0.5, 0.0), v=(0.0, -0.5), k=1.0, until=4.0), lambda p: math.hypot(p.x, p.y), 1 / 64),
}
# Those that happen on a line.
ON_A_LINE = ["creep", "breakaway", "heat", "drift", "ball-place"]


def pull(s, t, x, y, vx, vy):
    k = s["k"]
    ax = s["c"] + s["r"] * t + (s["s"] * math.sin(t) if s["s"] else 0.0) + k * (x + 2 * vy)
    return ax, k * (y - 2 * vx)


class Path:
    """What the questions need, noted step by step."""

    def __init__(self, s):
        self.from_ = s["until"] - s["window"]
        self.travelled, self.begin = 0.0, None
        self.x, self.y = s["x"]
        self.vx, self.vy = s["v"]

    def note(self, t, step, x, y, vx, vy):
        """The state at the time t, after a step."""
        if t > self.from_ + 0.5 * step:
            if self.begin is None:
                self.begin = self.x
            self.travelled += abs(x - self.x)
        self.x, self.y, self.vx, self.vy = x, y, vx, vy

    @property
    def way(self):
        return self.x - (self.begin or 0.0)


def steps(s, step):
    """The number of steps, and their length so that they fit."""
    n = max(1, round(s["until"] / step))
    return n, s["until"] / n


def timed(simulate, s, value):
    """A run, and the processor time that it took; a candidate that is a process of its own tells itself."""
    begin = time.process_time()
    path = simulate(s, value)
    return path, getattr(path, "cpu", None) or time.process_time() - begin


def sit(simulate, tasks, seconds=20.0, halvings=9, knob="step", values=None):
    """Runs each task with ever smaller steps (or the given values of the knob) until the answer settles or time is up."""
    runs = []
    for name in tasks:
        s, read, coarsest = TASKS[name]
        last, still = None, 0
        for value in values or [coarsest / 2**n for n in range(halvings + 1)]:
            try:
                path, cpu = timed(simulate, s, value)
                if cpu < 0.3:
                    # What is short is run again: the first time may have compiled something.
                    path, cpu = min((path, cpu), timed(simulate, s, value), key=lambda run: run[1])
                answer = float(read(path))
            except Exception as error:  # a solver that gives up has no answer
                runs.append(dict(task=name, knob=value, answer=None, error=None, cpu=None, simulated=s["until"], failed=str(error)[:80]))
                break
            wrong = abs(answer - ANSWERS[name])
            runs.append(dict(task=name, knob=value, answer=answer, error=wrong, cpu=cpu, simulated=s["until"]))
            print(f"  {name:15} {knob} {value:.2e}  {answer:+.12f}  error {wrong:.2e}  {cpu:.3f} s", flush=True)
            # Twice in a row: once may be chance.
            still = still + 1 if last is not None and abs(answer - last) < 0.02 * wrong else 0
            settled = still == 2 and values is None
            last = answer
            # The next one costs twice as much.
            if settled or 2 * cpu > seconds:
                break
    return runs


def save(file, entries):
    """One result file per script; an entry per kind of settings."""
    out = dict(
        date=datetime.date.today().isoformat(),
        machine=f"{platform.machine()}, two shared cores, time of one processor",
        python=platform.python_version(),
        entries=entries,
    )
    path = HERE / "results" / file
    path.write_text(json.dumps(out, indent=1, ensure_ascii=False) + "\n")
    print("wrote", path.name)


def main(file, candidates):
    """`candidates`: dicts with name, version, settings, promises, simulate; perhaps tasks, knob, values."""
    ap = argparse.ArgumentParser()
    ap.add_argument("--seconds", type=float, default=10.0, help="longest run of one task")
    ap.add_argument("--only", help="one task")
    a = ap.parse_args()
    entries = []
    for c in candidates:
        print(c["name"], "-", c["settings"])
        tasks = c.get("tasks", list(TASKS))
        if a.only:
            tasks = [t for t in tasks if t == a.only]
        runs = sit(c["simulate"], tasks, a.seconds, knob=c.get("knob", "step"), values=c.get("values"))
        entries.append({k: c[k] for k in ("name", "version", "settings", "promises")} | dict(knob=c.get("knob", "step"), runs=runs))
    if not a.only:
        save(file, entries)
