# SPDX-License-Identifier: GPL-3.0-or-later
"""Meshes whose answer is known, and the command line's program."""
import os
import subprocess
from pathlib import Path

import numpy as np
import pytest


def icosphere(levels):
    """Vertices on the unit sphere and outward faces: 10 * 4^levels + 2 vertices."""
    g = (1 + 5**0.5) / 2
    vertices = [(-1, g, 0), (1, g, 0), (-1, -g, 0), (1, -g, 0), (0, -1, g), (0, 1, g), (0, -1, -g), (0, 1, -g),
                (g, 0, -1), (g, 0, 1), (-g, 0, -1), (-g, 0, 1)]
    faces = [(0, 11, 5), (0, 5, 1), (0, 1, 7), (0, 7, 10), (0, 10, 11), (1, 5, 9), (5, 11, 4), (11, 10, 2), (10, 7, 6),
             (7, 1, 8), (3, 9, 4), (3, 4, 2), (3, 2, 6), (3, 6, 8), (3, 8, 9), (4, 9, 5), (2, 4, 11), (6, 2, 10),
             (8, 6, 7), (9, 8, 1)]
    vertices = [np.array(v) / np.linalg.norm(v) for v in vertices]
    for _ in range(levels):
        middles, finer = {}, []

        def middle(a, b):
            key = (min(a, b), max(a, b))
            if key not in middles:
                middles[key] = len(vertices)
                v = vertices[a] + vertices[b]
                vertices.append(v / np.linalg.norm(v))
            return middles[key]

        for a, b, c in faces:
            ab, bc, ca = middle(a, b), middle(b, c), middle(c, a)
            finer += [(a, ab, ca), (b, bc, ab), (c, ca, bc), (ab, bc, ca)]
        faces = finer
    return np.array(vertices), np.array(faces)


def without(vertices, faces, gone):
    """The mesh without the vertices for which gone(vertex rows) holds, and without the faces at them."""
    keep = ~gone(vertices)
    number = np.cumsum(keep) - 1
    return vertices[keep], number[faces[keep[faces].all(axis=1)]]


def open_edges(faces):
    """How many directed edges have no face on their other side."""
    edges = {(int(t[k]), int(t[(k + 1) % 3])) for t in faces for k in range(3)}
    assert len(edges) == 3 * len(faces), "an edge has two faces on the same side"
    return sum((b, a) not in edges for a, b in edges)


@pytest.fixture(scope="session")
def sphere():
    """A unit sphere with one round hole at its north pole, 34 degrees wide: vertices, faces."""
    return without(*icosphere(4), lambda v: v[:, 2] > np.cos(np.radians(17)))


@pytest.fixture(scope="session")
def two_holes():
    """A unit sphere with a round hole at each pole, that at the north pole being wider."""
    return without(*icosphere(4), lambda v: (v[:, 2] > np.cos(np.radians(20))) | (v[:, 2] < -np.cos(np.radians(12))))


@pytest.fixture(scope="session")
def program():
    """Runs the command line: program("fill", ...). Skips where LOOPMEND_PROGRAM does not name it."""
    path = os.environ.get("LOOPMEND_PROGRAM", "")
    if not path or not Path(path).exists():
        pytest.skip("LOOPMEND_PROGRAM names no program to compare with")

    def run(*words):
        done = subprocess.run([path, *map(str, words)], capture_output=True, text=True, timeout=300, check=False)
        assert done.returncode in (0, 1), done.stderr
        return done

    return run
