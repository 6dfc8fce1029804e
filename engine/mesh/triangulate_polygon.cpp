// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/triangulate_polygon.h"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Spatial_sort_traits_adapter_2.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>
#include <CGAL/hilbert_sort.h>
#include <CGAL/property_map.h>
#include <Eigen/Geometry>

#include <algorithm>
#include <limits>
#include <map>
#include <numeric>
#include <utility>
#include <vector>

namespace loopmend {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using VertexBase = CGAL::Triangulation_vertex_base_with_info_2<int, Kernel>;  // index into the soup, -1: none
using FaceBase =
    CGAL::Triangulation_face_base_with_info_2<int, Kernel, CGAL::Constrained_triangulation_face_base_2<Kernel>>;
using Structure = CGAL::Triangulation_data_structure_2<VertexBase, FaceBase>;
using Delaunay = CGAL::Constrained_Delaunay_triangulation_2<Kernel, Structure, CGAL::No_constraint_intersection_tag>;

constexpr std::size_t largest_least_area = 128;  // the search is cubic
constexpr int unvisited = -1;

const Vec3& at(const Points& points, int index) { return points[index]; }

Vec3 area_vector(const Points& points, int a, int b, int c) {
  return (at(points, b) - at(points, a)).cross(at(points, c) - at(points, a));
}

void triangulate_quad(const Points& points, std::span<const int> q, Triangles& triangles) {
  // A diagonal lies inside if the triangles on its two sides face the same way.
  const auto agreement = [&](int a, int b, int c, int d) {
    return area_vector(points, a, b, c).dot(area_vector(points, a, c, d));
  };
  const bool first_inside = agreement(q[0], q[1], q[2], q[3]) > 0.0;
  const bool second_inside = agreement(q[1], q[2], q[3], q[0]) > 0.0;
  const double first_length = (at(points, q[0]) - at(points, q[2])).squaredNorm();
  const double second_length = (at(points, q[1]) - at(points, q[3])).squaredNorm();
  const bool first = first_inside != second_inside ? first_inside : first_length <= second_length;
  if (first) {
    triangles.insert(triangles.end(), {Triangle{q[0], q[1], q[2]}, Triangle{q[0], q[2], q[3]}});
  } else {
    triangles.insert(triangles.end(), {Triangle{q[0], q[1], q[3]}, Triangle{q[1], q[2], q[3]}});
  }
}

/// Twice the area of the polygon as a vector (Newell), seen from its first corner.
Vec3 newell_normal(const Points& points, std::span<const int> polygon) {
  Vec3 sum = Vec3::Zero();
  for (std::size_t i = 1; i + 1 < polygon.size(); ++i)
    sum += area_vector(points, polygon[0], polygon[i], polygon[i + 1]);
  return sum;
}

/// Drops the coordinate along which the polygon is seen largest. The other two stay as they are, so that CGAL's exact
/// predicates speak about the coordinates of the file and not about rounded projections.
class Projection {
 public:
  explicit Projection(const Vec3& normal) {
    Eigen::Index dropped = 0;
    normal.cwiseAbs().maxCoeff(&dropped);
    u_ = (dropped + 1) % 3;
    v_ = (dropped + 2) % 3;
    if (normal[dropped] < 0.0) std::swap(u_, v_);  // the polygon then runs counter-clockwise in the plane
  }

  Kernel::Point_2 operator()(const Vec3& point) const { return {point[u_], point[v_]}; }

