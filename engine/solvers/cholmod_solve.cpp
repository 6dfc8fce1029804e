// SPDX-License-Identifier: GPL-3.0-or-later
#include "solvers/cholmod_solve.h"

#include "solvers/factoring.h"

#include <cholmod.h>

#include <algorithm>
#include <cstddef>
#include <memory>
#include <new>

namespace loopmend {

namespace {

struct FreeDense {
  cholmod_common* common;
  void operator()(cholmod_dense* dense) const { cholmod_free_dense(&dense, common); }
};

}  // namespace

void solve_by_cholmod(int system, cholmod_factor& factor, cholmod_common& common, Eigen::MatrixXd& x) {
  const auto n = static_cast<std::size_t>(x.rows()), columns = static_cast<std::size_t>(x.cols());
  cholmod_dense b{};
  b.nrow = b.d = n;
  b.ncol = columns;
  b.nzmax = n * columns;
  b.x = x.data();
  b.xtype = CHOLMOD_REAL;
  b.dtype = CHOLMOD_DOUBLE;
  const NoThreadsWithin alone;
  const auto array = [&](std::size_t rows, std::size_t cols) {
    cholmod_dense* made = cholmod_allocate_dense(rows, cols, rows, CHOLMOD_REAL, &common);
    if (!made) throw std::bad_alloc();
    return std::unique_ptr<cholmod_dense, FreeDense>(made, {&common});
  };
  // Of just the sizes that it wants: others it frees, and asks for new ones.
  auto solution = array(n, columns);
  auto y = factor.is_super ? array(n, columns) : array(std::min<std::size_t>(columns, 4), n);
  auto e = factor.is_super ? array(columns, factor.maxesize) : nullptr;
  cholmod_dense *x_out = solution.release(), *y_out = y.release(), *e_out = e.release();
  const int good = cholmod_solve2(system, &factor, &b, nullptr, &x_out, nullptr, &y_out, &e_out, &common);
  solution.reset(x_out), y.reset(y_out), e.reset(e_out);
  if (!good) throw std::bad_alloc();
  x = Eigen::Map<const Eigen::MatrixXd>(static_cast<const double*>(solution->x), x.rows(), x.cols());
}

}  // namespace loopmend
