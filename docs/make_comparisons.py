#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Pictures of README.md: a hole, Loopmend's patch, and that of the best other program.

Usage: make_comparisons.py PROGRAM FOLDER   writes edges.png, mirror.png and likely_error.png into FOLDER

The models are those of docs/user/which_option.md, whose whole surface is known. Each is filled by Loopmend and by the programs of
tests/bench/other_programs.py; the picture shows the one that comes closest to what was cut away, and the distances are printed. Needs
the packages that that script names, and Pillow. Run it under xvfb-run where there is no display.
"""
import multiprocessing
import subprocess
import sys
import tempfile
from pathlib import Path

import numpy as np

sys.dont_write_bytecode = True
ROOT = Path(__file__).resolve().parents[1]
sys.path[:0] = [str(ROOT / "tests/bench"), str(ROOT / "docs/user/pictures")]
import make_cases  # noqa: E402
import other_programs  # noqa: E402

WIDE, HIGH, HEAD, FOOT = 460, 400, 66, 60  # captions are legible where the picture is 366 pixels wide, as on a telephone
SCAN, INSIDE, LOOP = "#c9c3ba", "#55514d", "#b5095f"

# Picture, model, its whole surface, options of Loopmend, direction of view, zoom.
PICTURES = [
    ("edges", make_cases.block, lambda: make_cases.box(40, (45, 30, 30)), [], (0.5, 0.7, 1), 1.3),
    ("mirror", make_cases.owl, None, ["--mirror"], (0.3, 0.4, 1), 1.7),
    ("likely_error", make_cases.pebble_with_hole, make_cases.pebble, ["--deviation"], (0.1, -0.35, 1.2), 1.75),
]


def whole_owl():
    """The head with both horns: the owl before it is cut."""
    kept = make_cases.cut
    make_cases.cut = lambda mesh, gone: mesh
    try:
        return make_cases.owl()
    finally:
        make_cases.cut = kept


def arrays(mesh):
    return np.array(mesh[0], float), np.array(mesh[1], np.int32)


def fill(program, points, faces, options, folder):
    """Loopmend's vertices and faces, and the likely error of each vertex where it is asked for."""
    import pyvista
    source, target = folder / "in.ply", folder / "out.ply"
    other_programs.write_ply(source, points, faces)
    subprocess.run([program, "fill", source, "-o", target, "--quiet", *options], check=True)
    head = target.read_bytes().split(b"end_header\n")[0].decode()
    mesh = pyvista.read(target)
    values = mesh.point_data["expected_deviation"] if "expected_deviation" in mesh.point_data else None
    if values is None and "expected_deviation" in head:
        values = read_property(target, head)
    return np.array(mesh.points, float), mesh.faces.reshape(-1, 4)[:, 1:], values


def read_property(path, head):
    """expected_deviation, from a binary PLY."""
    kinds = {"double": "<f8", "float": "<f4", "uchar": "u1", "int": "<i4"}
    vertex = head.split("element vertex")[1].split("element")[0].splitlines()
    row = np.dtype([(line.split()[2], kinds[line.split()[1]]) for line in vertex[1:] if line.startswith("property")])
    count = int(vertex[0])
    data = path.read_bytes().split(b"end_header\n", 1)[1]
    return np.frombuffer(data[:count * row.itemsize], row)["expected_deviation"]


def distances(truth, points, faces, filled):
    """Two-sided rms distance in diameters of the largest loop's hole, as in other_programs.py."""
    import trimesh
    mesh = trimesh.Trimesh(*truth, process=False)
    kept = {tuple(sorted(map(tuple, np.round(p, 7)))) for p in points[faces]}
    removed = np.array([tuple(sorted(map(tuple, np.round(p, 7)))) not in kept for p in truth[0][truth[1]]])
    loop, _ = other_programs.boundary(truth[1][removed])
    return other_programs.distance(mesh, removed, loop, filled, np.random.default_rng(5))


