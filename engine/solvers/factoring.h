// What all sparse factorisations here share. For the .cpp files of this folder alone.
#pragma once

#include <Eigen/SparseCore>

#include <algorithm>
#include <vector>

extern "C" void openblas_set_num_threads(int threads);

namespace loopmend {

/// OpenBLAS threads spin-wait and lose tenfold on a busy machine (NUMERICS §5); loops run in parallel instead.
inline void use_one_blas_thread() {
  static const bool done = (openblas_set_num_threads(1), true);
  static_cast<void>(done);
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