 private:
  Eigen::Index u_ = 0;
  Eigen::Index v_ = 1;
};

/// Inserts corners and edges. False if corners of different vertices coincide, or if a curve crosses itself or another.
/// `uses` counts how often the curves run along each edge; twice along the edge that joins a hole to the outline.
class PolygonDelaunay {
 public:
  PolygonDelaunay(const Points& points, const std::vector<std::vector<int>>& curves, const Projection& project) {
    std::vector<int> polygon;
    for (const std::vector<int>& curve : curves) polygon.insert(polygon.end(), curve.begin(), curve.end());
    std::vector<Delaunay::Vertex_handle> handles(polygon.size());
    Delaunay::Face_handle hint;
    for (const std::size_t corner : order_of(points, polygon, project)) {
      const int index = polygon[corner];
      const Delaunay::Vertex_handle handle = delaunay_.insert(project(at(points, index)), hint);
      hint = handle->face();
      const bool is_new = seen_.emplace(handle, index).second;
      if (!is_new && handle->info() != index) return;
      handle->info() = index;
      handles[corner] = handle;
    }
    triangles_ = polygon.size() + 2 * (curves.size() - 1) - 2;
    good_ = delaunay_.dimension() == 2;
    std::size_t first = 0;
    for (const std::vector<int>& curve : curves) {
      good_ = good_ && insert_edges(std::span(handles).subspan(first, curve.size()));
      first += curve.size();
    }
  }

  bool good() const { return good_; }

  /// The triangles inside, or nothing if they are not as many as between such curves.
  Triangles inside() {
    mark_domains();
    Triangles triangles;
    for (const Delaunay::Face_handle face : delaunay_.finite_face_handles()) {
      if (face->info() % 2 == 0) continue;
      triangles.push_back(canonical({face->vertex(0)->info(), face->vertex(1)->info(), face->vertex(2)->info()}));
    }
    if (triangles.size() != triangles_) triangles.clear();
    std::sort(triangles.begin(), triangles.end());
    return triangles;
  }

 private:
  using Edge = std::pair<Delaunay::Vertex_handle, Delaunay::Vertex_handle>;

  /// As the polygon has them; of a large one along a Hilbert curve, since in the order of a smooth outline each new corner would
  /// turn all the edges that the last ones have made.
  static std::vector<std::size_t> order_of(const Points& points, std::span<const int> polygon,
                                           const Projection& project) {
    std::vector<std::size_t> order(polygon.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    constexpr std::size_t large = 2000;
    if (polygon.size() < large) return order;
    std::vector<Kernel::Point_2> places;
    places.reserve(polygon.size());
    for (const int index : polygon) places.push_back(project(at(points, index)));
    const auto map = CGAL::make_property_map(places);
    CGAL::hilbert_sort(order.begin(), order.end(), CGAL::Spatial_sort_traits_adapter_2<Kernel, decltype(map)>(map));
    return order;
  }

  static Edge edge_between(Delaunay::Vertex_handle a, Delaunay::Vertex_handle b) {
    return a < b ? Edge{a, b} : Edge{b, a};
  }

  static Triangle canonical(Triangle t) {
    std::rotate(t.begin(), std::min_element(t.begin(), t.end()), t.end());
    return t;
  }

  bool insert_edges(std::span<const Delaunay::Vertex_handle> handles) {
    try {
      for (std::size_t i = 0; i < handles.size(); ++i) {
        const Delaunay::Vertex_handle a = handles[i];
        const Delaunay::Vertex_handle b = handles[(i + 1) % handles.size()];
        if (a == b) return false;
        delaunay_.insert_constraint(a, b);
        if (!delaunay_.is_edge(a, b)) return false;  // it was split at a corner that lies on it
        ++uses_[edge_between(a, b)];
      }
    } catch (const Delaunay::Intersection_of_constraints_exception&) {
      return false;
    } catch (const CGAL::Failure_exception&) {
      return false;
    }
    return true;
  }

  /// Faces get the number of polygon edges between them and the outside; an odd number is inside.
  void mark_domains() {
    for (const Delaunay::Face_handle face : delaunay_.all_face_handles()) face->info() = unvisited;
    std::vector<Delaunay::Face_handle> open = {delaunay_.infinite_face()};
    open.front()->info() = 0;
    while (!open.empty()) {
      const Delaunay::Face_handle face = open.back();
      open.pop_back();
      for (int i = 0; i < 3; ++i) {
        const Delaunay::Face_handle next = face->neighbor(i);
        if (next->info() != unvisited) continue;
        const auto found = uses_.find(edge_between(face->vertex(Delaunay::cw(i)), face->vertex(Delaunay::ccw(i))));
        next->info() = (face->info() + (found == uses_.end() ? 0 : found->second)) % 2;
        open.push_back(next);
      }
    }
  }

  Delaunay delaunay_;
  std::map<Delaunay::Vertex_handle, int> seen_;
  std::map<Edge, int> uses_;
  std::size_t triangles_ = 0;
  bool good_ = false;
};

/// Least total area over all triangulations of the polygon's corners, by dynamic programming.
class LeastArea {
 public:
  LeastArea(const Points& points, std::span<const int> polygon)
      : polygon_(polygon),
        size_(polygon.size()),
        cost_(size_ * size_, 0.0),
        apex_(size_ * size_, 0) {
    for (std::size_t width = 2; width < size_; ++width) {
      for (std::size_t i = 0; i + width < size_; ++i) choose_apex(points, i, i + width);
    }
  }

