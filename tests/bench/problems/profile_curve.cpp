// SPDX-License-Identifier: GPL-3.0-or-later
#include "profile_curve.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <vector>

namespace loopmend::bench {

namespace {

using Eigen::Vector2d;

double unduloid_radius(double bulge, double s) { return std::sqrt(1 + bulge * bulge + 2 * bulge * std::sin(s)); }

/// dz/ds.
double unduloid_rise(double bulge, double s) { return (1 + bulge * std::sin(s)) / unduloid_radius(bulge, s); }

/// ∫ of the rise over [a, b] by the 5-point Gauss-Legendre rule: error below 1e-16 for |b − a| ≤ 0.02.
double integrated_rise(double bulge, double a, double b) {
  constexpr std::array<double, 3> node{0, 0.5384693101056831, 0.9061798459386640};
  constexpr std::array<double, 3> weight{0.5688888888888889, 0.4786286704993665, 0.2369268850561891};
  const double middle = (a + b) / 2, half = (b - a) / 2;
  double sum = weight[0] * unduloid_rise(bulge, middle);
  for (int k = 1; k < 3; ++k)
    sum += weight[k] * (unduloid_rise(bulge, middle - half * node[k]) + unduloid_rise(bulge, middle + half * node[k]));
  return half * sum;
}

/// z at evenly spaced knots, from 0 at s = 0.
class RiseTable {
 public:
  RiseTable(double bulge, double length) : bulge_(bulge), half_(static_cast<int>(std::ceil(length / spacing))) {
    z_.assign(2 * half_ + 1, 0);
    for (int k = 1; k <= half_; ++k) {
      z_[half_ + k] = z_[half_ + k - 1] + integrated_rise(bulge, (k - 1) * spacing, k * spacing);
      z_[half_ - k] = z_[half_ - k + 1] - integrated_rise(bulge, -k * spacing, (1 - k) * spacing);
    }
  }
  double z(double s) const {
    const int k = std::clamp(static_cast<int>(std::lround(s / spacing)), -half_, half_);
    return z_[half_ + k] + integrated_rise(bulge_, k * spacing, s);
  }

 private:
  static constexpr double spacing = 0.02;
  double bulge_;
  int half_;
  std::vector<double> z_;
};

/// x, y, the angle of the tangent, κ, κ', κ'', κ'''.
using CurveState = Eigen::Matrix<double, 7, 1>;

CurveState mvc_rate(const CurveState& at) {
  CurveState rate;
  rate << std::cos(at[2]), std::sin(at[2]), at[3], at[4], at[5], at[6], at[3] * (at[4] * at[4] / 2 - at[3] * at[5]);
  return rate;
}

CurveState mvc_step(const CurveState& at, double step) {
  const CurveState a = mvc_rate(at), b = mvc_rate(at + step / 2 * a), c = mvc_rate(at + step / 2 * b),
                   d = mvc_rate(at + step * c);
  return at + step / 6 * (a + 2 * b + 2 * c + d);
}

/// States at evenly spaced knots.
class CurveTable {
 public:
  CurveTable(const Eigen::Vector4d& curvature, double length) : half_(static_cast<int>(std::ceil(length / spacing))) {
    states_.resize(2 * half_ + 1);
    states_[half_] << 0, 0, 0, curvature;
    for (int k = 1; k <= half_; ++k) {
      states_[half_ + k] = mvc_step(states_[half_ + k - 1], spacing);
      states_[half_ - k] = mvc_step(states_[half_ - k + 1], -spacing);
    }
  }
  CurveState at(double s) const {
    const int k = std::clamp(static_cast<int>(std::lround(s / spacing)), -half_, half_);
    return mvc_step(states_[half_ + k], s - k * spacing);
  }

 private:
  static constexpr double spacing = 1e-3;
  int half_;
  std::vector<CurveState> states_;
};

}  // namespace

ProfileCurve mvc_profile(const Eigen::Vector4d& curvature, double length) {
  const auto table = std::make_shared<const CurveTable>(curvature, length);
  return {[=](double s) -> Vector2d { return table->at(s).head<2>(); },
          [=](double s) {
            const double angle = table->at(s)[2];
            return Vector2d(std::cos(angle), std::sin(angle));
          }};
}

ProfileCurve catenoid_profile() {
  const auto radius = [](double s) { return std::sqrt(1 + s * s); };
  return {[=](double s) { return Vector2d(radius(s), std::asinh(s)); },
          [=](double s) { return Vector2d(s / radius(s), 1 / radius(s)); }};
}

ProfileCurve unduloid_profile(double bulge, double length) {
  const auto table = std::make_shared<const RiseTable>(bulge, length);
  return {[=](double s) { return Vector2d(unduloid_radius(bulge, s), table->z(s)); },
          [=](double s) { return Vector2d(bulge * std::cos(s) / unduloid_radius(bulge, s), unduloid_rise(bulge, s)); }};
}

double nearest_arc_length(const ProfileCurve& profile, const Eigen::Vector2d& place, double from, double to) {
  constexpr int samples = 200;
  double best = from, least = std::numeric_limits<double>::max();
  for (int k = 0; k <= samples; ++k) {
    const double s = from + (to - from) * k / samples;
    const double d = (profile.point(s) - place).squaredNorm();
    if (d < least) least = d, best = s;
  }
  // Gauss-Newton: the tangent is of unit length.
  for (int k = 0; k < 60; ++k) {
    const double step = (place - profile.point(best)).dot(profile.tangent(best));
    best += step;
    if (std::abs(step) < 1e-15) break;
  }
  return best;
}

}  // namespace loopmend::bench
