// SPDX-License-Identifier: GPL-3.0-or-later
#include "output_check.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/triangulate_hole.h>
#include <CGAL/box_intersection_d.h>
#include <CGAL/intersections.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <numeric>

namespace loopmend::bench {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Edge = std::pair<int, int>;

constexpr double largest_area_ratio = 2;
const double fold_cosine = std::cos(150 * std::numbers::pi / 180);

Kernel::Point_3 exact(const Vec3& p) { return {p.x(), p.y(), p.z()}; }

bool same_exterior(const TriangleSoup& input, const TriangleSoup& output) {
  if (output.points.size() < input.points.size() || output.triangles.size() < input.triangles.size()) return false;
  for (std::size_t v = 0; v < input.points.size(); ++v)
    if (input.points[v] != output.points[v]) return false;
  for (std::size_t f = 0; f < input.triangles.size(); ++f) {
    Triangle a = input.triangles[f], b = output.triangles[f];
    std::sort(a.begin(), a.end());
    std::sort(b.begin(), b.end());
    if (a != b) return false;
  }
  return true;
}

/// Do two triangles meet in more than the corners they share? Corners in one place count as shared.
class Crossing {
 public:
  explicit Crossing(const TriangleSoup& soup) : soup_(soup) {}

  bool operator()(int f, int g) const {
    const auto a = corners(f), b = corners(g);
    const Kernel::Triangle_3 s(a[0], a[1], a[2]), t(b[0], b[1], b[2]);
    if (s.is_degenerate() || t.is_degenerate()) return false;
    std::vector<int> in_a, in_b;
    for (int i = 0; i < 3; ++i)
      for (int j = 0; j < 3; ++j)
        if (a[i] == b[j]) {
          in_a.push_back(i);
          in_b.push_back(j);
        }
    if (in_a.size() >= 3) return true;
    if (in_a.size() == 2) {
      const auto &p = a[in_a[0]], &q = a[in_a[1]], &r = a[3 - in_a[0] - in_a[1]], &u = b[3 - in_b[0] - in_b[1]];
      return CGAL::coplanar(p, q, r, u) && CGAL::coplanar_orientation(p, q, r, u) == CGAL::POSITIVE;
    }
    if (in_a.size() == 1)
      return CGAL::do_intersect(Kernel::Segment_3(a[(in_a[0] + 1) % 3], a[(in_a[0] + 2) % 3]), t) ||
             CGAL::do_intersect(Kernel::Segment_3(b[(in_b[0] + 1) % 3], b[(in_b[0] + 2) % 3]), s);
    return CGAL::do_intersect(s, t);
  }

 private:
  std::array<Kernel::Point_3, 3> corners(int f) const {
    const Triangle& t = soup_.triangles[f];
    return {exact(soup_.points[t[0]]), exact(soup_.points[t[1]]), exact(soup_.points[t[2]])};
  }
  const TriangleSoup& soup_;
};

std::vector<std::pair<int, int>> crossings_of(const TriangleSoup& output, int first_new) {
  using Box = CGAL::Box_intersection_d::Box_with_info_d<double, 3, int>;
  const auto box = [&](int f) {
    CGAL::Bbox_3 all;
    for (int v : output.triangles[f]) all += exact(output.points[v]).bbox();
    return Box(all, f);
  };
  std::vector<Box> made, there;
  CGAL::Bbox_3 reach;
  for (int f = first_new; f < static_cast<int>(output.triangles.size()); ++f) reach += made.emplace_back(box(f)).bbox();
  for (int f = 0; f < first_new; ++f)
    if (Box b = box(f); CGAL::do_overlap(b.bbox(), reach)) there.push_back(b);
  std::vector<std::pair<int, int>> pairs;
  const Crossing cross(output);
  const auto look = [&](const Box& a, const Box& b) {
    if (cross(a.info(), b.info())) pairs.emplace_back(a.info(), b.info());
  };
  CGAL::box_self_intersection_d(made.begin(), made.end(), look);
  CGAL::box_intersection_d(made.begin(), made.end(), there.begin(), there.end(), look);
  return pairs;
}

double area(const Vec3& a, const Vec3& b, const Vec3& c) { return (b - a).cross(c - a).norm() / 2; }

/// The closed chain of these directed edges; empty where they make several, or one that meets itself.
std::vector<int> single_chain(const std::vector<Edge>& edges) {
  std::map<int, int> next;
  for (const Edge& edge : edges)
    if (!next.emplace(edge).second) return {};
  std::vector<int> chain;
  if (next.empty()) return chain;
  for (int v = next.begin()->first; chain.size() < next.size() && next.contains(v); v = next.at(v)) chain.push_back(v);
  return chain.size() == next.size() && next.at(chain.back()) == chain.front() ? chain : std::vector<int>{};
}

/// The smallest triangulation found of the chain, over the points.
std::vector<Triangle> smallest_triangulation(const Points& points, const std::vector<int>& chain) {
  std::vector<Kernel::Point_3> polyline;
  for (int v : chain) polyline.push_back(exact(points[v]));
  std::vector<CGAL::Triple<int, int, int>> found;
  CGAL::Polygon_mesh_processing::triangulate_hole_polyline(
      polyline, std::back_inserter(found),
      CGAL::parameters::use_delaunay_triangulation(true).do_not_use_cubic_algorithm(chain.size() > 300));
  std::vector<Triangle> triangles;
  // Corners of polylines ascend, so that triangles run as the chain does.
  for (const auto& t : found) {
    std::array<int, 3> corner{t.first, t.second, t.third};
    std::sort(corner.begin(), corner.end());
    triangles.push_back({chain[corner[0]], chain[corner[1]], chain[corner[2]]});
  }
  return triangles;
}

}  // namespace

