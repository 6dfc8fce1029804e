// SPDX-License-Identifier: GPL-3.0-or-later
#include "texture/chart.h"

#include "operators/operator_set.h"
#include "solvers/linear_solver.h"

#include <Eigen/Geometry>

#include <cmath>
#include <numeric>

namespace loopmend {

namespace {

double signed_area(const std::vector<Vec2>& at, const Triangle& t) {
  const Vec2 u = at[t[1]] - at[t[0]], v = at[t[2]] - at[t[0]];
  return (u.x() * v.y() - u.y() * v.x()) / 2;
}

/// Two points far from each other: the farthest from the first, and the farthest from that.
std::pair<int, int> far_points(const Points& points) {
  const auto farthest = [&](const Vec3& from) {
    int best = 0;
    for (std::size_t k = 0; k < points.size(); ++k)
      if ((points[k] - from).squaredNorm() > (points[best] - from).squaredNorm()) best = static_cast<int>(k);
    return best;
  };
  const int a = farthest(points.front());
  return {a, farthest(points[a])};
}

/// Entries of A, 2n by 2n: ½ (u, v) A (u, v) = ½ ∫ ‖∇u‖² + ‖∇v‖² − the area of the image.
std::vector<Eigen::Triplet<double>> conformal_energy(const Points& points, const Triangles& triangles) {
  const int n = static_cast<int>(points.size());
  std::vector<int> faces(triangles.size());
  std::iota(faces.begin(), faces.end(), 0);
  const SparseMatrix C = cotan_stiffness(points, triangles, faces);
  std::vector<Eigen::Triplet<double>> entries;
  for (int k = 0; k < C.outerSize(); ++k)
    for (SparseMatrix::InnerIterator it(C, k); it; ++it) {
      entries.emplace_back(it.row(), it.col(), it.value());
      entries.emplace_back(n + it.row(), n + it.col(), it.value());
    }
  for (const Triangle& t : triangles)
    for (int k = 0; k < 3; ++k) {  // area = ½ Σ (uᵢ vⱼ − uⱼ vᵢ) over its edges
      const int i = t[k], j = t[(k + 1) % 3];
      for (const auto& [row, col, sign] : {std::tuple(i, n + j, -1.0), std::tuple(j, n + i, 1.0)}) {
        entries.emplace_back(row, col, sign / 2);
        entries.emplace_back(col, row, sign / 2);
      }
    }
  return entries;
}

/// Scales the image of the first `own` triangles to their area in space. @returns false if one of them is turned over.
bool scale_to_area(const Points& points, const Triangles& triangles, std::size_t own, std::vector<Vec2>& flat) {
  double plane = 0, space = 0;
  for (std::size_t f = 0; f < own; ++f) {
    const Triangle& t = triangles[f];
    const double area = signed_area(flat, t);
    if (!(area > 0)) return false;
    plane += area;
    space += (points[t[1]] - points[t[0]]).cross(points[t[2]] - points[t[0]]).norm() / 2;
  }
  if (!(plane > 0) || !(space > 0)) return false;
  for (Vec2& p : flat) p *= std::sqrt(space / plane);
  return true;
}

}  // namespace

std::optional<std::vector<Vec2>> flatten(const Points& points, const Triangles& triangles, std::size_t own) {
  const int n = static_cast<int>(points.size());
  if (n < 3 || triangles.empty()) return {};
  const auto [first, second] = far_points(points);
  Eigen::VectorXd x = Eigen::VectorXd::Zero(2 * n);
  x[second] = (points[second] - points[first]).norm();
  std::vector<int> place(2 * static_cast<std::size_t>(n), -1);
  int free = 0;
  for (int k = 0; k < 2 * n; ++k)
    if (k % n != first && k % n != second) place[k] = free++;
  std::vector<Eigen::Triplet<double>> inner;
  Eigen::VectorXd b = Eigen::VectorXd::Zero(free);
  for (const auto& entry : conformal_energy(points, triangles)) {
    const int row = place[entry.row()], col = place[entry.col()];
    if (row < 0) continue;
    if (col < 0)
      b[row] -= entry.value() * x[entry.col()];
    else
      inner.emplace_back(row, col, entry.value());
  }
  SparseMatrix A(free, free);
  A.setFromTriplets(inner.begin(), inner.end());
  A.makeCompressed();
  const auto solver = make_spd_solver();
  Eigen::MatrixXd solution;
  if (!solver->factorize(A) || !solver->solve(b, solution)) return {};
  std::vector<Vec2> flat(points.size());
  for (int k = 0; k < n; ++k) {
    const auto value = [&](int unknown) { return place[unknown] < 0 ? x[unknown] : solution(place[unknown], 0); };
    flat[k] = {value(k), value(n + k)};
  }
  if (!scale_to_area(points, triangles, own, flat)) return {};
  return flat;
}

}  // namespace loopmend
