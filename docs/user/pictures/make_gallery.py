#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The pictures of docs/user/gallery.md: twelve scans, before and after `loopmend fill --auto`.

Usage: make_gallery.py PROGRAM SHARED FOLDER [NAME...]   draws NAME, or all, into FOLDER; prints what the page's table says

SHARED has data/ and scans2/ with the scans, which are not in the repository; where they come from, and under which terms, is on the page.
"""
import json
import subprocess
import sys
import tempfile
from pathlib import Path

# Name, file, further options, view.
SCANS = [
    ("sample", None, [], ["--direction", "0.35,0.1,1"]),
    ("head", "data/head_holes.ply", [], []),
    ("bunny", "data/bunny.ply", [], []),
    ("demosthenes", "data/demosthenes.obj", [], ["--loop", "1"]),
    ("adonis", "scans2/adonis.obj", [], []),
    ("doll", "data/doll.obj", [], ["--loop", "3"]),
    ("plane", "data/plane_holes.obj", [], []),
    ("wall", "scans2/photo_wall.ply", [], []),
    ("face", "scans2/face_raw.ply", [], ["--direction", "0.9,0.15,0.6"]),
    ("skeleton", "scans2/facial_skeleton.ply", [], ["--loop", "4"]),
    ("bust", "data/lps_head.ply", [], ["--direction", "0.2,0.1,1"]),
    ("range", "scans2/range_bun090.ply", [], ["--direction=-0.8,0.3,1"]),
]


# Holes cut into a closed scan: x, y and radius, seen from the front.
CUTS = {"bust": [(-0.83, 2.98, 0.55), (0.15, 3.0, 0.5), (-0.75, 1.05, 0.3), (2.4, -2.4, 0.7), (-2.2, -2.3, 0.5)]}


def with_holes(program, source, target, holes):
    """Writes the scan without the faces that have a corner within a hole."""
    subprocess.run([program, "fill", source, "-o", target, "--quiet"], check=True)
    lines = target.read_text().splitlines()
    vertices, faces, _ = map(int, lines[1].split())
    points = [tuple(map(float, line.split()[:3])) for line in lines[2:2 + vertices]]
    gone = {k for k, (x, y, z) in enumerate(points) if z > 0 and any((x - a)**2 + (y - b)**2 < r * r for a, b, r in holes)}
    kept = [line for line in lines[2 + vertices:2 + vertices + faces] if not gone.intersection(map(int, line.split()[1:]))]
    target.write_text("\n".join(["OFF", f"{vertices} {len(kept)} 0", *lines[2:2 + vertices], *kept]) + "\n")


def draw(program, shared, folder, name, scan, options, view):
    with tempfile.TemporaryDirectory() as work:
        source = Path(shared) / scan if scan else Path(work) / "sample.ply"
        if not scan:
            subprocess.run([program, "sample", "-o", source], check=True, stdout=subprocess.DEVNULL)
        if name in CUTS:
            with_holes(program, source, Path(work) / "cut.off", CUTS[name])
            source = Path(work) / "cut.off"
        filled, report = Path(work) / "filled.ply", Path(work) / "report.json"
        subprocess.run([program, "fill", source, "-o", filled, "--auto", "--report", report, "--quiet", *options], check=False)
        loops = json.loads(report.read_text())["loops"]
        done = [loop for loop in loops if loop["status"] not in ("skipped", "failed")]
        grades = [loop["verdict"]["grade"] for loop in done if "verdict" in loop]
        print(f"{name}: {len(done)} of {len(loops)} loops filled; " + ", ".join(f"{grades.count(g)} {g}" for g in ("good", "look", "bad")) + "; "
              f"{sum(loop['free_vertices'] for loop in done)} new vertices; "
              f"{json.loads(report.read_text())['total_seconds']:.1f} s", flush=True)
        picture = Path(folder) / f"gallery_{name}.png"
        subprocess.run([program, "render", source, filled, "-o", picture, "--color", "plain", "--size", "840x400", *view], check=True,
                       stdout=subprocess.DEVNULL)


def main():
    if len(sys.argv) < 4:
        raise SystemExit(__doc__)
    program, shared, folder, *names = sys.argv[1:]
    for scan in SCANS:
        if not names or scan[0] in names:
            draw(program, shared, folder, *scan)


if __name__ == "__main__":
    main()
