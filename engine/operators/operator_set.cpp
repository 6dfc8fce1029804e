// SPDX-License-Identifier: GPL-3.0-or-later
#include "operators/operator_set.h"

#include "core/threads.h"
#include "operators/vertex_normals.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <numeric>
#include <utility>

namespace loopmend {

double OperatorSet::apply_laplacian(int i, const Eigen::VectorXd& f) const {
  double sum = 0;
  for (int e = offset[i]; e < offset[i + 1]; ++e) sum += laplacian[e] * f[index[e]];
  return sum;
}

Vec3 OperatorSet::apply_gradient(int i, const Eigen::VectorXd& f) const {
  Vec3 sum = Vec3::Zero();
  for (int e = offset[i]; e < offset[i + 1]; ++e) sum += gradient[e] * f[index[e]];
  return sum;
}

Vec3 OperatorSet::apply_diamond(int i, const Eigen::VectorXd& f) const { return diamond(i, apply_gradient(i, f)); }

namespace {

constexpr int run_length = 64;  ///< vertices that a thread takes at a time

template <class T>
void append_all(std::vector<T>& to, const std::vector<T>& from) {
  to.insert(to.end(), from.begin(), from.end());
}

/// The rows of a run of vertices, made by one thread.
struct Rows {
  std::vector<int> length;  ///< entries per vertex of the run
  std::vector<int> index;
  std::vector<double> laplacian;
  Points gradient;
  std::vector<double> gauss;

