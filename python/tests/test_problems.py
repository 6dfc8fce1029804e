# SPDX-License-Identifier: GPL-3.0-or-later
"""blend(), interpolate(), evolve(): known surfaces, and the same bits as the command line."""
import numpy as np
import pytest

import loopmend
from conftest import icosphere, open_edges
from test_same_bits import ply_arrays


def tube(begin, end, around=24, along=10):
    """An open cylinder of radius 1 round the x axis, its outside facing out."""
    x, a = np.meshgrid(np.linspace(begin, end, along + 1), 2 * np.pi * np.arange(around) / around, indexing="ij")
    vertices = np.column_stack([x.ravel(), np.cos(a).ravel(), np.sin(a).ravel()])
    i, j = (k.ravel() for k in np.meshgrid(np.arange(along) * around, np.arange(around), indexing="ij"))
    a, b = i + j, i + (j + 1) % around
    return vertices, np.vstack([np.column_stack([a, b, b + around]), np.column_stack([a, b + around, a + around])])


@pytest.fixture(scope="module")
def tubes():
    return tube(-3, -1), tube(1, 3)


def test_a_blend_of_two_tubes_is_the_tube_between_them(tubes):
    steps = []
    result = loopmend.blend(tubes, boundary="exact", progress=lambda step, energy: steps.append((step, energy)))
    assert result.refusal == "" and result.status == "converged" and result.method == "mmcvf"
    given = np.vstack([tubes[0][0], tubes[1][0]])
    assert result.given_vertices == len(given)
    assert result.vertices[:len(given)].tobytes() == given.tobytes()
    new = result.vertices[len(given):]
    assert len(new) > 50 and (np.abs(new[:, 0]) < 1).all()
    assert np.abs(np.hypot(new[:, 1], new[:, 2]) - 1).max() < 0.01
    assert open_edges(result.faces) == 2 * 24  # the far ends
    assert len(result.seams_after) == 2 and (result.folds, result.self_intersections) == (0, 0)
    assert steps and steps[0][0] == 1


def test_interpolation_of_an_icosahedron_is_a_sphere():
    vertices, faces = icosphere(0)
    result = loopmend.interpolate(vertices, faces, subdivide=3)
    assert result.refusal == "" and result.given_vertices == 12
    assert result.vertices[:12].tobytes() == vertices.tobytes()
    assert result.vertices.shape == (642, 3) and result.faces.shape == (1280, 3)
    assert np.abs(np.linalg.norm(result.vertices, axis=1) - 1).max() < 1e-3


def test_a_dent_in_a_sphere_is_taken_out():
    vertices, faces = icosphere(4)
    region = vertices[:, 2] > 0.9
    dented = vertices.copy()
    dented[region, 2] -= 0.1 * (vertices[region, 2] - 0.9)
    by_mask = loopmend.evolve(dented, faces, region)
    assert by_mask.refusal == "" and not by_mask.remeshed
    assert np.abs(np.linalg.norm(by_mask.vertices, axis=1) - 1).max() < 1e-4
    assert by_mask.vertices[~region].tobytes() == dented[~region].tobytes()
    by_number = loopmend.evolve(dented, faces, np.flatnonzero(region))
    assert by_number.vertices.tobytes() == by_mask.vertices.tobytes()


def test_the_same_bits_as_the_command_line(program, tmp_path, tubes):
    for name, mesh in zip(("left.ply", "right.ply"), tubes):
        loopmend.write(tmp_path / name, *mesh)
    out = tmp_path / "out.ply"

    def check(result):
        vertices, faces = ply_arrays(out)
        assert result.vertices.tobytes() == vertices.tobytes() and result.faces.tobytes() == faces.tobytes()

    program("blend", tmp_path / "left.ply", tmp_path / "right.ply", "-o", out, "--quiet")
    check(loopmend.blend(tubes))
    program("blend", tmp_path / "left.ply", tmp_path / "right.ply", "-o", out, "--quiet", "--loops", "1:1,2:2", "--flow", "wf")
    check(loopmend.blend(tubes, loops=[(1, 1), (2, 2)], flow="wf"))

    vertices, faces = icosphere(1)
    vertices = vertices * [1, 2, 3]
    loopmend.write(tmp_path / "poly.ply", vertices, faces)
    program("interpolate", tmp_path / "poly.ply", "-o", out, "--subdivide", "2", "--quiet")
    check(loopmend.interpolate(vertices, faces, subdivide=2))

    scan = loopmend.sample()
    loopmend.write(tmp_path / "scan.ply", scan.vertices, scan.faces)
    region = np.flatnonzero(np.linalg.norm(scan.vertices - scan.vertices[7000], axis=1) < 6)
    (tmp_path / "region.txt").write_text(" ".join(map(str, region)))
    program("evolve", tmp_path / "scan.ply", "-o", out, "--region", tmp_path / "region.txt", "--quiet")
    check(loopmend.evolve(scan.vertices, scan.faces, region))


@pytest.mark.parametrize("call, words", [
    (lambda t: loopmend.blend(t, loops=[(1, 1)]), "a blend needs at least two loops"),
    (lambda t: loopmend.blend(t, loops=[(1, 1), (3, 1)]), "there is no file 3"),
    (lambda t: loopmend.blend([]), "one part at least"),
    (lambda t: loopmend.blend([t[0], t[0]], density=99), "density must lie between"),
    (lambda t: loopmend.interpolate(*t[0]), "."),
    (lambda t: loopmend.interpolate(*icosphere(0), subdivide=9), "."),
    (lambda t: loopmend.interpolate(*icosphere(0), fixed=[]), "fixed names no vertex"),
    (lambda t: loopmend.evolve(*icosphere(1), [10**6]), "."),
    (lambda t: loopmend.evolve(*icosphere(1), []), "."),
    (lambda t: loopmend.evolve(*icosphere(1), [1], flow="none"), "would leave the region as it is"),
    (lambda t: loopmend.evolve(*icosphere(1), [True, False]), "one bool for each of the 42 vertices"),
])
def test_what_cannot_be_posed_raises(tubes, call, words):
    with pytest.raises(loopmend.InvalidArgument, match=words):
        call(tubes)
