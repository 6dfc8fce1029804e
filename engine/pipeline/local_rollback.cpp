// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/local_rollback.h"

#include "operators/topology.h"

#include <algorithm>

namespace loopmend {

namespace {

/// Edges from the nearest of the marked vertices; for those farther away `most`.
std::vector<int> edges_from(const std::vector<char>& marked, const Topology& topology, int most) {
  std::vector<int> way(marked.size(), most), front;
  for (std::size_t v = 0; v < marked.size(); ++v)
    if (marked[v]) {
      way[v] = 0;
      front.push_back(static_cast<int>(v));
    }
  for (int k = 1; k < most; ++k) {
    std::vector<int> next;
    for (int v : front)
      for (int w : topology.neighbors(v))
        if (way[w] == most) {
          way[w] = k;
          next.push_back(w);
        }
    front = std::move(next);
  }
  return way;
}

/// 0 at the spoilt place, 1 beyond the rings, without a kink at either end.
double share_at(int way, int rings) {
  const double t = static_cast<double>(way) / (rings + 1);
  return t * t * (3 - 2 * t);
}

}  // namespace

std::optional<LocalRollback> roll_back_locally(const ScanIndex& scan, const Patch& start, const Patch& evolved,
                                               const Validity& limit, const CancelToken& cancel) {
  const int n = evolved.free_count;
  if (n != start.free_count) return std::nullopt;
  const Topology topology(evolved.vertex_count(), evolved.triangles);
  std::vector<char> spoilt(evolved.vertex_count(), 0);
  LocalRollback result{evolved, validate(scan, evolved)};
  while (!no_worse(result.validity, limit)) {
    result.rings = std::max(1, 2 * result.rings);
    for (int f : result.validity.spoiled)
      for (int v : evolved.triangles[f]) spoilt[v] = 1;
    const std::vector<int> way = edges_from(spoilt, topology, result.rings + 1);
    result.moved =
        static_cast<int>(std::count_if(way.begin(), way.begin() + n, [&](int k) { return k <= result.rings; }));
    if (result.moved == n || cancel.cancelled()) return std::nullopt;
    for (int i = 0; i < n; ++i)
      if (way[i] <= result.rings)
        result.patch.positions[i] =
            start.positions[i] + share_at(way[i], result.rings) * (evolved.positions[i] - start.positions[i]);
    result.validity = validate(scan, result.patch);
  }
  return result;
}

}  // namespace loopmend
