#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Processor time and memory of `loopmend fill` on a scan with thousands of tiny holes.

Usage: tiny_holes.py PROGRAM [--level L] [--holes N] [--folder DIR]

The scan is a bumpy, slightly noisy sphere: an icosphere of 20 * 4^L triangles, out of which one, two or three triangles at a
vertex, or all of them, are taken at random places that share no vertex. It is filled, and then with --max-edges 2, which
leaves all holes: what that takes is reading and writing; the difference is what the holes take.
"""
import argparse
import os
import pathlib
import resource
import subprocess
import tempfile

import numpy as np


def icosphere(level):
    t = (1 + 5**0.5) / 2
    points = np.array([(-1, t, 0), (1, t, 0), (-1, -t, 0), (1, -t, 0), (0, -1, t), (0, 1, t), (0, -1, -t), (0, 1, -t),
                       (t, 0, -1), (t, 0, 1), (-t, 0, -1), (-t, 0, 1)])
    faces = np.array([(0, 11, 5), (0, 5, 1), (0, 1, 7), (0, 7, 10), (0, 10, 11), (1, 5, 9), (5, 11, 4), (11, 10, 2),
                      (10, 7, 6), (7, 1, 8), (3, 9, 4), (3, 4, 2), (3, 2, 6), (3, 6, 8), (3, 8, 9), (4, 9, 5),
                      (2, 4, 11), (6, 2, 10), (8, 6, 7), (9, 8, 1)])
    for _ in range(level):
        edges = np.sort(np.vstack([faces[:, [0, 1]], faces[:, [1, 2]], faces[:, [2, 0]]]), axis=1)
        unique, place = np.unique(edges, axis=0, return_inverse=True)
        a, b, c = len(points) + place.reshape(3, -1)
        points = np.vstack([points, points[unique].mean(axis=1)])
        i, j, k = faces.T
        faces = np.vstack([np.c_[i, a, c], np.c_[j, b, a], np.c_[k, c, b], np.c_[a, b, c]])
    return points / np.linalg.norm(points, axis=1)[:, None], faces


def with_holes(points, faces, holes, random):
    """Faces without those of the holes, and how many holes there are."""
    order = np.argsort(faces.reshape(-1), kind="stable")
    first = np.searchsorted(faces.reshape(-1)[order], np.arange(len(points) + 1))
    used, gone, made = np.zeros(len(points), bool), np.zeros(len(faces), bool), 0
    for vertex in random.permutation(len(points)):
        if made == holes:
            break
        star = list(order[first[vertex]:first[vertex + 1]] // 3)
        fan = [star.pop(0)]
        while len(fan) < (1, 2, 3, 99)[made % 4]:
            beside = [f for f in star if len(set(faces[f]) & set(faces[fan[-1]])) == 2]
            if not beside:
                break
            fan.append(star.pop(star.index(beside[0])))
        corners = np.unique(faces[fan])
        if not used[corners].any():
            used[corners], gone[fan], made = True, True, made + 1
    return faces[~gone], made


def write_ply(path, points, faces):
    rows = np.empty(len(faces), dtype=[("count", "u1"), ("corners", "<i4", 3)])
    rows["count"], rows["corners"] = 3, faces
    header = (f"ply\nformat binary_little_endian 1.0\nelement vertex {len(points)}\nproperty float x\nproperty float y\n"
              f"property float z\nelement face {len(faces)}\nproperty list uchar int vertex_indices\nend_header\n")
    path.write_bytes(header.encode() + points.astype("<f4").tobytes() + rows.tobytes())


def run(*command):
    """Processor seconds, and the peak of memory in MB of this and all earlier runs."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    code = subprocess.run(command, stdout=subprocess.DEVNULL, check=False).returncode
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    if code > 1:
        raise SystemExit(f"{' '.join(command)} ended with {code}")
    return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime, after.ru_maxrss / 1024


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("--level", type=int, default=8)
    parser.add_argument("--holes", type=int, default=60000)
    parser.add_argument("--folder", default=None)
    options = parser.parse_args()
    random = np.random.default_rng(1)
    sphere, faces = icosphere(options.level)
    edge = (4 * np.pi / len(faces) * 4 / 3**0.5)**0.5
    bumps = 1 + 0.05 * np.sin(5 * sphere[:, 0]) * np.cos(4 * sphere[:, 1]) + 0.03 * np.sin(9 * sphere[:, 2])
    points = sphere * bumps[:, None] + random.normal(size=sphere.shape) * edge * 0.05
    faces, holes = with_holes(points, faces, options.holes, random)
    with tempfile.TemporaryDirectory(dir=options.folder) as name:
        scan = pathlib.Path(name) / "scan.ply"
        write_ply(scan, points, faces)
        out = str(pathlib.Path(name) / "out.ply")
        base, base_mb = run(options.program, "fill", str(scan), "-o", out, "--quiet", "--max-edges", "2")
        os.remove(out)
        seconds, peak_mb = run(options.program, "fill", str(scan), "-o", out, "--quiet")
        print(f"{len(faces)} triangles, {holes} holes: {seconds:.2f} s of processor time, {peak_mb:.0f} MB; without the holes "
              f"{base:.2f} s, {base_mb:.0f} MB; {1e6 * (seconds - base) / holes:.1f} microseconds and "
              f"{1024 * (peak_mb - base_mb) / holes:.1f} KB a hole")


if __name__ == "__main__":
    main()
