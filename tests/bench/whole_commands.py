#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Processor time of whole `loopmend fill` commands beside MeshLib's fillHoleNicely on the same holes, and where it goes.

Writes a table to the standard output. Both run in turn, --runs times; medians. MeshLib's time is that of loading, filling and
saving, without Python's own start. With --stages the table is another one: the share of each stage in the instructions of one
run with one thread, counted by valgrind --tool=callgrind, so that it does not depend on the load. The program must have its
symbols, and a second of processor time takes about a minute. Needs PyPI's meshlib, which is used for measuring only.
"""
import argparse
import collections
import json
import os
import pathlib
import re
import resource
import statistics
import subprocess
import sys
import tempfile

# What counts for each stage: calls of functions by these names, and of one by another where it is to be taken off. No two of these
# lie within each other. What is left over is "other": the choice of loops and candidates, pasting, the start of the program.
STAGES = {
    "reading": ["read_mesh"],
    "view": ["flat_view", "view_around"],
    "initial patches": ["make_initial_patch", "fill_loop_uncut"],
    "relief estimate": ["estimate_split"],
    "boundary fits": ["boundary_fits"],
    "outliers": ["remove_outliers"],
    "sharp edges": ["continue_sharp_edges"],
    "fairing": ["RobustFairing::step"],
    "split": ["SplitDescent::step", "-SplitDescent::fair"],
    "flow": ["Multilevel::step"],
    "checks": ["validate", "seam_reports", "Judge::operator()"],
    "error bar": ["expected_deviation"],
    "writing": ["write_scan"],
}


def profile(path):
    """Instructions in all, and of each function of a callgrind file with what it calls."""
    names, inclusive, total = {}, collections.Counter(), 0

    def name_of(text):
        number, _, name = text.partition(" ")
        if name:
            names[number] = re.sub(r"^loopmend::|\(anonymous namespace\)::", "", name)
        return re.sub(r"\((?!\)).*", "", names[number])

    callee = None
    with open(path, encoding="utf-8") as file:
        for line in file:
            if line.startswith("fn="):
                name_of(line[3:].strip())
            elif line.startswith("cfn="):
                called = name_of(line[4:].strip())
            elif line.startswith("calls="):
                callee = called
            elif line[0] in "0123456789+-*" and len(line.split()) > 1:
                count = int(line.split()[1])
                if callee is None:
                    total += count
                else:
                    inclusive[callee] += count
                callee = None
    return total, inclusive


def stage_row(program, scan, options):
    with tempfile.TemporaryDirectory() as folder:
        counts, filled = os.path.join(folder, "counts"), os.path.join(folder, "filled.ply")
        subprocess.run(["valgrind", "--tool=callgrind", f"--callgrind-out-file={counts}", program, "fill", str(scan), "-o", filled,
                        "--quiet", "--threads", "1", *options], capture_output=True, check=False)
        total, inclusive = profile(counts)
    shares = []
    for functions in STAGES.values():
        signed = ((-1, f[1:]) if f.startswith("-") else (1, f) for f in functions)
        shares.append(100 * sum(sign * inclusive[function] for sign, function in signed) / total)
    return [scan.name, f"{total / 1e9:.2f}", *(f"{share:.0f}" for share in [*shares, 100 - sum(shares)])]


def peer(source, target, report):
    """Fills by MeshLib the holes that the report has as filled, told by their perimeters."""
    import meshlib.mrmeshpy as mm
    with open(report, encoding="utf-8") as file:
        filled = [loop["perimeter"] for loop in json.load(file)["loops"] if loop["free_vertices"] > 0]
    start = resource.getrusage(resource.RUSAGE_SELF)
    mesh = mm.loadMesh(source)
    done, before = 0, mesh.topology.numValidVerts()
    for edge in mesh.topology.findHoleRepresentiveEdges():
        perimeter = mesh.holePerimeter(edge)
        if not any(abs(p - perimeter) < 1e-4 * p for p in filled):
            continue
        settings = mm.FillHoleNicelySettings()
        settings.triangulateParams.metric = mm.getUniversalMetric(mesh)
        settings.subdivideSettings.maxEdgeLen = float(mesh.averageEdgeLength())
        settings.subdivideSettings.maxEdgeSplits = 100000
        settings.smoothCurvature = True
        mm.fillHoleNicely(mesh, edge, settings)
        done += 1
    mm.saveMesh(mesh, target)
    end = resource.getrusage(resource.RUSAGE_SELF)
    print(end.ru_utime + end.ru_stime - start.ru_utime - start.ru_stime, done, mesh.topology.numValidVerts() - before)


def processor_time(command):
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    code = subprocess.run(command, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, check=False).returncode
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    if code not in (0, 1):
        sys.exit(f"{' '.join(command)} ended with status {code}")
    return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


def row(program, scan, runs, options):
    with tempfile.TemporaryDirectory() as folder:
        report, filled = os.path.join(folder, "report.json"), os.path.join(folder, "filled.ply")
        fill = [program, "fill", str(scan), "-o", filled, "--quiet", *options]
        processor_time([*fill, "--threads", "1", "--report", report])
        with open(report, encoding="utf-8") as file:
            loops = json.load(file)["loops"]
        ours, theirs, answer = [], [], ["0", "0", "0"]
        for _ in range(runs):
            ours.append(processor_time(fill))
            run = subprocess.run([sys.executable, __file__, "--peer", str(scan), filled, report], capture_output=True,
                                 text=True, check=False)
            if run.returncode == 0:
                answer = run.stdout.split()
                theirs.append(float(answer[0]))
        filled_loops = [loop for loop in loops if loop["free_vertices"] > 0]
        cells = [scan.name, len(filled_loops), sum(loop["free_vertices"] for loop in filled_loops),
                 f"{statistics.median(ours):.2f}"]
        if theirs:
            other = statistics.median(theirs)
            cells += [answer[1], answer[2], f"{other:.2f}", f"{statistics.median(ours) / other:.1f}"]
        else:
            cells += ["-"] * 4
        return cells


def table(heads, rows):
    print("|", " | ".join(heads), "|")
    print("| ---", "| ---:" * (len(heads) - 1), "|")
    for cells in rows:
        print("|", " | ".join(map(str, cells)), "|", flush=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program", help="loopmend")
    parser.add_argument("scans", nargs="+", type=pathlib.Path)
    parser.add_argument("--runs", type=int, default=3)
    parser.add_argument("--stages", action="store_true", help="where the time goes, instead")
    parser.add_argument("--options", default="", help="of loopmend fill, in one string")
    options = parser.parse_args()
    if options.stages:
        table(["scan", "10⁹ instructions", *(f"{stage}, %" for stage in STAGES), "other, %"],
              (stage_row(options.program, scan, options.options.split()) for scan in options.scans))
        return
    table(["scan", "holes", "new vertices", "Loopmend, s", "MeshLib's holes", "its new vertices", "MeshLib, s", "ratio"],
          (row(options.program, scan, options.runs, options.options.split()) for scan in options.scans))


if __name__ == "__main__":
    if sys.argv[1:2] == ["--peer"]:
        peer(*sys.argv[2:])
    else:
        main()
