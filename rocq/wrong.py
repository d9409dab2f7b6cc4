#!/usr/bin/env python3
"""Makes statements wrong, one at a time, and sees the kernel refuse them by the same scripts.

    python3 rocq/wrong.py [CHAPTER ...]

A line of rocq/wrong/CHAPTER.txt is `theorem | text | replacement`. The text is replaced where it stands first after the theorem's
name in the chapter, else in a file of the chapter, else in another. `make -C rocq` has to have run. Exit code 1 where a wrong
statement goes through, where its text is gone, or where it fails for another reason than its proof.
"""

import concurrent.futures, pathlib, re, shutil, subprocess, sys, tempfile

ROCQ = pathlib.Path(__file__).resolve().parent
BUILT = ROCQ.parent / "target" / "rocq"
# What says that a statement was not read, and so not refused.
UNREAD = re.compile(r"[Ss]yntax error|was not found|Cannot find|already exists|Unable to locate|No rule to make")


def place(chapter, theorem, text):
    """The file and the position of the text to be replaced."""
    head = ROCQ / f"{chapter}.v"
    own = re.search(rf"^(Theorem|Lemma|Corollary) {theorem}\b", head.read_text(), re.M)
    if own is None:
        return None
    files = [(head, own.start())] + [(file, 0) for file in sorted(ROCQ.glob(f"{chapter}/*.v"))]
    files += [(head, 0)] + [(file, 0) for file in sorted(ROCQ.rglob("*.v"))]
    found = ((file, file.read_text().find(text, start)) for file, start in files)
    return next(((file, at) for file, at in found if at >= 0), None)


def tried(chapter, line):
    """What is wrong with this line; nothing where the kernel refuses the statement."""
    theorem, text, replacement = (part.strip() for part in line.split(" | "))
    found = place(chapter, theorem, text)
    if found is None:
        return "there is no such theorem, or no such text"
    file, at = found
    with tempfile.TemporaryDirectory(dir=ROCQ.parent / "target") as away:
        copy = pathlib.Path(away) / "rocq"
        shutil.copytree(BUILT, copy)
        changed = file.read_text()
        (copy / file.relative_to(ROCQ)).write_text(changed[:at] + replacement + changed[at + len(text) :])
        make = subprocess.run(["make", "-f", "Makefile", f"{chapter}.vo"], cwd=copy, capture_output=True, text=True)
    if make.returncode == 0:
        return "it goes through"
    errors = make.stderr[make.stderr.find("Error:") :]
    return f"it was not read: {errors.strip()[:200]}" if UNREAD.search(errors) else None


def main():
    chapters = sys.argv[1:] or sorted(file.stem for file in ROCQ.glob("wrong/*.txt"))
    lines = [(chapter, line) for chapter in chapters for line in (ROCQ / f"wrong/{chapter}.txt").read_text().splitlines() if line]
    offences = 0
    with concurrent.futures.ThreadPoolExecutor(2) as pool:
        for (chapter, line), fault in zip(lines, pool.map(lambda one: tried(*one), lines)):
            offences += fault is not None
            print(f"{chapter}: {line}: {fault or 'refused'}", flush=True)
    print(f"{len(lines) - offences} of {len(lines)} wrong statements are refused")
    sys.exit(offences > 0)


if __name__ == "__main__":
    main()
