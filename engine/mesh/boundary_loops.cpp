// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/boundary_loops.h"

#include "core/quantile.h"
#include "mesh/by_position.h"
#include "mesh/loop_chords.h"
#include "mesh/loop_facing.h"
#include "mesh/pieces.h"
#include "mesh/point_diameter.h"
#include "mesh/vertex_fans.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>
#include <map>
#include <numbers>
#include <set>
#include <tuple>
#include <unordered_map>

namespace loopmend {

namespace {

/// A boundary whose geodesic curvature is above this share of 2π bounds a sheet; the end of a tube (0) and a hole (−1) do not. A
/// small loop that turns so is a hole at the tip of something.
constexpr double outer_rim_turning = 0.6, least_extent_of_a_turn = 0.2;
/// So does a boundary that runs round its whole piece where that is shallow and does not run on straight, as a tray's walls do: a
/// mask, or a ragged scan seen from one side, however its boundary turns.
constexpr double whole_extent = 0.84, sheet_depth = 0.475, straight_on = 0.9;
/// The two ends of a short tube, which turn to neither side, bound no sheet, however noise tilts their faces.
constexpr double turning_of_a_tube = 0.3;
/// A plane boundary behind which the surface reaches far is where something was cut, as a bell or a base with torn triangles at its
/// boundary, however it turns. Of the loops of 60 shared scans and cases one is plane, turns and has an extent below 0.84.
constexpr double plane_cut = 0.01;
/// Noise there makes it less plane, but not what the surface does behind: it leaves the plane (0.63 and more at eight noisy busts), and does
/// not at the outline of a terrain. Of 6 145 loops of shared scans and made-up ones no other is that plane, turns, and has that extent.
constexpr double noisy_plane_cut = 0.03, onward_at_cut = 0.5;
/// Along a long part, a slot that turns as a hole does is measured across: a rod is open there up to 75° on both sides. The outline of a
/// shared face (0.8 wide) turns so, too.
constexpr double widest_slot = 0.5;
/// Sides of a bent slot are so near to each other along four fifths of it, in perimeters, and so far from each other along the loop.
constexpr double near_sides = 1.0 / 60, far_along = 1.0 / 20, share_of_sides = 0.8;
/// An exact sphere (rms distance in radii; of coordinates in single precision 1e-7) with more than a cap of 45° left is no sheet.
constexpr double on_sphere = 1e-4, sphere_depth = 0.2;
/// Around a missing face of a part: a loop that is plane and turns, or not, by these figures. In single precision edges turn by 0.006°.
constexpr double exact_plane = 1e-5, straight_deg = 0.06, corner_deg = 3;
constexpr std::size_t edges_of_a_side = 2, most_corners = 16;
constexpr std::size_t coarse = 8;  ///< edges of a face of a part that is triangulated without vertices on its sides
/// The faces beside it rise from its plane by 20°: a tent without a floor, and no plate with a relief.
constexpr double onward_at_face = 0.35;
constexpr std::size_t most_places = 100;  ///< of a loop, from which its other side is sought

Points loop_points(const SurfaceModel& model, const BoundaryLoop& loop) {
  Points points;
  for (int v : loop.vertices) points.push_back(model.mesh.point(TriMesh::VertexHandle(v)));
  return points;
}

/// Corners and straight places alone, few corners. @param points  of a plane loop
bool is_polygon(const Points& points) {
  const std::size_t n = points.size();
  std::size_t corners = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const Vec3 to = points[i] - points[(i + n - 1) % n], from = points[(i + 1) % n] - points[i];
    const double turn = std::atan2(to.cross(from).norm(), to.dot(from)) * 180 / std::numbers::pi;
    if (turn > straight_deg && turn < corner_deg) return false;
    corners += turn >= corner_deg;
  }
  return corners >= 3 && (n <= coarse || (corners <= most_corners && edges_of_a_side * corners <= n));
}

void measure(const SurfaceModel& model, BoundaryLoop& loop) {
  const Points points = loop_points(model, loop);
  const std::size_t n = points.size();
  for (std::size_t i = 0; i < n; ++i) {
    loop.center += points[i] / static_cast<double>(n);
    loop.perimeter += (points[(i + 1) % n] - points[i]).norm();
  }
  loop.diameter = diameter_of(points);
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  Vec3 area_vector = Vec3::Zero();
  for (std::size_t i = 0; i < n; ++i) {
    const Vec3 d = points[i] - loop.center;
    covariance += d * d.transpose() / static_cast<double>(n);
    area_vector += d.cross(points[(i + 1) % n] - loop.center) / 2;
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> eigen(covariance);
  loop.planarity = loop.diameter > 0 ? std::sqrt(std::max(0.0, eigen.eigenvalues()[0])) / loop.diameter : 0;
  loop.is_polygon = loop.planarity <= exact_plane && is_polygon(points);
  loop.width = std::sqrt(8 * std::max(0.0, eigen.eigenvalues()[1]));
  loop.area = std::abs(area_vector.dot(eigen.eigenvectors().col(0)));
}

/// Distance between the sides of a slot, straight or bent; infinite where the loop has no two sides that run beside each other.
double between_sides(const SurfaceModel& model, const BoundaryLoop& loop) {
  const Points points = loop_points(model, loop);
  const std::size_t n = points.size();
  std::vector<double> along{0}, apart;
  for (std::size_t i = 0; i < n; ++i) along.push_back(along.back() + (points[(i + 1) % n] - points[i]).norm());
  for (std::size_t i = 0; i < n; i += 1 + n / most_places) {
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < n; ++k) {
      const double between = std::abs(along[k] - along[i]);
      if (std::min(between, loop.perimeter - between) >= far_along * loop.perimeter)
        least = std::min(least, (points[k] - points[i]).norm());
    }
    apart.push_back(least);
  }
  const double usual = quantile(apart, share_of_sides);
  return usual <= near_sides * loop.perimeter ? usual : std::numeric_limits<double>::infinity();
}

/// The edge from which the loop's positions, one after the other, come first in lexicographic order.
int first_by_position(const TriMesh& mesh, const std::vector<TriMesh::HalfedgeHandle>& edges) {
  const int n = static_cast<int>(edges.size());
  const auto point = [&](int i) -> const Vec3& { return mesh.point(mesh.from_vertex_handle(edges[i % n])); };
  int first = 0;
  for (int i = 1; i < n; ++i) {
    int k = 0;
    while (k < n && point(i + k) == point(first + k)) ++k;
    if (k < n && precedes(point(i + k), point(first + k))) first = i;
  }
  return first;
}

std::vector<BoundaryLoop> walk_loops(const SurfaceModel& model) {
  const TriMesh& mesh = model.mesh;
  std::vector<BoundaryLoop> loops;
  std::vector<char> seen(mesh.n_halfedges(), 0);
  for (const auto start : mesh.halfedges()) {
    if (!mesh.is_boundary(start) || seen[start.idx()]) continue;
    if (is_cut_off(model, mesh.from_vertex_handle(start).idx())) continue;
    std::vector<TriMesh::HalfedgeHandle> edges;
    for (auto h = start; !seen[h.idx()]; h = mesh.next_halfedge_handle(h)) {
      seen[h.idx()] = 1;
      edges.push_back(h);
    }
    std::rotate(edges.begin(), edges.begin() + first_by_position(mesh, edges), edges.end());
    BoundaryLoop loop;
    for (const auto h : edges) {
      loop.vertices.push_back(mesh.from_vertex_handle(h).idx());
      loop.turning += (gap_angle(mesh, h) - std::numbers::pi) / (2 * std::numbers::pi);
    }
    loops.push_back(std::move(loop));
  }
  return loops;
}

/// Faces of the soup at each of its edges that lie on a boundary of the view.
class SoupEdges {
 public:
  explicit SoupEdges(const SurfaceModel& model) {
    if (model.mesh.n_vertices() == 0 ||
        (model.repairs.non_manifold_edges == 0 && model.repairs.non_manifold_vertices == 0 &&
         model.repairs.duplicate_faces == 0))
      return;
    std::vector<char> on_boundary(model.soup.points.size(), 0);
    for (const auto v : model.mesh.vertices())
      if (model.mesh.is_boundary(v) && !is_cut_off(model, v.idx())) on_boundary[model.soup_vertex[v.idx()]] = 1;
    for (const Triangle& t : model.soup.triangles)  // also those that the view left out
      for (std::size_t k = 0; k < 3; ++k) {
        const int a = t[k], b = t[(k + 1) % 3];
        if (on_boundary[a] && on_boundary[b]) ++at_[key(a, b)].faces;
      }
    for (const auto h : model.mesh.halfedges())
      if (model.mesh.is_boundary(h))
        ++at_[key(model.soup_vertex[model.mesh.from_vertex_handle(h).idx()],
                  model.soup_vertex[model.mesh.to_vertex_handle(h).idx()])]
              .boundaries;
  }
  bool has_several_faces(int a, int b) const { return at(a, b).faces > 1; }
  /// Its two faces are in the view, which could not join them.
  bool is_one_sided(int a, int b) const { return at(a, b).faces == 2 && at(a, b).boundaries == 2; }

