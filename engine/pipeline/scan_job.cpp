// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/scan_job.h"

#include "core/error.h"
#include "core/path_text.h"
#include "core/system_memory.h"
#include "mesh/loop_facing.h"
#include "mesh/pieces.h"
#include "neighborhood/trim_boundary.h"
#include "pipeline/edge_preview.h"
#include "pipeline/filling_view.h"
#include "pipeline/late_findings.h"
#include "repair/zip_boundaries.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <map>
#include <set>
#include <utility>

namespace loopmend {

namespace {

/// @throws ReadError in place of InvalidArgument where the source is known.
SurfaceModel model_from(const std::filesystem::path& source, TriangleSoup soup) {
  if (source.empty()) return make_surface_model(std::move(soup));
  try {
    return make_surface_model(std::move(soup));
  } catch (const InvalidArgument& error) {
    throw ReadError(source, error.message(), {}, say("Check the mesh in the program that made it."));
  }
}

std::vector<int> soup_points(const SurfaceModel& model, const BoundaryLoop& loop) {
  std::vector<int> points;
  for (const int v : loop.vertices) points.push_back(model.soup_vertex[static_cast<std::size_t>(v)]);
  return points;
}

/// Choices among the loops of a trimmed scan: those that were chosen, as trimming left them. A small component's boundary that only
/// touches one of these is not chosen.
std::vector<LoopChoice> choices_after_trim(const std::vector<BoundaryLoop>& loops, const ScanPlan& before,
                                           const std::vector<BoundaryLoop>& grown, const ScanJob& job) {
  const std::vector<BoundaryLoop> chosen = before.chosen();
  const auto nearest = [&](const BoundaryLoop& loop) {  // the continuity of the nearest chosen loop
    std::pair<double, std::optional<SeamContinuity>> best{std::numeric_limits<double>::infinity(), std::nullopt};
    for (std::size_t k = 0; k < before.loops.size(); ++k) {
      const double distance = (before.loops[k].center - loop.center).norm();
      if (before.choices[k].fill && distance < best.first) best = {distance, before.choices[k].continuity};
    }
    return best.second;
  };
  const bool named = job.loops.names_loops();
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
    if (!named) choices[k] = choose_unnamed(loops[k], job.loops);
    if (std::exchange(choices[k].fill, false) || named) choices[k].why_not = not_selected();
  }
  return choices;
}

/// Trims the boundaries of the loops to fill, and chooses among the loops that this leaves.
void trim(ScanPlan& plan, const ScanJob& job) {
  const std::vector<BoundaryLoop> chosen = plan.chosen();
  TrimmedModel trimmed = job.prepare.trim_rounds > 0 ? trim_boundary(plan.model, chosen, job.prepare.trim_rounds)
                                                     : trim_pierced(plan.model, chosen);
  plan.trimmed = std::move(trimmed.removed);
  plan.to_trim = trimmed.loops;
  plan.spared_pieces = trimmed.spared;
  if (plan.trimmed.empty()) return;
  TriangleSoup given = as_read(std::move(plan.model));
  std::vector<char> gone(given.triangles.size(), 0);
  for (const BadBoundaryFace& bad : plan.trimmed) gone[static_cast<std::size_t>(bad.face)] = 1;
  Triangles left;
  for (std::size_t f = 0; f < gone.size(); ++f)
    if (!gone[f]) left.push_back(given.triangles[f]);
  given.triangles = std::move(left);
  plan.given = record_of(given);
  std::vector<int>& turned = trimmed.model.turned_faces;
  turned.clear();
  for (std::size_t f = 0; f < given.triangles.size(); ++f)
    if (trimmed.model.soup.triangles[f] != given.triangles[f]) turned.push_back(static_cast<int>(f));
  trimmed.model.repairs.reoriented_faces = turned.size();
  plan.model = std::move(trimmed.model);
  std::vector<BoundaryLoop> loops = find_boundary_loops(plan.model);
  plan.choices = choices_after_trim(loops, plan, trimmed.loops, job);
  plan.loops = std::move(loops);
}

/// How near the sides of a hole must be for it to be a crack. In the shared scans no hole comes near to that; a slit in a dummy's
/// head, which is filled, has 0.03. Those of an outer rim may be as far apart as stitching joins them: nothing is filled there.
constexpr double crack_in_edges = 0.01;

Message crack_message(int closing, const BoundaryLoop& loop) {
  return with_cure(
      say("crack: %1 of its %2 edges lie beside another within a tenth of their length", closing, loop.edges()),
      say("--stitch joins them"));
}

/// Farther apart than stitching reaches by itself: two boundaries of one size in one place, whose edges all close at this tolerance.
constexpr double wide_gap_in_edges = 0.3, closing_share = 0.9, one_place = 0.1;

/// Whether the surface beyond a loop would meet the other one: the ends of a short tube run on away from each other.
bool runs_on_towards(const SurfaceModel& model, const BoundaryLoop& loop, const BoundaryLoop& other) {
  const LoopFacing facing = loop_facing(model, loop);
  std::size_t towards = 0;
  for (std::size_t k = 0; k < loop.vertices.size(); ++k) {
    const Vec3& p = model.mesh.point(TriMesh::VertexHandle(loop.vertices[k]));
    Vec3 nearest = Vec3::Constant(std::numeric_limits<double>::infinity());
    for (const int v : other.vertices) {
      const Vec3 d = model.mesh.point(TriMesh::VertexHandle(v)) - p;
      if (!(d.squaredNorm() >= nearest.squaredNorm())) nearest = d;
    }
    towards += nearest.dot(facing.conormals[k]) > 0;
  }
  return 2 * towards > loop.vertices.size();
}

/// The boundaries of two parts that cross each other to and fro lie so near each other, in edges, and may be longer by their zigzag.
constexpr double ragged_gap_in_edges = 0.5, least_of_perimeter = 0.75;

/// "0.034"
std::string in_two_digits(double length) {
  char text[32];
  std::snprintf(text, sizeof text, "%.2g", length);
  return text;
}

/// The length with which stitching zips both boundaries from end to end; empty where they are not so near, or it would not close
/// them, or would close others than loops of gaps.
std::string length_that_zips(const ScanPlan& plan, std::size_t k, std::size_t l, const std::set<std::size_t>& of_gaps) {
  const BoundaryLoop &a = plan.loops[k], &b = plan.loops[l];
  const double edge = std::max(a.perimeter / a.edges(), b.perimeter / b.edges());
  const double distance =
      distance_all_along(plan.model.soup.points, soup_points(plan.model, a), soup_points(plan.model, b));
  if (!(distance > 0) || distance > ragged_gap_in_edges * edge) return {};
  const double unit = std::pow(10, std::floor(std::log10(distance)) - 1);
  const std::string length = in_two_digits(std::ceil(distance / unit) * unit);
  const NearBoundaries near = near_boundaries(plan.model, stitch_tolerance_of(length));
  const auto closing = [&](std::size_t loop) { return closing_edges(plan.model, plan.loops[loop], near); };
  std::size_t expected = 0;
  for (const std::size_t loop : of_gaps) expected += static_cast<std::size_t>(closing(loop));
  const bool closes = closing(k) == a.edges() && closing(l) == b.edges() && near.closing.size() == expected;
  return closes ? length : std::string();
}

/// Leaves the two boundaries of such a gap: a patch over each would close both parts beside it, one on the other.
void leave_gaps_between_parts(ScanPlan& plan) {
  const auto may_be_side = [&](std::size_t k) {
    const bool is_open = plan.choices[k].fill || plan.loops[k].kind == LoopKind::outer_rim;
    return is_open && plan.choices[k].left == LoopChoice::Left::as_asked && !plan.at_walls[k];
  };
  const auto lie_in_one_place = [&](const BoundaryLoop& a, const BoundaryLoop& b) {
    const double reach = one_place * a.diameter;
    return (a.center - b.center).norm() < reach && std::abs(a.diameter - b.diameter) < reach;
  };
  const auto run_on = [&](const BoundaryLoop& a, const BoundaryLoop& b) {
    return runs_on_towards(plan.model, a, b) && runs_on_towards(plan.model, b, a);
  };
  std::set<std::size_t> sides;
  std::vector<std::pair<std::size_t, std::size_t>> pairs;
  for (std::size_t k = 0; k < plan.loops.size(); ++k)  // by falling perimeter
    for (std::size_t l = k + 1; may_be_side(k) && l < plan.loops.size(); ++l) {
      const double share = plan.loops[l].perimeter / plan.loops[k].perimeter;
      if (share < least_of_perimeter) break;
      if (!may_be_side(l) || !lie_in_one_place(plan.loops[k], plan.loops[l])) continue;
      pairs.emplace_back(k, l);
      if (share >= 1 - 2 * one_place && run_on(plan.loops[k], plan.loops[l])) sides.insert({k, l});
    }
  const auto closes = [&](const NearBoundaries& near, std::size_t k) {
    return closing_edges(plan.model, plan.loops[k], near) > closing_share * plan.loops[k].edges();
  };
  const auto leave = [&](const NearBoundaries& near, const auto& why) {
    std::set<std::size_t> closing;
    for (const std::size_t k : sides)
      if (closes(near, k)) closing.insert(k);
    for (const std::size_t k : closing) {
      if (closing.size() < 2) break;
      sides.erase(k);
      plan.choices[k].fill = false;
      plan.choices[k].left = LoopChoice::Left::wide_crack;
      plan.choices[k].why_not = why(plan.loops[k]).with_code("wide_crack");
    }
  };
  if (!sides.empty())
    leave(plan.coincident, [&](const BoundaryLoop& loop) {
      return crack_message(closing_edges(plan.model, loop, plan.coincident), loop);
    });
  if (!sides.empty())
    leave(near_boundaries(plan.model, {wide_gap_in_edges, std::nullopt}), [](const BoundaryLoop&) {
      return with_cure(say("gap: another boundary lies beside it within 30 % of its edges' length"),
                       say("--stitch 30% joins them"));
    });
  int parts = 0;
  std::vector<int> part_of;
  std::set<std::size_t> of_gaps;
  for (const auto& [k, l] : pairs) of_gaps.insert({k, l});
  if (!pairs.empty()) part_of = parts_of_points(plan.model, parts);
  const auto part = [&](std::size_t k) { return part_of[soup_points(plan.model, plan.loops[k]).front()]; };
  for (const auto& [k, l] : pairs) {
    if (!may_be_side(k) || !may_be_side(l) || part(k) == part(l)) continue;
    const bool is_crack = closes(plan.coincident, k) && closes(plan.coincident, l);
    const std::string length = is_crack ? std::string() : length_that_zips(plan, k, l, of_gaps);
    if (!is_crack && length.empty()) continue;
    for (const std::size_t side : {k, l}) {
      plan.choices[side].fill = false;
      plan.choices[side].left = LoopChoice::Left::wide_crack;
      plan.choices[side].why_not =
          is_crack ? crack_message(closing_edges(plan.model, plan.loops[side], plan.coincident), plan.loops[side])
                         .with_code("wide_crack")
                   : with_cure(say("gap: the boundary of another part lies beside it all along"),
                               say("--stitch %1 joins them", length))
                         .with_code("wide_crack");
    }
  }
}

/// Leaves loops without a name of which --stitch would close more than half: a patch between sides that nearly touch would cross
/// them.
void leave_wide_cracks(ScanPlan& plan, const ScanJob& job) {
  if (plan.loops.empty()) return;
  const bool stitched = job.prepare.stitch == PrepareOptions::Stitch::yes;
  if (!stitched) plan.coincident = near_boundaries(plan.model);
  if (job.loops.names_loops()) return;
  if (!stitched || job.prepare.stitch_tolerance.edges < wide_gap_in_edges) leave_gaps_between_parts(plan);
  if (plan.coincident.closing.empty()) return;
  const NearBoundaries nearest = near_boundaries(plan.model, {crack_in_edges, std::nullopt});
  for (std::size_t k = 0; k < plan.loops.size(); ++k) {
    const BoundaryLoop& loop = plan.loops[k];
    LoopChoice& choice = plan.choices[k];
    const bool is_rim = loop.kind == LoopKind::outer_rim;
    if (choice.left != LoopChoice::Left::as_asked || (!choice.fill && !is_rim) || plan.at_walls[k]) continue;
    const int closing = closing_edges(plan.model, loop, is_rim ? plan.coincident : nearest);
    if (2 * closing <= loop.edges()) continue;
    choice.fill = false;
    choice.left = LoopChoice::Left::wide_crack;
    choice.why_not = crack_message(closing, loop).with_code("wide_crack");
  }
}

/// The loops, those of gaps that --stitch closes not as what they are: they may cross, and are no tiles.
std::vector<BoundaryLoop> without_gaps(const ScanPlan& plan) {
  std::vector<BoundaryLoop> loops = plan.loops;
  for (std::size_t k = 0; k < loops.size(); ++k)
    if (plan.choices[k].left == LoopChoice::Left::wide_crack) loops[k].kind = LoopKind::crack;
  return loops;
}

/// Of a loop's edges those that --stitch would close; 0 below a tenth: joining so few cures no loop.
int edges_to_stitch(const ScanPlan& plan, std::size_t loop) {
  const int closing = closing_edges(plan.model, plan.loops[loop], plan.coincident);
  return 10 * closing >= plan.loops[loop].edges() ? closing : 0;
}

/// Outlines that are left, and that --stitch would close in part.
std::size_t count_abutting(const ScanPlan& plan) {
  std::size_t count = 0;
  for (std::size_t k = 0; k < plan.loops.size(); ++k) {
    const LoopChoice& choice = plan.choices[k];
    const bool is_left = !choice.fill && choice.left == LoopChoice::Left::as_asked && !plan.at_walls[k];
    count += is_left && plan.loops[k].kind == LoopKind::outer_rim && edges_to_stitch(plan, k) > 0;
  }
  return count;
}

/// Names what closes a loop that is no hole, or makes one of it; nothing that was done already, or that would join nothing.
/// @param job  with what was done
void name_cures(ScanPlan& plan, const ScanJob& job) {
  for (std::size_t k = 0; k < plan.loops.size(); ++k) {
    LoopChoice& choice = plan.choices[k];
    if (choice.cure == LoopChoice::Cure::repair && !job.prepare.repair.empty()) choice.cure = LoopChoice::Cure::none;
    if (choice.cure == LoopChoice::Cure::stitch && closing_edges(plan.model, plan.loops[k], plan.coincident) == 0)
      choice.cure = LoopChoice::Cure::none;
    switch (choice.cure) {
      case LoopChoice::Cure::none: break;
      case LoopChoice::Cure::stitch: choice.why_not = with_cure(choice.why_not, say("--stitch joins them")); break;
      case LoopChoice::Cure::repair:
        choice.why_not = with_cure(choice.why_not, say("--repair makes a hole of it, or nothing"));
        break;
    }
  }
}

/// The loops to be filled by the shape that was named for them; first those without.
std::map<std::optional<SeamContinuity>, std::vector<BoundaryLoop>> loops_of_each_shape(const ScanPlan& plan) {
  std::map<std::optional<SeamContinuity>, std::vector<BoundaryLoop>> loops;
  for (std::size_t k = 0; k < plan.loops.size(); ++k)
    if (plan.choices[k].fill) loops[plan.choices[k].continuity].push_back(plan.loops[k]);
  return loops;
}

/// @throws InvalidArgument where vertices are named that have other numbers by then.
void check_numbering(const ScanJob& job) {
  const bool names_edges = job.fill.evolution && !job.fill.evolution->edge_edits.empty();
  if (job.prepare.cut_plane && (!job.loops.at_vertices.empty() || names_edges))
    throw InvalidArgument(say("--cut-plane renumbers the vertices: name those of the file that it writes, later"));
}

/// @throws InvalidArgument where a shape is named that the flow does not know.
void check_shapes(const ScanPlan& plan, const ScanJob& job) {
  const bool named = std::any_of(plan.choices.begin(), plan.choices.end(),
                                 [](const LoopChoice& choice) { return choice.continuity.has_value(); });
  const std::optional<EvolutionOptions>& flow = job.fill.evolution;
  if (named && !(flow && flow->flow == FlowKind::mmcvf && flow->mode == EvolutionMode::steady))
    throw InvalidArgument(
        say("--loops takes flat, tangent and smooth only with --flow mmcvf and --mode steady, the defaults"));
}

/// The surface before its holes were filled, for trials.
AdviceTrials trials_on(const ScanPlan& plan, const FillOptions& options, const CancelToken& cancel) {
  TriangleSoup soup;
  const auto points = static_cast<std::ptrdiff_t>(plan.given.points);
  const auto triangles = static_cast<std::ptrdiff_t>(plan.given.triangles);
  soup.points.assign(plan.model.soup.points.begin(), plan.model.soup.points.begin() + points);
  soup.triangles.assign(plan.model.soup.triangles.begin(), plan.model.soup.triangles.begin() + triangles);
  std::vector<std::vector<int>> chosen;
  for (const BoundaryLoop& loop : plan.chosen()) chosen.push_back(soup_points(plan.model, loop));
  return {std::move(soup), std::move(chosen), plan.used, options, cancel};
}

/// Whether the part of this soup point runs over another, or another over it, and was not joined to it.
bool lies_on_a_tile(const ScanPlan& plan, int point) {
  const std::vector<char>& is_tile = plan.tiles.overlapping.is_tile;
  if (plan.tiles.overlapping.count == 0 || plan.used.stitch_tolerance.length) return false;
  int parts = 0;
  const std::vector<int> part_of = parts_of_points(plan.model, parts);
  const int part = part_of[static_cast<std::size_t>(point)];
  return part >= 0 && static_cast<std::size_t>(parts) == is_tile.size() && is_tile[static_cast<std::size_t>(part)] != 0;
}

/// Says of loops that failed what closes them, and whether trimming cures them and those with a bad patch. Where triangles were
/// trimmed nothing is tried, since options run in another order then; where stitching joins the sides, that is the cure.
void try_advice(ScanPlan& plan, const FillOptions& options, const CancelToken& cancel,
                std::vector<HoleResult>& results) {
  using Helps = ScanPlan::TrimmingHelps;
  std::optional<AdviceTrials> trials;
  int tried = 0;
  const auto has_cure = [&](std::size_t k) {
    return edges_to_stitch(plan, k) > 0 || std::ranges::any_of(plan.rim_groups, [&](const RimGroup& group) {
             return std::ranges::count(group.loops, static_cast<int>(k)) > 0;
           });
  };
  for (std::size_t k = 0; k < results.size(); ++k) {
    const bool failed = is_open_for_its_shape(results[k]);
    const bool may_trim = !plan.trimmable.empty() && plan.trimming_helps != Helps::no && plan.used.trim_rounds == 0;
    if ((!failed && !(may_trim && results[k].verdict().grade == Grade::bad)) || has_cure(k)) continue;
    const std::vector<int> points = soup_points(plan.model, plan.loops[k]);
    Message& message = results[k].message;
    if (failed && lies_on_a_tile(plan, points.front())) {
      message = with_advice(message, say("join the parts that overlap first (--stitch %1)",
                                         in_two_digits(plan.tiles.overlapping.distance)));
      continue;
    }
    if (!trials) trials.emplace(trials_on(plan, options, cancel));
    const bool tries = plan.trimmed.empty() && trials->are_small(points) && tried++ < most_tried_loops;
    const std::optional<SeamContinuity> continuity = plan.choices[k].continuity;
    if (tries && may_trim) plan.trimming_helps = trials->trimming_closes(points, continuity) ? Helps::yes : Helps::no;
    if (failed)
      message = with_advice(message, tries ? trials->advice(plan.loops[k], points, continuity) : trials->untried());
  }
}

}  // namespace

