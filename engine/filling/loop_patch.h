// SPDX-License-Identifier: GPL-3.0-or-later
// From a boundary loop to the initial patch: triangulate, refine to the density of the neighborhood, remesh, relax.
#pragma once

#include "core/cancel.h"
#include "core/message.h"
#include "mesh/patch.h"
#include "mesh/self_intersections.h"
#include "mesh/validity.h"

#include <optional>

namespace loopmend {

enum class InitialShape {
  minimal,       ///< relaxed to a minimal surface
  triangulated,  ///< as the loop's triangulation lies in space, with its creases: nearer to a bulging neighborhood
};

struct InitialPatchOptions {
  double density = 1;  ///< edges per length relative to the neighborhood, 0.1..10: 2 halves the edge length
  InitialShape shape = InitialShape::minimal;
  double most_vertices = 2e6;  ///< a loop that needs more is left open, above 0; 2 million take some 13 GB to solve
};

/// @throws InvalidArgument if an option is out of range.
void check(const InitialPatchOptions& options);

struct LoopPatchOutcome {
  std::optional<LoopPatch> patch;  ///< empty when there is no valid triangulation, or when cancelled
  Message message;                 ///< error or warning; empty if none
  Validity quality;
};

/// Reads the model, never changes it. No new vertex lies on the loop.
/// @throws InvalidArgument if the density is out of range.
LoopPatchOutcome fill_loop(const SurfaceModel& model, const BoundaryLoop& loop, const InitialPatchOptions& options,
                           const CancelToken& cancel);

/// For a loop whose ordinary patches cut the surface: the loop is triangulated by triangles that cut nothing of the scan, and refined
/// as far as none of them does. Up to 200 edges.
/// @param index  of the model's soup triangles
/// @throws InvalidArgument if the density is out of range.
LoopPatchOutcome fill_loop_uncut(const SurfaceModel& model, const TriangleIndex& index, const BoundaryLoop& loop,
                                 const InitialPatchOptions& options, const CancelToken& cancel);

}  // namespace loopmend
