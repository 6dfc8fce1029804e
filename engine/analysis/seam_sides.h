// SPDX-License-Identifier: GPL-3.0-or-later
// Fits at the vertices of a seam from one side only.
#pragma once

#include "mesh/patch.h"
#include "operators/polynomial_fit.h"
#include "operators/vertex_normals.h"

namespace loopmend {

/// A cubic (a quadratic where the side is small) over the nearest two to five rings that hold 18 vertices.
constexpr FitOptions one_sided_fit() {
  FitOptions options;
  options.most_rings = 5;
  options.enough = 18;
  options.degree = 3;
  options.spare = 1;
  options.least_condition = last_condition;
  options.softening = 0.1;
  return options;
}

inline Triangles own_triangles(const Patch& patch) {
  return {patch.triangles.begin(), patch.triangles.begin() + patch.patch_triangles};
}
inline Triangles triangles_around(const Patch& patch) {
  return {patch.triangles.begin() + patch.patch_triangles, patch.triangles.end()};
}

/// The patch and its neighborhood, each by itself.
class SeamSides {
 public:
  explicit SeamSides(const Patch& patch)
      : patch_(patch),
        inside_(patch.vertex_count(), own_triangles(patch)),
        outside_(patch.vertex_count(), triangles_around(patch)),
        normals_(angle_weighted_normals(patch.positions, patch.triangles)),
        scratch_(patch.vertex_count()) {}

  /// Whether both sides determine a fit at v.
  bool fit(int v, const FitOptions& options) {
    return fit_polynomial(patch_.positions, inside_, v, normals_[v], options, scratch_, in) &&
           fit_polynomial(patch_.positions, outside_, v, normals_[v], options, scratch_, out);
  }

  PolynomialFit in, out;  ///< the last ones, patch frame

 private:
  const Patch& patch_;
  Topology inside_, outside_;
  Points normals_;
  FitScratch scratch_;
};

}  // namespace loopmend
