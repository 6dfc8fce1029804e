// SPDX-License-Identifier: GPL-3.0-or-later
#include "operators/hybrid_curvature.h"

#include "core/threads.h"
#include "operators/small_least_squares.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

namespace loopmend {

namespace {

constexpr std::size_t fewest_neighbors = 15;  ///< below, a third ring is taken
constexpr std::size_t most_samples = 22;      ///< the nearest, the vertex itself included
constexpr double crease =
    40 * std::numbers::pi / 180;  ///< between normals, at which a sample has lost 63 % of its weight
constexpr int passes = 3;         ///< each but the last turns the fit's plane to its tangent plane
constexpr double steepest = 2;    ///< slope to which it is turned
constexpr double ridge = 1e-7;    ///< of the normal matrix, in units of its weights
constexpr double most_bent = 9;   ///< times the mean of ‖A‖²: more is taken for noise
constexpr int vertices_at_a_time = 16;

/// Of the height fields: xᵃ yᵇ with these powers.
constexpr int terms = 10, x_power[] = {0, 1, 0, 2, 1, 0, 3, 2, 1, 0}, y_power[] = {0, 0, 1, 0, 1, 2, 0, 1, 2, 3};
using Vector10 = Eigen::Matrix<double, terms, 1>;
using Pair = Eigen::Array2d;  ///< of two samples: the processor's vectors hold as many everywhere

struct Fit {
  double H = 0, bent = 0, height = 0;  ///< bent: ‖A‖²; height: of the field over the vertex
  Vec3 normal = Vec3::Zero();
};

/// All that one fit is made of. Lengths are in units of its width.
class Fitter {
 public:
  /// @returns false where the vertex has no normal or no neighbor, or a position is not finite.
  bool fit(int i, const Points& points, const Points& normals, const std::vector<int>& neighbors) {
    center_ = i;
    normal_ = normals[i];
    if (normal_.isZero()) return false;
    choose_samples(points, neighbors);
    if (!(width_ > 0)) return false;
    weigh(normals);
    take_steps(points);
    for (int pass = 0; pass < passes; ++pass) {
      if (!solve()) return false;
      if (pass + 1 < passes && std::hypot(c_[1], c_[2]) < steepest)
        normal_ = (normal_ - c_[1] * u_ - c_[2] * v_).normalized();
    }
    return true;
  }

  const Vec3& normal() const { return normal_; }

  Fit result() const {
    const Slopes f = slopes();
    return {f.H(), f.xx * f.xx + 2 * f.xy * f.xy + f.yy * f.yy, c_[0] * width_, normal_};
  }

  /// What H and the height of the field count, handed on to the samples.
  void add_derivative(double of_H, double of_height, const Points& points, const Points& normals,
                      std::vector<std::pair<int, Vec3>>& moves, std::vector<std::pair<int, Vec3>>& turns) const;

 private:
  struct Sample {
    double distance2 = 0;
    int vertex = 0;
  };
  struct Slopes {
    double x, y, xx, xy, yy;
    double metric() const { return 1 + x * x + y * y; }
    double H() const {
      const double g = metric();
      return ((1 + y * y) * xx - 2 * x * y * xy + (1 + x * x) * yy) / (2 * g * std::sqrt(g));
    }
  };
  Slopes slopes() const { return {c_[1], c_[2], 2 * c_[3] / width_, c_[4] / width_, 2 * c_[5] / width_}; }
  Vector10 derivative_of_coefficients(double of_H, double of_height) const;
  void choose_samples(const Points& points, const std::vector<int>& neighbors);
  void weigh(const Points& normals);
  void take_steps(const Points& points);
  bool solve();
  static Vector10 row(double x, double y) {
    Vector10 row;
    row << 1, x, y, x * x, x * y, y * y, x * x * x, x * x * y, x * y * y, y * y * y;
    return row;
  }

