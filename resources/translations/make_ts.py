#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes the translations of the window from its sources, as the build does.

Usage: make_ts.py FOLDER   writes loopmend_de.ts and loopmend_en.ts there
       make_ts.py --check  exit code 1 where a string has no translation

It calls lupdate, adds what the engine says (core/message.h) as context "Message", and fills loopmend_de.ts from german.json and loopmend_en.ts, which has plural forms only (all else is English in
the sources), from english_plurals.json. It names the strings that are not translated yet.
"""
import json
import re
import shutil
import subprocess
import sys
import tempfile
import xml.etree.ElementTree as ET
from pathlib import Path

here = Path(__file__).resolve().parent
app = here.parent.parent / "app"
lupdate = next((tool for tool in (shutil.which("lupdate", path="/usr/lib/qt5/bin"), shutil.which("lupdate")) if tool), None)


def said():
    """The literals in calls of say() and text_to_say(). Not those that the window never shows: it has a substitute
    (message_words.cpp), or they name an option and are the command line's alone."""
    literal = r'"(?:[^"\\\n]|\\.)*"'
    call = re.compile(rf'\b(?:say|text_to_say)\(\s*((?:{literal}\s*)+)')
    texts = set()
    for source in [*app.parent.glob("engine/**/*"), *app.glob("**/*")]:
        if source.suffix not in (".h", ".cpp") or app / "cli" in source.parents:
            continue
        for found in call.findall(source.read_text(encoding="utf-8")):
            texts.add("".join(json.loads(part) for part in re.findall(literal, found)))
    table = (app / "document" / "message_words.cpp").read_text(encoding="utf-8")
    for found in re.findall(rf"\{{((?:\s*{literal})+),\s*QT_TRANSLATE_NOOP", table):
        texts.discard("".join(json.loads(part) for part in re.findall(literal, found)))
    return sorted(text for text in texts if not re.search(r"--\w|'loopmend ", text))


def add_said(tree):
    context = next((c for c in tree.getroot().iter("context") if c.find("name").text == "Message"), None)
    if context is None:
        context = ET.SubElement(tree.getroot(), "context")
        ET.SubElement(context, "name").text = "Message"
    known = {source.text for source in context.iter("source")}
    for text in said():
        if text not in known:
            message = ET.SubElement(context, "message")
            ET.SubElement(message, "source").text = text
            ET.SubElement(message, "translation")


def misfiled(tree):
    """What would stay English although german.json has it: contexts that the sources look up and lupdate did not file, and
    lines at which it loses the name of the class, since it takes a lone digit separator for the start of a character."""
    contexts = {context.find("name").text for context in tree.getroot().iter("context")}
    found = []
    for source in sorted(app.glob("**/*.cpp")):
        if app / "cli" in source.parents:
            continue
        text = source.read_text(encoding="utf-8")
        looked_up = set(re.findall(r'\btranslate\(\s*"([\w:]+)"', text))
        found += [f"{source.name}: no text has the context {name}" for name in sorted(looked_up - contexts)]
        if re.search(r"\btr\(", text):
            found += [f"{source.name}: lupdate cannot read {number}" for number in re.findall(r"\b\d+(?:'\d+)+", text)
                      if number.count("'") % 2]
    return found


def fill(tree, words, plurals):
    """Writes the words into the tree. Returns the strings that have none, or have one with other places."""
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
            places = [sorted(re.findall(r"%L?[1-9n]", text)) for text in (source, target.text or "")]
            found = found and places[0] == places[1]
        if not found:
            target.set("type", "unfinished")
            missing.append(source)
    return missing


def make(folder, language, words, plurals, options):
    """Returns whether every string is translated. A file that is right already keeps its time, so that nothing is built again."""
    name = f"loopmend_{language}.ts"
    with tempfile.TemporaryDirectory() as scratch:
        made = Path(scratch) / name
        subprocess.run([lupdate, "-silent", "-locations", "none", *options, str(app), "-ts", str(made)],
                       check=True, stderr=subprocess.DEVNULL)
        tree = ET.parse(made)
        if language != "en":
            add_said(tree)
        missing = fill(tree, words, plurals)
        wrong = misfiled(tree) if language != "en" else []
        tree.write(made, encoding="utf-8", xml_declaration=True)
        text = made.read_bytes()
    if folder and not ((folder / name).exists() and (folder / name).read_bytes() == text):
        (folder / name).write_bytes(text)
    for source in missing:
        print(f"not translated ({language}):", repr(source))
    for problem in wrong:
        print(problem)
    return not missing and not wrong


def main(argument):
    if not lupdate:
        sys.exit("lupdate of Qt 5 is missing (Debian: qttools5-dev-tools)")
    folder = None if argument == "--check" else Path(argument)
    german = json.loads((here / "german.json").read_text(encoding="utf-8"))
    english = json.loads((here / "english_plurals.json").read_text(encoding="utf-8"))
    complete = make(folder, "en", {}, english, ["-pluralonly"])
    complete = make(folder, "de", german["words"], german["plurals"], []) and complete
    return 0 if complete or folder else 1


if __name__ == "__main__":
    sys.exit(main(*sys.argv[1:]))
