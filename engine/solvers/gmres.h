// SPDX-License-Identifier: GPL-3.0-or-later
// GMRES for systems that are nearly symmetric. For the .cpp files of this folder alone.
#pragma once

#include "solvers/linear_solver.h"

namespace loopmend {

struct GmresReport {
  int iterations = 0;
  double left = 1;  ///< the residual's norm, relative to that of b; not finite if the iteration broke down
};

/// A x = b from x = 0, preconditioned by P, whose factors are given; until `left` is at most `wanted`, or `most` iterations
/// are done. All norms are those of P: ‖r‖² = rᵀ P⁻¹ r, so where P is near A, `left` is near the error of x in the energy
/// of A, relative to x. (Saad, Iterative Methods for Sparse Linear Systems, 2nd ed., §9.4: split preconditioning without
/// the factors' halves.) A residual measured without such weights sees the low frequencies alone.
/// @param promising  given up after `trial` iterations if more than this is left by then
/// @param x  n, written always
/// @returns when cancelled, what is left by then
struct GmresLimits {
  double wanted = 1e-6;
  int most = 120;
  int trial = 120;
  double promising = 1;
};
GmresReport gmres(const GeneralSystem& system, const SpdSolver& factors, const Eigen::VectorXd& b,
                  const GmresLimits& limits, Eigen::VectorXd& x, const CancelToken& cancel);

}  // namespace loopmend
