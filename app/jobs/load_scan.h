// Opening a scan, off the window's thread: read, see, find loops, colour.
#pragma once

#include "document/document.h"

#include <functional>

namespace loopmend {

/// Called on the worker's thread, in this order.
struct LoadStages {
  std::function<void(std::shared_ptr<const SurfaceShape>)> picture;  ///< first plain picture
  std::function<void(OpenedScan)> opened;                            ///< model and loops, no H yet
  std::function<void(std::shared_ptr<const SurfaceShape>)> colored;  ///< the same with H
  std::function<void(QString)> stage;                                ///< what is being done, in words
};

/// @param path  empty: the embedded sample.
/// @throws Error; nothing is called after that. Returns early when cancelled.
void load_scan(const QString& path, const LoadStages& stages, const CancelToken& cancel);

}  // namespace loopmend
