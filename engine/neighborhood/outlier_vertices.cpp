// SPDX-License-Identifier: GPL-3.0-or-later
#include "neighborhood/outlier_vertices.h"

#include "core/quantile.h"
#include "filling/fairing.h"
#include "mesh/quality.h"
#include "neighborhood/boundary_fits.h"
#include "operators/operator_set.h"
#include "operators/polynomial_fit.h"
#include "operators/vertex_normals.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <set>

namespace loopmend {

namespace {

constexpr int fit_rings = 3, feature_rings = 2;
constexpr int looked_at_rings = 4;  ///< as far as the fits at the loop reach
constexpr int most_rounds = 4;
constexpr int most_in_one_place = 2;      ///< outliers; more of them are a feature
constexpr double least_distance = 0.03;   ///< mean edges: below, fits of coarse meshes err by as much
constexpr double many_times_median = 10;  ///< on clean surfaces the largest distance is below that

/// Of normals, coordinate by coordinate: those beside a spike lean, but they are few.
Vec3 median_normal(const Points& normals, const std::vector<int>& vertices) {
  std::array<std::vector<double>, 3> coordinates;
  for (int v : vertices)
    for (int c = 0; c < 3; ++c)
      if (!normals[v].isZero()) coordinates[c].push_back(normals[v][c]);
  if (coordinates[0].empty()) return Vec3::Zero();
  return Vec3(median(coordinates[0]), median(coordinates[1]), median(coordinates[2])).normalized();
}

/// The neighborhood, with some vertices moved onto what their neighbours say.
class Surround {
 public:
  Surround(const Patch& patch, const FixedSurface& around)
      : points(patch.positions),
        around_(around),
        normals_(around.normals),
        scratch_(patch.vertex_count()) {}

  void take_normals() { normals_ = angle_weighted_normals(points, around_.triangles); }

  /// From the vertex onto the fit of its neighbours; 0 where there is none.
  Vec3 way_to_neighbours(int i, Outliers outliers) {
    FitOptions options = cubic_height_field(fit_rings, outliers, FitOutput::curvatures);
    options.centre = Centre::left_out;
    const Vec3 normal = median_normal(normals_, near(i, fit_rings));
    const bool found = fit_polynomial(points, around_.topology, i, normal, options, scratch_, fit_);
    return found ? Vec3(fit_.derivatives.col(0)) : Vec3::Zero();
  }

  const std::vector<int>& near(int i, int rings) {
    around_.topology.k_ring(i, rings, near_, scratch_.mark);
    return near_;
  }

  Points points;

 private:
  const FixedSurface& around_;
  Points normals_;
  FitScratch scratch_;
  PolynomialFit fit_;
  std::vector<int> near_;
};

std::vector<int> looked_at(const Patch& patch) {
  std::vector<int> vertices;
  for (int i = patch.free_count; i < patch.vertex_count(); ++i)
    if (patch.ring[i] <= looked_at_rings) vertices.push_back(i);
  return vertices;
}

/// Distances from what the neighbours say, of the vertices that are looked at; 0 of the others.
struct Distances {
  std::vector<double> all;  ///< #V
  double median = 0;
  double limit = 0;  ///< from which a vertex is an outlier

  Distances(Surround& surround, const std::vector<int>& vertices, double edge, Outliers in_fits)
      : all(surround.points.size(), 0.0) {
    std::vector<double> sorted;
    for (int i : vertices) {
      all[i] = surround.way_to_neighbours(i, in_fits).norm();
      sorted.push_back(all[i]);
    }
    median = loopmend::median(std::move(sorted));
    limit = std::max(least_distance * edge, many_times_median * median);
  }

  bool beyond(int i) const { return all[i] > limit; }
  bool any_beyond(const std::vector<int>& vertices) const {
    return std::any_of(vertices.begin(), vertices.end(), [&](int i) { return beyond(i); });
  }
};

/// Those beyond the limit by more than all that are near them: a large spike makes its neighbours look like outliers too.
std::vector<int> foremost(Surround& surround, const std::vector<int>& vertices, const Distances& distances) {
  std::vector<int> result;
  for (int i : vertices) {
    if (!distances.beyond(i)) continue;
    const std::vector<int>& near = surround.near(i, fit_rings);
    if (std::all_of(near.begin(), near.end(), [&](int j) {
          return distances.all[j] < distances.all[i] || (distances.all[j] == distances.all[i] && i < j);
        }))
      result.push_back(i);
  }
  return result;
}

}  // namespace

CleanNeighborhood remove_outliers(const Patch& patch) {
  CleanNeighborhood clean_neighborhood{patch, 0};
  const std::vector<int> vertices = looked_at(patch);
  const FixedSurface around(patch);
  Surround surround(patch, around);
  // Least squares fits see every outlier as well, only less sharply, at a fifth of the time.
  const double edge = mean_edge_length(patch.positions, patch.triangles, patch.patch_triangles);
  const Distances first(surround, vertices, edge, Outliers::count);
  if (!first.any_beyond(vertices) || first.median > least_distance * edge) return clean_neighborhood;

  std::set<int> outliers;
  Distances left(surround, vertices, edge, Outliers::weighted_down);
  for (int round = 0; round < most_rounds && left.any_beyond(vertices); ++round) {
    for (int i : foremost(surround, vertices, left)) {
      surround.points[i] += surround.way_to_neighbours(i, Outliers::weighted_down);
      outliers.insert(i);
    }
    surround.take_normals();
    left = Distances(surround, vertices, edge, Outliers::weighted_down);
  }
  for (int i : outliers) {
    const std::vector<int>& near = surround.near(i, feature_rings);
    const auto counts = [&](int j) { return outliers.count(j) > 0 || left.beyond(j); };
    if (left.beyond(i) || 1 + std::count_if(near.begin(), near.end(), counts) > most_in_one_place) continue;
    // What is left of the way once its neighbours are in place, from where the vertex is.
    surround.points[i] = patch.positions[i];
    const Vec3 way = surround.way_to_neighbours(i, Outliers::weighted_down);
    surround.points[i] += way;
    const double share = std::clamp(way.norm() / left.limit - 1, 0.0, 1.0);
    if (!(share > 0)) continue;
    clean_neighborhood.patch.positions[i] += share * way;
    ++clean_neighborhood.outliers;
  }
  return clean_neighborhood;
}

Patch carried_to(const Patch& original, const Patch& solved, double reach) {
  Patch result = solved;
  Points offset(result.vertex_count(), Vec3::Zero());
  for (int k = 0; k < original.vertex_count() - original.free_count; ++k)
    offset[result.free_count + k] =
        original.positions[original.free_count + k] - result.positions[result.free_count + k];
  std::vector<int> own(result.patch_triangles);
  std::iota(own.begin(), own.end(), 0);
  SparseMatrix C = clamped_cotan_stiffness(result.positions, result.triangles, own, robust_clamp);
  const Eigen::VectorXd fading = barycentric_areas(result.positions, result.triangles) / (reach * reach);
  C += SparseMatrix(fading.asDiagonal());
  minimise_quadratic_form(C, offset, 0, result.free_count);
  for (int i = 0; i < result.free_count; ++i) result.positions[i] += offset[i];
  std::copy(original.positions.begin() + original.free_count, original.positions.end(),
            result.positions.begin() + result.free_count);
  return result;
}

}  // namespace loopmend
