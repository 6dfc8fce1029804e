# SPDX-License-Identifier: GPL-3.0-or-later
"""fill() of the meshes of other packages: the same type comes back, with the arrays of its vertices and faces continued."""
import sys

import numpy as np
import pytest

import loopmend
from conftest import icosphere, without


def height(vertices):
    return 3 + vertices[:, 0] - 2 * vertices[:, 1] + vertices[:, 2]


def colors_of(vertices):
    return np.round(127 + 100 * vertices).astype(np.uint8)


@pytest.fixture(scope="module")
def cut():
    """A sphere of radius 2 with one hole that no axis runs through, and a label for each face."""
    vertices, faces = without(*icosphere(3), lambda v: v @ [0.48, 0.6, 0.64] > np.cos(np.radians(20)))
    return 2 * vertices, faces, (vertices[faces].mean(axis=1)[:, 2] > 0).astype(np.int64) + 5


def check_filled(result, cut):
    assert len(result.holes) == 1 and result.holes[0].status == "converged"
    assert np.abs(np.linalg.norm(result.vertices, axis=1) - 2).max() < 1e-4
    assert len(result.new_vertices) > 10 and result.given_vertices == len(cut[0])


def check_numbers(values, cut, result):
    """Those given are the same, the others lie within those around the hole, near what a linear function has there."""
    given, new = values[:len(cut[0])], values[len(cut[0]):]
    assert np.array_equal(given, height(cut[0]).astype(values.dtype))
    around = height(cut[0][loopmend.boundary_loops(*cut[:2])[0].vertices])
    assert around.min() - 1e-6 <= new.min() and new.max() <= around.max() + 1e-6
    assert np.abs(new - height(result.vertices[len(cut[0]):])).max() < 0.5 and np.ptp(new) > 0.5 * np.ptp(around)


def check_labels(labels, cut, result):
    assert np.array_equal(labels[:len(cut[1])], cut[2]) and len(labels) == len(result.faces)
    new = result.vertices[result.faces[result.new_faces]].mean(axis=1)[:, 2]
    assert new.min() > 0 and set(labels[result.given_faces:]) == {6}


def test_trimesh(cut, tmp_path):
    trimesh = pytest.importorskip("trimesh")
    mesh = trimesh.Trimesh(cut[0], cut[1], process=False, vertex_colors=colors_of(cut[0] / 2), metadata={"name": "ball"},
                           vertex_attributes={"height": height(cut[0])}, face_attributes={"label": cut[2]})
    result = loopmend.fill(mesh)
    check_filled(result, cut)
    filled = result.mesh
    assert type(filled) is trimesh.Trimesh and filled.is_watertight and filled is result.mesh
    assert np.array_equal(filled.vertices[:len(cut[0])], cut[0]) and filled.metadata["name"] == "ball"
    check_numbers(filled.vertex_attributes["height"], cut, result)
    check_labels(filled.face_attributes["label"], cut, result)
    assert np.array_equal(filled.visual.vertex_colors[:len(cut[0]), :3], colors_of(cut[0] / 2))
    off = filled.visual.vertex_colors[len(cut[0]):, :3].astype(int) - colors_of(result.vertices[len(cut[0]):] / 2)
    assert np.abs(off).max() < 25
    assert result.to_trimesh().face_attributes["hole"].max() == 1
    result.save(tmp_path / "colors.ply")
    saved = loopmend.read(tmp_path / "colors.ply").colors
    assert np.array_equal(saved[:, :3], filled.visual.vertex_colors[:, :3])


def test_a_texture_of_trimesh_stays(cut):
    trimesh = pytest.importorskip("trimesh")
    mesh = trimesh.Trimesh(cut[0], cut[1], process=False)
    material = trimesh.visual.material.SimpleMaterial()
    mesh.visual = trimesh.visual.TextureVisuals(uv=cut[0][:, :2] / 4 + 0.5, material=material)
    filled = loopmend.fill(mesh).mesh
    assert filled.visual.kind == "texture" and filled.visual.material is material
    assert np.array_equal(filled.visual.uv[:len(cut[0])], mesh.visual.uv) and np.isfinite(filled.visual.uv).all()


def test_a_scene_of_one_mesh_comes_back_as_a_scene(cut):
    trimesh = pytest.importorskip("trimesh")
    scene = trimesh.Scene()
    scene.add_geometry(trimesh.Trimesh(cut[0], cut[1], process=False), geom_name="ball", transform=np.diag([2.0, 2, 2, 1]))
    filled = loopmend.fill(scene).mesh
    assert type(filled) is trimesh.Scene and filled.geometry["ball"].is_watertight
    assert filled.to_mesh().volume == pytest.approx(8 * filled.geometry["ball"].volume) and not scene.geometry["ball"].is_watertight
    with pytest.raises(TypeError, match="holds 2 meshes: hand over scene.to_mesh"):
        loopmend.fill(trimesh.Scene([trimesh.Trimesh(cut[0], cut[1]), trimesh.creation.box()]))


