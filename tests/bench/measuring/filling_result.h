// SPDX-License-Identifier: GPL-3.0-or-later
// What a program made of a hole problem, and how good it is: the same figures for everybody.
#pragma once

#include "hole_problem.h"
#include "pipeline/fill_holes.h"

#include <string>

namespace loopmend::bench {

/// Patches for all loops of a problem together.
struct Filling {
  Points points;          ///< new vertices, mesh units
  Triangles triangles;    ///< over the vertices of the problem's view, then the new ones
  bool complete = false;  ///< every loop got a patch
  std::string status;     ///< one word for the whole problem
  std::string message;    ///< the reason, where there is one
  std::string attempt;    ///< the strategy's attempt that made the worst loop's patch; empty for others
  int steps = 0;          ///< of the flow, the most over the loops; 0 for others
  double bending = 0;     ///< HoleResult::bending, the most over the loops
  double energy_before = 0, energy_after = 0;  ///< of patches of the flow, summed over the loops (mmcvf: 1/length²)
  DeviationPredictors predictors;              ///< of the loop with the largest second_order; 0: not known
  MirrorFit mirror;                            ///< of the first loop
  double seconds = 0;                          ///< of the filling call alone
  bool exterior_unchanged = true;              ///< input points and triangles, bit for bit
};

/// By the engine in one call, as `loopmend fill` does.
Filling fill_by_engine(const HoleProblem& problem, const FillOptions& options = {}, const CancelToken& cancel = {});

/// d in 1e-3 of the hole's diameter; NaN where there is nothing to measure.
struct PatchFigures {
  double d_rms = 0;  ///< new vertices to the truth, weighted by their areas
  double d_max = 0;  ///< the largest of these
  double d_faces =
      0;          ///< rms over points spread evenly over the new faces (a facet misses a curved truth by its sagitta)
  double g1 = 0;  ///< rms angle between the one-sided normals at the loop, degrees
  double g2 = 0;  ///< rms |H_in − H_out| · diameter of the loop
  double min_angle = 0;  ///< of the new triangles, degrees
  int folds = 0;         ///< edges of new triangles with a dihedral over 90°
  int cuts = 0;          ///< pairs of triangles that cut each other, one of them new
  double reach = 0;      ///< farthest new vertex from the middle of its nearest loop, in loop diameters
};

PatchFigures measure(const HoleProblem& problem, const Filling& filling);

}  // namespace loopmend::bench
