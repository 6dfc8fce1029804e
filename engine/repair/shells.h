// SPDX-License-Identifier: GPL-3.0-or-later
// The shells of a surface, its connected parts, and which of them lie in others.
#pragma once

#include "mesh/boundary_loops.h"
#include "mesh/surface_model.h"

#include <Eigen/Geometry>

#include <set>
#include <vector>

namespace loopmend {

struct Shell {
  std::vector<int> faces;  ///< soup triangles, ascending; only after list_faces()
  Points covers;           ///< three corners after another: flat fans over its openings
  Eigen::AlignedBox3d box;
  double area = 0;
  double volume = 0;           ///< with the fans; below 0: the faces look inward
  double openings = 0;         ///< area of the fans
  double uncertainty = 0;      ///< of the volume: what covers as high as half balls would change
  bool has_sides = true;       ///< each edge has two faces, or one, and no vertex is a mark for missing data
  bool is_open = false;        ///< whether some edge has one face
  bool has_opening = false;    ///< the same, and it is no side of a crack
  bool may_be_a_room = false;  ///< that was scanned from within: it does not count as closed
  std::set<int> crosses{};     ///< shells that cross or touch it: it is not looked for in them
  std::vector<int> around;     ///< shells that it lies in; only after find_nesting()

  bool is_certain() const;
  /// But for openings of a twentieth of its area.
  bool is_nearly_closed() const;
};

struct Shells {
  std::vector<Shell> all;
  std::vector<int> of_point;  ///< of each soup point; −1: no part of the surface
};

/// @param loops  all of the model, which may be one that holds only what lies around them
Shells find_shells(const SurfaceModel& model, const std::vector<BoundaryLoop>& loops);
void list_faces(const SurfaceModel& model, Shells& shells);
/// Corners of the faces and of the covers, three after another.
Points corners_of(const SurfaceModel& model, const Shell& shell);
bool some_boxes_meet(const std::vector<Shell>& shells);
void find_nesting(const SurfaceModel& model, std::vector<Shell>& shells);

}  // namespace loopmend
