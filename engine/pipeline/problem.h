// SPDX-License-Identifier: GPL-3.0-or-later
// Problems beside single holes, posed and solved alike by the command line and the window.
#pragma once

#include "core/message.h"
#include "filling/loop_patch.h"
#include "filling/subdivide_polyhedron.h"
#include "pipeline/evolve_region.h"

#include <functional>
#include <memory>
#include <vector>

namespace loopmend {

/// Where flows begin, and how a patch becomes the whole surface again.
struct Problem {
  Patch start;
  std::function<TriangleSoup(const Patch&)> surface;
};

/// What came of a problem.
struct Solution {
  TriangleSoup surface;  ///< the whole; empty when refused or cancelled
  PatchResult outcome;
  Message refusal;  ///< why the surface must not be used, without a full stop; empty: it may
};

using ModelPtr = std::shared_ptr<const SurfaceModel>;

/// A problem that knows how it is solved.
struct PosedProblem {
  Problem problem;
  std::vector<int> replaced;  ///< triangles of the model's soup that the patch takes the place of
  Message remark;             ///< something to know about it; may be empty
  std::function<Solution(const EvolutionOptions&, const Evolution::OnStep&, const CancelToken&)> solve;
};

/// As `loopmend evolve`: vertices of the soup set free, everything else held.
/// @throws InvalidArgument as make_region.
PosedProblem pose_region(const ModelPtr& model, const std::vector<int>& vertices);

/// As `loopmend interpolate`: the polyhedron's chosen vertices held, everything else found.
/// @throws InvalidArgument as subdivide_polyhedron.
PosedProblem pose_points(const ModelPtr& polyhedron, const SubdivisionOptions& options);

/// As `loopmend blend`: one patch that joins the loops.
/// @throws InvalidArgument as bridge_loops, and where the loops cannot be joined.
PosedProblem pose_bridge(const ModelPtr& model, const std::vector<BoundaryLoop>& loops,
                         const InitialPatchOptions& options, const CancelToken& cancel);

/// As `loopmend compare` poses the holes of a mesh: all of them as one problem. `solve` is empty.
/// @throws InvalidArgument where none of them can be filled.
PosedProblem pose_holes(const ModelPtr& model, const std::vector<BoundaryLoop>& holes,
                        const InitialPatchOptions& options, const CancelToken& cancel);

}  // namespace loopmend
