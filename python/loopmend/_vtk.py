# SPDX-License-Identifier: GPL-3.0-or-later
"""Surfaces of VTK itself, as ParaView and 3D Slicer hold them: their arrays, and a vtkPolyData made of a filled one."""
from __future__ import annotations

from typing import Any, Dict, Tuple

import numpy as np
from numpy.typing import NDArray

from loopmend._types import package

Array = NDArray[Any]
Named = Dict[str, Array]


def _support() -> Any:
    return package("vtkmodules.util.numpy_support", "this mesh")


def _numbers_of(data: Any, first: int, count: int) -> Named:
    """The arrays of numbers; those of text are left out."""
    to_numpy, result = _support().vtk_to_numpy, {}
    for k in range(data.GetNumberOfArrays()):
        array = data.GetArray(k)  # None: text
        if array is not None and array.GetName() and array.GetDataTypeAsString() != "bit":
            result[array.GetName()] = to_numpy(array)[first:first + count]
    return result


def triangles_of(mesh: Any) -> Any:
    """The mesh, or where it has other polygons or strips, its polygons as triangles."""
    polygons = mesh.GetPolys()
    if mesh.GetNumberOfStrips() == 0 and polygons.GetNumberOfConnectivityIds() == 3 * polygons.GetNumberOfCells():
        return mesh
    triangles = package("vtkmodules.vtkFiltersCore", "this mesh").vtkTriangleFilter()
    triangles.SetInputData(mesh)
    triangles.PassVertsOff()
    triangles.PassLinesOff()
    triangles.Update()
    return triangles.GetOutput()


def arrays_of(mesh: Any) -> Tuple[Array, Array, Named, Named]:
    """Of triangles_of(mesh): points, triangles, and the arrays at both."""
    to_numpy, count = _support().vtk_to_numpy, mesh.GetNumberOfPolys()
    points = to_numpy(mesh.GetPoints().GetData()) if mesh.GetNumberOfPoints() else np.zeros((0, 3))
    faces = to_numpy(mesh.GetPolys().GetConnectivityArray()).reshape(-1, 3) if count else np.zeros((0, 3), np.int64)
    before = mesh.GetNumberOfVerts() + mesh.GetNumberOfLines()  # their cells come first
    return points, faces, _numbers_of(mesh.GetPointData(), 0, len(points)), _numbers_of(mesh.GetCellData(), before, count)


def made_of(vertices: Array, faces: Array, at_points: Named, at_faces: Named, surface: Any) -> Any:
    """vtkPolyData with these arrays; what is active, and the field data, are those of the surface."""
    support, core = _support(), package("vtkmodules.vtkCommonCore", "this mesh")
    model = package("vtkmodules.vtkCommonDataModel", "this mesh")
    filled, points, cells = model.vtkPolyData(), core.vtkPoints(), model.vtkCellArray()
    points.SetData(support.numpy_to_vtk(np.ascontiguousarray(vertices), deep=True))
    cells.SetData(3, support.numpy_to_vtkIdTypeArray(np.ascontiguousarray(faces, np.int64).ravel(), deep=True))
    filled.SetPoints(points)
    filled.SetPolys(cells)
    for old, new, arrays in ((surface.GetPointData(), filled.GetPointData(), at_points), (surface.GetCellData(), filled.GetCellData(), at_faces)):
        for name, array in arrays.items():
            made = support.numpy_to_vtk(np.ascontiguousarray(array), deep=True)
            made.SetName(name)
            new.AddArray(made)
        for kind in range(model.vtkDataSetAttributes.NUM_ATTRIBUTES):
            active = old.GetAbstractAttribute(kind)
            if active is not None and active.GetName() in arrays:
                new.SetActiveAttribute(active.GetName(), kind)
    filled.GetFieldData().ShallowCopy(surface.GetFieldData())
    return filled
