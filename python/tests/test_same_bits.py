# SPDX-License-Identifier: GPL-3.0-or-later
"""The same options give the same bits as the command line does."""
import json
import math

import numpy as np
import pytest

import loopmend
from conftest import icosphere, without

# On the embedded sample, which has relief.
SAMPLE_FILLS = [
    (["--loops", "all"], {}),
    (["--relief", "continued", "--relief-seed", "3", "--loops", "6"], {"relief": "continued", "relief_seed": 3, "loops": 6}),
    (["--at-vertex", "13,96", "--solver", "gmres", "--mode", "steps", "--steps", "2"],
     {"at_vertices": [13, 96], "solver": "gmres", "mode": "steps", "steps": 2}),
]

# On a small rough sphere with six holes.
BALL_FILLS = [
    (["--loops", "2,5"], {"loops": [2, 5]}),
    (["--flow", "wf", "--mode", "steps", "--steps", "3", "--sigma", "1"],
     {"flow": "wf", "mode": "steps", "steps": 3, "sigma": 1}),
    (["--loops", "2:flat,5:tangent,6"], {"loops": {2: "flat", 5: "tangent", 6: None}}),
    (["--base", "1:0.5"], {"base": (1, 0.5)}),
    (["--cut-plane", "0.1,0,0.5,0.1,0,1"], {"cut_plane": [0.1, 0, 0.5, 0.1, 0, 1]}),
    (["--boundary", "exact", "--max-edges", "60"], {"boundary": "exact", "max_edges": 60}),
    (["--boundary", "robust", "--threads", "1"], {"boundary": "robust", "threads": 1}),
    (["--continuity", "tangent"], {"continuity": "tangent"}),
    (["--trim-boundary", "3", "--flow", "mcf"], {"trim_boundary": 3, "flow": "mcf"}),
    (["--trim-crossing"], {"trim_crossing": True}),
    (["--cut-intersections", "--loops", "6"], {"cut_intersections": True, "loops": 6}),
    (["--union", "--loops", "6"], {"union": True, "loops": 6}),
    (["--stitch", "--repair", "--loops", "6"], {"stitch": True, "repair": True, "loops": 6}),
    (["--patches-only"], {"patches_only": True}),
    (["--mirror"], {"mirror": True}),
    (["--mirror-plane", "0,0,0.5,0,0,1"], {"mirror_plane": [0, 0, 0.5, 0, 0, 1]}),
    (["--patches-only", "--loops", "6", "--trim-boundary", "3"], {"patches_only": True, "loops": 6, "trim_boundary": 3}),
]


@pytest.fixture(scope="module")
def ball():
    """A rough sphere with a hole around each end of each axis, no two of them equally wide."""
    vertices, faces = icosphere(3)
    widths = np.cos(np.radians([[14, 17, 20], [23, 26, 29]]))
    vertices, faces = without(vertices, faces, lambda v: (v > widths[0]).any(axis=1) | (-v > widths[1]).any(axis=1))
    return vertices * (1 + 0.01 * np.random.default_rng(1).standard_normal((len(vertices), 1))), faces


def ply_arrays(path):
    """Vertices and faces of a binary PLY by NumPy alone: double x, y, z and lists of three int."""
    data = path.read_bytes()
    header, end = data[:data.index(b"end_header\n")].decode().splitlines(), data.index(b"end_header\n") + 11
    count = {line.split()[1]: int(line.split()[2]) for line in header if line.startswith("element")}
    assert [line for line in header if line.startswith("property")] == [
        "property double x", "property double y", "property double z", "property list uchar int vertex_indices"]
    vertices = np.frombuffer(data, "<f8", 3 * count["vertex"], end).reshape(-1, 3)
    rows = np.dtype([("n", "u1"), ("v", "<i4", 3)])
    faces = np.frombuffer(data, rows, count["face"], end + vertices.nbytes)
    assert (faces["n"] == 3).all()
    return vertices, faces["v"]


def same(figure, reported):
    return math.isnan(figure) if reported is None else figure == reported


def check_same(program, folder, scan, words, options):
    filled, report = folder / "filled.ply", folder / "report.json"
    program("fill", scan, "-o", filled, "--report", report, "--quiet", *words)
    mesh = loopmend.read(scan)
    result = loopmend.fill(mesh.vertices, mesh.faces, **options)
    vertices, faces = ply_arrays(filled)
    assert result.vertices.tobytes() == vertices.tobytes()
    assert result.faces.tobytes() == faces.tobytes()
    loops = json.loads(report.read_text())["loops"]
    assert len(loops) == len(result.holes)
    for loop, hole in zip(loops, result.holes):
        for name in ("number", "kind", "edges", "perimeter", "diameter", "status", "method", "steps"):
            assert getattr(hole, name) == loop[name], name
        for name in ("message", "reason"):  # which names options as Python does
            assert (getattr(hole, name) == loop[name] or "--" in loop[name]) and "--" not in getattr(hole, name), name
        assert same(hole.energy_before, loop["energy"]["initial"]) and same(hole.energy_after, loop["energy"]["final"])
        if not hole.message.startswith("an island"):  # whose patch counts for its hole
            assert len(hole.new_vertices) == (loop["free_vertices"] if hole.is_filled else 0)
        for seam, reported in ((hole.seam_before, loop["seam_before"]), (hole.seam_after, loop["seam_after"])):
            assert seam is None or all(same(getattr(seam, name), value) for name, value in reported.items())
    return result


