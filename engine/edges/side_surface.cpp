// SPDX-License-Identifier: GPL-3.0-or-later
#include "edges/side_surface.h"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <limits>

namespace loopmend {

namespace {

constexpr double least_rms = 1e-9;  ///< in units: below that, all fits are exact
constexpr double penalty_quadratic = 0.35, penalty_third = 1;
constexpr double rank_threshold = 1e-8;
constexpr double weight_between = 1e-3;  ///< of middles of edges, beside 1 of the points
constexpr double left_open = 1e-6;       ///< rms distance in units: two quadrics are both as near as that
constexpr double clearly_along = 0.5;    ///< mean cosine between the normals of a quadric and the side's own
constexpr double singular = 0.1;  ///< of the mean ‖∇q‖: two planes are a quadric, too, with ∇q = 0 where they meet
constexpr int fewest_for_quadric = 22, fewest_for_exact_quadric = 12;
constexpr int foot_rounds = 12;
constexpr double longest_foot_step = 0.2;

using Monomials = Eigen::Matrix<double, 10, 1>;

int terms_of(SideSurface::Kind kind) {
  switch (kind) {
    case SideSurface::Kind::plane: return 3;
    case SideSurface::Kind::quadratic: return 6;
    case SideSurface::Kind::cubic:
    case SideSurface::Kind::quadric: return 10;
  }
  return 0;
}

Monomials height_monomials(double x, double y) {
  Monomials m;
  m << 1, x, y, x * x, x * y, y * y, x * x * x, x * x * y, x * y * y, y * y * y;
  return m;
}
Monomials height_monomials_x(double x, double y) {
  Monomials m;
  m << 0, 1, 0, 2 * x, y, 0, 3 * x * x, 2 * x * y, y * y, 0;
  return m;
}
Monomials height_monomials_y(double x, double y) {
  Monomials m;
  m << 0, 0, 1, 0, x, 2 * y, 0, x * x, 2 * x * y, 3 * y * y;
  return m;
}

Monomials quadric_monomials(const Vec3& q) {
  Monomials m;
  m << 1, q.x(), q.y(), q.z(), q.x() * q.x(), q.y() * q.y(), q.z() * q.z(), q.x() * q.y(), q.y() * q.z(), q.z() * q.x();
  return m;
}
/// Columns: derivatives by x, y, z.
Eigen::Matrix<double, 10, 3> quadric_gradients(const Vec3& q) {
  Eigen::Matrix<double, 10, 3> g = Eigen::Matrix<double, 10, 3>::Zero();
  g(1, 0) = g(2, 1) = g(3, 2) = 1;
  for (int k = 0; k < 3; ++k) g(4 + k, k) = 2 * q[k];
  g(7, 0) = q.y(), g(7, 1) = q.x();
  g(8, 1) = q.z(), g(8, 2) = q.y();
  g(9, 2) = q.x(), g(9, 0) = q.z();
  return g;
}

Eigen::Matrix3d axes_with(const Vec3& normal) {
  Vec3 across = Vec3::Zero();
  across[std::abs(normal.x()) < 0.7 ? 0 : 1] = 1;
  Eigen::Matrix3d axes;
  axes.col(0) = across.cross(normal).normalized();
  axes.col(1) = normal.cross(axes.col(0));
  axes.col(2) = normal;
  return axes;
}

}  // namespace

std::optional<SideSurface> SideSurface::fit(const Points& points, const Vec3& normal, double unit, Kinds kinds,
                                            const Points& between) {
  if (points.size() < 3) return std::nullopt;
  SideSurface surface;
  for (const Vec3& p : points) surface.origin_ += p / static_cast<double>(points.size());
  surface.axes_ = axes_with(normal);
  surface.unit_ = unit;
  Points local;
  for (const Vec3& p : points) local.push_back(surface.local(p));
  Points local_between;
  for (const Vec3& p : between) local_between.push_back(surface.local(p));
  double best = std::numeric_limits<double>::infinity();
  for (const Kind kind : {Kind::plane, Kind::quadratic, Kind::cubic})
    surface.try_height_field(local, local_between, kind, best);
  if (kinds == Kinds::all) surface.try_quadric(local, local_between, best);
  if (!std::isfinite(best)) return std::nullopt;
  return surface;
}

void SideSurface::try_height_field(const Points& local, const Points& between, Kind kind, double& best) {
  const int terms = terms_of(kind), n = static_cast<int>(local.size());
  if (kind != Kind::plane && n < 2 * terms + 2) return;
  const auto fill = [&](const Points& points, double weight, auto rows, auto heights) {
    for (std::size_t i = 0; i < points.size(); ++i) {
      const auto row = static_cast<Eigen::Index>(i);
      rows.row(row) = weight * height_monomials(points[i].x(), points[i].y()).head(terms).transpose();
      heights[row] = weight * points[i].z();
    }
  };
  Eigen::MatrixXd A(n, terms);
  Eigen::VectorXd z(n);
  fill(local, 1, A.topRows(n), z.head(n));
  Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> solver;
  solver.setThreshold(rank_threshold);
  solver.compute(A);
  if (solver.rank() < terms && !between.empty()) {
    const auto m = static_cast<Eigen::Index>(between.size());
    A.conservativeResize(n + m, terms);
    z.conservativeResize(n + m);
    fill(between, weight_between, A.bottomRows(m), z.tail(m));
    solver.compute(A);
  }
  if (solver.rank() < terms) return;
  Coefficients c = Coefficients::Zero();
  c.head(terms) = solver.solve(z);
  const double rms = std::sqrt((z - A * c.head(terms)).head(n).squaredNorm() / std::max(1, n - terms));
  const double score = std::log(rms + least_rms) + (kind == Kind::plane       ? 0
                                                    : kind == Kind::quadratic ? penalty_quadratic
                                                                              : penalty_third);
  if (score >= best) return;
  best = score;
  kind_ = kind;
  c_ = c;
  rms_ = rms * unit_;
}

/// Taubin 1991: Σ q² least where Σ ‖∇q‖² = 1. The constant is eliminated, which leaves a symmetric pencil of nine rows.
void SideSurface::try_quadric(const Points& local, const Points& between, double& best) {
  const int n = static_cast<int>(local.size());
  if (n < fewest_for_exact_quadric) return;
  Eigen::MatrixXd A(n, 9);
  Eigen::Matrix<double, 9, 9> N = Eigen::Matrix<double, 9, 9>::Zero();
  for (int i = 0; i < n; ++i) {
    A.row(i) = quadric_monomials(local[i]).tail<9>().transpose();
    const Eigen::Matrix<double, 9, 3> g = quadric_gradients(local[i]).bottomRows<9>();
    N += g * g.transpose();
  }
  const Eigen::RowVectorXd mean = A.colwise().mean();
  const Eigen::MatrixXd centred = A.rowwise() - mean;
  N.diagonal().array() += 1e-12 * N.trace();
  Eigen::Matrix<double, 9, 9> M = centred.transpose() * centred;
  Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> solver(M, N);
  if (solver.info() == Eigen::Success && !between.empty() && solver.eigenvalues()[1] < n * left_open * left_open) {
    for (const Vec3& q : between) {
      const Eigen::Matrix<double, 9, 1> row = weight_between * (quadric_monomials(q).tail<9>() - mean.transpose());
      M += row * row.transpose();
    }
    solver.compute(M, N);
  }
  if (solver.info() != Eigen::Success) return;
  Coefficients c;
  c.tail<9>() = solver.eigenvectors().col(0);
  c[0] = -mean.dot(c.tail<9>());
  double sum = 0, least_slope = std::numeric_limits<double>::infinity(), mean_slope = 0, along_normal = 0;
  for (const Vec3& q : local) {
    const Vec3 gradient = quadric_gradients(q).transpose() * c;
    const double slope = gradient.norm();
    along_normal += gradient.z() / slope / n;
    least_slope = std::min(least_slope, slope);
    mean_slope += slope / n;
    sum += std::pow(c.dot(quadric_monomials(q)) / slope, 2);
  }
  if (!(least_slope > singular * mean_slope)) return;
  const double rms = std::sqrt(sum / (n - 9));
  if (n < fewest_for_quadric && rms > left_open) return;
  const double score = std::log(rms + least_rms) + penalty_third;
  if (!(score < best)) return;
  best = score;
  kind_ = Kind::quadric;
  c_ = along_normal < 0 ? Coefficients(-c) : c;
  has_outside_ = std::abs(along_normal) > clearly_along;
  rms_ = rms * unit_;
}

Vec3 SideSurface::foot_on_height_field(const Vec3& q) const {
  double x = q.x(), y = q.y();
  for (int round = 0; round < foot_rounds; ++round) {
    const double f = c_.dot(height_monomials(x, y)), fx = c_.dot(height_monomials_x(x, y)),
                 fy = c_.dot(height_monomials_y(x, y));
    const double t = (q.z() - f - fx * (q.x() - x) - fy * (q.y() - y)) / (1 + fx * fx + fy * fy);
    Eigen::Vector2d step(q.x() + t * fx - x, q.y() + t * fy - y);
    if (step.norm() > longest_foot_step) step *= longest_foot_step / step.norm();
    x += step.x();
    y += step.y();
    if (step.norm() < 1e-13) break;
  }
  return {x, y, c_.dot(height_monomials(x, y))};
}

Vec3 SideSurface::foot_on_quadric(const Vec3& start) const {
  Vec3 q = start;
  for (int round = 0; round < 2 * foot_rounds; ++round) {
    const Vec3 gradient = quadric_gradients(q).transpose() * c_;
    if (!(gradient.squaredNorm() > 0)) break;
    Vec3 step = -c_.dot(quadric_monomials(q)) / gradient.squaredNorm() * gradient;
    if (step.norm() > longest_foot_step) step *= longest_foot_step / step.norm();
    q += step;
    if (step.norm() < 1e-13) break;
  }
  return q;
}

Vec3 SideSurface::foot(const Vec3& p) const {
  const Vec3 q = local(p);
  return origin_ + unit_ * (axes_ * (kind_ == Kind::quadric ? foot_on_quadric(q) : foot_on_height_field(q)));
}

Vec3 SideSurface::normal_at(const Vec3& on_surface) const {
  const Vec3 q = local(on_surface);
  const Vec3 normal = kind_ == Kind::quadric ? Vec3(quadric_gradients(q).transpose() * c_)
                                             : Vec3(-c_.dot(height_monomials_x(q.x(), q.y())),
                                                    -c_.dot(height_monomials_y(q.x(), q.y())), 1);
  return axes_ * normal.normalized();
}

bool SideSurface::changes_sides(const Vec3& p, const Vec3& q) const {
  const auto side = [&](const Vec3& x) {
    const Vec3 l = local(x);
    return kind_ == Kind::quadric ? c_.dot(quadric_monomials(l)) : l.z() - c_.dot(height_monomials(l.x(), l.y()));
  };
  return side(p) * side(q) < 0;
}

double distance(std::span<const SideSurface* const> surfaces, const Vec3& p) {
  double largest = 0;
  for (const SideSurface* surface : surfaces) largest = std::max(largest, (surface->foot(p) - p).norm());
  return largest;
}

Vec3 common_point(std::span<const SideSurface* const> surfaces, const Vec3& p, double reach) {
  constexpr int rounds = 12;
  constexpr double parallel = 0.05;  // sine of the angle below which two surfaces count as one
  Vec3 x = p;
  for (int round = 0; round < rounds; ++round) {
    Eigen::MatrixX3d normals(surfaces.size(), 3);
    Eigen::VectorXd away(surfaces.size());
    for (std::size_t k = 0; k < surfaces.size(); ++k) {
      const Vec3 foot = surfaces[k]->foot(x), normal = surfaces[k]->normal_at(foot);
      normals.row(k) = normal.transpose();
      away[k] = normal.dot(foot - x);
    }
    Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> solver;
    solver.setThreshold(parallel);
    solver.compute(normals);
    x += solver.solve(away);
  }
  if ((x - p).norm() <= reach) return x;
  Vec3 mean = Vec3::Zero();
  for (const SideSurface* surface : surfaces) mean += surface->foot(p) / static_cast<double>(surfaces.size());
  return mean;
}

}  // namespace loopmend
