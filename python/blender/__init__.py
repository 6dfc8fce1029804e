# SPDX-License-Identifier: GPL-3.0-or-later
"""Loopmend in Blender: fills the holes of the active mesh, all or those of which an edge is selected. Materials, UV maps and smooth
shading run on over the patches. Found in the sidebar of the 3D view, and in the menu Mesh > Clean Up."""
import bpy
import numpy as np
from bpy.props import BoolProperty, EnumProperty, FloatProperty, IntProperty

import loopmend
from loopmend._meshes import Given, Values


def read_all(collection, name, columns, kind):
    values = np.empty(len(collection) * columns, kind)
    collection.foreach_get(name, values)
    return values.reshape(-1, columns) if columns > 1 else values


class Arrays:
    """A mesh of Blender as arrays: its polygons as triangles, with the polygon and the corners that each comes from."""

    def __init__(self, mesh):
        mesh.calc_loop_triangles()
        self.vertices = read_all(mesh.vertices, "co", 3, np.float32)
        self.triangles = read_all(mesh.loop_triangles, "vertices", 3, np.int32)
        polygons = read_all(mesh.loop_triangles, "polygon_index", 1, np.int32)
        corner_vertices = read_all(mesh.loops, "vertex_index", 1, np.int32)
        at_points = {}
        for layer in mesh.uv_layers:  # at a seam of the map a vertex has several places: one of them
            place = np.full((len(self.vertices), 2), np.nan)
            place[corner_vertices] = read_all(layer.uv, "vector", 2, np.float32)
            at_points["uv " + layer.name] = place
        for layer in mesh.color_attributes:
            if layer.domain == "POINT":
                at_points["color " + layer.name] = read_all(layer.data, "color", 4, np.float32)
        at_faces = {"material": read_all(mesh.polygons, "material_index", 1, np.int32)[polygons],
                    "smooth": read_all(mesh.polygons, "use_smooth", 1, bool)[polygons]}
        self.values = Values(at_points, at_faces, len(self.vertices), len(self.triangles))

    def given(self):
        return Given(self.vertices, self.triangles, carried=self.values.carried)


def loops_at_selection(mesh, arrays):
    """Boundary loops with an edge whose two vertices are selected."""
    selected = read_all(mesh.vertices, "select", 1, bool)
    found = []
    for loop in loopmend.boundary_loops(arrays.vertices, arrays.triangles):
        at = selected[loop.vertices]
        if (at & np.roll(at, 1)).any():
            found.append(loop.number)
    return found


def add_patches(mesh, arrays, result):
    """The new vertices and faces behind those of the mesh, which stay as they are."""
    new_vertices, new_faces = result.vertices[result.new_vertices], result.faces[result.new_faces]
    at_points, at_faces = arrays.values.over(result)
    first_vertex, first_corner, first_polygon = len(mesh.vertices), len(mesh.loops), len(mesh.polygons)
    uv = {layer.name: read_all(layer.uv, "vector", 2, np.float32) for layer in mesh.uv_layers}
    mesh.vertices.add(len(new_vertices))
    mesh.loops.add(3 * len(new_faces))
    mesh.polygons.add(len(new_faces))
    set_tail(mesh.vertices, "co", first_vertex, new_vertices.astype(np.float32), 3)
    set_tail(mesh.loops, "vertex_index", first_corner, new_faces.astype(np.int32).ravel(), 1)
    set_tail(mesh.polygons, "loop_start", first_polygon, first_corner + 3 * np.arange(len(new_faces), dtype=np.int32), 1)
    set_tail(mesh.polygons, "material_index", first_polygon, at_faces["material"][result.given_faces:], 1)
    set_tail(mesh.polygons, "use_smooth", first_polygon, at_faces["smooth"][result.given_faces:], 1)
    for layer in mesh.uv_layers:
        corners = at_points["uv " + layer.name][new_faces.ravel()]
        layer.uv.foreach_set("vector", np.vstack([uv[layer.name], corners]).astype(np.float32).ravel())
    for layer in mesh.color_attributes:
        if layer.domain == "POINT":
            layer.data.foreach_set("color", at_points["color " + layer.name].astype(np.float32).ravel())
    chosen = np.arange(len(mesh.polygons)) >= first_polygon
    mesh.polygons.foreach_set("select", chosen)
    at = np.zeros(len(mesh.vertices), bool)
    at[new_faces.ravel()] = True
    mesh.vertices.foreach_set("select", at)
    mesh.update(calc_edges=True)


def set_tail(collection, name, first, values, columns):
    """Keeps what stands before `first`."""
    all_values = read_all(collection, name, columns, values.dtype)
    all_values[first:] = values
    collection.foreach_set(name, all_values.ravel())


