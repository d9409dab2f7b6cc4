#!/usr/bin/env python3
"""Checks certificates with python-flint alone; nothing of it is shared with what wrote them.

    python3 check.py FOLDER [DATE]     all files of a folder; with a date, the result is recorded
    python3 check.py FOLDER --list     writes said.txt anew, if every file is right, for it to be read and reviewed

The format is described in the book, on the page "Certificates". Exit code 0 if every file is accepted.
"""
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
from said import Said, witness
from ties import tied

KINDS = {"identity": identity, "root": root, "number": number, "range": range_, "motion": motion}


def plain(text):
    """A formula without what does not belong to it: spaces, the last full stop, columns."""
    text = re.sub(r"^(\\text\{)?[A-E]:\}?", "", text).replace(r"\mbox", r"\text").replace("&", "")
    return re.sub(r"\s+", "", text).rstrip(".,;").replace(r"\quad", "").replace(r"\,", "")


LITERAL = r'r?"((?:[^"\\]|\\.)*)"'


def rows(files):
    """Of each claim, by its row in the sources: the statement, what replaces it, and its conditions."""
    texts = [re.sub(r"\\\n\s*", "", file.read_text("utf-8")) for file in files]
    # What every claim takes for granted is written shorter.
    shorter = rf"\brough\(\s*({LITERAL}),?\s*\)"
    texts = [re.sub(shorter, r"Condition { text: \1, sort: Sort::Convention, }", text) for text in texts]
    consts = lambda text: dict(re.findall(r"const (\w+): [^=]+ =\s(.*?);\n", text, re.DOTALL))
    everywhere, found = consts("".join(texts)), {}
    for text in texts:
        known = everywhere | consts(text)

        def meant(name):
            """What stands for a constant, or for one of a list."""
            of = known.get(name[1], name[0])
            return of if name[2] is None else re.findall(r"Condition \{.*?Sort::\w+,\s*\}|[A-Z_]{4,}", of, re.DOTALL)[int(name[2])]

        for claim, row in re.findall(r'\bClaim \{\s+id: "([^"]+)",(.*?)\n    \}', text, re.DOTALL):
            for _ in range(3):
                row = re.sub(r"(?<!:)\b([A-Z][A-Z0-9_]+)\b(?:\[(\d)\])?", meant, row)
            statements = re.findall(r"\blatex: " + LITERAL, row)
            conditions = re.findall(rf"\btext: {LITERAL},\s+sort: Sort::(\w+)", row)
            found[claim] = statements[:1], statements[1:], [said for said, sort in conditions if sort != "Remark"]
    return found


class Prints:
    """The statements as they stand in the repository: the numbered equations, and the rows of the claims."""

    def __init__(self, root_):
        self.root = Path(root_)
        lines = (self.root / "tests/data/equations.md").read_text("utf-8").splitlines()
        cells = [[cell.strip() for cell in line.split(" | ")] for line in lines if re.match(r"\| \d", line)]
        self.equations = {"eq-" + c[0].strip("| "): " | ".join(c[3:]).rstrip("| ").strip("`") for c in cells}
        self.rows = rows(sorted((self.root / "src/claims").glob("*.rs")))
        self.said = Said((self.root / "certificates/said.txt").read_text("utf-8"))

    def has(self, claim, statement, corrected, conditions):
        printed, correct, under = self.rows.get(claim, ([], [], None))
        if claim in self.equations and not corrected:
            return plain(self.equations[claim]) == plain(statement) and conditions == under
        return [statement] == (correct if corrected else printed) and conditions == under


def right(certificate, name, prints):
    """Raises `Wrong` unless the certificate proves what it says; what it says, as text."""
    version, claim, statement, conditions, about, proof, says, witnesses = keys(
        certificate, "format claim statement conditions about proof says witnesses")
    demand(type(version) is int and version == 4, "another version of the format")
    demand(type(proof) is int and name == f"{claim}-{proof}.json", "another file's name")
    demand(prints.has(claim, statement, "corrected" in about, conditions), "the statement is not printed so")
    demand(any(w.get("kind") != "identity" or w.get("equal") for w in witnesses), "nothing is compared")
    before, under = [], [] if about.startswith("without") else conditions
    for w in witnesses:
        demand(w.get("kind") in KINDS, f"no kind of witness: {w.get('kind')}")
        before.append(KINDS[w["kind"]](w, before, *[under, claim] * (w["kind"] == "identity")))
    head = [f"{name}: {about}; {tied(statement, witnesses)}", f"statement: {statement}",
            *(f"condition: {text}" for text in conditions), f"says: {says}"]
    demand(not any("\n" in line for line in head), "a text of two lines")
    return "\n".join(head), [witness(w) for w in witnesses]


def check(certificate, name, prints):
    """Raises `Wrong` unless the certificate is right, and says what is recorded."""
    said = right(certificate, name, prints)
    demand(name in prints.said.files, "a file that is not listed")
    demand(prints.said.files[name] == said, "not what is listed")
    about, tie = said[0].split("\n")[0].split(": ", 1)[1].rsplit("; ", 1)
    return f"{certificate['claim']},{certificate['proof']},{tie},{about}"


def once(pairs):
    """An object, in which no key stands twice."""
    demand(len(dict(pairs)) == len(pairs), "a key twice")
    return dict(pairs)


def opened(file):
    return json.loads(Path(file).read_text("utf-8"), object_pairs_hook=once)


def main(folder, date=None):
    prints = Prints(Path(__file__).resolve().parent.parent)
    files, anew = sorted(Path(folder).glob("*.json")), date == "--list"
    accepted, rejected = [], []
    for file in files:
        try:
            accepted.append((right if anew else check)(opened(file), file.name, prints))
        except Exception as error:  # whatever a broken file brings about
            rejected.append(f"{file.name}: {type(error).__name__}: {error}")
    if anew:
        print("\n".join(rejected))
        if not rejected:
            (prints.root / "certificates/said.txt").write_text(Said.written(accepted), "utf-8")
        return 1 if rejected else 0
    rejected += [f"{name}: missing" for name in sorted(prints.said.files.keys() - {file.name for file in files})]
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