  /// @param place  of vertex i in the run.
  void append(int i, int place, const PolynomialFit& fit) {
    index.push_back(i);
    laplacian.push_back(-std::accumulate(fit.laplacian.begin(), fit.laplacian.end(), 0.0));
    gradient.push_back(-std::accumulate(fit.gradient.begin(), fit.gradient.end(), Vec3(Vec3::Zero())));
    gauss.push_back(-std::accumulate(fit.gauss.begin(), fit.gauss.end(), 0.0));
    append_all(index, fit.samples);
    append_all(laplacian, fit.laplacian);
    append_all(gradient, fit.gradient);
    append_all(gauss, fit.gauss);
    length[place] = static_cast<int>(fit.samples.size()) + 1;
  }
};

/// One after another; each run is freed as soon as it is copied, since there may be gigabytes of them.
void join(std::vector<Rows>& runs, OperatorSet& set) {
  std::size_t entries = 0;
  for (const Rows& rows : runs) entries += rows.index.size();
  set.index.reserve(entries);
  set.laplacian.reserve(entries);
  set.gradient.reserve(entries);
  set.gauss.reserve(entries);
  set.offset.push_back(0);
  for (Rows& rows : runs) {
    for (int length : rows.length) set.offset.push_back(set.offset.back() + length);
    append_all(set.index, rows.index);
    append_all(set.laplacian, rows.laplacian);
    append_all(set.gradient, rows.gradient);
    append_all(set.gauss, rows.gauss);
    rows = Rows();
  }
}

/// Curvatures and normals of a fit.
void take(const PolynomialFit& fit, int i, OperatorSet& set) {
  set.valid[i] = 1;
  set.H[i] = fit.H;
  set.K[i] = fit.K;
  set.normal[i] = fit.normal;
  set.second_form[i] = fit.second_form;
}

/// Takes the fit at vertex i from what is known, if it has not changed.
bool recall(const KnownFits& known, int i, PolynomialFit& fit) {
  if (!known.set || known.set->offset.empty() || i < known.moved || !known.set->valid[i]) return false;
  const OperatorSet& set = *known.set;
  const int begin = set.offset[i] + 1, end = set.offset[i + 1];
  fit.samples.assign(set.index.begin() + begin, set.index.begin() + end);
  if (*std::min_element(fit.samples.begin(), fit.samples.end()) < known.moved) return false;
  fit.laplacian.assign(set.laplacian.begin() + begin, set.laplacian.begin() + end);
  fit.gradient.assign(set.gradient.begin() + begin, set.gradient.begin() + end);
  fit.gauss.assign(set.gauss.begin() + begin, set.gauss.begin() + end);
  fit.normal = set.normal[i];
  fit.second_form = set.second_form[i];
  fit.H = set.H[i];
  fit.K = set.K[i];
  fit.valid = true;
  return true;
}

/// Runs of vertices are numbered in order, and none is worked on by two threads: joined in order, they have the same bits for
/// any number of threads.
OperatorSet compute(const Points& points, const Triangles& triangles, const Topology& topology, Stencil stencil,
                    FitOutput output, const std::vector<char>& wanted, const KnownFits& known) {
  FitOptions options;
  options.degree = stencil == Stencil::two_ring_cubic ? 3 : 2;
  options.output = output;
  const int n = static_cast<int>(points.size());
  OperatorSet set;
  set.normal.assign(n, Vec3::Zero());
  set.H.setZero(n);
  set.K.setZero(n);
  set.valid.assign(n, 0);
  set.second_form.assign(n, Eigen::Matrix3d::Zero());
  std::vector<Rows> runs((n + run_length - 1) / run_length);
  for (int run = 0; run < static_cast<int>(runs.size()); ++run)
    runs[run].length.assign(std::min(run_length, n - run * run_length), 0);
  const auto make_scratch = [n] { return std::pair(FitScratch(n), PolynomialFit()); };
  parallel_for(0, n, run_length, make_scratch, [&](int i, auto& scratch) {
    auto& [work, fit] = scratch;
    if (!wanted[i]) return;
    if (!recall(known, i, fit)) {
      set.normal[i] = angle_weighted_normal(points, triangles, topology, i);
      if (!fit_polynomial(points, topology, i, set.normal[i], options, work, fit)) return;
    }
    take(fit, i, set);
    if (output == FitOutput::operator_weights) runs[i / run_length].append(i, i % run_length, fit);
  });
  if (output == FitOutput::operator_weights) join(runs, set);
  return set;
}

}  // namespace

OperatorSet compute_operators(const Points& points, const Triangles& triangles, const Topology& topology,
                              Stencil stencil, const std::vector<char>& wanted, const KnownFits& known) {
  return compute(points, triangles, topology, stencil, FitOutput::operator_weights, wanted, known);
}

OperatorSet compute_curvatures(const Points& points, const Triangles& triangles, const Topology& topology,
                               Stencil stencil, const std::vector<char>& wanted, const KnownFits& known) {
  return compute(points, triangles, topology, stencil, FitOutput::curvatures, wanted, known);
}

std::array<double, 3> half_cotangents(const Points& points, const Triangle& t) {
  std::array<double, 3> result;
  for (int k = 0; k < 3; ++k) {
    const Vec3 a = points[t[(k + 1) % 3]] - points[t[k]], b = points[t[(k + 2) % 3]] - points[t[k]];
    const double sine = std::max(a.cross(b).norm(), 1e-14 * (a.squaredNorm() + b.squaredNorm()) + 1e-300);
    result[k] = 0.5 * a.dot(b) / sine;
  }
  return result;
}

namespace {

using Triplets = std::vector<Eigen::Triplet<double>>;

void add_edge(Triplets& triplets, int i, int j, double weight) {
  triplets.emplace_back(i, i, weight);
  triplets.emplace_back(j, j, weight);
  triplets.emplace_back(i, j, -weight);
  triplets.emplace_back(j, i, -weight);
}

SparseMatrix square_matrix(std::size_t size, const Triplets& triplets) {
  SparseMatrix matrix(static_cast<Eigen::Index>(size), static_cast<Eigen::Index>(size));
  matrix.setFromTriplets(triplets.begin(), triplets.end());
  return matrix;
}

}  // namespace

SparseMatrix cotan_stiffness(const Points& points, const Triangles& triangles, const std::vector<int>& faces) {
  Triplets triplets;
  triplets.reserve(12 * faces.size());
  for (int f : faces) {
    const auto weights = half_cotangents(points, triangles[f]);
    for (int k = 0; k < 3; ++k) add_edge(triplets, triangles[f][(k + 1) % 3], triangles[f][(k + 2) % 3], weights[k]);
  }
  return square_matrix(points.size(), triplets);
}

SparseMatrix clamped_cotan_stiffness(const Points& points, const Triangles& triangles, const std::vector<int>& faces,
                                     CotanClamp clamp) {
  // All sides of triangles in buckets by their lower vertex; in each the two of an edge find each other.
  struct Side {
    int high;
    double weight;
  };
  std::vector<int> begin(points.size() + 1, 0);
  const auto ends = [&](int f, int k) { return std::minmax(triangles[f][(k + 1) % 3], triangles[f][(k + 2) % 3]); };
  for (int f : faces)
    for (int k = 0; k < 3; ++k) ++begin[ends(f, k).first + 1];
  std::partial_sum(begin.begin(), begin.end(), begin.begin());
  std::vector<Side> sides(3 * faces.size());
  std::vector<int> next(begin.begin(), begin.end() - 1);
  for (int f : faces) {
    const auto weights = half_cotangents(points, triangles[f]);
    for (int k = 0; k < 3; ++k) {
      const auto [low, high] = ends(f, k);
      sides[next[low]++] = {high, weights[k]};
    }
  }
  Triplets triplets;
  triplets.reserve(2 * sides.size());
  for (std::size_t low = 0; low < points.size(); ++low) {
    const auto first = sides.begin() + begin[low], last = sides.begin() + begin[low + 1];
    std::sort(first, last, [](const Side& a, const Side& b) { return a.high < b.high; });
    for (auto side = first; side != last;) {
      const int high = side->high;
      double weight = 0;
      for (; side != last && side->high == high; ++side) weight += side->weight;
      add_edge(triplets, static_cast<int>(low), high, std::clamp(weight, clamp.low, clamp.high));
    }
  }
  return square_matrix(points.size(), triplets);
}

Eigen::VectorXd barycentric_areas(const Points& points, const Triangles& triangles) {
  Eigen::VectorXd areas = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(points.size()));
  for (const Triangle& t : triangles) {
    const double area = 0.5 * (points[t[1]] - points[t[0]]).cross(points[t[2]] - points[t[0]]).norm();
    for (int v : t) areas[v] += area / 3;
  }
  return areas.cwiseMax(0.05 * areas.mean());
}

}  // namespace loopmend