 private:
  static std::uint64_t key(int a, int b) {
    return (static_cast<std::uint64_t>(std::min(a, b)) << 32) | static_cast<std::uint32_t>(std::max(a, b));
  }
  struct At {
    int faces = 0, boundaries = 0;  ///< of the soup, of the view
  };
  At at(int a, int b) const {
    const auto found = at_.find(key(a, b));
    return found == at_.end() ? At{} : found->second;
  }
  std::unordered_map<std::uint64_t, At> at_;
};

/// Fills BoundaryLoop::coincident.
void count_coincident(const SurfaceModel& model, std::vector<BoundaryLoop>& loops) {
  using Place = std::array<double, 3>;
  const auto place = [&](int v) {
    const Vec3 p = model.mesh.point(TriMesh::VertexHandle(v));
    return Place{p.x(), p.y(), p.z()};
  };
  std::vector<std::pair<std::pair<Place, Place>, BoundaryLoop*>> edges;
  for (BoundaryLoop& loop : loops)
    for (std::size_t i = 0; i < loop.vertices.size(); ++i) {
      const Place a = place(loop.vertices[i]), b = place(loop.vertices[(i + 1) % loop.vertices.size()]);
      edges.push_back({std::minmax(a, b), &loop});
    }
  std::sort(edges.begin(), edges.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  for (std::size_t i = 0; i < edges.size();) {
    std::size_t j = i;
    while (j < edges.size() && edges[j].first == edges[i].first) ++j;
    for (std::size_t k = i; k < j && j - i > 1; ++k) ++edges[k].second->coincident;
    i = j;
  }
}

bool is_cut_off(const BoundaryLoop& loop) {
  if (loop.planarity <= plane_cut) return loop.extent <= whole_extent || loop.depth >= sheet_depth;
  return loop.planarity <= noisy_plane_cut && loop.onward >= onward_at_cut && loop.extent <= whole_extent;
}

bool is_around_a_face(const BoundaryLoop& loop) { return loop.is_polygon && loop.onward >= onward_at_face; }

bool turns_like_a_sheet(const BoundaryLoop& loop) {
  return loop.turning > outer_rim_turning && loop.extent > least_extent_of_a_turn && !is_cut_off(loop) &&
         !is_around_a_face(loop) && !loop.on_sphere;
}

bool runs_round_a_sheet(const BoundaryLoop& loop) {
  const bool is_slot = loop.turning < 0 && loop.width < widest_slot * loop.diameter;
  const double across = is_slot ? loop.width : loop.diameter;
  return !loop.on_sphere && !loop.ends_tube && !is_around_a_face(loop) && loop.extent > whole_extent &&
         loop.depth * loop.diameter < sheet_depth * across && loop.onward < straight_on;
}

/// The sphere ‖p‖² = 2⟨c, p⟩ + d nearest to some points, by least squares of this equation.
class SphereSums {
 public:
  void add(const Vec3& p) {
    const Eigen::Vector4d row(2 * p.x(), 2 * p.y(), 2 * p.z(), 1);
    A_ += row * row.transpose();
    b_ += row * p.squaredNorm();
    squares_ += p.squaredNorm() * p.squaredNorm();
    ++count_;
  }
  /// rms distance of the points from the sphere, in its radius.
  double misfit() const {
    const Eigen::Vector4d x = A_.ldlt().solve(b_);
    const double radius2 = x.head<3>().squaredNorm() + x[3];
    return std::sqrt(std::max(0.0, squares_ - b_.dot(x)) / count_) / (2 * radius2);
  }

 private:
  Eigen::Matrix4d A_ = Eigen::Matrix4d::Zero();
  Eigen::Vector4d b_ = Eigen::Vector4d::Zero();
  double squares_ = 0;
  int count_ = 0;
};

/// Whether it runs along an edge of the scan that has several faces.
bool is_cut(const SurfaceModel& model, const BoundaryLoop& loop, const SoupEdges& edges) {
  for (std::size_t i = 0; i < loop.vertices.size(); ++i) {
    const int next = loop.vertices[(i + 1) % loop.vertices.size()];
    if (edges.has_several_faces(model.soup_vertex[loop.vertices[i]], model.soup_vertex[next])) return true;
  }
  return false;
}

/// Fills onward, extent, ends_tube, depth and on_sphere. The last two are measured only where they may matter.
void measure_beside_pieces(const SurfaceModel& model, const Pieces& pieces, const SoupEdges& edges,
                           std::vector<BoundaryLoop>& loops) {
  std::map<int, std::vector<std::pair<BoundaryLoop*, Vec3>>>
      at_piece;  // loops whose depth is asked for, and their axes
  for (BoundaryLoop& loop : loops) {
    const LoopFacing facing = loop_facing(model, loop);
    loop.onward = facing.onward.norm();
    const int piece = pieces.beside(loop);
    Eigen::AlignedBox3d box;
    for (const int v : loop.vertices) box.extend(model.mesh.point(TriMesh::VertexHandle(v)));
    loop.extent = box.diagonal().norm() / pieces.box(piece).diagonal().norm();
    if (loop.extent > whole_extent && loop.turning < 0) loop.width = std::min(loop.width, between_sides(model, loop));
    if (loop.extent > whole_extent && loop.diameter > 0) at_piece[piece].emplace_back(&loop, facing.axis);
  }
  for (const auto& [piece, asked] : at_piece) {
    const auto ends = [&](const auto& entry) {
      return std::abs(entry.first->turning) < turning_of_a_tube && !is_cut(model, *entry.first, edges);
    };
    if (std::ranges::count_if(asked, ends) < 2) continue;
    for (const auto& entry : asked) entry.first->ends_tube = ends(entry);
  }
  if (at_piece.empty()) return;
  std::map<const BoundaryLoop*, SphereSums> spheres;
  pieces.for_each_point([&](int piece, const Vec3& point) {
    const auto asked = at_piece.find(piece);
    if (asked == at_piece.end()) return;
    for (const auto& [loop, axis] : asked->second) {
      const Vec3 place = (point - loop->center) / loop->diameter;
      loop->depth = std::max(loop->depth, std::abs(axis.dot(place)));
      spheres[loop].add(place);
    }
  });
  for (const auto& [piece, asked] : at_piece)
    for (const auto& [loop, axis] : asked)
      loop->on_sphere = loop->depth > sphere_depth && spheres.at(loop).misfit() < on_sphere;
}

/// Loops of three edges whose triangle lies at the same place already, on another sheet.
std::set<int> covered_triangles(const SurfaceModel& model, const std::vector<BoundaryLoop>& loops) {
  using Place = std::array<double, 3>;
  const auto place = [](const Vec3& p) { return Place{p.x(), p.y(), p.z()}; };
  std::map<Place, std::vector<int>> loops_at;  // by their first place
  std::map<int, std::array<Place, 3>> places;
  for (std::size_t k = 0; k < loops.size(); ++k) {
    if (loops[k].edges() != 3) continue;
    std::array<Place, 3>& sorted = places[static_cast<int>(k)];
    for (int i = 0; i < 3; ++i) sorted[i] = place(model.mesh.point(TriMesh::VertexHandle(loops[k].vertices[i])));
    std::sort(sorted.begin(), sorted.end());
    loops_at[sorted[0]].push_back(static_cast<int>(k));
  }
  std::set<int> covered;
  if (places.empty()) return covered;
  for_each_soup_triangle(model, [&](int f) {
    std::array<Place, 3> sorted;
    for (int i = 0; i < 3; ++i) sorted[i] = place(model.soup.points[model.soup.triangles[f][i]]);
    std::sort(sorted.begin(), sorted.end());
    const auto found = loops_at.find(sorted[0]);
    if (found == loops_at.end()) return;
    for (int k : found->second)
      if (places.at(k) == sorted) covered.insert(k);
  });
  return covered;
}

/// By falling perimeter. Ends of one tube are equally long but for rounding: there, only the order of vertices in the file tells
/// which comes first, and is kept to, so that the numbers that a person knows stay. No patch depends on them (group_loops).
void sort_by_perimeter(const SurfaceModel& model, std::vector<BoundaryLoop>& loops) {
  std::vector<std::tuple<double, int, std::size_t>> order;  // −perimeter, summed from the lowest vertex on; that vertex
  for (std::size_t l = 0; l < loops.size(); ++l) {
    const std::vector<int>& vertices = loops[l].vertices;
    const std::size_t n = vertices.size();
    const auto lowest = static_cast<std::size_t>(std::min_element(vertices.begin(), vertices.end()) - vertices.begin());
    const auto point = [&](std::size_t i) -> const Vec3& {
      return model.mesh.point(TriMesh::VertexHandle(vertices[(lowest + i) % n]));
    };
    double perimeter = 0;
    for (std::size_t i = 0; i < n; ++i) perimeter += (point(i + 1) - point(i)).norm();
    order.emplace_back(-perimeter, vertices[lowest], l);
  }
  std::sort(order.begin(), order.end());
  std::vector<BoundaryLoop> sorted;
  for (const auto& [perimeter, lowest, l] : order) sorted.push_back(std::move(loops[l]));
  loops = std::move(sorted);
}

/// Fills BoundaryLoop::one_sided.
LoopKind kind_of(const SurfaceModel& model, BoundaryLoop& loop, const SoupEdges& edges) {
  const std::size_t n = loop.vertices.size();
  int cut = 0, one_sided = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const int a = model.soup_vertex[loop.vertices[i]], b = model.soup_vertex[loop.vertices[(i + 1) % n]];
    cut += edges.has_several_faces(a, b);
    one_sided += edges.is_one_sided(a, b);
  }
  loop.one_sided = cut > 0 && one_sided == cut;
  if (cut > 0) return LoopKind::cut;
  if (loop.coincident == loop.edges()) return LoopKind::crack;
  return is_shaped_like_a_hole(loop) ? LoopKind::hole : LoopKind::outer_rim;
}

}  // namespace

