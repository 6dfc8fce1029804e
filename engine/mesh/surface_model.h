// SPDX-License-Identifier: GPL-3.0-or-later
// The opened surface: the soup as read, and a manifold, oriented halfedge view of it in which loops can be walked.
#pragma once

#include "mesh/tri_mesh.h"
#include "mesh/triangle_soup.h"
#include "mesh/vertex_survey.h"

#include <Eigen/Geometry>

#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

namespace loopmend {

/// What had to be done to the soup before it could be seen as an oriented manifold. Counts; all 0 for a clean mesh.
struct ModelRepairs {
  std::size_t degenerate_faces = 0;    ///< a vertex twice in one face: kept in the file, left out of the view
  std::size_t duplicate_faces = 0;     ///< same three vertices as an earlier face: likewise
  std::size_t non_manifold_edges = 0;  ///< edges with more than two faces: the view is cut there
  /// Vertices with more than one fan of faces: split in the view, but for those whose fans lie side by side, and those
  /// that one loop would pass several times, as where two holes touch.
  std::size_t non_manifold_vertices = 0;
  std::size_t reoriented_faces = 0;       ///< faces turned round to agree with their neighbours, in view and file
  std::size_t unreferenced_vertices = 0;  ///< points that no face uses: kept in the file
};

struct FlatView;  // mesh/flat_view.h

/// What is known of the surface beyond a view that holds only what lies around its boundary loops.
struct SurfaceBeyond {
  int rings = 0;                 ///< as asked for (AroundLoops)
  std::vector<char> is_cut_off;  ///< #V': whether faces of the vertex may be missing in the view
  std::vector<int> unusable;     ///< soup triangles that are no part of the surface, ascending
  std::vector<int> copy_of;  ///< points of the surface beyond those of the soup, where it was split: their soup points
  std::vector<int> piece_of_point;   ///< #soup points, then #copy_of: number of the piece of surface; −1: on none
  std::vector<int> piece_of_vertex;  ///< #V'
  std::vector<Eigen::AlignedBox3d> boxes;  ///< of the pieces
  std::shared_ptr<const FlatView> flat;    ///< what the view was made of, where that was cut or turned
};

/// `soup` is what is written back: its points and the order of its triangles never change; filling only appends.
/// To move a model copies its mesh, since OpenMesh's meshes have no move.
struct SurfaceModel {
  TriangleSoup soup;
  TriMesh mesh;                  ///< #V' vertices; isolated points are left out
  std::vector<int> soup_vertex;  ///< #V': view vertex → soup point (several may share one where the view was cut)
  std::vector<int> soup_face;    ///< #F': view face → soup triangle
  ModelRepairs repairs;
  std::vector<int> turned_faces{};  ///< soup triangles that were turned round, ascending
  /// Nothing: the view holds the whole surface.
  std::optional<SurfaceBeyond> beyond{};
};

/// Builds the view. Deterministic. @param survey  of this soup, where it was made before; its indices are in range then
/// @throws InvalidArgument if an index is out of range or no usable face is left.
SurfaceModel make_surface_model(TriangleSoup soup, std::optional<VertexSurvey> survey = std::nullopt);
/// The same, made in place.
std::shared_ptr<const SurfaceModel> make_shared_surface_model(TriangleSoup soup,
                                                              std::optional<VertexSurvey> survey = std::nullopt);

/// What a view around the boundary loops holds: all faces at points that are up to `rings` edges from a boundary, or from a
/// point in one of the boxes.
struct AroundLoops {
  int rings = 0;  ///< up to 200
  std::vector<Eigen::AlignedBox3d> boxes{};
};

/// The same for a large scan of which only the loops and what lies around them matter: it takes a fraction of the time and
/// memory. Vertices and faces are in the same order as in the whole view; find_boundary_loops and fill_holes give the same
/// (with the neighborhood that pipeline/filling_view.h asks for). What walks over the whole view needs the whole view.
SurfaceModel make_view_around_loops(TriangleSoup soup, const AroundLoops& around,
                                    std::optional<VertexSurvey> survey = std::nullopt);

/// The same view of another extent. @param model  whose view is around loops
SurfaceModel with_view_around(SurfaceModel model, const AroundLoops& around);

/// The soup before any triangle was turned round.
TriangleSoup as_read(SurfaceModel model);

/// Whether the view ends at the vertex though the surface goes on.
bool is_cut_off(const SurfaceModel& model, int view_vertex);

/// visit(f) for all soup triangles that are part of the surface, whether the view holds them or not; ascending.
template <class Visit>
void for_each_soup_triangle(const SurfaceModel& model, const Visit& visit) {
  if (!model.beyond) {
    for (int f : model.soup_face) visit(f);
    return;
  }
  auto next = model.beyond->unusable.begin();
  for (int f = 0; f < static_cast<int>(model.soup.triangles.size()); ++f)
    if (next != model.beyond->unusable.end() && *next == f)
      ++next;
    else
      visit(f);
}

/// Soup triangles that are no part of the surface; ascending.
std::vector<int> triangles_outside(const SurfaceModel& model);

/// A triangulation that fits into one or more boundary loops of a model, ready to be pasted.
struct PatchGeometry {
  std::vector<int>
      boundary;   ///< view vertices that the patch shares with the model; patch vertex i < #boundary is boundary[i]
  Points points;  ///< the patch's own vertices; patch vertex #boundary + k is points[k]
  Triangles triangles;  ///< over patch vertices, oriented like the neighborhood
};

/// Room for patches of so many points and triangles together: append_patch then takes no more memory for the model.
/// @throws std::bad_alloc; the model is then unchanged.
void reserve_patches(SurfaceModel& model, std::size_t points, std::size_t triangles);

/// Appends the patch to soup and view. New soup points and triangles come last; nothing that was there moves.
/// @throws InvalidArgument if the patch does not fit (a boundary edge of it is none of the surface); the model is then unchanged, as it
///         is on std::bad_alloc where there is room for the patch.
void append_patch(SurfaceModel& model, const PatchGeometry& patch);

}  // namespace loopmend
