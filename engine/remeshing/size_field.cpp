// SPDX-License-Identifier: GPL-3.0-or-later
#include "remeshing/size_field.h"

#include "core/quantile.h"

#include <boost/geometry.hpp>
#include <boost/geometry/index/rtree.hpp>

#include <algorithm>
#include <utility>

namespace loopmend {

namespace {

namespace bg = boost::geometry;
using TreePoint = bg::model::point<double, 3, bg::cs::cartesian>;

/// By how much the target may fall per length of way from the boundary.
constexpr double steepest_fall = 0.4;

/// A boundary vertex with tiny edges among ordinary ones, as where a scan has two vertices nearly in one place, would fill its
/// neighborhood with millions of triangles: no size is below this share of the median of those near it.
constexpr double least_of_the_median = 0.2;
constexpr std::size_t near_sizes = 9;

std::vector<double> without_tiny_ones(const Points& places, const std::vector<double>& sizes) {
  std::vector<double> raised = sizes;
  std::vector<std::pair<double, double>> near(places.size());  // squared distance, size
  const std::size_t count = std::min(near_sizes, places.size());
  for (std::size_t i = 0; i < places.size(); ++i) {
    for (std::size_t k = 0; k < places.size(); ++k) near[k] = {(places[k] - places[i]).squaredNorm(), sizes[k]};
    std::nth_element(near.begin(), near.begin() + static_cast<long>(count - 1), near.end());
    std::vector<double> nearest;
    for (std::size_t k = 0; k < count; ++k) nearest.push_back(near[k].second);
    raised[i] = std::max(sizes[i], least_of_the_median * median(std::move(nearest)));
  }
  return raised;
}

}  // namespace

struct SizeField::Boundary {
  bg::index::rtree<TreePoint, bg::index::quadratic<16>> tree;

  double distance(const Vec3& p) const {
    const TreePoint place(p.x(), p.y(), p.z());
    return bg::distance(place, *tree.qbegin(bg::index::nearest(place, 1)));
  }
};

SizeField::SizeField(const Points& places, const std::vector<double>& sizes, const Grading& grading)
    : grading_(grading) {
  const std::size_t stride = 1 + places.size() / 256;
  double mean = 0;
  for (std::size_t i = 0; i < places.size(); i += stride) {
    place_.push_back(places[i]);
    size_.push_back(sizes[i]);
    mean += sizes[i];
  }
  size_ = without_tiny_ones(place_, size_);
  mean /= static_cast<double>(place_.size());
  floor_ = 0.01 * mean * mean;
  if (grading.density <= 1 && grading.growth == 0) return;
  std::vector<TreePoint> points;
  for (const Vec3& p : places) points.emplace_back(p.x(), p.y(), p.z());
  boundary_ = std::make_unique<Boundary>();
  boundary_->tree = decltype(boundary_->tree)(points);
}

SizeField::~SizeField() = default;
SizeField::SizeField(SizeField&&) noexcept = default;
SizeField& SizeField::operator=(SizeField&&) noexcept = default;

double SizeField::at(const Vec3& p) const {
  double sum = 0, total = 0;
  for (std::size_t k = 0; k < place_.size(); ++k) {
    const double d = (p - place_[k]).squaredNorm() + floor_;
    const double weight = 1 / (d * d);
    sum += weight * size_[k];
    total += weight;
  }
  const double boundary = sum / total;
  if (!boundary_) return boundary / grading_.density;
  const double way = boundary_->distance(p);
  if (grading_.growth > 0) return std::max(boundary, std::min(boundary + grading_.growth * way, grading_.longest));
  return std::max(boundary / grading_.density, boundary - steepest_fall * way);
}

}  // namespace loopmend
