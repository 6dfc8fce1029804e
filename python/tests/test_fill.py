# SPDX-License-Identifier: GPL-3.0-or-later
"""fill(): known surfaces, what goes in and comes out, errors."""
import numpy as np
import pytest

import loopmend
from conftest import icosphere, open_edges, without


def test_the_patch_of_a_hole_in_a_sphere_lies_on_the_sphere(sphere):
    vertices, faces = sphere
    result = loopmend.fill(vertices, faces)
    radii = np.linalg.norm(result.vertices[result.new_vertices], axis=1)
    assert len(radii) > 30
    assert np.abs(radii - 1).max() < 1e-6
    assert open_edges(result.faces) == 0
    assert len(result.vertices) - len(result.faces) * 3 // 2 + len(result.faces) == 2
    (hole,) = result.holes
    assert (hole.number, hole.kind, hole.status, hole.method, hole.is_filled) == (1, "hole", "converged", "mmcvf", True)
    assert (hole.message, hole.reason) == ("", "")
    assert hole.energy_after < 1e-3 * hole.energy_before
    assert hole.seam_after.g1_max_deg < 0.01 < hole.seam_before.g1_max_deg
    assert hole.seam_after.h_jump_rms_times_diameter < 1e-2 * hole.seam_before.h_jump_rms_times_diameter
    assert np.linalg.norm(hole.center - [0, 0, np.cos(np.radians(17))]) < 0.05


def test_patches_alone_are_those_of_the_whole(two_holes):
    whole, alone = loopmend.fill(*two_holes), loopmend.fill(*two_holes, patches_only=True)
    assert len(alone.faces) == len(whole.new_faces) and alone.given_faces == 0
    assert alone.given_vertices == sum(hole.edges for hole in whole.holes)  # each vertex of a round hole once
    assert set(map(bytes, alone.vertices[:alone.given_vertices])) <= set(map(bytes, two_holes[0]))
    assert np.array_equal(alone.vertices[alone.faces], whole.vertices[whole.faces[whole.new_faces]])
    for one, other in zip(alone.holes, whole.holes):
        assert np.array_equal(alone.vertices[one.new_vertices], whole.vertices[other.new_vertices])
        assert np.array_equal(alone.vertices[alone.faces[one.new_faces]], whole.vertices[whole.faces[other.new_faces]])
    assert not whole.stopped and not alone.stopped


def test_patches_alone_are_nothing_where_no_hole_is_filled(sphere):
    alone = loopmend.fill(*sphere, max_edges=3, patches_only=True)
    assert alone.vertices.shape == (0, 3) and alone.faces.shape == (0, 3)
    assert (alone.given_vertices, alone.given_faces, alone.holes[0].is_filled) == (0, 0, False)


def test_what_is_not_finished_in_time_is_left_and_said(sphere):
    result = loopmend.fill(*sphere, max_time=1e-6)
    assert result.stopped and result.holes[0].status == "skipped"
    assert result.holes[0].message == "not finished in the time that max_time allows: left open"
    assert np.array_equal(result.vertices, sphere[0]) and np.array_equal(result.faces, sphere[1])


def test_without_a_flow_the_patch_is_flat(sphere):
    result = loopmend.fill(*sphere, flow="none")
    radii = np.linalg.norm(result.vertices[result.new_vertices], axis=1)
    assert np.abs(radii - 1).max() > 0.02
    assert result.holes[0].status == "filled"


def test_what_is_given_comes_first_bit_for_bit(sphere):
    vertices, faces = sphere
    result = loopmend.fill(vertices, faces)
    assert result.vertices.dtype == np.float64 and result.vertices.shape[1] == 3
    assert result.faces.dtype == np.int32 and result.faces.shape[1] == 3
    assert (result.given_vertices, result.given_faces) == (len(vertices), len(faces))
    assert result.vertices[:len(vertices)].tobytes() == vertices.tobytes()
    assert np.array_equal(result.faces[:len(faces)], faces)
    assert result.turned_faces == 0 and result.colors is None


