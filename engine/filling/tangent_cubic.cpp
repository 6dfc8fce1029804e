// SPDX-License-Identifier: GPL-3.0-or-later
#include "filling/tangent_cubic.h"

#include <algorithm>
#include <cmath>

namespace loopmend {

TangentCubic::TangentCubic(const Vec3& from, const Vec3& leaving, const Vec3& to, const Vec3& arriving)
    : p_(from),
      q_(to) {
  const double turn = std::acos(std::clamp(leaving.dot(arriving), -1.0, 1.0));
  const double speed = (to - from).norm() / std::pow(std::cos(turn / 4), 2);
  u_ = speed * leaving;
  v_ = speed * arriving;
}

Vec3 TangentCubic::at(double t) const {
  const double s = 1 - t;
  return s * s * (1 + 2 * t) * p_ + t * s * s * u_ + t * t * (3 - 2 * t) * q_ - t * t * s * v_;
}

Vec3 TangentCubic::derivative(double t) const {
  const double s = 1 - t;
  return 6 * t * s * (q_ - p_) + s * (1 - 3 * t) * u_ + t * (3 * t - 2) * v_;
}

double TangentCubic::length() const {
  constexpr int edges = 16;
  double sum = 0;
  for (int k = 0; k < edges; ++k) sum += (at((k + 1.0) / edges) - at(static_cast<double>(k) / edges)).norm();
  return sum;
}

}  // namespace loopmend
