#include "analysis/seam_report.h"

#include "analysis/one_sided_fit.h"
#include "core/error.h"
#include "operators/local_fit.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace loopmend {

SeamReport seam_report(const Patch& patch, int loop) {
  if (loop < 0 || loop >= static_cast<int>(patch.loops.size()))
    throw InvalidArgument("the patch has no loop " + std::to_string(loop));
  const auto middle = patch.triangles.begin() + patch.patch_triangles;
  const Topology inside(patch.vertex_count(), Triangles(patch.triangles.begin(), middle));
  const Topology outside(patch.vertex_count(), Triangles(middle, patch.triangles.end()));
  const Points normals = angle_weighted_normals(patch.positions, patch.triangles);
  std::vector<char> mark(patch.vertex_count(), 0);

  SeamReport report;
  double angle2 = 0, jump2 = 0, diameter2 = 0;
  int count = 0;
  for (int v : patch.loops[loop]) {
    for (int w : patch.loops[loop])
      diameter2 = std::max(diameter2, (patch.positions[v] - patch.positions[w]).squaredNorm());
    const auto in = one_sided_fit(patch.positions, inside, v, normals[v], mark);
    const auto out = one_sided_fit(patch.positions, outside, v, normals[v], mark);
    if (!in || !out) continue;
    const double angle =
        std::atan2(in->normal.cross(out->normal).norm(), in->normal.dot(out->normal)) * 180 / std::numbers::pi;
    const double jump = std::abs(in->H - out->H) / patch.scale;
    angle2 += angle * angle;
    jump2 += jump * jump;
    report.g1_max_deg = std::max(report.g1_max_deg, angle);
    report.h_jump_max = std::max(report.h_jump_max, jump);
    ++count;
  }
  if (count == 0) {
    constexpr double nan = std::numeric_limits<double>::quiet_NaN();
    report.g1_rms_deg = report.g1_max_deg = report.h_jump_rms = report.h_jump_max = nan;
  } else {
    report.g1_rms_deg = std::sqrt(angle2 / count);
    report.h_jump_rms = std::sqrt(jump2 / count);
  }
  report.h_jump_rms_times_diameter = report.h_jump_rms * std::sqrt(diameter2) * patch.scale;
  return report;
}

}  // namespace loopmend
