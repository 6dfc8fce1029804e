// SPDX-License-Identifier: GPL-3.0-or-later
#include "repair/stitch_boundaries.h"

#include "core/error.h"

#include <boost/geometry.hpp>
#include <boost/geometry/index/rtree.hpp>

#include <algorithm>
#include <limits>
#include <map>
#include <numeric>
#include <set>
#include <tuple>
#include <vector>

namespace loopmend {

namespace {

namespace bg = boost::geometry;
using TreePoint = bg::model::point<double, 3, bg::cs::cartesian>;
using TreeBox = bg::model::box<TreePoint>;
using Tree = bg::index::rtree<std::pair<TreePoint, int>, bg::index::quadratic<16>>;

TreePoint tree_point(const Vec3& p) { return {p.x(), p.y(), p.z()}; }

/// A boundary edge of the soup, as it runs in its face.
struct BoundaryEdge {
  int face, corner;  ///< from this corner of the face to the next
  int from, to;      ///< soup points
};

class Stitching {
 public:
  Stitching(const SurfaceModel& model, double tolerance)
      : soup_(model.soup),
        tolerance_(tolerance),
        parent_(model.soup.points.size()),
        size_(model.soup.points.size(), 0) {
    std::iota(parent_.begin(), parent_.end(), 0);
    find_boundary(model);
  }

  StitchedSurface result() {
    StitchedSurface stitched{soup_, 0, 0, 0};
    join_near_vertices();
    split_at_junctions(stitched);
    for (std::size_t v = 0; v < parent_.size(); ++v)
      stitched.joined_vertices += root(static_cast<int>(v)) != static_cast<int>(v);
    Triangles kept;
    std::vector<int> points(soup_.points.size()), rows;  // those of split faces are new
    std::iota(points.begin(), points.end(), 0);
    for (std::size_t f = 0; f < stitched.soup.triangles.size(); ++f) {
      const Triangle& given = stitched.soup.triangles[f];
      const Triangle t{root(given[0]), root(given[1]), root(given[2])};
      if (t[0] == t[1] || t[1] == t[2] || t[2] == t[0]) {
        ++stitched.removed_faces;
        continue;
      }
      kept.push_back(t);
      const bool is_new = f >= soup_.triangles.size() || given != soup_.triangles[f];
      rows.push_back(is_new ? -1 : static_cast<int>(f));
    }
    stitched.soup.triangles = std::move(kept);
    copy_rows(soup_, points, rows, stitched.soup);
    return stitched;
  }

 private:
  void find_boundary(const SurfaceModel& model) {
    std::vector<double> sum(size_.size(), 0), count(size_.size(), 0);
    for (const auto h : model.mesh.halfedges()) {
      if (!model.mesh.is_boundary(h)) continue;
      const auto inner = model.mesh.opposite_halfedge_handle(h);
      const int face = model.soup_face[model.mesh.face_handle(inner).idx()];
      const int from = model.soup_vertex[model.mesh.from_vertex_handle(inner).idx()];
      const int to = model.soup_vertex[model.mesh.to_vertex_handle(inner).idx()];
      const Triangle& t = soup_.triangles[face];
      const int corner = static_cast<int>(std::find(t.begin(), t.end(), from) - t.begin());
      edges_.push_back({face, corner, from, to});
      neighbors_.insert(std::minmax(from, to));
      const double length = (soup_.points[to] - soup_.points[from]).norm();
      for (int v : {from, to}) {
        sum[v] += length;
        count[v] += 1;
      }
    }
    std::vector<std::pair<TreePoint, int>> entries;
    for (std::size_t v = 0; v < size_.size(); ++v) {
      if (count[v] == 0) continue;
      size_[v] = sum[v] / count[v];
      entries.emplace_back(tree_point(soup_.points[v]), static_cast<int>(v));
    }
    tree_ = Tree(entries);
  }

  int root(int v) {
    while (parent_[v] != v) v = parent_[v] = parent_[parent_[v]];
    return v;
  }

  std::vector<int> near(const Vec3& low, const Vec3& high) const {
    std::vector<int> found;
    const TreeBox box(tree_point(low), tree_point(high));
    for (auto it = tree_.qbegin(bg::index::intersects(box)); it != tree_.qend(); ++it) found.push_back(it->second);
    std::sort(found.begin(), found.end());
    return found;
  }

