// SPDX-License-Identifier: GPL-3.0-or-later
#include "neighborhood/trim_boundary.h"

#include "core/error.h"
#include "mesh/mesh_arrays.h"
#include "mesh/pieces.h"
#include "mesh/quality.h"
#include "mesh/self_intersections.h"

#include <algorithm>
#include <map>
#include <numbers>
#include <numeric>
#include <optional>
#include <set>

namespace loopmend {

namespace {

constexpr double sliver_angle = 5 * std::numbers::pi / 180;
constexpr double spike_cosine = 0.5, flipped_cosine = -0.5;
/// Cosine between triangles of one plane, but for rounding.
constexpr double same_plane = 0.9999;
/// What crosses is followed inward further than what is merely bad: no patch is valid beside it.
constexpr int rounds_for_crossings = 10;

Vec3 normal_of(const SurfaceModel& model, int view_face) {
  const auto& [a, b, c] = model.soup.triangles[model.soup_face[view_face]];
  return unit_normal(model.soup.points[a], model.soup.points[b], model.soup.points[c]);
}

std::optional<BoundaryFault> fault_of(const SurfaceModel& model, int view_face) {
  const auto& [a, b, c] = model.soup.triangles[model.soup_face[view_face]];
  const Points& p = model.soup.points;
  std::vector<Vec3> beside;
  for (const auto f : model.mesh.ff_range(TriMesh::FaceHandle(view_face))) beside.push_back(normal_of(model, f.idx()));
  if (beside.size() <= 1) return BoundaryFault::dangling;
  if (min_angle(p[a], p[b], p[c]) < sliver_angle) return BoundaryFault::sliver;
  // Where the neighbours disagree among themselves, it is the surface that folds there, not the triangle.
  const Vec3 own = normal_of(model, view_face);
  const bool turned =
      std::any_of(beside.begin(), beside.end(), [&](const Vec3& n) { return own.dot(n) < flipped_cosine; });
  if (turned && beside[0].dot(beside[1]) > spike_cosine) return BoundaryFault::flipped;
  return std::nullopt;
}

/// The triangles at a boundary vertex that stands up out of what lies round about; else none.
std::vector<int> spike_at(const SurfaceModel& model, int view_vertex) {
  std::vector<int> fan;
  std::set<int> around;
  for (const auto f : model.mesh.vf_range(TriMesh::VertexHandle(view_vertex))) fan.push_back(f.idx());
  for (int f : fan)
    for (const auto v : model.mesh.fv_range(TriMesh::FaceHandle(f)))
      if (v.idx() != view_vertex)
        for (const auto g : model.mesh.vf_range(v)) around.insert(g.idx());
  for (int f : fan) around.erase(f);
  if (around.empty()) return {};
  Vec3 ground = Vec3::Zero();
  for (int f : around) ground += normal_of(model, f);
  ground.normalize();
  const bool stands =
      std::all_of(fan.begin(), fan.end(), [&](int f) { return normal_of(model, f).dot(ground) < spike_cosine; });
  // At a corner of a coarse bar, whose sides face all directions, a side goes on in its plane.
  const auto goes_on = [&](int f) {
    for (const auto g : model.mesh.ff_range(TriMesh::FaceHandle(f)))
      if (around.contains(g.idx()) && normal_of(model, f).dot(normal_of(model, g.idx())) > same_plane) return true;
    return false;
  };
  return stands && std::none_of(fan.begin(), fan.end(), goes_on) ? fan : std::vector<int>{};
}

/// View faces with this edge.
std::vector<int> faces_at(const SurfaceModel& model, int from, int to) {
  std::vector<int> faces;
  const auto edge = model.mesh.find_halfedge(TriMesh::VertexHandle(from), TriMesh::VertexHandle(to));
  if (!edge.is_valid()) return faces;
  for (const auto half : {edge, model.mesh.opposite_halfedge_handle(edge)}) {
    const auto face = model.mesh.face_handle(half);
    if (face.is_valid()) faces.push_back(face.idx());
  }
  return faces;
}

/// View faces with an edge on one of the loops that are holes.
std::set<int> boundary_faces(const SurfaceModel& model, const std::vector<BoundaryLoop>& loops) {
  std::set<int> faces;
  for (const BoundaryLoop& loop : loops) {
    if (loop.kind != LoopKind::hole) continue;
    for (std::size_t k = 0; k < loop.vertices.size(); ++k) {
      const std::vector<int> at = faces_at(model, loop.vertices[k], loop.vertices[(k + 1) % loop.vertices.size()]);
      faces.insert(at.begin(), at.end());
    }
  }
  return faces;
}

/// Which of the view faces cut others of the surface.
std::vector<int> crossing_faces(const SurfaceModel& model, const std::set<int>& faces) {
  std::vector<int> crossing;
  if (faces.empty()) return crossing;
  const Points points = points_of(model.mesh);
  const Triangles triangles = triangles_of(model.mesh);
  const TriangleIndex index(points, triangles);
  for (int f : faces) {
    const auto& [a, b, c] = triangles[f];
    const Vec3 low = points[a].cwiseMin(points[b]).cwiseMin(points[c]);
    const Vec3 high = points[a].cwiseMax(points[b]).cwiseMax(points[c]);
    Points corners;
    Triangles local;
    const auto add = [&](int face) {
      const int first = static_cast<int>(corners.size());
      for (int v : triangles[face]) corners.push_back(points[v]);
      local.push_back({first, first + 1, first + 2});
    };
    add(f);
    for (int g : index.near_box(low, high))
      if (g != f) add(g);
    if (!self_intersections(corners, local, 1).empty()) crossing.push_back(f);
  }
  return crossing;
}

std::set<int> soup_vertices(const SurfaceModel& model, const std::vector<BoundaryLoop>& loops) {
  std::set<int> vertices;
  for (const BoundaryLoop& loop : loops)
    for (int v : loop.vertices) vertices.insert(model.soup_vertex[v]);
  return vertices;
}

}  // namespace

const char* to_string(BoundaryFault fault) {
  switch (fault) {
    case BoundaryFault::dangling: return "dangling";
    case BoundaryFault::sliver: return "sliver";
    case BoundaryFault::spike: return "spike";
    case BoundaryFault::flipped: return "flipped";
    case BoundaryFault::crossing: return "crossing";
    case BoundaryFault::fragment: return "fragment";
  }
  return "";
}

std::vector<BadBoundaryFace> bad_boundary_faces(const SurfaceModel& model, const std::vector<BoundaryLoop>& loops) {
  std::map<int, BoundaryFault> faults;  // by soup triangle
  for (int f : boundary_faces(model, loops))
    if (const auto fault = fault_of(model, f)) faults.emplace(model.soup_face[f], *fault);
  for (const BoundaryLoop& loop : loops)
    if (loop.kind == LoopKind::hole)
      for (int v : loop.vertices)
        for (int f : spike_at(model, v)) faults.emplace(model.soup_face[f], BoundaryFault::spike);
  std::vector<BadBoundaryFace> bad;
  for (const auto& [face, fault] : faults) bad.push_back({face, fault, 1});
  return bad;
}

namespace {

/// To the other bad faces, by rising number.
void add_crossing_faces(const SurfaceModel& model, const std::vector<BoundaryLoop>& loops,
                        std::vector<BadBoundaryFace>& bad) {
  for (int f : crossing_faces(model, boundary_faces(model, loops))) {
    const BadBoundaryFace face{model.soup_face[f], BoundaryFault::crossing, 1};
    const auto at =
        std::lower_bound(bad.begin(), bad.end(), face,
                         [](const BadBoundaryFace& a, const BadBoundaryFace& b) { return a.face < b.face; });
    if (at == bad.end() || at->face != face.face) bad.insert(at, face);
  }
}

/// Faces whose edge on one of the loops that are holes runs through the surface, by rising number.
std::vector<BadBoundaryFace> pierced_faces(const SurfaceModel& model, const std::vector<BoundaryLoop>& loops) {
  std::set<int> faces;
  const TriangleSoup& soup = model.soup;
  const TriangleIndex index(soup.points, soup.triangles, triangles_outside(model));
  for (const BoundaryLoop& loop : loops) {
    if (loop.kind != LoopKind::hole) continue;
    for (std::size_t k = 0; k < loop.vertices.size(); ++k) {
      const int from = loop.vertices[k], to = loop.vertices[(k + 1) % loop.vertices.size()];
      const Vec3 &p = soup.points[model.soup_vertex[from]], &q = soup.points[model.soup_vertex[to]];
      if (!runs_through(soup.points, soup.triangles, index, p, q)) continue;
      for (int f : faces_at(model, from, to)) faces.insert(model.soup_face[f]);
    }
  }
  std::vector<BadBoundaryFace> bad;
  for (int f : faces) bad.push_back({f, BoundaryFault::crossing, 1});
  return bad;
}

/// Triangles of pieces of at most two that have one of these soup points: what trimming has cut off. Not the whole mesh.
std::vector<BadBoundaryFace> fragments_at(const SurfaceModel& model, const std::set<int>& points) {
  std::set<int> faces;
  const auto beside = [&](int f) {
    std::vector<int> others;
    for (const auto g : model.mesh.ff_range(TriMesh::FaceHandle(f))) others.push_back(g.idx());
    return others;
  };
  for (const auto f : model.mesh.faces()) {
    const Triangle& t = model.soup.triangles[model.soup_face[f.idx()]];
    if (std::none_of(t.begin(), t.end(), [&](int v) { return points.contains(v); })) continue;
    const std::vector<int> others = beside(f.idx());
    const bool alone = others.empty() || (others.size() == 1 && beside(others.front()).size() == 1);
    if (!alone) continue;
    faces.insert(model.soup_face[f.idx()]);
    for (int g : others) faces.insert(model.soup_face[g]);
  }
  std::vector<BadBoundaryFace> fragments;
  if (faces.size() == model.soup.triangles.size()) return fragments;
  for (int f : faces) fragments.push_back({f, BoundaryFault::fragment, 1});
  return fragments;
}

/// A surface that loses triangles round by round.
class Trimming {
 public:
  Trimming(const SurfaceModel& model, const std::vector<BoundaryLoop>& loops)
      : result_{model, {}, loops},
        original_(model.soup.triangles.size()),
        touched_(soup_vertices(model, loops)) {
    std::iota(original_.begin(), original_.end(), 0);
  }

