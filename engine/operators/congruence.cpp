#include "operators/congruence.h"

#include "core/threads.h"

#include <algorithm>
#include <atomic>

namespace loopmend {

namespace {

/// A sparse vector that is being summed up; its entries in no order.
class Accumulator {
 public:
  explicit Accumulator(Eigen::Index size) : value_(size, 0.0), present_(size, 0) {}
  void add(int i, double value) {
    if (!present_[i]) {
      present_[i] = 1;
      entries_.push_back(i);
    }
    value_[i] += value;
  }
  std::vector<int>& entries() { return entries_; }
  double value(int i) const { return value_[i]; }
  void clear() {
    for (int i : entries_) {
      value_[i] = 0;
      present_[i] = 0;
    }
    entries_.clear();
  }

 private:
  std::vector<double> value_;
  std::vector<char> present_;
  std::vector<int> entries_;
};

/// Columns of the result, one after another.
struct Columns {
  std::vector<int> length, index;
  std::vector<double> value;
};

/// Column j of Q B into `product`, then rows j and beyond of Bᵀ times that into `column`.
/// @param from  for each row of B a place among its entries; moved to the first at j or beyond, which is never far.
void multiply(const RowSparseMatrix& B, const SparseMatrix& B_by_columns, const SparseMatrix& Q, int j,
              std::vector<int>& from, Accumulator& product, Accumulator& column) {
  product.clear();
  column.clear();
  for (SparseMatrix::InnerIterator b(B_by_columns, j); b; ++b)
    for (SparseMatrix::InnerIterator q(Q, b.row()); q; ++q)
      product.add(static_cast<int>(q.row()), q.value() * b.value());
  for (int k : product.entries()) {
    const int begin = B.outerIndexPtr()[k], end = B.outerIndexPtr()[k + 1];
    int& e = from[k];
    while (e < end && B.innerIndexPtr()[e] < j) ++e;
    while (e > begin && B.innerIndexPtr()[e - 1] >= j) --e;
    const double factor = product.value(k);
    for (int place = e; place < end; ++place) column.add(B.innerIndexPtr()[place], factor * B.valuePtr()[place]);
  }
  std::sort(column.entries().begin(), column.entries().end());
}

SparseMatrix joined(const std::vector<Columns>& runs, Eigen::Index n) {
  SparseMatrix result(n, n);
  Eigen::Index entries = 0, column = 0;
  for (const Columns& run : runs) entries += static_cast<Eigen::Index>(run.index.size());
  result.resizeNonZeros(entries);
  int filled = 0;
  for (const Columns& run : runs) {
    std::copy(run.index.begin(), run.index.end(), result.innerIndexPtr() + filled);
    std::copy(run.value.begin(), run.value.end(), result.valuePtr() + filled);
    for (int length : run.length) {
      result.outerIndexPtr()[column++] = filled;
      filled += length;
    }
  }
  result.outerIndexPtr()[column] = filled;
  return result;
}

}  // namespace

SparseMatrix lower_congruence(const RowSparseMatrix& B, const SparseMatrix& Q) {
  const SparseMatrix B_by_columns = B;
  const int n = static_cast<int>(B.cols());
  const int run_length = n > least_for_threads ? 256 : 64;
  const int run_count = (n + run_length - 1) / run_length;
  std::vector<Columns> runs(run_count);
  std::atomic<int> next{0};
  share_work(static_cast<int>(B.rows()), [&] {
    Accumulator product(B.rows()), column(n);
    std::vector<int> from(B.outerIndexPtr(), B.outerIndexPtr() + B.rows());
    for (int run = next++; run < run_count; run = next++) {
      const int begin = run * run_length, end = std::min(n, begin + run_length);
      for (int j = begin; j < end; ++j) {
        multiply(B, B_by_columns, Q, j, from, product, column);
        runs[run].length.push_back(static_cast<int>(column.entries().size()));
        for (int i : column.entries()) {
          runs[run].index.push_back(i);
          runs[run].value.push_back(column.value(i));
        }
      }
    }
  });
  return joined(runs, n);
}

}  // namespace loopmend
