// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/curvature_field.h"

#include "core/threads.h"
#include "mesh/mesh_arrays.h"
#include "operators/polynomial_fit.h"
#include "operators/vertex_normals.h"

#include <limits>
#include <span>
#include <utility>

namespace loopmend {

namespace {

constexpr int fits_at_a_time = 1024;  ///< by a thread

CurvatureField field_of(std::span<const Vec3> points, Triangles triangles) {
  const int n = static_cast<int>(points.size());
  Topology topology(n, triangles);
  topology.forget_faces();
  CurvatureField field;
  field.normals = angle_weighted_normals(points, triangles);
  Triangles().swap(triangles);  // a large scan needs the memory
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  field.H.assign(n, nan);
  field.K.assign(n, nan);
  const auto make_scratch = [n] { return std::pair(FitScratch(n), PolynomialFit()); };
  parallel_for(0, n, fits_at_a_time, make_scratch, [&](int i, auto& scratch) {
    auto& [work, fit] = scratch;
    const Vec3 reference = field.normals[i];
    if (!fit_polynomial(points, topology, i, reference, FitOptions{}, work, fit)) return;
    field.H[i] = fit.H;
    field.K[i] = fit.K;
    field.normals[i] = fit.normal;
  });
  return field;
}

}  // namespace

CurvatureField curvature_field(const TriMesh& mesh) {
  return field_of({mesh.points(), mesh.n_vertices()}, triangles_of(mesh));
}

CurvatureField curvature_field(const Patch& patch) {
  CurvatureField field = field_of(patch.positions, patch.triangles);
  for (double& H : field.H) H /= patch.scale;
  for (double& K : field.K) K /= patch.scale * patch.scale;
  return field;
}

}  // namespace loopmend
