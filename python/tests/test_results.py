# SPDX-License-Identifier: GPL-3.0-or-later
"""What comes back of a fill: saved, shown, as a table, and with all that its file carried."""
import base64
import pickle
import re
import sys
import zlib

import numpy as np
import pytest

import loopmend
from conftest import icosphere, without


@pytest.fixture(scope="module")
def result(sphere):
    return loopmend.fill(*sphere)


@pytest.fixture
def scan(tmp_path, sphere):
    loopmend.write(tmp_path / "scan.ply", *sphere)
    return tmp_path / "scan.ply"


def test_a_path_a_mesh_a_pair_and_a_result_are_meshes(scan, sphere, result):
    mesh = loopmend.read(scan)
    for given in (scan, str(scan), mesh, sphere, [sphere[0], sphere[1].tolist()]):
        filled = loopmend.fill(given)
        assert filled.vertices.tobytes() == result.vertices.tobytes() and filled.faces.tobytes() == result.faces.tobytes()
        assert type(filled.mesh) is loopmend.Mesh and filled.mesh.vertices is filled.vertices
    assert loopmend.fill(result).holes == () and loopmend.boundary_loops(result.mesh) == []
    assert loopmend.check(scan).open_boundaries == 1 and loopmend.check(result).ready_to_print
    assert loopmend.curvatures(mesh).H.shape == (len(sphere[0]),)


def test_saving_is_writing(tmp_path, scan, result):
    result.save(tmp_path / "a.ply")
    loopmend.write(tmp_path / "b.ply", result.vertices, result.faces)
    assert (tmp_path / "a.ply").read_bytes() == (tmp_path / "b.ply").read_bytes()
    loopmend.read(scan).save(tmp_path / "c.off")
    assert len(loopmend.read(tmp_path / "c.off").vertices) == result.given_vertices


def test_each_is_one_line(scan, result):
    assert repr(result) == (f"<loopmend.FillResult: 1 of 1 loop filled, {len(result.vertices)} vertices ({len(result.new_vertices)} new), "
                            f"{len(result.faces)} faces ({len(result.new_faces)} new)>")
    assert repr(loopmend.read(scan)) == f"<loopmend.Mesh: {result.given_vertices} vertices, {result.given_faces} faces, PLY>"
    assert re.fullmatch(r"<loopmend.HoleResult 1: hole, \d+ edges, converged, good>", repr(result.holes[0]))
    assert re.fullmatch(r"<loopmend.BoundaryLoop 1: hole, \d+ edges, 0.\d+ wide>", repr(loopmend.boundary_loops(scan)[0]))


def pixels_of(png):
    """By zlib alone: 8 bits, three colours, no filter."""
    width, height = (int.from_bytes(png[at:at + 4], "big") for at in (16, 20))
    data, at = b"", 8
    while at < len(png):
        size, kind = int.from_bytes(png[at:at + 4], "big"), png[at + 4:at + 8]
        data += png[at + 8:at + 8 + size] if kind == b"IDAT" else b""
        at += 12 + size
    rows = np.frombuffer(zlib.decompress(data), np.uint8).reshape(height, 1 + 3 * width)
    assert not rows[:, 0].any()
    return rows[:, 1:].reshape(height, width, 3)


def test_a_notebook_shows_table_and_picture(result):
    html = result._repr_html_()
    assert html.count("<tr>") == 2 and "<td style='text-align:left'>good</td>" in html
    assert "converged" not in html  # how the computation ended: in the report, not in the table
    picture = pixels_of(base64.b64decode(re.search("base64,([^']+)'", html)[1]))
    assert picture.shape == (315, 420, 3) and len(np.unique(picture.reshape(-1, 3), axis=0)) > 100


def test_a_sphere_is_drawn_as_a_disc_with_its_patch(tmp_path, result):
    image = loopmend.render(result, tmp_path / "a.png", size=(200, 200))
    assert np.array_equal(pixels_of((tmp_path / "a.png").read_bytes()), image)
    drawn = (image != 255).any(axis=2)
    assert drawn.mean() == pytest.approx(0.94**2 * np.pi / 4, rel=0.02)  # it fills 94 % of the picture
    orange = image[:, :, 0].astype(int) - image[:, :, 2] > 60
    assert orange[100, 100]  # seen from where the patch is
    a, b, c = (result.vertices[corner] for corner in result.faces[result.new_faces].T)
    assert orange.mean() / drawn.mean() == pytest.approx(np.cross(b - a, c - a)[:, 2].sum() / 2 / np.pi, rel=0.05)
    behind = result.render(size=(200, 200), direction=(0, 0, -1))
    assert not (behind[:, :, 0].astype(int) - behind[:, :, 2] > 60).any() and (behind[100, 100] != 255).any()


