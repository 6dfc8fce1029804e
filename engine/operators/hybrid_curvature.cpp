// SPDX-License-Identifier: GPL-3.0-or-later
#include "operators/hybrid_curvature.h"

#include "core/threads.h"

#include <Eigen/Cholesky>
#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace loopmend {

namespace {

constexpr std::size_t fewest_neighbors = 15;  ///< below, a third ring is taken
constexpr std::size_t most_samples = 22;      ///< the nearest, the vertex itself included
constexpr double crease =
    40 * std::numbers::pi / 180;  ///< between normals, at which a sample has lost 63 % of its weight
constexpr int passes = 3;         ///< each but the last turns the fit's plane to its tangent plane
constexpr double steepest = 2;    ///< slope to which it is turned
constexpr double ridge = 1e-7;    ///< of the normal matrix, in units of its weights
constexpr double most_bent = 9;   ///< times the mean of ‖A‖²: more is taken for noise
constexpr int vertices_at_a_time = 16;

using Vector10 = Eigen::Matrix<double, 10, 1>;
using Matrix10 = Eigen::Matrix<double, 10, 10>;

struct Sample {
  double distance2 = 0;
  int vertex = 0;
};

struct Fit {
  double H = 0, bent = 0, height = 0;  ///< bent: ‖A‖²; height: of the field over the vertex
  Vec3 normal = Vec3::Zero();
};

Fit fit_at(int i, const Points& points, const Points& normals, const std::vector<int>& neighbors,
           std::vector<Sample>& samples) {
  Fit fit;
  fit.normal = normals[i];
  if (fit.normal.isZero()) return fit;
  samples.clear();
  for (int j : neighbors) samples.push_back({(points[j] - points[i]).squaredNorm(), j});
  if (samples.size() > most_samples) {
    std::nth_element(samples.begin(), samples.begin() + (most_samples - 1), samples.end(),
                     [](const Sample& a, const Sample& b) {
                       return a.distance2 < b.distance2 || (a.distance2 == b.distance2 && a.vertex < b.vertex);
                     });
    samples.resize(most_samples);
    std::sort(samples.begin(), samples.end(), [](const Sample& a, const Sample& b) { return a.vertex < b.vertex; });
  }
  double widest2 = 0;
  for (const Sample& s : samples) widest2 = std::max(widest2, s.distance2);
  const double width = std::sqrt(widest2);
  if (!(width > 0)) return fit;
  std::array<double, 64> weight{};
  for (std::size_t k = 0; k < samples.size(); ++k) {
    const double turn = std::acos(std::clamp(normals[samples[k].vertex].dot(normals[i]), -1.0, 1.0)) / crease;
    weight[k] = std::exp(-3 * samples[k].distance2 / widest2 - turn * turn * turn * turn);
  }
  Vector10 c;
  for (int pass = 0; pass < passes; ++pass) {
    const Vec3 u = fit.normal.unitOrthogonal(), v = fit.normal.cross(u);
    Matrix10 A = Matrix10::Zero();
    Vector10 b = Vector10::Zero();
    for (std::size_t k = 0; k < samples.size(); ++k) {
      const Vec3 way = (points[samples[k].vertex] - points[i]) / width;
      const double x = way.dot(u), y = way.dot(v), z = way.dot(fit.normal);
      Vector10 row;
      row << 1, x, y, x * x, x * y, y * y, x * x * x, x * x * y, x * y * y, y * y * y;
      const Vector10 weighted = weight[k] * row;
      A.noalias() += weighted * row.transpose();
      b += z * weighted;
    }
    A.diagonal().array() += ridge;
    c = A.ldlt().solve(b);
    if (pass + 1 < passes && std::hypot(c[1], c[2]) < steepest)
      fit.normal = (fit.normal - c[1] * u - c[2] * v).normalized();
  }
  const double fx = c[1], fy = c[2], fxx = 2 * c[3] / width, fxy = c[4] / width, fyy = 2 * c[5] / width;
  const double g = 1 + fx * fx + fy * fy;
  fit.H = ((1 + fy * fy) * fxx - 2 * fx * fy * fxy + (1 + fx * fx) * fyy) / (2 * g * std::sqrt(g));
  fit.bent = fxx * fxx + 2 * fxy * fxy + fyy * fyy;
  fit.height = c[0] * width;
  return fit;
}

}  // namespace

FitNeighbors fit_neighbors(const Topology& topology) {
  FitNeighbors neighbors(topology.vertex_count());
  parallel_for(
      0, topology.vertex_count(), vertices_at_a_time, [&] { return std::vector<char>(topology.vertex_count(), 0); },
      [&](int i, std::vector<char>& mark) {
        topology.k_ring(i, 2, neighbors[i], mark);
        if (neighbors[i].size() < fewest_neighbors) topology.k_ring(i, 3, neighbors[i], mark);
        neighbors[i].push_back(i);
      });
  return neighbors;
}

HybridCurvature hybrid_curvature(const Points& points, const Points& normals, const FitNeighbors& neighbors,
                                 const SparseMatrix& stiffness, const Eigen::VectorXd& mass) {
  const int n = static_cast<int>(points.size());
  std::vector<Fit> fits(n);
  parallel_for(
      0, n, vertices_at_a_time, [] { return std::vector<Sample>(); },
      [&](int i, std::vector<Sample>& samples) { fits[i] = fit_at(i, points, normals, neighbors[i], samples); });
  HybridCurvature result;
  result.B = stiffness;
  double bent = 0;
  for (const Fit& fit : fits) bent += fit.bent / n;
  for (int i = 0; i < n; ++i)
    for (RowSparseMatrix::InnerIterator entry(result.B, i); entry; ++entry)
      entry.valueRef() *= -0.5 / mass[i] * fits[i].normal.dot(fits[entry.col()].normal);
  Eigen::VectorXd heights(n), curvatures(n);
  for (int i = 0; i < n; ++i) {
    heights[i] = fits[i].height;
    curvatures[i] = fits[i].H;
  }
  result.H = curvatures - result.B * heights;
  for (int i = 0; i < n; ++i) result.B.coeffRef(i, i) += std::min(fits[i].bent, most_bent * bent);
  return result;
}

}  // namespace loopmend
