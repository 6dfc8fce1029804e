#include "rim/white_noise.h"

#include "filling/fairing.h"
#include "operators/operator_set.h"
#include "rim/cubic_fit.h"

#include <algorithm>
#include <numeric>

namespace loopmend {

namespace {

constexpr int fitted_rings = 5;

/// Moves the fixed vertices to `places` (of vertex free_count + k) and carries the free ones along.
void move_fixed(Patch& patch, const Points& places) {
  Points offset(patch.vertex_count(), Vec3::Zero());
  for (std::size_t k = 0; k < places.size(); ++k)
    offset[patch.free_count + k] = places[k] - patch.positions[patch.free_count + k];
  std::vector<int> own(patch.patch_triangles);
  std::iota(own.begin(), own.end(), 0);
  const SparseMatrix C = clamped_cotan_stiffness(patch.positions, patch.triangles, own, robust_clamp);
  minimise_quadratic_form(C, offset, 0, patch.free_count);
  for (int i = 0; i < patch.free_count; ++i) patch.positions[i] += offset[i];
  std::copy(places.begin(), places.end(), patch.positions.begin() + patch.free_count);
}

}  // namespace

Patch without_noise(const Patch& patch) {
  const Triangles around(patch.triangles.begin() + patch.patch_triangles, patch.triangles.end());
  const Topology topology(patch.vertex_count(), around);
  const Points normals = angle_weighted_normals(patch.positions, around);
  std::vector<char> mark(patch.vertex_count(), 0);
  Points places(patch.positions.begin() + patch.free_count, patch.positions.end());
  for (int i = patch.free_count; i < patch.vertex_count(); ++i) {
    if (normals[i].isZero()) continue;
    const auto fit = fit_cubic(patch.positions, topology, i, normals[i], fitted_rings, Outliers::weighted_down, mark);
    if (fit) places[i - patch.free_count] += fit->coefficients[0] * fit->normal;
  }
  Patch result = patch;
  move_fixed(result, places);
  return result;
}

Patch with_noise_again(const Patch& solved, const Patch& original) {
  Patch result = solved;
  move_fixed(result, Points(original.positions.begin() + original.free_count, original.positions.end()));
  return result;
}

}  // namespace loopmend
