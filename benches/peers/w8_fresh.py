#!/usr/bin/env python3
"""W8 - from nothing to the result: a clone, its dependencies and the main job, against an environment and the five figures of w6.

Both get what they need from their registry, into empty folders, in the same run; the compiler and Python are there.
"""
import argparse
import os
import shutil
import subprocess
import sys
import tempfile
import time

import benchlib as B

HERE = os.path.dirname(os.path.abspath(__file__))
ROOT = os.path.dirname(os.path.dirname(HERE))


def ours(folder):
    clone, home = os.path.join(folder, "clone"), os.path.join(folder, "cargo")
    os.makedirs(home)
    # Where the registry is, where that is set; nothing that was fetched before.
    known = os.path.join(os.environ.get("CARGO_HOME", os.path.expanduser("~/.cargo")), "config.toml")
    if os.path.exists(known):
        shutil.copy(known, home)
    subprocess.run(["git", "clone", "--quiet", "--no-local", ROOT, clone], check=True)
    environment = {**os.environ, "CARGO_HOME": home, "CARGO_TARGET_DIR": os.path.join(folder, "target")}
    subprocess.run(["cargo", "run", "--quiet"], cwd=clone, env=environment, check=True, stdout=subprocess.DEVNULL)


def theirs(folder):
    subprocess.run([sys.executable, "-m", "venv", folder], check=True)
    python = os.path.join(folder, "bin", "python")
    with open(os.path.join(HERE, "requirements.txt")) as file:
        # What the script of five figures imports.
        needed = [line.strip() for line in file if line.startswith(("numpy=", "scipy=", "matplotlib="))]
    subprocess.run([python, "-m", "pip", "install", "--quiet", "--no-cache-dir", *needed], check=True)
    subprocess.run([python, "w6_notebook.py", "--peer", "script", "--repeats", "1"], cwd=HERE, check=True, stdout=subprocess.DEVNULL)


def main():
    ap = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    ap.add_argument("--peer", default="scipy", choices=["scipy", "slipbook"])
    a = ap.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        start = time.perf_counter()
        (ours if a.peer == "slipbook" else theirs)(folder)
        seconds = time.perf_counter() - start
    B.emit("W8", a.peer, 1, {"seconds": seconds, "seconds_min": seconds, "repeats": 1}, {}, loc=B.loc_of(ours, theirs))


if __name__ == "__main__":
    sys.exit(main())
