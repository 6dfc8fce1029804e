#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Keeps the translations in step with the sources.

Run it after strings have changed: it calls lupdate, fills loopmend_de.ts from german.json, writes the English plurals,
and tells which strings have no German words yet.
"""
import json
import subprocess
import sys
import xml.etree.ElementTree as ET
from pathlib import Path

here = Path(__file__).resolve().parent
app = here.parent.parent / "app"


def fill(path, words, plurals):
    tree = ET.parse(path)
    missing = []
    for message in tree.getroot().iter("message"):
        source = message.find("source").text
        target = message.find("translation")
        target.attrib.pop("type", None)
        for child in list(target):
            target.remove(child)
        if message.get("numerus"):
            for form in plurals.get(source, [source, source]):
                ET.SubElement(target, "numerusform").text = form
        elif words is None:
            target.text = source
        elif source in words:
            target.text = words[source]
        else:
            target.set("type", "unfinished")
            missing.append(source)
    ET.indent(tree, "    ")
    with open(path, "wb") as file:
        file.write(b'<?xml version="1.0" encoding="utf-8"?>\n<!DOCTYPE TS>\n')
        tree.write(file, encoding="utf-8", xml_declaration=False)
        file.write(b"\n")
    return missing


def main():
    files = [here / "loopmend_en.ts", here / "loopmend_de.ts"]
    for file in files:
        subprocess.run(["lupdate", "-silent", "-no-obsolete", "-locations", "none", str(app), "-ts", str(file)],
                       check=True, stderr=subprocess.DEVNULL)
    german = json.loads((here / "german.json").read_text(encoding="utf-8"))
    english = json.loads((here / "english_plurals.json").read_text(encoding="utf-8"))
    fill(files[0], None, english)
    missing = fill(files[1], german["words"], german["plurals"])
    for source in missing:
        print("no German for:", repr(source))
    return 1 if missing else 0


if __name__ == "__main__":
    sys.exit(main())