  int center_ = 0;
  double width_ = 0;
  Vec3 normal_, u_, v_;
  Vector10 c_;
  SmallCholesky<terms> normal_matrix_;
  std::vector<Sample> samples_;
  std::vector<double> weight_;            ///< an even number: one sample too many counts nothing
  std::vector<std::array<Pair, 3>> way_;  ///< from the center to the samples, in units of the width
};

void Fitter::choose_samples(const Points& points, const std::vector<int>& neighbors) {
  samples_.clear();
  for (int j : neighbors) samples_.push_back({(points[j] - points[center_]).squaredNorm(), j});
  if (samples_.size() > most_samples) {
    std::nth_element(samples_.begin(), samples_.begin() + (most_samples - 1), samples_.end(),
                     [](const Sample& a, const Sample& b) {
                       return a.distance2 < b.distance2 || (a.distance2 == b.distance2 && a.vertex < b.vertex);
                     });
    samples_.resize(most_samples);
    std::sort(samples_.begin(), samples_.end(), [](const Sample& a, const Sample& b) { return a.vertex < b.vertex; });
  }
  double widest2 = 0;
  for (const Sample& s : samples_) widest2 = std::max(widest2, s.distance2);
  width_ = std::sqrt(widest2);
}

void Fitter::weigh(const Points& normals) {
  weight_.assign((samples_.size() + 1) / 2 * 2, 0);
  const double widest2 = width_ * width_;
  for (std::size_t k = 0; k < samples_.size(); ++k) {
    const double turn = std::acos(std::clamp(normals[samples_[k].vertex].dot(normals[center_]), -1.0, 1.0)) / crease;
    weight_[k] = std::exp(-3 * samples_[k].distance2 / widest2 - turn * turn * turn * turn);
  }
}

void Fitter::take_steps(const Points& points) {
  const Pair none = Pair::Zero();
  way_.assign((samples_.size() + 1) / 2, {none, none, none});
  for (std::size_t k = 0; k < samples_.size(); ++k) {
    const Vec3 way = (points[samples_[k].vertex] - points[center_]) / width_;
    for (int c = 0; c < 3; ++c) way_[k / 2][c][k % 2] = way[c];
  }
}

/// A c = Σ ω z p for the terms p.
bool Fitter::solve() {
  u_ = normal_.unitOrthogonal();
  v_ = normal_.cross(u_);
  const Pair zero = Pair::Zero();
  Moments<0, 6, Pair> moments(zero);
  Moments<0, 3, Pair> right(zero);
  for (std::size_t k = 0; k < way_.size(); ++k) {
    const auto along = [&](const Vec3& axis) -> Pair {
      return way_[k][0] * axis[0] + way_[k][1] * axis[1] + way_[k][2] * axis[2];
    };
    const Pair x = along(u_), y = along(v_), weight = Eigen::Map<const Pair>(&weight_[2 * k]);
    moments.add(weight, x, y);
    right.add(weight * along(normal_), x, y);
  }
  double A[terms][terms];
  for (int i = 0; i < terms; ++i) {
    for (int j = 0; j <= i; ++j) A[i][j] = moments(x_power[i] + x_power[j], y_power[i] + y_power[j]).sum();
    A[i][i] += ridge;
    c_[i] = right(x_power[i], y_power[i]).sum();
  }
  if (!normal_matrix_.factorize(A)) return false;
  normal_matrix_.solve(c_.data());
  return true;
}

Vector10 Fitter::derivative_of_coefficients(double of_H, double of_height) const {
  const Slopes f = slopes();
  const double g = f.metric(), twice = 2 * g * std::sqrt(g), H = f.H();
  Vector10 d = Vector10::Zero();
  d[0] = of_height * width_;
  d[1] = of_H * (2 * (f.x * f.yy - f.y * f.xy) / twice - 3 * f.x * H / g);
  d[2] = of_H * (2 * (f.y * f.xx - f.x * f.xy) / twice - 3 * f.y * H / g);
  d[3] = of_H * (1 + f.y * f.y) / twice * 2 / width_;
  d[4] = of_H * -2 * f.x * f.y / twice / width_;
  d[5] = of_H * (1 + f.x * f.x) / twice * 2 / width_;
  return d;
}

/// With A c = Σ ω z p for the terms p, residuals z − c·p: A dc = Σ ω (dz − ∇f·dξ) p + Σ ω (z − f) dp + Σ dω (z − f) p.
void Fitter::add_derivative(double of_H, double of_height, const Points& points, const Points& normals,
                            std::vector<std::pair<int, Vec3>>& moves, std::vector<std::pair<int, Vec3>>& turns) const {
  Vector10 t = derivative_of_coefficients(of_H, of_height);
  normal_matrix_.solve(t.data());
  Vec3 back = Vec3::Zero(), center_turn = Vec3::Zero(), widest_move = Vec3::Zero();
  const double widest2 = width_ * width_;
  double of_widest2 = 0;
  std::size_t widest = 0;
  const auto moved = [&](int vertex, const Vec3& d) {
    moves.emplace_back(vertex, d);
    back -= d;
  };
  for (std::size_t k = 0; k < samples_.size(); ++k) {
    const int j = samples_[k].vertex;
    if (samples_[k].distance2 > samples_[widest].distance2) widest = k;
    const Vec3 way = points[j] - points[center_];
    const double x = way.dot(u_) / width_, y = way.dot(v_) / width_;
    Vector10 px, py;
    px << 0, 1, 0, 2 * x, y, 0, 3 * x * x, 2 * x * y, y * y, 0;
    py << 0, 0, 1, 0, x, 2 * y, 0, x * x, 2 * x * y, 3 * y * y;
    const Vector10 p = row(x, y);
    const double residual = way.dot(normal_) / width_ - c_.dot(p), pull = t.dot(p);
    Vec3 d = weight_[k] / width_ *
             (pull * (normal_ - c_.dot(px) * u_ - c_.dot(py) * v_) + residual * (t.dot(px) * u_ + t.dot(py) * v_));
    const double of_weight = weight_[k] * pull * residual;
    d -= 6 * of_weight / widest2 * way;
    of_widest2 += 3 * of_weight * samples_[k].distance2 / (widest2 * widest2);
    const double cosine = std::clamp(normals[j].dot(normals[center_]), -1.0, 1.0), angle = std::acos(cosine);
    const double turn = angle / crease, sine = std::sin(angle);
    if (sine > 1e-9) {
      const double of_cosine = of_weight * 4 * turn * turn * turn / (crease * sine);
      turns.emplace_back(j, of_cosine * normals[center_]);
      center_turn += of_cosine * normals[j];
    }
    if (j != center_) moved(j, d);
  }
  widest_move = 2 * of_widest2 * (points[samples_[widest].vertex] - points[center_]);
  moved(samples_[widest].vertex, widest_move);
  moves.emplace_back(center_, back);
  turns.emplace_back(center_, center_turn);
}

Fit fit_at(int i, const Points& points, const Points& normals, const std::vector<int>& neighbors, Fitter& fitter) {
  if (fitter.fit(i, points, normals, neighbors)) return fitter.result();
  Fit fit;
  fit.normal = normals[i];
  return fit;
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
  parallel_for(
      0, n, vertices_at_a_time, [] { return Fitter(); },
      [&](int i, Fitter& fitter) { fits[i] = fit_at(i, points, normals, neighbors[i], fitter); });
  HybridCurvature result;
  result.B = stiffness;
  double bent = 0;
  for (const Fit& fit : fits) bent += fit.bent / n;
  for (int i = 0; i < n; ++i)
    for (RowSparseMatrix::InnerIterator entry(result.B, i); entry; ++entry)
      entry.valueRef() *= -0.5 / mass[i] * fits[i].normal.dot(fits[entry.col()].normal);
  result.bent.resize(n);
  result.heights.resize(n);
  result.fitted.resize(n);
  result.normals.resize(n);
  for (int i = 0; i < n; ++i) {
    result.bent[i] = fits[i].bent;
    result.heights[i] = fits[i].height;
    result.fitted[i] = fits[i].H;
    result.normals[i] = fits[i].normal;
  }
  result.H = result.fitted - result.B * result.heights;
  for (int i = 0; i < n; ++i) result.B.coeffRef(i, i) += std::min(fits[i].bent, most_bent * bent);
  return result;
}

FitDerivative fit_derivative(const Points& points, const Points& normals, const FitNeighbors& neighbors,
                             const FitFunctional& functional) {
  using Shares = std::vector<std::pair<int, Vec3>>;
  const int n = static_cast<int>(points.size());
  std::vector<Shares> moves(n), turns(n);
  parallel_for(
      0, n, vertices_at_a_time, [] { return Fitter(); },
      [&](int i, Fitter& fitter) {
        if (fitter.fit(i, points, normals, neighbors[i]))
          fitter.add_derivative(functional.H[i], functional.heights[i], points, normals, moves[i], turns[i]);
      });
  FitDerivative derivative{Points(n, Vec3::Zero()), Points(n, Vec3::Zero())};
  for (int i = 0; i < n; ++i) {  // in order: the same bits for any number of threads
    for (const auto& [vertex, share] : moves[i]) derivative.points[vertex] += share;
    for (const auto& [vertex, share] : turns[i]) derivative.normals[vertex] += share;
  }
  return derivative;
}

}  // namespace loopmend
