#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The small pictures of the start page: the paper's examples with their patches in orange, on a transparent ground.

Usage: make_gallery.py PROGRAM   writes fig*.png beside this file

PROGRAM is loopmend_reproduce (tests/reproduce). Needs NumPy, PyVista and Pillow, and xvfb-run where there is no display.
"""
import subprocess
import sys
import tempfile
from pathlib import Path

import numpy as np
import pyvista
from PIL import Image

SCAN, PATCH, INSIDE = "#aaa49b", "#e8932f", "#8d7f76"
SIZE = (168, 117)
# Direction to the eye, and the zoom.
VIEWS = {
    "fig5.1a": ((1, 0.9, 0.5), 1.05), "fig5.1d": ((0.7, 0.9, 0.5), 1.35), "fig5.2a": ((1, 0.8, 0.7), 1.5),
    "fig5.2d": ((1, 0.7, 0.5), 1.5), "fig5.2g": ((0.5, 1, 0.4), 1.6), "fig5.3": ((0.35, -1, 0.05), 1.45),
    "fig5.4": ((0.7, 1, 0.4), 1.35), "fig5.5": ((0.4, 0.6, 1), 1.5), "fig5.6": ((0.5, -0.9, 1), 1.25),
}


def changed_faces(given, result):
    """Which faces of the result are new, or have a vertex that was moved."""
    if result.n_points > given.n_points:
        return np.arange(result.n_cells) >= (given.n_cells if result.n_cells > given.n_cells else 0)
    moved = np.linalg.norm(result.points - given.points, axis=1) > 1e-6
    return moved[result.faces.reshape(-1, 4)[:, 1:]].any(axis=1)


def draw(name, given, result):
    direction, zoom = VIEWS[name]
    plotter = pyvista.Plotter(off_screen=True, window_size=(4 * SIZE[0], 4 * SIZE[1]), lighting="three lights")
    new = changed_faces(given, result)
    if name == "fig5.4":  # all of it is new: the points that it goes through show what was given
        new[:] = True
        plotter.add_mesh(pyvista.PolyData(given.points), color="#4a4540", point_size=26, render_points_as_spheres=True)
    result = result.compute_normals(cell_normals=False, split_vertices=True, feature_angle=60)
    for color, part in ((SCAN, ~new), (PATCH, new)):
        if part.any():
            plotter.add_mesh(result.extract_cells(np.flatnonzero(part)), color=color, smooth_shading=True, ambient=0.05,
                             specular=0.1, backface_params={"color": INSIDE})
    middle = np.array(result.center)
    away = 2.4 * result.length * np.array(direction) / np.linalg.norm(direction)
    plotter.camera_position = [middle + away, middle, (0, 0, 1)]
    plotter.camera.zoom(zoom)
    plotter.enable_anti_aliasing("ssaa")
    picture = Image.fromarray(plotter.screenshot(return_img=True, transparent_background=True))
    plotter.close()
    picture.resize(SIZE, Image.LANCZOS).save(Path(__file__).parent / f"{name}.png", optimize=True)


def main():
    if len(sys.argv) != 2:
        raise SystemExit(__doc__)
    with tempfile.TemporaryDirectory() as folder:
        subprocess.run([sys.argv[1], "all", "-o", folder, "--quiet"], check=True)
        for name in VIEWS:
            draw(name, *(pyvista.read(Path(folder) / f"{name}-{part}.ply") for part in ("input", "result")))


if __name__ == "__main__":
    main()
