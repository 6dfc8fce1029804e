// SPDX-License-Identifier: GPL-3.0-or-later
// Loops at which the surface ends: the base of a bust, the end of a tube, the opening of a vase.
#pragma once

#include "mesh/boundary_loops.h"

namespace loopmend {

/// Largest planarity of a loop that is closed flat: 0.030 as printed. Bases of scanned statues have up to that.
inline constexpr double flat_planarity = 0.0305;

/// What the surface does at a loop.
enum class LoopEnd {
  runs_on,  ///< it continues across the hole
  flat,     ///< it was cut: the wall leaves the loop's plane on one side all along; a plane cap is missing
  toothed,  ///< flat, but the loop goes up and down by whole edges, as where faces below a plane were removed: a plane base is missing
  /// Flat, but at the loop the wall bends like a dome's, or lies on a quadric that closes high over it: a base that curves in, or an egg
  /// without its end.
  flat_or_dome,
  curved,  ///< flat at an outer rim that is not plane: a minimal surface is missing
};

/// `flat` where the loop is nearly plane (planarity up to 0.03), the surface meets its plane steeply on one side along
/// nine tenths of the loop or more, and neither does it bend towards closing there as a ball through the loop would, on
/// one quadric that goes on behind (if it bends so on no quadric, it is `flat_or_dome`), nor does it lie on a quadric,
/// almost exactly, that closes over the loop (if it closes higher than half a ball, the end is `flat_or_dome`). A wall
/// that flares ends at a plane loop, however little it leans. At a hole whose loop is not quite plane the wall has to
/// be steeper. An upright wall that does not turn ends whatever its corners. A straight wall whose rulings all leave
/// through a loop that is not nearly plane, of planarity up to 0.35, is `curved`, as the saddle at the end of a pipe.
/// So are, up to 0.1, the other walls of outer rims: of holes in natural surfaces, those with such loops mostly run on.
/// An exactly plane loop is `flat` also where all faces at it are square to its plane, or where it is a polygon
/// (BoundaryLoop::is_polygon) and the faces leave it on one side. A loop that is not exactly plane runs on where the wall
/// clearly bends like a ball.
/// With eight teeth or more a loop that would be flat is `toothed`. The surface is read from fits behind the loop, so
/// that noise does not decide; which side of it is out does not matter.
LoopEnd loop_end(const SurfaceModel& model, const BoundaryLoop& loop);

/// Distance from the loop within which loop_end() reads the surface, mesh units; 0 where the loop's own shape decides.
double reach_of_loop_end(const SurfaceModel& model, const BoundaryLoop& loop);

}  // namespace loopmend
