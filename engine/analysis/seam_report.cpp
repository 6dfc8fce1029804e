// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/seam_report.h"

#include "analysis/seam_sides.h"
#include "core/error.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace loopmend {

namespace {

double diameter(const Points& points, const std::vector<int>& vertices) {
  double diameter2 = 0;
  for (int v : vertices)
    for (int w : vertices) diameter2 = std::max(diameter2, (points[v] - points[w]).squaredNorm());
  return std::sqrt(diameter2);
}

SeamReport report_of(const Patch& patch, SeamSides& sides, const std::vector<int>& loop) {
  SeamReport report;
  double angle2 = 0, jump2 = 0;
  int count = 0;
  for (int v : loop) {
    if (!sides.fit(v, one_sided_fit())) continue;
    const double angle =
        std::atan2(sides.in.normal.cross(sides.out.normal).norm(), sides.in.normal.dot(sides.out.normal)) * 180 /
        std::numbers::pi;
    const double jump = std::abs(sides.in.H - sides.out.H) / patch.scale;
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
  report.h_jump_rms_times_diameter = report.h_jump_rms * diameter(patch.positions, loop) * patch.scale;
  return report;
}

}  // namespace

std::vector<SeamReport> seam_reports(const Patch& patch) {
  SeamSides sides(patch);
  std::vector<SeamReport> reports;
  for (const auto& loop : patch.loops) reports.push_back(report_of(patch, sides, loop));
  return reports;
}

SeamReport seam_report(const Patch& patch, int loop) {
  if (loop < 0 || loop >= static_cast<int>(patch.loops.size()))
    throw InvalidArgument(say("the patch has no loop %1", loop));
  SeamSides sides(patch);
  return report_of(patch, sides, patch.loops[loop]);
}

}  // namespace loopmend
