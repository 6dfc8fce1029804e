#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The models of docs/user/which_option.md and its pictures, before and after.

Usage: make_cases.py PROGRAM FOLDER   draws all pictures into FOLDER
       make_cases.py --models FOLDER  writes the models alone

The commands are those of the page, so that a picture shows what its command does. The models are formulas, and need nothing but the
standard library. tests/docs/run_commands.py takes them from here, too. The pictures are drawn by `loopmend render`.
"""
import math
import os
import random
import re
import subprocess
import sys
import tempfile
from pathlib import Path


# ---- meshes: lists of points and of faces ----

def write_ply(path, points, faces):
    with open(path, "w", encoding="ascii") as out:
        out.write(f"ply\nformat ascii 1.0\nelement vertex {len(points)}\n")
        out.writelines(f"property double {axis}\n" for axis in "xyz")
        out.write(f"element face {len(faces)}\nproperty list uchar int vertex_indices\nend_header\n")
        out.writelines("{!r} {!r} {!r}\n".format(*p) for p in points)
        out.writelines(f"{len(f)} {' '.join(map(str, f))}\n" for f in faces)


def icosphere(levels):
    g = (1 + 5**0.5) / 2
    points = [unit(p) for p in ((-1, g, 0), (1, g, 0), (-1, -g, 0), (1, -g, 0), (0, -1, g), (0, 1, g), (0, -1, -g), (0, 1, -g),
                                (g, 0, -1), (g, 0, 1), (-g, 0, -1), (-g, 0, 1))]
    faces = [(0, 11, 5), (0, 5, 1), (0, 1, 7), (0, 7, 10), (0, 10, 11), (1, 5, 9), (5, 11, 4), (11, 10, 2), (10, 7, 6), (7, 1, 8),
             (3, 9, 4), (3, 4, 2), (3, 2, 6), (3, 6, 8), (3, 8, 9), (4, 9, 5), (2, 4, 11), (6, 2, 10), (8, 6, 7), (9, 8, 1)]
    for _ in range(levels):
        middles, finer = {}, []
        for a, b, c in faces:
            mids = []
            for i, j in ((a, b), (b, c), (c, a)):
                key = (min(i, j), max(i, j))
                if key not in middles:
                    middles[key] = len(points)
                    points.append(unit([x + y for x, y in zip(points[i], points[j])]))
                mids.append(middles[key])
            x, y, z = mids
            finer += [(a, x, z), (b, y, x), (c, z, y), (x, y, z)]
        faces = finer
    return points, faces


def unit(p):
    length = math.sqrt(sum(x * x for x in p))
    return tuple(x / length for x in p)


def grid(nu, nv, place, closed=False):
    """Triangles over nu by nv cells, diagonals alternating; u and v run from 0 to 1; closed: u = 1 is u = 0."""
    wide = nu if closed else nu + 1
    points = [place(i / nu, j / nv) for j in range(nv + 1) for i in range(wide)]
    faces = []
    for j in range(nv):
        for i in range(nu):
            a, b = j * wide + i, j * wide + (i + 1) % wide
            c, d = a + wide, b + wide
            faces += [(a, b, d), (a, d, c)] if (i + j) % 2 else [(a, b, c), (b, d, c)]
    return points, faces


def join(*meshes):
    points, faces = [], []
    for p, f in meshes:
        faces += [tuple(v + len(points) for v in face) for face in f]
        points += p
    return points, faces


def cut(mesh, gone):
    """Without the faces whose middle is `gone`, and without the vertices that no face uses any more."""
    points, faces = mesh
    kept = [f for f in faces if not gone(*(sum(points[v][k] for v in f) / len(f) for k in range(3)))]
    used = sorted({v for f in kept for v in f})
    number = {v: i for i, v in enumerate(used)}
    return [points[v] for v in used], [tuple(number[v] for v in f) for f in kept]


def move(mesh, place):
    return [tuple(place(*p)) for p in mesh[0]], mesh[1]


def welded(mesh):
    """Vertices at one place become one."""
    number, points = {}, []
    index = []
    for p in mesh[0]:
        key = tuple(round(x, 6) for x in p)
        if key not in number:
            number[key] = len(points)
            points.append(p)
        index.append(number[key])
    return points, [f for f in (tuple(index[v] for v in f) for f in mesh[1]) if len(set(f)) == 3]


def edges_of(faces):
    """The faces at each edge."""
    found = {}
    for i, f in enumerate(faces):
        for k in range(3):
            found.setdefault(tuple(sorted((f[k], f[(k + 1) % 3]))), []).append(i)
    return found


def tidy(mesh):
    """Without the faces that hang by one edge alone, as a good scanner leaves a boundary."""
    for _ in range(3):
        points, faces = mesh
        open_edges = [0] * len(faces)
        for at in edges_of(faces).values():
            if len(at) == 1:
                open_edges[at[0]] += 1
        mesh = points, [f for f, n in zip(faces, open_edges) if n < 2]
    return cut(mesh, lambda *p: False)


# ---- models ----

def pebble(levels=5):
    """A smooth body some 100 wide."""
    def place(x, y, z):
        r = 44 + 5 * math.sin(2.3 * x + 0.4) * math.cos(1.7 * y) + 4 * math.cos(2.1 * z + 1.3 * x) + 2.5 * math.sin(3.1 * y + 1)
        return 1.15 * r * x, 0.95 * r * y, r * z
    return move(icosphere(levels), place)


def ring_hole(x, y):
    """Where the hole of the pebbles is: below 1."""
    return math.hypot(x - 4, y - 2) / (19 + 3 * math.sin(3 * math.atan2(y - 2, x - 4)))


def pebble_with_hole():
    return tidy(cut(pebble(), lambda x, y, z: z > 0 and ring_hole(x, y) < 1))


def tiles():
    def tile(x0, y0):
        def place(u, v):
            x, y = x0 + 50 * u, y0 + 50 * v
            return x, y, 5 * math.sin(x / 16) * math.cos(y / 19) + 0.004 * (x * x - y * y)
        return grid(40, 40, place)
    parts = join(*(tile(x, y) for x in (-50.05, 0.05) for y in (-50.05, 0.05)))
    return cut(parts, lambda x, y, z: math.hypot(x - 3, y + 4) < 17)


def border_of(faces):
    """The boundary as a chain of vertices, the surface on its left; one loop alone."""
    at = edges_of(faces)
    after = {a: b for f in faces for a, b in zip(f, f[1:] + f[:1]) if len(at[tuple(sorted((a, b)))]) == 1}
    chain = [min(after)]
    while after[chain[-1]] != chain[0]:
        chain.append(after[chain[-1]])
    return chain


def box(n, half):
    sides = []
    for axis in range(3):
        for sign in (-1, 1):
            def place(u, v, axis=axis, sign=sign):
                p = [sign] * 3
                p[(axis + 1) % 3], p[(axis + 2) % 3] = 2 * u - 1, 2 * v - 1
                return tuple(x * h for x, h in zip(p, half))
            points, faces = grid(n, n, place)
            sides.append((points, faces if sign > 0 else [f[::-1] for f in faces]))
    return welded(join(*sides))


def strays():
    """Stray triangles stand on edges beside the hole and at its boundary."""
    points, faces = pebble_with_hole()
    points, faces = list(points), list(faces)

    def stand(a, b, shift, up):
        x, y, z = points[a]
        faces.append((a, b, len(points)))
        points.append((x + shift * (4 - x), y + shift * (2 - y), z + up))
    for f in [f for f in faces if points[f[0]][2] > 0 and 1.1 < ring_hole(*points[f[0]][:2]) < 1.3][::9]:
        stand(f[0], f[1], -0.1, 5)
    return points, faces


def block():
    return tidy(cut(box(40, (45, 30, 30)), lambda *p: math.dist(p, (-13, 30, 30)) < 15 or math.dist(p, (45, 30, 30)) < 13))


def turned(profile, around, along):
    """A surface of revolution about z: profile(t) gives radius and height."""
    def place(u, v):
        r, z = profile(v)
        return r * math.cos(2 * math.pi * u), r * math.sin(2 * math.pi * u), z
    return welded(grid(around, along, place, closed=True))


def vase_profile(t):
    """From the middle of the foot up to the mouth."""
    s = math.pi * 0.9 * t
    return 30 * math.sin(s) * (1 + 0.12 * math.cos(2.4 * s)), -48 * math.cos(s)


def bust():
    """Cut flat below, with a hole in its side."""
    def profile(t):
        return (vase_profile(1.11 * (1 - t))[0] if 0 < t < 1 else 0), -vase_profile(1.11 * (1 - t))[1]
    whole = turned(profile, 100, 90)
    below = tidy(cut(whole, lambda *p: p[2] < -25 or math.dist(p, (0, -33, 8)) < 14))
    low = min(p[2] for p in below[0])
    return move(below, lambda x, y, z: (x, y, -25 if z < low + 1e-9 else z))


def vase():
    """Open above, with small holes."""
    spots = [(0, -33, 8, 6), (22, -24, -12, 5), (-20, -22, -20, 7), (12, -28, 24, 4), (-14, -26, 20, 5)]
    return tidy(cut(turned(vase_profile, 110, 90), lambda *p: any(math.dist(p, c[:3]) < c[3] for c in spots)))


def mask():
    """A face, open behind."""
    def height(x, y):
        r = (x / 36)**2 + (y / 48)**2
        nose = 13 * math.exp(-(x / 5.5)**2 - ((y + 3) / 10)**2)
        eyes = -6 * sum(math.exp(-((x - s) / 7)**2 - ((y - 13) / 5)**2) for s in (-14, 14))
        mouth = 3 * math.exp(-(x / 12)**2 - ((y + 22) / 3)**2) - 3 * math.exp(-(x / 12)**2 - ((y + 26) / 2)**2)
        return 30 * math.sqrt(max(0, 1.15 - r)) + nose + eyes + mouth

    def place(u, v):
        x, y = 36 * v * math.cos(2 * math.pi * u), 48 * v * math.sin(2 * math.pi * u)
        return x, y, height(x, y)
    sheet = welded(grid(150, 48, place, closed=True))
    return tidy(cut((sheet[0], [f[::-1] for f in sheet[1]]), lambda x, y, z: math.hypot(x - 17, y + 8) < 7))


def cup():
    """A hollow print whose lip is missing: an outer and an inner wall."""
    def wall(radius, low):
        def profile(t):
            if t < 0.5:
                return radius * math.sin(math.pi * t), low + radius * (1 - math.cos(math.pi * t))
            return radius, low + radius + (84 - low - radius) * (2 * t - 1)
        return turned(profile, 96, 64)
    outer, inner = wall(34, 0), wall(27, 7)
    return join(outer, (inner[0], [f[::-1] for f in inner[1]]))


def owl():
    """A head with two horns, symmetric; one horn is broken off."""
    horns = [unit((s * 0.62, 0.7, 0.15)) for s in (-1, 1)]

    def place(x, y, z):
        r = 40 + 3 * math.cos(3 * y) + 3 * z
        for h in horns:
            d = math.dist((x, y, z), h)
            r += 24 * math.exp(-(d / 0.2)**2) + 2.2 * math.exp(-((d - 0.42) / 0.07)**2)
        for s in (-1, 1):
            d = math.dist((x, y, z), unit((s * 0.42, 0.12, 0.9)))
            r += 2.5 * math.exp(-((d - 0.26) / 0.07)**2) - 2 * math.exp(-(d / 0.12)**2)
        r += 9 * math.exp(-(math.dist((x, y, z), unit((0, -0.2, 1))) / 0.14)**2)
        return r * x, 1.1 * r * y, 0.9 * r * z
    tip = place(*horns[1])
    return tidy(cut(move(icosphere(5), place), lambda *p: math.dist(p, tip) < 21))


def stone(strength=1, hole=0.9):
    """A rough scan."""
    chance = random.Random(7)
    waves = []
    for _ in range(60):
        direction, length = unit([chance.gauss(0, 1) for _ in range(3)]), chance.uniform(7, 16)
        waves.append(([2 * math.pi / length * x for x in direction], chance.uniform(0, 6.3), length / 110))
    points, faces = pebble()
    rough = []
    for p in points:
        h = sum(a * math.sin(sum(k * x for k, x in zip(w, p)) + f) for w, f, a in waves) + chance.gauss(0, 0.06)
        rough.append(tuple(x + strength * h * n for x, n in zip(p, unit(p))))
    return tidy(cut((rough, faces), lambda x, y, z: z > 0 and ring_hole(x, y) < hole))


def island():
    return tidy(cut(pebble(), lambda x, y, z: z > 0 and ring_hole(x, y) < 1 and math.hypot(x - 6, y - 3) > 8))


def crossing():
    """A body with an inner wall; a part of the hole's boundary is bent down through that wall."""
    points, faces = pebble_with_hole()
    points = list(points)
    for v in border_of(faces)[12:30:3]:
        points[v] = tuple(0.91 * x for x in points[v])
    inner = pebble(4)
    return join((points, faces), ([tuple(0.95 * x for x in p) for p in inner[0]], [f[::-1] for f in inner[1]]))


