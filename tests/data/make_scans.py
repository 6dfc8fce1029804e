#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Makes the small scans in this folder: surfaces of our own with bumps, measured noise and faults of real scans.

Usage: make_scans.py FOLDER            writes them there
       make_scans.py --check FOLDER    tells which files there are not what it would write; exit code 1 if any
"""
import math
import random
import sys
from pathlib import Path


def scaled(p, factor):
    return [factor * x for x in p]


def unit(p):
    return scaled(p, 1 / math.sqrt(sum(x * x for x in p)))


def distance(a, b):
    return math.dist(a, b)


def icosphere(level):
    """Points and triangles of the unit sphere, an icosahedron split so often."""
    t = (1 + math.sqrt(5)) / 2
    points = [unit(p) for p in [(-1, t, 0), (1, t, 0), (-1, -t, 0), (1, -t, 0), (0, -1, t), (0, 1, t),
                                (0, -1, -t), (0, 1, -t), (t, 0, -1), (t, 0, 1), (-t, 0, -1), (-t, 0, 1)]]
    triangles = [(0, 11, 5), (0, 5, 1), (0, 1, 7), (0, 7, 10), (0, 10, 11), (1, 5, 9), (5, 11, 4), (11, 10, 2),
                 (10, 7, 6), (7, 1, 8), (3, 9, 4), (3, 4, 2), (3, 2, 6), (3, 6, 8), (3, 8, 9), (4, 9, 5),
                 (2, 4, 11), (6, 2, 10), (8, 6, 7), (9, 8, 1)]
    for _ in range(level):
        middles = {}

        def middle(a, b):
            key = (min(a, b), max(a, b))
            if key not in middles:
                middles[key] = len(points)
                points.append(unit([x + y for x, y in zip(points[a], points[b])]))
            return middles[key]

        split = []
        for a, b, c in triangles:
            ab, bc, ca = middle(a, b), middle(b, c), middle(c, a)
            split += [(a, ab, ca), (ab, b, bc), (ca, bc, c), (ab, bc, ca)]
        triangles = split
    return points, triangles


def grid(columns, rows, wraps, keep=lambda i, j: True):
    """Triangles of a grid of points (point = row · columns + column); with `wraps` the last column meets the first."""
    triangles = []
    for j in range(rows - 1):
        for i in range(columns if wraps else columns - 1):
            if not keep(i, j):
                continue
            right = (i + 1) % columns
            a, b, c, d = j * columns + i, j * columns + right, (j + 1) * columns + right, (j + 1) * columns + i
            triangles += [(a, b, c), (a, c, d)] if (i + j) % 2 == 0 else [(a, b, d), (b, c, d)]
    return triangles


def without(mesh, is_gone):
    """Without the triangles at points for which `is_gone` holds."""
    points, triangles = mesh
    gone = [is_gone(p) for p in points]
    return points, [t for t in triangles if not any(gone[v] for v in t)]


def bumpy(mesh, radius, height):
    """Each point of a unit sphere pushed out or in, by bumps and a little noise."""
    noise = random.Random(7)
    points, triangles = mesh
    moved = []
    for x, y, z in points:
        bump = height * (math.sin(5 * x) * math.sin(4 * y + 1) + 0.4 * math.sin(9 * z + 3 * x)) + noise.gauss(0, 5e-4)
        moved.append(scaled((x, y, z), radius * (1 + bump)))
    return moved, triangles


def ball():
    """A bumpy ball with three holes."""
    holes = [unit(p) for p in [(0, 0, 1), (1, 0.3, -0.2), (-0.5, 1, -0.4)]]
    return bumpy(without(icosphere(3), lambda p: any(distance(p, h) < 0.42 for h in holes)), 10, 0.03)


def ring():
    """What a scanner saw around one hole in a bumpy ball, and no more: a hole and an outer rim."""
    north = (0, 0, 1)
    return bumpy(without(icosphere(4), lambda p: not 0.35 < distance(p, north) < 0.85), 10, 0.03)


def wavy(i, j):
    return [i, j, 0.4 * math.sin(0.7 * i) * math.cos(0.5 * j)]


def touching_holes():
    """A wavy sheet with two holes that have one vertex in common."""
    missing = {(i, j) for first in (3, 5) for i in (first, first + 1) for j in (first, first + 1)}
    return [wavy(i, j) for j in range(13) for i in range(13)], grid(13, 13, False, lambda i, j: (i, j) not in missing)


def crack():
    """A wavy sheet whose two parts were not joined along five vertices: nothing is missing there."""
    points = [wavy(i, j) for j in range(13) for i in range(13)]
    twin = {}
    for i in range(4, 9):
        twin[6 * 13 + i] = len(points)
        points.append(points[6 * 13 + i])
    triangles = grid(13, 13, False)
    half = len(triangles) // 2  # the rows above the crack
    return points, triangles[:half] + [tuple(twin.get(v, v) for v in t) for t in triangles[half:]]


def tube_end():
    """A dented tube, cut straight at one end and aslant at the other."""
    noise = random.Random(11)
    columns, rows = 24, 11
    points = []
    for j in range(rows):
        for i in range(columns):
            u = 2 * math.pi * i / columns
            height = j * (1.2 + 0.25 * math.cos(u))
            radius = 5 + 0.3 * math.sin(2 * u + 0.2 * height) + noise.gauss(0, 3e-3)
            points.append([radius * math.cos(u), radius * math.sin(u), height])
    return points, grid(columns, rows, True)


def text_of(mesh):
    """Wavefront OBJ; coordinates in thousandths, like a scanner's. Points that no triangle uses are left out."""
    points, triangles = mesh
    used = sorted({v for t in triangles for v in t})
    number = {v: k + 1 for k, v in enumerate(used)}
    lines = ["# made by make_scans.py"]
    lines += ["v " + " ".join(f"{x + 0.0:.3f}".replace("-0.000", "0.000") for x in points[v]) for v in used]
    lines += ["f " + " ".join(str(number[v]) for v in t) for t in triangles]
    return "\n".join(lines) + "\n"


def main(arguments):
    check = arguments[:1] == ["--check"]
    folder = Path(arguments[-1])
    wrong = []
    for make in (ball, ring, touching_holes, crack, tube_end):
        path, text = folder / f"{make.__name__}.obj", text_of(make())
        if not check:
            path.write_text(text, encoding="ascii")
        elif not path.exists() or path.read_text(encoding="ascii") != text:
            wrong.append(path)
    for path in wrong:
        print(f"{path}: not what make_scans.py writes")
    return 1 if wrong else 0


if __name__ == "__main__":
    if len(sys.argv) not in (2, 3):
        sys.exit(__doc__)
    sys.exit(main(sys.argv[1:]))
