// SPDX-License-Identifier: GPL-3.0-or-later
// What the engine and the window's own jobs can say, as they say it: whole messages with sample numbers and names, by the
// source that makes them. Left out are errors of the program itself, such as a table of another size than its mesh.
#pragma once

namespace loopmend::test {

inline constexpr const char* engine_messages[] = {
    // filling/loop_patch.cpp
    "a crack: its edges lie exactly on other boundary edges, so that nothing is missing between them; stitching joins "
    "them",
    "a crack: a face at the same place covers it already",
    "no hole: it runs where the surface had to be cut, along an edge with more than two faces or because the surface "
    "is one-sided",
    "all vertices of the loop are in one place",
    "the loop is the boundary of a single triangle",
    "the patch would need about 3 million vertices: a lower density needs fewer",
    "the patch would need about far too many vertices: a lower density needs fewer",
    "the patch would need more than 250000 vertices: a lower density needs fewer",
    "4 edges of this loop have no length; welding their vertices would help",
    "no valid triangulation of this loop was found",
    "the initial patch has 2 folded edges left",
    "the initial patch has 3 self-intersections left",
    "the initial patch has 2 folded edges and 3 self-intersections left",
    "the density must lie between 0.1 and 10, not 12.500000",
    // filling/bridge_loops.cpp, mesh/join_parts.cpp, pipeline/hand_bridge.cpp
    "a blend needs at least two loops, not 1",
    "loop 3 is no hole but a crack: it cannot be joined to others",
    "loop 3 is no hole but a cut: it cannot be joined to others",
    "all vertices of loop 3 are in one place",
    "loop 3 is named twice",
    "loop 3 touches another loop, or itself, at a vertex: it cannot be joined to others",
    "the patch would need about 12 million vertices: a lower density needs fewer",
    "every first surface between these loops folds or cuts itself all over: a lower density may help",
    "no surface that joins these loops was found: they do not face a common middle, nor each other",
    "the bridge has 2 folded edges and 3 self-intersections left",
    "two of the loops bound one piece of surface, but its inside faces the gap at one of them and its outside at the "
    "other: "
    "no two-sided surface joins them",
    "a loop was lost when its surface was turned round",
    "parts 1 and 2 overlap: 17 pairs of their triangles cut each other. Move them apart.",
    "vertex 12 lies on no boundary loop",
    "the boundary edges that begin at vertices 3 and 4 have a vertex in common: a bridge needs two that lie apart",
    // pipeline/fill_holes.cpp, initial_patch.h, solve_group.cpp, paste.cpp
    "its edges are too short for its size: left open; a smaller density needs less memory",
    "about 120000 new vertices would take 900 MB of memory, and 500 MB are allowed: left open; a smaller density needs "
    "less",
    "not enough memory for this hole: left open; a smaller density needs less",
    "the memory for patches must be above 0 MB",
    "the piece lies within hole 2, whose patch covers it: left as it is",
    "an island: joined to hole 2",
    "the piece of surface within it was not joined: no bridge was found",
    "the piece of surface within it was not joined: no surface that joins these loops was found: they do not face a "
    "common "
    "middle, nor each other",
    "not finished when stopped",
    "cancelled",
    "every patch that was found would cut the surface or itself, in 12 places: left open; removing loose crumbs "
    "in its way (--repair), trimming the boundary (--trim-boundary 3) or a strip across the hole (--bridge) may help",
    "1 boundary edge intersects the surface, so that no valid patch exists: left open; remove what "
    "crosses (--trim-crossing)",
    "4 boundary edges intersect the surface, so that no valid patch exists: left open; remove what "
    "crosses (--trim-crossing)",
    "1 edge of its patch would have more than two faces: left open",
    "2 edges of its patch would have more than two faces: left open",
    "its patch would cut that of loop 3: left open; 'loopmend blend --loops 3,5' joins the two by one surface",
    "the surface outside the patches was changed: nothing is handed on",
    // evolution/evolution.cpp and its steps; jobs/steady_run.cpp
    "the scan around the hole has relief: the flow runs on the smooth surface under it; --boundary exact runs the flow "
    "itself",
    "the scan around the hole is noisy: the flow runs on the smooth surface under it; --boundary exact runs the flow "
    "itself",
    "robust fairing in place of the flow: the scan around the hole does not tell shape from relief, so that its "
    "curvature "
    "counts little; --boundary exact runs the flow itself",
    "the flow on the smooth surface under the scan: the scan around the hole is noisy: the flow runs on the smooth "
    "surface "
    "under it; --boundary exact runs the flow itself; stopped after 100 steps, before the steady state",
    "linear fairing in place of the flow: the surface ends at this loop, which is flat, so that it was closed flat; "
    "--boundary exact runs the flow itself",
    "both surfaces end at these loops, so that a straight ring joins them; --boundary exact runs the flow itself",
    "linear fairing in place of the flow: the surface ends at this loop, so that it was closed by a minimal surface; "
    "--boundary exact runs the flow itself",
    "the flow with bending energy mixed in: split flow: 3 edges are folded by more than 150°",
    "no step of the flow came below its fairings, which were kept",
    "stopped early: the noise could not be carried into the patch",
    "stopped early: only vanishing time steps keep the flow stable here",
    "stopped early: the flow has not converged, but only ever smaller steps lower the energy",
    "stopped early: no further step lowers the energy without folding the patch",
    "stopped early: the patch is too degenerate to be faired",
    "the surface around the hole has too few vertices to tell its curvature",
    "the patch has no free vertex to evolve",
    "the patch has a vertex that is not finite",
    "a loop has no extent: all its vertices are in one place",
    "the time step sigma must lie between 1e-6 and 1e8, not 0.000000",
    "the share of bending energy must lie between 0 and 1e6, not -1.000000",
    "the number of steps must be at least 1, not 0",
    // core/notice.cpp, pipeline/attempt.cpp, candidates.cpp, patch_relief.cpp, blend.cpp
    "one boundary vertex is an outlier: the patch meets it, but does not take its curvature from it",
    "5 boundary vertices are outliers: the patch meets them, but does not take its curvature from them",
    "the patch would have folded or cut the surface at a few places: there, at 12 of its 300 vertices, it goes back "
    "towards "
    "what it set out from",
    "the flow could not start: the surface around the hole has too few vertices to tell its curvature",
    "flow: crosses the surface or itself in 3 places: the initial patch was kept",
    "split flow: crosses the surface or itself in 1 place",
    "split flow: 3 edges are folded by more than 150°",
    "robust fairing: 1 edge is folded by more than 150°",
    "tangent fairing: 2 edges have more than two faces",
    "minimal surface: 1 edge has more than two faces",
    "split flow: a crease of 90° along 12 edges of the seam, where the initial patch had 18°",
    "minimal surface over a cut: a dome 0.42 diameters high over a flat loop",
    "flow: a bubble of 3.8 times the area of the initial patch, reaching 1.2 diameters beyond it",
    "flow: a bubble of 3.8 times the area of the initial patch",
    "split flow: mean curvature jumps at the seam by 250 / diameter, before the flow by 3.4",
    "too small to hold a free vertex: closed by triangles between its own vertices",
    "too small for a flow: closed by triangles around one new vertex",
    "the scan around the hole has no relief to continue",
    "the patch has as much relief as the scan without any added, rms 0.0123 (0.0131 around the hole)",
    "with relief the patch would fold or cut the surface: it stays smooth",
    "bent past loose crumbs of surface in the hole; --repair removes such crumbs",
    "relief continued at random, rms 0.0123 (0.0131 around the hole)",
    "the patch of the flow itself had a fault; with bending energy mixed in it has none",
    "the flow itself did not converge; with bending energy mixed in it did",
    "a crease of 40 degrees is left at a seam: the patch turns too sharply there for edges of this length; finer "
    "meshes would "
    "help",
    "every patch that was found would cut the surface or itself, in 3 places: the loops cannot be joined as they lie",
    // jobs/state_making.cpp, initial_patches.cpp, change_surface.cpp, problem_base.cpp, task_runner.cpp
    "It cuts the surface or itself in 3 places; the command line leaves such a hole open. Run a flow, or discard it "
    "and try "
    "another density.",
    "It folds over itself where the initial patch did not; the command line would keep the initial patch. Go back a "
    "few "
    "steps, or take smaller ones.",
    "No valid triangulation of this loop was found.",
    "this would leave no triangle of the surface",
    "loop 3 of bunny.ply is filled already: discard its patch, or choose another loop",
    "std::bad_alloc",
    // pipeline/problem.cpp, evolve_region.cpp, interpolate.cpp, mesh/region.cpp, filling/subdivide_polyhedron.cpp
    "6 vertices of the region lie on the surface's boundary: they stay",
    "12 faces were turned round: their inside faced the gap",
    "the loops were not joined: every first surface between these loops folds or cuts itself all over: a lower density "
    "may "
    "help",
    "no hole could be filled",
    "no hole could be filled: no valid triangulation of this loop was found",
    "the flow would leave 2 folded edges and 0 self-intersections in the region",
    "no valid surface was found: the best one has 2 folded edges and 0 self-intersections",
    "the region names vertex 900, but the vertices are 0 to 800",
    "the region takes in a whole piece of the surface: nothing around it would hold it",
    "the region has no vertex that could move: it is empty, or lies on the surface's boundary",
    "all vertices of the polyhedron lie in one plane: there is no surface to find between them",
    "the number of subdivisions must lie between 1 and 8, not 9",
    "the polyhedron has 3 vertices: too few for a surface, at least 4 are needed",
    "the polyhedron is no simple surface: edges with more than two faces, faces that meet at a vertex alone, or faces "
    "that "
    "are double or without area. Repair it first.",
    "the subdivided polyhedron would have more than 4 million triangles: fewer subdivisions do",
    "the polyhedron has 1 hole, the largest with 8 edges: close it, or let its boundary loops become smooth curves "
    "(--open)",
    "the polyhedron has 2 holes, the largest with 8 edges: close it, or let its boundary loops become smooth curves "
    "(--open)",
    "vertex 9 is to be fixed, but the vertices are 0 to 7",
    "3 fixed vertices are too few for a surface: at least 4 are needed",
    "a closed curve needs at least 3 points, not 2",
    "two neighbouring points of the curve lie in one place",
    // neighborhood/trim_boundary.cpp, repair/stitch_boundaries.cpp, mesh/surface_model.cpp, mesh/flat_view.cpp
    "between 0 and 100 rings of a boundary can be trimmed, not 101",
    "trimming the boundary would leave no triangle",
    "the tolerance of stitching must lie between 0 and 0.4, not 0.500000",
    "the tolerance of stitching must be a length, not -1.000000",
    "face 4 names vertex 12, but there are 9",
    "face 4 cannot be joined to its neighbours",
    "the patch is not an oriented manifold",
    "the patch has an open edge away from its boundary",
    "a boundary edge of the patch is not a boundary edge of the surface",
    "a chord of the patch is an edge of the surface already",
    "no usable face: every face is degenerate",
};

}  // namespace loopmend::test
