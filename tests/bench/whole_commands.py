#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Processor time of whole `loopmend fill` commands, by stage, beside MeshLib's fillHoleNicely on the same holes.

Writes a table to the standard output. Both run in turn, --runs times; medians. MeshLib's time is that of loading, filling and
saving, without Python's own start. The stages are the report's `seconds` (wall time), summed over all patches, of one more
run with one thread. Needs PyPI's meshlib, which is used for measuring only.
"""
import argparse
import json
import os
import pathlib
import resource
import statistics
import subprocess
import sys
import tempfile

STAGES = ("initial_patch", "survey", "choice", "assemble", "solve", "checks", "rejected", "expected_deviation", "other")


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
        # Loops of one patch have the same seconds.
        patches = {tuple(loop["seconds"].get(stage, 0) for stage in STAGES) for loop in loops if loop.get("seconds")}
        stages = [sum(column) for column in zip(*patches)] or [0] * len(STAGES)
        filled_loops = [loop for loop in loops if loop["free_vertices"] > 0]
        cells = [scan.name, len(filled_loops), sum(loop["free_vertices"] for loop in filled_loops),
                 f"{statistics.median(ours):.2f}", *(f"{seconds:.2f}" for seconds in stages)]
        if theirs:
            other = statistics.median(theirs)
            cells += [answer[1], answer[2], f"{other:.2f}", f"{statistics.median(ours) / other:.1f}"]
        else:
            cells += ["-"] * 4
        return cells


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program", help="loopmend")
    parser.add_argument("scans", nargs="+", type=pathlib.Path)
    parser.add_argument("--runs", type=int, default=3)
    parser.add_argument("--options", default="", help="of loopmend fill, in one string")
    options = parser.parse_args()
    heads = ["scan", "holes", "new vertices", "Loopmend, s", *(stage.replace("_", " ") for stage in STAGES),
             "MeshLib's holes", "its new vertices", "MeshLib, s", "ratio"]
    print("|", " | ".join(heads), "|")
    print("| ---", "| ---:" * (len(heads) - 1), "|")
    for scan in options.scans:
        print("|", " | ".join(map(str, row(options.program, scan, options.runs, options.options.split()))), "|", flush=True)


if __name__ == "__main__":
    if sys.argv[1:2] == ["--peer"]:
        peer(*sys.argv[2:])
    else:
        main()
