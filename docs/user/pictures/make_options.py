#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The pictures of docs/user/holes_and_options.md: kinds of loops, density, continuity; of docs/user/which_option.md: edges, boundary,
islands; and of docs/user/first_hole.md: numbers of loops.

Usage: make_options.py PROGRAM FOLDER [NAME...]   writes option_kinds.png, option_density.png, option_continuity.png, option_edges.png,
                                                  option_boundary.png, option_islands.png and first_hole_numbers.png into FOLDER, or
                                                  only those of these names (such as kinds)

The models are formulas of make_cases.py. Needs NumPy, PyVista and Pillow, and xvfb-run where there is no display.
"""
import json
import math
import subprocess
import sys
import tempfile
from pathlib import Path

import numpy as np
import pyvista
from PIL import Image, ImageDraw, ImageFont

sys.dont_write_bytecode = True
sys.path.insert(0, str(Path(__file__).resolve().parent))
import make_cases  # noqa: E402

COLORS = {"hole": "#b5095f", "outer rim": "#707070", "crack": "#1f6fb4", "cut": "#d9781a"}
SCAN, INSIDE, PATCH = "#d6d0c8", "#a08d80", "#f0b878"
FONT = "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf"


def surface(path):
    return pyvista.read(path)


def panel(mesh, view, loops=(), edges=False, up=(0, 1, 0), zoom=1.5, size=(380, 320), given=None, labels=None):
    """@param given   number of faces of the scan, where those behind them, the patch, get a color of their own
    @param labels  places, and what is written there
    """
    plotter = pyvista.Plotter(off_screen=True, window_size=(2 * size[0], 2 * size[1]))
    plotter.set_background("white")
    look = {"ambient": 0.25, "specular": 0.1, "smooth_shading": not edges, "show_edges": edges, "edge_color": "#57534e", "line_width": 2}
    if given is None:
        smooth = mesh.compute_normals(cell_normals=False, feature_angle=40, split_vertices=True)
        plotter.add_mesh(smooth, color=SCAN, backface_params={"color": INSIDE}, **look)
    else:
        for color, part in ((SCAN, range(given)), (PATCH, range(given, mesh.n_cells))):
            shown = mesh.extract_cells(part).extract_surface(algorithm=None)
            plotter.add_mesh(shown.compute_normals(cell_normals=False, feature_angle=40, split_vertices=True), color=color, **look)
    extent = np.ptp(np.array(mesh.bounds).reshape(3, 2), axis=1)
    for kind, points in loops:
        plotter.add_mesh(pyvista.lines_from_points(points, close=True).tube(radius=0.007 * extent.max()), color=COLORS[kind])
    middle = np.array(mesh.bounds).reshape(3, 2).mean(axis=1)
    plotter.camera_position = [middle + 2.4 * np.linalg.norm(extent) * np.array(view) / np.linalg.norm(view), middle, up]
    plotter.camera.zoom(zoom)
    if labels is not None:
        plotter.add_point_labels(*labels, shape=None, show_points=False, always_visible=True, font_size=44, bold=True, text_color="#222222",
                                 justification_horizontal="center", justification_vertical="center")
    plotter.enable_anti_aliasing("ssaa")
    image = Image.fromarray(plotter.screenshot(return_img=True)).resize(size, Image.LANCZOS)
    plotter.close()
    return image


def sheet(images, texts, path, columns, colors=None):
    """Captions are legible where the whole picture is 366 pixels wide, as on a telephone."""
    wide, high = images[0].size
    font = ImageFont.truetype(FONT, round(0.03 * wide * columns))
    head = round(1.7 * font.size)
    made = Image.new("RGB", (wide * columns, (high + head) * -(-len(images) // columns)), "white")
    pen = ImageDraw.Draw(made)
    for k, (image, text) in enumerate(zip(images, texts)):
        x, y = k % columns * wide, k // columns * (high + head)
        made.paste(image, (x, y + head))
        pen.text((x + 10, y + head // 5), text, fill="#222222", font=font)
    if colors:
        made = made.quantize(colors, dither=Image.Dither.NONE)
    made.save(path, optimize=True)


def slit():
    """A sheet in which two sides lie at the same place and are not joined: a crack, and nothing is missing."""
    points, faces = make_cases.grid(20, 12, lambda u, v: (100 * u - 50, 60 * v, 0.006 * (100 * u - 50)**2))
    points, copy = list(points), {}
    for i in range(5, 16):
        copy[6 * 21 + i] = len(points)
        points.append(points[6 * 21 + i])
    return points, [tuple(copy.get(v, v) for v in f) if sum(points[v][1] for v in f) > 3 * 30 else f for f in faces]


def fin():
    """A sheet on which another one stands: three triangles meet at each edge between them."""
    points, faces = make_cases.grid(20, 12, lambda u, v: (100 * u - 50, 50 * v, 0))
    points, faces = list(points), list(faces)
    row = [j * 21 + 10 for j in range(13)]
    below = row
    for k in range(1, 5):
        above = []
        for v in row:
            x, y, _ = points[v]
            above.append(len(points))
            points.append((x + 1.2 * k, y, 6.0 * k))
        for a, b, c, d in zip(below, below[1:], above, above[1:]):
            faces += [(a, b, d), (a, d, c)]
        below = above
    return points, faces


def kinds(program, folder, work):
    shown = [("hole", make_cases.pebble_with_hole, (0.3, -0.8, 1.2), 1.6), ("outer rim (grey)", make_cases.mask, (0.9, -0.3, 1), 1.5),
             ("crack (blue)", slit, (0.2, -1, 1.6), 1.5), ("cut (orange)", fin, (0.6, -1, 1), 1.3)]
    images = []
    for text, model, view, zoom in shown:
        path = work / "model.ply"
        points, faces = model()
        make_cases.write_ply(path, points, faces)
        found = json.loads(subprocess.run([program, "info", path, "--json", "-"], check=True, capture_output=True, text=True).stdout)
        loops = [(loop["kind"], np.array(points)[loop["vertices"]]) for loop in found["loops"]]
        print(text, [kind for kind, _ in loops])
        images.append(panel(surface(path), view, loops, zoom=zoom))
    sheet(images, [text for text, *_ in shown], Path(folder) / "option_kinds.png", 2)


def numbers(program, folder, work):
    """The sample with the number of each loop."""
    subprocess.run([program, "sample", "-o", work / "sample.ply"], check=True, stdout=subprocess.DEVNULL)
    found = json.loads(subprocess.run([program, "info", work / "sample.ply", "--json", "-"], check=True, capture_output=True, text=True).stdout)
    mesh = surface(work / "sample.ply")
    loops = [(loop["kind"], mesh.points[loop["vertices"]]) for loop in found["loops"]]
    # The outline has its number at its right side, a hole above it.
    places = [(points[:, 0].max() + 7, 0, 0) if kind == "outer rim" else (points[:, 0].mean(), points[:, 1].max() + 5, points[:, 2].max())
              for kind, points in loops]
    labels = [str(loop["number"]) for loop in found["loops"]]
    panel(mesh, (0, 0, 1), loops, zoom=1.55, size=(420, 400), labels=(np.array(places), labels)).quantize(128).save(
        Path(folder) / "first_hole_numbers.png", optimize=True)


def density(program, folder, work):
    images, texts = [], []
    make_cases.write_ply(work / "pebble.ply", *make_cases.tidy(make_cases.cut(
        make_cases.pebble(4), lambda x, y, z: z > 0 and make_cases.ring_hole(x, y) < 1)))
    given = surface(work / "pebble.ply").n_cells
    for ratio in (0.5, 1, 2):
        subprocess.run([program, "fill", work / "pebble.ply", "-o", work / "out.ply", "--quiet", "--density", str(ratio)], check=True)
        images.append(panel(surface(work / "out.ply"), (0.1, -0.2, 1.2), edges=True, zoom=2.05, given=given))
        texts.append(f"{ratio}" + (" (default)" if ratio == 1 else ""))
    sheet(images, texts, Path(folder) / "option_density.png", 3, colors=64)  # thin lines need few


def continuity(program, folder, work):
    make_cases.write_ply(work / "pebble.ply", *make_cases.pebble_with_hole())
    for word in ("position", "tangent", "curvature"):
        subprocess.run([program, "fill", work / "pebble.ply", "-o", work / f"{word}.ply", "--quiet", "--continuity", word], check=True)
    images = []
    for pair in (("position", "tangent"), ("curvature", "curvature")):
        subprocess.run([program, "render", *(work / f"{word}.ply" for word in pair), "-o", work / "pair.png", "--color", "zebra", "--size", "1000x460",
                        "--direction", "0.1,-0.35,1.2"], check=True, stdout=subprocess.DEVNULL)
        both = Image.open(work / "pair.png").convert("RGB")
        images += [both.crop((k * 500, 51, (k + 1) * 500, 460)) for k in (0, 1)]
    sheet(images[:3], ["position", "tangent", "curvature (default)"], Path(folder) / "option_continuity.png", 3)


def compare(program, work, scan, option, words, view, zoom):
    """One panel for each word of an option; the first is the default. The patch is tinted."""
    make_cases.write_ply(work / "scan.ply", *scan)
    given, images, texts = surface(work / "scan.ply").n_cells, [], []
    for word in words:
        subprocess.run([program, "fill", work / "scan.ply", "-o", work / "out.ply", "--quiet", option, word], check=True)
        images.append(panel(surface(work / "out.ply"), view, zoom=zoom, given=given))
        texts.append(word + (" (default)" if not texts else ""))
    return images, texts


def edges(program, folder, work):
    images, texts = compare(program, work, make_cases.block(), "--edges", ("auto", "round"), (1.2, 0.9, 1.1), 1.35)
    sheet(images, texts, Path(folder) / "option_edges.png", 2)


def boundary(program, folder, work):
    images, texts = compare(program, work, make_cases.stone(2, 1.8), "--boundary", ("auto", "exact", "robust"), (0.3, -1, 0.3), 1.9)
    sheet(images, texts, Path(folder) / "option_boundary.png", 3, colors=200)


def islands(program, folder, work):
    """The island is debris: a chip that lies above the surface."""
    points, faces = make_cases.island()
    raised = [(x, y, z + 7) if z > 0 and math.hypot(x - 6, y - 3) < 9.5 else (x, y, z) for x, y, z in points]
    images, texts = compare(program, work, (raised, faces), "--islands", ("join", "cover"), (0.3, -1, 0.7), 1.8)
    sheet(images, texts, Path(folder) / "option_islands.png", 2)


def main():
    if len(sys.argv) < 3:
        raise SystemExit(__doc__)
    program, folder, *names = sys.argv[1:]
    with tempfile.TemporaryDirectory() as work:
        for make in (kinds, density, continuity, edges, boundary, islands, numbers):
            if not names or make.__name__ in names:
                make(program, folder, Path(work))


if __name__ == "__main__":
    main()
