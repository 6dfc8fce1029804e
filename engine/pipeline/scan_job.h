// SPDX-License-Identifier: GPL-3.0-or-later
// What happens to a scan between its files: prepare it, choose its loops, fill them, check that nothing else was changed. The
// command line, the batch and the Python module call these functions, so that the same options give the same bits.
#pragma once

#include "core/deadline.h"
#include "pipeline/choose_loops.h"
#include "pipeline/fill_holes.h"
#include "pipeline/paste.h"
#include "pipeline/prepare.h"
#include "pipeline/rim_groups.h"
#include "pipeline/tile_outlines.h"
#include "pipeline/tried_advice.h"
#include "repair/inverted_shells.h"

#include <cstddef>
#include <filesystem>
#include <optional>
#include <vector>

namespace loopmend {

struct ScanJob {
  PrepareOptions prepare;
  LoopSelection loops;
  FillOptions fill;
  std::optional<double> max_memory_mb;  ///< of the whole process, above 0; without: nine tenths of what is available
  std::filesystem::path source{};       ///< named in errors; empty: the surface comes from no file
  /// Whether loops have the numbers that `loopmend blend` would give them.
  enum class Numbering { of_source, of_prepared } numbering = Numbering::of_source;
};

/// A prepared scan, and what is to be done with each of its loops.
struct ScanPlan {
  SoupRecord given;  ///< of the prepared mesh: with this the output is compared
  SurfaceModel model;
  Preparation done;
  std::vector<BoundaryLoop> loops;
  std::vector<LoopChoice> choices;         ///< one for each loop
  NearBoundaries coincident;               ///< where --stitch would join something; empty where it was asked for
  std::vector<BadBoundaryFace> trimmed;    ///< faces of the mesh as it was before --trim-boundary
  std::vector<BadBoundaryFace> bad_faces;  ///< bad triangles that are left at the boundaries of `to_trim`
  std::vector<BadBoundaryFace> trimmable;  ///< those of bad_faces for which trimming can be proposed
  std::size_t spared_pieces = 0;           ///< of which --trim-boundary would have taken too much
  std::vector<char> at_walls;              ///< per loop whether it bounds the wall of a pipe or a side of a plate
  TileOutlines tiles;                      ///< outlines that are left beside or over other sheets
  InvertedShells inverted;                 ///< what looks inward still
  std::vector<RimGroup> rim_groups;        ///< loops across from each other that a command joins; indices into `loops`
  std::vector<BoundaryLoop> to_trim;       ///< the loops to fill, and those that trimming left no hole
  PrepareOptions used;                     ///< what was asked for, and what was done since the mesh needed it
  /// Whether trimming makes every hole good that failed or has a bad patch; fill_chosen() finds out.
  enum class TrimmingHelps { not_tried, yes, no } trimming_helps = TrimmingHelps::not_tried;

  std::vector<BoundaryLoop> chosen() const;
  /// Faces turned to agree with their neighbors: in the mesh as it was read, and in what was made of it.
  std::size_t turned_faces() const { return done.turned_faces + model.repairs.reoriented_faces; }
};

/// Whether a job has to see the whole surface first; else a view for filling (pipeline/filling_view.h) serves.
bool needs_whole_view(const ScanJob& job);

/// Prepares the scan, then finds and chooses its loops.
/// @param given  of the mesh, before any face was turned. @param model  made of it; see needs_whole_view(). Cancelled, repairs may
/// be left undone.
/// @throws ReadError or InvalidArgument where no usable face is left (the former where the job names its source);
/// InvalidArgument for loops, vertices or bridges that do not exist.
ScanPlan plan_scan(SoupRecord given, SurfaceModel model, const ScanJob& job, const CancelToken& cancel = {},
                   const OnRepairStep& on_step = {});

/// Fills the chosen loops into the plan's model, within the memory that the job allows, and compares what was given, bit for
/// bit. What is finished when the token is cancelled is kept.
/// @returns one result for each loop, in the order of their numbers; those that were left, or were not finished, say why.
std::vector<HoleResult> fill_chosen(ScanPlan& plan, const ScanJob& job, const Deadline& deadline,
                                    const OnFillProgress& progress, const CancelToken& cancel);

}  // namespace loopmend
