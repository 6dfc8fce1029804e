#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes the three scans of irregular_boundaries.md, section 10: the same hole in a clean, a noisy and a rough sphere.
Fills them, draws each before and after, and prints the table of the page.
Usage: three_holes.py PROGRAM FOLDER   (PROGRAM: loopmend; the pictures go into FOLDER)"""
import json
import pathlib
import subprocess
import sys
import tempfile

import numpy as np

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "tests" / "data"))
from make_scans import icosphere  # noqa: E402


def heights(kind, points, edge, random):
    if kind == "noisy":
        return 0.03 * edge * random.standard_normal(len(points))
    if kind == "rough":  # 400 waves in all directions, 2.5 to 20 edges long, the long ones higher
        lengths = 2.5 * 8 ** random.random(400)
        directions = random.standard_normal((400, 3))
        directions *= (2 * np.pi / (lengths * edge) / np.linalg.norm(directions, axis=1))[:, None]
        waves = np.sin(points @ directions.T + 2 * np.pi * random.random(400)) @ lengths
        return 0.1 * edge * waves / waves.std()
    return np.zeros(len(points))


def write(path, points, faces):
    with open(path, "w", encoding="ascii") as file:
        for p in points:
            file.write("v %.17g %.17g %.17g\n" % tuple(p))
        for f in faces + 1:
            file.write("f %d %d %d\n" % tuple(f))


def main():
    program, pictures = sys.argv[1], pathlib.Path(sys.argv[2])
    points, faces = map(np.array, icosphere(5))
    edge = np.mean(np.linalg.norm(points[faces[:, 0]] - points[faces[:, 1]], axis=1))
    faces = faces[~(points[faces] @ np.array([0.36, 0.48, 0.8]) > 0.93).any(axis=1)]  # the hole is a cap
    print("| scan | relief, edges | noise, edges | method | distance | with `--boundary exact` |")
    print("| --- | ---: | ---: | --- | ---: | ---: |")
    for kind in ("clean", "noisy", "rough"):
        random = np.random.default_rng(7)
        scan = points * (1 + heights(kind, points, edge, random))[:, None]
        distances = []
        with tempfile.TemporaryDirectory() as folder:
            given, filled, report = (f"{folder}/{name}" for name in ("scan.obj", "filled.obj", "report.json"))
            write(given, scan, faces)
            for boundary in ("auto", "exact"):
                subprocess.run([program, "fill", given, "-o", filled, "--report", report, "--quiet", "--boundary", boundary],
                               check=True)
                loop = json.loads(pathlib.Path(report).read_text())["loops"][0]
                lines = pathlib.Path(filled).read_text(encoding="ascii").splitlines()
                new = np.array([line.split()[1:4] for line in lines if line.startswith("v ")][len(points):], float)
                distances.append(np.sqrt(np.mean((np.linalg.norm(new, axis=1) - 1) ** 2)) / edge)
                if boundary == "auto":
                    neighborhood, method = loop["neighborhood"], loop["method"]
                    subprocess.run([program, "render", given, filled, "--color", "plain", "--direction", "0.36,0.48,0.8",
                                    "--size", "900x450", "-o", str(pictures / f"{kind}.png")], check=True)
        figures = (neighborhood["relief_per_edge"] or 0, neighborhood["noise_per_edge"] or 0, method, *distances)
        print("| %s | %.2g | %.2g | `%s` | %.2g | %.2g |" % (kind, *figures))


if __name__ == "__main__":
    main()
