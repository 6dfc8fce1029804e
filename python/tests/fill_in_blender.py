# SPDX-License-Identifier: GPL-3.0-or-later
"""The extension in Blender without a window: fills all holes and the selected one, keeps materials and UV maps, and can be undone.

Usage: fill_in_blender.py EXTENSION.ZIP   (in a Python that has the package bpy)
       fill_in_blender.py FOLDER          (of the add-on's sources, where loopmend is installed already)
"""
import importlib
import os
import sys
import tempfile

os.environ["BLENDER_USER_RESOURCES"] = tempfile.mkdtemp()

import bpy  # noqa: E402
import numpy as np  # noqa: E402


def open_ball():
    """A sphere of quadrangles and triangles with two holes, two materials and a UV map; the lower half has the second material."""
    bpy.data.batch_remove(list(bpy.data.objects))
    bpy.ops.mesh.primitive_uv_sphere_add(segments=32, ring_count=16, radius=2)
    ball = bpy.context.active_object
    mesh = ball.data
    for name in ("upper", "lower"):
        mesh.materials.append(bpy.data.materials.new(name))
    for polygon in mesh.polygons:
        polygon.material_index = int(polygon.center[2] < 0)
        polygon.use_smooth = True
    bpy.ops.object.mode_set(mode="EDIT")
    bpy.ops.mesh.select_all(action="DESELECT")
    bpy.ops.object.mode_set(mode="OBJECT")
    for vertex in mesh.vertices:
        vertex.select = abs(vertex.co[2]) > 1.6
    bpy.ops.object.mode_set(mode="EDIT")
    bpy.ops.mesh.select_mode(type="VERT")
    bpy.ops.mesh.delete(type="VERT")
    bpy.ops.object.mode_set(mode="OBJECT")
    return ball


def open_edges(mesh):
    count = {}
    for polygon in mesh.polygons:
        for key in polygon.edge_keys:
            count[key] = count.get(key, 0) + 1
    return sum(n == 1 for n in count.values())


def state(mesh):
    return ([tuple(v.co) for v in mesh.vertices], [tuple(p.vertices) for p in mesh.polygons], [p.material_index for p in mesh.polygons],
            [tuple(place.vector) for place in mesh.uv_layers[0].uv])


def check_all():
    ball = open_ball()
    given = state(ball.data)
    assert open_edges(ball.data) == 64 and any(len(p) == 4 for p in given[1])
    bpy.ops.ed.undo_push(message="ball")
    assert bpy.ops.mesh.loopmend_fill(holes="ALL") == {"FINISHED"}
    mesh = bpy.context.active_object.data
    filled = state(mesh)
    for before, after in zip(given, filled):
        assert after[:len(before)] == before
    assert open_edges(mesh) == 0 and not mesh.validate(verbose=True)
    new = np.array(filled[0][len(given[0]):])
    assert len(new) > 50 and np.abs(np.linalg.norm(new, axis=1) - 2).max() < 0.01
    for polygon in list(mesh.polygons)[len(given[1]):]:
        assert polygon.use_smooth and polygon.material_index == int(polygon.center[2] < 0) and polygon.select
    uv = np.array(filled[3][len(given[3]):])
    assert np.isfinite(uv).all() and uv.min() >= 0 and uv.max() <= 1 and np.ptp(uv[:, 0]) > 0.2
    bpy.ops.ed.undo_push(message="filled")
    bpy.ops.ed.undo()
    assert state(bpy.context.active_object.data) == given, "undo leads to another mesh"


def check_selected():
    ball = open_ball()
    mesh = ball.data
    for vertex in mesh.vertices:
        vertex.select = vertex.co[2] > 1.3
    bpy.ops.object.mode_set(mode="EDIT")
    assert bpy.ops.mesh.loopmend_fill(density=0.7, continuity="tangent", boundary="exact") == {"FINISHED"}
    assert bpy.context.active_object.mode == "EDIT"
    bpy.ops.object.mode_set(mode="OBJECT")
    assert open_edges(mesh) == 32  # those of the other hole
    assert min(mesh.vertices[v].co[2] for polygon in mesh.polygons if polygon.select for v in polygon.vertices) > 1.3


def check_nothing_to_fill():
    bpy.data.batch_remove(list(bpy.data.objects))
    bpy.ops.mesh.primitive_cube_add()
    assert bpy.ops.mesh.loopmend_fill(holes="ALL") == {"CANCELLED"} and len(bpy.context.active_object.data.polygons) == 6


def main():
    print("Blender", bpy.app.version_string)
    if os.path.isdir(sys.argv[1]):
        sys.path.append(os.path.dirname(os.path.abspath(sys.argv[1])))
        importlib.import_module(os.path.basename(os.path.abspath(sys.argv[1]))).register()
    else:
        bpy.ops.extensions.package_install_files(filepath=os.path.abspath(sys.argv[1]), repo="user_default", enable_on_install=True)
    import loopmend

    print("loopmend", loopmend.__version__, "of", os.path.dirname(loopmend.__file__))
    check_all()
    check_selected()
    check_nothing_to_fill()
    print("filled in Blender")


if __name__ == "__main__":
    main()