std::vector<BoundaryLoop> ScanPlan::chosen() const {
  std::vector<BoundaryLoop> result;
  for (std::size_t k = 0; k < loops.size(); ++k)
    if (choices[k].fill) result.push_back(loops[k]);
  return result;
}

bool needs_whole_view(const ScanJob& job) {
  const PrepareOptions& prepare = job.prepare;
  return prepare.extent == PrepareOptions::Extent::where_needed || prepare.stitch == PrepareOptions::Stitch::yes ||
         prepare.sides == PrepareOptions::Sides::turned || prepare.no_data == PrepareOptions::NoData::cut ||
         !prepare.repair.empty() || !prepare.bridges.empty() || prepare.cut_plane || prepare.base || prepare.trims();
}

ScanPlan plan_scan(SoupRecord given, SurfaceModel model, const ScanJob& asked, const CancelToken& cancel,
                   const OnRepairStep& on_step) {
  ScanJob job = asked;
  ScanPlan plan;
  plan.given = std::move(given);
  plan.model = std::move(model);
  bool is_replaced = false;
  const auto make_model = [&](TriangleSoup soup) {
    is_replaced = true;
    return model_from(job.source, std::move(soup));
  };
  check_numbering(job);
  try {
    plan.done = prepare(plan.model, job.prepare, make_model, cancel, on_step);
  } catch (const InvalidArgument& error) {
    if (!job.prepare.cut_plane || job.source.empty()) throw;
    throw InvalidArgument(say("%1: %2", path_text(job.source), error.message()));
  }
  if (is_replaced) plan.given = record_of(plan.model.soup, plan.model.turned_faces);
  plan.loops = find_boundary_loops(plan.model);
  plan.choices = choose_loops(plan.model, plan.loops, job.loops);
  if (widen_filling_view(plan.model, plan.loops, plan.chosen())) {  // the same loops, of other view vertices
    plan.loops = find_boundary_loops(plan.model);
    plan.choices = choose_loops(plan.model, plan.loops, job.loops);
  }
  check_shapes(plan, job);
  plan.inverted = find_inverted_shells(plan.model, plan.loops);
  // Only where commands find the same loops in the file.
  if (job.numbering == ScanJob::Numbering::of_source && plan.done.changed_nothing())
    plan.rim_groups = find_rim_groups(plan.model, plan.loops, cancel);
  plan.at_walls = are_at_walls(plan.model, plan.loops, plan.rim_groups);
  leave_wide_cracks(plan, job);
  plan.tiles = {count_abutting(plan), find_overlapping_outlines(plan.model, without_gaps(plan))};
  plan.to_trim = plan.chosen();
  if (job.prepare.trims()) {
    if (on_step) on_step({RepairStage::trim});
    trim(plan, job);
  }
  if (job.fill.evolution) check(job.fill.evolution->edge_edits, plan.model, plan.loops);
  name_cures(plan, job);
  plan.used = job.prepare;
  if (!plan.trimmed.empty()) plan.rim_groups.clear();  // no command finds the same loops in the file
  plan.bad_faces = bad_boundary_faces(plan.model, plan.to_trim);
  std::vector<BoundaryLoop> apart = plan.to_trim;  // stitching is the cure of the others
  std::erase_if(apart, [&](const BoundaryLoop& loop) { return closing_edges(plan.model, loop, plan.coincident) > 0; });
  plan.trimmable = few_of_their_pieces(plan.model, bad_boundary_faces(plan.model, apart));
  return plan;
}

