// SPDX-License-Identifier: GPL-3.0-or-later
// Normal, H and ∇H of the neighborhood along a loop, each with its uncertainty.
#pragma once

#include "mesh/patch.h"
#include "operators/topology.h"
#include "operators/vertex_normals.h"
#include "split/split_estimate.h"

#include <span>
#include <vector>

namespace loopmend {

/// The triangles around a patch by themselves, with what fits to them need.
struct FixedSurface {
  explicit FixedSurface(const Patch& patch)
      : triangles(patch.triangles.begin() + patch.patch_triangles, patch.triangles.end()),
        topology(patch.vertex_count(), triangles),
        normals(angle_weighted_normals(patch.positions, triangles)) {}

  Triangles triangles;
  Topology topology;  ///< of all vertices; the free ones have no neighbours
  Points normals;     ///< #V, zero at the free vertices
};

/// At one loop vertex, from the neighborhood alone. Patch frame; uncertainties are standard deviations.
struct BoundaryFit {
  bool valid = false;  ///< false where the neighborhood does not determine a cubic
  Vec3 normal = Vec3::Zero();
  double normal_sigma = 0;  ///< radians
  double H = 0;             ///< 1/length; −1/R on a sphere with outward normals
  double H_sigma = 0;
  double gradient = 0;  ///< ‖∇H‖, 1/length²
  double gradient_sigma = 0;
};

/// Robust cubic fits at the vertices of each loop, in the order of Patch::loops. The width of a loop's, 3 to 5 rings, is the
/// largest that leaves over no more than white noise does: at most 1.5 times the smallest residual of the narrower ones.
std::vector<std::vector<BoundaryFit>> boundary_fits(const Patch& patch, const FixedSurface& surface);

/// Standard deviation of H, 1/length in mesh units, at each fixed vertex of rings 1 to 4, from the same fits; NaN farther out
/// and where there is no fit. One value for each fixed vertex, in their order.
std::vector<float> curvature_uncertainty(const Patch& patch);
/// The same at the given vertices of the patch alone, NaN at all others.
std::vector<float> curvature_uncertainty(const Patch& patch, std::span<const int> vertices);

/// What a person wants to know of one boundary. Mesh units.
struct BoundarySummary {
  SplitEstimate split;                             ///< of the whole problem; patch frame
  double relief = 0, noise = 0;                    ///< SplitEstimate's heights, length
  double relief_per_edge = 0, noise_per_edge = 0;  ///< the same in mean edge lengths of the loop
  double normal_sigma_deg = 0;                     ///< rms of BoundaryFit::normal_sigma over the loop
  double H = 0, H_sigma = 0;                       ///< rms over the loop, 1/length
  double gradient = 0, gradient_sigma = 0;         ///< rms over the loop, 1/length²
  int fitted = 0;                                  ///< loop vertices with a valid fit
};

/// One for each loop, in the order of Patch::loops.
/// @param fits  of boundary_fits(patch).
std::vector<BoundarySummary> boundary_summaries(const Patch& patch, const SplitEstimate& split,
                                                const std::vector<std::vector<BoundaryFit>>& fits);
std::vector<BoundarySummary> boundary_summaries(const Patch& patch, const SplitEstimate& split);

}  // namespace loopmend
