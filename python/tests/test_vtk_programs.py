# SPDX-License-Identifier: GPL-3.0-or-later
"""The filter for ParaView and the module for 3D Slicer, with VTK from PyPI. ParaView and Slicer are replaced by stand-ins of the few names
that the files import: that both programs show and call them is not tested here."""
import importlib.util
import sys
import types
from pathlib import Path
from unittest import mock

import numpy as np
import pytest

import loopmend
from conftest import icosphere, without

here = Path(__file__).resolve().parent.parent


def module(name, **entries):
    made = types.ModuleType(name)
    made.__dict__.update(entries)
    return made


def load(path, stand_ins):
    with mock.patch.dict(sys.modules, {made.__name__: made for made in stand_ins}):
        spec = importlib.util.spec_from_file_location(path.stem, path)
        loaded = importlib.util.module_from_spec(spec)
        spec.loader.exec_module(loaded)
    return loaded


class Decorators:
    """Each of its methods takes what describes an entry of the panel, and leaves the function as it is."""

    def __getattr__(self, _name):
        return lambda *_words, **_named: lambda decorated: decorated


@pytest.fixture(scope="module")
def vtk_model():
    return pytest.importorskip("vtkmodules.vtkCommonDataModel")


@pytest.fixture(scope="module")
def holes(vtk_model):
    """A sphere of vtkPolyData with a wide and a narrow hole, and its heights at the points."""
    from vtkmodules.util.numpy_support import numpy_to_vtk
    from loopmend._vtk import made_of

    vertices, faces = without(*icosphere(4), lambda v: (v[:, 2] > np.cos(np.radians(20))) | (v[:, 2] < -np.cos(np.radians(9))))
    mesh = made_of(vertices, faces, {}, {}, vtk_model.vtkPolyData())
    height = numpy_to_vtk(vertices[:, 2].copy(), deep=True)
    height.SetName("height")
    mesh.GetPointData().AddArray(height)
    return mesh


@pytest.fixture
def paraview(vtk_model):
    decorators = module("paraview.util.vtkAlgorithm", **{name: Decorators() for name in ("smdomain", "smhint", "smproperty", "smproxy")})
    return load(here / "paraview/loopmend_paraview.py", [module("paraview"), module("paraview.util"), decorators])


def test_the_filter_of_paraview_fills_and_names_the_holes(paraview, holes):
    fill = paraview.LoopmendFillHoles()
    fill.SetInputDataObject(0, holes)
    fill.Update()
    filled = fill.GetOutputDataObject(0)
    assert loopmend.check(filled).open_edges == 0 and filled.GetPointData().GetArray("height").GetNumberOfTuples() == filled.GetNumberOfPoints()
    assert filled.GetCellData().GetArray("loopmend hole").GetRange() == (0, 2)
    before = filled.GetNumberOfCells()
    fill.SetDensity(2.0)
    fill.Update()
    assert fill.GetOutputDataObject(0).GetNumberOfCells() > before
    narrow = min(loop.edges for loop in loopmend.boundary_loops(holes))
    fill.SetMostEdges(narrow)
    fill.Update()
    assert [hole.is_filled for hole in fill.result.holes] == [False, True]


def test_the_filter_hands_a_closed_surface_on(paraview, holes):
    closed = loopmend.fill(holes).mesh
    fill = paraview.LoopmendFillHoles()
    fill.SetInputDataObject(0, closed)
    fill.Update()
    assert fill.GetOutputDataObject(0).GetNumberOfCells() == closed.GetNumberOfCells()


def test_the_logic_of_slicer_fills(vtk_model, holes):
    class Base:
        pass

    scripted = module("slicer.ScriptedLoadableModule", **{f"ScriptedLoadableModule{part}": Base for part in ("", "Logic", "Widget")})
    slicer = load(here / "slicer/Loopmend.py", [module("ctk"), module("qt"), module("slicer"), scripted])
    filled, said = slicer.LoopmendLogic().fill_polydata(holes, density=1.5)
    assert said == "2 of 2 boundary loops filled." and loopmend.check(filled).open_edges == 0
    assert isinstance(filled, vtk_model.vtkPolyData) and filled.GetPointData().GetArray("height") is not None
    assert "has more than 3 edges" in slicer.LoopmendLogic().fill_polydata(holes, max_edges=3)[1]
