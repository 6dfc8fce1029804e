// SPDX-License-Identifier: GPL-3.0-or-later
#include "remeshing/constrained_remesher.h"

#include "mesh/quality.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Spatial_sort_traits_adapter_3.h>
#include <CGAL/hilbert_sort.h>
#include <boost/property_map/function_property_map.hpp>

#include <Eigen/Geometry>
#include <algorithm>

#include <cmath>
#include <numbers>
#include <set>

namespace loopmend {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;

const double guard_cosine = std::cos(80 * std::numbers::pi / 180);

/// The guard: at least as good as before, or good enough.
bool allowed(double after, double before) { return after >= std::min(guard_cosine, before); }

double cosine(const Vec3& a, const Vec3& b) { return a.isZero() || b.isZero() ? -1 : a.dot(b); }

/// Collapsed edges and what goes with them are marked.
void request_status(TriMesh& mesh) {
  mesh.request_vertex_status();
  mesh.request_edge_status();
  mesh.request_face_status();
}

}  // namespace

ConstrainedRemesher::ConstrainedRemesher(const Points& points, const Triangles& triangles, int locked,
                                         const BoundaryNormals& boundary_normals, TargetSize target_size)
    : locked_(locked),
      target_size_(std::move(target_size)) {
  request_status(mesh_);
  for (const Vec3& p : points) {
    mesh_.add_vertex(p);
    size_.push_back(target_size_(p));
  }
  for (const Triangle& t : triangles) mesh_.add_face(VH(t[0]), VH(t[1]), VH(t[2]));
  set_boundary_normals(boundary_normals);
  normal_.resize(mesh_.n_faces());
  for (const auto f : mesh_.faces()) update_normal(f);
}

void ConstrainedRemesher::set_boundary_normals(const BoundaryNormals& boundary_normals) {
  boundary_normal_.assign(mesh_.n_edges(), Vec3::Zero());
  for (const auto& [edge, normal] : boundary_normals) {
    const HH h = mesh_.find_halfedge(VH(edge.first), VH(edge.second));
    if (h.is_valid()) boundary_normal_[mesh_.edge_handle(h).idx()] = normal;
  }
}

double ConstrainedRemesher::length(EH e) const {
  const HH h = mesh_.halfedge_handle(e, 0);
  return (mesh_.point(mesh_.to_vertex_handle(h)) - mesh_.point(mesh_.from_vertex_handle(h))).norm();
}

double ConstrainedRemesher::target(EH e) const {
  const HH h = mesh_.halfedge_handle(e, 0);
  return (size_[mesh_.to_vertex_handle(h).idx()] + size_[mesh_.from_vertex_handle(h).idx()]) / 2;
}

void ConstrainedRemesher::update_normal(FH f) {
  const HH h = mesh_.halfedge_handle(f);
  normal_[f.idx()] = unit_normal(mesh_.point(mesh_.from_vertex_handle(h)), mesh_.point(mesh_.to_vertex_handle(h)),
                                 mesh_.point(mesh_.to_vertex_handle(mesh_.next_halfedge_handle(h))));
}

void ConstrainedRemesher::update_normals_around(VH v) {
  normal_.resize(mesh_.n_faces());
  for (const auto f : mesh_.vf_range(v)) update_normal(f);
}

/// Normal on the other side of h; on the boundary that of the neighborhood, or this face's own where there are none.
Vec3 ConstrainedRemesher::normal_across(HH h) const {
  const HH other = mesh_.opposite_halfedge_handle(h);
  if (!mesh_.is_boundary(other)) return face_normal(mesh_.face_handle(other));
  const Vec3& boundary = boundary_normal_[mesh_.edge_handle(h).idx()];
  return boundary.isZero() ? face_normal(mesh_.face_handle(h)) : boundary;
}

double ConstrainedRemesher::edge_cosine(EH e) const {
  HH h = mesh_.halfedge_handle(e, 0);
  if (mesh_.is_boundary(h)) h = mesh_.opposite_halfedge_handle(h);
  return cosine(face_normal(mesh_.face_handle(h)), normal_across(h));
}

