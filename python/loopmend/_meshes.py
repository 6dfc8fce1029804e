# SPDX-License-Identifier: GPL-3.0-or-later
"""Meshes of other packages: their arrays go in, and a mesh of the same type comes out. No package is imported before one of its
meshes is handed over.

Arrays of a mesh that belong to its vertices or faces run on over the patches: numbers with fractions and colours continue those
at the boundary (docs of engine/pipeline/continue_attributes.h), all others are those of the nearest vertex or face.
"""
from __future__ import annotations

import copy
import os
from dataclasses import dataclass
from typing import Any, Callable, Dict, List, Optional, Tuple

import numpy as np
from numpy.typing import NDArray

from loopmend import _core
from loopmend._types import package
from loopmend._vtk import arrays_of, made_of, triangles_of
from loopmend._words import errors_in_python
from loopmend.results import FillResult, Mesh

Array = NDArray[Any]
Named = Dict[str, Array]


@dataclass
class Given:
    """A mesh as the engine takes it, and how a result becomes a mesh of the same type."""

    vertices: Array
    faces: Array
    colors: Optional[Array] = None
    carried: Any = None
    back: Optional[Callable[[FillResult], Any]] = None


def _is_color(array: Array) -> bool:
    return array.dtype == np.uint8 and array.ndim == 2 and array.shape[1] in (3, 4)


def _is_smooth(array: Array) -> bool:
    return array.dtype.kind == "f" or _is_color(array)


class _Side:
    """The arrays at the vertices, or at the faces."""

    def __init__(self, arrays: Named, rows: int) -> None:
        self.arrays = {name: np.asarray(array) for name, array in arrays.items() if len(array) == rows}
        self.names: List[str] = []
        columns = [np.zeros((rows, 0))]
        for name, array in self.arrays.items():
            if not _is_smooth(array):
                continue
            flat = array.reshape(rows, -1).astype(np.float64)
            is_normal = "normal" in name.lower() and flat.shape[1] == 3 and "nx" not in self.names
            self.names += ["nx", "ny", "nz"] if is_normal else [f"{name} {k}" for k in range(flat.shape[1])]
            columns.append(flat)
        self.columns = np.hstack(columns)

    def continued(self, rows: Array, values: Array) -> Named:
        result, at = {}, 0
        for name, array in self.arrays.items():
            result[name] = array[rows]
            if not _is_smooth(array):
                continue
            width = int(np.prod(array.shape[1:], dtype=int))
            part = values[:, at:at + width].reshape(result[name].shape)
            result[name] = (np.clip(part.round(), 0, 255) if array.dtype.kind == "u" else part).astype(array.dtype)
            at += width
        return result


class Values:
    """The arrays of a mesh of another package."""

    def __init__(self, of_points: Named, of_faces: Named, points: int, faces: int) -> None:
        self._points, self._faces = _Side(of_points, points), _Side(of_faces, faces)
        self.carried = _core.carry_values(self._points.columns, self._points.names, self._faces.columns, self._faces.names)

    def over(self, result: FillResult) -> Tuple[Named, Named]:
        """The arrays of a filled mesh: at its vertices, at its faces."""
        points, faces = _core.carried_values(result.vertices, result.faces, result.carried)
        return self._points.continued(*points), self._faces.continued(*faces)


def _of_trimesh(mesh: Any) -> Given:
    points, faces = dict(mesh.vertex_attributes), dict(mesh.face_attributes)
    kind = mesh.visual.kind
    vertex_colors = np.asarray(mesh.visual.vertex_colors) if kind == "vertex" else None  # the engine's own: files have room for them
    if kind == "face":
        faces["loopmend colors"] = mesh.visual.face_colors
    elif kind == "texture" and mesh.visual.uv is not None:
        points["loopmend uv"] = mesh.visual.uv
    values = Values(points, faces, len(mesh.vertices), len(mesh.faces))

    def back(result: FillResult) -> Any:
        trimesh = package("trimesh", "this mesh")

        at_points, at_faces = values.over(result)
        face_colors = at_faces.pop("loopmend colors", None)
        uv = at_points.pop("loopmend uv", None)
        filled = trimesh.Trimesh(result.vertices, result.faces, process=False, vertex_colors=result.colors, face_colors=face_colors,
                                 metadata=copy.deepcopy(mesh.metadata), vertex_attributes=at_points, face_attributes=at_faces)
        if uv is not None:
            filled.visual = trimesh.visual.TextureVisuals(uv=uv, material=mesh.visual.material)
        return filled

    return Given(np.asarray(mesh.vertices), np.asarray(mesh.faces), vertex_colors, values.carried, back)


