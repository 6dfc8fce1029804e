// SPDX-License-Identifier: GPL-3.0-or-later
// Initial patches for chosen loops, off the window's thread.
#pragma once

#include "document/document.h"
#include "jobs/scan_context.h"
#include "pipeline/fill_holes.h"

#include <functional>
#include <map>
#include <set>

namespace loopmend {

/// The holes of one scan.
struct FillTask {
  int scan = 0;
  ScanContextPtr scan_context;
  std::map<int, BoundaryLoop> wanted;  ///< by index in the document
  /// Filled before. One whose neighborhood overlaps that of a wanted loop is filled again, jointly: the two could not
  /// know of each other otherwise.
  std::map<int, BoundaryLoop> filled;
  FillOptions options;
  std::set<int> taken;  ///< loops that have a patch which stays
  int first_loop = 0;   ///< index of the scan's first loop in the document
  Vec3 origin = Vec3::Zero();
};

struct FillResult {
  std::vector<OpenPatch> patches;   ///< ids are not set
  std::map<int, Message> failures;  ///< by index in the document
  std::map<int, Message> remarks;   ///< filled, but with something left to wish
};

/// Each patch is validated against its scan.
/// @param progress  holes done; called from several threads, one call at a time.
FillResult make_initial_patches(const std::vector<FillTask>& tasks, const std::function<void(int)>& progress,
                                const CancelToken& cancel);

}  // namespace loopmend
