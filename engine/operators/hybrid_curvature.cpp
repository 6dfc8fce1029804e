// SPDX-License-Identifier: GPL-3.0-or-later
#include "operators/hybrid_curvature.h"

#include "core/threads.h"
#include "operators/small_least_squares.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace loopmend {

namespace {

constexpr std::size_t fewest_neighbors = 15;  ///< below, a third ring is taken
constexpr std::size_t most_samples = 22;      ///< the nearest, the vertex itself included
constexpr double crease =
    40 * std::numbers::pi / 180;  ///< between normals, at which a sample has lost 63 % of its weight
constexpr int passes = 3;         ///< each but the last turns the fit's plane to its tangent plane
constexpr double steepest = 2;    ///< slope to which it is turned
constexpr double ridge = 5e-8;    ///< of the normal matrix, in units of its weights
constexpr double least_eigen =
    5e-7;                        ///< bound on its eigenvalues, likewise: below, the samples do not determine a cubic
constexpr double spread = 0.4;   ///< least distance between samples that are chosen apart, over that to the vertex
constexpr double most_bent = 9;  ///< times the mean of ‖A‖²: more is taken for noise
constexpr int vertices_at_a_time = 16;

/// Of the height fields: xᵃ yᵇ with these powers.
constexpr int terms = 10, x_power[] = {0, 1, 0, 2, 1, 0, 3, 2, 1, 0}, y_power[] = {0, 0, 1, 0, 1, 2, 0, 1, 2, 3};
/// a! b! / (a + b)!: with these weights the sum of squared coefficients of each degree is the same in all frames of the plane (Bombieri's
/// norm), and with it the ridge and the eigenvalues.
constexpr double frame_weight[] = {1, 1, 1, 1, 1. / 2, 1, 1, 1. / 3, 1. / 3, 1};
constexpr int lanes =
    2;  ///< vertices at which fits are made side by side: the processor's vectors hold as many everywhere
using Lanes = Eigen::Array2d;
using Offset = std::array<Lanes, 3>;

struct Fit {
  double H = 0, bent = 0, height = 0;  ///< bent: ‖A‖²; height: of the field over the vertex
  Vec3 normal = Vec3::Zero();
};

/// All that the fit at one vertex is made of. Lengths are in units of its width.
struct Place {
  struct Sample {
    double distance2 = 0;
    int vertex = 0;
  };

  int center = 0;
  bool is_fitted = false;
  double width = 0;
  Vec3 normal, u, v;
  std::vector<Sample> samples;

