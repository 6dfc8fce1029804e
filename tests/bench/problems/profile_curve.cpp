#include "profile_curve.h"

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

}  // namespace

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
