// SPDX-License-Identifier: GPL-3.0-or-later
// A patch that is being remeshed under guard: no operation may fold it, none may touch its boundary.
#pragma once

#include "mesh/tri_mesh.h"

#include <functional>
#include <map>
#include <utility>
#include <vector>

namespace loopmend {

/// Normals of the neighborhood across the boundary: key (a, b) is the boundary edge as it runs in the patch.
using BoundaryNormals = std::map<std::pair<int, int>, Vec3>;

/// An operation is undone, or not done, when it takes the largest angle between normals at the edges it touches beyond 80° and
/// beyond its old value (docs/math/filling.md, "Remeshing and relaxation"). Vertices 0..locked−1 are the boundary: they never
/// move, and no edge between two of them is made.
class ConstrainedRemesher {
 public:
  /// Target edge length at a place.
  using TargetSize = std::function<double(const Vec3&)>;

  ConstrainedRemesher(const Points& points, const Triangles& triangles, int locked,
                      const BoundaryNormals& boundary_normals, TargetSize target_size);

  /// Is asked with the number of vertices before each operation, and while edges are split; may throw to end it, after
  /// which the mesh is of no use.
  using Watch = std::function<void(std::size_t vertices)>;
  void set_watch(Watch watch) { watch_ = std::move(watch); }

  void scale_sizes(double factor);
  /// Numbers vertices and triangles again, so that those near each other in space are near each other in memory: after many
  /// splits everything else takes twice the time. Locked vertices keep their numbers.
  void sort_in_space();
  /// Splits edges above 4/3 of the target (chords between boundary vertices above 1/2); the midpoints stay on the edges.
  /// @returns how many.
  int split_long_edges();
  int collapse_short_edges();  ///< below 3/4 of the target. @returns how many.
  void flip_to_delaunay();     ///< where the two angles opposite an edge sum to more than π
  void smooth_tangentially();  ///< towards the area-weighted centroid of the one-ring, within the tangent plane
  /// Moves free vertices towards `goal` (in the numbering of points()) as far as the guard allows: all the way, half, a
  /// quarter.
  /// @returns the longest way still wanted at the start, in target lengths.
  double move_towards(const Points& goal);
  /// Flips and local uniform relaxation around bad edges, kept only where their number falls.
  void untangle();

  /// Free vertices follow the locked ones; numbers may have changed since the last call.
  Points points() const;
  Triangles triangles() const;
  int locked() const { return locked_; }
  int free_count() const;  ///< vertices that may move

 private:
  using VH = TriMesh::VertexHandle;
  using EH = TriMesh::EdgeHandle;
  using HH = TriMesh::HalfedgeHandle;
  using FH = TriMesh::FaceHandle;

  void set_boundary_normals(const BoundaryNormals& boundary_normals);
  bool is_locked(VH v) const { return v.idx() < locked_; }
  double target(EH e) const;
  bool is_close_to_long_boundary(EH e, const Vec3& middle) const;
  double length(EH e) const;
  const Vec3& face_normal(FH f) const { return normal_[f.idx()]; }
  void update_normal(FH f);
  void update_normals_around(VH v);
  Vec3 normal_across(HH h) const;
  double edge_cosine(EH e) const;
  double fan_worst(VH v) const;
  double fan_worst(VH v, const Vec3& position);
  double pair_worst(HH h, const Vec3* place) const;
  HH beyond_collapsed(HH side, HH h) const;
  bool guarded_move(VH v, const Vec3& position);
  bool flip_guarded(EH e);
  bool collapse_guarded(HH h);
  bool opposite_angles_exceed_pi(EH e) const;
  void relax_around(const std::vector<EH>& edges, int rings);
  std::vector<EH> edges_beyond(double cosine) const;

  void ask_watch() const {
    if (watch_) watch_(mesh_.n_vertices());
  }

  TriMesh mesh_;
  int locked_;
  Watch watch_;
  std::vector<Vec3> boundary_normal_;  ///< by edge; zero where the edge is not on the boundary or nothing lies across
  TargetSize target_size_;
  double coarser_ = 1;        ///< factor on all target sizes
  std::vector<double> size_;  ///< by vertex: target_size_ where it was made, times coarser_
  std::vector<Vec3> normal_;  ///< by face, unit or zero; kept up to date with every change
  std::vector<Vec3> fan_;     ///< scratch: of the faces around a vertex, were it where it was last asked for
};

}  // namespace loopmend
