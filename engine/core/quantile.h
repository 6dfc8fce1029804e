// SPDX-License-Identifier: GPL-3.0-or-later
// Order statistics.
#pragma once

#include <algorithm>
#include <utility>
#include <vector>

namespace loopmend {

/// The value that a share, 0 to below 1, of all are below; 0 where there are none.
inline double quantile(std::vector<double> values, double share) {
  if (values.empty()) return 0;
  const auto place = values.begin() + static_cast<long>(share * static_cast<double>(values.size()));
  std::nth_element(values.begin(), place, values.end());
  return *place;
}

inline double median(std::vector<double> values) { return quantile(std::move(values), 0.5); }

}  // namespace loopmend
