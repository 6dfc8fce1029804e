#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Keeps the translations in step with the sources.

Run it after strings have changed: it calls lupdate, fills loopmend_de.ts from german.json and loopmend_en.ts, which has
plural forms only (all else is English in the sources), from english_plurals.json. Tells which strings have no words yet.
"""
import json
import subprocess
import sys
import xml.etree.ElementTree as ET
from pathlib import Path

here = Path(__file__).resolve().parent
app = here.parent.parent / "app"


def fill(path, words, plurals):
    """Writes the words into the file. Returns the strings that have none."""
    tree = ET.parse(path)
    missing = []
    for message in tree.getroot().iter("message"):
        source = message.find("source").text
        target = message.find("translation")
        target.attrib.pop("type", None)
        for child in list(target):
            target.remove(child)
        if message.get("numerus"):
            found = source in plurals
            for form in plurals.get(source, [source, source]):
                ET.SubElement(target, "numerusform").text = form
        else:
            found = source in words
            target.text = words.get(source)
        if not found:
            target.set("type", "unfinished")
            missing.append(source)
    ET.indent(tree, "    ")
    with open(path, "wb") as file:
        file.write(b'<?xml version="1.0" encoding="utf-8"?>\n<!DOCTYPE TS>\n')
        tree.write(file, encoding="utf-8", xml_declaration=False)
        file.write(b"\n")
    return missing


def update(language, words, plurals, options):
    file = here / f"loopmend_{language}.ts"
    subprocess.run(["lupdate", "-silent", "-no-obsolete", "-locations", "none", *options, str(app), "-ts", str(file)],
                   check=True, stderr=subprocess.DEVNULL)
    missing = fill(file, words, plurals)
    for source in missing:
        print(f"no words in {language} for:", repr(source))
    return not missing


def main():
    german = json.loads((here / "german.json").read_text(encoding="utf-8"))
    english = json.loads((here / "english_plurals.json").read_text(encoding="utf-8"))
    complete = update("en", {}, english, ["-pluralonly"])
    complete = update("de", german["words"], german["plurals"], []) and complete
    return 0 if complete else 1


if __name__ == "__main__":
    sys.exit(main())