def ragged():
    """Flakes of two triangles hang at the boundary."""
    points, faces = pebble_with_hole()
    points, faces, chain = list(points), list(faces), border_of(faces)
    chance = random.Random(3)
    for k in range(1, len(chain) - 1, 5):
        (x, y, z), up = points[chain[k]], chance.uniform(2, 5)
        p = len(points)
        points += [(x + 0.2 * (4 - x), y + 0.2 * (2 - y), z + up), (x + 0.15 * (4 - x), y + 0.1 * (2 - y), z + 1.9 * up)]
        faces += [(chain[k + 1], chain[k], p), (p, chain[k], p + 1)]
    return points, faces


def terrain():
    """Heights of a landscape; the program that wrote them had none at some places."""
    def place(u, v):
        x, y = 100 * u - 50, 100 * v - 50
        hills = 14 * math.exp(-((x - 12)**2 + (y - 8)**2) / 500) + 9 * math.exp(-((x + 22)**2 + (y + 16)**2) / 300)
        z = hills + 2 * math.sin(x / 9) * math.cos(y / 11)
        missing = math.hypot(x - 8, y - 5) < 11 or math.hypot(x + 25, y - 24) < 5
        return x, y, -9999 if missing else z
    return grid(70, 70, place)


def parts():
    """A ball and two bars through it, each closed."""
    ball = move(icosphere(4), lambda x, y, z: (30 * x, 30 * y, 30 * z))
    return join(ball, box(9, (45, 9, 9)), box(9, (7, 42, 11)))


