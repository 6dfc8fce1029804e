#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Compares `loopmend fill` with and without --auto on every scan of some folders.

  preparation.py PROGRAM FOLDER... [--largest MB] [--folder FOLDER]

For each scan: loops that are holes and stay open, filled, failed; verdicts look and bad; open, non-manifold and reversed edges and pairs
of triangles that intersect, as `--check` counts them in what was written; triangles of the input that are missing; processor time.
Prints the scans in which one of these differs, and the sum of all; then what --auto makes worse, scan by scan. Exit code: 0 where that is nothing, 1 otherwise.
"""
import argparse
import json
import pathlib
import resource
import subprocess
import sys
import tempfile

FORMATS = {".ply", ".obj", ".off", ".stl", ".glb", ".3mf"}
FIGURES = ["filled", "failed", "left", "look", "bad", "open", "non-manifold", "reversed", "crossings", "removed"]
WORSE_IF_MORE = ["failed", "open", "non-manifold", "reversed", "crossings"]


def processor_time():
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


def removed_faces(report):
    prepared = report["prepared"]
    repaired = prepared.get("repaired", {})
    kinds = ["degenerate_faces", "duplicate_faces", "intersecting_faces", "handle_faces", "removed_faces"]
    return (sum(repaired.get(kind, 0) for kind in kinds) + prepared.get("stitched", {}).get("removed_faces", 0)
            + len(report["trimmed_faces"]))


def figures_of(report):
    loops, check = report["loops"], report["check"]
    is_filled = [loop["status"] not in ("failed", "skipped") for loop in loops]
    grades = [loop["verdict"]["grade"] for loop, filled in zip(loops, is_filled) if filled and loop.get("verdict")]
    return {
        "filled": sum(is_filled),
        "failed": sum(loop["status"] == "failed" for loop in loops),
        "left": sum(loop["status"] == "skipped" for loop in loops),
        "look": grades.count("look"),
        "bad": grades.count("bad"),
        "open": check["open_edges"],
        "non-manifold": check["non_manifold_edges"],
        "reversed": check["reversed_edges"],
        "crossings": check["intersecting_pairs"],
        "removed": removed_faces(report),
    }


def fill(program, scan, folder, options):
    report = folder / "report.json"
    report.unlink(missing_ok=True)
    begin = processor_time()
    command = [program, "fill", scan, "-o", folder / "out.ply", "--report", report, "--check", "--quiet", "--verbose"]
    run = subprocess.run([str(word) for word in command + options], capture_output=True, text=True, check=False)
    if not report.exists():
        return None, run.stderr.strip()
    result = figures_of(json.loads(report.read_text()))
    result["code"], result["s"] = run.returncode, round(processor_time() - begin, 1)
    return result, ""


def scans_in(folders, largest):
    files = [file for folder in folders for file in sorted(pathlib.Path(folder).rglob("*"))]
    return [file for file in files if file.suffix in FORMATS and file.stat().st_size <= largest * 2**20]


def row(name, plain, auto):
    cells = [f"{plain[key]}" if plain[key] == auto[key] else f"{plain[key]} → {auto[key]}"
             for key in FIGURES + ["code", "s"]]
    return f"| {name} | " + " | ".join(cells) + " |"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("folders", nargs="+")
    parser.add_argument("--largest", type=float, default=1e6, help="megabytes; larger files are left out")
    parser.add_argument("--folder", help="where to write; default: a temporary one")
    asked = parser.parse_args()
    work = pathlib.Path(asked.folder or tempfile.mkdtemp())
    print("| scan | " + " | ".join(FIGURES) + " | exit code | s |\n|" + " --- |" * (len(FIGURES) + 3))
    harm, total, count, unreadable = [], [dict.fromkeys(FIGURES + ["code", "s"], 0) for _ in range(2)], 0, 0
    for scan in scans_in(asked.folders, asked.largest):
        (plain, why), (auto, _) = fill(asked.program, scan, work, []), fill(asked.program, scan, work, ["--auto"])
        if plain is None or auto is None:
            unreadable += 1
            if plain is not None:
                harm.append(f"{scan.name}: no output with --auto")
            continue
        count += 1
        if any(plain[key] != auto[key] for key in FIGURES + ["code"]):
            print(row(scan.name, plain, auto), flush=True)
        for sums, one in zip(total, (plain, auto)):
            for key in sums:
                sums[key] = round(sums[key] + one[key], 1)
        harm += [f"{scan.name}: {key} {plain[key]} → {auto[key]}" for key in WORSE_IF_MORE if auto[key] > plain[key]]
        if auto["bad"] - plain["bad"] > max(0, auto["filled"] - plain["filled"]):  # a bad patch where there was none is told
            harm.append(f"{scan.name}: bad {plain['bad']} → {auto['bad']}")
        if auto["filled"] < plain["filled"]:
            harm.append(f"{scan.name}: filled {plain['filled']} → {auto['filled']}")
    print(row("all", *total))
    print(f"\n{count} scans; {unreadable} other files gave no mesh. Worse with `--auto`: {'; '.join(harm) or 'nothing'}.")
    return 1 if harm else 0


if __name__ == "__main__":
    sys.exit(main())