  const SurfaceModel& model() const { return result_.model; }
  const std::vector<BoundaryLoop>& loops() const { return result_.loops; }

  /// @param bad  by rising number
  void remove(const std::vector<BadBoundaryFace>& bad, int round) {
    take(bad, round);
    if (const std::vector<BadBoundaryFace> fragments = fragments_at(result_.model, cut_); !fragments.empty())
      take(fragments, round);
    result_.loops.clear();
    for (BoundaryLoop& loop : find_boundary_loops(result_.model))
      if (std::any_of(loop.vertices.begin(), loop.vertices.end(),
                      [&](int v) { return touched_.contains(result_.model.soup_vertex[v]); }))
        result_.loops.push_back(std::move(loop));
  }

  /// What was removed, and these, by their numbers in the soup that was given.
  std::vector<BadBoundaryFace> with_removed(const std::vector<BadBoundaryFace>& bad) const {
    std::vector<BadBoundaryFace> all = result_.removed;
    for (const BadBoundaryFace& face : bad) all.push_back({original_[face.face], face.fault, face.ring});
    return all;
  }

  TrimmedModel take_result() { return std::move(result_); }

 private:
  void take(const std::vector<BadBoundaryFace>& bad, int round) {
    TriangleSoup left = result_.model.soup;
    left.triangles.clear();
    std::vector<int> points(left.points.size()), stay, numbers;
    std::iota(points.begin(), points.end(), 0);
    auto next = bad.begin();
    for (int f = 0; f < static_cast<int>(original_.size()); ++f) {
      const Triangle& t = result_.model.soup.triangles[f];
      if (next == bad.end() || next->face != f) {
        left.triangles.push_back(t);
        stay.push_back(f);
        numbers.push_back(original_[f]);
        continue;
      }
      result_.removed.push_back({original_[f], next->fault, round});
      touched_.insert(t.begin(), t.end());
      cut_.insert(t.begin(), t.end());
      ++next;
    }
    if (left.triangles.empty()) throw InvalidArgument(say("trimming the boundary would leave no triangle"));
    copy_rows(result_.model.soup, points, stay, left);
    original_ = std::move(numbers);
    result_.model = make_surface_model(std::move(left));
  }