@pytest.mark.parametrize("words, options", BALL_FILLS, ids=[" ".join(words) for words, _ in BALL_FILLS])
def test_a_ball_with_six_holes(ball, program, tmp_path, words, options):
    loopmend.write(tmp_path / "ball.ply", *ball)
    result = check_same(program, tmp_path, tmp_path / "ball.ply", words, options)
    assert len(result.holes) == (5 if {"base", "cut_plane"} & options.keys() else 6) and any(hole.is_filled for hole in result.holes)


@pytest.mark.parametrize("words, options", SAMPLE_FILLS, ids=[" ".join(words) for words, _ in SAMPLE_FILLS])
def test_the_sample(program, tmp_path, words, options):
    scan = tmp_path / "scan.ply"
    program("sample", "-o", scan)
    result = check_same(program, tmp_path, scan, words, options)
    assert any(hole.is_filled for hole in result.holes)


def test_the_sample_itself(program, tmp_path):
    program("sample", "-o", tmp_path / "scan.ply")
    vertices, faces = ply_arrays(tmp_path / "scan.ply")
    sample = loopmend.sample()
    assert sample.vertices.tobytes() == vertices.tobytes() and sample.faces.tobytes() == faces.tobytes()


def test_a_sheet_with_its_outer_rim(program, tmp_path):
    across = 12
    x, y = (axis.ravel() for axis in np.meshgrid(np.arange(across + 1), np.arange(across + 1)))
    vertices = np.column_stack([x, y, 0.05 * (x - 6) ** 2 - 0.03 * (y - 5) ** 2])
    first = (x + y * (across + 1))[(x < across) & (y < across)]
    squares = np.column_stack([first, first + 1, first + across + 2, first + across + 1])
    faces = np.vstack([squares[:, [0, 1, 2]], squares[:, [0, 2, 3]]])
    loopmend.write(tmp_path / "sheet.ply", *without(vertices, faces, lambda v: np.hypot(v[:, 0] - 6, v[:, 1] - 6) < 2))
    result = check_same(program, tmp_path, tmp_path / "sheet.ply", ["--flow", "none", "--density", "1.5", "--include-outer-rim"],
                        {"flow": "none", "density": 1.5, "include_outer_rim": True})
    assert {hole.kind for hole in result.holes} == {"hole", "outer rim"} and all(hole.is_filled for hole in result.holes)


@pytest.mark.parametrize("islands", ["join", "cover"])
def test_a_hole_with_an_island(program, tmp_path, islands):
    ring = lambda v: (v[:, 2] > np.cos(np.radians(40))) & (v[:, 2] < np.cos(np.radians(20)))
    loopmend.write(tmp_path / "island.ply", *without(*icosphere(4), ring))
    result = check_same(program, tmp_path, tmp_path / "island.ply", ["--islands", islands], {"islands": islands})
    assert result.holes[0].is_filled
    assert (result.holes[1].status == result.holes[0].status) == (islands == "join")


def test_a_tiny_handle(program, tmp_path):
    """Two triangles of a sphere become the ends of a strut of three edges around."""
    vertices, faces = icosphere(5)
    middles = vertices[faces].mean(axis=1)
    first, second = (int(np.argmin(np.linalg.norm(middles - place, axis=1))) for place in ([0, 0, 1], [0.15, 0, 0.99]))
    (a, b, c), (d, f, e) = faces[first], faces[second]
    strut = [(a, b, d), (d, b, e), (b, c, e), (e, c, f), (c, a, f), (f, a, d)]
    scan = tmp_path / "handle.ply"
    loopmend.write(scan, vertices, np.vstack([np.delete(faces, [first, second], axis=0), strut]))
    result = check_same(program, tmp_path, scan, ["--cut-handles"], {"cut_handles": True})
    assert result.prepared["repaired"]["cut_handles"] == 1
    assert all(hole.is_filled for hole in result.holes)
    used, edges = np.unique(result.faces).size, len(result.faces) * 3 // 2
    assert used - edges + len(result.faces) == 2  # a sphere again


def test_a_drawn_edge(program, tmp_path):
    """A roof with a bend of 20°, less than what counts as sharp."""
    n = 25
    x, y = np.meshgrid(np.linspace(-1, 1, n), np.linspace(-1, 1, n))
    vertices = np.column_stack([x.ravel(), y.ravel(), -np.tan(np.radians(10)) * abs(x.ravel())])
    corner = np.array([row * n + column for row in range(n - 1) for column in range(n - 1)])
    faces = np.concatenate([np.column_stack([corner, corner + 1, corner + n + 1]),
                            np.column_stack([corner, corner + n + 1, corner + n])]).astype(np.int32)
    vertices, faces = without(vertices, faces, lambda v: np.hypot(v[:, 0], v[:, 1]) < 0.4)
    loopmend.write(tmp_path / "roof.ply", vertices, faces)
    (hole,) = [loop for loop in loopmend.boundary_loops(vertices, faces) if loop.kind == "hole"]
    ends = [int(min(hole.vertices, key=lambda v: np.linalg.norm(vertices[v] - (0, side, 0)))) for side in (-1, 1)]
    result = check_same(program, tmp_path, tmp_path / "roof.ply", ["--draw-edge", f"{ends[0]},{ends[1]}"],
                        {"drawn_edges": [tuple(ends)]})
    new = np.asarray(result.vertices)[len(vertices):]
    assert abs(new[:, 2] + np.tan(np.radians(10)) * abs(new[:, 0])).max() < 1e-9
    check_same(program, tmp_path, tmp_path / "roof.ply", ["--stop-edge", str(ends[0])], {"stopped_edges": [ends[0]]})