def _of_scene(scene: Any) -> Given:
    """Of a scene with one mesh, as files of glTF give it: the mesh in its own coordinates; what comes back is a scene."""
    meshes = {name: of for name, of in scene.geometry.items() if hasattr(of, "faces")}
    if len(meshes) != 1:
        raise TypeError(f"this trimesh.Scene holds {len(meshes)} meshes: hand over scene.to_mesh(), or one of scene.geometry")
    (name, mesh), = meshes.items()
    taken = _of_trimesh(mesh)
    of_mesh = taken.back

    def back(result: FillResult) -> Any:
        filled = scene.copy()
        filled.geometry[name] = of_mesh(result) if of_mesh else None
        return filled

    taken.back = back
    return taken


def _of_pyvista(mesh: Any) -> Given:
    pyvista = package("pyvista", "this mesh")
    surface = pyvista.wrap(triangles_of(mesh))
    faces = np.asarray(surface.faces).reshape(-1, 4)[:, 1:]
    before = surface.n_verts + surface.n_lines  # their cells come first
    values = Values({name: np.asarray(surface.point_data[name]) for name in surface.point_data.keys()},
                    {name: np.asarray(surface.cell_data[name])[before:before + len(faces)] for name in surface.cell_data.keys()},
                    surface.n_points, len(faces))

    def back(result: FillResult) -> Any:
        filled = polydata(pyvista, result)
        at_points, at_faces = values.over(result)
        for name, array in at_points.items():
            filled.point_data[name] = array
        for name, array in at_faces.items():
            filled.cell_data[name] = array
        for name in surface.field_data.keys():
            filled.field_data[name] = surface.field_data[name]
        for old, new in ((surface.point_data, filled.point_data), (surface.cell_data, filled.cell_data)):
            for role in ("texture_coordinates", "normals", "vectors"):
                if name := getattr(old, f"active_{role}_name"):
                    setattr(new, f"active_{role}_name", name)
        if surface.active_scalars_name:
            filled.set_active_scalars(surface.active_scalars_name, preference=surface.active_scalars_info.association)
        return filled

    return Given(np.asarray(surface.points), faces, carried=values.carried, back=back)


def _of_vtk(mesh: Any) -> Given:
    surface = triangles_of(mesh)
    points, faces, of_points, of_faces = arrays_of(surface)
    values = Values(of_points, of_faces, len(points), len(faces))
    return Given(points, faces, carried=values.carried, back=lambda result: made_of(result.vertices, result.faces, *values.over(result), surface))


def polydata(pyvista: Any, mesh: Any) -> Any:
    """PolyData of vertices and faces."""
    faces = np.column_stack([np.full(len(mesh.faces), 3), mesh.faces])
    return pyvista.PolyData(mesh.vertices, faces.ravel()) if len(faces) else pyvista.PolyData(mesh.vertices)


def _of_meshio(mesh: Any) -> Given:
    faces, of_block, at = [], [], []
    for k, block in enumerate(mesh.cells):
        corners = np.asarray(block.data)
        if block.type in ("vertex", "line"):
            continue
        if block.type not in ("triangle", "quad", "polygon"):
            raise _core.InvalidArgument(f"a mesh of meshio must have triangles and polygons, not cells of the type {block.type!r}: "
                                        "take its surface first")
        for third in range(2, corners.shape[1]):
            faces.append(corners[:, [0, third - 1, third]])
            of_block.append(np.full(len(corners), k))
            at.append(np.arange(len(corners)))
    if not faces:
        return Given(np.asarray(mesh.points), np.zeros((0, 3), np.int64))
    blocks, places = np.concatenate(of_block), np.concatenate(at)
    of_faces = {}
    for name, per_block in mesh.cell_data.items():
        used = [np.asarray(per_block[k])[places[blocks == k]] for k in dict.fromkeys(blocks.tolist())]
        of_faces[name] = np.concatenate(used)
    triangles, points = np.vstack(faces), np.asarray(mesh.points)
    values = Values(dict(mesh.point_data), of_faces, len(points), len(triangles))

    def back(result: FillResult) -> Any:
        meshio = package("meshio", "this mesh")

        at_points, at_faces = values.over(result)
        return meshio.Mesh(result.vertices, [("triangle", result.faces)], point_data=at_points,
                           cell_data={name: [array] for name, array in at_faces.items()}, field_data=dict(mesh.field_data),
                           point_sets=dict(mesh.point_sets))

    return Given(points, triangles, carried=values.carried, back=back)


def _of_open3d(mesh: Any) -> Given:
    vertices, faces = np.asarray(mesh.vertices), np.asarray(mesh.triangles)
    points = {name: np.asarray(getattr(mesh, "vertex_" + name)) for name in ("colors", "normals") if getattr(mesh, f"has_vertex_{name}")()}
    values = Values(points, {}, len(vertices), len(faces))

    def back(result: FillResult) -> Any:
        open3d = package("open3d", "this mesh")

        of = open3d.utility.Vector3dVector
        filled = open3d.geometry.TriangleMesh(of(result.vertices), open3d.utility.Vector3iVector(result.faces))
        for name, array in values.over(result)[0].items():
            setattr(filled, "vertex_" + name, of(array))
        if mesh.has_triangle_normals():
            filled.compute_triangle_normals()
        return filled

    return Given(vertices, faces, carried=values.carried, back=back)


