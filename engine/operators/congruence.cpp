// SPDX-License-Identifier: GPL-3.0-or-later
#include "operators/congruence.h"

#include "core/threads.h"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <utility>

namespace loopmend {

namespace {

constexpr int columns_at_a_time = 128;  ///< columns that a thread takes at a time

/// A sparse vector that is being summed up; its entries in the order in which they came.
class Product {
 public:
  explicit Product(Eigen::Index size) : value_(size, 0.0), present_(size, 0) {}
  void add(int i, double value) {
    if (!present_[i]) {
      present_[i] = 1;
      entries_.push_back(i);
    }
    value_[i] += value;
  }
  /// visit(i, value) for all entries; leaves zero.
  template <class Visit>
  void drain(const Visit& visit) {
    for (int i : entries_) {
      visit(i, std::exchange(value_[i], 0.0));
      present_[i] = 0;
    }
    entries_.clear();
  }

 private:
  std::vector<double> value_;
  std::vector<char> present_;
  std::vector<int> entries_;
};

/// The same, but its entries come out by their numbers: a bit for each that is present, and a bit for each word of those.
/// To sort them would take most of the time.
class Column {
 public:
  explicit Column(Eigen::Index size)
      : value_(size, 0.0),
        words_(size / 64 + 1, 0),
        filled_(words_.size() / 64 + 1, 0) {}
  void add(int i, double value) {
    words_[i / 64] |= bit(i);
    filled_[i / 4096] |= bit(i / 64);
    value_[i] += value;
  }
  template <class Visit>
  void drain(const Visit& visit) {
    for (std::size_t block = 0; block < filled_.size(); ++block)
      for (std::uint64_t& filled = filled_[block]; filled != 0; filled &= filled - 1) {
        const std::size_t word = 64 * block + std::countr_zero(filled);
        for (std::uint64_t& left = words_[word]; left != 0; left &= left - 1) {
          const int i = static_cast<int>(64 * word) + std::countr_zero(left);
          visit(i, std::exchange(value_[i], 0.0));
        }
      }
  }

 private:
  static std::uint64_t bit(int i) { return std::uint64_t{1} << (i % 64); }

  std::vector<double> value_;
  std::vector<std::uint64_t> words_, filled_;
};

/// Columns of the result, one after another.
struct Columns {
  std::vector<int> length, index;
  std::vector<double> value;
};

/// Column j of Q B into `product`, then rows j and beyond of Bᵀ times that into `column`. Both are empty before; `product`
/// is so afterwards.
/// @param from  for each row of B a place among its entries; moved to the first at j or beyond, which is never far.
void multiply(const RowSparseMatrix& B, const SparseMatrix& B_by_columns, const SparseMatrix& Q, int j,
              std::vector<int>& from, Product& product, Column& column) {
  for (SparseMatrix::InnerIterator b(B_by_columns, j); b; ++b)
    for (SparseMatrix::InnerIterator q(Q, b.row()); q; ++q)
      product.add(static_cast<int>(q.row()), q.value() * b.value());
  product.drain([&](int k, double factor) {
    const int begin = B.outerIndexPtr()[k], end = B.outerIndexPtr()[k + 1];
    int& e = from[k];
    while (e < end && B.innerIndexPtr()[e] < j) ++e;
    while (e > begin && B.innerIndexPtr()[e - 1] >= j) --e;
    for (int place = e; place < end; ++place) column.add(B.innerIndexPtr()[place], factor * B.valuePtr()[place]);
  });
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
  struct Scratch {
    Product product;
    Column column;
    std::vector<int> from;
  };
  const auto make_scratch = [&] {
    return Scratch{Product(B.rows()), Column(n), {B.outerIndexPtr(), B.outerIndexPtr() + B.rows()}};
  };
  std::vector<Columns> runs((n + columns_at_a_time - 1) / columns_at_a_time);
  parallel_for(0, static_cast<int>(runs.size()), 1, make_scratch, [&](int run, Scratch& scratch) {
    Columns& columns = runs[run];
    for (int j = run * columns_at_a_time; j < std::min(n, (run + 1) * columns_at_a_time); ++j) {
      multiply(B, B_by_columns, Q, j, scratch.from, scratch.product, scratch.column);
      const std::size_t before = columns.index.size();
      scratch.column.drain([&](int i, double value) {
        columns.index.push_back(i);
        columns.value.push_back(value);
      });
      columns.length.push_back(static_cast<int>(columns.index.size() - before));
    }
  });
  return joined(runs, n);
}

}  // namespace loopmend
