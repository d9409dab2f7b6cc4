#!/usr/bin/env python3
"""Rapier, in its build for JavaScript: a cuboid whose rotation is locked, a ball. Needs node; `npm install` reads package.json."""

import json
import pathlib
import subprocess
from types import SimpleNamespace

import examlib as E


def simulate(iterations=None):
    def run(s, step):
        n, step = E.steps(s, step)
        task = json.dumps(dict(spec=s, n=n, step=step, iterations=iterations))
        out = subprocess.run(["node", "rapier.mjs", task], cwd=E.HERE, capture_output=True, text=True)
        if out.returncode:
            raise RuntimeError(out.stderr.strip().splitlines()[-1] if out.stderr else "node failed")
        return SimpleNamespace(**json.loads(out.stdout.splitlines()[-1]))

    return run


PROMISES = "An engine for games and robotics, here in single precision; Coulomb friction by small steps of a soft solver."

if __name__ == "__main__":
    version = json.loads((E.HERE / "node_modules/@dimforge/rapier3d-compat/package.json").read_text())["version"]
    E.main(
        "rapier.json",
        [
            dict(name="Rapier", version=version, settings="as it comes", promises=PROMISES, simulate=simulate()),
            dict(name="Rapier", version=version, settings="tuned: 32 solver iterations", promises=PROMISES, simulate=simulate(32)),
        ],
    )
