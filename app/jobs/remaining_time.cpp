// SPDX-License-Identifier: GPL-3.0-or-later
#include "jobs/remaining_time.h"

#include <algorithm>
#include <utility>

namespace loopmend {

double work_of(const BoundaryLoop& loop) {
  constexpr double of_any_hole = 100;
  return of_any_hole + static_cast<double>(loop.edges()) * loop.edges();
}

double steps_left(int taken) {
  constexpr double usual = 3, with_checks = 0.5;
  return std::max(1.0, usual - taken) + with_checks;
}

namespace {

/// Seconds on scans of half a million to a million triangles, rounded; few of these are intersecting, or in many bodies.
double work_of(Defect defect) {
  switch (defect) {
    case Defect::coincident_points: return 1;
    case Defect::degenerate_faces: return 0.1;
    case Defect::duplicate_faces: return 1;
    case Defect::intersections: return 6;
    case Defect::non_manifold: return 4;
    case Defect::overlaps: return 6;
    case Defect::handles: return 3;
    case Defect::fragments: return 2;
  }
  return 0;
}

}  // namespace

double share_of_repair(const std::set<Defect>& defects, const RepairStep& step) {
  constexpr double of_measuring = 3, separated = 0.25;
  double all = of_measuring, done = 0;
  std::size_t number = 0;
  for (const Defect defect : defects) {
    const double work = work_of(defect);
    all += work;
    ++number;
    if (step.stage == RepairStage::measure_result || number < step.number) done += work;
    if (number == step.number && step.stage == RepairStage::turn_outward) done += separated * work;
  }
  return done / all;
}

double share_of_preparing(RepairStage stage, double before) {
  // Seconds on scans of 0.9 and 1.1 million triangles, rounded; what a scan does not need is passed over.
  static constexpr std::pair<RepairStage, double> work[] = {
      {RepairStage::survey, 1},          {RepairStage::remove_no_data, 0.5},    {RepairStage::stitch, 0.8},
      {RepairStage::join_vertices, 0.3}, {RepairStage::remove_duplicates, 0.3}, {RepairStage::separate, 0.6},
      {RepairStage::turn_outward, 1.7},  {RepairStage::remove_fragments, 1},    {RepairStage::trim, 0.2},
      {RepairStage::measure_result, 3},
  };
  double all = 0, done = 0;
  for (const auto& [one, seconds] : work) {
    if (one == stage) done = all;
    all += seconds;
  }
  return std::max(before, done / all);
}

std::optional<double> seconds_left(double seconds, double share) {
  constexpr double least_share = 0.05;
  if (seconds < least_seconds_shown || share < least_share || share >= 1) return std::nullopt;
  return seconds * (1 - share) / share;
}

}  // namespace loopmend
