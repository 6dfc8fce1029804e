// SPDX-License-Identifier: GPL-3.0-or-later
#include "edges/seams.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <set>

namespace loopmend {

namespace {

using Edge = std::pair<int, int>;

constexpr int smoothing_rounds = 20;
constexpr double one_node = 0.25;  ///< edges of the neighborhood: nodes that are nearer to each other are one

/// Vertices of the domain along a seam between two sides, from one node to another.
struct Chain {
  std::vector<int> vertices;
  std::set<int> sides;
  std::vector<int> points;  ///< of the layout, instead of them
};

class SeamTracer {
 public:
  SeamTracer(const Domain& domain, const std::vector<int>& labels, const Sides& sides,
             const std::function<double(const Vec3&)>& size, double reach)
      : domain_(domain),
        labels_(labels),
        sides_(sides),
        size_(size),
        reach_(reach) {
    for (int f = 0; f < static_cast<int>(domain.triangles.size()); ++f)
      for (int k = 0; k < 3; ++k) face_at_[{domain.triangles[f][k], domain.triangles[f][(k + 1) % 3]}] = f;
    for (const auto& [edge, face] : face_at_) {
      const int beyond = face_beyond(edge);
      if (beyond < 0 || labels_[beyond] == labels_[face]) continue;
      beside_[edge.first].insert(edge.second);
      sides_at_[edge.first].insert(labels_[face]);
      sides_at_[edge.first].insert(labels_[beyond]);
    }
  }

  SeamLayout run() {
    layout_.points.assign(domain_.points.begin(), domain_.points.begin() + domain_.loop);
    for (int i = 0; i < domain_.loop; ++i) {
      point_of_node_[i] = i;
      layout_.side_inside.push_back(labels_[face_at_.at({i, (i + 1) % domain_.loop})]);
    }
    trace_chains();
    for (Chain& chain : chains_) lay(chain);
    find_parts();
    return std::move(layout_);
  }

 private:
  int face_beyond(const Edge& edge) const {
    const auto found = face_at_.find({edge.second, edge.first});
    return found == face_at_.end() ? -1 : found->second;
  }
  bool is_node(int v) const { return v < domain_.loop || beside_.at(v).size() != 2; }

  void trace_chains() {
    for (const auto& [v, neighbors] : beside_) {
      if (!is_node(v)) continue;
      for (int w : neighbors) {
        Chain chain{{v, w}, {}, {}};
        while (!is_node(chain.vertices.back())) {
          const std::set<int>& next = beside_.at(chain.vertices.back());
          const int previous = chain.vertices[chain.vertices.size() - 2];
          chain.vertices.push_back(*next.begin() == previous ? *next.rbegin() : *next.begin());
        }
        if (chain_at_.contains({v, w})) continue;
        const int number = static_cast<int>(chains_.size());
        const auto last = chain.vertices.end();
        chain_at_[{v, w}] = number;
        chain_at_[{*(last - 1), *(last - 2)}] = number;
        chain.sides = {labels_[face_at_.at({v, w})], labels_[face_at_.at({w, v})]};
        chains_.push_back(std::move(chain));
      }
    }
  }

  std::vector<const SideSurface*> surfaces(const std::set<int>& numbers) const {
    std::vector<const SideSurface*> result;
    for (int s : numbers) result.push_back(&sides_.surfaces[s]);
    return result;
  }

  /// The point of the layout for a node: one of the loop's, or where the surfaces of all sides around it meet. At the
  /// tip of a pyramid several nodes are one point.
  int node(int v) {
    const auto known = point_of_node_.find(v);
    if (known != point_of_node_.end()) return known->second;
    const Vec3 point = place(surfaces(sides_at_.at(v)), domain_.points[v]);
    const auto same = std::ranges::find_if(
        inner_nodes_, [&](int other) { return (layout_.points[other] - point).norm() < one_node * size_(point); });
    const int number = same != inner_nodes_.end() ? *same : static_cast<int>(layout_.points.size());
    if (same == inner_nodes_.end()) {
      layout_.points.push_back(point);
      inner_nodes_.push_back(number);
    }
    return point_of_node_[v] = number;
  }

