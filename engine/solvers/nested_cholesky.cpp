// SPDX-License-Identifier: GPL-3.0-or-later
#include "solvers/nested_cholesky.h"

#include "core/threads.h"
#include "solvers/cholmod_solve.h"
#include "solvers/dissection.h"
#include "solvers/factoring.h"

#include <cholmod.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <new>
#include <numeric>
#include <utility>

// LAPACK, of OpenBLAS.
extern "C" {
void dlauum_(const char* uplo, const int* n, double* a, const int* lda, int* info);
void dpotrf_(const char* uplo, const int* n, double* a, const int* lda, int* info);
}

namespace loopmend {

namespace {

using SparseMatrix = Eigen::SparseMatrix<double>;

class Common : public cholmod_common {
 public:
  Common() {
    cholmod_start(this);
    print = 0;  // a matrix that is not positive definite is our business, not the terminal's
    error_handler = nullptr;
    nmethods = 1;
    method[0].ordering = CHOLMOD_NATURAL;
    postorder = 0;  // the separator must stay at the end
    supernodal = CHOLMOD_SUPERNODAL;
  }
  ~Common() { cholmod_finish(this); }
  Common(const Common&) = delete;
  Common& operator=(const Common&) = delete;
};

struct FreeFactor {
  cholmod_common* common;
  void operator()(cholmod_factor* factor) const { cholmod_free_factor(&factor, common); }
};

/// The factors L Lᵀ of A(rows, rows), in the order of the rows. The last of them are the separator, which is factored as if
/// there were no other half.
class Half {
 public:
  /// Symbolic. @param rows  of A
  void analyze(const SparseMatrix& A, const std::vector<int>& rows, int separator) {
    separator_ = separator;
    size_ = static_cast<int>(rows.size());
    place_.assign(A.rows(), -1);
    for (int i = 0; i < size_; ++i) place_[rows[i]] = i;
    SparseMatrix part = part_of(A);
    cholmod_sparse pattern = view(part);
    const NoThreadsWithin alone;
    factor_ = {cholmod_analyze(&pattern, common_.get()), FreeFactor{common_.get()}};
    if (!factor_) throw std::bad_alloc();
  }

  /// @returns false if this half is not positive definite. CHOLMOD cannot be interrupted.
  bool factorize(const SparseMatrix& A) {
    SparseMatrix part = part_of(A);
    cholmod_sparse values = view(part);
    const NoThreadsWithin alone;
    cholmod_factorize(&values, factor_.get(), common_.get());
    check_memory(common_->status);
    return common_->status == CHOLMOD_OK && factor_->minor == factor_->n;
  }

  /// F Fᵀ, where F is the part of L that belongs to the separator; the separator in reverse order, upper triangle.
  Eigen::MatrixXd schur_complement() const {
    // Reversed, F is an upper triangle, and F Fᵀ is what LAPACK has.
    Eigen::MatrixXd left = Eigen::MatrixXd::Zero(separator_, separator_);
    for_schur_blocks([&](int begin, const auto& block, const int* rows) {
      for (Eigen::Index j = 0; j < block.cols(); ++j)
        for (Eigen::Index k = j; k < block.rows(); ++k)
          left(separator_ - 1 - rows[k], separator_ - 1 - begin - j) = block(k, j);
    });
    int info = 0;
    if (separator_ > 0) dlauum_("U", &separator_, left.data(), &separator_, &info);
    return left;
  }

  /// @param y  b of the inner rows by any number; becomes what backward() goes on with. @returns −B A⁻¹ b, which the separator's
  /// right-hand sides get
  Eigen::MatrixXd forward(Eigen::MatrixXd& y) const {
    y.conservativeResizeLike(Eigen::MatrixXd::Zero(size_, y.cols()));
    solve(CHOLMOD_L, y);
    Eigen::MatrixXd share = Eigen::MatrixXd::Zero(separator_, y.cols());
    for (Eigen::Index c = 0; c < y.cols(); ++c)  // one by one: Eigen is slow with a few columns
      for_schur_blocks([&](int begin, const auto& block, const int* rows) {
        const Eigen::Index width = block.cols(), below = block.rows() - width;
        const auto z = y.col(c).tail(separator_).segment(begin, width);
        share.col(c).segment(begin, width) += block.topRows(width).template triangularView<Eigen::Lower>() * z;
        const Eigen::VectorXd reached = block.bottomRows(below) * z;
        for (Eigen::Index k = 0; k < below; ++k) share(rows[width + k], c) += reached[k];
      });
    return share;
  }
  /// @param x_separator  of the separator rows. @param y  of forward(); becomes x of the inner and the separator rows
  void backward(const Eigen::MatrixXd& x_separator, Eigen::MatrixXd& y) const {
    for (Eigen::Index c = 0; c < y.cols(); ++c)
      for_schur_blocks([&](int begin, const auto& block, const int* rows) {
        const Eigen::Index width = block.cols(), below = block.rows() - width;
        Eigen::VectorXd reached(below);
        for (Eigen::Index k = 0; k < below; ++k) reached[k] = x_separator(rows[width + k], c);
        auto z = y.col(c).tail(separator_).segment(begin, width);
        z = block.topRows(width).template triangularView<Eigen::Lower>().transpose() *
            x_separator.col(c).segment(begin, width);
        z += block.bottomRows(below).transpose() * reached;
      });
    solve(CHOLMOD_Lt, y);
  }

