// SPDX-License-Identifier: GPL-3.0-or-later
#include "edges/face_labels.h"

#include <boost/graph/adjacency_list.hpp>
#include <boost/graph/boykov_kolmogorov_max_flow.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>

namespace loopmend {

namespace {

constexpr double price_of_length =
    0.02;  ///< of an edge between two sides whose surfaces meet there, in mean edges of gap
constexpr double share_off_seam = 0.05;  ///< of the distance from where two surfaces meet
constexpr double parallel = 0.05;        ///< sine of the angle below which two surfaces do not meet
constexpr int most_sweeps = 4;
constexpr double resolution = 1e9;  ///< of capacities, which are whole numbers, in the largest of them

using Traits = boost::adjacency_list_traits<boost::vecS, boost::vecS, boost::directedS>;
using Capacity = long long;
// clang-format off
using FlowGraph = boost::adjacency_list<
    boost::vecS, boost::vecS, boost::directedS,
    boost::property<boost::vertex_index_t, long,
    boost::property<boost::vertex_color_t, boost::default_color_type,
    boost::property<boost::vertex_distance_t, long,
    boost::property<boost::vertex_predecessor_t, Traits::edge_descriptor>>>>,
    boost::property<boost::edge_capacity_t, Capacity,
    boost::property<boost::edge_residual_capacity_t, Capacity,
    boost::property<boost::edge_reverse_t, Traits::edge_descriptor>>>>;
// clang-format on

/// An edge of the domain. `other` is −1 on the loop.
struct DomainEdge {
  int a = 0, b = 0, face = 0, other = -1;
  double length = 0;
};

/// E(x) = Σ_i u_i x_i + Σ_ij w_ij (1 − x_i) x_j over x in {0, 1}, least by a cut.
class BinaryProblem {
 public:
  explicit BinaryProblem(int count) : unary_(count, 0) {}
  void add_unary(int i, double cost) { unary_[i] += cost; }
  void add_pair(int i, int j, double cost) {
    if (cost > 0) pairs_.push_back({i, j, cost});
  }

  std::vector<char> solve() const {
    double largest = 0;
    for (double u : unary_) largest = std::max(largest, std::abs(u));
    for (const Pair& p : pairs_) largest = std::max(largest, p.cost);
    const auto n = unary_.size();
    std::vector<char> x(n, 0);
    if (!(largest > 0)) return x;
    const double scale = resolution / largest;
    FlowGraph graph(n + 2);
    const auto source = n, sink = n + 1;
    const auto connect = [&](std::size_t from, std::size_t to, double cost) {
      const auto there = boost::add_edge(from, to, graph).first, back = boost::add_edge(to, from, graph).first;
      boost::put(boost::edge_capacity, graph, there, static_cast<Capacity>(std::llround(cost * scale)));
      boost::put(boost::edge_capacity, graph, back, 0);
      boost::put(boost::edge_reverse, graph, there, back);
      boost::put(boost::edge_reverse, graph, back, there);
    };
    for (std::size_t i = 0; i < n; ++i)
      if (unary_[i] > 0)
        connect(source, i, unary_[i]);
      else if (unary_[i] < 0)
        connect(i, sink, -unary_[i]);
    for (const Pair& p : pairs_) connect(p.i, p.j, p.cost);
    boost::boykov_kolmogorov_max_flow(graph, source, sink);
    const auto color = boost::get(boost::vertex_color, graph);
    // The source's side keeps, x = 0; what neither end reaches keeps, too.
    for (std::size_t i = 0; i < n; ++i) x[i] = color[i] == boost::color_traits<boost::default_color_type>::white();
    return x;
  }

 private:
  struct Pair {
    int i, j;
    double cost;
  };
  std::vector<double> unary_;
  std::vector<Pair> pairs_;
};

class Labelling {
 public:
  Labelling(const Domain& domain, const Sides& sides, SeamPrice price) : domain_(domain), sides_(sides), price_(price) {
    collect_edges();
    for (const SideSurface& surface : sides.surfaces) {
      feet_.emplace_back();
      normals_.emplace_back();
      for (const Vec3& p : domain.points) {
        feet_.back().push_back(surface.foot(p));
        normals_.back().push_back(surface.normal_at(feet_.back().back()));
      }
    }
  }