std::vector<HoleResult> fill_chosen(ScanPlan& plan, const ScanJob& job, const Deadline& deadline,
                                    const OnFillProgress& progress, const CancelToken& cancel) {
  FillOptions options = job.fill;
  options.on_cancel = FillOptions::OnCancel::keep_finished;  // the caller drops the results where nothing is kept
  options.most_memory_mb = memory_left_mb(job.max_memory_mb);
  std::map<int, HoleResult> filled;
  for (const auto& [continuity, loops] : loops_of_each_shape(plan)) {
    if (continuity) options.evolution->continuity = *continuity;
    for (HoleResult& result : fill_holes(plan.model, loops, options, progress, cancel))
      filled[result.loop.number] = std::move(result);
    options.evolution = job.fill.evolution;
  }
  check_exterior(plan.given, plan.model.soup, plan.model.turned_faces);
  const bool out_of_time = deadline.passed();
  std::vector<HoleResult> results;
  for (std::size_t k = 0; k < plan.loops.size(); ++k) {
    const LoopChoice& choice = plan.choices[k];
    const auto done = filled.find(plan.loops[k].number);
    results.push_back(done != filled.end() ? std::move(done->second)
                                           : open_hole(plan.loops[k], PatchStatus::skipped, choice.why_not));
    if (job.prepare.trim_pierced == PrepareOptions::TrimPierced::yes && results[k].message.code == "boundary_crosses")
      results[k].message = say("boundary edges intersect the surface, and removing what crosses does not end that: "
                               "left open as it was")
                               .with_code("boundary_crosses");
    const bool is_unsound = results[k].status == PatchStatus::failed || results[k].verdict().grade == Grade::bad;
    const int closing = is_unsound ? edges_to_stitch(plan, k) : 0;
    if (closing > 0) {  // the sides of a crack may cross each other: joining them cures that, too
      const bool says_no_more = results[k].message.empty() || results[k].message.code == "boundary_crosses";
      results[k].message =
          joined(say("%1 of its edges lie beside another within a tenth of their length: --stitch joins them", closing),
                 "; ", says_no_more ? Message() : say("without it, %1", results[k].message));
    }
    if (out_of_time && choice.fill && results[k].status == PatchStatus::skipped)
      results[k].message = say("not finished in the time that --max-time allows: left open").with_code("out_of_time");
  }
  if (!cancel.cancelled()) try_advice(plan, options, cancel, results);
  name_rim_groups(plan.rim_groups, plan.choices, results);
  judge_outlines(results);
  return results;
}

}  // namespace loopmend
