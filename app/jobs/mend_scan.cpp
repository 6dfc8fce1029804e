// SPDX-License-Identifier: GPL-3.0-or-later
#include "jobs/mend_scan.h"

#include "jobs/fill_controller.h"
#include "pipeline/hand_bridge.h"
#include "repair/repair_surface.h"
#include "repair/stitch_boundaries.h"
#include "rim/trim_rim.h"

namespace loopmend {

namespace {

std::optional<MendedScan> trimmed(const MendingTask& task) {
  constexpr int rounds = 3;
  const OpenedScan& old = *task.opened;
  TrimmedModel result = trim_rim(*old.model, task.loops, rounds);
  if (result.removed.empty()) return std::nullopt;
  const QString words =
      FillController::tr("%1: %2 bad triangles were removed at the boundaries; Ctrl+Z brings them back.")
          .arg(old.name)
          .arg(result.removed.size());
  return MendedScan{task.scan, made_scan(std::move(result.model.soup), old.name, old.origin),
                    FillController::tr("Trim the boundaries of %1").arg(old.name), words};
}

std::optional<MendedScan> stitched(const MendingTask& task) {
  const OpenedScan& old = *task.opened;
  StitchedSurface result = stitch_boundaries(*old.model);
  if (result.joined_vertices + result.split_faces == 0) return std::nullopt;
  const QString words =
      FillController::tr("%1: %2 vertices were joined to others, %3 faces split; Ctrl+Z takes it back.")
          .arg(old.name)
          .arg(result.joined_vertices)
          .arg(result.split_faces);
  return MendedScan{task.scan, made_scan(std::move(result.soup), old.name, old.origin),
                    FillController::tr("Stitch %1").arg(old.name), words};
}

std::optional<MendedScan> repaired(const MendingTask& task) {
  const OpenedScan& old = *task.opened;
  RepairedSurface result = repair_surface(old.model->soup, task.defects);
  const RepairCounts& counts = result.counts;
  if (!counts.any()) return std::nullopt;
  QStringList done;
  const auto add = [&done](std::size_t count, const QString& text) {
    if (count > 0) done << text;
  };
  const auto n = [](std::size_t count) { return static_cast<int>(count); };
  add(counts.joined_points, FillController::tr("%n vertices joined", nullptr, n(counts.joined_points)));
  add(counts.degenerate_faces, FillController::tr("%n degenerate faces removed", nullptr, n(counts.degenerate_faces)));
  add(counts.duplicate_faces, FillController::tr("%n duplicate faces removed", nullptr, n(counts.duplicate_faces)));
  add(counts.intersecting_faces,
      FillController::tr("%n intersecting faces cut out", nullptr, n(counts.intersecting_faces)));
  add(counts.separated_edges, FillController::tr("%n edges separated", nullptr, n(counts.separated_edges)));
  add(counts.separated_vertices, FillController::tr("%n vertices separated", nullptr, n(counts.separated_vertices)));
  add(counts.turned_faces, FillController::tr("%n faces turned", nullptr, n(counts.turned_faces)));
  add(counts.removed_pieces, FillController::tr("%n loose crumbs removed", nullptr, n(counts.removed_pieces)));
  const QString words =
      FillController::tr("%1: %2. Ctrl+Z takes it back.").arg(old.name, done.join(QStringLiteral(", ")));
  return MendedScan{task.scan, made_scan(std::move(result.soup), old.name, old.origin),
                    FillController::tr("Repair %1").arg(old.name), words};
}

MendedScan bridged(const MendingTask& task) {
  const OpenedScan& old = *task.opened;
  const auto [a, b] = task.bridge_ends;
  const QString words =
      FillController::tr("%1: a bridge was laid between the vertices %2 and %3; Ctrl+Z takes it back.")
          .arg(old.name)
          .arg(a)
          .arg(b);
  return MendedScan{task.scan, made_scan(with_bridge(*old.model, a, b), old.name, old.origin),
                    FillController::tr("Bridge a hole of %1").arg(old.name), words};
}

}  // namespace

std::optional<MendedScan> mended(Mending what, const MendingTask& task) {
  std::optional<MendedScan> result;
  switch (what) {
    case Mending::trim: result = trimmed(task); break;
    case Mending::stitch: result = stitched(task); break;
    case Mending::repair: result = repaired(task); break;
    case Mending::bridge: result = bridged(task); break;
  }
  if (result) result->lost_patches = task.patches;
  return result;
}

QString nothing_to_mend(Mending what) {
  switch (what) {
    case Mending::trim: return FillController::tr("There are no bad triangles at these boundaries.");
    case Mending::stitch: return FillController::tr("No boundaries lie close enough together to be stitched.");
    case Mending::repair: return FillController::tr("There is nothing to repair.");
    case Mending::bridge: break;
  }
  return {};
}

QString mending_title(Mending what) {
  switch (what) {
    case Mending::trim: return FillController::tr("Trimming boundaries");
    case Mending::stitch: return FillController::tr("Stitching boundaries");
    case Mending::repair: return FillController::tr("Repairing the scan");
    case Mending::bridge: return FillController::tr("Bridging a hole");
  }
  return {};
}

}  // namespace loopmend
