// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/no_data.h"

#include <algorithm>
#include <iterator>
#include <limits>
#include <set>
#include <utility>

namespace loopmend {

namespace {

constexpr double marks[] = {-9999,  // the greatest
                            -99999, -999999, -32768, -32767, -std::numeric_limits<float>::max()};

/// Text often has the lowest float by fewer digits, as -3.4e38.
double as_mark(double x) { return x < -3.3e38 ? -std::numeric_limits<float>::max() : x; }

NoDataVertices with_mark(const Points& points, int axis, double mark) {
  NoDataVertices found{mark, {}};
  double least = std::numeric_limits<double>::infinity(), most = -least;
  for (std::size_t v = 0; v < points.size(); ++v) {
    const double x = points[v][axis];
    if (as_mark(x) == mark) {
      found.vertices.push_back(static_cast<int>(v));
    } else {
      least = std::min(least, x);
      most = std::max(most, x);
    }
  }
  const bool stands_off = !(least > most) && least - mark > most - least;
  if (!stands_off) found.vertices.clear();
  return found;
}

}  // namespace

NoDataVertices find_no_data(const Points& points) {
  std::set<std::pair<int, double>> present;  // axis, mark
  for (const Vec3& p : points)
    for (int axis = 0; axis < 3; ++axis)
      if (p[axis] <= marks[0] && std::find(std::begin(marks), std::end(marks), as_mark(p[axis])) != std::end(marks))
        present.emplace(axis, as_mark(p[axis]));
  NoDataVertices best;
  for (const auto& [axis, mark] : present)
    if (NoDataVertices found = with_mark(points, axis, mark); found.vertices.size() > best.vertices.size())
      best = std::move(found);
  return best;
}

}  // namespace loopmend