  Vec3 place(const std::vector<const SideSurface*>& surfaces, const Vec3& near) {
    const Vec3 point = common_point(surfaces, near, reach_);
    layout_.gap = std::max(layout_.gap, distance(surfaces, point));
    return point;
  }

  /// Puts the seam onto the intersection of both surfaces, evenly spaced.
  void lay(Chain& chain) {
    const int from = node(chain.vertices.front()), to = node(chain.vertices.back());
    if (from == to) {
      if (from >= domain_.loop) chain.points = {from};
      return;
    }
    const std::vector<const SideSurface*> both = surfaces(chain.sides);
    Points line{layout_.points[from]};
    for (std::size_t k = 1; k + 1 < chain.vertices.size(); ++k) line.push_back(domain_.points[chain.vertices[k]]);
    line.push_back(layout_.points[to]);
    for (int round = 0; round < smoothing_rounds; ++round) {
      line = evenly_spaced(line, std::max<std::size_t>(line.size(), 4));
      Points smooth = line;
      for (std::size_t k = 1; k + 1 < line.size(); ++k)
        smooth[k] = common_point(both, (line[k - 1] + 2 * line[k] + line[k + 1]) / 4, reach_);
      line = std::move(smooth);
    }
    line = evenly_spaced(line, 1 + std::max<std::size_t>(1, segments(line)));
    chain.points.push_back(from);
    const Vec3 end = layout_.points[to];
    for (std::size_t k = 1; k + 1 < line.size(); ++k) {
      const Vec3 point = place(both, line[k]);
      const double least = one_node * size_(point);  // where the loop runs along the seam, its end may be passed
      if ((point - layout_.points[chain.points.back()]).norm() < least || (point - end).norm() < least) continue;
      chain.points.push_back(static_cast<int>(layout_.points.size()));
      layout_.points.push_back(point);
    }
    chain.points.push_back(to);
    const double bend = bend_deg(both, line[line.size() / 2]);
    if (bend <= sides_.seam_deg) return;
    layout_.sharpest_deg = std::max(layout_.sharpest_deg, bend);
    layout_.seams.push_back(chain.points);
    layout_.sides_of_seam.emplace_back(*chain.sides.begin(), *chain.sides.rbegin());
  }

  /// The angle between the normals of both surfaces there; the acute one where an outside is not known.
  static double bend_deg(const std::vector<const SideSurface*>& both, const Vec3& p) {
    const Vec3 first = both.front()->normal_at(both.front()->foot(p)),
               second = both.back()->normal_at(both.back()->foot(p));
    const bool is_signed = both.front()->has_outside() && both.back()->has_outside();
    const double cosine = is_signed ? first.dot(second) : std::abs(first.dot(second));
    return std::acos(std::clamp(cosine, -1.0, 1.0)) * 180 / std::numbers::pi;
  }

  std::size_t segments(const Points& line) const {
    double count = 0;
    for (std::size_t k = 0; k + 1 < line.size(); ++k)
      count += (line[k + 1] - line[k]).norm() / size_((line[k] + line[k + 1]) / 2);
    return static_cast<std::size_t>(std::lround(count));
  }

  static Points evenly_spaced(const Points& line, std::size_t count) {
    std::vector<double> lengths{0};
    for (std::size_t k = 0; k + 1 < line.size(); ++k)
      lengths.push_back(lengths.back() + (line[k + 1] - line[k]).norm());
    Points result{line.front()};
    std::size_t k = 0;
    for (std::size_t i = 1; i + 1 < count; ++i) {
      const double wanted = lengths.back() * static_cast<double>(i) / static_cast<double>(count - 1);
      while (k + 2 < lengths.size() && lengths[k + 1] < wanted) ++k;
      const double length = lengths[k + 1] - lengths[k], share = length > 0 ? (wanted - lengths[k]) / length : 0;
      result.push_back(line[k] + share * (line[k + 1] - line[k]));
    }
    result.push_back(line.back());
    return result;
  }

