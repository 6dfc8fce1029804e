// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/loop_chords.h"

#include "mesh/by_position.h"

#include <algorithm>

namespace loopmend {

namespace {

/// The vertices of all loops by the numbers of their positions.
class LoopPositions {
 public:
  struct Visit {
    int loop, place;  ///< indices into the loops, and into the loop's vertices
  };

  LoopPositions(const SurfaceModel& model, const std::vector<BoundaryLoop>& loops) {
    Points places;
    std::vector<Visit> visits;
    for (std::size_t l = 0; l < loops.size(); ++l)
      for (std::size_t i = 0; i < loops[l].vertices.size(); ++i) {
        places.push_back(model.mesh.point(TriMesh::VertexHandle(loops[l].vertices[i])));
        visits.push_back({static_cast<int>(l), static_cast<int>(i)});
      }
    const std::vector<int> number = position_numbers(places, places);
    visits_.resize(places.size());
    for (std::size_t k = 0; k < visits.size(); ++k) visits_[number[k]].push_back(visits[k]);
    of_point_ = position_numbers(model.soup.points, places);
  }

  /// Of a soup point; −1 where no loop passes its position.
  int number(int point) const { return of_point_[point]; }
  const std::vector<Visit>& visits(int number) const { return visits_[number]; }
  const std::vector<std::vector<Visit>>& all() const { return visits_; }

 private:
  std::vector<std::vector<Visit>> visits_;
  std::vector<int> of_point_;
};

bool may_be_filled(const BoundaryLoop& loop) { return loop.kind == LoopKind::hole || loop.kind == LoopKind::outer_rim; }

void mark_shared(const LoopPositions& positions, std::vector<BoundaryLoop>& loops) {
  for (const auto& visits : positions.all()) {
    const auto filled = std::count_if(visits.begin(), visits.end(),
                                      [&](const auto& visit) { return may_be_filled(loops[visit.loop]); });
    if (filled < 2) continue;
    for (const auto& [l, place] : visits) {
      loops[l].shared.resize(loops[l].vertices.size(), 0);
      loops[l].shared[place] = 1;
    }
  }
}

void add_joined(const LoopPositions& positions, int a, int b, std::vector<BoundaryLoop>& loops) {
  for (const auto& [loop_a, i] : positions.visits(a))
    for (const auto& [loop_b, k] : positions.visits(b)) {
      if (loop_a != loop_b) continue;
      const auto [low, high] = std::minmax(i, k);
      if (high - low > 1 && high - low != loops[loop_a].edges() - 1) loops[loop_a].joined.emplace_back(low, high);
    }
}

}  // namespace

void find_taken_chords(const SurfaceModel& model, std::vector<BoundaryLoop>& loops) {
  if (loops.empty()) return;
  const LoopPositions positions(model, loops);
  mark_shared(positions, loops);
  for_each_soup_triangle(model, [&](int f) {
    const Triangle& t = model.soup.triangles[f];
    for (int k = 0; k < 3; ++k) {
      const int a = positions.number(t[k]), b = positions.number(t[(k + 1) % 3]);
      if (a >= 0 && b >= 0 && a != b) add_joined(positions, a, b, loops);
    }
  });
  for (BoundaryLoop& loop : loops) {
    std::sort(loop.joined.begin(), loop.joined.end());
    loop.joined.erase(std::unique(loop.joined.begin(), loop.joined.end()), loop.joined.end());
  }
}

}  // namespace loopmend
