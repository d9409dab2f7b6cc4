#!/usr/bin/env python3
"""Checks certificates with python-flint alone; nothing of it is shared with what wrote them.

    python3 check.py FOLDER [DATE]     all files of a folder; with a date, the result is recorded
    python3 check.py FOLDER --list     writes ties.csv anew

The format is described in the book, on the page "Certificates". Exit code 0 if every file is accepted.
"""
import hashlib
import json
import re
import subprocess
import sys
from collections import Counter
from pathlib import Path

import flint

from field import identity
from formula import demand, keys
from intervals import motion, number, range_, root
from ties import outline, tied

KINDS = {"identity": identity, "root": root, "number": number, "range": range_, "motion": motion}


def plain(text):
    """A formula without what does not belong to it: spaces, the last full stop, columns."""
    text = re.sub(r"^(\\text\{)?[A-E]:\}?", "", text).replace(r"\mbox", r"\text").replace("&", "")
    return re.sub(r"\s+", "", text).rstrip(".,;").replace(r"\quad", "").replace(r"\,", "")


class Prints:
    """The statements as they stand in the repository: the numbered equations, and the rows of the claims."""

    def __init__(self, root_):
        self.root = Path(root_)
        lines = (self.root / "tests/data/equations.md").read_text("utf-8").splitlines()
        cells = [[cell.strip() for cell in line.split(" | ")] for line in lines if re.match(r"\| \d", line)]
        self.equations = {"eq-" + c[0].strip("| "): " | ".join(c[3:]).rstrip("| ").strip("`") for c in cells}
        rows = "".join(path.read_text("utf-8") for path in (self.root / "src/claims").rglob("*.rs"))
        self.rows = re.sub(r"\\\n\s*", "", rows)
        listed = (self.root / "certificates/ties.csv").read_text("utf-8").splitlines()
        self.ties = dict(line.split(",", 1) for line in listed)

    def has(self, claim, statement, corrected):
        if claim in self.equations and not corrected:
            return plain(self.equations[claim]) == plain(statement)
        return any(f'"{text}"' in self.rows for text in (statement, statement.replace("\\", "\\\\")))


def listed(certificate):
    """What a file has to be about: to be read before it is committed."""
    statement, sha256, witnesses = (certificate[key] for key in ("statement", "sha256", "witnesses"))
    return f"{tied(statement, witnesses)},{sha256[:16]},{outline(certificate)}"


def check(certificate, name, prints):
    """Raises `Wrong` unless the certificate is right."""
    version, claim, statement, sha256, about, proof, says, witnesses = keys(
        certificate, "format claim statement sha256 about proof says witnesses")
    demand(type(version) is int and version == 3, "another version of the format")
    demand(type(proof) is int and name == f"{claim}-{proof}.json", "another file's name")
    demand(hashlib.sha256(statement.encode()).hexdigest() == sha256, "the hash is not that of the statement")
    demand(prints.has(claim, statement, "corrected" in about), "the statement is not printed so")
    demand(witnesses, "no witness")
    before = []
    for w in witnesses:
        demand(w.get("kind") in KINDS, f"no kind of witness: {w.get('kind')}")
        before.append(KINDS[w["kind"]](w, before))
    tie = listed(certificate)
    demand(name in prints.ties, "a file that is not listed")
    demand(prints.ties[name] == tie, f"not what is listed: {tie}")
    return f"{claim},{proof},{tie.split(',')[0]},{about}"


def once(pairs):
    """An object, in which no key stands twice."""
    demand(len(dict(pairs)) == len(pairs), "a key twice")
    return dict(pairs)


def opened(file):
    return json.loads(Path(file).read_text("utf-8"), object_pairs_hook=once)


def main(folder, date=None):
    prints = Prints(Path(__file__).resolve().parent.parent)
    files = sorted(Path(folder).glob("*.json"))
    if date == "--list":
        lines = [f"{file.name},{listed(opened(file))}\n" for file in files]
        (prints.root / "certificates/ties.csv").write_text("".join(lines), "utf-8")
        return 0
    accepted, rejected = [], []
    for file in files:
        try:
            accepted.append(check(opened(file), file.name, prints))
        except Exception as error:  # whatever a broken file brings about
            rejected.append(f"{file.name}: {type(error).__name__}: {error}")
    rejected += [f"{name}: missing" for name in sorted(prints.ties.keys() - {file.name for file in files})]
    ties = dict(sorted(Counter(line.split(",")[2] for line in accepted).items()))
    print("\n".join(rejected))
    print(f"{len(accepted)} of {len(files)} files accepted; the printed formula is", ties)
    if date and not rejected:
        # Who accepted what, when, and of which commit.
        commit = subprocess.run(["git", "-C", prints.root, "rev-parse", "--short", "HEAD"], capture_output=True, check=True, text=True).stdout.strip()
        by = f"Python {sys.version.split()[0]}, python-flint {flint.__version__}, FLINT {flint.__FLINT_VERSION__}"
        (prints.root / "snapshots/certificates.csv").write_text("\n".join([f"{date},{commit},{by}", *accepted, ""]), "utf-8")
    return 1 if rejected or not files else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:3]))