def test_the_nearer_surface_is_drawn(sphere):
    """A small sphere before a large one, and behind it."""
    vertices, faces = icosphere(3)
    both = np.vstack([vertices, 0.3 * vertices + [0, 0, 3]]), np.vstack([faces, faces + len(vertices)])
    colors = np.zeros((len(both[0]), 4), np.uint8)
    colors[:len(vertices), 0] = colors[len(vertices):, 1] = colors[:, 3] = 255
    mesh = loopmend.Mesh(*both, colors)
    before, behind = (loopmend.render(mesh, size=(100, 100), direction=(0, 0, z)) for z in (1, -1))
    assert before[50, 50].argmax() == 1 and before[50, 85].argmax() == 0 and behind[50, 50].argmax() == 0


def test_a_picture_that_cannot_be_written_raises(tmp_path, result):
    with pytest.raises(loopmend.WriteError, match="none"):
        result.render(tmp_path / "none" / "a.png", size=(64, 64))


def test_colors_without_alpha_stay_so(sphere):
    colors = np.round(127 + 100 * sphere[0]).astype(np.uint8)
    filled = loopmend.fill(*sphere, colors=colors)
    assert filled.colors.shape == (len(filled.vertices), 3) and np.array_equal(filled.colors[:len(colors)], colors)
    with_alpha = np.column_stack([colors, np.full(len(colors), 255, np.uint8)])
    assert np.array_equal(loopmend.fill(*sphere, colors=with_alpha).colors[:, :3], filled.colors)


def test_loops_are_named_by_what_boundary_loops_gives(two_holes):
    north, south = loopmend.boundary_loops(*two_holes)
    for chosen in (south, [south], [2], {south: "flat"}):
        filled = loopmend.fill(*two_holes, loops=chosen)
        assert [hole.is_filled for hole in filled.holes] == [False, True]
    again = loopmend.fill(*two_holes, loops=[hole for hole in filled.holes if not hole.is_filled])
    assert [hole.is_filled for hole in again.holes] == [True, False]


def test_options_are_named_as_in_python(two_holes):
    left = loopmend.fill(*two_holes, max_edges=3).holes[0].message
    assert left == "has more than 3 edges (max_edges)"
    with pytest.raises(loopmend.InvalidArgument, match=r"boundary_loops\(\) lists them$"):
        loopmend.fill(*two_holes, loops=[9])
    words = loopmend._words.in_python
    assert words("again with --repair; --trim-boundary 3 or --boundary exact; fill --stitch joins") == \
        'again with repair=True; trim_boundary=3 or boundary="exact"; fill stitch=True joins'
    assert words("it is open: 'loopmend blend --loops 1:2,1:5' joins both") == "it is open: blend([mesh], loops=[(1, 2), (1, 5)]) joins both"
    assert words("in the time that --max-time allows -- and so on") == "in the time that max_time allows -- and so on"


def test_a_table_has_a_row_for_each_loop(two_holes):
    pytest.importorskip("pandas")
    table = loopmend.fill(*two_holes, loops=[2]).to_frame()
    assert list(table["number"]) == [1, 2] and list(table["status"]) == ["skipped", "converged"]
    assert table["grade"][1] == "good" and np.isnan(table["seam_angle_after_deg"][0]) and table["new_faces"][1] > 10


def test_a_bar_shows_progress(two_holes, capfd):
    pytest.importorskip("tqdm")
    loopmend.fill(*two_holes, progress=True)
    assert "2/2" in capfd.readouterr().err
    loopmend.fill(*two_holes, progress=False)
    assert capfd.readouterr() == ("", "")


