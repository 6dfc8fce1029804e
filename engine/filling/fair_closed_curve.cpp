// SPDX-License-Identifier: GPL-3.0-or-later
#include "filling/fair_closed_curve.h"

#include "core/error.h"
#include "solvers/linear_solver.h"

#include <Eigen/SparseCore>
#include <unsupported/Eigen/AutoDiff>

#include <algorithm>
#include <array>
#include <cmath>

namespace loopmend {

namespace {

using Sparse = Eigen::SparseMatrix<double>;

constexpr int most_pieces = 256;
constexpr int fine_pieces = 16;     ///< for each corner: the curve is found with at least as many
constexpr int most_steps = 60;      ///< of Levenberg and Marquardt
constexpr double settled = 1e-7;    ///< a step, in chords
constexpr double longest_side = 3;  ///< in chords
constexpr double evenness = 1;      ///< weight of equal edges, which the integral does not ask for

/// Parameters of the corners and tangents dr/du there: the periodic cubic spline, twice continuously differentiable.
struct Spline {
  Points corners, tangents;
  std::vector<double> width;  ///< of the parameter, from each corner to the next

  Vec3 at(std::size_t side, double t) const {
    const std::size_t next = (side + 1) % corners.size();
    const double s = 1 - t, h = width[side];
    return (1 + 2 * t) * s * s * corners[side] + t * s * s * h * tangents[side] + t * t * (3 - 2 * t) * corners[next] -
           t * t * s * h * tangents[next];
  }
};

Spline centripetal_spline(const Points& corners) {
  const int m = static_cast<int>(corners.size());
  Spline spline{corners, Points(corners.size()), {}};
  for (int k = 0; k < m; ++k) spline.width.push_back(std::sqrt((corners[(k + 1) % m] - corners[k]).norm()));
  std::vector<Eigen::Triplet<double>> entries;
  Eigen::MatrixXd rhs(m, 3);
  for (int k = 0; k < m; ++k) {
    const int before = (k + m - 1) % m, after = (k + 1) % m;
    const double a = 1 / spline.width[before], b = 1 / spline.width[k];
    entries.emplace_back(k, before, a);
    entries.emplace_back(k, k, 2 * (a + b));
    entries.emplace_back(k, after, b);
    rhs.row(k) = 3 * (a * a * (corners[k] - corners[before]) + b * b * (corners[after] - corners[k])).transpose();
  }
  Sparse A(m, m);
  A.setFromTriplets(entries.begin(), entries.end());
  // Symmetric and diagonally dominant: only corners that are not finite, or all in one place, have no solution.
  const auto solver = make_spd_solver();
  Eigen::MatrixXd tangents = Eigen::MatrixXd::Zero(m, 3);
  if (solver->factorize(A)) solver->solve(rhs, tangents);
  for (int k = 0; k < m; ++k) spline.tangents[k] = tangents.row(k).transpose();
  return spline;
}

/// Points at equal distances along each side, corners included.
Points sampled_evenly(const Spline& spline, int pieces) {
  constexpr int finer = 16;
  Points points;
  for (std::size_t side = 0; side < spline.corners.size(); ++side) {
    const int count = finer * pieces;
    std::vector<double> length{0};
    Vec3 last = spline.corners[side];
    for (int j = 1; j <= count; ++j) {
      const Vec3 next = spline.at(side, static_cast<double>(j) / count);
      length.push_back(length.back() + (next - last).norm());
      last = next;
    }
    points.push_back(spline.corners[side]);
    for (int i = 1; i < pieces; ++i) {
      const double wanted = length.back() * i / pieces;
      const auto above = std::upper_bound(length.begin() + 1, length.end() - 1, wanted);
      const double part = (wanted - above[-1]) / (above[0] - above[-1]);
      points.push_back(spline.at(side, (static_cast<double>(above - length.begin() - 1) + part) / count));
    }
  }
  return points;
}

/// What least squares are made of, around the edge from the second to the third of four points in a row: the variation of
/// the curvature vector across that edge, and by how much the edges at the second point differ.
using Scalar = Eigen::AutoDiffScalar<Eigen::Matrix<double, 12, 1>>;
using Vector = Eigen::Matrix<Scalar, 3, 1>;

Scalar length_of(const Vector& v) { return sqrt(Scalar(v[0] * v[0] + v[1] * v[1] + v[2] * v[2])); }

std::array<Scalar, 4> residuals_at(const std::array<Vec3, 4>& place, bool even) {
  std::array<Vector, 4> p;
  for (int k = 0; k < 4; ++k)
    for (int c = 0; c < 3; ++c) p[k][c] = Scalar(place[k][c], 12, 3 * k + c);
  std::array<Vector, 3> edge;
  std::array<Scalar, 3> l;
  for (int k = 0; k < 3; ++k) {
    for (int c = 0; c < 3; ++c) edge[k][c] = p[k + 1][c] - p[k][c];
    l[k] = length_of(edge[k]);
  }
  Vector change;  // of the curvature vector
  Scalar along(0);
  for (int c = 0; c < 3; ++c) {
    const Scalar t0 = edge[0][c] / l[0], t1 = edge[1][c] / l[1], t2 = edge[2][c] / l[2];
    change[c] = 2 * (t2 - t1) / (l[1] + l[2]) - 2 * (t1 - t0) / (l[0] + l[1]);
    along += change[c] * t1;
  }
  std::array<Scalar, 4> result;
  const Scalar root = sqrt(l[1]);
  for (int c = 0; c < 3; ++c) result[c] = (change[c] - along * edge[1][c] / l[1]) / root;
  result[3] = even ? Scalar(evenness * 2 * (l[1] - l[0]) / (l[1] + l[0])) : Scalar(0);
  return result;
}

/// The sum of squares over the whole curve, and what a Gauss-Newton step needs of it.
struct LeastSquares {
  double sum = 0;
  Sparse J;  ///< 4N by 3N; columns of corners are empty
  Eigen::VectorXd residual;
};

LeastSquares least_squares(const Points& points, int pieces) {
  const int N = static_cast<int>(points.size());
  LeastSquares result;
  result.residual.resize(4 * N);
  std::vector<Eigen::Triplet<double>> entries;
  for (int i = 0; i < N; ++i) {
    const std::array<int, 4> at{(i + N - 1) % N, i, (i + 1) % N, (i + 2) % N};
    const auto r = residuals_at({points[at[0]], points[at[1]], points[at[2]], points[at[3]]}, i % pieces != 0);
    for (int row = 0; row < 4; ++row) {
      result.residual[4 * i + row] = r[row].value();
      for (int k = 0; k < 12 && r[row].derivatives().size() == 12; ++k)
        if (at[k / 3] % pieces != 0) entries.emplace_back(4 * i + row, 3 * at[k / 3] + k % 3, r[row].derivatives()[k]);
    }
  }
  result.J.resize(4 * N, 3 * N);
  result.J.setFromTriplets(entries.begin(), entries.end());
  result.sum = result.residual.squaredNorm();
  return result;
}

/// @param points  in units of their chords' mean length
Points of_least_variation(Points points, int pieces) {
  LeastSquares now = least_squares(points, pieces);
  const auto solver = make_spd_solver();
  double mu = 1e-3;
  for (int step = 0; step < most_steps; ++step) {
    Sparse A = now.J.transpose() * now.J;
    Sparse diagonal(A.rows(), A.cols());
    diagonal.setIdentity();
    A += mu * diagonal;
    Eigen::MatrixXd move;
    if (!solver->factorize(A) || !solver->solve(-(now.J.transpose() * now.residual), move)) return points;
    Points moved = points;
    for (std::size_t i = 0; i < points.size(); ++i)
      if (i % pieces != 0) moved[i] += move.block<3, 1>(3 * static_cast<Eigen::Index>(i), 0);
    LeastSquares next = least_squares(moved, pieces);
    if (!(next.sum < now.sum)) {
      if (mu > 1e12) return points;
      mu *= 10;
      continue;
    }
    points = std::move(moved);
    now = std::move(next);
    mu = std::max(mu / 10, 1e-12);
    if (move.cwiseAbs().maxCoeff() < settled) break;
  }
  return points;
}

/// Of the longest side, in chords.
double bulge(const Points& points, const Points& corners, int pieces) {
  double worst = 0;
  for (std::size_t side = 0; side < corners.size(); ++side) {
    double length = 0;
    for (std::size_t i = side * pieces; i < (side + 1) * pieces; ++i)
      length += (points[(i + 1) % points.size()] - points[i]).norm();
    worst = std::max(worst, length / (corners[(side + 1) % corners.size()] - corners[side]).norm());
  }
  return worst;
}

}  // namespace

Points fair_closed_curve(const Points& corners, int pieces) {
  if (corners.size() < 3) throw InvalidArgument(say("a closed curve needs at least 3 points, not %1", corners.size()));
  if (pieces < 1 || pieces > most_pieces)
    throw InvalidArgument(say("a curve's side is divided into 1 to 256 pieces, not %1", pieces));
  double chord = 0;
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const double length = (corners[(k + 1) % corners.size()] - corners[k]).norm();
    if (!(length > 0)) throw InvalidArgument(say("two neighbouring points of the curve lie in one place"));
    chord += length / static_cast<double>(corners.size());
  }
  Points scaled;
  for (const Vec3& p : corners) scaled.push_back((p - corners[0]) / chord);
  const int fine = pieces * std::max(1, fine_pieces / pieces);
  const Points spline = sampled_evenly(centripetal_spline(scaled), fine);
  Points curve = of_least_variation(spline, fine);
  if (!(bulge(curve, scaled, fine) < longest_side)) curve = spline;
  Points result;
  for (std::size_t i = 0; i < curve.size(); i += fine / pieces)
    result.push_back(i % fine == 0 ? corners[i / fine] : Vec3(corners[0] + chord * curve[i]));
  return result;
}

}  // namespace loopmend