  /// log |A₁|: of the rows that do not belong to the separator.
  double inner_log_determinant() const {
    const cholmod_factor& L = *factor_;
    const auto *columns = static_cast<const int*>(L.super), *row_begin = static_cast<const int*>(L.pi),
               *value_begin = static_cast<const int*>(L.px);
    const int inner = size_ - separator_;
    double sum = 0;
    for (int s = 0; s < static_cast<int>(L.nsuper); ++s) {
      const std::ptrdiff_t height = row_begin[s + 1] - row_begin[s];
      const double* values = static_cast<const double*>(L.x) + value_begin[s];
      for (int j = columns[s]; j < std::min(columns[s + 1], inner); ++j)
        sum += 2 * std::log(values[(j - columns[s]) * (height + 1)]);
    }
    return sum;
  }

 private:
  /// A(rows, rows), lower triangle.
  SparseMatrix part_of(const SparseMatrix& A) const {
    const auto for_entries = [&](const auto& visit) {
      for (int j = 0; j < A.outerSize(); ++j) {
        if (place_[j] < 0) continue;
        for (SparseMatrix::InnerIterator it(A, j); it; ++it)
          if (it.row() >= j && place_[it.row()] >= 0)
            visit(std::max(place_[it.row()], place_[j]), std::min(place_[it.row()], place_[j]), it.value());
      }
    };
    SparseMatrix part(size_, size_);
    int* outer = part.outerIndexPtr();
    for_entries([&](int, int j, double) { ++outer[j + 1]; });
    std::partial_sum(outer, outer + size_ + 1, outer);
    part.resizeNonZeros(outer[size_]);
    std::vector<int> put(outer, outer + size_);
    for_entries([&](int i, int j, double value) {
      part.innerIndexPtr()[put[j]] = i;
      part.valuePtr()[put[j]++] = value;
    });
    return part;
  }

  /// What CHOLMOD takes; rows in no order within a column.
  static cholmod_sparse view(SparseMatrix& part) {
    cholmod_sparse A{};
    A.nrow = A.ncol = static_cast<std::size_t>(part.rows());
    A.nzmax = static_cast<std::size_t>(part.nonZeros());
    A.p = part.outerIndexPtr();
    A.i = part.innerIndexPtr();
    A.x = part.valuePtr();
    A.stype = -1;
    A.itype = CHOLMOD_INT;
    A.xtype = CHOLMOD_REAL;
    A.dtype = CHOLMOD_DOUBLE;
    A.packed = 1;
    return A;
  }

  /// visit(begin, block, rows) for the blocks of columns that F has in CHOLMOD's supernodes: the columns begin, begin + 1, …
  /// of it, from the diagonal on (the upper triangle of the topmost rows means nothing), and the rows of F that these are.
  template <class Visit>
  void for_schur_blocks(const Visit& visit) const {
    const cholmod_factor& L = *factor_;
    const auto *columns = static_cast<const int*>(L.super), *row_begin = static_cast<const int*>(L.pi),
               *value_begin = static_cast<const int*>(L.px), *rows = static_cast<const int*>(L.s);
    const int first = size_ - separator_;
    std::vector<int> of_separator;
    for (int s = static_cast<int>(L.nsuper) - 1; s >= 0 && columns[s + 1] > first; --s) {
      const int begin = std::max(first, columns[s]), skip = begin - columns[s];
      const int height = row_begin[s + 1] - row_begin[s];
      of_separator.assign(rows + row_begin[s] + skip, rows + row_begin[s + 1]);
      for (int& row : of_separator) row -= first;
      const double* values = static_cast<const double*>(L.x) + value_begin[s];
      const Eigen::Map<const Eigen::MatrixXd, 0, Eigen::OuterStride<>> block(
          values + static_cast<std::ptrdiff_t>(skip) * height + skip, height - skip, columns[s + 1] - begin,
          Eigen::OuterStride<>(height));
      visit(begin - first, block, of_separator.data());
    }
  }

  void solve(int system, Eigen::MatrixXd& x) const { solve_by_cholmod(system, *factor_, *common_, x); }

