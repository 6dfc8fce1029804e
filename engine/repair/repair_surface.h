// SPDX-License-Identifier: GPL-3.0-or-later
// From a soup of triangles to an oriented manifold, at the price of some vertices that become two.
#pragma once

#include "core/cancel.h"
#include "mesh/surface_model.h"
#include "repair/unite_bodies.h"

#include <cstddef>
#include <functional>
#include <set>

namespace loopmend {

enum class Defect {
  coincident_points,  ///< several at exactly the same place: joined
  degenerate_faces,   ///< with a vertex twice: removed
  duplicate_faces,    ///< over the vertices of an earlier one: removed; the earlier one too where they cancel out
  /// Faces that cut another: removed, which leaves holes to be filled. Bodies that are closed but for holes of a twentieth of
  /// their area stay whole where they overlap each other, and where something open crosses them.
  intersections,
  /// Edges of more than two faces, fans that meet at a vertex: separated. Faces are turned to agree, and those of bodies
  /// that are closed but for small holes to look outward (inverted_shells.h). A face that two bodies have in common, which is left
  /// as a closed piece without volume, is removed, and counted among duplicate faces.
  non_manifold,
  overlaps,   ///< closed bodies that overlap: united (unite_bodies.h)
  handles,    ///< of a few edges: cut open, which leaves two holes each to be filled
  fragments,  ///< tiny components, and small ones that hang at an edge of others: removed
};

/// What makes a manifold without removing anything that a person would miss.
inline const std::set<Defect> harmless_repairs{Defect::degenerate_faces, Defect::duplicate_faces, Defect::non_manifold,
                                               Defect::fragments};

/// What was done. All 0 for a sound mesh.
struct RepairCounts {
  std::size_t joined_points = 0;
  std::size_t degenerate_faces = 0;    ///< removed
  std::size_t duplicate_faces = 0;     ///< removed
  std::size_t intersecting_faces = 0;  ///< removed
  std::size_t overlapping_bodies = 0;  ///< that cross others: left where faces are cut, not united
  std::size_t separated_edges = 0;     ///< had more than two faces; each now has two or one
  /// Fans that lie side by side, as where two holes touch, keep their vertex in common.
  std::size_t separated_vertices = 0;  ///< became several at one place: ends of such edges, and where sheets touch
  std::size_t turned_faces = 0;        ///< to agree with their neighbors, and those of the shells
  std::size_t turned_shells = 0;       ///< bodies and cavities that were inside out
  UnionCounts united;
  std::size_t cut_handles = 0;     ///< tiny
  std::size_t handle_faces = 0;    ///< removed to cut them
  std::size_t removed_pieces = 0;  ///< of surface, tiny
  std::size_t removed_faces = 0;   ///< of these pieces

  bool any() const {
    return joined_points + degenerate_faces + duplicate_faces + intersecting_faces + separated_edges +
               separated_vertices + turned_faces + united.bodies + cut_handles + removed_pieces >
           0;
  }
};

struct RepairedSurface {
  /// The points given, in their order and bit by bit, then the copies of those that were separated, then those that uniting
  /// bodies made.
  TriangleSoup soup;
  RepairCounts counts;
};

/// The step at work while a scan is repaired or prepared.
enum class RepairStage {
  survey,          ///< of what the scan needs
  remove_no_data,  ///< faces of missing data
  stitch,
  join_vertices,
  remove_degenerate,
  remove_duplicates,
  cut_intersections,
  separate,
  turn_outward,
  unite,
  cut_handles,
  remove_fragments,
  trim,            ///< triangles at boundaries that run through the surface
  measure_result,  ///< boundary loops and curvature of what was made: by the caller
};

/// The stage that begins.
struct RepairStep {
  RepairStage stage = RepairStage::survey;
  std::size_t number = 0, of = 0;  ///< of the defects that are repaired, from 1; 0: not known
  RepairCounts so_far{};           ///< by the stages before
};
/// Called on the thread that repairs.
using OnRepairStep = std::function<void(const RepairStep&)>;

/// Repairs the defects named, in the order of the enumeration. Faces keep their order. No point moves. Points that no face
/// needs any more stay. `non_manifold` takes degenerate and duplicate faces along, and `overlaps` takes `non_manifold` along.
/// @throws InvalidArgument if no usable face is left.
RepairedSurface repair_surface(const TriangleSoup& soup, const std::set<Defect>& defects = harmless_repairs,
                               const CancelToken& cancel = {}, const OnRepairStep& on_step = {});

/// Whether the surface has tiny loose components with a boundary, as Defect::fragments removes. Closed ones do no harm.
bool has_open_fragments(const SurfaceModel& model);

/// What repair_surface() would do about each defect if it were the only one to be repaired; it unites bodies for that.
/// Cancelled, nothing of use.
RepairCounts count_defects(const TriangleSoup& soup, const CancelToken& cancel = {});

}  // namespace loopmend
