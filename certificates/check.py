#!/usr/bin/env python3
"""Checks certificates with python-flint alone; nothing of it is shared with what wrote them.

    python3 check.py FOLDER [DATE]     all files of a folder; with a date, the result is recorded
    python3 check.py FOLDER --list     writes ties.csv anew

The format is described in the book, on the page "Certificates". Exit code 0 if every file is accepted.
"""
import hashlib
import json
import os
import re
import sys

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
        self.root = root_
        lines = open(os.path.join(root_, "tests/data/equations.md"), encoding="utf-8").read().splitlines()
        cells = [[cell.strip() for cell in line.split(" | ")] for line in lines if re.match(r"\| \d", line)]
        self.equations = {"eq-" + c[0].strip("| "): " | ".join(c[3:]).rstrip("| ").strip("`") for c in cells}
        rows = ""
        for folder, _, names in sorted(os.walk(os.path.join(root_, "src/claims"))):
            rows += "".join(open(os.path.join(folder, n), encoding="utf-8").read() for n in sorted(names) if n.endswith(".rs"))
        self.rows = re.sub(r"\\\n\s*", "", rows)
        with open(os.path.join(root_, "certificates/ties.csv"), encoding="utf-8") as file:
            self.ties = dict(line.rstrip("\n").split(",", 1) for line in file)

    def has(self, claim, statement, corrected):
        if claim in self.equations and not corrected:
            return plain(self.equations[claim]) == plain(statement)
        quoted = statement.replace("\\", "\\\\")
        return any(f'"{text}"' in self.rows for text in (statement, quoted))


def check(certificate, name, prints):
    """Raises `Wrong` unless the certificate is right."""
    version, claim, statement, sha256, about, trial, says, witnesses = keys(
        certificate, "format claim statement sha256 about trial says witnesses")
    demand(version == 2, "another version of the format")
    demand(name == f"{claim}-{trial.replace('::', '-')}.json", "another file's name")
    demand(hashlib.sha256(statement.encode()).hexdigest() == sha256, "the hash is not that of the statement")
    demand(prints.has(claim, statement, "corrected" in about), "the statement is not printed so")
    demand(witnesses, "no witness")
    before = []
    for w in witnesses:
        demand(w.get("kind") in KINDS, f"no kind of witness: {w.get('kind')}")
        before.append(KINDS[w["kind"]](w, before))
    tie = f"{tied(statement, witnesses)},{sha256[:16]},{outline(witnesses)}"
    demand(name in prints.ties, "a file that is not listed")
    demand(prints.ties[name] == tie, f"not what is listed: {tie}")
    return tie.split(",")[0]


def digest(witnesses):
    """What tells these witnesses from all others; the tests of the crate compute it too, of what it proves today."""
    text = json.dumps(witnesses, sort_keys=True, separators=(",", ":"), ensure_ascii=False)
    return hashlib.sha256(text.encode()).hexdigest()[:16]


def record(path, date, accepted):
    """Writes who accepted what, and when."""
    import flint
    versions = f"Python {sys.version.split()[0]}, python-flint {flint.__version__}, FLINT {flint.__FLINT_VERSION__}"
    with open(path, "w", encoding="utf-8") as out:
        out.write(f"{date},{versions}\n" + "".join(",".join(line) + "\n" for line in accepted))


def listed(folder, files):
    """The table of what each file has to be about: to be read before it is committed."""
    for name in files:
        with open(os.path.join(folder, name), encoding="utf-8") as file:
            c = json.load(file)
        yield f"{name},{tied(c['statement'], c['witnesses'])},{c['sha256'][:16]},{outline(c['witnesses'])}\n"


def main(folder, date=None):
    prints = Prints(os.path.join(os.path.dirname(os.path.abspath(__file__)), ".."))
    files = sorted(name for name in os.listdir(folder) if name.endswith(".json"))
    if date == "--list":
        with open(os.path.join(prints.root, "certificates/ties.csv"), "w", encoding="utf-8") as out:
            out.writelines(listed(folder, files))
        return 0
    accepted, rejected = [], []
    for name in files:
        try:
            with open(os.path.join(folder, name), encoding="utf-8") as file:
                certificate = json.load(file)
            tie = check(certificate, name, prints)
            accepted.append((certificate["claim"], certificate["trial"], tie, digest(certificate["witnesses"])))
        except Exception as error:  # whatever a broken file brings about
            rejected.append(f"{name}: {type(error).__name__}: {error}")
    missing = sorted(set(prints.ties) - set(files))
    print("\n".join(rejected + [f"{name}: missing" for name in missing]))
    ties = [line[2] for line in accepted]
    print(f"{len(accepted)} of {len(files)} files accepted; the printed formula is", {tie: ties.count(tie) for tie in sorted(set(ties))})
    if date and not rejected and not missing:
        record(os.path.join(prints.root, "snapshots/certificates.csv"), date, accepted)
    return 1 if rejected or missing or not files else 0


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:3]))
