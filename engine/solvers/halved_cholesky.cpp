#include "solvers/halved_cholesky.h"

#include "core/threads.h"
#include "solvers/dissection.h"
#include "solvers/factoring.h"

#include <cholmod.h>

#include <algorithm>
#include <array>
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

constexpr double least_for_threads_in_solve = 3e5;  ///< entries of the factors: below, starting a thread takes longer

class Common : public cholmod_common {
 public:
  Common() {
    cholmod_start(this);
    print = 0;  // a matrix that is not positive definite is our business, not the terminal's
    error_handler = nullptr;
    nmethods = 1;
    method[0].ordering = CHOLMOD_NATURAL;
    postorder = 0;  // the border must stay at the end
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
struct FreeDense {
  cholmod_common* common;
  void operator()(cholmod_dense* dense) const { cholmod_free_dense(&dense, common); }
};

/// The factors L Lᵀ of A(rows, rows), in the order of the rows. The last of them are the border, which is factored as if
/// there were no other half.
class Half {
 public:
  /// Symbolic. @param place  of each row of A: where it stands in `rows`, or -1
  void analyze(const MatrixGraph& graph, const std::vector<int>& rows, const std::vector<int>& place, int border) {
    take_pattern(graph, rows, place);
    border_factor_.resize(border, border);
    cholmod_sparse A = view();
    const NoThreadsWithin alone;
    factor_ = {cholmod_analyze(&A, common_.get()), FreeFactor{common_.get()}};
    if (!factor_) throw std::bad_alloc();
  }

  /// @returns false if this half is not positive definite.
  bool factorize(const SparseMatrix& A) {
    for (std::size_t k = 0; k < from_.size(); ++k) part_.valuePtr()[k] = A.valuePtr()[from_[k]];
    cholmod_sparse values = view();
    const NoThreadsWithin alone;
    cholmod_factorize(&values, factor_.get(), common_.get());
    if (common_->status != CHOLMOD_OK || factor_->minor != factor_->n) return false;
    copy_border_factor();
    return true;
  }

  int inner() const { return static_cast<int>(part_.rows() - border_factor_.rows()); }
  double entries() const { return static_cast<double>(factor_->xsize); }
  /// S Sᵀ, of the border in reverse order: upper triangle.
  Eigen::MatrixXd left_for_border() const {
    // Reversed it is an upper triangle U, and U Uᵀ is what LAPACK has.
    Eigen::MatrixXd left = border_factor_.reverse();
    const int n = static_cast<int>(left.rows());
    int info = 0;
    if (n > 0) dlauum_("U", &n, left.data(), &n, &info);
    return left;
  }
  /// From a matrix of the border in reverse order, upper triangle.
  void subtract_border(Eigen::MatrixXd& from) const {
    const Eigen::Index first = inner(), last = part_.rows() - 1;
    for (Eigen::Index j = first; j <= last; ++j)
      for (SparseMatrix::InnerIterator it(part_, j); it; ++it) from(last - it.row(), last - j) -= it.value();
  }

  /// @param y  b of the inner rows by any number; becomes what backward() goes on with. @returns −B A⁻¹ b, which the border's
  /// right-hand sides get
  Eigen::MatrixXd forward(Eigen::MatrixXd& y) const {
    y.conservativeResizeLike(Eigen::MatrixXd::Zero(part_.rows(), y.cols()));
    solve(CHOLMOD_L, y);
    Eigen::MatrixXd share(border_factor_.rows(), y.cols());
    for (Eigen::Index c = 0; c < y.cols(); ++c)  // one by one: Eigen is slow with a few columns
      share.col(c) = border_factor_.triangularView<Eigen::Lower>() * y.col(c).tail(share.rows());
    return share;
  }
  /// @param x_border  of the border rows. @param y  of forward(); becomes x of the inner and the border rows
  void backward(const Eigen::MatrixXd& x_border, Eigen::MatrixXd& y) const {
    for (Eigen::Index c = 0; c < y.cols(); ++c)
      y.col(c).tail(x_border.rows()) = border_factor_.triangularView<Eigen::Lower>().transpose() * x_border.col(c);
    solve(CHOLMOD_Lt, y);
  }

 private:
  void take_pattern(const MatrixGraph& graph, const std::vector<int>& rows, const std::vector<int>& place) {
    const int n = static_cast<int>(rows.size());
    const auto for_lower = [&](int i, const auto& visit) {
      for (int k = graph.begin[rows[i]]; k < graph.begin[rows[i] + 1]; ++k) {
        const int j = place[graph.neighbour[k]];
        if (j >= 0 && j < i) visit(j, graph.entry[k]);
      }
      if (graph.diagonal[rows[i]] >= 0) visit(i, graph.diagonal[rows[i]]);
    };
    part_.resize(n, n);
    int* outer = part_.outerIndexPtr();
    std::fill(outer, outer + n + 1, 0);
    for (int i = 0; i < n; ++i) for_lower(i, [&](int j, int) { ++outer[j + 1]; });
    std::partial_sum(outer, outer + n + 1, outer);
    part_.resizeNonZeros(outer[n]);
    from_.resize(outer[n]);
    std::vector<int> put(outer, outer + n);
    for (int i = 0; i < n; ++i)
      for_lower(i, [&](int j, int entry) {
        part_.innerIndexPtr()[put[j]] = i;
        from_[put[j]++] = entry;
      });
  }

  cholmod_sparse view() {
    cholmod_sparse A{};
    A.nrow = A.ncol = static_cast<std::size_t>(part_.rows());
    A.nzmax = from_.size();
    A.p = part_.outerIndexPtr();
    A.i = part_.innerIndexPtr();
    A.x = part_.valuePtr();
    A.stype = -1;
    A.itype = CHOLMOD_INT;
    A.xtype = CHOLMOD_REAL;
    A.dtype = CHOLMOD_DOUBLE;
    A.sorted = A.packed = 1;
    return A;
  }

  void copy_border_factor() {
    border_factor_.setZero();
    const cholmod_factor& L = *factor_;
    const auto *columns = static_cast<const int*>(L.super), *row_begin = static_cast<const int*>(L.pi),
               *value_begin = static_cast<const int*>(L.px), *rows = static_cast<const int*>(L.s);
    const auto* values = static_cast<const double*>(L.x);
    const int first = inner();
    for (int s = static_cast<int>(L.nsuper) - 1; s >= 0 && columns[s + 1] > first; --s)
      for (int j = std::max(first, columns[s]); j < columns[s + 1]; ++j) {
        const int height = row_begin[s + 1] - row_begin[s];
        const double* column = values + value_begin[s] + static_cast<std::ptrdiff_t>(j - columns[s]) * height;
        for (int k = j - columns[s]; k < height; ++k)
          border_factor_(rows[row_begin[s] + k] - first, j - first) = column[k];
      }
  }

  void solve(int system, Eigen::MatrixXd& x) const {
    cholmod_dense b{};
    b.nrow = b.d = static_cast<std::size_t>(x.rows());
    b.ncol = static_cast<std::size_t>(x.cols());
    b.nzmax = b.nrow * b.ncol;
    b.x = x.data();
    b.xtype = CHOLMOD_REAL;
    b.dtype = CHOLMOD_DOUBLE;
    const NoThreadsWithin alone;
    const std::unique_ptr<cholmod_dense, FreeDense> solution(cholmod_solve(system, factor_.get(), &b, common_.get()),
                                                             FreeDense{common_.get()});
    if (!solution) throw std::bad_alloc();
    x = Eigen::Map<const Eigen::MatrixXd>(static_cast<const double*>(solution->x), x.rows(), x.cols());
  }

  SparseMatrix part_;      ///< A(rows, rows), lower triangle
  std::vector<int> from_;  ///< where A has the entries of it
  std::unique_ptr<Common> common_ = std::make_unique<Common>();
  std::unique_ptr<cholmod_factor, FreeFactor> factor_;
  Eigen::MatrixXd border_factor_;  ///< S: of L, what belongs to the border; lower triangle, the rest is 0
};

/// A of the upper triangle becomes U, where A = UᵀU. @returns false if A is not positive definite.
bool cholesky_of_upper(Eigen::MatrixXd& A) {
  const int n = static_cast<int>(A.rows());
  int info = 0;
  if (n > 0) dpotrf_("U", &n, A.data(), &n, &info);
  return info == 0;
}

/// With rows in the order first half, second half, border: A = [A₁ 0 B₁ᵀ; 0 A₂ B₂ᵀ; B₁ B₂ C]. The factors of a half end with
/// Sₖ, where C − Bₖ Aₖ⁻¹ Bₖᵀ = Sₖ Sₖᵀ; when both halves are eliminated, S₁S₁ᵀ + S₂S₂ᵀ − C is left for the border.
class HalvedCholesky : public SpdSolver {
 public:
  HalvedCholesky(const SparseMatrix& A, const MatrixGraph& graph, const Dissection& dissection) {
    use_one_blas_thread();
    const auto begin = dissection.order.begin(), middle = begin + dissection.first, end = middle + dissection.second;
    border_.assign(end, dissection.order.end());
    rows_ = {std::vector<int>(begin, middle), std::vector<int>(middle, end)};
    for_halves(1, [&](int k) {
      std::vector<int> rows = rows_[k], place(A.rows(), -1);
      rows.insert(rows.end(), border_.begin(), border_.end());
      for (std::size_t i = 0; i < rows.size(); ++i) place[rows[i]] = static_cast<int>(i);
      halves_[k].analyze(graph, rows, place, static_cast<int>(border_.size()));
    });
  }

  bool factorize(const SparseMatrix& A) override {
    std::array<bool, 2> good{};
    std::array<Eigen::MatrixXd, 2> left;
    for_halves(1, [&](int k) {
      good[k] = halves_[k].factorize(A);
      if (good[k]) left[k] = halves_[k].left_for_border();
    });
    if (!good[0] || !good[1]) return false;
    border_factor_ = std::move(left[0]);
    border_factor_ += left[1];
    halves_[0].subtract_border(border_factor_);
    return cholesky_of_upper(border_factor_);
  }

  bool solve(const Eigen::MatrixXd& b, Eigen::MatrixXd& x) const override {
    const double worth = (halves_[0].entries() + halves_[1].entries()) / least_for_threads_in_solve;
    std::array<Eigen::MatrixXd, 2> y, share;
    for_halves(worth, [&](int k) {
      y[k] = b(rows_[k], Eigen::all);
      share[k] = halves_[k].forward(y[k]);
    });
    Eigen::MatrixXd x_border = (b(border_, Eigen::all) + share[0] + share[1]).colwise().reverse();
    for (Eigen::Index c = 0; c < x_border.cols(); ++c) {
      border_factor_.triangularView<Eigen::Upper>().transpose().solveInPlace(x_border.col(c));
      border_factor_.triangularView<Eigen::Upper>().solveInPlace(x_border.col(c));
    }
    x_border = x_border.colwise().reverse().eval();
    for_halves(worth, [&](int k) { halves_[k].backward(x_border, y[k]); });
    Eigen::MatrixXd solution(b.rows(), b.cols());
    for (int k : {0, 1}) solution(rows_[k], Eigen::all) = y[k].topRows(rows_[k].size());
    solution(border_, Eigen::all) = x_border;
    if (!solution.allFinite()) return false;
    x = std::move(solution);
    return true;
  }

 private:
  /// work(0) and work(1); by two threads if it is worth it, that is at least 1.
  template <class Work>
  static void for_halves(double worth, const Work& work) {
    if (worth < 1) {
      work(0);
      work(1);
    } else {
      side_by_side([&] { work(0); }, [&] { work(1); });
    }
  }

  std::array<std::vector<int>, 2> rows_;
  std::vector<int> border_;
  std::array<Half, 2> halves_;
  Eigen::MatrixXd border_factor_;  ///< upper triangle: of the border in reverse order UᵀU
};

}  // namespace

std::unique_ptr<SpdSolver> make_halved_cholesky(const SparseMatrix& A) {
  const MatrixGraph graph = graph_of(A);
  const Dissection dissection = dissect(graph);
  if (dissection.second == 0) return nullptr;
  return std::make_unique<HalvedCholesky>(A, graph, dissection);
}

}  // namespace loopmend