def plates():
    """A bent plate that broke in two; between the parts is a gap."""
    def part(begin):
        return grid(25, 25, lambda u, v: (begin + 50 * u, 50 * v, 0.006 * (begin + 50 * u)**2))
    return join(part(-56), part(6))


MODELS = {"pebble.ply": pebble_with_hole, "tiles.ply": tiles, "strays.ply": strays, "block.ply": block, "bust.ply": bust,
          "mask.ply": mask, "cup.ply": cup, "head.ply": owl, "stone.ply": stone, "island.ply": island, "crossing.ply": crossing,
          "ragged.ply": ragged, "heights.ply": terrain, "plates.ply": plates, "vase.ply": vase,
          "parts.ply": parts}


# ---- pictures ----

# The picture, the files before and after, the view, and the size where it is another one.
PICTURES = [
    ("hole", "pebble.ply", "filled.ply", "--direction 0.3,-0.8,1.2"),
    ("tiles", "tiles.ply", "one_sheet.ply", "--direction 0.2,-1,1.4"),
    ("strays", "strays.ply", "clean.ply", "--direction 0.3,-0.8,1"),
    ("edges", "block.ply", "block_filled.ply", "--direction 0.5,0.7,1"),
    ("flat", "bust.ply", "bust_filled.ply", "--direction 0.3,-1,-0.5"),
    ("base", "mask.ply", "print.stl", "--direction 1.2,-0.7,0.4"),
    ("wall", "cup.ply", "cup_closed.ply", "--direction 0.3,-0.8,0.8"),
    ("mirror", "head.ply", "head_filled.ply", "--direction 0.3,0.4,1 --size 1180x420"),  # wide: the ear beside the title
    ("rough", "stone.ply", "stone_filled.ply", "--direction 0.1,-0.3,1.2"),
    ("island", "island.ply", "joined.ply", "--direction 0.3,-0.8,1.2"),
    ("crossing", "crossing.ply", "uncrossed.ply", "--direction=-0.5,-0.5,1.2"),
    ("ragged", "ragged.ply", "trimmed.ply", "--direction -0.2,-0.6,1"),
    ("no_data", "heights.ply", "heights_filled.ply", "--loop 1"),
    ("union", "parts_half.ply", "one_body_half.ply", "--direction 0.35,-0.6,1"),
    ("bridge", "plates.ply", "one_plate.ply", "--direction 0.3,-1,0.8"),
    ("opening", "vase.ply", "vase_filled.ply", "--direction 0.1,-1,0.5"),
    ("invented", "pebble.ply", "patches.ply", "--direction 0.3,-0.8,1.2"),
]