@pytest.mark.parametrize("kind", ["int32", "int64", "uint64", "big endian", "columns", "strided", "list"])
def test_any_layout_of_the_arrays_gives_the_same_bits(sphere, kind):
    vertices, faces = sphere
    wanted = loopmend.fill(vertices, faces)
    if kind in ("int32", "int64", "uint64"):
        faces = faces.astype(kind)
    elif kind == "big endian":
        vertices, faces = vertices.astype(">f8"), faces.astype(">i4")
    elif kind == "columns":
        vertices, faces = np.asfortranarray(vertices), np.asfortranarray(faces.astype(np.int32))
    elif kind == "strided":
        vertices, faces = np.repeat(vertices, 2, axis=0)[::2], np.repeat(faces, 2, axis=1)[:, ::2]
    elif kind == "list":
        vertices, faces = vertices.tolist(), faces.tolist()
    result = loopmend.fill(vertices, faces)
    assert result.vertices.tobytes() == wanted.vertices.tobytes()
    assert result.faces.tobytes() == wanted.faces.tobytes()


def test_single_precision_is_taken_as_it_is(sphere):
    single = sphere[0].astype(np.float32)
    result = loopmend.fill(single, sphere[1])
    assert np.array_equal(result.vertices[:len(single)], single.astype(np.float64))


def test_read_only_arrays_are_read_and_left_alone(sphere):
    vertices, faces = sphere[0].copy(), sphere[1].copy()
    vertices.flags.writeable = faces.flags.writeable = False
    assert loopmend.fill(vertices, faces).holes[0].is_filled
    assert np.array_equal(vertices, sphere[0]) and np.array_equal(faces, sphere[1])


def test_results_are_handed_over_without_a_copy_and_can_be_written_to(sphere):
    result = loopmend.fill(*sphere)
    vertices, faces = result.vertices, result.faces
    assert not vertices.flags.owndata and not faces.flags.owndata
    before = vertices.copy()
    del result
    assert np.array_equal(vertices, before)
    vertices += 1
    assert np.array_equal(vertices, before + 1)


def test_each_hole_says_how_far_it_is_likely_from_what_was_there(two_holes):
    result = loopmend.fill(*two_holes)
    assert len(result.expected_deviation) == len(result.new_vertices)
    for hole in result.holes:
        bounds = hole.expected_deviation
        assert 0 < bounds.half < bounds.likely < bounds.most < hole.diameter
        own = result.expected_deviation[np.searchsorted(result.new_vertices, hole.new_vertices)]
        assert 0 < own.min() < bounds.likely < own.max()
    tangent = loopmend.fill(*two_holes, continuity="tangent")
    assert tangent.holes[0].expected_deviation is None and np.isnan(tangent.expected_deviation).all()


def test_each_hole_names_its_new_vertices_and_faces(two_holes):
    result = loopmend.fill(*two_holes)
    north, south = result.holes
    assert north.edges > south.edges
    for hole, sign in ((north, 1), (south, -1)):
        assert (sign * result.vertices[hole.new_vertices][:, 2] > 0.9).all()
        assert (sign * result.vertices[result.faces[hole.new_faces]][:, :, 2] > 0.9).all()
        assert len(hole.new_faces) == 2 * len(hole.new_vertices) + hole.edges - 2  # of a disk
    assert sorted([*north.new_vertices, *south.new_vertices]) == result.new_vertices.tolist()
    assert sorted([*north.new_faces, *south.new_faces]) == result.new_faces.tolist()


def test_loops_that_are_named_are_filled_and_the_others_left(two_holes):
    south = loopmend.fill(*two_holes, loops=[2])
    assert [(h.number, h.status, h.message) for h in south.holes] == [(1, "skipped", "not selected"), (2, "converged", "")]
    assert south.holes[0].seam_after is None and len(south.holes[0].new_faces) == 0
    assert open_edges(south.faces) == south.holes[0].edges
    loop = loopmend.boundary_loops(*two_holes)[1]
    same = loopmend.fill(*two_holes, at_vertices=loop.vertices[0])
    assert same.vertices.tobytes() == south.vertices.tobytes()
    small = loopmend.fill(*two_holes, max_edges=loop.edges)
    assert small.vertices.tobytes() == south.vertices.tobytes()
    narrow = loopmend.fill(*two_holes, max_diameter=loop.diameter * 1.001)
    assert narrow.vertices.tobytes() == south.vertices.tobytes()


def test_holes_solved_as_one_group_name_their_own_parts():
    """Two holes with a strip of a few faces between them share a patch."""
    near = lambda v: np.minimum(np.linalg.norm(v - [0.21, 0, 0.977], axis=1), np.linalg.norm(v - [-0.21, 0, 0.977], axis=1))
    vertices, faces = without(*icosphere(5), lambda v: near(v) < 0.16)
    result = loopmend.fill(vertices, faces)
    assert len(result.holes) == 2 and all(hole.is_filled for hole in result.holes)
    sides = [np.sign(result.vertices[hole.new_vertices][:, 0].mean()) for hole in result.holes]
    assert sorted(sides) == [-1, 1]
    for hole, side in zip(result.holes, sides):
        assert (side * result.vertices[hole.new_vertices][:, 0] > 0).all()
        assert len(hole.new_faces) == 2 * len(hole.new_vertices) + hole.edges - 2