  /// The nearest pairs first; never two ends of one edge, nor by way of others.
  void join_near_vertices() {
    std::vector<std::tuple<double, int, int>> pairs;
    for (std::size_t v = 0; v < size_.size(); ++v) {
      if (size_[v] == 0) continue;
      const Vec3 &p = soup_.points[v], reach = Vec3::Constant(tolerance_ * size_[v]);
      for (int w : near(p - reach, p + reach)) {
        const double distance = (soup_.points[w] - p).norm();
        if (w > static_cast<int>(v) && distance <= tolerance_ * std::min(size_[v], size_[w]))
          pairs.emplace_back(distance, static_cast<int>(v), w);
      }
    }
    std::sort(pairs.begin(), pairs.end());
    std::map<int, std::vector<int>> members;
    for (const auto& [distance, v, w] : pairs) {
      const int a = std::min(root(v), root(w)), b = std::max(root(v), root(w));
      if (a == b) continue;
      std::vector<int>&all = members[a], &more = members[b];
      if (all.empty()) all = {a};
      if (more.empty()) more = {b};
      const bool share_an_edge = std::any_of(all.begin(), all.end(), [&, &others = more](int x) {
        return std::any_of(others.begin(), others.end(), [&](int y) { return neighbors_.contains(std::minmax(x, y)); });
      });
      if (share_an_edge) continue;
      parent_[b] = a;
      all.insert(all.end(), more.begin(), more.end());
      members.erase(b);
    }
  }

  /// A face whose boundary edge passes a boundary vertex of the other side becomes several.
  void split_at_junctions(StitchedSurface& stitched) {
    std::set<std::pair<int, int>> directed;
    for (const BoundaryEdge& e : edges_) directed.insert({root(e.from), root(e.to)});
    std::map<int, std::vector<std::pair<int, std::vector<int>>>> cuts;  // face → corner, vertices on that side
    for (const BoundaryEdge& e : edges_) {
      if (directed.contains({root(e.to), root(e.from)})) continue;  // zipped already
      const int apex = soup_.triangles[e.face][(e.corner + 2) % 3];
      const Vec3 &a = soup_.points[e.from], &b = soup_.points[e.to];
      const double length = (b - a).norm();
      if (!(length > 0)) continue;
      const Vec3 along = (b - a) / length, reach = Vec3::Constant(tolerance_ * length);
      std::map<double, int> on;
      for (int v : near(a.cwiseMin(b) - reach, a.cwiseMax(b) + reach)) {
        if (root(v) == root(e.from) || root(v) == root(e.to)) continue;
        if (root(v) == root(apex)) continue;
        const Vec3 d = soup_.points[v] - a;
        const double t = along.dot(d);
        if (t > tolerance_ * length && t < (1 - tolerance_) * length &&
            (d - t * along).norm() <= tolerance_ * std::min(length, size_[v]))
          on.emplace(t, root(v));
      }
      if (on.empty()) continue;
      std::vector<int> vertices;
      for (const auto& [t, v] : on)
        if (vertices.empty() || vertices.back() != v) vertices.push_back(v);
      cuts[e.face].emplace_back(e.corner, std::move(vertices));
    }
    for (const auto& [face, sides] : cuts) {
      const auto& [corner, vertices] = sides.front();  // one side of a face: the others wait for another run
      const Triangle t = stitched.soup.triangles[face];
      const int to = t[(corner + 1) % 3], apex = t[(corner + 2) % 3];
      int from = t[corner];
      stitched.soup.triangles[face] = {from, vertices.front(), apex};
      for (std::size_t k = 0; k < vertices.size(); ++k) {
        from = vertices[k];
        stitched.soup.triangles.push_back({from, k + 1 < vertices.size() ? vertices[k + 1] : to, apex});
      }
      ++stitched.split_faces;
    }
  }

  const TriangleSoup& soup_;
  double tolerance_;
  std::vector<int> parent_;   // of soup points
  std::vector<double> size_;  // mean length of the boundary edges at each; 0 where there are none
  std::vector<BoundaryEdge> edges_;
  std::set<std::pair<int, int>> neighbors_;  // ends of boundary edges
  Tree tree_;
};

}  // namespace

StitchedSurface stitch_boundaries(const SurfaceModel& model, double tolerance) {
  if (!(tolerance >= 0 && tolerance <= 0.4))
    throw InvalidArgument("the tolerance of stitching must lie between 0 and 0.4, not " + std::to_string(tolerance));
  return Stitching(model, tolerance).result();
}

}  // namespace loopmend
