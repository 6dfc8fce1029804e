// SPDX-License-Identifier: GPL-3.0-or-later
// Numbered points in boost's R-tree, for sources that search boxes.
#pragma once

#include "core/types.h"

#include <boost/geometry.hpp>
#include <boost/geometry/index/rtree.hpp>

#include <utility>

namespace loopmend {

using TreePoint = boost::geometry::model::point<double, 3, boost::geometry::cs::cartesian>;
using TreeBox = boost::geometry::model::box<TreePoint>;
using PointTree = boost::geometry::index::rtree<std::pair<TreePoint, int>, boost::geometry::index::quadratic<16>>;

inline TreePoint tree_point(const Vec3& p) { return {p.x(), p.y(), p.z()}; }

}  // namespace loopmend
