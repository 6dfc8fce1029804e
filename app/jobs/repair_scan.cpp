// SPDX-License-Identifier: GPL-3.0-or-later
#include "jobs/repair_scan.h"

#include "document/labels.h"
#include "document/laid_points.h"
#include "jobs/change_surface.h"
#include "jobs/defect_places.h"
#include "jobs/fill_controller.h"
#include "jobs/repair_words.h"
#include "neighborhood/trim_boundary.h"
#include "pipeline/append_colored_patch.h"
#include "pipeline/hand_bridge.h"
#include "pipeline/join_tiles.h"
#include "pipeline/scan_job.h"
#include "pipeline/tile_outlines.h"
#include "repair/base.h"
#include "repair/inverted_shells.h"
#include "repair/repair_surface.h"
#include "repair/stitch_boundaries.h"

#include <algorithm>
#include <iterator>
#include <set>
#include <utility>

namespace loopmend {

namespace {

std::optional<RepairedScan> trimmed(const ScanRepairTask& task) {
  constexpr int rounds = 3;
  const OpenedScan& old = *task.opened;
  TrimmedModel result = trim_boundary(*old.model, task.loops, rounds);
  if (result.removed.empty()) return std::nullopt;
  const QString words =
      FillController::tr("%1: %L2 bad triangles were removed at the boundaries; Ctrl+Z brings them back.")
          .arg(old.name)
          .arg(result.removed.size());
  RepairedScan repaired{task.scan, made_scan(std::move(result.model.soup), old.name, old.origin),
                        FillController::tr("Trim the boundaries of %1").arg(old.name), words, NewPoints{}};
  for (const BadBoundaryFace& bad : result.removed) repaired.changed_faces.push_back(bad.face);
  repaired.proposal = FillController::tr("%1: %Ln bad triangle(s) would be removed at the boundaries.", nullptr,
                                         static_cast<int>(result.removed.size()))
                          .arg(old.name);
  return repaired;
}

std::optional<RepairedScan> trimmed_where_it_crosses(const ScanRepairTask& task) {
  const OpenedScan& old = *task.opened;
  TrimmedModel result = trim_pierced(*old.model, task.loops);
  if (result.removed.empty()) return std::nullopt;
  const int count = static_cast<int>(result.removed.size());
  RepairedScan repaired{task.scan, made_scan(std::move(result.model.soup), old.name, old.origin),
                        FillController::tr("Trim crossing triangles of %1").arg(old.name),
                        FillController::tr("%1: %Ln triangle(s) were removed where a boundary ran through the surface; "
                                           "Ctrl+Z brings them back.",
                                           nullptr, count)
                            .arg(old.name),
                        NewPoints{}};
  for (const BadBoundaryFace& bad : result.removed) repaired.changed_faces.push_back(bad.face);
  repaired.proposal =
      FillController::tr("%1: %Ln triangle(s) would be removed where a boundary runs through the surface.", nullptr,
                         count)
          .arg(old.name);
  return repaired;
}

/// Faces along the boundary edges that would close, and those that would have other corners.
std::vector<int> faces_at_stitches(const SurfaceModel& model, const NearBoundaries& found,
                                   const StitchedSurface& stitched) {
  const bool all_in_place = stitched.removed_faces == 0;
  std::vector<int> faces = all_in_place ? std::vector<int>() : changed_faces(model.soup, stitched.soup);
  for (std::size_t f = 0; f < model.soup.triangles.size(); ++f) {
    const Triangle& t = model.soup.triangles[f];
    bool changes = false;
    for (std::size_t k = 0; k < 3; ++k)
      changes = changes || found.closing.contains({t[k], t[(k + 1) % 3]}) ||
                (all_in_place && model.soup.points[t[k]] != stitched.soup.points[stitched.soup.triangles[f][k]]);
    if (changes) faces.push_back(static_cast<int>(f));
  }
  return faces;
}

void keep_laid_points(const OpenedScan& before, OpenedScan& after) {
  after.laid = with_laid_points(before.laid, before.model->soup.points, after.model->soup.points);
}

/// @param distance  within which the tiles lie over each other
RepairedScan with_joined_tiles(const ScanRepairTask& task, double distance) {
  const OpenedScan& old = *task.opened;
  SurfaceModel model = *old.model;
  const JoinedTiles joined =
      join_tiles(model, distance, [&](TriangleSoup soup) { model = make_surface_model(std::move(soup)); });
  const QString faces = labels::count(joined.removed_faces), strips = labels::count(joined.bridges);
  RepairedScan repaired{task.scan, nullptr, FillController::tr("Join the tiles of %1").arg(old.name),
                        FillController::tr("%1: %2 faces that lay on a larger tile were removed, and %3 strips laid "
                                           "across the gaps; Ctrl+Z takes it back.")
                            .arg(old.name, faces, strips)};
  repaired.proposal = FillController::tr(
                          "%1: tiles overlap. %2 faces that lie on a larger tile would be removed, and "
                          "%3 strips laid across the gaps.")
                          .arg(old.name, faces, strips);
  repaired.changed_faces = changed_faces(old.model->soup, model.soup);
  repaired.made = made_scan(std::move(model.soup), old.name, old.origin);
  keep_laid_points(old, *repaired.made);
  return repaired;
}

/// Tiles that overlap are joined first, since stitching cannot.
std::optional<RepairedScan> stitched(const ScanRepairTask& task) {
  const OpenedScan& old = *task.opened;
  const OverlappingOutlines tiles = find_overlapping_outlines(*old.model, find_boundary_loops(*old.model));
  if (tiles.count > 0) return with_joined_tiles(task, tiles.distance);
  StitchedSurface result = stitch_boundaries(*old.model);
  if (result.joined_vertices + result.split_faces == 0) return std::nullopt;
  const QString words =
      FillController::tr("%1: %2 vertices were joined to others, %3 faces split; Ctrl+Z takes it back.")
          .arg(old.name)
          .arg(result.joined_vertices)
          .arg(result.split_faces);
  RepairedScan repaired{task.scan, nullptr, FillController::tr("Stitch %1").arg(old.name), words};
  const NearBoundaries found = near_boundaries(*old.model);
  repaired.changed_faces = faces_at_stitches(*old.model, found, result);
  repaired.proposal = FillController::tr(
                          "%1: %2 vertices would be joined to others and %3 faces split; %4 boundary edges "
                          "would close.")
                          .arg(old.name, labels::count(result.joined_vertices), labels::count(result.split_faces),
                               labels::count(found.closing.size()));
  repaired.made = made_scan(std::move(result.soup), old.name, old.origin);
  return repaired;
}

QString sentence_of(const OpenedScan& scan, const QStringList& done) {
  return FillController::tr("%1: %2. Ctrl+Z takes it back.").arg(scan.name, done.join(QStringLiteral(", ")));
}

std::optional<RepairedScan> repaired(const ScanRepairTask& task) {
  const OpenedScan& old = *task.opened;
  RepairedSurface result = repair_surface(as_read(*old.model), task.defects, task.cancel, task.on_step);
  const QString left = bodies_left(result.counts.united);
  if (!result.counts.any()) {
    if (left.isEmpty()) return std::nullopt;
    return RepairedScan{task.scan, nullptr, {}, left};
  }
  QString words = sentence_of(old, list_of(result.counts));
  if (!left.isEmpty()) words += QLatin1Char(' ') + left;
  if (task.on_step) task.on_step({RepairStage::measure_result, 0, 0, result.counts});
  return RepairedScan{task.scan, made_scan(std::move(result.soup), old.name, old.origin),
                      FillController::tr("Repair %1").arg(old.name), words};
}

/// What `fill --auto` does before it fills.
std::optional<RepairedScan> prepared(const ScanRepairTask& task) {
  const OpenedScan& old = *task.opened;
  ScanJob job;
  job.prepare.extent = PrepareOptions::Extent::where_needed;
  job.numbering = ScanJob::Numbering::of_prepared;
  ScanPlan plan = plan_scan(record_of(as_read(*old.model)), *old.model, job, task.cancel, task.on_step);
  if (task.cancel.cancelled()) return std::nullopt;
  QStringList done;
  const auto n = [](std::size_t count) { return static_cast<int>(count); };
  if (plan.done.no_data_faces)
    done << FillController::tr("%Ln faces removed at vertices of missing data", nullptr, n(*plan.done.no_data_faces));
  const std::size_t joined = (plan.done.stitched ? plan.done.stitched->joined_vertices : 0) + plan.done.joined_again;
  if (joined > 0) done << FillController::tr("%Ln vertices joined", nullptr, n(joined));
  if (plan.done.stitched && plan.done.stitched->split_faces > 0)
    done << FillController::tr("%Ln faces split", nullptr, n(plan.done.stitched->split_faces));
  if (plan.done.repaired) done << list_of(*plan.done.repaired);
  if (!plan.trimmed.empty())
    done << FillController::tr("%Ln crossing triangles removed", nullptr, n(plan.trimmed.size()));
  if (done.isEmpty()) return std::nullopt;
  if (task.on_step) task.on_step({RepairStage::measure_result});
  RepairedScan result{task.scan, nullptr, FillController::tr("Prepare %1").arg(old.name), sentence_of(old, done)};
  result.proposal = FillController::tr("%1 would be prepared: %2.").arg(old.name, done.join(QStringLiteral(", ")));
  result.changed_faces = changed_faces(old.model->soup, plan.model.soup);
  result.made = made_scan(std::move(plan.model.soup), old.name, old.origin);
  return result;
}

RepairedScan bridged(const ScanRepairTask& task) {
  const OpenedScan& old = *task.opened;
  const BridgeStrip bridge = BridgeMaker(*old.model).strip(task.bridge_ends[0], task.bridge_ends[1]);
  TriangleSoup soup = old.model->soup;
  append(soup, bridge, soup.points.size());
  const QString words =
      FillController::tr("%1: a bridge was laid between the vertices %2 and %3; Ctrl+Z takes it back.")
          .arg(old.name)
          .arg(bridge.from)
          .arg(bridge.to);
  const bool fills = task.part_to_fill >= 0;
  RepairedScan result{
      task.scan, made_scan(std::move(soup), old.name, old.origin),
      (fills ? FillController::tr("Fill a part of a hole of %1") : FillController::tr("Bridge a hole of %1"))
          .arg(old.name),
      words, NewPoints{}};
  for (std::size_t l = 0; fills && l < result.made->loops.size(); ++l) {
    const std::vector<int>& vertices = result.made->loops[l].vertices;
    if (std::any_of(vertices.begin(), vertices.end(),
                    [&](int v) { return result.made->model->soup_vertex[v] == task.part_to_fill; }))
      result.to_fill.push_back(static_cast<int>(l));
  }
  return result;
}

RepairedScan based(const ScanRepairTask& task) {
  const OpenedScan& old = *task.opened;
  const BoundaryLoop& loop = task.loops.front();
  return {task.scan, made_scan(with_base(*old.model, loop, task.base_distance), old.name, old.origin),
          FillController::tr("Base of %1").arg(old.name),
          FillController::tr("%1: a base closes hole %2; Ctrl+Z takes it back.").arg(old.name).arg(loop.number),
          NewPoints{}};
}

/// With its patches, which are cut with it.
RepairedScan cut_off(const ScanRepairTask& task) {
  const OpenedScan& old = *task.opened;
  SurfaceModel base = *old.model;
  for (const OpenPatch& open : task.patches) append_colored_patch(base, patch_geometry(open.state->patch));
  CutSurface cut = cut_by_plane(base.soup, task.cut_plane);
  const auto n = [](std::size_t count) { return static_cast<int>(count); };
  QStringList done{FillController::tr("%Ln face(s) cut off", nullptr, n(cut.counts.removed_faces)),
                   FillController::tr("%Ln face(s) divided", nullptr, n(cut.counts.divided_faces))};
  if (cut.counts.new_faces > 0)
    done << FillController::tr("section closed by %Ln face(s)", nullptr, n(cut.counts.new_faces));
  if (cut.counts.left_open > 0)
    done << FillController::tr("%Ln curve(s) of it left open", nullptr, n(cut.counts.left_open));
  RepairedScan result{task.scan, made_scan(std::move(cut.soup), old.name, old.origin),
                      FillController::tr("Plane cut of %1").arg(old.name), sentence_of(old, done)};
  result.joined_patches = static_cast<int>(task.patches.size());
  return result;
}

/// Whether something is erased within a patch, or in the two rings around it: then its boundary is another.
bool is_touched(const Patch& patch, const OpenedScan& scan, int first_point, const std::vector<char>& erased) {
  for (int i = 0; i < patch.vertex_count(); ++i) {
    const auto at = static_cast<std::size_t>(i);
    if (patch.ring[at] > 2) continue;
    const int point = i < patch.free_count ? first_point + i : scan.model->soup_vertex[patch.view_vertex[at]];
    if (erased[point]) return true;
  }
  return false;
}

/// What was painted, or all along the boundaries of the loops; ascending.
std::vector<int> points_to_erase(const ScanRepairTask& task) {
  if (!task.erased.empty()) return task.erased;
  std::set<int> points;
  for (const BoundaryLoop& loop : task.loops)
    for (int v : loop.vertices) points.insert(task.opened->model->soup_vertex[v]);
  return {points.begin(), points.end()};
}

/// Patches that lose faces, or have some beside them, become a part of the scan; the others are carried over.
std::optional<RepairedScan> erased(const ScanRepairTask& task) {
  const OpenedScan& old = *task.opened;
  const std::vector<int> wanted = points_to_erase(task);
  if (wanted.empty()) return std::nullopt;
  const int own = static_cast<int>(old.model->soup.points.size());
  std::size_t all = static_cast<std::size_t>(own);
  for (const OpenPatch& open : task.patches) all += static_cast<std::size_t>(open.state->patch.free_count);
  std::vector<char> chosen(std::max(all, static_cast<std::size_t>(wanted.back()) + 1), 0);
  for (int p : wanted) chosen[p] = 1;
  std::vector<int> points;
  std::copy_if(wanted.begin(), wanted.end(), std::back_inserter(points), [own](int p) { return p < own; });
  SurfaceModel base = *old.model;
  int first_point = own, joined = 0;
  for (const OpenPatch& open : task.patches) {
    const Patch& patch = open.state->patch;
    if (is_touched(patch, old, first_point, chosen)) {
      const int first_joined = static_cast<int>(base.soup.points.size());
      append_colored_patch(base, patch_geometry(patch));
      for (int i = 0; i < patch.free_count; ++i)
        if (chosen[first_point + i]) points.push_back(first_joined + i);
      ++joined;
    }
    first_point += patch.free_count;
  }
  ChangedSurface changed = without_faces_at(base.soup, points);
  const QString title = task.erased.empty() ? FillController::tr("Erase a ring of faces of %1")
                                            : FillController::tr("Erase a region of %1");
  RepairedScan result{task.scan, made_scan(std::move(changed.soup), old.name, old.origin), title.arg(old.name),
                      FillController::tr("%1: %Ln face(s) were erased; Ctrl+Z brings them back.", nullptr,
                                         static_cast<int>(changed.changes))
                          .arg(old.name),
                      changed.new_points};
  result.joined_patches = joined;
  result.to_fill = loops_opened(base, *result.made, changed.new_points);
  return result;
}

std::optional<RepairedScan> parted(const ScanRepairTask& task) {
  const OpenedScan& old = *task.opened;
  ChangedSurface changed = parted_at_touches(*old.model, task.loops);
  if (changed.changes == 0) return std::nullopt;
  return RepairedScan{task.scan, made_scan(std::move(changed.soup), old.name, old.origin),
                      FillController::tr("Part a boundary of %1").arg(old.name),
                      FillController::tr("%1: the boundary was parted at %Ln vertices; Ctrl+Z takes it back.", nullptr,
                                         static_cast<int>(changed.changes))
                          .arg(old.name),
                      NewPoints{}};
}

/// What looks inward; where nothing does, everything, as `fill --turn-around` does.
RepairedScan turned_around(const ScanRepairTask& task) {
  const OpenedScan& old = *task.opened;
  const std::vector<char> inside_out = faces_inside_out(*old.model, old.loops);
  TriangleSoup soup = as_read(*old.model);
  int count = 0;
  for (std::size_t f = 0; f < soup.triangles.size(); ++f) {
    if (!inside_out.empty() && !inside_out[f]) continue;
    std::swap(soup.triangles[f][1], soup.triangles[f][2]);
    ++count;
  }
  return {
      task.scan, made_scan(std::move(soup), old.name, old.origin), FillController::tr("Turn %1 around").arg(old.name),
      FillController::tr("%1: %Ln face(s) were turned around; Ctrl+Z takes it back.", nullptr, count).arg(old.name)};
}

std::size_t count_loops(const OpenedScan& scan) {
  return static_cast<std::size_t>(
      std::count_if(scan.loops.begin(), scan.loops.end(), [](const auto& loop) { return loop.kind != LoopKind::cut; }));
}

/// How much of the scan is left, and how open it is.
QString sizes_in_words(const OpenedScan& before, const RepairedScan& after) {
  const std::size_t had = before.model->soup.triangles.size(), has = after.made->model->soup.triangles.size();
  QString words = FillController::tr("Boundary loops: %L1, before %L2.").arg(after.loops).arg(after.loops_before);
  if (has < had)
    words += QLatin1Char(' ') + FillController::tr("%Ln triangle(s) fewer.", nullptr, static_cast<int>(had - has));
  return words;
}

}  // namespace

std::optional<RepairedScan> repaired_scan(ScanRepair what, const ScanRepairTask& task) {
  std::optional<RepairedScan> result;
  switch (what) {
    case ScanRepair::trim: result = trimmed(task); break;
    case ScanRepair::trim_crossing: result = trimmed_where_it_crosses(task); break;
    case ScanRepair::stitch: result = stitched(task); break;
    case ScanRepair::prepare: result = prepared(task); break;
    case ScanRepair::repair: result = repaired(task); break;
    case ScanRepair::bridge: result = bridged(task); break;
    case ScanRepair::erase: result = erased(task); break;
    case ScanRepair::base: result = based(task); break;
    case ScanRepair::plane_cut: result = cut_off(task); break;
    case ScanRepair::part: result = parted(task); break;
    case ScanRepair::turn_around: result = turned_around(task); break;
  }
  if (!result || !result->made) return result;
  result->made->repaired_from = task.opened->from == ScanOrigin::file ? task.opened->path : task.opened->repaired_from;
  if (what == ScanRepair::bridge || what == ScanRepair::erase || what == ScanRepair::base ||
      what == ScanRepair::plane_cut)
    keep_laid_points(*task.opened, *result->made);
  else if (result->made->laid.empty())
    result->made->laid = task.opened->laid;
  result->loops_before = count_loops(*task.opened);
  result->loops = count_loops(*result->made);
  if (what == ScanRepair::repair || what == ScanRepair::prepare || what == ScanRepair::stitch)
    result->words += QLatin1Char(' ') + sizes_in_words(*task.opened, *result);
  if (result->new_points)
    result->carried = carried_patches(task.patches, task.first_loop, *task.opened, *result->made, *result->new_points);
  result->lost_patches = static_cast<int>(task.patches.size() - result->carried.size()) - result->joined_patches;
  std::vector<int>& faces = result->changed_faces;
  std::sort(faces.begin(), faces.end());
  faces.erase(std::unique(faces.begin(), faces.end()), faces.end());
  return result;
}

}  // namespace loopmend
