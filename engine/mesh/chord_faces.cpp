// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/chord_faces.h"

#include "mesh/by_position.h"
#include "mesh/directed_edges.h"

namespace loopmend {

namespace {

Vec3 boundary_point(const SurfaceModel& model, const PatchGeometry& patch, int v) {
  return model.mesh.point(TriMesh::VertexHandle(patch.boundary[v]));
}

/// visit(a, b) for each side of each triangle that joins two boundary vertices.
template <class Visit>
void for_each_side(const PatchGeometry& patch, const Visit& visit) {
  const int boundary = static_cast<int>(patch.boundary.size());
  for (const Triangle& t : patch.triangles)
    for (int k = 0; k < 3; ++k)
      if (const int a = t[k], b = t[(k + 1) % 3]; a < boundary && b < boundary) visit(a, b);
}

}  // namespace

std::set<ChordFaces::Chord> ChordFaces::chords_of(const SurfaceModel& model, const PatchGeometry& patch) {
  const DirectedEdges edges(patch.triangles, static_cast<int>(patch.triangles.size()));
  std::set<Chord> chords;
  for_each_side(patch, [&](int a, int b) {
    if (a < b && edges.contains({b, a}))
      chords.insert(chord(boundary_point(model, patch, a), boundary_point(model, patch, b)));
  });
  return chords;
}

/// Of the patch at the chords that are counted.
std::map<ChordFaces::Chord, int> ChordFaces::faces_of(const SurfaceModel& model, const PatchGeometry& patch) const {
  std::map<Chord, int> faces;
  for_each_side(patch, [&](int a, int b) {
    const Chord at = chord(boundary_point(model, patch, a), boundary_point(model, patch, b));
    if (faces_.contains(at)) ++faces[at];
  });
  return faces;
}

void ChordFaces::add_chords(const SurfaceModel& model, const PatchGeometry& patch) {
  for (const Chord& at : chords_of(model, patch)) faces_.emplace(at, 0);
}

Points ChordFaces::ends() const {
  std::set<Position> positions;
  for (const auto& [at, faces] : faces_) {
    positions.insert(at.first);
    positions.insert(at.second);
  }
  Points points;
  for (const Position& p : positions) points.emplace_back(p[0], p[1], p[2]);
  return points;
}

void ChordFaces::add_face(const Points& points, const Triangle& face) {
  for (int k = 0; k < 3; ++k)
    if (const auto found = faces_.find(chord(points[face[k]], points[face[(k + 1) % 3]])); found != faces_.end())
      ++found->second;
}

void ChordFaces::add_faces(const SurfaceModel& model) {
  if (faces_.empty()) return;
  const std::vector<int> end = position_numbers(model.soup.points, ends());
  for_each_soup_triangle(model, [&](int f) {
    const Triangle& t = model.soup.triangles[f];
    if ((end[t[0]] >= 0) + (end[t[1]] >= 0) + (end[t[2]] >= 0) > 1) add_face(model.soup.points, t);
  });
}

void ChordFaces::add_patch(const SurfaceModel& model, const PatchGeometry& patch) {
  for_each_side(patch, [&](int a, int b) {  // takes no memory
    const auto found = faces_.find(chord(boundary_point(model, patch, a), boundary_point(model, patch, b)));
    if (found != faces_.end()) ++found->second;
  });
}

int ChordFaces::count_crowded(const SurfaceModel& model, const PatchGeometry& patch) const {
  const std::map<Chord, int> own = faces_of(model, patch);
  int crowded = 0;
  for (const Chord& at : chords_of(model, patch)) {
    const int others = faces_.at(at);
    crowded += others <= 2 && others + own.at(at) > 2;
  }
  return crowded;
}

}  // namespace loopmend
