// SPDX-License-Identifier: GPL-3.0-or-later
// One call of loopmend.fill(), without Python.
#pragma once

#include "pipeline/scan_job.h"

#include <vector>

namespace loopmend {

struct FillJob {
  TriangleSoup soup;
  ScanJob job;
  std::optional<double> max_seconds;                                   ///< above 0
  enum class Content { surface, patches } content = Content::surface;  ///< what is handed back
};

/// Where a hole's part of the patch is in the filled soup; empty where the hole was left open.
struct NewPart {
  std::vector<int> vertices;  ///< ascending
  std::vector<int> faces;     ///< ascending
};

struct FilledScan {
  TriangleSoup soup;
  std::vector<HoleResult> holes;                    ///< one for each loop, in the order of their numbers
  std::vector<NewPart> parts;                       ///< one for each of `holes`
  std::size_t given_vertices = 0, given_faces = 0;  ///< of the prepared scan, in `soup`: they come first there
  std::size_t turned_faces = 0;                     ///< to agree with their neighbours
  bool stopped = false;                             ///< some loops may be unfinished
  Preparation prepared;
  std::vector<BadBoundaryFace> trimmed;  ///< faces of the scan as it was before trimming
};

/// What is finished when `cancel` is set, or when its time is over, is kept.
/// @throws InvalidArgument as plan_scan().
FilledScan run_fill_job(FillJob job, const OnFillProgress& progress, const CancelToken& cancel);

}  // namespace loopmend