bool is_shaped_like_a_hole(const BoundaryLoop& loop) { return !turns_like_a_sheet(loop) && !runs_round_a_sheet(loop); }

const char* to_string(LoopKind kind) {
  switch (kind) {
    case LoopKind::hole: return "hole";
    case LoopKind::outer_rim: return "outer rim";
    case LoopKind::crack: return "crack";
    case LoopKind::cut: return "cut";
  }
  return "";
}

Message why_outer_rim(const BoundaryLoop& loop) {
  if (loop.kind != LoopKind::outer_rim) return {};
  if (turns_like_a_sheet(loop)) return say("the surface lies inside the loop");
  char depth[32];
  std::snprintf(depth, sizeof depth, "%.2f", loop.depth);
  return say("its component is only %1 loop diameters deep", depth);
}

std::vector<BoundaryLoop> find_boundary_loops(const SurfaceModel& model) {
  std::vector<BoundaryLoop> loops = walk_loops(model);
  const SoupEdges edges(model);
  count_coincident(model, loops);
  if (loops.empty()) return loops;
  for (BoundaryLoop& loop : loops) measure(model, loop);
  measure_beside_pieces(model, Pieces(model), edges, loops);
  for (BoundaryLoop& loop : loops) loop.kind = kind_of(model, loop, edges);
  for (int k : covered_triangles(model, loops))
    if (loops[k].kind == LoopKind::hole) loops[k].kind = LoopKind::crack;
  find_taken_chords(model, loops);
  sort_by_perimeter(model, loops);
  for (std::size_t k = 0; k < loops.size(); ++k) loops[k].number = static_cast<int>(k) + 1;
  return loops;
}

}  // namespace loopmend
