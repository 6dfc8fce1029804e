// SPDX-License-Identifier: GPL-3.0-or-later
#include "split/split_surface.h"

#include "core/threads.h"
#include "operators/congruence.h"
#include "operators/vertex_normals.h"

#include <boost/pending/disjoint_sets.hpp>

#include <numeric>
#include <utility>

namespace loopmend {

namespace {

/// Vertices of these triangles less their connected parts.
int rank_of(const Triangles& triangles, const std::vector<int>& faces, int vertex_count) {
  std::vector<int> rank(vertex_count, 0), parent(vertex_count);
  boost::disjoint_sets<int*, int*> sets(rank.data(), parent.data());
  std::vector<char> used(vertex_count, 0);
  for (int i = 0; i < vertex_count; ++i) sets.make_set(i);
  int joined = 0;
  for (int f : faces)
    for (int k = 0; k < 3; ++k) {
      const int a = sets.find_set(triangles[f][k]), b = sets.find_set(triangles[f][(k + 1) % 3]);
      if (a == b) continue;
      sets.link(a, b);
      ++joined;
    }
  return joined;
}

}  // namespace

Eigen::VectorXd SplitGeometry::half_gradient() const {
  const Eigen::VectorXd KH = inner_stiffness * curvature.H;
  return curvature.B.transpose() * KH;
}

SparseMatrix SplitGeometry::hessian() const { return lower_congruence(curvature.B, inner_stiffness); }

SparseMatrix SplitGeometry::roughness(double kappa) const {
  RowSparseMatrix A = stiffness;
  for (Eigen::Index i = 0; i < A.rows(); ++i) A.coeffRef(i, i) += kappa * kappa * mass[i];
  const SparseMatrix weights(mass.cwiseInverse().asDiagonal());
  return lower_congruence(A, weights);
}

SplitSurface::SplitSurface(int vertex_count, Triangles triangles)
    : triangles_(std::move(triangles)),
      all_(triangles_.size()) {
  const Topology topology(vertex_count, triangles_);
  std::iota(all_.begin(), all_.end(), 0);
  for (int f : all_) {
    const Triangle& t = triangles_[f];
    if (!topology.is_boundary(t[0]) && !topology.is_boundary(t[1]) && !topology.is_boundary(t[2])) inner_.push_back(f);
  }
  neighbors_ = fit_neighbors(topology);
  rank_ = rank_of(triangles_, inner_, vertex_count);
}

SplitGeometry SplitSurface::at(const Points& points) const {
  SplitGeometry geometry;
  geometry.normals = angle_weighted_normals(points, triangles_);
  geometry.mass = barycentric_areas(points, triangles_);
  parallel_invoke(
      [&] { geometry.stiffness = clamped_cotan_stiffness(points, triangles_, all_, robust_clamp); },
      [&] { geometry.inner_stiffness = clamped_cotan_stiffness(points, triangles_, inner_, robust_clamp); });
  geometry.curvature = hybrid_curvature(points, geometry.normals, neighbors_, geometry.stiffness, geometry.mass);
  return geometry;
}

}  // namespace loopmend
