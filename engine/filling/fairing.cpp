#include "filling/fairing.h"

#include "operators/operator_set.h"
#include "solvers/linear_solver.h"

#include <numeric>

namespace loopmend {

namespace {

/// Solves Q_ff x_f = −Q_fc x_c for the three coordinates; f the vertices [begin, end), c the others.
bool solve_quadratic_form(const SparseMatrix& Q, Points& points, int begin, int end) {
  const Eigen::Index n = end - begin;
  if (n == 0) return false;
  const SparseMatrix A = Q.block(begin, begin, n, n);
  Eigen::MatrixX3d x(static_cast<Eigen::Index>(points.size()), 3);
  for (std::size_t i = 0; i < points.size(); ++i) x.row(static_cast<Eigen::Index>(i)) = points[i].transpose();
  Eigen::MatrixX3d fixed = x;
  fixed.middleRows(begin, n).setZero();
  const Eigen::MatrixX3d rhs = -(Q * fixed).middleRows(begin, n);
  Eigen::MatrixXd solution;
  const auto solver = make_spd_solver();
  if (!solver->factorize(A) || !solver->solve(rhs, solution)) return false;
  for (int i = begin; i < end; ++i) points[i] = solution.row(i - begin).transpose();
  return true;
}

}  // namespace

Points minimal_surface_step(const Points& points, const Triangles& triangles, int locked) {
  std::vector<int> faces(triangles.size());
  std::iota(faces.begin(), faces.end(), 0);
  Points result = points;
  const SparseMatrix C = clamped_cotan_stiffness(points, triangles, faces, robust_clamp);
  return solve_quadratic_form(C, result, locked, static_cast<int>(points.size())) ? result : points;
}

}  // namespace loopmend
