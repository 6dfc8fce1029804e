#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The reports of real runs follow the schemas of docs/user.

Usage: check_schemas.py LOOPMEND SCHEMA_FOLDER SCAN_FOLDER
Exit code: 0 all well, 1 a report does not follow its schema, 77 the module jsonschema is missing.
"""
import json
import re
import subprocess
import sys
import tempfile
from pathlib import Path

try:
    import jsonschema
except ImportError:
    print("the Python module jsonschema is missing", file=sys.stderr)
    sys.exit(77)

OPTIONS = [[], ["--flow", "none"], ["--continuity", "tangent"], ["--boundary", "exact"], ["--mode", "steps", "--steps", "2"],
           ["--trim-boundary", "3"], ["--stitch"], ["--repair"], ["--weld"], ["--include-outer-rim"], ["--loops", "2"],
           ["--max-edges", "6"], ["--islands", "cover"], ["--mirror"]]


def many_open_tetrahedra(count):
    """As OFF: a loop of three edges each."""
    points = [f"{3 * k + x} {y} {z}" for k in range(count) for x, y, z in ((0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1))]
    faces = [f"3 {4 * k + a} {4 * k + b} {4 * k + c}" for k in range(count) for a, b, c in ((0, 1, 3), (1, 2, 3), (2, 0, 3))]
    return "\n".join(["OFF", f"{len(points)} {len(faces)} 0", *points, *faces]) + "\n"


def names_of_attempts(docs):
    """As the engine, the schema and the page have them."""
    sources = (docs.parent.parent / "engine" / "pipeline").glob("*.cpp")
    engine = {name for source in sources for name in re.findall(r'text_to_say\("([^"]+)"\)', source.read_text())}
    schema = json.loads((docs / "report.schema.json").read_text())["$defs"]["attempt"]["enum"]
    table = (docs / "report.md").read_text().split("### attempts")[1].split("\n## ")[0]
    page = {name for row in re.findall(r"^\| (`.*?) \|", table, re.MULTILINE) for name in re.findall("`([^`]+)`", row)}
    return engine, set(schema), page


def main():
    program, schemas, scans = sys.argv[1], Path(sys.argv[2]), Path(sys.argv[3])
    validators = {name: jsonschema.Draft202012Validator(json.loads((schemas / f"{name}.schema.json").read_text()))
                  for name in ("report", "info")}
    wrong = seen = 0
    engine, *others = names_of_attempts(schemas)
    for place, names in zip(("schema", "page"), others):
        for name in engine ^ names:
            wrong += 1
            print(f"attempt '{name}': {'missing in the' if name in engine else 'only in the'} {place}")

    def check(name, text, what):
        nonlocal wrong, seen
        seen += 1
        for error in validators[name].iter_errors(json.loads(text)):
            wrong += 1
            print(f"{what}: {list(error.absolute_path)}: {error.message}")

    with tempfile.TemporaryDirectory() as folder:
        sample = Path(folder) / "sample.ply"
        subprocess.run([program, "sample", "-o", sample], check=True, capture_output=True)
        many = Path(folder) / "many.off"
        many.write_text(many_open_tetrahedra(1002))
        few = Path(folder) / "few.off"
        few.write_text(many_open_tetrahedra(3))
        for scan in (many, few):
            out = Path(folder) / "out.ply"
            for words in (["info", scan, "--json", "-"], ["fill", scan, "-o", out, "--report", "-"]):
                run = subprocess.run([program, *words], capture_output=True, text=True)
                check("info" if words[0] == "info" else "report", run.stdout, f"{words[0]} {scan.name}")
        for scan in [sample] + sorted(p for p in scans.iterdir() if p.suffix in (".ply", ".obj", ".off", ".stl")):
            run = subprocess.run([program, "info", scan, "--json", "-"], capture_output=True, text=True)
            if run.returncode == 0:
                check("info", run.stdout, f"info {scan.name}")
            # The sample has what the small scans have not, relief and an outer rim; to fill it takes longest.
            for options in OPTIONS[:1] if scan == sample else OPTIONS:
                report = Path(folder) / "report.json"
                report.unlink(missing_ok=True)
                subprocess.run([program, "fill", scan, "-o", Path(folder) / "out.ply", "--report", report, *options],
                               capture_output=True)
                if report.exists():
                    check("report", report.read_text(), f"fill {scan.name} {' '.join(options)}")
    print(f"{seen} reports, {wrong} faults")
    return 1 if wrong or seen < 20 else 0


if __name__ == "__main__":
    sys.exit(main())
