#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""What a scan carries is in the filled file as it was, element by element, read by a reader that is not ours.

Usage: read_by_others.py LOOPMEND FOLDER. FOLDER is made anew. PLY is read by trimesh, which is fetched from PyPI into a
virtual environment in FOLDER; text OBJ and binary STL are compared statement by statement.
Exit code: 0 all the same, 1 something differs, 77 trimesh is not to be had.
"""
import math
import os
import shutil
import struct
import subprocess
import sys
from pathlib import Path

TRIMESH = ["trimesh==4.5.3", "numpy", "lxml", "networkx"]


def with_trimesh(folder):
    """Starts this script again with an interpreter that has trimesh."""
    environment = folder / "reader"
    made = subprocess.run([sys.executable, "-m", "venv", environment], capture_output=True, check=False)
    if made.returncode == 0:
        made = subprocess.run([environment / "bin/pip", "install", "--quiet", "--disable-pip-version-check", *TRIMESH],
                              capture_output=True, check=False)
    if made.returncode != 0:
        print("skipped: trimesh cannot be installed:", (made.stderr or made.stdout).decode()[-300:])
        sys.exit(77)
    os.execv(environment / "bin/python", [environment / "bin/python", __file__, *sys.argv[1:], "--inside"])


def open_sphere(rows=24, around=40):
    """Points and triangles of a sphere without its caps: the northern one is the hole."""
    points, triangles = [], []
    for row in range(rows):
        angle = math.pi * (0.12 + 0.76 * row / (rows - 1))
        for k in range(around):
            turn = 2 * math.pi * k / around
            points.append((math.sin(angle) * math.cos(turn), math.sin(angle) * math.sin(turn), math.cos(angle)))
    for row in range(rows - 1):
        for k in range(around):
            a, b = row * around + k, row * around + (k + 1) % around
            triangles += [(a, a + around, b), (b, a + around, b + around)]
    return points, triangles


def fill(loopmend, before, after):
    subprocess.run([loopmend, "fill", before, "-o", after, "--loops", "1", "--quiet"], check=True)


def check(same, what):
    print("same:" if same else "DIFFERENT:", what)
    return same


def check_ply(loopmend, folder):
    import numpy
    import trimesh
    points, triangles = open_sphere()
    before, after = folder / "before.ply", folder / "after.ply"
    vertex_types = "<fff fff BBB f d i H".replace(" ", "")
    face_types = "<Biii BBB f b"
    with open(before, "wb") as out:
        out.write(f"""ply