  /// @returns false where the vertex has no normal or no neighbor.
  bool begin(int i, const Points& points, const Points& normals, const std::vector<int>& neighbors) {
    center = i;
    normal = normals[i];
    if (normal.isZero()) return false;
    choose_samples(points, neighbors);
    return width > 0;
  }
  /// The nearest.
  void choose_samples(const Points& points, const std::vector<int>& neighbors);
  /// The nearest that lie apart: around the pole of a globe the nearest lie all on one circle of latitude.
  void spread_samples(const Points& points, const std::vector<int>& neighbors);
  void set_width() {
    double widest2 = 0;
    for (const Sample& s : samples) widest2 = std::max(widest2, s.distance2);
    width = std::sqrt(widest2);
  }
  double weight(std::size_t k, const Points& normals) const {
    const double turn = std::acos(std::clamp(normals[samples[k].vertex].dot(normals[center]), -1.0, 1.0)) / crease;
    return std::exp(-3 * samples[k].distance2 / (width * width) - turn * turn * turn * turn);
  }
  /// @param c  of the height field
  Fit result(const std::array<double, 6>& c) const {
    const double x = c[1], y = c[2], xx = 2 * c[3] / width, xy = c[4] / width, yy = 2 * c[5] / width;
    const double g = 1 + x * x + y * y;
    const double H = ((1 + y * y) * xx - 2 * x * y * xy + (1 + x * x) * yy) / (2 * g * std::sqrt(g));
    return {H, xx * xx + 2 * xy * xy + yy * yy, c[0] * width, normal};
  }
};

void Place::choose_samples(const Points& points, const std::vector<int>& neighbors) {
  samples.clear();
  for (int j : neighbors) samples.push_back({(points[j] - points[center]).squaredNorm(), j});
  if (samples.size() > most_samples) {
    std::nth_element(samples.begin(), samples.begin() + (most_samples - 1), samples.end(),
                     [](const Sample& a, const Sample& b) {
                       return a.distance2 < b.distance2 || (a.distance2 == b.distance2 && a.vertex < b.vertex);
                     });
    samples.resize(most_samples);
    std::sort(samples.begin(), samples.end(), [](const Sample& a, const Sample& b) { return a.vertex < b.vertex; });
  }
  set_width();
}

void Place::spread_samples(const Points& points, const std::vector<int>& neighbors) {
  std::vector<Sample> nearest;
  for (int j : neighbors) nearest.push_back({(points[j] - points[center]).squaredNorm(), j});
  std::sort(nearest.begin(), nearest.end(), [](const Sample& a, const Sample& b) {
    return a.distance2 < b.distance2 || (a.distance2 == b.distance2 && a.vertex < b.vertex);
  });
  samples.clear();
  for (const Sample& s : nearest) {
    const bool apart = std::all_of(samples.begin(), samples.end(), [&](const Sample& other) {
      return (points[s.vertex] - points[other.vertex]).squaredNorm() >= spread * spread * s.distance2;
    });
    if (apart) samples.push_back(s);
    if (samples.size() == most_samples) break;
  }
  set_width();
}

/// The fits at two vertices side by side.
class Fitter {
 public:
  /// At vertex i and the next one, where there is one. A fit stays as it is where the vertex has no normal or no
  /// neighbor, or a position is not finite.
  void fit(int i, const Points& points, const Points& normals, const FitNeighbors& neighbors, std::vector<Fit>& fits) {
    const int count = std::min(lanes, static_cast<int>(points.size()) - i);
    for (int l = 0; l < lanes; ++l)
      places_[l].is_fitted = l < count && places_[l].begin(i + l, points, normals, neighbors[i + l]);
    take_samples(points, normals);
    solve();
    bool others = false;
    for (int l = 0; l < count; ++l) {
      if (!places_[l].is_fitted || neighbors[i + l].size() <= most_samples || is_determined(l)) continue;
      places_[l].spread_samples(points, neighbors[i + l]);
      others = true;
    }
    if (others) {
      take_samples(points, normals);
      solve();
    }
    for (int pass = 1; pass < passes; ++pass) {
      turn();
      solve();
    }
    for (int l = 0; l < count; ++l)
      if (places_[l].is_fitted)
        fits[i + l] = places_[l].result({c_[0][l], c_[1][l], c_[2][l], c_[3][l], c_[4][l], c_[5][l]});
  }

 private:
  /// The trace of the inverse bounds the least eigenvalue from below, up to the number of terms.
  bool is_determined(int lane) const {
    const std::array<Lanes, terms> inverse = normal_matrix_.inverse_diagonal();
    double trace = 0;
    for (int i = 0; i < terms; ++i) trace += frame_weight[i] * inverse[i][lane];
    return 1 / trace > least_eigen;
  }

  /// Samples that a vertex has fewer than the other count nothing.
  void take_samples(const Points& points, const Points& normals) {
    std::size_t most = 0;
    for (const Place& place : places_)
      if (place.is_fitted) most = std::max(most, place.samples.size());
    weight_.assign(most, Lanes::Zero());
    offset_.assign(most, {Lanes::Zero(), Lanes::Zero(), Lanes::Zero()});
    for (int l = 0; l < lanes; ++l)
      if (places_[l].is_fitted) take_samples(l, points, normals);
  }
  void take_samples(int lane, const Points& points, const Points& normals) {
    const Place& place = places_[lane];
    for (std::size_t k = 0; k < place.samples.size(); ++k) {
      weight_[k][lane] = place.weight(k, normals);
      const Vec3 offset = (points[place.samples[k].vertex] - points[place.center]) / place.width;
      for (int c = 0; c < 3; ++c) offset_[k][c][lane] = offset[c];
    }
  }

  /// To the tangent planes of the fits.
  void turn() {
    for (int l = 0; l < lanes; ++l)
      if (Place& p = places_[l]; p.is_fitted && std::hypot(c_[1][l], c_[2][l]) < steepest)
        p.normal = (p.normal - c_[1][l] * p.u - c_[2][l] * p.v).normalized();
  }

  void solve();

