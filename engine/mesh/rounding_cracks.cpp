// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/rounding_cracks.h"
#include "mesh/point_tree.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <set>
#include <span>
#include <tuple>
#include <unordered_map>
#include <utility>

namespace loopmend {

namespace {

namespace bg = boost::geometry;
using Pair = std::pair<int, int>;

constexpr double least_edge = 100;  ///< in distances between the vertices
/// Coordinates of single precision are taken for one place so many units in the last place apart, and edges need not be as long then:
/// far from the origin these units are no small part of them.
constexpr double units_of_one_place = 2, least_edge_there = 4;
constexpr double of_a_unit = 0.1;  ///< by which a number written with nine digits may miss that of single precision

/// Between a number and the next of single precision.
double unit_in_last_place(double x) {
  const float size = std::abs(static_cast<float>(x));
  return static_cast<double>(std::nextafter(size, std::numeric_limits<float>::infinity())) - static_cast<double>(size);
}

bool is_of_single_precision(const Vec3& p) {
  return std::all_of(p.begin(), p.end(), [](double x) {
    return std::abs(x - static_cast<double>(static_cast<float>(x))) <= of_a_unit * unit_in_last_place(x);
  });
}

/// Whether the coordinates differ in their last digits alone. @param otherwise  distance that is allowed in any case, mesh units
bool are_one_place(const Vec3& p, const Vec3& q, double otherwise) {
  for (int k = 0; k < 3; ++k) {
    const double unit = std::max(unit_in_last_place(p[k]), unit_in_last_place(q[k]));
    if (std::abs(p[k] - q[k]) > std::max(units_of_one_place * (1 + of_a_unit) * unit, otherwise)) return false;
  }
  return is_of_single_precision(p) && is_of_single_precision(q);
}

double size_of(const Points& points) {
  Eigen::AlignedBox3d box;
  double largest = 0;
  for (const Vec3& p : points) {
    box.extend(p);
    largest = std::max(largest, p.cwiseAbs().maxCoeff());
  }
  return std::max(largest, box.diagonal().norm());
}

/// Groups of vertices that may become one, and which of these groups may not after all.
class CrackJoin {
 public:
  CrackJoin(const TriangleSoup& soup, const VertexSurvey& survey) : soup_(soup) {
    find_pairs(survey);
    if (pairs_.empty()) return;
    find_faces();
    make_groups();
    while (drop_groups()) {
    }
  }

  JoinedCracks result() const {
    JoinedCracks joined;
    for (const auto& [v, group] : group_of_) {
      const int first = place(v);
      if (first == v) continue;
      if (joined.first.empty()) {
        joined.first.resize(soup_.points.size());
        std::iota(joined.first.begin(), joined.first.end(), 0);
      }
      joined.first[v] = first;
      ++joined.vertices;
      joined.largest = std::max(joined.largest, (soup_.points[v] - soup_.points[first]).norm());
    }
    return joined;
  }

 private:
  /// The shortest edge at each boundary vertex.
  static std::unordered_map<int, double> shortest_edges(const TriangleSoup& soup, const VertexSurvey& survey) {
    std::unordered_map<int, double> shortest;
    for (const Triangle& t : soup.triangles) {
      if (!has_three_corners(t)) continue;
      for (int k = 0; k < 3; ++k) {
        const int a = t[k], b = t[(k + 1) % 3];
        if (!survey.at_boundary[a] && !survey.at_boundary[b]) continue;
        const double length = (soup.points[a] - soup.points[b]).norm();
        for (int v : {a, b})
          if (survey.at_boundary[v]) {
            double& least = shortest.emplace(v, length).first->second;
            least = std::min(least, length);
          }
      }
    }
    return shortest;
  }

  /// Boundary vertices that lie within rounding of each other, the nearest first.
  void find_pairs(const VertexSurvey& survey) {
    const std::unordered_map<int, double> shortest = shortest_edges(soup_, survey);
    if (shortest.empty()) return;
    std::vector<std::pair<TreePoint, int>> entries;
    for (const auto& [v, length] : shortest) entries.emplace_back(tree_point(soup_.points[v]), v);
    const PointTree tree(entries);
    const double rounding = rounding_of_floats * size_of(soup_.points);
    for (const auto& [v, length] : shortest) {
      const Vec3& p = soup_.points[v];
      const double reach = std::min(rounding, length / least_edge);
      const Vec3 half_box =
          p.unaryExpr([&](double x) { return std::max(reach, 3 * units_of_one_place * unit_in_last_place(x)); });
      const TreeBox box(tree_point(p - half_box), tree_point(p + half_box));
      for (auto it = tree.qbegin(bg::index::intersects(box)); it != tree.qend(); ++it) {
        const int w = it->second;
        const double distance = (soup_.points[w] - p).norm();
        if (w <= v) continue;
        const double least = std::min(length, shortest.at(w));
        if (distance <= std::min(rounding, least / least_edge) ||
            (distance <= least / least_edge_there &&
             are_one_place(p, soup_.points[w], std::min(rounding, least / least_edge) / 2)))
          pairs_.emplace_back(distance, v, w);
      }
    }
    std::sort(pairs_.begin(), pairs_.end());
  }