format binary_little_endian 1.0
comment made by a test
element vertex {len(points)}
property float x
property float y
property float z
property float nx
property float ny
property float nz
property uchar red
property uchar green
property uchar blue
property float quality
property double time
property int label
property ushort count
element face {len(triangles)}
property list uchar int vertex_indices
property uchar red
property uchar green
property uchar blue
property float area
property char sign
end_header
""".encode())
        for k, p in enumerate(points):
            color = [int(127 + 127 * x) for x in p]
            out.write(struct.pack(vertex_types, *p, *p, *color, 1 / (k + 1), k / 7, -k, k % 65536))
        for k, t in enumerate(triangles):
            out.write(struct.pack(face_types.replace(" ", ""), 3, *t, k % 256, 2, 3, k / 3, -(k % 100)))
    fill(loopmend, before, after)
    rows = {}
    for path in (before, after):
        raw = trimesh.load(path, process=False).metadata["_ply_raw"]
        rows[path] = {name: raw[name]["data"] for name in ("vertex", "face")}
    good = True
    for element in ("vertex", "face"):
        old, new = rows[before][element], rows[after][element]
        good &= check(len(new) > len(old), f"PLY: the patch has elements {element}")
        for name in old.dtype.names:
            good &= check(old[name].dtype == new[name].dtype and numpy.array_equal(old[name], new[name][:len(old)]),
                          f"PLY: property {name} of {element}")
        good &= check(old.dtype.names == new.dtype.names, f"PLY: the properties of {element} are those of the scan")
    patch = rows[after]["vertex"][len(points):]
    good &= check((patch["red"] <= 180).all() and (patch["red"] >= 70).all(), "PLY: colours of the patch lie in the range of the boundary")
    good &= check(b"comment made by a test\n" in after.read_bytes()[:200], "PLY: the comment")
    return good


def statements(path):
    """The values, and each face with the names that hold for it."""
    values, faces, names = {"v": [], "vt": [], "vn": [], "mtllib": []}, [], {}
    for line in path.read_text().splitlines():
        word, _, rest = line.partition(" ")
        if word in ("g", "o", "s", "usemtl"):
            names[word] = rest
        elif word == "mtllib":
            values[word].append(rest)
        elif word in values:
            values[word].append([float(x) for x in rest.split()])
        elif word == "f":
            faces.append((rest, dict(names)))
    return values, faces


def check_obj(loopmend, folder):
    points, triangles = open_sphere()
    before, after = folder / "before.obj", folder / "after.obj"
    with open(before, "w", encoding="ascii") as out:
        out.write("mtllib skin.mtl\no ball\n")
        for p in points:
            out.write("v {:.6f} {:.6f} {:.6f}\nvn {:.4f} {:.4f} {:.4f}\n".format(*p, *p))
        for k in range(3 * len(triangles)):
            out.write(f"vt {k % 97 / 97:.5f} {k % 89 / 89:.5f}\n")
        for k, t in enumerate(triangles):
            if k % 300 == 0:
                out.write(f"g part{k // 300}\nusemtl {'red' if k % 600 else 'blue'}\ns {k // 300 % 2}\n")
            out.write("f " + " ".join(f"{v + 1}/{3 * k + c + 1}/{v + 1}" for c, v in enumerate(t)) + "\n")
    fill(loopmend, before, after)
    (old, old_faces), (new, new_faces) = statements(before), statements(after)
    good = True
    for name, values in old.items():
        good &= check(values == new[name][:len(values)], f"OBJ: statements {name}")
    good &= check(old_faces == new_faces[:len(old_faces)], "OBJ: faces with their corners, groups and materials")
    patch = new_faces[len(old_faces):]
    good &= check(bool(patch) and all(names["usemtl"] == "blue" and names["g"] == "part0" for _, names in patch),
                  "OBJ: the patch is of the group and material around it")
    good &= check(all(corner.count("/") == 2 for face, _ in patch for corner in face.split()), "OBJ: the patch has normals")
    return good


def check_stl(loopmend, folder):
    points, triangles = open_sphere()
    before, after = folder / "before.stl", folder / "after.stl"
    rows = [struct.pack("<12fH", 0, 0, 0, *points[t[0]], *points[t[1]], *points[t[2]], k % 65536 | 32768)
            for k, t in enumerate(triangles)]
    header = b"COLOR=\x01\x02\x03\xff".ljust(80, b" ")
    before.write_bytes(header + struct.pack("<I", len(rows)) + b"".join(rows))
    fill(loopmend, before, after)
    data = after.read_bytes()
    good = check(data[:80] == header, "STL: the header")
    new = [data[84 + 50 * k:134 + 50 * k] for k in range(len(rows))]
    return good & check([row[12:] for row in rows] == [row[12:] for row in new], "STL: corners and attributes of every facet")


def check_others(loopmend, folder):
    """glTF and 3MF that trimesh has written, filled; and what it reads of the outputs."""
    import numpy
    import trimesh
    points, triangles = open_sphere()
    points = numpy.array(points, dtype=numpy.float32).astype(float)
    good = True
    for ending in ("glb", "3mf"):
        before, after = folder / f"before.{ending}", folder / f"after.{ending}"
        trimesh.Trimesh(points, triangles, process=False).export(before)
        fill(loopmend, before, after)
        (old,), (new,) = (tuple(trimesh.load(path, force="scene", process=False).geometry.values()) for path in (before, after))
        good &= check(numpy.array_equal(old.vertices, new.vertices[:len(old.vertices)]), f"{ending}: coordinates of the scan")
        good &= check(numpy.array_equal(old.faces, new.faces[:len(old.faces)]), f"{ending}: triangles of the scan")
        good &= check(len(new.faces) > len(old.faces), f"{ending}: the patch")
        good &= check(new.is_winding_consistent, f"{ending}: all triangles are turned alike")
    return good


def main():
    loopmend, folder = Path(sys.argv[1]).resolve(), Path(sys.argv[2])
    if "--inside" not in sys.argv:
        shutil.rmtree(folder, ignore_errors=True)
        folder.mkdir(parents=True)
        with_trimesh(folder)
    results = [check_ply(loopmend, folder), check_obj(loopmend, folder), check_stl(loopmend, folder), check_others(loopmend, folder)]
    return 0 if all(results) else 1


if __name__ == "__main__":
    sys.exit(main())