  std::vector<int> run(const CancelToken& cancel) {
    std::vector<int> labels = nearest();
    double best = energy(labels);
    for (int sweep = 0; sweep < most_sweeps; ++sweep) {
      const double before = best;
      for (int side = 0; side < static_cast<int>(feet_.size()); ++side) {
        if (cancel.cancelled()) return {};
        std::vector<int> next = expanded(labels, side);
        const double cost = energy(next);
        if (!(cost < best)) continue;
        labels = std::move(next);
        best = cost;
      }
      if (!(best < before)) break;
    }
    if (price_ == SeamPrice::off_seam) open_pinches(labels);
    return labels;
  }

 private:
  void collect_edges() {
    std::map<std::pair<int, int>, std::size_t> known;
    double sum = 0;
    for (int f = 0; f < static_cast<int>(domain_.triangles.size()); ++f)
      for (int k = 0; k < 3; ++k) {
        const int a = domain_.triangles[f][k], b = domain_.triangles[f][(k + 1) % 3];
        const auto [entry, is_new] = known.emplace(std::minmax(a, b), edges_.size());
        if (!is_new) {
          edges_[entry->second].other = f;
          continue;
        }
        edges_.push_back({a, b, f, -1, (domain_.points[a] - domain_.points[b]).norm()});
        sum += edges_.back().length;
      }
    mean_length_ = sum / static_cast<double>(edges_.size());
  }

  double gap(const DomainEdge& e, int i, int j) const {
    return ((feet_[i][e.a] - feet_[j][e.a]).norm() + (feet_[i][e.b] - feet_[j][e.b]).norm()) / 2;
  }
  double off_seam(int v, int i, int j) const {
    const Vec3 &p = domain_.points[v], &n = normals_[i][v], &m = normals_[j][v];
    const double apart = (feet_[i][v] - feet_[j][v]).norm(), cosine = n.dot(m), sine2 = 1 - cosine * cosine;
    if (sine2 < parallel * parallel) return apart;
    // The least move onto both tangent planes.
    const double a = n.dot(feet_[i][v] - p), b = m.dot(feet_[j][v] - p);
    return std::min(apart, share_off_seam * std::sqrt(std::max(0.0, (a * a + b * b - 2 * cosine * a * b) / sine2)));
  }
  double cost(const DomainEdge& e, int i, int j) const {
    if (i == j) return 0;
    const double between = price_ == SeamPrice::apart ? gap(e, i, j) : (off_seam(e.a, i, j) + off_seam(e.b, i, j)) / 2;
    return e.length * (between + price_of_length * mean_length_);
  }
  /// Of the neighborhood across an edge of the loop; −1 where it is not known.
  int side_outside(const DomainEdge& e) const {
    return e.a < domain_.loop && e.b < domain_.loop ? sides_.of_edge[e.a] : -1;
  }
  double cost_outside(const DomainEdge& e, int i) const {
    const int outside = side_outside(e);
    if (outside < 0 || outside == i) return 0;
    return sides_.loop_price * e.length * gap(e, i, outside);
  }

  double energy(const std::vector<int>& labels) const {
    double sum = 0;
    for (const DomainEdge& e : edges_)
      sum += e.other < 0 ? cost_outside(e, labels[e.face]) : cost(e, labels[e.face], labels[e.other]);
    return sum;
  }

  std::vector<int> nearest() const {
    std::vector<int> labels;
    for (const Triangle& t : domain_.triangles) {
      const Vec3 middle = (domain_.points[t[0]] + domain_.points[t[1]] + domain_.points[t[2]]) / 3;
      double least = std::numeric_limits<double>::infinity();
      int label = 0;
      for (int i = 0; i < domain_.loop; ++i) {
        const Vec3 edge = (domain_.points[i] + domain_.points[(i + 1) % domain_.loop]) / 2;
        if (sides_.of_edge[i] < 0 || (edge - middle).squaredNorm() >= least) continue;
        least = (edge - middle).squaredNorm();
        label = sides_.of_edge[i];
      }
      labels.push_back(label);
    }
    return labels;
  }

  /// No side touches the loop in a vertex alone, where another one lies inside both loop edges, and none is as narrow
  /// as a vertex.
  void open_pinches(std::vector<int>& labels) const {
    open_pinches_at_loop(labels);
    open_narrow_sides(labels);
    part_parallel_sides(labels);
  }