  TrimmedModel result_;
  std::vector<int> original_;  ///< number of each triangle in the soup that was given
  std::set<int> touched_;      ///< soup points of the loops and of removed triangles
  std::set<int> cut_;          ///< those of removed triangles
};

/// How many of a soup's triangles lie in each part of its surface, and their area.
class PartSizes {
 public:
  struct Share {
    double faces, area;
  };

  explicit PartSizes(const SurfaceModel& model) : model_(model), part_of_(parts_of_points(model, count_)) {
    size_.resize(static_cast<std::size_t>(count_));
    for_each_soup_triangle(model, [&](int f) { size_[part(f)] += size_of(f); });
  }
  int part_at(int point) const { return part_of_[point]; }
  /// The parts of which these are more than the share.
  std::set<int> with_more(const std::vector<BadBoundaryFace>& faces, const Share& share) const {
    std::map<int, Size> bad;
    for (const BadBoundaryFace& face : faces) bad[part(face.face)] += size_of(face.face);
    std::set<int> parts;
    for (const auto& [part, size] : bad)
      if (size.faces > share.faces * size_[part].faces || size.area > share.area * size_[part].area) parts.insert(part);
    return parts;
  }
  int part(int face) const { return part_at(model_.soup.triangles[face][0]); }

 private:
  struct Size {
    double faces = 0, area = 0;
    Size& operator+=(const Size& other) {
      faces += other.faces;
      area += other.area;
      return *this;
    }
  };

