#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The reports of real runs follow the schemas of docs/user.

Usage: check_schemas.py LOOPMEND SCHEMA_FOLDER SCAN_FOLDER
Exit code: 0 all well, 1 a report does not follow its schema, 77 the module jsonschema is missing.
"""
import json
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
           ["--max-edges", "6"], ["--islands", "cover"]]


def main():
    program, schemas, scans = sys.argv[1], Path(sys.argv[2]), Path(sys.argv[3])
    validators = {name: jsonschema.Draft202012Validator(json.loads((schemas / f"{name}.schema.json").read_text()))
                  for name in ("report", "info")}
    wrong = seen = 0

    def check(name, text, what):
        nonlocal wrong, seen
        seen += 1
        for error in validators[name].iter_errors(json.loads(text)):
            wrong += 1
            print(f"{what}: {list(error.absolute_path)}: {error.message}")

    with tempfile.TemporaryDirectory() as folder:
        sample = Path(folder) / "sample.ply"
        subprocess.run([program, "sample", "-o", sample], check=True, capture_output=True)
        for scan in [sample] + sorted(p for p in scans.iterdir() if p.suffix in (".ply", ".obj", ".off", ".stl")):
            run = subprocess.run([program, "info", scan, "--json", "-"], capture_output=True, text=True)
            if run.returncode == 0:
                check("info", run.stdout, f"info {scan.name}")
            for options in OPTIONS:
                if scan == sample and "--include-outer-rim" in options:
                    continue  # a minute's work
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