  /// Where two sides that do not meet, as those of a plate, have a vertex in common, one of them withdraws from it for a third: a short
  /// seam between two others is cheaper as a point.
  void part_parallel_sides(std::vector<int>& labels) const {
    std::vector<std::vector<int>> faces(domain_.points.size());
    for (int f = 0; f < static_cast<int>(labels.size()); ++f)
      for (const int v : domain_.triangles[f]) faces[v].push_back(f);
    for (int v = domain_.loop; v < static_cast<int>(faces.size()); ++v) {
      std::set<int> around;
      for (const int f : faces[v]) around.insert(labels[f]);
      if (around.size() < 4) continue;
      for (const int i : around)
        for (const int j : around) {
          if (i >= j || normals_[i][v].cross(normals_[j][v]).norm() > parallel) continue;
          const auto third = std::ranges::find_if(around, [&](int k) { return k != i && k != j; });
          for (const int f : faces[v])
            if (labels[f] == i) labels[f] = *third;
        }
    }
  }

  /// Where the triangles of a side at a vertex are in two runs, what lies between them is given to it.
  void open_narrow_sides(std::vector<int>& labels) const {
    std::map<std::pair<int, int>, int> runs;  // by vertex and side
    for (std::size_t f = 0; f < labels.size(); ++f)
      for (const int v : domain_.triangles[f]) ++runs[{v, labels[f]}];
    for (const DomainEdge& e : edges_) {
      if (e.other < 0 || labels[e.face] != labels[e.other]) continue;
      --runs[{e.a, labels[e.face]}];
      --runs[{e.b, labels[e.face]}];
    }
    for (std::size_t f = 0; f < labels.size(); ++f)
      for (const int v : domain_.triangles[f]) {
        if (v < domain_.loop) continue;
        for (auto at = runs.lower_bound({v, 0}); at != runs.end() && at->first.first == v; ++at)
          if (at->second > 1) labels[f] = at->first.second;
      }
  }

  void open_pinches_at_loop(std::vector<int>& labels) const {
    std::vector<int> inside(static_cast<std::size_t>(domain_.loop), -1);
    for (const DomainEdge& e : edges_)
      if (e.other < 0) inside[static_cast<std::size_t>(e.a)] = labels[e.face];
    for (std::size_t f = 0; f < labels.size(); ++f)
      for (const int v : domain_.triangles[f]) {
        if (v >= domain_.loop) continue;
        const int side = inside[static_cast<std::size_t>(v)];
        if (side >= 0 && side == inside[static_cast<std::size_t>((v + domain_.loop - 1) % domain_.loop)])
          labels[f] = side;
      }
  }

  /// x = 1: the triangle takes the side.
  std::vector<int> expanded(const std::vector<int>& labels, int side) const {
    BinaryProblem problem(static_cast<int>(labels.size()));
    for (const DomainEdge& e : edges_) {
      const int i = labels[e.face];
      if (e.other < 0) {
        problem.add_unary(e.face, cost_outside(e, side) - cost_outside(e, i));
        continue;
      }
      const int j = labels[e.other];
      const double stay = cost(e, i, j), first = cost(e, side, j), second = cost(e, i, side);
      // E(0,0) = stay, E(1,0) = first, E(0,1) = second, E(1,1) = 0
      problem.add_unary(e.face, first - stay);
      problem.add_unary(e.other, -first);
      problem.add_pair(e.face, e.other, first + second - stay);
    }
    const std::vector<char> takes = problem.solve();
    std::vector<int> result = labels;
    for (std::size_t f = 0; f < labels.size(); ++f)
      if (takes[f]) result[f] = side;
    return result;
  }

  const Domain& domain_;
  const Sides& sides_;
  SeamPrice price_;
  std::vector<DomainEdge> edges_;
  std::vector<Points> feet_, normals_;  ///< by side and point
  double mean_length_ = 0;
};

}  // namespace

std::vector<int> label_faces(const Domain& domain, const Sides& sides, SeamPrice price, const CancelToken& cancel) {
  return Labelling(domain, sides, price).run(cancel);
}

}  // namespace loopmend
