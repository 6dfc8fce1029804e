// SPDX-License-Identifier: GPL-3.0-or-later
// How many faces meet at the chords of patches: edges between two triangles of a patch whose ends lie on its boundary.
#pragma once

#include "mesh/surface_model.h"

#include <array>
#include <map>
#include <set>
#include <utility>

namespace loopmend {

/// Edges are distinguished by the positions of their ends, whatever vertices lie there.
class ChordFaces {
 public:
  /// From here on the faces at the chords of this patch are counted.
  /// @param model  that the patch is to be pasted into: the view vertices of its boundary are read
  void add_chords(const SurfaceModel& model, const PatchGeometry& patch);
  /// The ends of all chords, each position once.
  Points ends() const;
  /// Counts a face of the surface.
  void add_face(const Points& points, const Triangle& face);
  /// Counts all faces of the surface.
  void add_faces(const SurfaceModel& model);
  /// Counts the faces of a patch.
  void add_patch(const SurfaceModel& model, const PatchGeometry& patch);
  /// Chords of the patch that would have more than two faces with it, and have two at most without. A chord that has more
  /// already is not new.
  int count_crowded(const SurfaceModel& model, const PatchGeometry& patch) const;

 private:
  using Position = std::array<double, 3>;
  using Chord = std::pair<Position, Position>;  ///< the lower first

  static Position position(const Vec3& p) { return {p.x() + 0.0, p.y() + 0.0, p.z() + 0.0}; }
  static Chord chord(const Vec3& a, const Vec3& b) { return std::minmax(position(a), position(b)); }
  static std::set<Chord> chords_of(const SurfaceModel& model, const PatchGeometry& patch);
  std::map<Chord, int> faces_of(const SurfaceModel& model, const PatchGeometry& patch) const;

  std::map<Chord, int> faces_;  ///< at each chord
};

}  // namespace loopmend
