// SPDX-License-Identifier: GPL-3.0-or-later
// From labelled triangles to seams on the surfaces' intersections, and the outlines of the parts between them.
#pragma once

#include "edges/face_labels.h"

#include <functional>
#include <utility>
#include <vector>

namespace loopmend {

/// A disc of the patch that continues one side.
struct Part {
  int side = 0;
  std::vector<int> triangles;  ///< of the domain
  std::vector<int>
      outline;  ///< numbers of points, oriented like the patch's triangles; empty where the part is no disc
};

struct SeamLayout {
  Points points;                        ///< the loop's, then those of the seams
  std::vector<std::vector<int>> seams;  ///< those that are sharp
  std::vector<std::pair<int, int>> sides_of_seam;
  std::vector<Part> parts;
  std::vector<int> side_inside;  ///< of each loop edge
  double sharpest_deg = 0;       ///< largest bend where two sides meet
  double gap = 0;                ///< largest distance of a seam's point from one of the surfaces that should meet there
};

/// @param labels  a side for each triangle of the domain
/// @param size    wanted edge length at a place
/// @param reach   farthest that seams are from where the labels change
SeamLayout lay_out_seams(const Domain& domain, const std::vector<int>& labels, const Sides& sides,
                         const std::function<double(const Vec3&)>& size, double reach);

}  // namespace loopmend