  int size_ = 0, separator_ = 0;  ///< rows; the last of them
  std::vector<int> place_;        ///< of each row of A: where it stands among the rows, or -1
  std::unique_ptr<Common> common_ = std::make_unique<Common>();
  std::unique_ptr<cholmod_factor, FreeFactor> factor_;
};

/// A of the upper triangle becomes U, where A = UᵀU. @returns false if A is not positive definite.
bool cholesky_of_upper(Eigen::MatrixXd& A) {
  const int n = static_cast<int>(A.rows());
  int info = 0;
  if (n > 0) dpotrf_("U", &n, A.data(), &n, &info);
  return info == 0;
}

/// With rows in the order first half, second half, separator: A = [A₁ 0 B₁ᵀ; 0 A₂ B₂ᵀ; B₁ B₂ C]. The factors of a half end with
/// Fₖ, where C − Bₖ Aₖ⁻¹ Bₖᵀ = Fₖ Fₖᵀ; when both halves are eliminated, F₁F₁ᵀ + F₂F₂ᵀ − C is left for the separator.
class NestedCholesky : public SpdSolver {
 public:
  NestedCholesky(const SparseMatrix& A, const Dissection& dissection) {
    use_one_blas_thread();
    const auto begin = dissection.order.begin(), middle = begin + dissection.first, end = middle + dissection.second;
    separator_.assign(end, dissection.order.end());
    rows_ = {std::vector<int>(begin, middle), std::vector<int>(middle, end)};
    for_halves([&](int k) {
      std::vector<int> rows = rows_[k];
      rows.insert(rows.end(), separator_.begin(), separator_.end());
      halves_[k].analyze(A, rows, static_cast<int>(separator_.size()));
    });
  }

  bool factorize(const SparseMatrix& A, const CancelToken& cancel) override {
    std::array<bool, 2> good{};
    std::array<Eigen::MatrixXd, 2> left;
    for_halves([&](int k) {
      good[k] = !cancel.cancelled() && halves_[k].factorize(A);
      if (good[k] && !cancel.cancelled()) left[k] = halves_[k].schur_complement();
    });
    if (!good[0] || !good[1] || cancel.cancelled()) return false;
    schur_factor_ = std::move(left[0]);
    schur_factor_ += left[1];
    subtract_separator_block(A);
    return cholesky_of_upper(schur_factor_);
  }

  bool solve(const Eigen::MatrixXd& b, Eigen::MatrixXd& x) const override {
    std::array<Eigen::MatrixXd, 2> y, share;
    for_halves([&](int k) {
      y[k] = b(rows_[k], Eigen::all);
      share[k] = halves_[k].forward(y[k]);
    });
    Eigen::MatrixXd x_separator = (b(separator_, Eigen::all) + share[0] + share[1]).colwise().reverse();
    for (Eigen::Index c = 0; c < x_separator.cols(); ++c) {
      schur_factor_.triangularView<Eigen::Upper>().transpose().solveInPlace(x_separator.col(c));
      schur_factor_.triangularView<Eigen::Upper>().solveInPlace(x_separator.col(c));
    }
    x_separator = x_separator.colwise().reverse().eval();
    for_halves([&](int k) { halves_[k].backward(x_separator, y[k]); });
    Eigen::MatrixXd solution(b.rows(), b.cols());
    for (int k : {0, 1}) solution(rows_[k], Eigen::all) = y[k].topRows(rows_[k].size());
    solution(separator_, Eigen::all) = x_separator;
    if (!solution.allFinite()) return false;
    x = std::move(solution);
    return true;
  }

  double log_determinant() const override {
    return halves_[0].inner_log_determinant() + halves_[1].inner_log_determinant() +
           2 * schur_factor_.diagonal().array().log().sum();
  }

 private:
  template <class Work>
  static void for_halves(const Work& work) {
    parallel_invoke([&] { work(0); }, [&] { work(1); });
  }

  /// C, from the upper triangle of the separator in reverse order.
  void subtract_separator_block(const SparseMatrix& A) {
    const int last = static_cast<int>(separator_.size()) - 1;
    std::vector<int> place(A.rows(), -1);
    for (int i = 0; i <= last; ++i) place[separator_[i]] = last - i;
    for (int j : separator_)
      for (SparseMatrix::InnerIterator it(A, j); it; ++it)
        if (it.row() >= j && place[it.row()] >= 0)
          schur_factor_(std::min(place[it.row()], place[j]), std::max(place[it.row()], place[j])) -= it.value();
  }

  std::array<std::vector<int>, 2> rows_;
  std::vector<int> separator_;
  std::array<Half, 2> halves_;
  Eigen::MatrixXd schur_factor_;  ///< upper triangle: of the separator in reverse order UᵀU
};

}  // namespace

std::unique_ptr<SpdSolver> make_nested_cholesky(const SparseMatrix& A, const CancelToken& cancel) {
  const Dissection dissection = dissect(graph_of(A), cancel);
  if (dissection.second == 0 || cancel.cancelled()) return nullptr;
  return std::make_unique<NestedCholesky>(A, dissection);
}

}  // namespace loopmend