def polydata(pyvista, cut):
    faces = np.column_stack([np.full(len(cut[1]), 3), cut[1]])
    mesh = pyvista.PolyData(cut[0].astype(np.float32), faces.ravel())
    mesh.point_data["height"] = height(cut[0])
    mesh.cell_data["label"] = cut[2]
    mesh.field_data["unit"] = ["mm"]
    mesh.set_active_scalars("label", preference="cell")
    return mesh


def test_pyvista(cut):
    pyvista = pytest.importorskip("pyvista")
    result = loopmend.fill(polydata(pyvista, cut))
    check_filled(result, cut)
    filled = result.mesh
    assert type(filled) is pyvista.PolyData and filled.n_open_edges == 0 and filled.active_scalars_name == "label"
    assert filled.field_data["unit"][0] == "mm"
    check_numbers(filled.point_data["height"], cut, result)
    check_labels(filled.cell_data["label"], cut, result)
    shown = result.to_pyvista()
    assert set(shown.cell_data["hole"]) == {0, 1} and shown.point_data["expected_deviation"][len(cut[0]):].max() > 0


def test_lines_polygons_and_roles_of_pyvista(cut):
    """Cells of lines come before those of faces; what is active stays so."""
    pyvista = pytest.importorskip("pyvista")
    faces = np.column_stack([np.full(len(cut[1]), 3), cut[1]]).ravel()
    mesh = pyvista.PolyData(cut[0], faces, lines=np.array([2, 0, 1]))
    mesh.cell_data["number"] = np.arange(mesh.n_cells, dtype=np.int16)
    mesh.point_data["normal"] = (cut[0] / 2).astype(np.float32)
    mesh.point_data.active_normals_name = "normal"
    filled = loopmend.fill(mesh).mesh
    assert np.array_equal(filled.cell_data["number"][:len(cut[1])], np.arange(1, mesh.n_cells))
    assert filled.cell_data["number"].dtype == np.int16 and filled.point_data["normal"].dtype == np.float32
    assert filled.point_data.active_normals_name == "normal" and np.abs(filled.point_data["normal"] - filled.points / 2).max() < 0.2
    box = np.array([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0], [0, 0, 1], [1, 0, 1], [1, 1, 1], [0, 1, 1]], float)
    sides = pyvista.PolyData(box, [4, 0, 3, 2, 1, 4, 0, 1, 5, 4, 4, 1, 2, 6, 5, 4, 2, 3, 7, 6, 4, 3, 0, 4, 7], lines=np.array([2, 0, 6]))
    sides.cell_data["side"] = np.arange(6)
    closed = loopmend.fill(sides).mesh
    assert closed.n_open_edges == 0 and list(closed.cell_data["side"][:10]) == [1, 1, 2, 2, 3, 3, 4, 4, 5, 5]


def test_polydata_of_vtk_itself(cut):
    pyvista = pytest.importorskip("pyvista")
    from vtkmodules.vtkCommonDataModel import vtkPolyData

    mesh = vtkPolyData()
    mesh.ShallowCopy(polydata(pyvista, cut))
    result = loopmend.fill(mesh)
    check_filled(result, cut)
    assert isinstance(result.mesh, vtkPolyData)
    filled = pyvista.wrap(result.mesh)
    assert filled.n_open_edges == 0 and result.mesh.GetCellData().GetScalars().GetName() == "label" and filled.field_data["unit"][0] == "mm"
    check_numbers(filled.point_data["height"], cut, result)
    check_labels(filled.cell_data["label"], cut, result)


def test_pyvista_by_its_accessor(cut):
    pyvista = pytest.importorskip("pyvista")
    if not hasattr(pyvista, "register_dataset_accessor"):
        pytest.skip("this PyVista has no accessors")
    import loopmend.pyvista_accessor

    mesh = polydata(pyvista, cut)
    assert mesh.loopmend.fill(density=1.5).mesh.n_open_edges == 0
    assert len(mesh.loopmend.boundary_loops()) == 1 and mesh.loopmend.check().open_boundaries == 1


def test_grids_of_pyvista_are_refused_with_the_cure(cut):
    pyvista = pytest.importorskip("pyvista")
    with pytest.raises(TypeError, match="extract_surface"):
        loopmend.fill(polydata(pyvista, cut).cast_to_unstructured_grid())


