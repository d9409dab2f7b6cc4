#!/usr/bin/env python3
"""Both sides in one go: Slipbook's workloads and the peers', in turn, so that a busy machine slows both.

    python3 -m venv /tmp/peers && /tmp/peers/bin/pip install -r benches/peers/requirements.txt
    /tmp/peers/bin/python benches/peers/run.py --rounds 3 --out benches/results.json

Ours is `cargo bench -p slipbook-benches --bench workloads`, read from what criterion leaves, in README's own build (profile dev)
and in that of released binaries (profile release); a peer is a script of this folder, which prints one line of JSON. Of all
rounds and repeats the fastest counts, on all sides. The settings of the two profiles are kept with the figures.
"""
import argparse
import datetime
import json
import os
import platform
import subprocess
import sys
import tomllib

HERE = os.path.dirname(os.path.abspath(__file__))
ROOT = os.path.dirname(os.path.dirname(HERE))
PY = sys.executable

# What is done, criterion's group and function (or a script of this folder), items in it, peer, its command, items that one of its counts stands for.
ROWS = [
    ("start on the turntable, one core", "w1-turntable", "one core, 99856", 99856, "heyoka, batches",
     "w1_turntable.py --peer heyoka-raw-batch --m 316 --repeats 3"),
    ("start on the turntable, two cores", "w1-turntable", "all cores, 99856", 99856, "heyoka, batches",
     "w1_turntable.py --peer heyoka-raw-batch --m 316 --repeats 3 --threads 2"),
    ("start on the turntable, one core", "w1-turntable", "one core, 99856", 99856, "numba, DOP853",
     "w1_turntable.py --peer numba-dop853 --m 316 --repeats 3"),
    ("pixel of the stick-slip plane", "w2-census", "one core", 1000000, "numba, loop by hand",
     "w2_stickslip.py --peer numba-sim --repeats 2"),
    ("pixel of the stick-slip plane", "w2-census", "one core", 1000000, "heyoka with events",
     "w2_stickslip.py --peer heyoka-events --pixels 300"),
    ("pixel of the stick-slip plane, by formula", "w2-formula", "one core", 1000000, "numba, closed form",
     "w2_stickslip.py --peer numba-smart --repeats 5"),
    ("50 digits of Y", "w3-digits", "q-Y, 50", 1, "Arb", "w3_highprec.py --digits 50 --peer flint-arb"),
    ("50 digits of Y", "w3-digits", "q-Y, 50", 1, "mpmath", "w3_highprec.py --digits 50 --peer mpmath-findroot"),
    ("1000 digits of Y", "w3-digits", "q-Y, 1000", 1, "Arb", "w3_highprec.py --digits 1000 --peer flint-arb"),
    ("1000 digits of Y", "w3-digits", "q-Y, 1000", 1, "mpmath", "w3_highprec.py --digits 1000 --peer mpmath-findroot"),
    ("integral of A dt", "w4-quadrature", "integrals", 20000, "QUADPACK, SciPy",
     "w4_quadrature.py --peer scipy-quad --repeats 2"),
    ("integral of A dt", "w4-quadrature", "integrals", 20000, "numba, Gauss-Kronrod",
     "w4_quadrature.py --peer numba-gk21 --repeats 3 --n 100000"),
    ("integral of A dt", "w4-quadrature", "integrals", 20000, "quad-rs",
     "run_rust_peers.py --workload w4 --peer quad-rs-gk21 --n 20000"),
    ("proof of the four identities, cold", "w5-proofs", "from a cold start", 1, "SymPy, half angles",
     "w5_symbolic.py --peer sympy-halfangle --repeats 3"),
    ("everything, against five figures", "w6-everything", "main job", 1, "SciPy and matplotlib",
     "w6_notebook.py --peer script --repeats 2"),
    ("answer of an explorer, in WebAssembly", "w7-explorer", "w7_explorer.py --peer slipbook", 1, "SciPy with events",
     "w7_explorer.py --peer scipy"),
    ("from nothing to everything, against five figures", "w8-fresh", "w8_fresh.py --peer slipbook", 1, "SciPy and matplotlib",
     "w8_fresh.py --peer scipy"),
]

