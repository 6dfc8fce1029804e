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

struct Weighted {
  double value, weight;  ///< the weight at least 0
};

/// The value that a share, 0 to below 1, of all weights are below; 0 where there are none. Equal weights: as above.
inline double quantile(std::vector<Weighted> values, double share) {
  if (values.empty()) return 0;
  std::ranges::sort(values, {}, &Weighted::value);
  double all = 0;
  for (const Weighted& v : values) all += v.weight;
  const double rounding = 1e-12 * all;
  double left = share * all;
  for (const Weighted& v : values)
    if ((left -= v.weight) < -rounding) return v.value;
  return values.back().value;
}

inline double median(std::vector<Weighted> values) { return quantile(std::move(values), 0.5); }

}  // namespace loopmend