def test_meshio(cut):
    meshio = pytest.importorskip("meshio")
    mesh = meshio.Mesh(cut[0], [("line", [[0, 1]]), ("triangle", cut[1])], point_data={"height": height(cut[0])},
                       cell_data={"label": [np.array([9]), cut[2]]})
    result = loopmend.fill(mesh)
    check_filled(result, cut)
    assert type(result.mesh) is meshio.Mesh and list(result.mesh.cells_dict) == ["triangle"]
    check_numbers(result.mesh.point_data["height"], cut, result)
    check_labels(result.mesh.cell_data["label"][0], cut, result)
    with pytest.raises(loopmend.InvalidArgument, match="tetra"):
        loopmend.fill(meshio.Mesh(cut[0], [("tetra", [[0, 1, 2, 3]])]))


def test_quadrangles_of_meshio_become_triangles():
    meshio = pytest.importorskip("meshio")
    corners = np.array([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0], [0, 0, 1], [1, 0, 1], [1, 1, 1], [0, 1, 1]], float)
    open_box = [[0, 3, 2, 1], [0, 1, 5, 4], [1, 2, 6, 5], [2, 3, 7, 6], [3, 0, 4, 7]]
    result = loopmend.fill(meshio.Mesh(corners, [("quad", open_box)], cell_data={"side": [np.arange(5)]}))
    polygons = loopmend.fill(meshio.Mesh(corners, [("polygon", np.array(open_box[:1])), ("quad", open_box[1:])]))
    assert np.array_equal(polygons.faces[:2], [[0, 3, 2], [0, 2, 1]]) and loopmend.check(polygons).open_edges == 0
    assert list(result.mesh.cell_data["side"][0][:10]) == [0, 1, 2, 3, 4] * 2 and loopmend.check(result).open_edges == 0


def test_open3d(cut):
    try:
        import open3d
    except ImportError as error:  # also where a library of the system is missing
        pytest.skip(f"the package open3d cannot be used: {error}")
    mesh = open3d.geometry.TriangleMesh(open3d.utility.Vector3dVector(cut[0]), open3d.utility.Vector3iVector(cut[1]))
    mesh.vertex_colors = open3d.utility.Vector3dVector(cut[0] / 4 + 0.5)
    mesh.compute_vertex_normals()
    result = loopmend.fill(mesh)
    check_filled(result, cut)
    filled = result.mesh
    assert type(filled) is open3d.geometry.TriangleMesh and filled.is_watertight()
    colors, normals = np.asarray(filled.vertex_colors), np.asarray(filled.vertex_normals)
    assert np.array_equal(colors[:len(cut[0])], np.asarray(mesh.vertex_colors)) and np.abs(colors - result.vertices / 4 - 0.5).max() < 0.1
    assert np.abs(normals - result.vertices / 2).max() < 0.2
    tensors = open3d.t.geometry.TriangleMesh.from_legacy(mesh)
    assert type(loopmend.fill(tensors).mesh) is type(tensors)


def test_no_package_is_imported_that_nobody_uses():
    import subprocess

    code = "import loopmend, sys; loopmend.fill(loopmend.sample(), loops=[6]); print(*sys.modules)"
    loaded = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True).stdout.split()
    assert not {"trimesh", "pyvista", "meshio", "open3d", "pandas", "tqdm", "matplotlib"} & set(loaded)


def test_points_without_faces_raise_with_the_cure(cut):
    nothing = np.zeros((0, 3), int)
    for call in (loopmend.fill, loopmend.boundary_loops, loopmend.check, loopmend.curvatures):
        with pytest.raises(loopmend.InvalidArgument, match="no faces, and so no holes"):
            call(cut[0], nothing)
        with pytest.raises(loopmend.InvalidArgument, match="empty"):
            call(np.zeros((0, 3)), nothing)


@pytest.mark.parametrize("dtype", ["float16", "float32", ">f4", "longdouble", "int16"])
def test_arrays_of_any_kind_and_order(cut, dtype):
    rough = (1000 * cut[0] if dtype == "int16" else cut[0]).astype(dtype)
    plain = loopmend.fill(rough.astype(np.float64), cut[1])
    for vertices, faces in ((np.asfortranarray(rough), cut[1].astype(np.uint64)), (np.repeat(rough, 2, 0)[::2], np.asfortranarray(cut[1]))):
        assert loopmend.fill(vertices, faces).vertices.tobytes() == plain.vertices.tobytes()


def test_what_is_no_mesh_raises():
    for wrong in (None, 3, {"vertices": []}, np.eye(3)):
        with pytest.raises(TypeError, match="a mesh is needed"):
            loopmend.fill(wrong)
