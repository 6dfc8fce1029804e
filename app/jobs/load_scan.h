// SPDX-License-Identifier: GPL-3.0-or-later
// Opening a scan, off the window's thread: read, see, find loops, colour.
#pragma once

#include "core/cancel.h"
#include "document/opened_scan.h"

#include <functional>
#include <optional>

namespace loopmend {

using OpenedScanPtr = std::shared_ptr<OpenedScan>;

/// Called on the worker's thread, in this order; each may be empty.
struct LoadStages {
  std::function<void(SurfaceShapePtr)> picture;  ///< first plain picture, of a large one reduced
  std::function<void(OpenedScanPtr)> opened;     ///< model and loops, no curvature yet
  std::function<void(QString, double)> stage;    ///< name of the step at work; share of the time before it, 0..1
};

/// @param path    empty: the embedded sample.
/// @param origin  what its positions are relative to; empty: the middle of its box.
/// @returns the scan; null when cancelled. @throws Error; nothing is called after that.
OpenedScanPtr load_scan(const QString& path, std::optional<Vec3> origin, const LoadStages& stages,
                        const CancelToken& cancel);

/// A surface that the window has made, with curvature.
OpenedScanPtr made_scan(TriangleSoup surface, const QString& name, const Vec3& origin);

/// The scan's shape with curvature. Null when cancelled.
SurfaceShapePtr colored_shape(const OpenedScan& scan, const CancelToken& cancel);

}  // namespace loopmend