def panel(points, faces, given, view, zoom, values, most):
    """One picture; `given`: faces of the scan, None: all."""
    import pyvista
    plotter = pyvista.Plotter(off_screen=True, window_size=(2 * WIDE, 2 * HIGH))
    plotter.set_background("white")

    def surface(part):
        return pyvista.PolyData(points, np.column_stack([np.full(len(part), 3), part]).ravel())

    def shaded(mesh, **look):
        mesh = mesh.compute_normals(cell_normals=False, feature_angle=35, split_vertices=True)
        plotter.add_mesh(mesh, smooth_shading=True, specular=0.1, ambient=0.25, show_scalar_bar=False, **look)
    if given is None:
        shaded(surface(faces), color=SCAN, backface_params={"color": INSIDE})
        edge = surface(faces).extract_feature_edges(boundary_edges=True, feature_edges=False, manifold_edges=False)
        size = np.ptp(points, axis=0).max()
        plotter.add_mesh(edge.tube(radius=0.006 * size), color=LOOP)
    else:
        whole = surface(faces)
        if values is not None:
            whole.point_data["error"] = values
            shaded(whole.extract_cells(np.flatnonzero(given)).extract_surface(algorithm="dataset_surface"), color=SCAN)
            shaded(whole.extract_cells(np.flatnonzero(~given)).extract_surface(algorithm="dataset_surface"), scalars="error", cmap="Oranges",
                   clim=(0, most))
        else:
            whole = whole.compute_normals(cell_normals=False, feature_angle=35, split_vertices=True, consistent_normals=False)
            whole.cell_data["color"] = np.where(given[:, None], np.array([201, 195, 186]), np.array([232, 163, 90])).astype(np.uint8)
            plotter.add_mesh(whole, scalars="color", rgb=True, smooth_shading=True, specular=0.1, ambient=0.25, show_scalar_bar=False)
    middle = (points.max(axis=0) + points.min(axis=0)) / 2
    size = np.linalg.norm(np.ptp(points, axis=0))
    plotter.camera_position = [middle + 2.2 * size * np.array(view) / np.linalg.norm(view), middle, (0, 1, 0)]
    plotter.camera.zoom(zoom)
    plotter.enable_anti_aliasing("ssaa")
    image = plotter.screenshot(return_img=True)
    plotter.close()
    return image


def given_faces(points, faces, scan, scan_faces):
    """Which faces of the result lie on the scan."""
    on_scan = other_programs.scene_of(scan, scan_faces)
    size = np.ptp(scan, axis=0).max()
    corners = np.maximum.reduce([on_scan(points[faces[:, k]]) for k in range(3)] + [on_scan(points[faces].mean(axis=1))])
    return corners < 1e-5 * size


def draw(program, folder, name, model, truth, options, view, zoom):
    from PIL import Image
    points, faces = arrays(model())
    whole = arrays(truth() if truth else whole_owl())
    with tempfile.TemporaryDirectory() as work:
        *ours, values = fill(program, points, faces, options, Path(work))
    others = {o: other_programs.guarded(o, points, faces) for o in other_programs.OTHERS}
    measured = {o: other_programs.alone(distances, whole, points, faces, filled) for o, filled in others.items() if filled}
    measured = {o: d for o, d in measured.items() if d}
    best = min(measured, key=measured.get)
    mine = other_programs.alone(distances, whole, points, faces, ours)
    print(f"{name}: Loopmend {mine:.2g}; " + ", ".join(f"{o} {d:.2g}" for o, d in sorted(measured.items(), key=lambda p: p[1])), flush=True)
    most = float(np.max(values)) if values is not None else 0
    images = [panel(points, faces, None, view, zoom, None, 0),
              panel(*ours, given_faces(*ours, points, faces), view, zoom, values, most),
              panel(*others[best], given_faces(*others[best], points, faces), view, zoom, None, 0)]
    compose([Image.fromarray(image).resize((WIDE, HIGH), Image.LANCZOS) for image in images], best, most).save(
        Path(folder) / f"{name}.png", optimize=True)


def compose(images, best, most):
    """The three pictures under their captions, and under them the scale of the likely error where `most` is not 0."""
    from PIL import Image, ImageDraw, ImageFont
    sheet = Image.new("RGB", (3 * WIDE, HEAD + HIGH + (FOOT if most else 0)), "white")
    font = ImageFont.truetype("/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf", 42)
    pen = ImageDraw.Draw(sheet)
    for k, (image, text) in enumerate(zip(images, ["Before", "Loopmend", best])):
        sheet.paste(image, (k * WIDE, HEAD))
        pen.text((k * WIDE + 10, 8), text, fill="#222222", font=font)
    if most:
        import matplotlib
        bar = Image.linear_gradient("L").rotate(90, expand=True).resize((200, 26))
        colors = (matplotlib.colormaps["Oranges"](np.asarray(bar))[:, :, :3] * 255).astype(np.uint8)
        sheet.paste(Image.fromarray(colors), (WIDE + 50, HEAD + HIGH + 16))
        pen.text((WIDE + 10, HEAD + HIGH + 2), "0", fill="#222222", font=font)
        pen.text((WIDE + 262, HEAD + HIGH + 2), f"{most:.1f} (the pebble is 100 wide)", fill="#222222", font=font)
    return sheet


def main():
    if len(sys.argv) != 3:
        raise SystemExit(__doc__)
    for picture in PICTURES:
        # Each in a process of its own: VTK and Open3D start threads, which a fork does not keep.
        process = multiprocessing.get_context("spawn").Process(target=draw_number, args=(*sys.argv[1:], PICTURES.index(picture)))
        process.start()
        process.join()
        if process.exitcode != 0:
            raise SystemExit(f"{picture[0]}: no picture was made")


def draw_number(program, folder, k):
    draw(program, folder, *PICTURES[k])


if __name__ == "__main__":
    main()
