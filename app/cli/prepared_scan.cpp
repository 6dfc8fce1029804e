// SPDX-License-Identifier: GPL-3.0-or-later
#include "prepared_scan.h"

#include "open_model.h"

#include "filling/bridge_loops.h"
#include "mesh/rounding_cracks.h"
#include "neighborhood/trim_boundary.h"
#include "pipeline/filling_view.h"
#include "pipeline/hand_bridge.h"
#include "pipeline/paste.h"
#include "repair/base.h"

#include <algorithm>
#include <limits>
#include <map>
#include <numeric>
#include <optional>
#include <set>
#include <string>
#include <utility>

namespace loopmend {

namespace {

bool trims(const FillCommand& command) {
  return command.trim_rounds > 0 || command.trim_pierced == FillCommand::TrimPierced::yes;
}

/// @param a, b  vertices of the mesh as it was read.
TriangleSoup bridged(const SurfaceModel& model, int a, int b) {
  const std::string name = "bridge (" + std::to_string(a) + ", " + std::to_string(b) + "): ";
  const int count = static_cast<int>(model.soup.points.size());
  if (a < 0 || b < 0 || a >= count || b >= count)
    throw InvalidArgument(name + "the mesh has " + std::to_string(count) + " vertices, numbered from 0");
  try {
    return with_bridge(model, a, b);
  } catch (const InvalidArgument& error) {
    throw InvalidArgument(name + error.what());
  }
}

bool has_cuts(const SurfaceModel& model) {
  const std::vector<BoundaryLoop> loops = find_boundary_loops(model);
  return std::any_of(loops.begin(), loops.end(), [](const BoundaryLoop& loop) { return loop.kind == LoopKind::cut; });
}

bool has_sides_to_join(const SurfaceModel& model) {
  const std::vector<BoundaryLoop> loops = find_boundary_loops(model);
  return std::any_of(loops.begin(), loops.end(), [](const BoundaryLoop& loop) { return loop.coincident > 0; }) ||
         !near_boundaries(model).closing.empty();
}

struct OpenEdges {
  int all = 0, cut = 0;
};

OpenEdges open_edges(const std::vector<BoundaryLoop>& loops) {
  OpenEdges open;
  for (const BoundaryLoop& loop : loops) {
    open.all += loop.edges();
    if (loop.kind == LoopKind::cut) open.cut += loop.edges();
  }
  return open;
}

struct JoinedAgain {
  TriangleSoup soup;
  std::size_t vertices = 0;
};

/// Stitches what repair has parted. Where that makes edges of more than two faces, only vertices that lie on each other at cracks are
/// joined. Empty unless the surface then has fewer open edges, and no more of them at edges of more than two faces.
std::optional<JoinedAgain> joined_again(const SurfaceModel& model, const StitchTolerance& tolerance) {
  const OpenEdges before = open_edges(find_boundary_loops(model));
  const auto gains = [&](const JoinedAgain& joined) {
    if (joined.vertices == 0) return false;
    const OpenEdges after = open_edges(find_boundary_loops(make_surface_model(joined.soup)));
    return after.all < before.all && after.cut <= before.cut;
  };
  StitchedSurface stitched = stitch_boundaries(model, tolerance);
  JoinedAgain joined{std::move(stitched.soup), stitched.joined_vertices};
  if (gains(joined)) return joined;
  joined.soup = model.soup;
  const VertexSurvey survey = survey_vertices(joined.soup.triangles, joined.soup.points.size());
  joined.vertices = join_rounding_cracks(joined.soup, survey).vertices;
  if (gains(joined)) return joined;
  return std::nullopt;
}

/// @returns how many.
std::size_t remove_faces_at(const std::vector<int>& vertices, TriangleSoup& soup) {
  std::vector<char> is_marked(soup.points.size(), 0);
  for (int v : vertices) is_marked[static_cast<std::size_t>(v)] = 1;
  std::vector<int> points(soup.points.size()), rows;
  std::iota(points.begin(), points.end(), 0);
  Triangles kept;
  for (std::size_t f = 0; f < soup.triangles.size(); ++f) {
    const Triangle& t = soup.triangles[f];
    if (std::any_of(t.begin(), t.end(), [&](int v) { return is_marked[static_cast<std::size_t>(v)] != 0; })) continue;
    kept.push_back(t);
    rows.push_back(static_cast<int>(f));
  }
  const TriangleSoup given = soup;
  soup.triangles = std::move(kept);
  copy_rows(given, points, rows, soup);
  return given.triangles.size() - soup.triangles.size();
}

/// @throws UsageError where there is no such loop.
template <class Replace>
void build_base(PreparedScan& scan, const FillCommand::Base& base, const Replace& replace) {
  const std::vector<BoundaryLoop> loops = find_boundary_loops(scan.model);
  const std::size_t place = base.loop == 0 ? 0 : static_cast<std::size_t>(base.loop) - 1;
  if (place >= loops.size())
    throw UsageError("--base: there is no loop " + std::to_string(place + 1) + "; 'loopmend info' lists the loops");
  TriangleSoup soup = with_base(scan.model, loops[place], base.distance);
  scan.done.base_loop = loops[place].number;
  replace(std::move(soup));
}

/// @param command  what is done is added to it where the mesh needs it and the command leaves that open.
void prepare(PreparedScan& scan, FillCommand& command, const CancelToken& cancel) {
  const bool where_needed = command.prepare == FillCommand::Prepare::where_needed;
  scan.done.before = scan.model.repairs;
  const auto replace = [&](TriangleSoup soup) {
    scan.done.turned_faces += scan.model.repairs.reoriented_faces;
    scan.given = record_of(soup);
    scan.model = command.input.empty() ? make_surface_model(std::move(soup)) : model_of(command.input, std::move(soup));
  };
  scan.done.no_data = find_no_data(scan.model.soup.points);
  if (command.no_data == FillCommand::NoData::cut && !scan.done.no_data.vertices.empty()) {
    TriangleSoup soup = as_read(scan.model);
    scan.done.no_data_faces = remove_faces_at(scan.done.no_data.vertices, soup);
    replace(std::move(soup));
  }
  if (where_needed && has_sides_to_join(scan.model)) command.stitch = FillCommand::Stitch::yes;
  if (command.stitch == FillCommand::Stitch::yes) {
    scan.done.stitched = stitch_boundaries(scan.model, command.stitch_tolerance);
    replace(std::move(scan.done.stitched->soup));
    if (where_needed && !scan.done.stitched->any()) scan.done.stitched.reset();
  }
  if (where_needed && has_cuts(scan.model)) command.repair.insert(harmless_repairs.begin(), harmless_repairs.end());
  if (!command.repair.empty()) {
    RepairedSurface repaired = repair_surface(as_read(scan.model), command.repair, cancel);
    scan.done.repaired = repaired.counts;
    replace(std::move(repaired.soup));
    if ((where_needed && has_sides_to_join(scan.model)) || command.stitch == FillCommand::Stitch::yes)
      if (std::optional<JoinedAgain> joined = joined_again(scan.model, command.stitch_tolerance)) {
        scan.done.joined_again = joined->vertices;
        replace(std::move(joined->soup));
      }
  }
  for (const auto& [a, b] : command.bridges) {
    replace(bridged(scan.model, a, b));
    ++scan.done.bridges;
  }
  if (command.base) build_base(scan, *command.base, replace);
  if (!where_needed) return;
  command.stitch = FillCommand::Stitch::yes;  // what it can join is joined
  command.repair.insert(harmless_repairs.begin(), harmless_repairs.end());
  command.trim_pierced = FillCommand::TrimPierced::yes;
}

/// Choices among the loops of a trimmed scan: what grew out of those chosen before. The boundary of a crumb that only touches one of
/// these is not chosen for that.
std::vector<LoopChoice> choices_after_trim(const std::vector<BoundaryLoop>& loops, const PreparedScan& before,
                                           const std::vector<BoundaryLoop>& grown, const FillCommand& command) {
  const std::vector<BoundaryLoop> chosen = before.chosen();
  const auto nearest = [&](const BoundaryLoop& loop) {  // the shape of the loop that this one grew out of
    std::pair<double, std::optional<SeamContinuity>> best{std::numeric_limits<double>::infinity(), std::nullopt};
    for (std::size_t k = 0; k < before.loops.size(); ++k) {
      const double distance = (before.loops[k].center - loop.center).norm();
      if (before.choices[k].fill && distance < best.first) best = {distance, before.choices[k].continuity};
    }
    return best.second;
  };
  const bool named = command.loops != "all" || command.at_vertices;
  const bool outer_rims = std::any_of(chosen.begin(), chosen.end(),
                                      [](const BoundaryLoop& loop) { return loop.kind == LoopKind::outer_rim; });
  std::vector<LoopChoice> choices(loops.size());
  for (std::size_t k = 0; k < loops.size(); ++k) {
    const bool can_be_filled = loops[k].kind == LoopKind::hole || (outer_rims && loops[k].kind == LoopKind::outer_rim);
    choices[k].fill = can_be_filled && std::any_of(grown.begin(), grown.end(), [&](const BoundaryLoop& loop) {
                        return loop.number == loops[k].number;
                      });
    if (choices[k].fill) {
      choices[k].continuity = nearest(loops[k]);
      continue;
    }
    if (!named) choices[k] = choose_unnamed(loops[k], command);
    if (std::exchange(choices[k].fill, false) || named) choices[k].why_not = "not selected";
  }
  return choices;
}

/// Trims the boundaries of the loops that are to be filled, and chooses anew: what grew out of them.
void trim(PreparedScan& scan, const FillCommand& command) {
  const std::vector<BoundaryLoop> chosen = scan.chosen();
  TrimmedModel trimmed = command.trim_rounds > 0 ? trim_boundary(scan.model, chosen, command.trim_rounds)
                                                 : trim_pierced(scan.model, chosen);
  scan.trimmed = std::move(trimmed.removed);
  scan.to_trim = trimmed.loops;
  scan.spared_pieces = trimmed.spared;
  if (scan.trimmed.empty()) return;
  TriangleSoup given = as_read(std::move(scan.model));
  std::vector<char> gone(given.triangles.size(), 0);
  for (const BadBoundaryFace& bad : scan.trimmed) gone[static_cast<std::size_t>(bad.face)] = 1;
  Triangles left;
  for (std::size_t f = 0; f < gone.size(); ++f)
    if (!gone[f]) left.push_back(given.triangles[f]);
  given.triangles = std::move(left);
  scan.given = record_of(given);
  std::vector<int>& turned = trimmed.model.turned_faces;
  turned.clear();
  for (std::size_t f = 0; f < given.triangles.size(); ++f)
    if (trimmed.model.soup.triangles[f] != given.triangles[f]) turned.push_back(static_cast<int>(f));
  trimmed.model.repairs.reoriented_faces = turned.size();
  scan.model = std::move(trimmed.model);
  std::vector<BoundaryLoop> loops = find_boundary_loops(scan.model);
  scan.choices = choices_after_trim(loops, scan, trimmed.loops, command);
  scan.loops = std::move(loops);
}

/// How near the sides of a hole must be for it to be a crack. In the shared scans no hole comes near to that; a slit in a dummy's
/// head, which is filled, has 0.03. Those of an outer rim may be as far apart as stitching joins them: nothing is filled there.
constexpr double crack_in_edges = 0.01;

/// Loops that nobody named, more than half of whose edges --stitch would close, are no holes: a patch between sides that nearly
/// touch would cross them.
void leave_wide_cracks(PreparedScan& scan, const FillCommand& command) {
  const bool named = command.loops != "all" || command.at_vertices;
  if (scan.loops.empty() || command.stitch == FillCommand::Stitch::yes) return;
  scan.near = near_boundaries(scan.model);
  if (scan.near.closing.empty() || named) return;
  const NearBoundaries nearest = near_boundaries(scan.model, {crack_in_edges, std::nullopt});
  for (std::size_t k = 0; k < scan.loops.size(); ++k) {
    const BoundaryLoop& loop = scan.loops[k];
    LoopChoice& choice = scan.choices[k];
    const bool is_rim = loop.kind == LoopKind::outer_rim;
    if (choice.left != LoopChoice::Left::as_asked || (!choice.fill && !is_rim)) continue;
    const int closing = closing_edges(scan.model, loop, is_rim ? scan.near : nearest);
    if (2 * closing <= loop.edges()) continue;
    choice.fill = false;
    choice.left = LoopChoice::Left::wide_crack;
    choice.why_not = "crack: " + std::to_string(closing) + " of its " + std::to_string(loop.edges()) +
                     " edges lie beside another within a tenth of their length (--stitch joins them)";
  }
}

/// Names what closes a loop that is no hole, or makes one of it; nothing that was done already, or that would join nothing.
/// @param command  with what was done
void name_cures(PreparedScan& scan, const FillCommand& command) {
  for (std::size_t k = 0; k < scan.loops.size(); ++k) {
    LoopChoice& choice = scan.choices[k];
    if (choice.cure == LoopChoice::Cure::repair && !command.repair.empty()) choice.cure = LoopChoice::Cure::none;
    if (choice.cure == LoopChoice::Cure::stitch && closing_edges(scan.model, scan.loops[k], scan.near) == 0)
      choice.cure = LoopChoice::Cure::none;
    switch (choice.cure) {
      case LoopChoice::Cure::none: break;
      case LoopChoice::Cure::stitch: choice.why_not += " (--stitch joins them)"; break;
      case LoopChoice::Cure::repair: choice.why_not += " (--repair makes a hole of it, or nothing)"; break;
    }
  }
}

/// The loops to be filled by the shape that was named for them; first those without.
std::map<std::optional<SeamContinuity>, std::vector<BoundaryLoop>> loops_of_each_shape(const PreparedScan& scan) {
  std::map<std::optional<SeamContinuity>, std::vector<BoundaryLoop>> loops;
  for (std::size_t k = 0; k < scan.loops.size(); ++k)
    if (scan.choices[k].fill) loops[scan.choices[k].continuity].push_back(scan.loops[k]);
  return loops;
}

/// @throws UsageError where a shape is named that the flow does not know.
void check_shapes(const PreparedScan& scan, const FillCommand& command) {
  const bool named = std::any_of(scan.choices.begin(), scan.choices.end(),
                                 [](const LoopChoice& choice) { return choice.continuity.has_value(); });
  const std::optional<EvolutionOptions>& flow = command.fill.evolution;
  if (named && !(flow && flow->flow == FlowKind::mmcvf && flow->mode == EvolutionMode::steady))
    throw UsageError("--loops takes flat, tangent and smooth only with --flow mmcvf and --mode steady, the defaults");
}

/// Pairs of loops at which one wall ends. Only where 'blend' would find the same loops in the file.
std::vector<std::pair<int, int>> rings_of(const PreparedScan& scan, const FillCommand& command,
                                          const CancelToken& cancel) {
  const bool is_as_read = !scan.done.stitched && scan.done.no_data_faces == 0 && !scan.done.repaired &&
                          scan.done.bridges == 0 && scan.done.base_loop == 0 && scan.trimmed.empty() &&
                          command.coincident == CoincidentVertices::keep;
  if (!is_as_read) return {};
  return find_rings(scan.model, scan.loops, cancel);
}

/// A patch over each loop alone leaves the wall hollow, or goes through it.
void name_rings(const PreparedScan& scan, std::vector<HoleResult>& results) {
  for (const auto& [i, j] : scan.rings)
    for (const auto& [own, other] : {std::pair(i, j), std::pair(j, i)}) {
      std::string& message = results[static_cast<std::size_t>(own)].message;
      if (!message.empty()) message += "; ";
      message += "a wall ends at this loop and at loop " + std::to_string(other + 1) +
                 ": 'loopmend blend --loops 1:" + std::to_string(std::min(i, j) + 1) +
                 ",1:" + std::to_string(std::max(i, j) + 1) + "' joins them by a ring";
    }
}

}  // namespace

std::vector<BoundaryLoop> PreparedScan::chosen() const {
  std::vector<BoundaryLoop> result;
  for (std::size_t k = 0; k < loops.size(); ++k)
    if (choices[k].fill) result.push_back(loops[k]);
  return result;
}

bool needs_whole_view(const FillCommand& command) {
  return command.prepare == FillCommand::Prepare::where_needed || command.stitch == FillCommand::Stitch::yes ||
         command.no_data == FillCommand::NoData::cut || !command.repair.empty() || !command.bridges.empty() ||
         command.base || trims(command);
}

PreparedScan prepare_scan(SoupRecord as_read, SurfaceModel model, const FillCommand& asked, const CancelToken& cancel) {
  FillCommand command = asked;
  PreparedScan scan;
  scan.given = std::move(as_read);
  scan.model = std::move(model);
  prepare(scan, command, cancel);
  scan.loops = find_boundary_loops(scan.model);
  scan.choices = choose_loops(scan.model, scan.loops, command);
  if (widen_filling_view(scan.model, scan.loops, scan.chosen())) {  // the same loops, of other view vertices
    scan.loops = find_boundary_loops(scan.model);
    scan.choices = choose_loops(scan.model, scan.loops, command);
  }
  check_shapes(scan, command);
  leave_wide_cracks(scan, command);
  scan.to_trim = scan.chosen();
  if (trims(command)) trim(scan, command);
  name_cures(scan, command);
  scan.rings = rings_of(scan, command, cancel);
  scan.trimmable = few_of_their_pieces(scan.model, bad_boundary_faces(scan.model, scan.to_trim));
  return scan;
}

std::vector<HoleResult> fill_chosen(PreparedScan& scan, const FillCommand& command, const Deadline& deadline,
                                    const OnFillProgress& progress, const CancelToken& cancel) {
  FillOptions options = command.fill;
  options.on_cancel = FillOptions::OnCancel::keep_finished;  // where nothing is to be kept, nobody looks at the results
  options.most_memory_mb = memory_left_for_patches(command.max_memory_mb);
  std::map<int, HoleResult> filled;
  for (const auto& [continuity, loops] : loops_of_each_shape(scan)) {
    if (continuity) options.evolution->continuity = *continuity;
    for (HoleResult& result : fill_holes(scan.model, loops, options, progress, cancel))
      filled[result.loop.number] = std::move(result);
    options.evolution = command.fill.evolution;
  }
  check_exterior(scan.given, scan.model.soup, scan.model.turned_faces);
  const bool out_of_time = deadline.passed();
  std::vector<HoleResult> results;
  for (std::size_t k = 0; k < scan.loops.size(); ++k) {
    const LoopChoice& choice = scan.choices[k];
    const auto done = filled.find(scan.loops[k].number);
    results.push_back(done != filled.end() ? std::move(done->second)
                                           : open_hole(scan.loops[k], PatchStatus::skipped, choice.why_not));
    const bool is_unsound = results[k].status == PatchStatus::failed || results[k].verdict().grade == Grade::bad;
    const int closing = is_unsound ? closing_edges(scan.model, scan.loops[k], scan.near) : 0;
    if (closing > 0)
      results[k].message = std::to_string(closing) +
                           " of its edges lie beside another within a tenth of their length: --stitch joins them" +
                           (results[k].message.empty() ? "" : ". Without it, " + results[k].message);
    if (out_of_time && choice.fill && results[k].status == PatchStatus::skipped)
      results[k].message = "not finished in the time that --max-time allows: left open";
  }
  name_rings(scan, results);
  return results;
}

}  // namespace loopmend
