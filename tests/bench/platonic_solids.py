#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""How far `loopmend interpolate` leaves the sphere through the vertices of the Platonic solids, as a Markdown table.

Usage: platonic_solids.py LOOPMEND
"""
import os
import itertools
import subprocess
import sys
import tempfile
from pathlib import Path

GOLDEN = (1 + 5**0.5) / 2


def signs(*values):
    """All vectors that differ from this one in signs alone."""
    return sorted(set(itertools.product(*[(-v, v) for v in values])))


def cyclic(vectors):
    return sorted({(v[k], v[(k + 1) % 3], v[(k + 2) % 3]) for v in vectors for k in range(3)})


def off(points):
    """The convex hull: a face in each plane that has all points on one side."""
    faces = set()
    for a, b, c in itertools.permutations(range(len(points)), 3):
        u = [points[b][k] - points[a][k] for k in range(3)]
        v = [points[c][k] - points[a][k] for k in range(3)]
        n = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]]
        height = [sum(n[k] * (p[k] - points[a][k]) for k in range(3)) for p in points]
        if max(height) < 1e-9:
            faces.add((frozenset(i for i, h in enumerate(height) if h > -1e-9)))
    lines = ["OFF", f"{len(points)} {len(faces)} 0"] + [" ".join(map(repr, p)) for p in points]
    for face in sorted(map(sorted, faces)):
        middle = [sum(points[i][k] for i in face) / len(face) for k in range(3)]
        ring, left = [face[0]], set(face[1:])
        while left:  # counter-clockwise: each next one leaves all others to its left
            a = points[ring[-1]]

            def turns(i):
                p = points[i]
                cross = [(p[(k + 1) % 3] - a[(k + 1) % 3]) * middle[(k + 2) % 3]
                         - (p[(k + 2) % 3] - a[(k + 2) % 3]) * middle[(k + 1) % 3] for k in range(3)]
                return all(sum(-cross[k] * (points[j][k] - a[k]) for k in range(3)) > -1e-9 for j in face)

            following = min((i for i in left if turns(i)), key=lambda i: sum((points[i][k] - a[k])**2 for k in range(3)))
            ring.append(following)
            left.remove(following)
        lines.append(f"{len(ring)} " + " ".join(map(str, ring)))
    return "\n".join(lines) + "\n"


def distance(program, text, subdivisions):
    with tempfile.TemporaryDirectory() as folder:
        (Path(folder) / "in.off").write_text(text)
        subprocess.run([program, "interpolate", "in.off", "-o", "out.off", "--subdivide", str(subdivisions), "--quiet"],
                       cwd=folder, check=True)
        lines = (Path(folder) / "out.off").read_text().split("\n")
        count = int(lines[1].split()[0])
        radii = [sum(float(x)**2 for x in line.split()[:3])**0.5 for line in lines[2:2 + count]]
    return max(abs(r / radii[0] - 1) for r in radii)


def main():
    solids = {
        "tetrahedron": [p for p in signs(1.0, 1.0, 1.0) if p[0] * p[1] * p[2] > 0],
        "octahedron": cyclic(signs(1.0, 0.0, 0.0)),
        "cube": signs(1.0, 1.0, 1.0),
        "icosahedron": cyclic(signs(0.0, 1.0, GOLDEN)),
        "dodecahedron": signs(1.0, 1.0, 1.0) + cyclic(signs(0.0, 1 / GOLDEN, GOLDEN)),
    }
    print("| solid | 2 subdivisions | 3 | 4 |\n| --- | ---: | ---: | ---: |")
    for name, points in solids.items():
        text = off(points)
        print(f"| {name} | " + " | ".join(f"{distance(os.path.abspath(sys.argv[1]), text, k):.1e}" for k in (2, 3, 4)) + " |")


if __name__ == "__main__":
    main()