def half(run, folder, name):
    """Writes the lower half of a closed surface: from outside, bodies that overlap look like one."""
    run(f"loopmend fill {name}.ply -o {name}.off --quiet")
    lines = (folder / f"{name}.off").read_text().splitlines()
    vertices, faces, _ = map(int, lines[1].split())
    points = [tuple(map(float, line.split()[:3])) for line in lines[2:2 + vertices]]
    corners = [tuple(map(int, line.split()[1:4])) for line in lines[2 + vertices:2 + vertices + faces]]
    write_ply(folder / f"{name}_half.ply", *cut((points, corners), lambda x, y, z: z > 0))


def draw(program, target):
    page = (Path(__file__).resolve().parent.parent / "which_option.md").read_text(encoding="utf-8")
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        (folder / "bin").mkdir()
        (folder / "bin" / "loopmend").symlink_to(Path(program).resolve())
        environment = dict(os.environ, PATH=f"{folder / 'bin'}:{os.environ['PATH']}")

        def run(line):
            subprocess.run(["bash", "-c", line], cwd=folder, env=environment, check=True, stdout=subprocess.DEVNULL)
        for model, make in MODELS.items():
            write_ply(folder / model, *make())
        for block in re.findall(r"^```sh\n(.*?)^```", page, re.M | re.S):
            for line in block.splitlines():
                run(line)
        for name in ("parts", "one_body"):
            half(run, folder, name)
        for picture, before, after, view in PICTURES:
            size = "" if "--size" in view else "--size 1000x420"
            run(f"loopmend render {before} {after} --color plain {size} {view} "
                f"-o {Path(target).resolve() / f'case_{picture}.png'}")


def main():
    if len(sys.argv) != 3:
        raise SystemExit(__doc__)
    if sys.argv[1] != "--models":
        return draw(*sys.argv[1:])
    for name, make in MODELS.items():
        write_ply(Path(sys.argv[2]) / name, *make())


if __name__ == "__main__":
    main()
