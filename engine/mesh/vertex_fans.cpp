// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/vertex_fans.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

namespace loopmend {

namespace {

using HalfedgeHandle = TriMesh::HalfedgeHandle;
using VertexHandle = TriMesh::VertexHandle;

constexpr double full_turn = 2 * std::numbers::pi;

double angle_between(const Vec3& a, const Vec3& b) { return std::atan2(a.cross(b).norm(), a.dot(b)); }

/// Sum of the face normals, each by its angle.
Vec3 normal_sum(const Vec3& center, const FanLink& link) {
  Vec3 sum = Vec3::Zero();
  for (std::size_t i = 0; i + 1 < link.size(); ++i) {
    const Vec3 a = link[i] - center, b = link[i + 1] - center;
    sum += angle_between(a, b) * a.cross(b).normalized();
  }
  return sum;
}

double positive(double angle) { return angle < 0 ? angle + full_turn : angle; }

/// A fan at a vertex of a mesh, between its two boundary edges.
struct MeshFan {
  HalfedgeHandle in, out;  ///< along the boundary: the fan lies between them, counter-clockwise from `in` to `out`
  FanLink link;
};

std::vector<MeshFan> fans_at(const TriMesh& mesh, VertexHandle v) {
  std::vector<MeshFan> fans;
  for (const auto out : mesh.voh_range(v)) {
    if (!mesh.is_boundary(out)) continue;
    MeshFan fan;
    fan.out = out;
    fan.link.push_back(mesh.point(mesh.to_vertex_handle(out)));
    HalfedgeHandle towards = mesh.opposite_halfedge_handle(out);
    while (!mesh.is_boundary(towards)) {
      const HalfedgeHandle away = mesh.next_halfedge_handle(towards);
      fan.link.push_back(mesh.point(mesh.to_vertex_handle(away)));
      towards = mesh.opposite_halfedge_handle(away);
    }
    fan.in = towards;
    std::reverse(fan.link.begin(), fan.link.end());
    fans.push_back(std::move(fan));
  }
  return fans;
}

std::optional<FanArrangement> arrange(const TriMesh& mesh, VertexHandle v, const std::vector<MeshFan>& fans) {
  std::vector<FanLink> links;
  for (const MeshFan& fan : fans) links.push_back(fan.link);
  return arrange_fans(mesh.point(v), links);
}

}  // namespace

std::optional<FanArrangement> arrange_fans(const Vec3& center, const std::vector<FanLink>& fans) {
  std::vector<Vec3> sums;
  Vec3 normal = Vec3::Zero();
  for (const FanLink& fan : fans) normal += sums.emplace_back(normal_sum(center, fan));
  if (!(normal.norm() > 0)) return std::nullopt;
  normal.normalize();
  const Vec3 right = normal.unitOrthogonal(), up = normal.cross(right);
  const auto direction = [&](const Vec3& p) { return std::atan2(up.dot(p - center), right.dot(p - center)); };

  const int n = static_cast<int>(fans.size());
  std::vector<double> start(n), sweep(n, 0);
  for (int k = 0; k < n; ++k) {
    if (!(sums[k].dot(normal) > 0)) return std::nullopt;
    start[k] = positive(direction(fans[k].front()));
    for (std::size_t i = 0; i + 1 < fans[k].size(); ++i)
      sweep[k] += std::remainder(direction(fans[k][i + 1]) - direction(fans[k][i]), full_turn);
    if (!(sweep[k] > 0)) return std::nullopt;
  }
  FanArrangement arrangement;
  arrangement.order.resize(n);
  std::iota(arrangement.order.begin(), arrangement.order.end(), 0);
  std::sort(arrangement.order.begin(), arrangement.order.end(),
            [&](int a, int b) { return start[a] != start[b] ? start[a] < start[b] : a < b; });
  double total = 0;
  for (int k = 0; k < n; ++k) {
    const int here = arrangement.order[k], next = arrangement.order[(k + 1) % n];
    const double gap = start[next] + (k + 1 == n ? full_turn : 0) - start[here] - sweep[here];
    if (!(gap > 0)) return std::nullopt;
    arrangement.gap.push_back(gap);
    total += gap + sweep[here];
  }
  if (std::abs(total - full_turn) > 1e-6) return std::nullopt;
  return arrangement;
}

int fan_count(const TriMesh& mesh, VertexHandle v) {
  int count = 0;
  for (const auto h : mesh.voh_range(v)) count += mesh.is_boundary(h);
  return count;
}

void link_fans(TriMesh& mesh, VertexHandle v) {
  const std::vector<MeshFan> fans = fans_at(mesh, v);
  if (fans.size() < 2) return;
  const auto arrangement = arrange(mesh, v, fans);
  if (!arrangement) return;
  for (std::size_t k = 0; k < fans.size(); ++k) {
    const MeshFan &here = fans[arrangement->order[k]], &next = fans[arrangement->order[(k + 1) % fans.size()]];
    mesh.set_next_halfedge_handle(next.in, here.out);
  }
}

double gap_angle(const TriMesh& mesh, HalfedgeHandle in) {
  const VertexHandle v = mesh.to_vertex_handle(in);
  const std::vector<MeshFan> fans = fans_at(mesh, v);
  if (fans.size() > 1)
    if (const auto arrangement = arrange(mesh, v, fans))
      for (std::size_t k = 0; k < fans.size(); ++k)
        if (fans[arrangement->order[(k + 1) % fans.size()]].in == in) return arrangement->gap[k];
  double faces = 0;
  for (const MeshFan& fan : fans)
    for (std::size_t i = 0; i + 1 < fan.link.size(); ++i)
      faces += angle_between(fan.link[i] - mesh.point(v), fan.link[i + 1] - mesh.point(v));
  const double gaps = full_turn - faces;
  return fans.size() > 1 ? std::max(0.0, gaps) / static_cast<double>(fans.size()) : gaps;
}

}  // namespace loopmend
