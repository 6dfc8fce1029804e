// SPDX-License-Identifier: GPL-3.0-or-later
// A document whose loops are known: a flat sheet of 10 by 10 squares of side 1 with two holes.
#pragma once

#include "document/document.h"
#include "samples/analytic_surfaces.h"

#include <QString>

namespace loopmend::test {

// Indices of the sheet's loops, by falling perimeter; BoundaryLoop::number is one more.
inline constexpr int boundary = 0;  ///< 40 edges, an outer rim
inline constexpr int square = 1;    ///< 8 edges, perimeter 8, diameter 2 √2
inline constexpr int diamond = 2;   ///< 4 edges, perimeter 4 √2, diameter 2

inline TriangleSoup sheet_with_two_holes() {
  const auto is_at = [](const Vec3& p, double x, double y) { return (p - Vec3(x, y, 0)).norm() < 0.1; };
  // Around these two vertices there are eight triangles and four.
  return cut(make_graph([](double, double) { return 0.0; }, 5, 10),
             [&](const Vec3& p) { return is_at(p, -2, -2) || is_at(p, 2, 1); });
}

inline std::shared_ptr<OpenedScan> scan_from(const QString& path, ScanOrigin from = ScanOrigin::file) {
  auto scan = std::make_shared<OpenedScan>();
  scan->path = path;
  scan->from = from;
  scan->name = QStringLiteral("sheet");
  scan->model = std::make_shared<const SurfaceModel>(make_surface_model(sheet_with_two_holes()));
  scan->loops = find_boundary_loops(*scan->model);
  scan->fingerprint = fingerprint_of(scan->model->soup);
  return scan;
}

inline std::shared_ptr<PatchState> state_at(PatchStatus stage) {
  auto state = std::make_shared<PatchState>();
  state->status = stage;
  return state;
}

/// Puts a patch into these loops. @returns its id.
inline int add_patch(Document& document, const std::vector<int>& loops, const PatchStatePtr& state,
                     Acceptance acceptance = Acceptance::pending) {
  OpenPatch patch;
  patch.id = document.next_patch_id();
  patch.scan = document.scan_of(loops.front());
  patch.loops = loops;
  patch.state = state;
  patch.timeline = std::make_shared<Timeline>(Timeline{state});
  patch.acceptance = acceptance;
  document.replace({}, {patch});
  return patch.id;
}

/// With the sheet opened from /scans/sheet.ply.
struct SheetDocument : Document {
  SheetDocument() { add_scan(scan_from(QStringLiteral("/scans/sheet.ply"))); }
};

}  // namespace loopmend::test
