// SPDX-License-Identifier: GPL-3.0-or-later
// What a fill does between its files: prepare the scan, choose its loops, fill them. `loopmend fill` and the Python module
// call the same, so that the same options give the same bits.
#pragma once

#include "bounds.h"
#include "loop_selection.h"

#include "mesh/no_data.h"
#include "pipeline/paste.h"
#include "repair/repair_surface.h"
#include "repair/stitch_boundaries.h"

#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace loopmend {

/// What was done to the mesh before any loop was looked at.
struct Preparation {
  std::optional<StitchedSurface> stitched;  ///< without its soup
  std::optional<RepairCounts> repaired;
  std::size_t joined_again = 0;  ///< vertices at cracks that the repair left, where both stitching and repair are done
  std::size_t bridges = 0;
  int base_loop = 0;              ///< under which a base was built; 0: none
  NoDataVertices no_data;         ///< that were found
  std::size_t no_data_faces = 0;  ///< that were removed there
  ModelRepairs before;            ///< of the mesh as it was read
  std::size_t turned_faces = 0;   ///< in the mesh as it was read, where another mesh came out of it
};

struct PreparedScan {
  SoupRecord given;  ///< of the prepared mesh: with this the output is compared
  SurfaceModel model;
  Preparation done;
  std::vector<BoundaryLoop> loops;
  std::vector<LoopChoice> choices;       ///< one for each loop
  NearBoundaries near;                   ///< where --stitch would join something; only where it was not asked for
  std::vector<BadBoundaryFace> trimmed;  ///< faces of the mesh as it was before --trim-boundary
  std::vector<BadBoundaryFace>
      trimmable;                  ///< bad triangles at the loops that are filled, where trimming can be proposed
  std::size_t spared_pieces = 0;  ///< of which --trim-boundary would have taken too much
  std::vector<std::pair<int, int>> rings;  ///< loops that `blend` would join by a ring; indices into `loops`
  std::vector<BoundaryLoop> to_trim;       ///< the loops that are filled, and those that trimming left no hole

  std::vector<BoundaryLoop> chosen() const;
  /// Faces turned to agree with their neighbours: in the mesh as it was read, and in what was made of it.
  std::size_t turned_faces() const { return done.turned_faces + model.repairs.reoriented_faces; }
};

/// Stitches, repairs, bridges and trims as the command asks, then finds and chooses the loops.
/// @param as_read  of the mesh, before any face was turned. @param model  made of it; a view that is not whole must be one for
/// filling, and serves only where needs_whole_view() does not say otherwise. Cancelled, repairs may be left undone.
/// @throws ReadError or InvalidArgument where no usable face is left (the former where the command names a file); UsageError,
/// InvalidArgument for loops, vertices or bridges that there are not.
PreparedScan prepare_scan(SoupRecord as_read, SurfaceModel model, const FillCommand& command,
                          const CancelToken& cancel = {});

/// Whether what the command asks for first walks over the whole surface.
bool needs_whole_view(const FillCommand& command);

/// Fills the chosen loops into the scan's model, with no more memory than the command allows, and compares what was given, bit
/// for bit. What is finished when the token is cancelled is kept.
/// @returns one result for each loop, in the order of their numbers; those that were left, or were not finished, say why.
std::vector<HoleResult> fill_chosen(PreparedScan& scan, const FillCommand& command, const Deadline& deadline,
                                    const OnFillProgress& progress, const CancelToken& cancel);

}  // namespace loopmend