/// Worst cosine over the spokes and the link of v.
double ConstrainedRemesher::fan_worst(VH v) const {
  double worst = 1;
  for (const auto h : mesh_.voh_range(v)) {
    if (mesh_.is_boundary(h)) continue;
    const Vec3& normal = face_normal(mesh_.face_handle(h));
    const HH link = mesh_.next_halfedge_handle(h), spoke = mesh_.opposite_halfedge_handle(h);
    if (!mesh_.is_boundary(spoke)) worst = std::min(worst, cosine(normal, face_normal(mesh_.face_handle(spoke))));
    const HH across = mesh_.opposite_halfedge_handle(link);
    if (!mesh_.is_boundary(across))
      worst = std::min(worst, cosine(normal, face_normal(mesh_.face_handle(across))));
    else if (const Vec3& boundary = boundary_normal_[mesh_.edge_handle(link).idx()]; !boundary.isZero())
      worst = std::min(worst, cosine(normal, boundary));
  }
  return worst;
}

/// The same, were v, which is not on the boundary, at `position`; the normals are left in fan_.
double ConstrainedRemesher::fan_worst(VH v, const Vec3& position) {
  double worst = 1;
  fan_.clear();
  for (const auto h : mesh_.voh_range(v)) {
    const HH link = mesh_.next_halfedge_handle(h), begin = mesh_.halfedge_handle(mesh_.face_handle(h));
    const Vec3* const corner[] = {&position, &mesh_.point(mesh_.from_vertex_handle(link)),
                                  &mesh_.point(mesh_.to_vertex_handle(link))};
    const int k = begin == h ? 0 : begin == link ? 1 : 2;  // the bits of update_normal()
    const Vec3 normal = unit_normal(*corner[k], *corner[(k + 1) % 3], *corner[(k + 2) % 3]);
    const HH across = mesh_.opposite_halfedge_handle(link);
    if (!mesh_.is_boundary(across))
      worst = std::min(worst, cosine(normal, face_normal(mesh_.face_handle(across))));
    else if (const Vec3& boundary = boundary_normal_[mesh_.edge_handle(link).idx()]; !boundary.isZero())
      worst = std::min(worst, cosine(normal, boundary));
    if (!fan_.empty()) worst = std::min(worst, cosine(fan_.back(), normal));
    fan_.push_back(normal);
  }
  return fan_.empty() ? -1 : std::min(worst, cosine(fan_.back(), fan_.front()));
}

/// Worst cosine over the edges of the faces around v and u; of those that would be left, with u at `*place`, if v were
/// collapsed into u.
double ConstrainedRemesher::pair_worst(HH h, const Vec3* place) const {
  const VH v = mesh_.from_vertex_handle(h), u = mesh_.to_vertex_handle(h);
  const auto gone = [&](FH f) {
    return place && (f == mesh_.face_handle(h) || f == mesh_.face_handle(mesh_.opposite_halfedge_handle(h)));
  };
  const auto corner = [&](VH w) { return place && (w == v || w == u) ? *place : Vec3(mesh_.point(w)); };
  const auto touches = [&](FH f) {
    for (const auto w : mesh_.fv_range(f))
      if (w == v || w == u) return true;
    return false;
  };
  const auto normal = [&](FH f) -> Vec3 {
    if (!place || !touches(f)) return face_normal(f);
    const HH first = mesh_.halfedge_handle(f);
    return unit_normal(corner(mesh_.from_vertex_handle(first)), corner(mesh_.to_vertex_handle(first)),
                       corner(mesh_.to_vertex_handle(mesh_.next_halfedge_handle(first))));
  };
  double worst = 1;
  // Around each of the two, every face is compared with those across its three sides; a side onto a face that goes is
  // compared with what lies beyond that face.
  for (const VH centre : {v, u})
    for (const auto spoke : mesh_.voh_range(centre)) {
      if (mesh_.is_boundary(spoke)) continue;
      const FH f = mesh_.face_handle(spoke);
      if (gone(f)) continue;
      const Vec3 own = normal(f);
      HH side = spoke;
      for (int k = 0; k < 3; ++k, side = mesh_.next_halfedge_handle(side)) {
        HH across = mesh_.opposite_halfedge_handle(side);
        if (!mesh_.is_boundary(across) && gone(mesh_.face_handle(across))) across = beyond_collapsed(across, h);
        if (!mesh_.is_boundary(across)) {
          worst = std::min(worst, cosine(own, normal(mesh_.face_handle(across))));
        } else if (const Vec3& boundary = boundary_normal_[mesh_.edge_handle(across).idx()]; !boundary.isZero()) {
          worst = std::min(worst, cosine(own, boundary));
        }
      }
    }
  return worst;
}

