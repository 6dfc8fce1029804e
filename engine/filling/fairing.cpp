// SPDX-License-Identifier: GPL-3.0-or-later
#include "filling/fairing.h"

#include "operators/congruence.h"
#include "operators/operator_set.h"
#include "solvers/linear_solver.h"

#include <algorithm>
#include <numeric>

namespace loopmend {

namespace {

Eigen::MatrixX3d matrix_of(const Points& points) {
  Eigen::MatrixX3d x(static_cast<Eigen::Index>(points.size()), 3);
  for (std::size_t i = 0; i < points.size(); ++i) x.row(static_cast<Eigen::Index>(i)) = points[i].transpose();
  return x;
}

/// A x = b for the points from `begin` on. @returns false, the points as they were, if A is not positive definite, or when
/// cancelled.
bool solve_for(const SparseMatrix& A, const Eigen::MatrixX3d& b, Points& points, int begin, const CancelToken& cancel) {
  const auto solver = make_spd_solver();
  Eigen::MatrixXd solution;
  if (!solver->factorize(A, cancel) || !solver->solve(b, solution)) return false;
  for (Eigen::Index i = 0; i < solution.rows(); ++i) points[begin + i] = solution.row(i).transpose();
  return true;
}

}  // namespace

bool minimise_quadratic_form(const SparseMatrix& A, Points& points, int begin, int end, const CancelToken& cancel) {
  const Eigen::Index n = end - begin;
  if (n == 0) return false;
  Eigen::MatrixX3d fixed = matrix_of(points);
  fixed.middleRows(begin, n).setZero();
  // A_ff x_f = −A_fc x_c; f the vertices [begin, end), c the others.
  return solve_for(A.block(begin, begin, n, n), -(A * fixed).middleRows(begin, n), points, begin, cancel);
}

Points minimal_surface_step(const Points& points, const Triangles& triangles, int locked, const CancelToken& cancel) {
  std::vector<int> faces(triangles.size());
  std::iota(faces.begin(), faces.end(), 0);
  Points result = points;
  const SparseMatrix C = clamped_cotan_stiffness(points, triangles, faces, robust_clamp);
  return minimise_quadratic_form(C, result, locked, static_cast<int>(points.size()), cancel) ? result : points;
}

Points linear_fairing(const Patch& patch, double bending, CotanClamp clamp, const CancelToken& cancel) {
  return linear_fairing(patch, Topology(patch.vertex_count(), patch.triangles), bending, clamp, cancel);
}

Points linear_fairing(const Patch& patch, const Topology& topology, double bending, CotanClamp clamp,
                      const CancelToken& cancel) {
  // Rows of ΔL with a full one-ring of data whose value the patch can change or that stand beside such rows.
  constexpr int reach = 2;
  const Eigen::VectorXd mass = barycentric_areas(patch.positions, patch.triangles);
  Eigen::VectorXd rows = mass.cwiseInverse(), bent = bending * mass;
  for (int i = 0; i < patch.vertex_count(); ++i)
    if (patch.ring[i] > reach || topology.is_boundary(i)) rows[i] = bent[i] = 0;
  std::vector<int> near;    // triangles at those rows
  std::vector<int> active;  // triangles with a Laplacian at each corner
  for (std::size_t f = 0; f < patch.triangles.size(); ++f) {
    const Triangle& t = patch.triangles[f];
    const int nearest = std::min({patch.ring[t[0]], patch.ring[t[1]], patch.ring[t[2]]});
    if (nearest <= reach) near.push_back(static_cast<int>(f));
    if (nearest <= 1 && rows[t[0]] > 0 && rows[t[1]] > 0 && rows[t[2]] > 0) active.push_back(static_cast<int>(f));
  }
  const SparseMatrix L = rows.asDiagonal() * clamped_cotan_stiffness(patch.positions, patch.triangles, near, clamp);
  SparseMatrix Q = clamped_cotan_stiffness(patch.positions, patch.triangles, active, clamp);
  if (bending > 0) Q += SparseMatrix(bent.asDiagonal());
  // L_fᵀ Q L_f x_f = −L_fᵀ Q L_c x_c; f the free vertices, c the others.
  const int n = patch.free_count;
  const RowSparseMatrix free_L = L.leftCols(n);
  Eigen::MatrixX3d fixed = matrix_of(patch.positions);
  fixed.topRows(n).setZero();
  Points result = patch.positions;
  solve_for(lower_congruence(free_L, Q), -(free_L.transpose() * (Q * (L * fixed))), result, 0, cancel);
  return result;
}

void extend_evenly(const Triangles& triangles, const std::vector<char>& fixed, Points& vectors) {
  const int count = static_cast<int>(vectors.size());
  std::vector<int> row(count, -1);
  int free = 0;
  for (int i = 0; i < count; ++i)
    if (!fixed[i]) row[i] = free++;
  std::vector<Eigen::Triplet<double>> triplets;
  Eigen::MatrixXd rhs = Eigen::MatrixXd::Zero(free, 3), solution;
  const auto add = [&](int i, int j) {
    if (row[i] < 0) return;
    triplets.emplace_back(row[i], row[i], 1);
    if (row[j] >= 0)
      triplets.emplace_back(row[i], row[j], -1);
    else
      rhs.row(row[i]) += vectors[j].transpose();
  };
  for (const Triangle& t : triangles)
    for (int k = 0; k < 3; ++k) {
      add(t[k], t[(k + 1) % 3]);
      add(t[(k + 1) % 3], t[k]);
    }
  SparseMatrix A(free, free);
  A.setFromTriplets(triplets.begin(), triplets.end());
  const auto solver = make_spd_solver();
  if (free == 0 || !solver->factorize(A) || !solver->solve(rhs, solution)) return;
  for (int i = 0; i < count; ++i)
    if (row[i] >= 0) vectors[i] = solution.row(row[i]).transpose();
}

Points graph_fairing(const Patch& patch, const CancelToken& cancel) {
  const int count = patch.vertex_count();
  std::vector<Eigen::Triplet<double>> all, inner;
  const auto add = [](std::vector<Eigen::Triplet<double>>& triplets, int i, int j) {
    triplets.emplace_back(i, i, 0.5);  // each edge is met from both of its triangles
    triplets.emplace_back(j, j, 0.5);
    triplets.emplace_back(i, j, -0.5);
    triplets.emplace_back(j, i, -0.5);
  };
  for (const Triangle& t : patch.triangles)
    for (int k = 0; k < 3; ++k) {
      const int i = t[k], j = t[(k + 1) % 3];
      add(all, i, j);
      if (std::min(patch.ring[i], patch.ring[j]) <= 1) add(inner, i, j);
    }
  SparseMatrix C(count, count), C_inner(count, count);
  C.setFromTriplets(all.begin(), all.end());
  C_inner.setFromTriplets(inner.begin(), inner.end());
  Eigen::VectorXd rows(count);
  for (int i = 0; i < count; ++i) rows[i] = patch.ring[i] <= 2 && C.coeff(i, i) > 0 ? 1 / C.coeff(i, i) : 0;
  const SparseMatrix L = rows.asDiagonal() * C;
  const SparseMatrix A = SparseMatrix(L.transpose()) * C_inner * L;
  Points result = patch.positions;
  return minimise_quadratic_form(A, result, 0, patch.free_count, cancel) ? result : patch.positions;
}

}  // namespace loopmend