  Size size_of(int face) const {
    const auto& [a, b, c] = model_.soup.triangles[face];
    const Points& p = model_.soup.points;
    return {1, (p[b] - p[a]).cross(p[c] - p[a]).norm()};
  }

  const SurfaceModel& model_;
  int count_ = 0;
  std::vector<int> part_of_;
  std::vector<Size> size_;
};

/// Ends once some parts have lost more than trimming takes.
/// @param spared  parts of the surface in which nothing is taken; those parts are added
/// @returns nothing where parts were added
std::optional<TrimmedModel> trimmed(const SurfaceModel& model, const std::vector<BoundaryLoop>& loops, int rounds,
                                    const PartSizes& parts, std::set<int>& spared) {
  Trimming trimming(model, loops);
  for (int round = 1; round <= (rounds > 0 ? std::max(rounds, rounds_for_crossings) : 0); ++round) {
    std::vector<BadBoundaryFace> bad;
    if (round <= rounds) bad = bad_boundary_faces(trimming.model(), trimming.loops());
    add_crossing_faces(trimming.model(), trimming.loops(), bad);
    std::erase_if(bad, [&](const BadBoundaryFace& face) {
      return spared.contains(parts.part_at(trimming.model().soup.triangles[face.face][0]));
    });
    if (bad.empty()) break;
    const std::set<int> more = parts.with_more(trimming.with_removed(bad), {largest_trim, largest_trim_of_area});
    if (!more.empty()) {
      spared.insert(more.begin(), more.end());
      return std::nullopt;
    }
    trimming.remove(bad, round);
  }
  return trimming.take_result();
}

/// Soup points of loops and removed triangles that hang together, by common points, with one of these.
std::set<int> points_around(const SurfaceModel& model, const std::vector<BoundaryLoop>& loops,
                            const std::vector<BadBoundaryFace>& removed, std::set<int> points) {
  std::vector<std::set<int>> parts;
  for (const BoundaryLoop& loop : loops) parts.push_back(soup_vertices(model, {loop}));
  for (const BadBoundaryFace& face : removed) {
    const Triangle& t = model.soup.triangles[face.face];
    parts.emplace_back(t.begin(), t.end());
  }
  const auto touches = [&](const std::set<int>& part) {
    return std::any_of(part.begin(), part.end(), [&](int v) { return points.contains(v); });
  };
  for (bool grows = true; grows;) {
    grows = false;
    for (std::set<int>& part : parts) {
      if (!touches(part)) continue;
      points.merge(part);
      part.clear();
      grows = true;
    }
  }
  return points;
}

}  // namespace

std::vector<BadBoundaryFace> few_of_their_pieces(const SurfaceModel& model, const std::vector<BadBoundaryFace>& bad) {
  if (bad.empty()) return {};
  const PartSizes parts(model);
  const std::set<int> coarse = parts.with_more(bad, {largest_proposed_trim, largest_proposed_trim});
  std::vector<BadBoundaryFace> few;
  for (const BadBoundaryFace& face : bad)
    if (!coarse.contains(parts.part(face.face))) few.push_back(face);
  return few;
}

TrimmedModel trim_boundary(const SurfaceModel& model, const std::vector<BoundaryLoop>& loops, int rounds) {
  if (rounds < 0 || rounds > 100)
    throw InvalidArgument(say("between 0 and 100 rings of a boundary can be trimmed, not %1", rounds));
  const PartSizes parts(model);
  std::set<int> spared;
  for (;;) {
    std::optional<TrimmedModel> result = trimmed(model, loops, rounds, parts, spared);
    if (!result) continue;
    result->spared = spared.size();
    return std::move(*result);
  }
}

TrimmedModel trim_pierced(const SurfaceModel& model, const std::vector<BoundaryLoop>& loops) {
  std::set<int> spared;  // soup points of boundaries where removing ends nothing
  for (;;) {
    Trimming trimming(model, loops);
    std::vector<BadBoundaryFace> bad;
    for (int round = 1;; ++round) {
      bad = pierced_faces(trimming.model(), trimming.loops());
      std::erase_if(bad, [&](const BadBoundaryFace& face) {
        const Triangle& t = trimming.model().soup.triangles[face.face];
        return std::any_of(t.begin(), t.end(), [&](int v) { return spared.contains(v); });
      });
      if (bad.empty() || round > rounds_for_crossings) break;
      trimming.remove(bad, round);
    }
    const TriangleSoup& left = trimming.model().soup;
    std::set<int> in_vain;
    for (const BadBoundaryFace& face : bad)
      in_vain.insert(left.triangles[face.face].begin(), left.triangles[face.face].end());
    TrimmedModel result = trimming.take_result();
    if (bad.empty()) return result;
    spared.merge(points_around(model, loops, result.removed, in_vain));
  }
}

}  // namespace loopmend