  /// Those at the vertices of the pairs.
  void find_faces() {
    std::vector<char> wanted(soup_.points.size(), 0);
    for (const auto& [distance, v, w] : pairs_) wanted[v] = wanted[w] = 1;
    for (const Triangle& t : soup_.triangles)
      if (has_three_corners(t) && (wanted[t[0]] || wanted[t[1]] || wanted[t[2]])) faces_.push_back(t);
  }

  /// All members of a group lie within rounding of each other. They share no edge, since each would be far longer than that.
  void make_groups() {
    std::set<Pair> near;
    for (const auto& [distance, v, w] : pairs_) near.emplace(v, w);
    for (const auto& [distance, v, w] : pairs_) {
      for (int one : {v, w})
        if (group_of_.emplace(one, static_cast<int>(groups_.size())).second) groups_.push_back({one});
      const int a = group_of_[v], b = group_of_[w];
      if (a == b) continue;
      const auto all_near = [&] {
        for (int x : groups_[a])
          for (int y : groups_[b])
            if (!near.contains(std::minmax(x, y))) return false;
        return true;
      };
      if (!all_near()) continue;
      for (int y : groups_[b]) group_of_[y] = a;
      groups_[a].insert(groups_[a].end(), groups_[b].begin(), groups_[b].end());
      groups_[b].clear();
    }
    for (std::vector<int>& group : groups_) std::sort(group.begin(), group.end());
    open_.assign(groups_.size(), 1);
  }

  /// The vertex that the faces of v name, as the groups are.
  int place(int v) const {
    const auto found = group_of_.find(v);
    return found == group_of_.end() || !open_[found->second] ? v : groups_[found->second].front();
  }

  void close(int v) {
    const auto found = group_of_.find(v);
    if (found != group_of_.end() && groups_[found->second].size() > 1) open_[found->second] = 0;
  }

  /// Closes groups that do harm or no good. @returns whether there were any.
  bool drop_groups() {
    struct Edge {
      Pair place, own;
      bool operator<(const Edge& other) const { return std::tie(place, own) < std::tie(other.place, other.own); }
    };
    std::vector<Edge> edges;
    std::map<Triangle, std::vector<int>> faces_at;  // by their corners, sorted
    for (std::size_t f = 0; f < faces_.size(); ++f) {
      const Triangle& t = faces_[f];
      Triangle corners{place(t[0]), place(t[1]), place(t[2])};
      for (int k = 0; k < 3; ++k)
        edges.push_back({std::minmax(corners[k], corners[(k + 1) % 3]), std::minmax(t[k], t[(k + 1) % 3])});
      std::sort(corners.begin(), corners.end());
      faces_at[corners].push_back(static_cast<int>(f));
    }
    std::sort(edges.begin(), edges.end());
    const std::vector<char> before = open_;
    std::vector<char> helps(groups_.size(), 0);
    for (auto first = edges.begin(); first != edges.end();) {
      const auto last = std::find_if(first, edges.end(), [&](const Edge& e) { return e.place != first->place; });
      const std::span together(first, last);
      first = last;
      if (together.front().own == together.back().own) continue;  // nothing new
      for (const Edge& edge : together)
        for (int v : {edge.own.first, edge.own.second})
          if (together.size() > 2)
            close(v);
          else if (const auto group = group_of_.find(v); group != group_of_.end())
            helps[group->second] = 1;
    }
    for (const auto& [corners, faces] : faces_at)
      for (int f : faces)
        if (faces.size() > 1) std::for_each(faces_[f].begin(), faces_[f].end(), [&](int v) { close(v); });
    for (std::size_t g = 0; g < groups_.size(); ++g)
      if (!helps[g]) open_[g] = 0;
    return open_ != before;
  }

  const TriangleSoup& soup_;
  std::vector<std::tuple<double, int, int>> pairs_;
  Triangles faces_;
  std::map<int, int> group_of_;
  std::vector<std::vector<int>> groups_;  // ascending; the first is what the faces of all name
  std::vector<char> open_;                // per group: whether it is to become one
};

}  // namespace

JoinedCracks join_rounding_cracks(TriangleSoup& soup, const VertexSurvey& survey) {
  JoinedCracks joined = CrackJoin(soup, survey).result();
  if (joined.vertices == 0) return joined;
  for (Triangle& t : soup.triangles)
    for (int& v : t) v = joined.first[v];
  return joined;
}

}  // namespace loopmend
