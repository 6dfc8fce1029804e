// SPDX-License-Identifier: GPL-3.0-or-later
#include "jobs/remaining_time.h"

#include <algorithm>

namespace loopmend {

double work_of(const BoundaryLoop& loop) {
  constexpr double of_any_hole = 100;
  return of_any_hole + static_cast<double>(loop.edges()) * loop.edges();
}

double steps_left(int taken) {
  constexpr double usual = 3, with_checks = 0.5;
  return std::max(1.0, usual - taken) + with_checks;
}

std::optional<double> seconds_left(double seconds, double share) {
  constexpr double least_share = 0.05;
  if (seconds < least_seconds_told || share < least_share || share >= 1) return std::nullopt;
  return seconds * (1 - share) / share;
}

}  // namespace loopmend