/// `side` is a halfedge of a face that goes with the collapse of h: the halfedge from outside onto its other lasting side.
ConstrainedRemesher::HH ConstrainedRemesher::beyond_collapsed(HH side, HH h) const {
  const EH collapsed = mesh_.edge_handle(h);
  const HH next = mesh_.next_halfedge_handle(side), previous = mesh_.prev_halfedge_handle(side);
  return mesh_.opposite_halfedge_handle(mesh_.edge_handle(next) == collapsed ? previous : next);
}

bool ConstrainedRemesher::guarded_move(VH v, const Vec3& position) {
  const double after = fan_worst(v, position);
  if (after < guard_cosine && after < fan_worst(v)) return false;
  mesh_.set_point(v, position);
  auto normal = fan_.cbegin();
  for (const auto h : mesh_.voh_range(v)) normal_[mesh_.face_handle(h).idx()] = *normal++;
  return true;
}

void ConstrainedRemesher::scale_sizes(double factor) {
  coarser_ *= factor;
  for (double& size : size_) size *= factor;
}

void ConstrainedRemesher::sort_in_space() {
  BoundaryNormals boundary_normals;
  for (const auto e : mesh_.edges())
    if (mesh_.is_boundary(e) && !boundary_normal_[e.idx()].isZero()) {
      const HH h = mesh_.halfedge_handle(e, 0);
      boundary_normals[{mesh_.from_vertex_handle(h).idx(), mesh_.to_vertex_handle(h).idx()}] =
          boundary_normal_[e.idx()];
    }
  std::vector<VH> order;
  for (const auto v : mesh_.vertices()) order.push_back(v);
  const auto places = boost::make_function_property_map<VH>(
      [this](VH v) { return Kernel::Point_3(mesh_.point(v)[0], mesh_.point(v)[1], mesh_.point(v)[2]); });
  CGAL::hilbert_sort(order.begin() + locked_, order.end(),
                     CGAL::Spatial_sort_traits_adapter_3<Kernel, decltype(places)>(places));
  std::vector<int> number(mesh_.n_vertices(), -1);
  TriMesh sorted;
  request_status(sorted);
  std::vector<double> sizes;
  for (const VH v : order) {
    number[v.idx()] = sorted.add_vertex(mesh_.point(v)).idx();
    sizes.push_back(size_[v.idx()]);
  }
  Triangles triangles;
  for (const auto f : mesh_.faces()) {
    Triangle t;
    int k = 0;
    for (const auto v : mesh_.fv_range(f)) t[k++] = number[v.idx()];
    triangles.push_back(t);
  }
  std::sort(triangles.begin(), triangles.end(), [](const Triangle& a, const Triangle& b) {
    return std::max({a[0], a[1], a[2]}) < std::max({b[0], b[1], b[2]});
  });
  for (const Triangle& t : triangles) sorted.add_face(VH(t[0]), VH(t[1]), VH(t[2]));
  mesh_ = std::move(sorted);
  size_ = std::move(sizes);
  set_boundary_normals(boundary_normals);
  normal_.resize(mesh_.n_faces());
  for (const auto f : mesh_.faces()) update_normal(f);
}