  std::array<Place, lanes> places_;
  std::array<Lanes, terms> c_;
  SmallCholesky<terms, Lanes> normal_matrix_;
  std::vector<Lanes> weight_;
  std::vector<Offset> offset_;  ///< from the center to the samples, in units of the width
};

/// A c = Σ ω z p for the terms p. Samples at even and at odd places are summed up apart.
void Fitter::solve() {
  const Lanes zero = Lanes::Zero();
  Offset u{zero, zero, zero}, v = u, up = u;
  for (int l = 0; l < lanes; ++l) {
    Place& place = places_[l];
    if (!place.is_fitted) continue;
    place.u = place.normal.unitOrthogonal();
    place.v = place.normal.cross(place.u);
    for (int c = 0; c < 3; ++c) {
      u[c][l] = place.u[c];
      v[c][l] = place.v[c];
      up[c][l] = place.normal[c];
    }
  }
  const auto along = [](const Offset& offset, const Offset& axis) -> Lanes {
    return offset[0] * axis[0] + offset[1] * axis[1] + offset[2] * axis[2];
  };
  Moments<0, 6, Lanes> moments(zero), odd_moments(zero);
  Moments<0, 3, Lanes> right(zero), odd_right(zero);
  const auto sum_up = [&](std::size_t first, Moments<0, 6, Lanes>& of_all, Moments<0, 3, Lanes>& of_heights) {
    for (std::size_t k = first; k < offset_.size(); k += 2) {
      const Lanes x = along(offset_[k], u), y = along(offset_[k], v);
      of_all.add(weight_[k], x, y);
      of_heights.add(weight_[k] * along(offset_[k], up), x, y);
    }
  };
  sum_up(0, moments, right);
  sum_up(1, odd_moments, odd_right);
  moments.add(odd_moments);
  right.add(odd_right);
  Lanes A[terms][terms];
#pragma GCC unroll 10
  for (int i = 0; i < terms; ++i) {
#pragma GCC unroll 10
    for (int j = 0; j <= i; ++j) A[i][j] = moments(x_power[i] + x_power[j], y_power[i] + y_power[j]);
    A[i][i] += ridge * frame_weight[i];
    c_[i] = right(x_power[i], y_power[i]);
  }
  const bool any = normal_matrix_.factorize(A);
  for (int l = 0; l < lanes; ++l) places_[l].is_fitted = places_[l].is_fitted && any && normal_matrix_.is_factored(l);
  if (any) normal_matrix_.solve(c_.data());
}

}  // namespace

FitNeighbors fit_neighbors(const Topology& topology) {
  FitNeighbors neighbors(topology.vertex_count());
  parallel_for(
      0, topology.vertex_count(), vertices_at_a_time, [&] { return std::vector<char>(topology.vertex_count(), 0); },
      [&](int i, std::vector<char>& mark) {
        topology.k_ring(i, 2, neighbors[i], mark);
        if (neighbors[i].size() < fewest_neighbors) topology.k_ring(i, 3, neighbors[i], mark);
        neighbors[i].push_back(i);
      });
  return neighbors;
}

HybridCurvature hybrid_curvature(const Points& points, const Points& normals, const FitNeighbors& neighbors,
                                 const SparseMatrix& stiffness, const Eigen::VectorXd& mass) {
  const int n = static_cast<int>(points.size());
  std::vector<Fit> fits(n);
  for (int i = 0; i < n; ++i) fits[i].normal = normals[i];
  parallel_for(
      0, (n + lanes - 1) / lanes, vertices_at_a_time / lanes, [] { return Fitter(); },
      [&](int k, Fitter& fitter) { fitter.fit(lanes * k, points, normals, neighbors, fits); });
  HybridCurvature result;
  result.B = stiffness;
  double bent = 0;
  for (const Fit& fit : fits) bent += fit.bent / n;
  for (int i = 0; i < n; ++i)
    for (RowSparseMatrix::InnerIterator entry(result.B, i); entry; ++entry)
      entry.valueRef() *= -0.5 / mass[i] * fits[i].normal.dot(fits[entry.col()].normal);
  result.bent.resize(n);
  Eigen::VectorXd heights(n), fitted(n);
  for (int i = 0; i < n; ++i) {
    result.bent[i] = fits[i].bent;
    heights[i] = fits[i].height;
    fitted[i] = fits[i].H;
  }
  result.H = fitted - result.B * heights;
  for (int i = 0; i < n; ++i) result.B.coeffRef(i, i) += std::min(fits[i].bent, most_bent * bent);
  return result;
}

}  // namespace loopmend