def test_a_denser_patch_has_more_vertices(sphere):
    plain, dense = (loopmend.fill(*sphere, density=d) for d in (1, 2))
    assert 3 < len(dense.new_vertices) / len(plain.new_vertices) < 5


def test_colors_run_on_over_the_patch(sphere):
    colors = np.full((len(sphere[0]), 4), (10, 200, 30, 255), np.uint8)
    result = loopmend.fill(*sphere, colors=colors)
    assert result.colors.shape == (len(result.vertices), 4)
    assert (result.colors == (10, 200, 30, 255)).all()


def test_the_outer_rim_of_a_sheet_is_left_unless_it_is_asked_for():
    n = 12
    x, y = np.meshgrid(np.arange(n), np.arange(n))
    vertices = np.column_stack([x.ravel(), y.ravel(), np.zeros(n * n)])
    corner = np.array([i * n + j for i in range(n - 1) for j in range(n - 1)])
    faces = np.vstack([np.column_stack([corner, corner + 1, corner + n + 1]),
                       np.column_stack([corner, corner + n + 1, corner + n])])
    left = loopmend.fill(vertices, faces)
    assert [(h.kind, h.status) for h in left.holes] == [("outer rim", "skipped")]
    assert "include_outer_rim=True" in left.holes[0].message and len(left.new_faces) == 0
    assert loopmend.fill(vertices, faces, include_outer_rim=True).holes[0].status != "skipped"


def test_a_face_that_faces_the_other_way_is_turned(sphere):
    faces = sphere[1].copy()
    faces[7] = faces[7][::-1]
    result = loopmend.fill(sphere[0], faces)
    assert result.turned_faces == 1
    assert open_edges(result.faces) == 0


def test_stitch_repair_and_trim_say_what_they_did(sphere):
    vertices, faces = sphere
    twice = np.vstack([faces, faces[:3]])
    repaired = loopmend.fill(vertices, twice, repair=True)
    assert repaired.prepared["repaired"]["duplicate_faces"] == 3
    assert repaired.given_faces == len(faces)
    dangling = np.vstack([vertices, [[0, 0, 1.5]]])
    (a, b) = loopmend.boundary_loops(vertices, faces)[0].vertices[:2]
    trimmed = loopmend.fill(dangling, np.vstack([faces, [[a, b, len(vertices)]]]), trim_boundary=3)
    assert {"face": len(faces), "fault": "dangling", "ring": 1} in list(trimmed.trimmed_faces)
    assert trimmed.given_faces <= len(faces)
    split = without(*icosphere(3), lambda v: v[:, 2] > 0.9)
    soup = split[0][split[1].ravel()], np.arange(3 * len(split[1])).reshape(-1, 3)
    stitched = loopmend.fill(*soup, stitch=True)
    assert stitched.prepared["stitched"]["joined_vertices"] > 1000
    assert [h.status for h in stitched.holes if h.kind == "hole"] == ["converged"]


def test_faces_that_cut_others_are_cut_out():
    vertices, faces = icosphere(3)
    two = np.vstack([vertices, vertices * 0.4 + [1.0, 0, 0]]), np.vstack([faces, faces + len(vertices)])
    before = loopmend.check(*two)
    assert not before.ready_to_print and before.intersecting_pairs > 20 and before.pieces == 2
    assert before.against_it == (f"{before.intersecting_pairs} pairs of triangles that intersect",)
    # What is closed is not opened.
    closed = loopmend.fill(*two, cut_intersections=True)
    assert closed.prepared["repaired"]["intersecting_faces"] == 0 and len(closed.faces) == len(two[1])
    opened = without(vertices * 0.4 + [1.0, 0, 0], faces, lambda v: v[:, 0] > 1.35)
    two = np.vstack([vertices, opened[0]]), np.vstack([faces, opened[1] + len(vertices)])
    result = loopmend.fill(*two, cut_intersections=True)
    assert result.prepared["repaired"]["intersecting_faces"] > 20
    assert loopmend.check(result.vertices, result.faces).intersecting_pairs == 0