# Work that takes minutes is done once.
ONCE = ["w8-fresh"]


PROFILES = ("dev", "release")


def ours(profile, group, function, items):
    if ".py" in function:
        return theirs(function)[0], ""
    command = ["cargo", "bench", "--quiet", "-p", "slipbook-benches", "--profile", profile, "--bench", "workloads", "--", "--exact", f"{group}/{function}"]
    done = subprocess.run(command, cwd=ROOT, capture_output=True, text=True, check=True)
    accuracy = [line.removeprefix(group + ", ") for line in done.stdout.splitlines() if line.startswith(group + ", accuracy")]
    with open(os.path.join(ROOT, "target", "criterion", group, function, "new", "sample.json")) as file:
        sample = json.load(file)
    nanoseconds = min(time / times for time, times in zip(sample["times"], sample["iters"]))
    return nanoseconds / items / 1e3, "; ".join(accuracy)


def settings():
    """What Cargo.toml says of the profiles."""
    with open(os.path.join(ROOT, "Cargo.toml"), "rb") as file:
        return tomllib.load(file)["profile"]


# The ensemble on one core, from a thousand starts to a million: what one costs must not grow.
GROWTH = [1024, 10000, 99856, 1000000]


def processor():
    """The processor, with the widest registers that are used here."""
    with open("/proc/cpuinfo") as file:
        flags = file.read()
    wide = [name for name in ("avx512f", "avx2") if f" {name} " in flags]
    return ", ".join([platform.machine(), *wide[:1]])


def theirs(command):
    script, *rest = command.split()
    done = subprocess.run([PY, script, *rest], cwd=HERE, capture_output=True, text=True, check=True)
    line = json.loads([line for line in done.stdout.splitlines() if line.startswith("{")][-1])
    seconds = line.get("seconds_min", line["seconds"])
    return 1e6 * seconds / line["n"], line.get("accuracy", {})


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--rounds", type=int, default=3)
    parser.add_argument("--only", default="", help="rows whose group begins so")
    parser.add_argument("--out", default=os.path.join(os.path.dirname(HERE), "results.json"))
    arguments = parser.parse_args()
    rows = []
    for work, group, function, items, peer, command in ROWS:
        if not group.startswith(arguments.only):
            continue
        best = dict.fromkeys(("ours_us", "released_us", "peer_us"), float("inf"))
        # What is no bench of ours has one profile.
        keys = dict(zip(PROFILES, best)) if ".py" not in function else {"dev": "ours_us"}
        accuracy = ""
        try:
            for _ in range(1 if group in ONCE else arguments.rounds):
                for profile, key in keys.items():
                    mine, accuracy = ours(profile, group, function, items)
                    best[key] = min(best[key], mine)
                best["peer_us"] = min(best["peer_us"], theirs(command)[0])
        except (subprocess.CalledProcessError, OSError, IndexError, KeyError) as error:
            print(f"{work}, {peer}: {error} {getattr(error, 'stderr', '')}", file=sys.stderr)
            continue
        best = {key: float(f"{best[key]:.3g}") for key in [*keys.values(), "peer_us"]}
        row = {"work": work, "peer": peer, **best, "accuracy": accuracy}
        print(json.dumps(row), flush=True)
        rows.append(row)
    growth = []
    if "w1".startswith(arguments.only[:2]):
        for starts in GROWTH:
            times = [ours("dev", "w1-turntable", f"one core, {starts}", starts)[0] for _ in range(arguments.rounds)]
            growth.append({"starts": starts, "each_us": float(f"{min(times):.3g}")})
            print(json.dumps(growth[-1]), flush=True)
    machine = f"{processor()}, {os.cpu_count()} cores"
    commit = subprocess.run(["git", "rev-parse", "--short", "HEAD"], cwd=ROOT, capture_output=True, text=True, check=True).stdout.strip()
    result = {"date": datetime.date.today().isoformat(), "commit": commit, "profiles": settings(), "machine": machine, "rounds": arguments.rounds, "rows": rows, "growth": growth}
    with open(arguments.out + ".part", "w") as file:
        json.dump(result, file, indent=1)
        file.write("\n")
    os.replace(arguments.out + ".part", arguments.out)


if __name__ == "__main__":
    main()