/// A long boundary edge cannot be split. Each split beside it halves the height over it, down to vertices on the edge.
bool ConstrainedRemesher::is_close_to_long_boundary(EH e, const Vec3& middle) const {
  constexpr double long_edge = 3, close = 0.5;  // in target lengths
  for (const int k : {0, 1})
    for (const auto side : mesh_.fh_range(mesh_.face_handle(mesh_.halfedge_handle(e, k)))) {
      if (!mesh_.is_boundary(side.edge()) || length(side.edge()) < long_edge * target(e)) continue;
      const Vec3 along = mesh_.calc_edge_vector(side).normalized();
      if (along.cross(middle - mesh_.point(side.from())).norm() < close * target(e)) return true;
    }
  return false;
}

int ConstrainedRemesher::split_long_edges() {
  int count = 0;
  for (int pass = 0, before = -1; pass < 10 && count > before; ++pass) {
    before = count;
    std::vector<std::pair<double, int>> queue;
    for (const auto e : mesh_.edges()) {
      if (mesh_.is_boundary(e)) continue;
      const bool chord = is_locked(e.v0()) && is_locked(e.v1());
      const double ratio = length(e) / target(e);
      if (ratio > (chord ? 0.5 : 4.0 / 3)) queue.emplace_back(-std::round(6 * std::log(ratio)), e.idx());
    }
    std::sort(queue.begin(), queue.end());
    ask_watch();
    for (const auto& [ratio, index] : queue) {
      if (mesh_.n_vertices() % 4096 == 0) ask_watch();
      const EH e(index);
      const Vec3 middle = mesh_.calc_edge_midpoint(e);
      if (is_close_to_long_boundary(e, middle)) continue;
      const VH v = mesh_.add_vertex(middle);
      size_.resize(mesh_.n_vertices());
      size_[v.idx()] = std::min(target(e), coarser_ * target_size_(middle));
      mesh_.split(e, v);
      ++count;
      boundary_normal_.resize(mesh_.n_edges(), Vec3::Zero());
      update_normals_around(v);
    }
  }
  return count;
}

bool ConstrainedRemesher::collapse_guarded(HH h) {
  const VH v = mesh_.from_vertex_handle(h), u = mesh_.to_vertex_handle(h);
  if (is_locked(v)) return false;
  const Vec3 place = is_locked(u) ? Vec3(mesh_.point(u)) : Vec3((mesh_.point(u) + mesh_.point(v)) / 2);
  for (const auto w : mesh_.vv_range(v)) {
    if (w == u) continue;
    if (is_locked(u) && is_locked(w) && !mesh_.find_halfedge(u, w).is_valid()) return false;
    if ((mesh_.point(w) - place).norm() > 4.0 / 3 * (size_[w.idx()] + size_[u.idx()]) / 2) return false;
  }
  // The dearer questions last.
  if (!mesh_.is_collapse_ok(h)) return false;
  const double after = pair_worst(h, &place);
  if (after < guard_cosine && after < pair_worst(h, nullptr)) return false;
  mesh_.collapse(h);
  mesh_.set_point(u, place);
  update_normals_around(u);
  return true;
}

int ConstrainedRemesher::collapse_short_edges() {
  ask_watch();
  int count = 0;
  std::vector<std::pair<double, int>> queue;
  for (const auto e : mesh_.edges()) {
    const double ratio = length(e) / target(e);
    if (!mesh_.is_boundary(e) && ratio < 0.75) queue.emplace_back(ratio, e.idx());
  }
  std::sort(queue.begin(), queue.end());
  for (const auto& [ratio, index] : queue) {
    const EH e(index);
    if (mesh_.status(e).deleted() || length(e) >= 0.75 * target(e)) continue;
    if (collapse_guarded(mesh_.halfedge_handle(e, 0)) || collapse_guarded(mesh_.halfedge_handle(e, 1))) ++count;
  }
  // Faces, edges and vertices keep their numbers until points() and triangles() are asked for: no garbage collection.
  return count;
}

