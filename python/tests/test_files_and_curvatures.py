# SPDX-License-Identifier: GPL-3.0-or-later
"""read(), write(), boundary_loops(), curvatures()."""
import pickle

import numpy as np
import pytest

import loopmend
from conftest import icosphere


@pytest.mark.parametrize("name", ["a.ply", "a.ply.gz", "a.obj", "a.off"])
@pytest.mark.parametrize("ascii", [False, True])
def test_files_keep_every_bit(tmp_path, sphere, name, ascii):
    loopmend.write(tmp_path / name, *sphere, ascii=ascii)
    mesh = loopmend.read(tmp_path / name)
    assert mesh.vertices.tobytes() == sphere[0].tobytes() and np.array_equal(mesh.faces, sphere[1])
    assert mesh.colors is None and mesh.report["format"] == name[2:5].upper()
    assert (mesh.report["vertices"], mesh.report["triangles"]) == (len(sphere[0]), len(sphere[1]))


def test_stl_is_welded(tmp_path):
    vertices, faces = icosphere(2)
    loopmend.write(str(tmp_path / "a.stl"), vertices, faces)
    mesh = loopmend.read(str(tmp_path / "a.stl"))
    assert mesh.vertices.shape == vertices.shape and mesh.faces.shape == faces.shape
    corners = mesh.vertices[mesh.faces]
    assert np.abs(corners - vertices[faces]).max() < 1e-7


def test_weld_joins_vertices_at_one_place(tmp_path, sphere):
    soup = sphere[0][sphere[1].ravel()]
    loopmend.write(tmp_path / "soup.ply", soup, np.arange(len(soup)).reshape(-1, 3))
    assert len(loopmend.read(tmp_path / "soup.ply").vertices) == len(soup)
    welded = loopmend.read(tmp_path / "soup.ply", weld=True)
    assert len(welded.vertices) == len(sphere[0])
    assert welded.report["vertices_welded"] == len(soup) - len(sphere[0])


def test_text_of_floats_is_rounded_unless_all_digits_are_asked_for(tmp_path):
    (tmp_path / "a.ply").write_text("ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n"
                                    "property float z\nelement face 1\nproperty list uchar int vertex_indices\n"
                                    "end_header\n0.123456789012 0 0\n1 0 0\n0 1 0\n3 0 1 2\n")
    assert loopmend.read(tmp_path / "a.ply").vertices[0, 0] == np.float32(0.123456789012)
    assert loopmend.read(tmp_path / "a.ply", all_digits=True).vertices[0, 0] == 0.123456789012


def test_colors_are_kept(tmp_path, sphere):
    colors = np.arange(4 * len(sphere[0])).reshape(-1, 4).astype(np.uint8)
    loopmend.write(tmp_path / "a.ply", *sphere, colors=colors)
    assert np.array_equal(loopmend.read(tmp_path / "a.ply").colors, colors)


def test_files_that_are_no_mesh_raise(tmp_path):
    (tmp_path / "notes.ply").write_text("This is not a mesh.\n")
    with pytest.raises(loopmend.ReadError, match='notes.ply: does not begin with "ply"') as caught:
        loopmend.read(tmp_path / "notes.ply")
    assert isinstance(caught.value, loopmend.Error) and isinstance(caught.value, OSError)
    with pytest.raises(loopmend.ReadError, match="missing.ply"):
        loopmend.read(tmp_path / "missing.ply")


def test_files_that_cannot_be_written_raise(tmp_path, sphere):
    for path in (tmp_path / "a.xyz", tmp_path / "none" / "a.ply"):
        with pytest.raises(loopmend.WriteError, match=path.name) as caught:
            loopmend.write(path, *sphere)
        assert isinstance(caught.value, loopmend.Error) and isinstance(caught.value, OSError)
    assert list(tmp_path.iterdir()) == []


def test_the_loops_of_two_round_holes(two_holes):
    vertices, faces = two_holes
    north, south = loopmend.boundary_loops(vertices, faces)
    assert (north.number, south.number) == (1, 2) and {north.kind, south.kind} == {"hole"}
    assert north.perimeter > south.perimeter
    for loop, side in ((north, 1), (south, -1)):
        ring = vertices[loop.vertices]
        assert loop.vertices.dtype == np.int32 and len(loop.vertices) == loop.edges
        assert (side * ring[:, 2] > 0.8).all()
        assert np.allclose(ring.mean(axis=0), loop.center, atol=1e-14)
        assert loop.perimeter == pytest.approx(np.linalg.norm(ring - np.roll(ring, 1, axis=0), axis=1).sum(), rel=1e-14)
        assert loop.diameter == pytest.approx(max(np.linalg.norm(p - q) for p in ring for q in ring), rel=1e-14)


def test_a_closed_mesh_has_no_loops():
    assert loopmend.boundary_loops(*icosphere(1)) == []


def test_curvatures_of_a_sphere():
    """Of second order: half the edge length, a quarter of the error."""
    errors = []
    for levels in (3, 4):
        vertices, faces = icosphere(levels)
        lone = np.vstack([2.5 * vertices, [[9, 9, 9]]])
        field = loopmend.curvatures(lone, faces)
        assert field.H.shape == field.K.shape == (len(lone),) and field.normals.shape == lone.shape
        assert np.isnan(field.H[-1]) and np.isnan(field.K[-1])
        assert np.abs(field.normals[:-1] - vertices).max() < 1e-2
        errors.append((np.abs(field.H[:-1] + 1 / 2.5).max(), np.abs(field.K[:-1] - 1 / 2.5**2).max()))
    coarse, fine = np.array(errors)
    assert (fine < 3e-3).all() and (fine < coarse / 3.5).all()


def test_results_can_be_pickled(sphere):
    """What a pool of processes sends back."""
    result = loopmend.fill(*sphere)
    back = pickle.loads(pickle.dumps(result))
    assert back.vertices.tobytes() == result.vertices.tobytes() and back.holes[0].status == "converged"


def test_errors_can_be_pickled():
    with pytest.raises(loopmend.InvalidArgument) as caught:
        loopmend.fill(np.zeros((1, 2)), [[0, 0, 0]])
    back = pickle.loads(pickle.dumps(caught.value))
    assert type(back) is loopmend.InvalidArgument and str(back) == str(caught.value)


def test_the_module_says_its_version():
    assert loopmend.__version__.count(".") == 2
    assert set(loopmend.__all__) <= set(dir(loopmend))