class LOOPMEND_OT_fill(bpy.types.Operator):
    """Fill holes with patches whose curvature runs through the seam"""

    bl_idname = "mesh.loopmend_fill"
    bl_label = "Fill Holes (Loopmend)"
    bl_options = {"REGISTER", "UNDO"}

    holes: EnumProperty(name="Holes", default="SELECTED", items=[
        ("SELECTED", "Selected, or All", "Those of which an edge is selected; where none is, all of them"),
        ("ALL", "All", "All holes of the mesh")])
    density: FloatProperty(name="Density", default=1, min=0.1, max=10, description="Vertices along a length, relative to the mesh around")
    boundary: EnumProperty(name="Boundary", default="auto", items=[
        ("auto", "Automatic", "The curvature of the smooth surface under relief and noise"),
        ("exact", "Exact", "The curvature around the hole as it is"), ("robust", "Robust", "Hardly any curvature")])
    continuity: EnumProperty(name="Continuity", default="curvature", items=[
        ("curvature", "Curvature", "Curvature runs through the seam"), ("tangent", "Tangent", "The tangent plane does"),
        ("position", "Position", "The patch only meets the seam")])
    edges: EnumProperty(name="Sharp Edges", default="auto", items=[
        ("auto", "Run On", "Sharp edges run on across the hole where both sides say how"), ("round", "Round", "One smooth patch")])
    relief: EnumProperty(name="Relief", default="smooth", items=[
        ("smooth", "Smooth", "The patch has none"), ("continued", "Continued", "The patch has relief as strong as that around")])
    include_outer_rim: BoolProperty(name="Outer Rims", default=False, description="Fill the outlines of open sheets as well")
    max_edges: IntProperty(name="Most Edges", default=0, min=0, description="Leave holes with more edges; 0: none is left")

    @classmethod
    def poll(cls, context):
        return context.active_object is not None and context.active_object.type == "MESH"

    def draw(self, _context):
        self.layout.use_property_split = True
        for name in ("holes", "density", "boundary", "continuity", "edges", "relief", "include_outer_rim", "max_edges"):
            self.layout.prop(self, name)

    def execute(self, context):
        was_editing = context.active_object.mode == "EDIT"
        if was_editing:
            bpy.ops.object.mode_set(mode="OBJECT")
        try:
            return self.fill(context, context.active_object.data)
        finally:
            if was_editing:
                bpy.ops.object.mode_set(mode="EDIT")

    def fill(self, context, mesh):
        if mesh.shape_keys is not None:
            self.report({"ERROR"}, "The mesh has shape keys: apply or remove them first")
            return {"CANCELLED"}
        window = context.window_manager

        def show(done, total, _number):
            window.progress_update(done / max(total, 1))

        window.progress_begin(0, 1)
        try:
            arrays = Arrays(mesh)
            loops = loops_at_selection(mesh, arrays) if self.holes == "SELECTED" else []
            result = loopmend.fill(arrays.given(), loops=loops or None, density=self.density, boundary=self.boundary,
                                   continuity=self.continuity, edges=self.edges, relief=self.relief,
                                   include_outer_rim=self.include_outer_rim, max_edges=self.max_edges or None, progress=show)
        except loopmend.Error as error:
            self.report({"ERROR"}, str(error))
            return {"CANCELLED"}
        finally:
            window.progress_end()
        if len(result.new_faces):
            add_patches(mesh, arrays, result)
        return self.tell(result)

    def tell(self, result):
        filled = [hole for hole in result.holes if hole.is_filled]
        said = f"{len(filled)} of {len(result.holes)} boundary loops filled, {len(result.new_faces)} new faces"
        remarks = [f"loop {hole.number}: {hole.verdict.sentence}" for hole in filled if hole.verdict.grade != "good"]
        remarks += [f"loop {hole.number}: {hole.message}" for hole in result.holes if hole.status == "failed"]
        self.report({"WARNING" if remarks or not filled else "INFO"}, "; ".join([said, *remarks[:3]]))
        return {"FINISHED"} if filled else {"CANCELLED"}


class LOOPMEND_PT_panel(bpy.types.Panel):
    bl_label = "Loopmend"
    bl_idname = "LOOPMEND_PT_panel"
    bl_space_type = "VIEW_3D"
    bl_region_type = "UI"
    bl_category = "Loopmend"

    def draw(self, _context):
        self.layout.operator(LOOPMEND_OT_fill.bl_idname, text="Fill Holes").holes = "SELECTED"
        self.layout.operator(LOOPMEND_OT_fill.bl_idname, text="Fill All Holes").holes = "ALL"


def menu(self, _context):
    self.layout.operator(LOOPMEND_OT_fill.bl_idname)


def register():
    for one in (LOOPMEND_OT_fill, LOOPMEND_PT_panel):
        bpy.utils.register_class(one)
    bpy.types.VIEW3D_MT_edit_mesh_clean.append(menu)


def unregister():
    bpy.types.VIEW3D_MT_edit_mesh_clean.remove(menu)
    for one in (LOOPMEND_PT_panel, LOOPMEND_OT_fill):
        bpy.utils.unregister_class(one)
