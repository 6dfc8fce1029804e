// SPDX-License-Identifier: GPL-3.0-or-later
// What all sparse factorisations here share. For the .cpp files of this folder alone.
#pragma once

#include <Eigen/SparseCore>

#include <algorithm>
#include <new>
#include <vector>

// Of OpenBLAS, where that is the BLAS; and of the OpenMP that CHOLMOD runs on.
extern "C" {
#ifdef LOOPMEND_OPENBLAS
void openblas_set_num_threads(int threads);
#endif
int omp_get_max_active_levels();
void omp_set_max_active_levels(int levels);
}

namespace loopmend {

/// OpenBLAS threads spin-wait and lose tenfold on a busy machine (docs/math/energy_to_matrix.md, "Linear solvers"); loops run in
/// parallel instead.
inline void use_one_blas_thread() {
#ifdef LOOPMEND_OPENBLAS
  static const bool done = (openblas_set_num_threads(1), true);
  static_cast<void>(done);
#endif
}

/// While it lives, libraries that this thread calls start no OpenMP threads of their own. CHOLMOD asks for four at every
/// supernode, whatever the machine has: on two idle cores a factor takes a quarter to a half longer with them, on busy ones
/// several times as long.
class NoThreadsWithin {
 public:
  NoThreadsWithin() : levels_(omp_get_max_active_levels()) { omp_set_max_active_levels(0); }
  ~NoThreadsWithin() { omp_set_max_active_levels(levels_); }
  NoThreadsWithin(const NoThreadsWithin&) = delete;
  NoThreadsWithin& operator=(const NoThreadsWithin&) = delete;

 private:
  int levels_;  ///< OpenMP keeps this by thread
};

/// Turns CHOLMOD's word on memory into the exception that says so. Everything else that goes wrong is a value.
/// @param status  cholmod_common::status. @throws std::bad_alloc
inline void check_memory(int status) {
  constexpr int out_of_memory = -2,
                too_large = -3;  // CHOLMOD_OUT_OF_MEMORY and CHOLMOD_TOO_LARGE, whose header stays out
  if (status == out_of_memory || status == too_large) throw std::bad_alloc();
}

/// Remembers a sparsity pattern, to tell whether a symbolic analysis still holds.
class Pattern {
 public:
  /// True if A has the pattern seen last; remembers A's.
  bool matches(const Eigen::SparseMatrix<double>& A) {
    const int *outer = A.outerIndexPtr(), *inner = A.innerIndexPtr();
    const bool same = static_cast<Eigen::Index>(outer_.size()) == A.outerSize() + 1 &&
                      std::equal(outer_.begin(), outer_.end(), outer) &&
                      std::equal(inner_.begin(), inner_.end(), inner);
    if (!same) {
      outer_.assign(outer, outer + A.outerSize() + 1);
      inner_.assign(inner, inner + A.nonZeros());
    }
    return same;
  }

 private:
  std::vector<int> outer_, inner_;
};

}  // namespace loopmend
