// SPDX-License-Identifier: GPL-3.0-or-later
// G0 fillers for chosen loops, off the window's thread.
#pragma once

#include "document/document.h"
#include "evolution/fill_loops.h"
#include "jobs/scan_site.h"

#include <functional>
#include <map>

namespace loopmend {

/// The holes of one scan.
struct FillTask {
  int scan = 0;
  ScanSitePtr site;
  std::map<int, BoundaryLoop> wanted;  ///< by index in the document
  /// Filled before. One whose surroundings overlap those of a wanted loop is filled again, jointly: the two could not
  /// know of each other otherwise.
  std::map<int, BoundaryLoop> filled;
  FillerOptions options;
  Vec3 origin = Vec3::Zero();
};

enum class Judging {
  cuts,  ///< each patch is tested for cuts with the scan
  none,  ///< for a preview
};

struct FillResult {
  std::vector<OpenPatch> patches;       ///< ids are not set
  std::map<int, std::string> failures;  ///< by index in the document, in words
  std::map<int, std::string> remarks;   ///< filled, but with something left to wish
};

/// @param progress  holes done; called from several threads, one call at a time.
FillResult fill_holes(const std::vector<FillTask>& tasks, Judging judging, const std::function<void(int)>& progress,
                      const CancelToken& cancel);

}  // namespace loopmend