def test_a_package_that_is_missing_is_named(two_holes, result, monkeypatch):
    for name in ("tqdm", "tqdm.auto", "pyvista", "matplotlib", "matplotlib.pyplot", "pandas"):
        monkeypatch.setitem(sys.modules, name, None)
    for call, words in ((lambda: loopmend.fill(*two_holes, progress=True), r"progress=True needs the package tqdm: pip install tqdm"),
                        (result.plot, r"plot\(\) without PyVista needs the package matplotlib"),
                        (result.to_frame, r"to_frame\(\) needs the package pandas")):
        with pytest.raises(ImportError, match=words):
            call()


def test_pickling_keeps_the_arrays(scan):
    filled = loopmend.fill(scan)
    back = pickle.loads(pickle.dumps(filled))
    assert back.mesh.vertices.tobytes() == filled.vertices.tobytes() and back.carried is None
    assert pickle.loads(pickle.dumps(loopmend.read(scan))).report == loopmend.read(scan).report


def same_as_the_command_line(program, tmp_path, scan, name, **options):
    words = [f"--{key.replace('_', '-')}" for key in options]
    (tmp_path / "one").mkdir()
    (tmp_path / "two").mkdir()
    program("fill", scan, "-o", tmp_path / "one" / name, "--quiet", *words)
    loopmend.write(tmp_path / "two" / name, loopmend.fill(scan, **options))
    files = sorted(path.name for path in (tmp_path / "one").iterdir())
    assert sorted(path.name for path in (tmp_path / "two").iterdir()) == files
    for file in files:
        assert (tmp_path / "one" / file).read_bytes() == (tmp_path / "two" / file).read_bytes(), file
    return tmp_path / "two" / name


def test_attributes_of_a_file_go_through_read_fill_and_write(program, tmp_path, two_holes):
    vertices, faces = two_holes
    rows = "".join(f"{x:.9g} {y:.9g} {z:.9g} {3 + x - y:.9g}\n" for x, y, z in vertices)
    corners = "".join(f"3 {a} {b} {c} {a % 7}\n" for a, b, c in faces)
    (tmp_path / "a.ply").write_text(
        f"ply\nformat ascii 1.0\ncomment from a scanner\nelement vertex {len(vertices)}\nproperty float x\nproperty float y\n"
        f"property float z\nproperty float quality\nelement face {len(faces)}\nproperty list uchar int vertex_indices\n"
        f"property int label\nend_header\n{rows}{corners}")
    written = same_as_the_command_line(program, tmp_path, tmp_path / "a.ply", "a.ply", trim_crossing=True)
    header = written.read_bytes()[:600]
    assert b"property float quality" in header and b"property int label" in header and b"comment from a scanner" in header
    mesh = loopmend.read(written)
    patches = loopmend.fill(tmp_path / "a.ply", patches_only=True)
    patches.save(tmp_path / "patches.ply")
    assert b"property float quality" in (tmp_path / "patches.ply").read_bytes()[:600] and len(mesh.faces) > len(faces)


def test_a_texture_goes_through_read_fill_and_write(program, tmp_path, two_holes):
    vertices, faces = two_holes
    (tmp_path / "a.mtl").write_text("newmtl skin\nKd 1 1 1\nmap_Kd a.png\n")
    loopmend.render(loopmend.sample(), tmp_path / "a.png", size=(64, 64))
    (tmp_path / "a.obj").write_text("mtllib a.mtl\nusemtl skin\n" + "".join(f"v {x:.17g} {y:.17g} {z:.17g}\n" for x, y, z in vertices) +
                                    "".join(f"vt {x / 2 + 0.5:.9g} {y / 2 + 0.5:.9g}\n" for x, y, _ in vertices) +
                                    "".join("f " + " ".join(f"{v + 1}/{v + 1}" for v in face) + "\n" for face in faces))
    written = same_as_the_command_line(program, tmp_path, tmp_path / "a.obj", "b.obj")
    assert {path.name for path in written.parent.iterdir()} == {"a.mtl", "a.png", "b.obj", "b_patch.mtl", "b_patch.png"}


def test_what_a_file_carries_does_not_fit_fewer_vertices(tmp_path, sphere):
    loopmend.write(tmp_path / "a.stl", *sphere)  # whose faces carry two bytes each
    mesh = loopmend.read(tmp_path / "a.stl")
    assert mesh.carried is not None
    with pytest.raises(loopmend.InvalidArgument, match="carried"):
        loopmend.fill(loopmend.Mesh(mesh.vertices, mesh.faces[1:], carried=mesh.carried))