bool ConstrainedRemesher::opposite_angles_exceed_pi(EH e) const {
  // sin(α + β) < 0, without the angles themselves; α and β up to the same positive factor.
  double sine[2], cosine_of[2];
  for (int side : {0, 1}) {
    const HH h = mesh_.halfedge_handle(e, side);
    const Vec3 apex = mesh_.point(mesh_.to_vertex_handle(mesh_.next_halfedge_handle(h)));
    const Vec3 a = mesh_.point(mesh_.from_vertex_handle(h)) - apex, b = mesh_.point(mesh_.to_vertex_handle(h)) - apex;
    const double lengths = a.norm() * b.norm();
    sine[side] = a.cross(b).norm() / lengths;
    cosine_of[side] = a.dot(b) / lengths;
  }
  return sine[0] * cosine_of[1] + cosine_of[0] * sine[1] < -1e-6;
}

bool ConstrainedRemesher::flip_guarded(EH e) {
  if (mesh_.is_boundary(e) || !mesh_.is_flip_ok(e)) return false;
  const HH h = mesh_.halfedge_handle(e, 0), o = mesh_.halfedge_handle(e, 1);
  const HH sides[4] = {mesh_.next_halfedge_handle(h), mesh_.prev_halfedge_handle(h), mesh_.next_halfedge_handle(o),
                       mesh_.prev_halfedge_handle(o)};  // b→c, c→a, a→d, d→b
  const VH c = mesh_.to_vertex_handle(sides[0]), d = mesh_.to_vertex_handle(sides[2]);
  if (is_locked(c) && is_locked(d)) return false;
  const Vec3 &pa = mesh_.point(mesh_.from_vertex_handle(h)), &pb = mesh_.point(mesh_.to_vertex_handle(h));
  const Vec3 &pc = mesh_.point(c), &pd = mesh_.point(d);
  const Vec3 left = unit_normal(pa, pd, pc), right = unit_normal(pd, pb, pc);  // the triangles after the flip
  const Vec3* after_of[4] = {&right, &left, &left, &right};
  double before = cosine(face_normal(mesh_.face_handle(h)), face_normal(mesh_.face_handle(o)));
  double after = cosine(left, right);
  for (int k = 0; k < 4; ++k) {
    const HH across = mesh_.opposite_halfedge_handle(sides[k]);
    const bool boundary = mesh_.is_boundary(across);
    const Vec3& beyond =
        boundary ? boundary_normal_[mesh_.edge_handle(across).idx()] : face_normal(mesh_.face_handle(across));
    if (boundary && beyond.isZero()) continue;
    before = std::min(before, cosine(face_normal(mesh_.face_handle(sides[k])), beyond));
    after = std::min(after, cosine(*after_of[k], beyond));
  }
  if (!allowed(after, before)) return false;
  mesh_.flip(e);
  update_normal(mesh_.face_handle(h));
  update_normal(mesh_.face_handle(o));
  return true;
}

void ConstrainedRemesher::flip_to_delaunay() {
  ask_watch();
  std::vector<EH> queue;
  for (const auto e : mesh_.edges())
    if (!mesh_.is_boundary(e)) queue.push_back(e);
  std::vector<char> queued(mesh_.n_edges(), 1);
  // Flips under guard need not end: ten looks at each edge are enough.
  const std::size_t most = 10 * queue.size();
  for (std::size_t k = 0; k < queue.size() && k < most; ++k) {
    const EH e = queue[k];
    queued[e.idx()] = 0;
    if (!opposite_angles_exceed_pi(e) || !flip_guarded(e)) continue;
    for (int side : {0, 1}) {
      const HH h = mesh_.halfedge_handle(e, side);
      for (const HH beside : {mesh_.next_halfedge_handle(h), mesh_.prev_halfedge_handle(h)}) {
        const EH around = mesh_.edge_handle(beside);
        if (mesh_.is_boundary(around) || queued[around.idx()]) continue;
        queued[around.idx()] = 1;
        queue.push_back(around);
      }
    }
  }
}