def test_closed_bodies_that_overlap_become_one():
    vertices, faces = icosphere(3)
    two = np.vstack([vertices, vertices + [1.0, 0, 0]]), np.vstack([faces, faces + len(vertices)])
    result = loopmend.fill(*two, union=True)
    united = result.prepared["repaired"]["union"]
    assert united["bodies"] == 2 and united["made"] == 1 and united["open_pieces"] == 0
    assert np.array_equal(result.vertices[:len(two[0])], two[0])
    found = loopmend.check(result.vertices, result.faces)
    assert found.ready_to_print and found.pieces == 1
    height = 0.5
    assert abs(found.volume - (8 * np.pi / 3 - 2 * np.pi * height**2 * (3 - height) / 3)) < 0.1


def test_check_gives_the_volume_of_what_is_closed(sphere):
    assert loopmend.check(*sphere).volume is None
    assert loopmend.check(*sphere).open_boundaries == 1
    result = loopmend.fill(*sphere)
    assert loopmend.check(result.vertices, result.faces).ready_to_print
    assert abs(loopmend.check(result.vertices, result.faces).volume - 4 / 3 * np.pi) < 0.02
    inside_out = loopmend.check(result.vertices, result.faces[:, ::-1])
    assert not inside_out.ready_to_print and inside_out.volume < 0


def test_time_and_memory_are_bounded(sphere):
    (hole,) = loopmend.fill(*sphere, max_time=1e-6).holes
    assert (hole.status, hole.is_filled, len(hole.new_faces)) == ("skipped", False, 0)
    assert "max_time" in hole.message
    (hole,) = loopmend.fill(*sphere, max_memory=1).holes
    assert not hole.is_filled and "memory" in hole.message
    with pytest.raises(loopmend.InvalidArgument, match="max_time must be greater than 0"):
        loopmend.fill(*sphere, max_time=0)


