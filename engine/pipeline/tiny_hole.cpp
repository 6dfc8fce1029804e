// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/tiny_hole.h"

#include "core/seconds_since.h"
#include "filling/triangulate_loop.h"
#include "mesh/patch.h"
#include "mesh/vertex_fans.h"
#include "pipeline/edge_preview.h"

#include <Eigen/Cholesky>
#include <Eigen/Geometry>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <numbers>

namespace loopmend {

namespace {

constexpr int most_edges = 8;
/// 4π area / perimeter² of loops in which a vertex was, and of rows of triangles: 0.75 and 0.55 in the mean of 560 holes cut into
/// eight models (cow, arm, hand, homer, rocker arm, spot, screwdriver, springer).
constexpr double compact = 0.68;
/// Height of the fitted quadric over the middle of the loop, in mean distances of its vertices from there: a half ball has one.
constexpr double most_height = 0.5;
/// Weighted rms distance of the fitted vertices from the quadric, in the same unit: beyond sharp edges and the ends of tubes are.
constexpr double most_residual = 0.1;
/// Bend at the seam, degrees, from which on triangles between the loop's vertices may cut off a sharp edge or corner (fandisk).
constexpr double most_bend = 35;
constexpr double onward_at_part =
    0.1;  ///< from there on a plane loop may be that of a face of a part, which is looked at closely
constexpr std::size_t least_fitted = 9;  ///< for six coefficients

bool asks_for_no_treatment(const SurfaceModel& model, const BoundaryLoop& loop, const GroupOptions& options) {
  return options.evolution && is_judged(*options.evolution) && options.mirror_planes.empty() &&
         options.evolution->relief.kind == ReliefChoice::Kind::smooth && options.initial.density == 1 &&
         edits_at(model, {loop}, options.evolution->edge_edits).empty();
}

/// A hole by itself, with one fan of faces at each of its vertices.
bool stands_alone(const SurfaceModel& model, const BoundaryLoop& loop) {
  if (loop.kind != LoopKind::hole || loop.coincident > 0 || !loop.joined.empty() || !(loop.diameter > 0)) return false;
  if (std::count(loop.shared.begin(), loop.shared.end(), 0) < static_cast<long>(loop.shared.size())) return false;
  return std::all_of(loop.vertices.begin(), loop.vertices.end(), [&](int v) {
    return std::count(loop.vertices.begin(), loop.vertices.end(), v) == 1 &&
           fan_count(model.mesh, TriMesh::VertexHandle(v)) == 1;
  });
}

bool is_compact(const BoundaryLoop& loop) {
  return loop.edges() > 4 && 4 * std::numbers::pi * loop.area > compact * loop.perimeter * loop.perimeter;
}

/// Where a quadric through the loop's vertices and their neighbors passes the middle of the loop. Weighted least squares of the
/// height over the loop's mean plane. @returns nothing where the fit is poor, or far from the loop.
std::optional<Vec3> vertex_on_quadric(const Patch& frame) {
  const std::vector<int>& loop = frame.loops.front();
  Vec3 center = Vec3::Zero(), normal = Vec3::Zero();
  for (int v : loop) center += frame.positions[v] / static_cast<double>(loop.size());
  double radius = 0;
  for (std::size_t k = 0; k < loop.size(); ++k) {
    const Vec3 from_center = frame.positions[loop[k]] - center;
    normal += from_center.cross(frame.positions[loop[(k + 1) % loop.size()]] - center);
    radius += from_center.norm() / static_cast<double>(loop.size());
  }
  normal.normalize();
  const Vec3 u = normal.unitOrthogonal(), v = normal.cross(u);
  Eigen::Matrix<double, 6, 6> matrix = Eigen::Matrix<double, 6, 6>::Zero();
  Eigen::Matrix<double, 6, 1> rhs = Eigen::Matrix<double, 6, 1>::Zero();
  double squares = 0, weights = 0;
  std::size_t fitted = 0;
  for (std::size_t k = 0; k < frame.positions.size() && frame.ring[k] <= 2; ++k, ++fitted) {
    const Vec3 d = (frame.positions[k] - center) / radius;
    const double x = u.dot(d), y = v.dot(d), weight = 1 / (0.3 + x * x + y * y);
    Eigen::Matrix<double, 6, 1> row;
    row << 1, x, y, x * x, x * y, y * y;
    const double height = normal.dot(d);
    matrix += weight * weight * row * row.transpose();
    rhs += weight * weight * height * row;
    squares += weight * weight * height * height;
    weights += weight * weight;
  }
  if (fitted < least_fitted) return std::nullopt;
  const Eigen::Matrix<double, 6, 1> quadric = matrix.ldlt().solve(rhs);
  const double height = quadric[0], residual = std::sqrt(std::max(0.0, squares - quadric.dot(rhs)) / weights);
  if (!(std::abs(height) < most_height && residual < most_residual)) return std::nullopt;
  return center + height * radius * normal;
}

void put_first(Patch& patch, const Triangles& triangles) {
  patch.triangles.insert(patch.triangles.begin(), triangles.begin(), triangles.end());
  patch.patch_triangles = static_cast<int>(triangles.size());
}

/// Empty where there is none.
std::optional<Patch> patch_of_few_triangles(const SurfaceModel& model, const BoundaryLoop& loop, int rings) {
  LoopPatch empty;
  for (int v : loop.vertices) empty.points.push_back(model.mesh.point(TriMesh::VertexHandle(v)));
  Patch patch = make_narrow_patch(model, {loop}, {empty}, rings);
  const std::vector<int> boundary = patch.loops.front();
  if (!is_compact(loop)) {
    Triangles triangles = triangulate_loop(patch.positions, patch.triangles, boundary, {}, TriangulationMethod::cubic);
    if (triangles.empty()) return std::nullopt;
    for (Triangle& t : triangles)
      for (int& v : t) v = boundary[v];
    put_first(patch, triangles);
    return patch;
  }
  const std::optional<Vec3> middle = vertex_on_quadric(patch);
  if (!middle) return std::nullopt;
  empty.points.push_back(patch.to_mesh(*middle));
  const int n = loop.edges();
  for (int k = 0; k < n; ++k) empty.triangles.push_back({k, (k + 1) % n, n});
  return make_narrow_patch(model, {loop}, {empty}, rings);
}

}  // namespace

std::optional<GroupResult> close_tiny_hole(const ScanIndex& scan, const BoundaryLoop& loop, const GroupOptions& options,
                                           int rings) {
  const auto start = std::chrono::steady_clock::now();
  if (loop.edges() > most_edges || (loop.is_polygon && loop.edges() > 3 && loop.onward > onward_at_part) ||
      !asks_for_no_treatment(scan.model, loop, options) || !stands_alone(scan.model, loop))
    return {};
  constexpr int rings_of_test = 2;  // what is judged does not depend on how much the patch carries
  std::optional<Patch> patch = patch_of_few_triangles(scan.model, loop, rings_of_test);
  if (!patch) return {};
  Validity validity = validate(scan, *patch);
  const std::optional<SeamBend> bend = bend_without_finding(*patch);
  if (!validity.is_clean() || !bend || (loop.edges() > 3 && bend->largest > most_bend)) return {};
  if (rings != rings_of_test) patch = patch_of_few_triangles(scan.model, loop, rings);
  auto result = std::make_shared<PatchResult>();
  result->status = PatchStatus::filled;
  result->made_by = text_to_say("few triangles");
  result->attempts = {result->made_by};
  Message message = patch->free_count == 0
                        ? say("too small to hold a free vertex: closed by triangles between its own vertices")
                        : say("too small for a flow: closed by triangles around one new vertex");
  result->message = std::move(message).with_code("tiny");
  result->validity = std::move(validity);
  result->verdicts.resize(1);
  result->verdicts.front().crease_deg = bend->crease;
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  result->seams = result->seams_before = {{nan, nan, nan, nan, nan}};
  result->patch = std::move(*patch);
  result->seconds.initial_patch = result->seconds.total = seconds_since(start);
  HoleResult hole = open_hole(loop, result->status, result->message);
  hole.patch = result;
  hole.free_vertices = result->patch.free_count;
  hole.seconds = result->seconds.total;
  return GroupResult{{std::move(result)}, {std::move(hole)}};
}

}  // namespace loopmend
