// SPDX-License-Identifier: GPL-3.0-or-later
// Problems beside single holes, posed and solved alike by the command line and the window.
#pragma once

#include "evolution/interpolate_points.h"
#include "mesh/region.h"

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace loopmend {

/// Where flows begin, and how a patch becomes the whole surface again.
struct Problem {
  Patch start;
  std::function<TriangleSoup(const Patch&)> surface;
};

/// What came of a problem, judged as the command line judges it.
struct Solution {
  TriangleSoup surface;  ///< the whole; empty when refused or cancelled
  Patch patch;
  std::string refusal;  ///< why the surface must not be used, in words without a full stop; empty: it may
  EvolutionStatus status = EvolutionStatus::ready;
  std::string message;  ///< why it stopped early; empty when all is well
  std::string method;   ///< method_name()
  int steps = 0;
  double initial_energy = 0, final_energy = 0;  ///< units as in StepRecord
};

using ModelPtr = std::shared_ptr<const SurfaceModel>;

/// A problem that knows how it is solved.
struct PosedProblem {
  Problem problem;
  std::vector<int> replaced;  ///< triangles of the model's soup that the patch takes the place of
  std::string remark;         ///< something to know about it; may be empty
  std::function<Solution(const EvolutionOptions&, const Evolution::OnStep&, const CancelToken&)> solve;
};

/// As `loopmend evolve`: vertices of the soup set free, everything else held.
/// @throws InvalidArgument as make_region.
PosedProblem pose_region(const ModelPtr& model, const std::vector<int>& vertices);

/// The region alone, and its flow, with what the command wants to report.
EvolvedPatch evolve_region(const Region& region, EvolutionOptions options, const Evolution::OnStep& on_step,
                           const CancelToken& cancel);
/// Why this must not be used; empty when it may.
std::string refusal_of(const Region& region, const EvolvedPatch& evolved);

/// As `loopmend interpolate`: the polyhedron's chosen vertices held, everything else found.
/// @throws InvalidArgument as subdivide_polyhedron.
PosedProblem pose_points(const ModelPtr& polyhedron, const SubdivisionOptions& options);

/// Why what interpolate_points found must not be used; empty when it may.
std::string refusal_of(const Interpolation& result);

/// As `loopmend blend`: one patch that joins the loops.
/// @throws InvalidArgument as bridge_loops, and where the loops cannot be joined.
PosedProblem pose_bridge(const ModelPtr& model, const std::vector<BoundaryLoop>& loops, const FillerOptions& options,
                         const CancelToken& cancel);

/// As `loopmend compare` poses the holes of a mesh: all of them as one problem. `solve` is empty.
/// @throws InvalidArgument where none of them can be filled.
PosedProblem pose_holes(const ModelPtr& model, const std::vector<BoundaryLoop>& holes, const FillerOptions& options,
                        const CancelToken& cancel);

}  // namespace loopmend
