// SPDX-License-Identifier: GPL-3.0-or-later
#include "filling/patch_size.h"

#include <limits>

namespace loopmend {

double expected_new_vertices(const SurfaceModel& model, const BoundaryLoop& loop, double density) {
  const TriMesh& mesh = model.mesh;
  double sum = 0;
  int places = 0;
  for (const int v : loop.vertices) {
    const TriMesh::VertexHandle center(v);
    double lengths = 0;
    int edges = 0;
    for (const auto w : mesh.vv_range(center)) {
      lengths += (mesh.point(w) - mesh.point(center)).norm();
      ++edges;
    }
    if (edges == 0) continue;
    sum += lengths / edges;
    ++places;
  }
  const double edge = places > 0 ? sum / places / density : 0;
  return edge > 0 ? loop.area / (0.866 * edge * edge) : std::numeric_limits<double>::infinity();
}

double expected_memory_mb(double expected_vertices) { return 0.010 * expected_vertices; }

double memory_mb_of(int free_vertices) { return 0.020 * free_vertices; }

}  // namespace loopmend
