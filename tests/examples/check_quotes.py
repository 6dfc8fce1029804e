#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Checks that the worked examples of docs/dev quote what is there.

Usage: check_quotes.py ROOT

In each page docs/dev/add_a_*.md every block marked cpp must stand in tests/examples/ under the page's name, literally. In a
block marked diff, whose first line "--- FILE" names a file of the repository, the lines of each hunk that are kept or
removed must stand in that file, one after the other. Names each block that does not, and exits with 1.
"""
import re
import sys
from pathlib import Path

BLOCK = re.compile(r"^```(cpp|diff)\n(.*?)^```$", re.DOTALL | re.MULTILINE)


def stands_in(quote, text):
    """Whether these whole lines stand in the text."""
    return ("\n" + quote) in ("\n" + text)


def faults_of_diff(root, block):
    first, *lines = block.splitlines(keepends=True)
    file = root / first.removeprefix("--- ").strip()
    if not first.startswith("--- ") or not file.is_file():
        return [f'its first line is not "--- FILE" with a file of the repository, but "{first.strip()}"']
    text = file.read_text(encoding="utf-8")
    faults, hunk = [], ""
    for line in lines + ["@@\n"]:
        if line[0] not in " -+@":
            faults.append(f'a line begins with none of " ", "-", "+" and "@@": {line.strip()}')
        if line[0] in " -":
            hunk += line[1:]
        elif line[0] == "@":
            if hunk and not stands_in(hunk, text):
                faults.append(f"not in {file.relative_to(root)}:\n{hunk.rstrip()}")
            hunk = ""
    return faults


def faults_of(root, page):
    """Pairs of a line of the page and what is wrong there."""
    source = root / "tests" / "examples" / f"{page.stem}.cpp"
    text = source.read_text(encoding="utf-8") if source.is_file() else ""
    content = page.read_text(encoding="utf-8")
    found, quotes = [], 0
    for block in BLOCK.finditer(content):
        line = content.count("\n", 0, block.start()) + 1
        if block[1] == "diff":
            found += [(line, fault) for fault in faults_of_diff(root, block[2])]
            continue
        quotes += 1
        if not stands_in(block[2], text):
            found.append((line, f"not in {source.relative_to(root)}:\n{block[2].rstrip()}"))
    if quotes == 0:
        found.append((1, "quotes no code"))
    return found


def main(arguments):
    if len(arguments) != 1:
        print(__doc__.strip())
        return 2
    root = Path(arguments[0]).resolve()
    pages = sorted((root / "docs" / "dev").glob("add_a_*.md"))
    if not pages:
        print(f"check_quotes.py: no page docs/dev/add_a_*.md under {root}")
        return 2
    faults = [(page, line, fault) for page in pages for line, fault in faults_of(root, page)]
    for page, line, fault in faults:
        print(f"{page.relative_to(root)}:{line}: {fault}\n")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
