#!/usr/bin/env python3
"""Checks certificates with python-flint alone; nothing of it is shared with what wrote them.

    python3 check.py FOLDER      all files of a folder, of which none may be missing
    python3 check.py FILE...     these files alone

The format is described in the book, on the page "Certificates". Exit code 0 if every file is accepted, 2 if none is named.
"""
import argparse
import json
import subprocess
import sys
import tomllib
from collections import Counter
from pathlib import Path

try:
    import flint
except ImportError:
    sys.exit("python-flint is missing: pip install python-flint")

from field import identity, inequalities
from formula import Wrong, demand, keys
from intervals import motion, number, range_, root
from transcript import Transcript, witness
from ties import tied

# Kinds of claims that are formulas, which their own proofs have to compare.
FORMULAS = ("definition", "equation", "number")
KINDS = {"identity": identity, "root": root, "number": number, "range": range_, "motion": motion}


def text(value):
    """A text of a claim's entry, which may be broken into lines."""
    return value.rstrip().replace("\n", " ")


def entries(folder):
    """Of each claim, by its entry: the statement, what replaces it, its conditions, without remarks, and whether it is a formula."""
    files = {file.stem: tomllib.loads(file.read_text("utf-8")) for file in folder.glob("*.toml")}
    shared, found = files.pop("shared")["conditions"], {}
    for file in files.values():
        known = shared | file.pop("conditions", {})
        for claim, entry in file.items():
            if claim not in ("section", "reasons"):
                given = [known[c] if isinstance(c, str) else c for c in entry.get("conditions", [])]
                under = [text(said) for c in given for sort, said in c.items() if sort != "remark"]
                kind = entry.get("kind", "equation" if claim.startswith("eq-") else "property")
                found[claim] = text(entry["latex"]), text(entry.get("corrected", "")), under, kind in FORMULAS
    return found


class Prints:
    """The statements as they stand in the repository, in the claims' entries."""

    def __init__(self, root_):
        self.root = Path(root_)
        self.entries = entries(self.root / "claims")
        self.transcript = Transcript((self.root / "certificates/transcript.txt").read_text("utf-8"))

    def has(self, claim, statement, corrected, conditions):
        printed, correct, under, _ = self.entries.get(claim, ("", "", None, False))
        return statement == (correct if corrected else printed) and conditions == under


def right(certificate, name, prints):
    """Raises `Wrong` unless the certificate proves what it says; what it says, as text."""
    version, claim, statement, conditions, about, proof, says, witnesses = keys(
        certificate, "format claim statement conditions about proof says witnesses")
    demand(type(version) is int and version == 4, "another version of the format")
    demand(type(proof) is int and name == f"{claim}-{proof}.json", "another file's name")
    demand(prints.has(claim, statement, "corrected" in about, conditions), "the statement is not printed so")
    own = witnesses[-1:] if prints.entries[claim][3] else witnesses
    demand(any(w.get("kind") != "identity" or w.get("equal") for w in own), "nothing is compared")
    before, under = [], [] if about.startswith("without") else conditions
    for w in witnesses:
        demand(w.get("kind") in KINDS, f"no kind of witness: {w.get('kind')}")
        before.append(KINDS[w["kind"]](w, before, *[under] * (w["kind"] == "identity")))
    head = [f"{name}: {about}; {tied(statement, witnesses)}", f"statement: {statement}",
            *(f"condition: {text}" for text in conditions), f"says: {says}"]
    demand(not any("\n" in line for line in head), "a text of two lines")
    return "\n".join(head), [witness(w) for w in witnesses]


def use(certificate):
    """What becomes of the identities without the conditions that begin as inequalities: refused, as these are used, or not."""
    conditions, witnesses = [c for c in certificate["conditions"] if inequalities(c)], certificate["witnesses"]
    if not conditions or certificate["about"].startswith("without"):
        return "none"
    try:
        before = [w.get("title") for w in witnesses]
        all(identity(w, before) for w in witnesses if w["kind"] == "identity")
    except Wrong:
        return "used"
    return "idle"


def check(certificate, name, prints, record=False):
    """Raises `Wrong` unless the certificate is right, and says what is recorded."""
    said = right(certificate, name, prints)
    demand(name in prints.transcript.files, "a file that is not listed")
    demand(prints.transcript.files[name] == said, "not what is listed")
    about, tie = said[0].split("\n")[0].split(": ", 1)[1].rsplit("; ", 1)
    return f"{certificate['claim']},{certificate['proof']},{tie},{use(certificate) if record else ''},{about}"


def once(pairs):
    """An object, in which no key stands twice."""
    demand(len(dict(pairs)) == len(pairs), "a key twice")
    return dict(pairs)


def opened(file):
    return json.loads(Path(file).read_text("utf-8"), object_pairs_hook=once)


def main(words=None):
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("paths", metavar="PATH", nargs="+", type=Path)
    parser.add_argument("--list", action="store_true", help="write transcript.txt anew, if every file is right, for it to be read and reviewed")
    parser.add_argument("--record", metavar="DATE", help="record the result")
    asked = parser.parse_args(words)
    for path in asked.paths:
        if not path.exists():
            parser.error(f"there is no {path}")
    alone = all(path.is_file() for path in asked.paths)
    if not alone and len(asked.paths) > 1 or alone and (asked.list or asked.record):
        parser.error("one folder, or files; only a folder is listed or recorded")
    prints = Prints(Path(__file__).resolve().parent.parent)
    files, anew = asked.paths if alone else sorted(asked.paths[0].glob("*.json")), asked.list
    accepted, rejected = [], []
    for file in files:
        try:
            of = opened(file), file.name, prints
            accepted.append(right(*of) if anew else check(*of, bool(date)))
        except Exception as error:  # whatever a broken file brings about
            rejected.append(f"{file.name}: {type(error).__name__}: {error}")
    if anew:
        print("\n".join(rejected))
        if not rejected:
            (prints.root / "certificates/transcript.txt").write_text(Transcript.written(accepted), "utf-8")
        return 1 if rejected else 0
    missing = [] if alone else sorted(prints.transcript.files.keys() - {file.name for file in files})
    if missing:
        rejected.append(f"{len(missing)} missing, the first of them {missing[0]}; to check some alone, name the files")
    ties = dict(sorted(Counter(line.split(",")[2] for line in accepted).items()))
    print("\n".join(rejected))
    print(f"{len(accepted)} of {len(files)} files accepted; the printed formula is", ties)
    if asked.record and not rejected:
        # Who accepted what, when, and of which commit.
        commit = subprocess.run(["git", "-C", prints.root, "rev-parse", "--short", "HEAD"], capture_output=True, check=True, text=True).stdout.strip()
        by = f"Python {sys.version.split()[0]}, python-flint {flint.__version__}, FLINT {flint.__FLINT_VERSION__}"
        (prints.root / "snapshots/certificates.csv").write_text("\n".join([f"{asked.record},{commit},{by}", *accepted, ""]), "utf-8")
    return 1 if rejected or not files else 0


if __name__ == "__main__":
    sys.exit(main())
