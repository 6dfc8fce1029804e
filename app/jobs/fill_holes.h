// G0 fillers for chosen loops, off the window's thread.
#pragma once

#include "document/document.h"
#include "evolution/fill_loops.h"

#include <functional>
#include <map>

namespace loopmend {

struct FillTask {
  std::shared_ptr<const SurfaceModel> model;
  std::vector<BoundaryLoop> loops;  ///< those to fill
  std::vector<int> loop_indices;    ///< their indices in the document
  FillerOptions options;
  Vec3 origin = Vec3::Zero();
};

struct FillResult {
  std::vector<OpenPatch> patches;       ///< ids are not set
  std::map<int, std::string> failures;  ///< by index in the document, in words
  std::map<int, std::string> remarks;   ///< filled, but with something left to wish
};

/// @param progress  holes done; called from several threads, one call at a time.
FillResult fill_holes(const FillTask& task, const std::function<void(int)>& progress, const CancelToken& cancel);

}  // namespace loopmend
