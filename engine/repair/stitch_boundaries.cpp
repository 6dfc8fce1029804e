// SPDX-License-Identifier: GPL-3.0-or-later
#include "repair/stitch_boundaries.h"

#include "core/error.h"
#include "core/quantile.h"
#include "mesh/loop_facing.h"
#include "mesh/pieces.h"
#include "mesh/point_tree.h"
#include "mesh/triangulate_polygon.h"
#include "repair/zip_boundaries.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>
#include <set>
#include <tuple>
#include <vector>

namespace loopmend {

namespace {

namespace bg = boost::geometry;

/// Joined vertices lie nearer to each other than this share of the shortest boundary edge there, or a long triangle's short side would
/// be closed by its neighbours. Edges shorter than `no_edge` of the mean are slivers.
constexpr double share_of_shortest = 0.4, no_edge = 1e-3;
/// Longer boundary edges, in medians of all, count as if they were so long: those of spikes at missing data do not tell which vertices are near.
constexpr double longest_of_median = 10;
/// Two faces that would form a crevice narrower than 30 degrees, normals to normals: bodies that touch there, not sides of a crack.
constexpr double crevice = -0.866;
/// Sides of a gap round a whole body: lengths and centres agree within this share, and the surfaces run on towards each other at so many
/// vertices.
constexpr double zipped_agree = 0.25, zipped_share = 0.6;

/// A boundary edge of the soup, as it runs in its face.
struct BoundaryEdge {
  int face, corner;  ///< from this corner of the face to the next
  int from, to;      ///< soup points
  int loop;          ///< the boundary that it is on
};

class Stitching {
 public:
  Stitching(const SurfaceModel& model, const StitchTolerance& tolerance)
      : model_(model),
        soup_(model.soup),
        tolerance_(tolerance),
        parent_(model.soup.points.size()),
        size_(model.soup.points.size(), 0),
        is_zipped_(model.soup.points.size(), 0) {
    std::iota(parent_.begin(), parent_.end(), 0);
    find_boundary(model);
  }

