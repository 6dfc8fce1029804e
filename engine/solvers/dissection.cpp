// SPDX-License-Identifier: GPL-3.0-or-later
#include "solvers/dissection.h"

#include "core/threads.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <utility>

namespace loopmend {

namespace {

constexpr int smallest_dissected = 200;  ///< rows of wide stencils: fewer fill up in any order
constexpr int most_parts = 1 << 24;      ///< ends a dissection that only ever splits off a few rows

class Dissector {
 public:
  Dissector(const MatrixGraph& graph, const CancelToken& cancel)
      : graph_(graph),
        cancel_(cancel),
        part_(graph.begin.size() - 1, 1),
        level_(part_.size()),
        order_(part_.size()),
        queue_(part_.size()) {
    std::iota(order_.begin(), order_.end(), 0);
  }

  Dissection halves() {
    const Cut cut = split(0, static_cast<int>(order_.size()), 1);
    parallel_invoke([&] { dissect(0, cut.lower, 2); }, [&] { dissect(cut.lower, cut.lower + cut.upper, 3); });
    return {std::move(order_), cut.lower, cut.upper};
  }

 private:
  /// Of a range of order_: so many rows on one side, then so many on the other; the rest lies between.
  struct Cut {
    int lower, upper;
  };
  using Rows = std::vector<int>::iterator;

  template <class Visit>
  void for_neighbours(int v, int part, const Visit& visit) const {
    for (int k = graph_.begin[v]; k < graph_.begin[v + 1]; ++k)
      if (part_[graph_.neighbour[k]] == part) visit(graph_.neighbour[k]);
  }

  /// Sorts a range by the distance from its first row; what is not connected to it comes at the end.
  void sort_by_distance(int begin, int end, int part) {
    for (int i = begin; i < end; ++i) level_[order_[i]] = -1;
    int seed = begin, put = begin;
    for (int take = begin; take < end; ++take) {
      if (take == put) {
        while (level_[order_[seed]] >= 0) ++seed;
        level_[order_[seed]] = take == begin ? 0 : level_[queue_[take - 1]] + 1;
        queue_[put++] = order_[seed];
      }
      for_neighbours(queue_[take], part, [&](int w) {
        if (level_[w] >= 0) return;
        level_[w] = level_[queue_[take]] + 1;
        queue_[put++] = w;
      });
    }
    std::copy(queue_.begin() + begin, queue_.begin() + end, order_.begin() + begin);
  }

  /// Of a sorted range: the rows at one distance.
  std::pair<Rows, Rows> at_distance(int begin, int end, int level) {
    const auto below = [&](int v) { return level_[v] < level; };
    const auto not_above = [&](int v) { return level_[v] <= level; };
    const Rows first = std::partition_point(order_.begin() + begin, order_.begin() + end, below);
    return {first, std::partition_point(first, order_.begin() + end, not_above)};
  }

  /// The distance at which few rows lie with about as many on either side.
  int narrowest_near_the_middle(int begin, int end) {
    const int middle = level_[order_[begin + (end - begin) / 2]];
    int narrowest = middle;
    double least = std::numeric_limits<double>::infinity();
    for (int level : {middle, middle - 1, middle + 1}) {
      const auto [first, last] = at_distance(begin, end, level);
      const auto lower = first - order_.begin() - begin, upper = end - (last - order_.begin());
      const double larger_side = static_cast<double>(std::max(lower, upper)) / (end - begin);
      const double cost = static_cast<double>(last - first) * (0.5 + larger_side);
      if (lower == 0 || upper == 0 || cost >= least) continue;
      least = cost;
      narrowest = level;
    }
    return narrowest;
  }

  Cut split(int begin, int end, int part) {
    if (end - begin <= smallest_dissected || part >= most_parts || cancel_.cancelled()) return {end - begin, 0};
    sort_by_distance(begin, end, part);
    std::swap(order_[begin], order_[end - 1]);
    sort_by_distance(begin, end, part);
    const auto rows = order_.begin();
    const int middle = narrowest_near_the_middle(begin, end);
    const auto [between, above] = at_distance(begin, end, middle);
    // Not all at the middle distance are needed to keep the sides apart.
    const auto needed = std::stable_partition(between, above, [&](int v) {
      bool touches = false;
      for_neighbours(v, part, [&](int w) { touches = touches || level_[w] > middle; });
      return !touches;
    });
    const auto separator = std::rotate(needed, above, rows + end);
    for (auto v = rows + begin; v != needed; ++v) part_[*v] = 2 * part;
    for (auto v = needed; v != separator; ++v) part_[*v] = 2 * part + 1;
    for (auto v = separator; v != rows + end; ++v) part_[*v] = 0;
    return {static_cast<int>(needed - rows) - begin, static_cast<int>(separator - needed)};
  }

  void dissect(int begin, int end, int part) {
    const Cut cut = split(begin, end, part);
    if (cut.lower == 0 || cut.upper == 0) return;
    dissect(begin, begin + cut.lower, 2 * part);
    dissect(begin + cut.lower, begin + cut.lower + cut.upper, 2 * part + 1);
  }

  const MatrixGraph& graph_;
  const CancelToken& cancel_;
  std::vector<int> part_, level_;  ///< by row; part 0: a separator's
  std::vector<int> order_, queue_;
};

}  // namespace

MatrixGraph graph_of(const Eigen::SparseMatrix<double>& lower) {
  const int n = static_cast<int>(lower.rows());
  MatrixGraph graph;
  graph.begin.assign(n + 1, 0);
  const auto for_couplings = [&](const auto& visit) {
    for (int j = 0; j < n; ++j)
      for (Eigen::SparseMatrix<double>::InnerIterator it(lower, j); it; ++it)
        if (it.row() > j) visit(static_cast<int>(it.row()), j);
  };
  for_couplings([&](int i, int j) { ++graph.begin[i + 1], ++graph.begin[j + 1]; });
  std::partial_sum(graph.begin.begin(), graph.begin.end(), graph.begin.begin());
  graph.neighbour.resize(graph.begin[n]);
  std::vector<int> put(graph.begin.begin(), graph.begin.end() - 1);
  for_couplings([&](int i, int j) {
    graph.neighbour[put[i]++] = j;
    graph.neighbour[put[j]++] = i;
  });
  return graph;
}

Dissection dissect(const MatrixGraph& graph, const CancelToken& cancel) { return Dissector(graph, cancel).halves(); }

}  // namespace loopmend