def _of_open3d_tensors(mesh: Any) -> Given:
    if "positions" not in mesh.vertex or "indices" not in mesh.triangle:
        return Given(np.zeros((0, 3)), np.zeros((0, 3), np.int64))
    vertices, faces = mesh.vertex["positions"].cpu().numpy(), mesh.triangle["indices"].cpu().numpy()
    values = Values({name: array.cpu().numpy() for name, array in mesh.vertex.items() if name != "positions"},
                    {name: array.cpu().numpy() for name, array in mesh.triangle.items() if name != "indices"},
                    len(vertices), len(faces))

    def back(result: FillResult) -> Any:
        open3d = package("open3d", "this mesh")

        filled = open3d.t.geometry.TriangleMesh()
        filled.vertex["positions"] = open3d.core.Tensor(result.vertices.astype(vertices.dtype))
        filled.triangle["indices"] = open3d.core.Tensor(result.faces.astype(faces.dtype))
        for table, arrays in zip((filled.vertex, filled.triangle), values.over(result)):
            for name, array in arrays.items():
                table[name] = open3d.core.Tensor(np.ascontiguousarray(array))
        return filled

    return Given(vertices, faces, carried=values.carried, back=back)


_KINDS: Dict[Tuple[str, str], Callable[[Any], Given]] = {
    ("trimesh", "Trimesh"): _of_trimesh, ("pyvista", "PolyData"): _of_pyvista, ("meshio", "Mesh"): _of_meshio,
    ("trimesh", "Scene"): _of_scene, ("vtkmodules", "vtkPolyData"): _of_vtk,
}


def _open3d_kind(mesh: Any) -> Optional[Callable[[Any], Given]]:
    for base in type(mesh).__mro__:
        if base.__module__.startswith("open3d.") and base.__name__ == "TriangleMesh":
            return _of_open3d_tensors if ".t." in base.__module__ else _of_open3d
    return None


def _of_other_package(mesh: Any) -> Optional[Given]:
    names = {(base.__module__.partition(".")[0], base.__name__) for base in type(mesh).__mro__}
    for kind, take in _KINDS.items():
        if kind in names:
            return take(mesh)
    if take_open3d := _open3d_kind(mesh):
        return take_open3d(mesh)
    if ("trimesh", "PointCloud") in names or any(base.__module__.startswith("open3d.") and base.__name__ == "PointCloud" for base in type(mesh).__mro__):
        raise TypeError("a cloud of points has no surface that could have holes: make a surface of it first")
    if any(package == "pyvista" for package, _ in names):
        raise TypeError(f"of PyVista a PolyData is needed, not {type(mesh).__name__}: hand over mesh.extract_surface()")
    return None


def read(path: Any, weld: bool = False, all_digits: bool = False) -> Mesh:
    """The mesh of a file."""
    with errors_in_python():
        return Mesh(**_core.read(os.fspath(path), weld, all_digits))


def surface(mesh: Any, faces: Any = None, colors: Any = None) -> Given:
    """As given(), but a mesh without faces raises."""
    taken = given(mesh, faces, colors)
    if np.size(taken.faces) == 0:
        raise _core.InvalidArgument("this mesh has no faces, and so no holes. Of a cloud of points, make a surface first." if np.size(taken.vertices)
                                    else "this mesh is empty: it has no vertices and no faces")
    return taken


def given(mesh: Any, faces: Any = None, colors: Any = None) -> Given:
    """What a caller handed over: two arrays, or a mesh of one of the types."""
    if faces is not None:
        return Given(np.asarray(mesh), np.asarray(faces), colors)
    if isinstance(mesh, Given):
        return mesh
    if isinstance(mesh, (str, os.PathLike)):
        mesh = read(mesh)
    if isinstance(mesh, (Mesh, FillResult)):
        return Given(mesh.vertices, mesh.faces, mesh.colors if colors is None else colors, mesh.carried)
    taken = _of_other_package(mesh)
    if taken is None and isinstance(mesh, (tuple, list)) and len(mesh) == 2:
        taken = Given(np.asarray(mesh[0]), np.asarray(mesh[1]))
    if taken is None and hasattr(mesh, "vertices") and hasattr(mesh, "faces"):
        taken = Given(np.asarray(mesh.vertices), np.asarray(mesh.faces))
    if taken is None:
        raise TypeError("a mesh is needed: vertices and faces, a path, or a Mesh, trimesh.Trimesh, pyvista.PolyData, meshio.Mesh or "
                        f"open3d.geometry.TriangleMesh, not {type(mesh).__name__}")
    if colors is not None:
        taken.colors = colors
    return taken
