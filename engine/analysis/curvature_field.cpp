// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/curvature_field.h"

#include "mesh/mesh_arrays.h"
#include "operators/polynomial_fit.h"
#include "operators/vertex_normals.h"

#include <omp.h>

#include <limits>

namespace loopmend {

namespace {

CurvatureField field_of(const Points& points, const Triangles& triangles, int threads) {
  const int n = static_cast<int>(points.size());
  const Topology topology(n, triangles);
  CurvatureField field;
  field.normals = angle_weighted_normals(points, triangles);
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  field.H.assign(n, nan);
  field.K.assign(n, nan);
#pragma omp parallel num_threads(threads > 0 ? threads : omp_get_num_procs())
  {
    FitScratch scratch(n);
    PolynomialFit fit;
#pragma omp for schedule(dynamic, 1024)
    for (int i = 0; i < n; ++i) {
      const Vec3 reference = field.normals[i];
      if (!fit_polynomial(points, topology, i, reference, FitOptions{}, scratch, fit)) continue;
      field.H[i] = fit.H;
      field.K[i] = fit.K;
      field.normals[i] = fit.normal;
    }
  }
  return field;
}

}  // namespace

CurvatureField curvature_field(const TriMesh& mesh, int threads) {
  return field_of(points_of(mesh), triangles_of(mesh), threads);
}

CurvatureField curvature_field(const Patch& patch) {
  CurvatureField field = field_of(patch.positions, patch.triangles, 1);
  for (double& H : field.H) H /= patch.scale;
  for (double& K : field.K) K /= patch.scale * patch.scale;
  return field;
}

}  // namespace loopmend