def test_a_bridge_parts_a_hole(sphere):
    loop = loopmend.boundary_loops(*sphere)[0].vertices
    result = loopmend.fill(*sphere, bridges=[(loop[0], loop[len(loop) // 2])])
    assert len(result.holes) == 2
    assert result.given_faces > len(sphere[1])


WRONG = [
    ({"flow": "fast"}, "flow takes one of mmcvf, wf, sdf, mcf, none, not 'fast'"),
    ({"boundary": "smooth"}, "boundary takes one of auto, exact, robust, not 'smooth'"),
    ({"density": 11}, "the density must lie between 0.1 and 10"),
    ({"density": float("nan")}, "the density must lie between 0.1 and 10"),
    ({"sigma": 0}, "the time step sigma must lie between"),
    ({"steps": 0}, "the number of steps must be at least 1, not 0"),
    ({"loops": [7]}, "there is no loop 7: the mesh has one loop, number 1"),
    ({"loops": []}, "names nothing"),
    ({"at_vertices": [10**6]}, "there is no vertex 1000000"),
    ({"max_edges": 0}, "max_edges must be greater than 0, not 0"),
    ({"max_diameter": -1.5}, "max_diameter must be greater than 0, not -1.5"),
    ({"threads": -1}, "threads must lie between 0 and 1024, not -1"),
    ({"trim_boundary": 101}, "trim_boundary must lie between 0 and 100, not 101"),
    ({"mirror_plane": [0, 0, 0, 0, 0, 0]}, "a mirror plane needs a point and a normal that is not 0"),
    ({"mirror": True, "flow": "none"}, "is no mirror image: choose a flow"),
    ({"islands": "leave"}, "islands takes one of join, cover, not 'leave'"),
    ({"bridges": [(0, 10**6)]}, r"bridge \(0, 1000000\): the mesh has 2504 vertices"),
    ({"colors": np.zeros((3, 4), np.uint8)}, "colors must have one row for each of the 2504 vertices, not 3"),
    ({"colors": np.zeros((2504, 4))}, "colors must be of uint8"),
    ({"colors": np.zeros((2504, 2), np.uint8)}, r"colors must have the shape \(n, 4\), not \(2504, 2\)"),
]


@pytest.mark.parametrize("options, words", WRONG)
def test_options_out_of_range_raise_with_the_words_of_the_engine(sphere, options, words):
    words = words.replace("2504", str(len(sphere[0])))
    if "colors" in options and len(options["colors"]) > 3:
        options = {"colors": np.resize(options["colors"], (len(sphere[0]), options["colors"].shape[1]))}
    with pytest.raises(loopmend.InvalidArgument, match=words) as caught:
        loopmend.fill(*sphere, **options)
    assert isinstance(caught.value, loopmend.Error) and isinstance(caught.value, ValueError)


def test_a_mirror_image_is_copied_where_it_fits():
    vertices, faces = icosphere(4)
    ends = np.linalg.norm(vertices - [0.8, 0.5, 0.33], axis=1), np.linalg.norm(vertices - [-0.8, 0.5, 0.33], axis=1)
    bumps = 1 + sum(0.3 * np.exp(-end**2 / 0.05) for end in ends)
    shape = vertices * bumps[:, None] * [1, 1.3, 0.8]
    keep = ends[0] > 0.22
    number = np.cumsum(keep) - 1
    result = loopmend.fill(shape[keep], number[faces[keep[faces].all(axis=1)]], mirror=True)
    fit = result.holes[0].mirror
    assert fit.is_taken and fit.answer == "proposed" and fit.misfit < 1e-3 and fit.difference > 10 * fit.misfit
    assert result.holes[0].method == "mirror_image" and abs(abs(fit.plane_normal[0]) - 1) < 1e-3
    top = shape[~keep]  # the copy has the same triangles, but for those at its border
    gaps = np.linalg.norm(result.vertices[result.new_vertices][:, None] - top, axis=2).min(axis=1)
    assert gaps.max() < 1e-6
    assert loopmend.fill(shape[keep], number[faces[keep[faces].all(axis=1)]]).holes[0].mirror is None


@pytest.mark.parametrize("options", [{"steps": "many"}, {"density": None}, {"flow": 3}, {"sigmas": 1}])
def test_options_of_another_type_or_name_raise_type_error(sphere, options):
    with pytest.raises(TypeError):
        loopmend.fill(*sphere, **options)


@pytest.mark.parametrize("vertices, faces, words", [
    (np.zeros((4, 2)), [[0, 1, 2]], r"vertices must have the shape \(n, 3\), not \(4, 2\)"),
    (np.zeros(3), [[0, 1, 2]], r"vertices must have the shape \(n, 3\), not \(3,\)"),
    (np.zeros((4, 3)), [[0, 1, 2, 3]], r"faces must have the shape \(n, 3\), not \(1, 4\)"),
    (np.zeros((4, 3)), [[0.0, 1, 2]], "faces must be whole numbers, not float64"),
    (np.zeros((4, 3), complex), [[0, 1, 2]], "vertices must be real numbers, not complex128"),
    (np.eye(3), [[0, 1, 3]], "face 0 names vertex 3, but the mesh has 3 vertices, numbered from 0"),
    (np.eye(3), [[0, 1, -1]], "face 0 names vertex -1"),
    (np.eye(3), np.array([[0, 1, 2**33]]), "face 0 names vertex 8589934592"),
    (np.eye(3), np.array([[0, 1, 2**64 - 1]], np.uint64), "face 0 names vertex 18446744073709551615"),
    ([[0, 0, 0], [1, 0, 0], [0, float("nan"), 0]], [[0, 1, 2]], "vertex 2 has a coordinate that is no finite number"),
    (np.eye(3), np.zeros((0, 3), int), "."),
])
def test_arrays_that_are_no_mesh_raise(vertices, faces, words):
    for call in (loopmend.fill, loopmend.boundary_loops, loopmend.curvatures):
        with pytest.raises(loopmend.InvalidArgument, match=words):
            call(vertices, faces)


def test_a_closed_mesh_comes_back_as_it_is():
    vertices, faces = icosphere(2)
    result = loopmend.fill(vertices, faces)
    assert result.holes == () and len(result.new_vertices) == 0 and np.array_equal(result.faces, faces)


def test_a_hole_that_cannot_be_filled_is_a_value():
    """A hole whose boundary runs through the surface: nothing can close it, and nothing is raised."""
    vertices, faces = without(*icosphere(3), lambda v: v[:, 2] > 0.9)
    loop = loopmend.boundary_loops(vertices, faces)[0].vertices
    bad = vertices.copy()
    bad[loop[0]] = [0.3, 0.1, -1.5]
    result = loopmend.fill(bad, faces)
    assert result.holes[0].status == "failed" or result.holes[0].verdict.grade == "bad"


def test_nothing_is_printed(sphere, capfd):
    loopmend.fill(*sphere)
    assert capfd.readouterr() == ("", "")