bool FilledPart::is_clean() const {
  return is_closed() && crossings == 0 && folds == 0 && area_ratio <= largest_area_ratio;
}

OutputCheck check_output(const TriangleSoup& input, const TriangleSoup& output) {
  OutputCheck check;
  check.exterior_kept = same_exterior(input, output);
  if (!check.exterior_kept) return check;
  const int first_new = static_cast<int>(input.triangles.size()), count = static_cast<int>(output.triangles.size());
  // Faces at each edge of a new triangle; the sign of a direction says how the edge runs in it.
  std::map<Edge, std::vector<std::pair<int, bool>>> at;
  const auto edge_of = [&](int f, int k) { return Edge{output.triangles[f][k], output.triangles[f][(k + 1) % 3]}; };
  for (int f = first_new; f < count; ++f)
    for (int k = 0; k < 3; ++k) at[std::minmax(edge_of(f, k).first, edge_of(f, k).second)];
  for (int f = 0; f < count; ++f)
    for (int k = 0; k < 3; ++k) {
      const auto [a, b] = edge_of(f, k);
      if (const auto found = at.find(std::minmax(a, b)); found != at.end()) found->second.push_back({f, a < b});
    }
  std::vector<int> part(count);
  std::iota(part.begin(), part.end(), 0);
  const auto root = [&](int f) {
    while (part[f] != f) f = part[f] = part[part[f]];
    return f;
  };
  const auto is_new = [&](int f) { return f >= first_new; };
  for (const auto& [edge, faces] : at)
    for (std::size_t k = 1; k < faces.size(); ++k)
      if (is_new(faces[0].first) && is_new(faces[k].first)) part[root(faces[k].first)] = root(faces[0].first);
  std::map<int, FilledPart> parts;
  std::map<int, std::vector<Edge>> boundary;
  std::map<int, std::vector<std::pair<Edge, int>>> seam_folds;  // with the face of the input
  std::map<int, double> area_of;
  const auto normal = [&](const Triangle& t) {
    return Vec3(
        (output.points[t[1]] - output.points[t[0]]).cross(output.points[t[2]] - output.points[t[0]]).normalized());
  };
  const auto folds = [&](const Triangle& s, const Triangle& t) { return normal(s).dot(normal(t)) < fold_cosine; };
  for (int f = first_new; f < count; ++f) {
    const Triangle& t = output.triangles[f];
    ++parts[root(f)].triangles;
    area_of[root(f)] += area(output.points[t[0]], output.points[t[1]], output.points[t[2]]);
  }
  for (const auto& [edge, faces] : at) {
    const auto own = std::find_if(faces.begin(), faces.end(), [&](const auto& side) { return is_new(side.first); });
    const int r = root(own->first);
    FilledPart& here = parts[r];
    if (faces.size() == 1) {
      ++here.open_edges;
    } else if (faces.size() > 2 || faces[0].second == faces[1].second) {
      ++here.crowded_edges;
    } else {
      const bool fold = folds(output.triangles[faces[0].first], output.triangles[faces[1].first]);
      here.folds += fold;
      if (is_new(faces[0].first) && is_new(faces[1].first)) continue;
      const Edge along = own->second ? edge : Edge{edge.second, edge.first};
      boundary[r].push_back(along);
      if (fold) seam_folds[r].emplace_back(along, is_new(faces[0].first) ? faces[1].first : faces[0].first);
    }
  }
  for (const auto& [f, g] : crossings_of(output, first_new)) {
    ++parts[root(f)].crossings;
    if (is_new(g) && root(g) != root(f)) ++parts[root(g)].crossings;
  }
  for (auto& [r, here] : parts) {
    const std::vector<int> chain = single_chain(boundary[r]);
    double smallest = 0;
    if (!chain.empty())
      for (const Triangle& t : smallest_triangulation(output.points, chain)) {
        smallest += area(output.points[t[0]], output.points[t[1]], output.points[t[2]]);
        for (const auto& [edge, face] : seam_folds[r])
          for (int k = 0; k < 3; ++k)
            if (Edge{t[k], t[(k + 1) % 3]} == edge && folds(t, output.triangles[face])) ++here.forced_folds;
      }
    here.folds -= here.forced_folds;
    here.area_ratio = smallest > 0 ? area_of[r] / smallest : 0;
    check.parts.push_back(here);
  }
  return check;
}

}  // namespace loopmend::bench
