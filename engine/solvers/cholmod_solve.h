// SPDX-License-Identifier: GPL-3.0-or-later
// Solving by CHOLMOD's factors where memory may be short.
#pragma once

#include <Eigen/Core>

struct cholmod_factor_struct;
struct cholmod_common_struct;

namespace loopmend {

/// CHOLMOD's own cholmod_solve() asks for two work arrays, looks only at what became of the second, and writes through the first
/// where that was refused (SuiteSparse 5.12). Here it finds both, and asks for none.
/// @param system  CHOLMOD_A, CHOLMOD_L, ...
/// @param x  n by any number: the right-hand sides; becomes the solutions. @throws std::bad_alloc
void solve_by_cholmod(int system, cholmod_factor_struct& factor, cholmod_common_struct& common, Eigen::MatrixXd& x);

}  // namespace loopmend