  StitchedSurface result() {
    StitchedSurface stitched{soup_, 0, 0, 0};
    split(sew().cuts, stitched);
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

  bool zips_whole() {
    zip_whole_boundaries();
    return std::ranges::count(is_zipped_, 1) > 0;
  }

  NearBoundaries counts() {
    NearBoundaries near;
    const Sewing sewing = sew();
    for (int v = 0; v < static_cast<int>(parent_.size()); ++v)
      near.vertices += root(v) != v && soup_.points[v] != soup_.points[root(v)];
    near.faces = sewing.cuts.size();
    for (std::size_t k = 0; k < edges_.size(); ++k)
      if (sewing.open_parts[k] == 0) near.closing.emplace(edges_[k].from, edges_[k].to);
    return near;
  }

 private:
  using Sides = std::array<std::vector<int>, 3>;  ///< vertices on a face's side from each corner on

  void find_boundary(const SurfaceModel& model) {
    std::map<int, std::vector<double>> lengths;  // of the edges at each boundary vertex
    std::map<int, int> loop_of;                  // of boundary halfedges
    for (const auto h : model.mesh.halfedges()) {
      if (!model.mesh.is_boundary(h)) continue;
      for (auto next = h; loop_of.emplace(next.idx(), h.idx()).second;) next = model.mesh.next_halfedge_handle(next);
      const auto inner = model.mesh.opposite_halfedge_handle(h);
      if (is_cut_off(model, model.mesh.from_vertex_handle(h).idx()) ||
          is_cut_off(model, model.mesh.to_vertex_handle(h).idx()))
        continue;  // the view ends here, not the surface
      const int face = model.soup_face[model.mesh.face_handle(inner).idx()];
      const int from = model.soup_vertex[model.mesh.from_vertex_handle(inner).idx()];
      const int to = model.soup_vertex[model.mesh.to_vertex_handle(inner).idx()];
      const Triangle& t = soup_.triangles[face];
      const int corner = static_cast<int>(std::find(t.begin(), t.end(), from) - t.begin());
      edges_.push_back({face, corner, from, to, loop_of[h.idx()]});
      neighbors_.insert(std::minmax(from, to));
      const double length = (soup_.points[to] - soup_.points[from]).norm();
      for (int v : {from, to}) lengths[v].push_back(length);
    }
    std::vector<double> all;
    for (const auto& [v, here] : lengths) all.insert(all.end(), here.begin(), here.end());
    const double longest = longest_of_median * median(std::move(all));
    std::vector<std::pair<TreePoint, int>> entries;
    for (const auto& [v, here] : lengths) {
      size_[v] = std::min(size_of(here), longest);
      entries.emplace_back(tree_point(soup_.points[v]), v);
    }
    tree_ = PointTree(entries);
  }

  /// Their mean, or less where one is so short that `tolerance_` of the mean would reach along it.
  double size_of(const std::vector<double>& lengths) const {
    const double mean = std::accumulate(lengths.begin(), lengths.end(), 0.0) / static_cast<double>(lengths.size());
    double shortest = mean;
    for (double length : lengths)
      if (length > no_edge * mean) shortest = std::min(shortest, length);
    return tolerance_.edges > 0 ? std::min(mean, share_of_shortest / tolerance_.edges * shortest) : mean;
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

  struct Side {
    BoundaryLoop loop;
    LoopFacing facing;
    std::vector<int> points;  ///< of the soup, in the order of the loop
    int part = 0;             ///< of the surface
  };

  std::vector<Side> sides() const {
    int parts = 0;
    const std::vector<int> part_of = parts_of_points(model_, parts);
    std::vector<Side> result;
    if (parts < 2) return result;
    for (const BoundaryLoop& loop : find_boundary_loops(model_)) {
      if (loop.kind == LoopKind::cut) continue;
      std::vector<int> points;
      for (const int v : loop.vertices) points.push_back(model_.soup_vertex[v]);
      if (std::set<int>(points.begin(), points.end()).size() < points.size()) continue;
      const int part = part_of[points.front()];
      result.push_back({loop, loop_facing(model_, loop), std::move(points), part});
    }
    return result;
  }

  /// Whether the surfaces beyond both would meet, as those of two layers or of the sides of a plate do not.
  bool run_on_towards_each_other(const Side& a, const Side& b) const {
    std::size_t opposite = 0;
    for (std::size_t i = 0; i < a.points.size(); ++i) {
      const auto distance = [&](int v) { return (soup_.points[v] - soup_.points[a.points[i]]).squaredNorm(); };
      const auto nearest = std::ranges::min_element(b.points, {}, distance) - b.points.begin();
      opposite += a.facing.conormals[i].dot(b.facing.conormals[nearest]) < 0;
    }
    return static_cast<double>(opposite) >= zipped_share * static_cast<double>(a.points.size());
  }

  bool may_be_zipped(const Side& a, const Side& b) const {
    const auto mean_edge = [](const Side& side) { return side.loop.perimeter / side.loop.edges(); };
    const double limit = reach(std::min(mean_edge(a), mean_edge(b))), agree = zipped_agree * a.loop.diameter;
    return a.part != b.part && std::abs(a.loop.perimeter - b.loop.perimeter) < zipped_agree * a.loop.perimeter &&
           (a.loop.center - b.loop.center).norm() < agree && std::abs(a.loop.diameter - b.loop.diameter) < agree &&
           distance_all_along(soup_.points, a.points, b.points) <= limit && run_on_towards_each_other(a, b) &&
           run_on_towards_each_other(b, a);
  }

  /// Boundaries of two parts that lie within the tolerance of each other all along are matched from end to end: joined pair by pair, not all
  /// would close. Only with a tolerance that was asked for.
  void zip_whole_boundaries() {
    if (!tolerance_.length && tolerance_.edges <= StitchTolerance().edges) return;
    const std::vector<Side> all = sides();
    for (std::size_t i = 0; i < all.size(); ++i)
      for (std::size_t k = i + 1; k < all.size(); ++k) {
        const Side &a = all[i], &b = all[k];
        if (is_zipped_[a.points.front()] || is_zipped_[b.points.front()] || !may_be_zipped(a, b)) continue;
        if (const std::optional<ZippedBoundaries> zipped = zip_boundaries(soup_.points, a.points, b.points))
          take(*zipped);
      }
  }

  void take(const ZippedBoundaries& zipped) {
    for (const auto& [v, w] : zipped.pairs) {
      parent_[std::max(v, w)] = std::min(v, w);
      is_zipped_[v] = is_zipped_[w] = 1;
    }
    for (const auto& [ends, on] : zipped.on_edges)
      for (const int v : on) is_zipped_[v] = 1;
    for (const BoundaryEdge& e : edges_) {  // in its face the edge runs the other way
      const auto on = zipped.on_edges.find({e.to, e.from});
      if (on != zipped.on_edges.end())
        zipped_cuts_[e.face][static_cast<std::size_t>(e.corner)].assign(on->second.rbegin(), on->second.rend());
    }
  }

  /// The nearest pairs first; never two ends of one edge, nor by way of others, and no farther than the shortest edges of all that
  /// are joined allow.
  void join_near_vertices() {
    std::vector<std::tuple<double, int, int>> pairs;
    for (std::size_t v = 0; v < size_.size(); ++v) {
      if (size_[v] == 0 || is_zipped_[v]) continue;
      const Vec3 &p = soup_.points[v], box = Vec3::Constant(reach(size_[v]));
      for (int w : near(p - box, p + box)) {
        const double distance = (soup_.points[w] - p).norm();
        if (w > static_cast<int>(v) && !is_zipped_[w] && distance <= reach(std::min(size_[v], size_[w])))
          pairs.emplace_back(distance, static_cast<int>(v), w);
      }
    }
    std::sort(pairs.begin(), pairs.end());
    std::map<int, std::vector<int>> members;
    for (const auto& [distance, v, w] : pairs) {
      const int a = std::min(root(v), root(w)), b = std::max(root(v), root(w));
      if (a == b || distance > reach(std::min(size_[a], size_[b]))) continue;
      std::vector<int>&all = members[a], &more = members[b];
      if (all.empty()) all = {a};
      if (more.empty()) more = {b};
      const bool share_an_edge = std::any_of(all.begin(), all.end(), [&, &others = more](int x) {
        return std::any_of(others.begin(), others.end(), [&](int y) { return neighbors_.contains(std::minmax(x, y)); });
      });
      if (share_an_edge) continue;
      parent_[b] = a;
      size_[a] = std::min(size_[a], size_[b]);
      all.insert(all.end(), more.begin(), more.end());
      members.erase(b);
    }
  }

  /// How far a vertex may lie from a place, where boundary edges are so long.
  double reach(double edge) const { return tolerance_.length ? *tolerance_.length : tolerance_.edges * edge; }

  /// Boundary vertices that lie on an edge between its ends, in their order along it.
  std::vector<int> junctions_on(const BoundaryEdge& e) {
    const int apex = soup_.triangles[e.face][(e.corner + 2) % 3];
    const Vec3 &a = soup_.points[e.from], &b = soup_.points[e.to];
    const double length = (b - a).norm();
    if (!(length > 0)) return {};
    const Vec3 along = (b - a) / length, box = Vec3::Constant(reach(length));
    std::map<double, int> on;
    for (int v : near(a.cwiseMin(b) - box, a.cwiseMax(b) + box)) {
      if (is_zipped_[v] || root(v) == root(e.from) || root(v) == root(e.to) || root(v) == root(apex)) continue;
      const Vec3 d = soup_.points[v] - a;
      // Nearer to an end it would have been joined.
      const double t = along.dot(d), limit = reach(std::min(length, size_[v])),
                   end = std::min(limit, tolerance_.edges * length);
      if (t > end && t < length - end && (d - t * along).norm() <= limit) on.emplace(t, root(v));
    }
    std::vector<int> vertices;
    for (const auto& [t, v] : on)
      if (std::find(vertices.begin(), vertices.end(), v) == vertices.end()) vertices.push_back(v);
    return vertices;
  }

  /// The faces whose boundary edges pass boundary vertices.
  std::map<int, Sides> find_junctions() {
    std::set<std::pair<int, int>> directed;
    for (const BoundaryEdge& e : edges_) directed.insert({root(e.from), root(e.to)});
    std::map<int, Sides> cuts = zipped_cuts_;
    for (const BoundaryEdge& e : edges_) {
      if (is_zipped_[e.from] && is_zipped_[e.to]) continue;
      if (directed.contains({root(e.to), root(e.from)})) continue;  // zipped already
      std::vector<int> vertices = junctions_on(e);
      if (!vertices.empty()) cuts[e.face][static_cast<std::size_t>(e.corner)] = std::move(vertices);
    }
    return cuts;
  }

  /// What stitching does once vertices are joined.
  struct Sewing {
    std::map<int, Sides> cuts;           ///< of faces
    std::vector<int> parts, open_parts;  ///< of each boundary edge, once its face is cut: all, and those that stay open
  };

  /// Joins vertices and cuts faces where that closes edges; elsewhere surfaces only pass each other.
  Sewing sew() {
    zip_whole_boundaries();
    join_near_vertices();
    Sewing sewing = sewing_of(find_junctions());
    std::vector<char> closes(parent_.size(), 0);
    for (std::size_t k = 0; k < edges_.size(); ++k)
      if (sewing.open_parts[k] < sewing.parts[k]) closes[root(edges_[k].from)] = closes[root(edges_[k].to)] = 1;
    for (const auto& [face, sides] : sewing.cuts)
      for (const std::vector<int>& side : sides)
        for (int v : side) closes[v] = 1;
    std::vector<int> parent(parent_.size());
    for (int v = 0; v < static_cast<int>(parent.size()); ++v) parent[v] = closes[root(v)] ? root(v) : v;
    parent_ = std::move(parent);
    return sewing_of(std::move(sewing.cuts));
  }

  /// Whether two boundary edges, which would become one, may be the sides of a crack: those of one boundary, and those that lie on each
  /// other, always are.
  bool may_meet(int k, int l) const {
    const BoundaryEdge &a = edges_[static_cast<std::size_t>(k)], &b = edges_[static_cast<std::size_t>(l)];
    const Points& p = soup_.points;
    if (is_zipped_[a.from] && is_zipped_[a.to]) return true;
    if (a.loop == b.loop || (p[a.from] == p[b.to] && p[a.to] == p[b.from])) return true;
    const auto normal = [&](const BoundaryEdge& e) {
      const Triangle& t = soup_.triangles[e.face];
      return Vec3((p[t[1]] - p[t[0]]).cross(p[t[2]] - p[t[0]]).normalized());
    };
    const Triangle& t = soup_.triangles[b.face];
    const Vec3 beyond = (p[t[0]] + p[t[1]] + p[t[2]]) / 3 - p[a.from];
    return normal(a).dot(normal(b)) > crevice || normal(a).dot(beyond) <= 0;
  }

  /// Without the cuts that close nothing.
  Sewing sewing_of(std::map<int, Sides> cuts) {
    Sewing sewing{std::move(cuts), std::vector<int>(edges_.size(), 0), std::vector<int>(edges_.size(), 0)};
    std::map<std::pair<int, int>, std::vector<int>> parts;  // the edges that they come from
    for (std::size_t k = 0; k < edges_.size(); ++k) {
      const BoundaryEdge& e = edges_[k];
      int from = root(e.from);
      if (const auto cut = sewing.cuts.find(e.face); cut != sewing.cuts.end())
        for (int v : cut->second[static_cast<std::size_t>(e.corner)]) {
          parts[{from, v}].push_back(static_cast<int>(k));
          from = v;
        }
      parts[{from, root(e.to)}].push_back(static_cast<int>(k));
    }
    for (const auto& [part, of] : parts)
      for (int k : of) {
        const auto other = parts.find({part.second, part.first});
        ++sewing.parts[static_cast<std::size_t>(k)];
        sewing.open_parts[static_cast<std::size_t>(k)] +=
            other == parts.end() || std::ranges::none_of(other->second, [&](int l) { return may_meet(k, l); });
      }
    for (std::size_t k = 0; k < edges_.size(); ++k)
      if (const auto cut = sewing.cuts.find(edges_[k].face);
          cut != sewing.cuts.end() && sewing.open_parts[k] == sewing.parts[k])
        cut->second[static_cast<std::size_t>(edges_[k].corner)].clear();
    std::erase_if(sewing.cuts, [](const auto& cut) {
      return std::ranges::all_of(cut.second, [](const std::vector<int>& side) { return side.empty(); });
    });
    return sewing;
  }

  /// A face whose boundary edges pass boundary vertices of the other side becomes several.
  void split(const std::map<int, Sides>& cuts, StitchedSurface& stitched) {
    for (const auto& [face, sides] : cuts) {
      std::vector<int> polygon;
      for (std::size_t k = 0; k < 3; ++k) {
        polygon.push_back(root(soup_.triangles[face][k]));
        for (int v : sides[k])
          if (std::find(polygon.begin(), polygon.end(), v) == polygon.end()) polygon.push_back(v);
      }
      // Seen flat, no triangle lies along one side, as one between three vertices of a straight line would.
      Triangles parts = triangulate_seen_flat(soup_.points, polygon);
      if (parts.empty()) triangulate_polygon(soup_.points, polygon, parts);
      stitched.soup.triangles[face] = parts.front();
      stitched.soup.triangles.insert(stitched.soup.triangles.end(), parts.begin() + 1, parts.end());
      ++stitched.split_faces;
    }
  }

  const SurfaceModel& model_;
  const TriangleSoup& soup_;
  StitchTolerance tolerance_;
  std::vector<int> parent_;      // of soup points
  std::vector<double> size_;     // length of the boundary edges at each; 0 where there are none
  std::vector<char> is_zipped_;  // per soup point
  std::map<int, Sides> zipped_cuts_;
  std::vector<BoundaryEdge> edges_;
  std::set<std::pair<int, int>> neighbors_;  // ends of boundary edges
  PointTree tree_;
};

void check(const StitchTolerance& tolerance) {
  if (!(tolerance.edges >= 0 && tolerance.edges <= 0.4))
    throw InvalidArgument(say("the tolerance of stitching must lie between 0 and 0.4, not %1", tolerance.edges));
  if (tolerance.length && !(*tolerance.length >= 0 && std::isfinite(*tolerance.length)))
    throw InvalidArgument(say("the tolerance of stitching must be a length, not %1", *tolerance.length));
}

}  // namespace

StitchedSurface stitch_boundaries(const SurfaceModel& model, const StitchTolerance& tolerance) {
  check(tolerance);
  return Stitching(model, tolerance).result();
}

bool zips_whole_boundaries(const SurfaceModel& model, const StitchTolerance& tolerance) {
  check(tolerance);
  return Stitching(model, tolerance).zips_whole();
}

NearBoundaries near_boundaries(const SurfaceModel& model, const StitchTolerance& tolerance) {
  check(tolerance);
  return Stitching(model, tolerance).counts();
}

int closing_edges(const SurfaceModel& model, const BoundaryLoop& loop, const NearBoundaries& near) {
  int count = 0;
  for (std::size_t k = 0; k < loop.vertices.size(); ++k) {
    const int from = model.soup_vertex[loop.vertices[k]];
    const int to = model.soup_vertex[loop.vertices[(k + 1) % loop.vertices.size()]];
    count += near.closing.contains({to, from});  // in its face the edge runs the other direction
  }
  return count;
}

}  // namespace loopmend
