// SPDX-License-Identifier: GPL-3.0-or-later
#include "jobs/remaining_time.h"

namespace loopmend {

double work_of(const BoundaryLoop& loop) {
  constexpr double of_any_hole = 100;
  return of_any_hole + static_cast<double>(loop.edges()) * loop.edges();
}

std::optional<double> seconds_left(double seconds, double share) {
  constexpr double at_first = 3, least_share = 0.05;
  if (seconds < at_first || share < least_share || share >= 1) return std::nullopt;
  return seconds * (1 - share) / share;
}

}  // namespace loopmend
