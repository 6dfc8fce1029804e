// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/append_colored_patch.h"

#include "filling/fairing.h"
#include "operators/operator_set.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace loopmend {

namespace {

/// Three channels of the patch's colours as vectors: those of its boundary first.
Points continued(const SparseMatrix& stiffness, const Points& boundary, std::size_t vertices) {
  const auto count = static_cast<int>(boundary.size());
  Points all = boundary;
  const Vec3 sum = std::accumulate(boundary.begin(), boundary.end(), Vec3(Vec3::Zero()));
  all.resize(vertices, sum / std::max(1, count));
  minimise_quadratic_form(stiffness, all, count, static_cast<int>(vertices));
  return all;
}

unsigned char channel(double value) { return static_cast<unsigned char>(std::lround(std::clamp(value, 0.0, 255.0))); }

std::vector<Color> patch_colors(const SurfaceModel& model, const PatchGeometry& patch) {
  if (model.soup.colors.empty() || patch.points.empty()) return {};
  Points points, rgb, alpha;
  for (int v : patch.boundary) {
    const auto soup_point = static_cast<std::size_t>(model.soup_vertex[v]);
    points.push_back(model.soup.points[soup_point]);
    const Color& color = model.soup.colors[soup_point];
    rgb.emplace_back(color[0], color[1], color[2]);
    alpha.emplace_back(color[3], 0, 0);
  }
  points.insert(points.end(), patch.points.begin(), patch.points.end());
  std::vector<int> faces(patch.triangles.size());
  std::iota(faces.begin(), faces.end(), 0);
  const SparseMatrix stiffness = clamped_cotan_stiffness(points, patch.triangles, faces, robust_clamp);
  rgb = continued(stiffness, rgb, points.size());
  alpha = continued(stiffness, alpha, points.size());
  std::vector<Color> colors;
  for (std::size_t v = patch.boundary.size(); v < points.size(); ++v)
    colors.push_back({channel(rgb[v].x()), channel(rgb[v].y()), channel(rgb[v].z()), channel(alpha[v].x())});
  return colors;
}

}  // namespace

void append_colored_patch(SurfaceModel& model, const PatchGeometry& patch) {
  const std::vector<Color> colors = patch_colors(model, patch);
  append_patch(model, patch);
  std::copy(colors.rbegin(), colors.rend(), model.soup.colors.rbegin());
}

}  // namespace loopmend
