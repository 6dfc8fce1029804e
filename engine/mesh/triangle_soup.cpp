// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/triangle_soup.h"

#include <utility>

namespace loopmend {

void append(TriangleSoup& all, const TriangleSoup& part) {
  constexpr Color white{255, 255, 255, 255};
  const int shift = static_cast<int>(all.points.size());
  if (!part.colors.empty()) all.colors.resize(all.points.size(), white);
  all.points.insert(all.points.end(), part.points.begin(), part.points.end());
  all.colors.insert(all.colors.end(), part.colors.begin(), part.colors.end());
  if (!all.colors.empty()) all.colors.resize(all.points.size(), white);
  for (const Triangle& t : part.triangles) all.triangles.push_back({t[0] + shift, t[1] + shift, t[2] + shift});
}

TriangleSoup joined(std::vector<TriangleSoup> parts) {
  if (parts.empty()) return {};
  TriangleSoup all = std::move(parts.front());
  for (std::size_t k = 1; k < parts.size(); ++k) append(all, parts[k]);
  return all;
}

}  // namespace loopmend
