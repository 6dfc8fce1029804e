// SPDX-License-Identifier: GPL-3.0-or-later
#include "jobs/repair_words.h"

#include "jobs/fill_controller.h"

namespace loopmend {
namespace {

QString doing(RepairStage stage) {
  switch (stage) {
    case RepairStage::survey: return FillController::tr("looking for what it needs");
    case RepairStage::remove_no_data: return FillController::tr("removing faces of missing data");
    case RepairStage::stitch: return FillController::tr("stitching boundaries");
    case RepairStage::join_vertices: return FillController::tr("joining vertices at the same place");
    case RepairStage::remove_degenerate: return FillController::tr("removing degenerate faces");
    case RepairStage::remove_duplicates: return FillController::tr("removing duplicate faces");
    case RepairStage::cut_intersections: return FillController::tr("cutting out faces that intersect others");
    case RepairStage::separate: return FillController::tr("separating non-manifold edges and vertices");
    case RepairStage::turn_outward: return FillController::tr("turning around what looks inward");
    case RepairStage::unite: return FillController::tr("uniting bodies that overlap");
    case RepairStage::cut_handles: return FillController::tr("cutting tiny handles open");
    case RepairStage::remove_fragments: return FillController::tr("removing loose fragments and fins");
    case RepairStage::trim: return FillController::tr("removing triangles that cross at holes");
    case RepairStage::measure_result: return FillController::tr("looking for holes, computing curvature");
  }
  return {};
}

}  // namespace

QString repair_step(const QString& title, const RepairStep& step) {
  if (step.of < 2) return FillController::tr("%1: %2").arg(title, doing(step.stage));
  return FillController::tr("%1: %2 (%L3 of %L4)").arg(title, doing(step.stage)).arg(step.number).arg(step.of);
}

QStringList list_of(const RepairCounts& counts) {
  QStringList done;
  const auto add = [&done](std::size_t count, const QString& text) {
    if (count > 0) done << text;
  };
  const auto n = [](std::size_t count) { return static_cast<int>(count); };
  add(counts.joined_points, FillController::tr("%Ln vertices joined", nullptr, n(counts.joined_points)));
  add(counts.degenerate_faces, FillController::tr("%Ln degenerate faces removed", nullptr, n(counts.degenerate_faces)));
  add(counts.duplicate_faces, FillController::tr("%Ln duplicate faces removed", nullptr, n(counts.duplicate_faces)));
  add(counts.intersecting_faces,
      FillController::tr("%Ln intersecting faces cut out", nullptr, n(counts.intersecting_faces)));
  add(counts.separated_edges, FillController::tr("%Ln edges separated", nullptr, n(counts.separated_edges)));
  add(counts.separated_vertices, FillController::tr("%Ln vertices separated", nullptr, n(counts.separated_vertices)));
  add(counts.turned_faces, FillController::tr("%Ln faces turned", nullptr, n(counts.turned_faces)));
  add(counts.united.bodies, FillController::tr("%Ln bodies united", nullptr, n(counts.united.bodies)));
  add(counts.cut_handles, FillController::tr("%Ln tiny handles cut open", nullptr, n(counts.cut_handles)));
  add(counts.removed_pieces, FillController::tr("%Ln loose fragments removed", nullptr, n(counts.removed_pieces)));
  return done;
}

QString bodies_left(const UnionCounts& united) {
  QStringList left;
  const auto n = [](std::size_t count) { return static_cast<int>(count); };
  if (united.open_pieces > 0)
    left << FillController::tr(
        "%Ln open component(s) crossing, holding or within others were left: fill the holes, then unite.", nullptr,
        n(united.open_pieces));
  if (united.crossing > 0)
    left << FillController::tr(
        "%Ln bodies crossing themselves were left: cut out faces that intersect others, fill the holes, then unite.",
        nullptr, n(united.crossing));
  if (united.touching > 0)
    left << FillController::tr("%Ln pair(s) of bodies touching at points or edges alone stay apart.", nullptr,
                               n(united.touching));
  if (united.refused > 0)
    left << FillController::tr("%Ln pair(s) of overlapping bodies have no union and were left: move or part them.",
                               nullptr, n(united.refused));
  if (united.crossing_parts > 0)
    left << FillController::tr("%Ln pair(s) of new faces cross by the rounding of their corners; the body is closed.",
                               nullptr, n(united.crossing_parts));
  return left.join(QLatin1Char(' '));
}

QString nothing_to_repair(ScanRepair what) {
  switch (what) {
    case ScanRepair::trim:
      return FillController::tr(
          "There are no bad triangles at these boundaries. A right click on the hole offers to erase a ring of faces.");
    case ScanRepair::trim_crossing: return FillController::tr("No edge of these boundaries runs through the surface.");
    case ScanRepair::stitch: return FillController::tr("No boundaries lie close enough together to be stitched.");
    case ScanRepair::prepare: return FillController::tr("Nothing stands in the way of filling this scan.");
    case ScanRepair::repair: return FillController::tr("There is nothing to repair.");
    case ScanRepair::part: return FillController::tr("No vertex was found at which the boundary could be parted.");
    case ScanRepair::bridge:
    case ScanRepair::base:
    case ScanRepair::plane_cut:
    case ScanRepair::turn_around:
    case ScanRepair::erase: break;
  }
  return {};
}

QString repair_title(ScanRepair what) {
  switch (what) {
    case ScanRepair::trim: return FillController::tr("Trimming boundaries");
    case ScanRepair::trim_crossing: return FillController::tr("Trimming crossing triangles");
    case ScanRepair::stitch: return FillController::tr("Stitching boundaries");
    case ScanRepair::prepare: return FillController::tr("Preparing the scan");
    case ScanRepair::repair: return FillController::tr("Repairing the scan");
    case ScanRepair::bridge: return FillController::tr("Bridging a hole");
    case ScanRepair::erase: return FillController::tr("Erasing a region");
    case ScanRepair::base: return FillController::tr("Building a base");
    case ScanRepair::plane_cut: return FillController::tr("Cutting by a plane");
    case ScanRepair::part: return FillController::tr("Parting a boundary");
    case ScanRepair::turn_around: return FillController::tr("Turning the scan around");
  }
  return {};
}

}  // namespace loopmend