void ConstrainedRemesher::smooth_tangentially() {
  ask_watch();
  for (const auto v : mesh_.vertices()) {
    if (is_locked(v)) continue;
    Vec3 centroid = Vec3::Zero(), normal = Vec3::Zero();
    double total = 0;
    const Vec3 p = mesh_.point(v);
    for (const auto h : mesh_.voh_range(v)) {
      if (mesh_.is_boundary(h)) continue;
      const Vec3 a = mesh_.point(mesh_.to_vertex_handle(h));
      const Vec3 b = mesh_.point(mesh_.to_vertex_handle(mesh_.next_halfedge_handle(h)));
      const Vec3 cross = (a - p).cross(b - p);
      const double area = cross.norm() / 2;
      centroid += area * (p + a + b) / 3;
      normal += cross;
      total += area;
    }
    if (!(total > 0) || normal.isZero()) continue;
    normal.normalize();
    const Vec3 move = centroid / total - p;
    guarded_move(v, p + move - normal.dot(move) * normal);
  }
}

double ConstrainedRemesher::move_towards(const Points& goal) {
  double longest = 0;
  std::size_t k = 0;
  for (const auto v : mesh_.vertices()) {
    const Vec3& to = goal[k++];
    if (is_locked(v)) continue;
    const Vec3 from = mesh_.point(v);
    longest = std::max(longest, (to - from).norm() / size_[v.idx()]);
    for (double share : {1.0, 0.5, 0.25})
      if (guarded_move(v, from + share * (to - from))) break;
  }
  return longest;
}

std::vector<ConstrainedRemesher::EH> ConstrainedRemesher::edges_beyond(double limit) const {
  std::vector<EH> edges;
  for (const auto e : mesh_.edges()) {
    if (mesh_.is_boundary(e) && boundary_normal_[e.idx()].isZero()) continue;
    if (edge_cosine(e) < limit) edges.push_back(e);
  }
  return edges;
}

void ConstrainedRemesher::relax_around(const std::vector<EH>& edges, int rings) {
  std::set<int> region;
  for (EH e : edges)
    for (int side : {0, 1}) region.insert(mesh_.to_vertex_handle(mesh_.halfedge_handle(e, side)).idx());
  for (int ring = 0; ring < rings; ++ring) {
    std::set<int> grown = region;
    for (int v : region)
      for (const auto w : mesh_.vv_range(VH(v))) grown.insert(w.idx());
    region = std::move(grown);
  }
  for (int sweep = 0; sweep < 10 * rings; ++sweep)
    for (int v : region) {
      if (is_locked(VH(v))) continue;
      Vec3 mean = Vec3::Zero();
      for (const auto w : mesh_.vv_range(VH(v))) mean += mesh_.point(w);
      mesh_.set_point(VH(v), mean / static_cast<double>(mesh_.valence(VH(v))));
    }
  for (int v : region)
    if (!is_locked(VH(v))) update_normals_around(VH(v));
}

void ConstrainedRemesher::untangle() {
  ask_watch();
  std::vector<EH> bad = edges_beyond(guard_cosine);
  for (int ring = 1; ring <= 4 && !bad.empty(); ++ring) {
    for (EH e : bad) flip_guarded(e);
    bad = edges_beyond(guard_cosine);
    if (bad.empty()) return;
    const TriMesh before = mesh_;
    const std::vector<Vec3> normals_before = normal_;
    relax_around(bad, ring);
    std::vector<EH> left = edges_beyond(guard_cosine);
    if (left.size() < bad.size())
      bad = std::move(left);
    else {
      mesh_ = before;
      normal_ = normals_before;
    }
  }
}

int ConstrainedRemesher::free_count() const {
  int count = 0;
  for (const auto v : mesh_.vertices()) count += is_locked(v) ? 0 : 1;
  return count;
}

Points ConstrainedRemesher::points() const {
  Points result;
  for (const auto v : mesh_.vertices()) result.push_back(mesh_.point(v));
  return result;
}

Triangles ConstrainedRemesher::triangles() const {
  std::vector<int> number(mesh_.n_vertices(), -1);
  int next = 0;
  for (const auto v : mesh_.vertices()) number[v.idx()] = next++;
  Triangles result;
  for (const auto f : mesh_.faces()) {
    Triangle t;
    int k = 0;
    for (const auto v : mesh_.fv_range(f)) t[k++] = number[v.idx()];
    result.push_back(t);
  }
  return result;
}

}  // namespace loopmend