  void append_to(Triangles& triangles) const {
    std::vector<std::pair<std::size_t, std::size_t>> open = {{0, size_ - 1}};
    while (!open.empty()) {
      const auto [i, k] = open.back();
      open.pop_back();
      if (k < i + 2) continue;
      const std::size_t j = apex_[i * size_ + k];
      triangles.push_back({polygon_[i], polygon_[j], polygon_[k]});
      open.emplace_back(i, j);
      open.emplace_back(j, k);
    }
  }

 private:
  void choose_apex(const Points& points, std::size_t i, std::size_t k) {
    double least = std::numeric_limits<double>::infinity();
    std::size_t best = i + 1;
    for (std::size_t j = i + 1; j < k; ++j) {
      const double area = area_vector(points, polygon_[i], polygon_[j], polygon_[k]).norm();
      const double cost = cost_[i * size_ + j] + cost_[j * size_ + k] + area;
      if (cost < least) {
        least = cost;
        best = j;
      }
    }
    cost_[i * size_ + k] = least;
    apex_[i * size_ + k] = best;
  }

  std::span<const int> polygon_;
  std::size_t size_;
  std::vector<double> cost_;
  std::vector<std::size_t> apex_;
};

void append_fan(std::span<const int> polygon, Triangles& triangles) {
  for (std::size_t i = 1; i + 1 < polygon.size(); ++i) triangles.push_back({polygon[0], polygon[i], polygon[i + 1]});
}

}  // namespace

Triangles triangulate_seen_flat(const Points& points, const std::vector<std::vector<int>>& curves) {
  Vec3 normal = Vec3::Zero();
  for (const std::vector<int>& curve : curves) normal += newell_normal(points, curve);
  if (!normal.allFinite() || normal.isZero(0.0)) return {};
  PolygonDelaunay delaunay(points, curves, Projection(normal));
  return delaunay.good() ? delaunay.inside() : Triangles{};
}

Triangles triangulate_seen_flat(const Points& points, std::span<const int> polygon) {
  return triangulate_seen_flat(points, std::vector<std::vector<int>>{{polygon.begin(), polygon.end()}});
}

void triangulate_polygon(const Points& points, std::span<const int> polygon, Triangles& triangles) {
  if (polygon.size() == 3) {
    triangles.push_back({polygon[0], polygon[1], polygon[2]});
  } else if (polygon.size() == 4) {
    triangulate_quad(points, polygon, triangles);
  } else if (const Triangles flat = triangulate_seen_flat(points, polygon); !flat.empty()) {
    triangles.insert(triangles.end(), flat.begin(), flat.end());
  } else if (polygon.size() <= largest_least_area) {
    LeastArea(points, polygon).append_to(triangles);
  } else {
    append_fan(polygon, triangles);
  }
}

}  // namespace loopmend
