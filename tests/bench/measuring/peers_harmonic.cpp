// SPDX-License-Identifier: GPL-3.0-or-later
#include "peers.h"

#include "mesh/mesh_arrays.h"
#include "operators/operator_set.h"
#include "operators/topology.h"
#include "solvers/linear_solver.h"
#include "stopwatch.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <numeric>

namespace loopmend::bench {

namespace {

/// The filling's triangles and the neighborhood out to some rings, renumbered: free vertices first.
struct Neighborhood {
  Points points;
  Triangles triangles;
  int free = 0;
};

Neighborhood neighborhood(const Points& points, const Triangles& triangles, const Filling& filling, int rings) {
  const int old = static_cast<int>(points.size());
  Neighborhood near;
  near.points = filling.points;
  near.free = static_cast<int>(filling.points.size());
  std::vector<int> index(points.size(), -1);
  const auto local = [&](int v) {
    if (v >= old) return v - old;
    if (index[v] < 0) {
      index[v] = static_cast<int>(near.points.size());
      near.points.push_back(points[v]);
    }
    return index[v];
  };
  for (const Triangle& t : filling.triangles) near.triangles.push_back({local(t[0]), local(t[1]), local(t[2])});
  std::vector<char> taken(triangles.size(), 0);
  for (int ring = 0; ring < rings; ++ring) {
    std::vector<std::size_t> added;
    for (std::size_t f = 0; f < triangles.size(); ++f) {
      const Triangle& t = triangles[f];
      if (!taken[f] && (index[t[0]] >= 0 || index[t[1]] >= 0 || index[t[2]] >= 0)) added.push_back(f);
    }
    for (std::size_t f : added) {
      taken[f] = 1;
      const Triangle& t = triangles[f];
      near.triangles.push_back({local(t[0]), local(t[1]), local(t[2])});
    }
  }
  return near;
}

/// Mixed Voronoi areas (Meyer et al. 2003).
Eigen::VectorXd voronoi_areas(const Points& points, const Triangles& triangles) {
  Eigen::VectorXd areas = Eigen::VectorXd::Zero(static_cast<long>(points.size()));
  for (const Triangle& t : triangles) {
    double area = 0;
    std::array<double, 3> cot{}, length2{};
    for (int k = 0; k < 3; ++k) {
      const Vec3 u = points[t[(k + 1) % 3]] - points[t[k]], v = points[t[(k + 2) % 3]] - points[t[k]];
      area = u.cross(v).norm() / 2;
      cot[k] = u.dot(v) / std::max(2 * area, 1e-300);
      length2[k] = (u - v).squaredNorm();
    }
    const auto obtuse = std::find_if(cot.begin(), cot.end(), [](double c) { return c < 0; });
    for (int k = 0; k < 3; ++k) {
      const int l = (k + 1) % 3, m = (k + 2) % 3;
      if (obtuse != cot.end())
        areas[t[k]] += area / (obtuse - cot.begin() == k ? 2 : 4);
      else
        areas[t[k]] += (cot[l] * length2[l] + cot[m] * length2[m]) / 8;
    }
  }
  return areas;
}

std::vector<int> first_numbers(std::size_t count) {
  std::vector<int> numbers(count);
  std::iota(numbers.begin(), numbers.end(), 0);
  return numbers;
}

std::vector<std::vector<int>> loop_vertices(const HoleProblem& problem) {
  std::vector<std::vector<int>> loops;
  for (const BoundaryLoop& loop : problem.loops) loops.push_back(loop.vertices);
  return loops;
}

}  // namespace

const char* to_string(Peer peer) {
  switch (peer) {
    case Peer::cgal_c1: return "CGAL C1";
    case Peer::cgal_c2: return "CGAL C2";
    case Peer::harmonic_2: return "k = 2";
    case Peer::harmonic_3: return "k = 3";
  }
  return "";
}

bool make_harmonic(const Points& points, const Triangles& triangles, Filling& filling, int k) {
  const Neighborhood near = neighborhood(points, triangles, filling, k + 1);
  const SparseMatrix L = cotan_stiffness(near.points, near.triangles, first_numbers(near.triangles.size()));
  const Eigen::VectorXd inverse_mass = voronoi_areas(near.points, near.triangles).cwiseMax(1e-300).cwiseInverse();
  // Rows of the free vertices only: Δᵏ of the others is never needed.
  SparseMatrix Q = L.topRows(near.free);
  for (int power = 1; power < k; ++power) Q = SparseMatrix(Q * inverse_mass.asDiagonal()) * L;
  const long fixed = static_cast<long>(near.points.size()) - near.free;
  Eigen::MatrixXd positions(fixed, 3), solution;
  for (long i = 0; i < fixed; ++i) positions.row(i) = near.points[near.free + i].transpose();
  const SparseMatrix A = Q.leftCols(near.free);
  const Eigen::MatrixXd b = -(SparseMatrix(Q.rightCols(fixed)) * positions);
  const std::unique_ptr<SpdSolver> solver = make_spd_solver();
  if (!solver->factorize(A) || !solver->solve(b, solution)) return false;
  for (int i = 0; i < near.free; ++i) filling.points[i] = solution.row(i).transpose();
  return true;
}

Filling fill_by_peer(const HoleProblem& problem, Peer peer) {
  const Points points = points_of(problem.model.mesh);
  const Triangles triangles = triangles_of(problem.model.mesh);
  const auto loops = loop_vertices(problem);
  if (peer == Peer::cgal_c1) return fill_by_cgal(points, triangles, loops, 1);
  if (peer == Peer::cgal_c2) return fill_by_cgal(points, triangles, loops, 2);
  FillOptions initial_patch_only;
  initial_patch_only.evolution.reset();
  Filling filling = fill_by_engine(problem, initial_patch_only);
  if (!filling.complete || filling.points.empty()) return filling;
  const Stopwatch watch;
  if (!make_harmonic(points, triangles, filling, peer == Peer::harmonic_2 ? 2 : 3)) {
    filling.complete = false;
    filling.status = "failed";
    filling.message = "the matrix is not positive definite";
  }
  filling.seconds += watch.seconds();
  return filling;
}

}  // namespace loopmend::bench