  /// Connected triangles of one side.
  void find_parts() {
    std::vector<char> found(labels_.size(), 0);
    for (int seed = 0; seed < static_cast<int>(labels_.size()); ++seed) {
      if (found[seed]) continue;
      found[seed] = 1;
      Part part{labels_[seed], {seed}, {}};
      std::map<int, int> next;  // along the outline
      bool touches_itself = false;
      for (std::size_t k = 0; k < part.triangles.size(); ++k)
        for (int c = 0; c < 3; ++c) {
          const Triangle& t = domain_.triangles[part.triangles[k]];
          const Edge edge{t[c], t[(c + 1) % 3]};
          const int beyond = face_beyond(edge);
          if (beyond < 0 || labels_[beyond] != part.side) {
            touches_itself = !next.emplace(edge.first, edge.second).second || touches_itself;
          } else if (!found[beyond]) {
            found[beyond] = 1;
            part.triangles.push_back(beyond);
          }
        }
      if (!touches_itself) part.outline = outline_of(next);
      layout_.parts.push_back(std::move(part));
    }
  }

  /// @returns the points of the outline; none where it is in several cycles, or a seam's ends are one.
  std::vector<int> outline_of(const std::map<int, int>& next) const {
    const auto start = std::find_if(next.begin(), next.end(), [&](const auto& step) { return is_on_node(step.first); });
    if (start == next.end()) return {};  // an island
    std::vector<int> outline;
    std::size_t walked = 0;
    int v = start->first;
    do {
      const int w = next.at(v);
      if (outline.empty() || outline.back() != point_of_node_.at(v)) outline.push_back(point_of_node_.at(v));
      const auto found = chain_at_.find({v, w});
      if (found == chain_at_.end()) {  // along the loop
        v = w;
        ++walked;
        continue;
      }
      std::vector<int> points = chains_[found->second].points, vertices = chains_[found->second].vertices;
      if (points.empty()) return {};
      if (vertices.front() != v || vertices[1] != w) {
        std::reverse(points.begin(), points.end());
        std::reverse(vertices.begin(), vertices.end());
      }
      if (points.size() > 1) outline.insert(outline.end(), points.begin() + 1, points.end() - 1);
      v = vertices.back();
      walked += vertices.size() - 1;
    } while (v != start->first);
    if (outline.front() == outline.back()) outline.pop_back();
    const bool touches_itself = std::set<int>(outline.begin(), outline.end()).size() < outline.size();
    return walked == next.size() && outline.size() >= 3 && !touches_itself ? outline : std::vector<int>();
  }
  bool is_on_node(int v) const { return v < domain_.loop || (beside_.contains(v) && is_node(v)); }

  const Domain& domain_;
  const std::vector<int>& labels_;
  const Sides& sides_;
  const std::function<double(const Vec3&)>& size_;
  double reach_;
  std::map<Edge, int> face_at_;
  std::map<int, std::set<int>> beside_;    ///< along seams
  std::map<int, std::set<int>> sides_at_;  ///< of vertices on seams
  std::map<int, int> point_of_node_;
  std::vector<int> inner_nodes_;  ///< points of the layout
  std::vector<Chain> chains_;
  std::map<Edge, int> chain_at_;  ///< by the directed edges with which a chain begins
  SeamLayout layout_;
};

}  // namespace

SeamLayout lay_out_seams(const Domain& domain, const std::vector<int>& labels, const Sides& sides,
                         const std::function<double(const Vec3&)>& size, double reach) {
  return SeamTracer(domain, labels, sides, size, reach).run();
}

}  // namespace loopmend
