# SPDX-License-Identifier: GPL-3.0-or-later
"""A result shown: as a picture, in a notebook, as a table, and as a mesh of another package."""
from __future__ import annotations

import base64
import html
import os
from contextlib import suppress
from typing import Any, Dict, List, Optional, Sequence, Tuple

import numpy as np
from numpy.typing import NDArray

from loopmend import _core
from loopmend._meshes import given, polydata
from loopmend._picture import picture, png
from loopmend._types import Path, package
from loopmend.results import FillResult, HoleResult

_MOST_ROWS = 20


def render(mesh: Any, path: Optional[Path] = None, *, size: Tuple[int, int] = (960, 720),
           direction: Optional[Sequence[float]] = None) -> NDArray[np.uint8]:
    """Draws a mesh, or the result of fill() with its patches in orange. It needs no graphics driver and no other package.

    Parameters:
        mesh: a result of fill(), or a mesh as fill() takes it. Colours at the vertices are drawn where nothing is new.
        path: of a PNG file to write; None: none.
        size: pixels, width and height.
        direction: from the mesh to the eye, as x, y, z; None: the side from which the patches are seen best.

    Returns:
        (height, width, 3) uint8, red, green, blue.

    Raises:
        WriteError: the file cannot be written.

    Example:
        >>> import loopmend
        >>> loopmend.render(loopmend.sample(), size=(320, 240)).shape
        (240, 320, 3)
    """
    taken = given(mesh)
    new = np.zeros(len(taken.faces), bool)
    if isinstance(mesh, FillResult):
        new[mesh.given_faces:] = True
    colors = None if new.any() or taken.colors is None else np.asarray(taken.colors)
    image = picture(np.asarray(taken.vertices, float), np.asarray(taken.faces, np.int32), new, colors, size, direction)
    if path is not None:
        try:
            with open(path, "wb") as file:
                file.write(png(image))
        except OSError as error:
            raise _core.WriteError(f"{os.fspath(path)}: {error.strerror}") from error
    return image


def _figure(value: Optional[float]) -> str:
    return "" if value is None or not np.isfinite(value) else f"{value:.3g}"


def _row(hole: HoleResult) -> List[str]:
    return [str(hole.number), hole.kind, str(hole.edges), _figure(hole.diameter),
            hole.status if hole.verdict is None else hole.verdict.grade,
            "" if hole.expected_deviation is None else _figure(hole.expected_deviation.likely),
            "; ".join(text for text in ("" if hole.verdict is None else hole.verdict.sentence, hole.message) if text)]


def html_of(result: FillResult) -> str:
    """A table of the holes beside a picture."""
    head = ["loop", "kind", "edges", "diameter", "verdict", "likely off", "remark"]
    rows = "".join("<tr>" + "".join(f"<td style='text-align:left'>{html.escape(cell)}</td>" for cell in _row(hole)) + "</tr>"
                   for hole in result.holes[:_MOST_ROWS])
    if len(result.holes) > _MOST_ROWS:
        rows += f"<tr><td colspan='{len(head)}'>and {len(result.holes) - _MOST_ROWS} smaller loops</td></tr>"
    drawn = base64.b64encode(png(render(result, size=(420, 315)))).decode()
    return (f"<div><p>{html.escape(repr(result)[1:-1])}</p><img alt='the filled mesh' src='data:image/png;base64,{drawn}'/>"
            f"<table><thead><tr>{''.join(f'<th>{name}</th>' for name in head)}</tr></thead><tbody>{rows}</tbody></table></div>")


def show(result: FillResult) -> Any:
    """In the window or notebook of PyVista or Matplotlib."""
    with suppress(ImportError):
        plotter = package("pyvista", "plot()").Plotter()
        plotter.add_mesh(to_pyvista(result), scalars="hole", categories=True, show_scalar_bar=False, cmap=["#cbcdd0", "#e88820"],
                         clim=[0, 1])
        return plotter.show()
    pyplot = package("matplotlib.pyplot", "plot() without PyVista")
    pyplot.figure()
    pyplot.imshow(render(result))
    pyplot.axis("off")
    return pyplot.show()


def _hole_of_faces(result: FillResult) -> NDArray[np.int32]:
    number = np.zeros(len(result.faces), np.int32)
    for hole in reversed(result.holes):
        number[hole.new_faces] = hole.number
    return number


def to_pyvista(result: FillResult) -> Any:
    """PolyData with the number of the hole at each face and the expected deviation at each vertex."""
    pyvista = package("pyvista", "to_pyvista()")

    filled = polydata(pyvista, result)
    filled.cell_data["hole"] = _hole_of_faces(result)
    off = np.zeros(len(result.vertices))
    if len(result.expected_deviation) == len(result.new_vertices):
        off[result.given_vertices:] = result.expected_deviation
    filled.point_data["expected_deviation"] = off
    if result.colors is not None:
        filled.point_data["RGBA" if result.colors.shape[1] == 4 else "RGB"] = result.colors
    return filled


def to_trimesh(result: FillResult) -> Any:
    """Trimesh with the number of the hole of each face among its face attributes."""
    trimesh = package("trimesh", "to_trimesh()")

    return trimesh.Trimesh(result.vertices, result.faces, process=False, vertex_colors=result.colors,
                           face_attributes={"hole": _hole_of_faces(result)})


def to_frame(result: FillResult) -> Any:
    """One row for each loop."""
    pandas = package("pandas", "to_frame()")

    rows: List[Dict[str, Any]] = []
    for hole in result.holes:
        row: Dict[str, Any] = {name: getattr(hole, name) for name in (
            "number", "kind", "edges", "perimeter", "diameter", "planarity", "area", "status", "is_filled", "message", "method",
            "reason", "steps", "energy_before", "energy_after", "seconds")}
        row.update(zip(("center_x", "center_y", "center_z"), hole.center))
        row["new_vertices"], row["new_faces"] = len(hole.new_vertices), len(hole.new_faces)
        row["grade"] = None if hole.verdict is None else hole.verdict.grade
        row["remark"] = None if hole.verdict is None else hole.verdict.sentence
        row["likely_off"] = np.nan if hole.expected_deviation is None else hole.expected_deviation.likely
        for when, seam in (("before", hole.seam_before), ("after", hole.seam_after)):
            row[f"seam_angle_{when}_deg"] = np.nan if seam is None else seam.g1_rms_deg
            row[f"seam_jump_{when}"] = np.nan if seam is None else seam.h_jump_rms_times_diameter
        rows.append(row)
    return pandas.DataFrame(rows)
