// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/solve_group.h"

#include "core/error.h"
#include "core/seconds_since.h"
#include "core/threads.h"
#include "pipeline/bend_aside.h"
#include "pipeline/candidates.h"
#include "pipeline/mirror_candidate.h"
#include "pipeline/patch_relief.h"
#include "pipeline/tiny_hole.h"

#include <algorithm>
#include <chrono>
#include <exception>
#include <limits>
#include <map>
#include <new>

namespace loopmend {

namespace {

/// Free vertices of the part of the patch that each loop bounds.
std::vector<int> free_vertices_per_loop(const Patch& patch) {
  std::vector<int> result(patch.loops.size(), 0);
  for (int l : loop_of_free_vertices(patch)) ++result[l];
  return result;
}

Message why_left_open(const ScanIndex& scan, const BoundaryLoop& loop, int intersections) {
  if (Message why = why_no_patch_exists(scan, loop); !why.empty()) return why;
  const bool is_outline = loop.kind == LoopKind::outer_rim;
  return joined(
             say("every patch that was found would cut the surface or itself, in %1 places: left open", intersections),
             "; ",
             is_outline ? say("a base (--base) closes it below the surface")
                        : say("not tried, but may help: to remove loose fragments in its way (--repair), to trim the "
                              "boundary (--trim-boundary 3), or a strip across the hole (--bridge)"))
      .with_code("every_patch_crosses");
}

GroupResult failed_group(const std::vector<BoundaryLoop>& loops, const Message& why) {
  GroupResult result;
  for (const BoundaryLoop& loop : loops) result.holes.push_back(open_hole(loop, PatchStatus::failed, why));
  return result;
}

/// work(), which solves these loops; what goes wrong there is theirs alone.
template <class Work>
GroupResult guarded(const std::vector<BoundaryLoop>& loops, const Work& work) {
  try {
    return work();
  } catch (const std::bad_alloc&) {
    return failed_group(loops, no_memory_message());
  } catch (const std::exception& error) {
    return failed_group(loops, message_of(error));
  }
}

/// One group from its initial patch on.
class GroupSolver {
 public:
  GroupSolver(const ScanIndex& scan, const GroupOptions& options, const SolveObserver& observer,
              const CancelToken& cancel)
      : scan_(scan),
        options_(options),
        observer_(observer),
        cancel_(cancel) {}

  GroupResult solve(const InitialPatch& asked) const {
    if (asked.origin == InitialPatch::Origin::evolved) return done(jointly(asked));
    GroupResult result = failed_group(asked.loops, {});
    const InitialPatch initial = without_tiny(asked, result);
    if (initial.loops.empty()) return result;
    if (asked.loops.size() == 1) return done(jointly(initial));
    std::vector<MirrorFit> refused(initial.loops.size());
    const InitialPatch others = without_mirrored(initial, result, refused);
    if (others.loops.empty()) return result;
    const std::vector<InitialPatch> parts = parts_alike(scan_, others, options_, cancel_);
    if (parts.front().loops.size() < asked.loops.size())
      for (const InitialPatch& alike : parts) start(alike);
    for (const InitialPatch& alike : parts) {
      if (cancel_.cancelled()) return result;
      put(done(guarded(alike.loops, [&] { return part(alike); })), result);
    }
    for (std::size_t k = 0; k < refused.size(); ++k) {
      HoleResult& hole = *hole_of(initial.loops[k], result);
      if (hole.mirror.answer == MirrorFit::Answer::not_asked) hole.mirror = refused[k];
    }
    return result;
  }

 private:
  void start(const InitialPatch& initial) const {
    if (observer_.on_start && initial.patch) observer_.on_start({*initial.patch, initial.message()});
  }

  GroupResult done(GroupResult result) const {
    if (observer_.on_done && !cancel_.cancelled()) observer_.on_done(result);
    return result;
  }

  /// Closes the tiny holes of a group, each by itself. @returns the others.
  InitialPatch without_tiny(const InitialPatch& initial, GroupResult& result) const {
    std::vector<int> others;
    for (int k = 0; k < static_cast<int>(initial.loops.size()); ++k)
      if (std::optional<GroupResult> own = close_tiny_hole(scan_, initial.loops[k], options_, patch_rings))
        put(done(std::move(*own)), result);
      else
        others.push_back(k);
    if (others.size() == initial.loops.size()) return initial;
    return others.empty() ? InitialPatch{} : part_of(scan_.model, with_outcomes(initial), others, options_.initial);
  }

  InitialPatch with_outcomes(InitialPatch initial) const {
    if (initial.outcomes.empty())
      initial.outcomes = make_initial_patch(scan_.model, initial.loops, options_.initial, cancel_).outcomes;
    return initial;
  }

  /// Solves those loops of a group by themselves that a mirror image closes. @returns the others.
  InitialPatch without_mirrored(const InitialPatch& initial, GroupResult& result,
                                std::vector<MirrorFit>& refused) const {
    if (options_.mirror_planes.empty() || !options_.evolution) return initial;
    const InitialPatch known = with_outcomes(initial);
    std::vector<int> others;
    for (int k = 0; k < static_cast<int>(known.loops.size()); ++k) {
      GroupResult own = guarded({known.loops[k]}, [&] {
        const InitialPatch one = part_of(scan_.model, known, {k}, options_.initial);
        if (!one.patch) return GroupResult{};
        refused[k] =
            mirrored_patch({scan_, *one.patch, one.loops, &options_.mirror_planes}, *options_.evolution, cancel_)
                .mirror;
        if (!refused[k].is_proposed()) return GroupResult{};
        start(one);
        return jointly(one);
      });
      if (own.patches.empty())
        others.push_back(k);
      else
        put(done(std::move(own)), result);
    }
    if (others.size() == known.loops.size()) return initial;
    return others.empty() ? InitialPatch{} : part_of(scan_.model, known, others, options_.initial);
  }

  /// Jointly; where that spoils one of the loops, each by itself.
  GroupResult part(const InitialPatch& initial) const {
    GroupResult joint = jointly(initial);
    const bool spoilt = std::any_of(joint.holes.begin(), joint.holes.end(), [&](const HoleResult& hole) {
      return hole.status == PatchStatus::failed || hole.outcome().attempts.size() > 1 ||
             hole.verdict().grade == Grade::bad || (options_.evolution && hole.status == PatchStatus::filled);
    });
    if (initial.loops.size() == 1 || !spoilt || cancel_.cancelled()) return joint;
    GroupResult single = failed_group(initial.loops, {});
    const auto each = [&](const auto& work) {
      for (int k = 0; k < static_cast<int>(initial.loops.size()); ++k)
        put(guarded({initial.loops[k]}, [&] { return work(part_of(scan_.model, initial, {k}, options_.initial)); }),
            single);
    };
    if (observer_.on_start)  // of all, before the first is solved
      each([&](const InitialPatch& one) {
        start(one);
        return GroupResult{};
      });
    each([&](const InitialPatch& one) { return jointly(one); });
    return single;
  }

  static std::vector<HoleResult>::iterator hole_of(const BoundaryLoop& loop, GroupResult& result) {
    return std::find_if(result.holes.begin(), result.holes.end(),
                        [&](const HoleResult& hole) { return hole.loop.number == loop.number; });
  }

  static void put(GroupResult from, GroupResult& result) {
    for (auto& patch : from.patches) result.patches.push_back(std::move(patch));
    for (HoleResult& hole : from.holes) *hole_of(hole.loop, result) = std::move(hole);
  }

  GroupResult jointly(const InitialPatch& initial) const {
    return guarded(initial.loops, [&] { return unguarded(initial); });
  }

  GroupResult unguarded(const InitialPatch& initial) const {
    GroupResult result = failed_group(initial.loops, {});
    for (std::size_t k = 0; k < initial.outcomes.size(); ++k) {
      result.holes[k].message = initial.outcomes[k].message;
      result.holes[k].seconds = initial.seconds;
    }
    if (!initial.patch || cancel_.cancelled()) return result;
    PatchResult made = solved(initial);
    if (cancel_.cancelled()) return result;
    if (initial.loops.size() == 1 && initial.origin == InitialPatch::Origin::loops &&
        (is_cut_off(initial, made) || has_rounded_edges(made)))
      solve_from_uncut_triangles(initial, made, result.holes.front().message);
    if (made.validity.intersections > 0) bend_past_fragments(initial, made);
    if (cancel_.cancelled()) return result;
    const bool valid = made.validity.intersections == 0;
    if (!valid) {
      made.status = PatchStatus::invalid;
      made.message = why_left_open(scan_, initial.loops.front(), made.validity.intersections);
    }
    if (valid && options_.evolution) {
      const auto start = std::chrono::steady_clock::now();
      expect_deviation(*options_.evolution, cancel_, made);
      made.seconds.deviation = seconds_since(start);
      made.seconds.total += made.seconds.deviation;
    }
    const auto patch = std::make_shared<const PatchResult>(std::move(made));
    result.patches.push_back(patch);
    const std::vector<int> free = free_vertices_per_loop(patch->patch);
    for (std::size_t p = 0; p < patch->patch.loops.size(); ++p) {
      const auto hole = std::find_if(result.holes.begin(), result.holes.end(), [&](const HoleResult& h) {
        return h.loop.number == patch->patch.loop_numbers[p];
      });
      hole->seconds = patch->seconds.total;
      hole->patch = patch;
      hole->place = static_cast<int>(p);
      hole->free_vertices = free[p];
      hole->mirror = patch->mirror;
      if (!valid) {
        hole->message = why_left_open(scan_, hole->loop, patch->validity.intersections_of_loop[p]);
        continue;
      }
      hole->status = patch->status;
      // Drop the initial patch's warning of folds where these are gone, or are the corner between wall and cut.
      if (patch->status != PatchStatus::filled || !patch->message.empty() ||
          !has(hole->verdict(), NoticeCode::folded_edges))
        hole->message = patch->message;
    }
    return result;
  }

  /// Whether the patch, or the initial patch of one that is bad, cuts the surface.
  bool is_cut_off(const InitialPatch& initial, const PatchResult& made) const {
    return made.validity.intersections > 0 ||
           (worst(made.verdicts) == Grade::bad && validate(scan_, *initial.patch).intersections > 0);
  }

  static bool has(const Verdict& verdict, NoticeCode code) {
    return std::ranges::count(verdict.findings, code, &Notice::code) > 0;
  }

  static bool has_rounded_edges(const PatchResult& made) {
    return std::ranges::any_of(made.verdicts,
                               [](const Verdict& verdict) { return has(verdict, NoticeCode::edges_rounded); });
  }

  /// Of a loop whose every patch cuts the surface, or that of its sharp edges does: once more from an initial patch that does not. Where there is none, or
  /// anything goes wrong, `made` and `message` stay as they are.
  void solve_from_uncut_triangles(const InitialPatch& initial, PatchResult& made, Message& message) const {
    const BoundaryLoop& loop = initial.loops.front();
    if (pierced_edges(scan_, loop) > 0) return;
    try {
      const auto start = std::chrono::steady_clock::now();
      InitialPatchOptions options = options_.initial;  // what the first patch may have of memory, this one may, too
      options.most_vertices = std::min(options.most_vertices, 2.0 * initial.patch->free_count + 1000);
      InitialPatch uncut;
      uncut.origin = InitialPatch::Origin::uncut;
      uncut.loops = initial.loops;
      uncut.outcomes = {fill_loop_uncut(scan_.model, scan_.index, loop, options, cancel_)};
      if (!uncut.outcomes.front().patch) return;
      uncut.patch = make_patch(scan_.model, uncut.loops, {*uncut.outcomes.front().patch});
      uncut.patch->grading.density = options.density;
      uncut.survey = initial.survey;
      uncut.seconds = made.seconds.total + seconds_since(start);
      PatchResult next = solved(uncut);
      if (next.validity.intersections > 0 || cancel_.cancelled()) return;
      const bool continues_edges =
          has_rounded_edges(made) && !has_rounded_edges(next) && worst(next.verdicts) != Grade::bad;
      if (!continues_edges && !(faults(next.verdicts) < faults(made.verdicts))) return;
      made.attempts.emplace_back(text_to_say("from triangles that cut nothing"));
      next.attempts.insert(next.attempts.begin(), made.attempts.begin(), made.attempts.end());
      message = uncut.outcomes.front().message;
      made = std::move(next);
    } catch (const std::exception&) {  // for want of memory, say: what was made before stands
    }
  }

  void bend_past_fragments(const InitialPatch& initial, PatchResult& made) const {
    made.attempts.emplace_back(text_to_say("bent past fragments"));
    std::optional<BentPatch> bent = bent_aside(scan_, made.patch, made.validity, cancel_);
    if (!bent) return;
    made.patch = std::move(bent->patch);
    made.validity = std::move(bent->validity);
    made.seams = seam_reports(made.patch);
    made.made_by = made.attempts.back();
    const std::vector<BoundaryLoop> loops = loops_of(initial);
    judge_again({scan_, *initial.patch, loops}, options_.evolution.value_or(EvolutionOptions{}), made);
    add_message(made, bent_message());
  }

  /// The loops whose initial patch it is; none where a flow has moved it.
  static std::vector<BoundaryLoop> loops_of(const InitialPatch& initial) {
    return initial.origin == InitialPatch::Origin::evolved ? std::vector<BoundaryLoop>() : initial.loops;
  }

  PatchResult flowed(const PatchProblem& problem, const InitialPatch& initial) const {
    if (problem.initial.free_count == 0) return solve_patch(problem, *options_.evolution, observer_.on_step, cancel_);
    const auto start = std::chrono::steady_clock::now();
    const BoundarySurvey survey =
        initial.survey ? *initial.survey : survey_boundary(problem.initial, cancel_, initial.split);
    const double survey_seconds = initial.survey ? initial.survey_seconds : seconds_since(start);
    EvolutionOptions evolution = *options_.evolution;
    evolution.split = survey.split;
    evolution.fits = std::make_shared<const std::vector<std::vector<BoundaryFit>>>(survey.loops);
    PatchResult result = solve_patch(problem, evolution, observer_.on_step, cancel_);
    if (evolution.relief.kind == ReliefChoice::Kind::continued && evolution.mode == EvolutionMode::steady &&
        is_filled(result.status) && result.method != Method::mirror_image)
      add_relief(problem, survey.split, evolution.relief, cancel_, result);
    result.neighborhood = boundary_summaries(problem.initial, survey.split, survey.loops);
    result.seconds.survey = survey_seconds;
    return result;
  }

  PatchResult solved(const InitialPatch& initial) const {
    const auto start = std::chrono::steady_clock::now();
    const std::vector<BoundaryLoop> loops = loops_of(initial);
    const auto triangles = initial.origin == InitialPatch::Origin::uncut ? PatchProblem::Triangles::of_initial
                                                                         : PatchProblem::Triangles::any;
    const PatchProblem problem{scan_, *initial.patch, loops, &options_.mirror_planes, triangles};
    PatchResult result = options_.evolution ? flowed(problem, initial) : initial_result(problem, FlowKind::mmcvf);
    result.seconds.initial_patch = initial.seconds;
    result.seconds.total = initial.seconds + initial.survey_seconds + seconds_since(start);
    return result;
  }

  const ScanIndex& scan_;
  const GroupOptions& options_;
  const SolveObserver& observer_;
  const CancelToken& cancel_;
};

}  // namespace

std::vector<double> expected_deviations(const std::vector<HoleResult>& holes) {
  std::map<int, const PatchResult*> in_order;
  for (const HoleResult& hole : holes) {
    if (!is_filled(hole.status) || !hole.patch) continue;
    const std::vector<int>& numbers = hole.patch->patch.loop_numbers;
    in_order[*std::min_element(numbers.begin(), numbers.end())] = hole.patch.get();
  }
  std::vector<double> all;
  for (const auto& [number, result] : in_order) {
    std::vector<double> own = result->deviation.vertices;
    own.resize(result->patch.free_count, std::numeric_limits<double>::quiet_NaN());
    all.insert(all.end(), own.begin(), own.end());
  }
  return all;
}

Message why_no_patch_exists(const ScanIndex& scan, const BoundaryLoop& loop) {
  const int pierced = pierced_edges(scan, loop);
  if (pierced == 0) return {};
  return joined(pierced == 1
                    ? say("1 boundary edge intersects the surface, so that no valid patch exists: left open")
                    : say("%1 boundary edges intersect the surface, so that no valid patch exists: left open", pierced),
                "; ", say("remove what crosses (--trim-crossing)"))
      .with_code("boundary_crosses");
}

HoleResult open_hole(const BoundaryLoop& loop, PatchStatus status, Message why) {
  HoleResult result;
  result.loop = loop;
  result.status = status;
  result.message = std::move(why);
  return result;
}

std::vector<InitialPatch> parts_alike(const ScanIndex& scan, const InitialPatch& initial, const GroupOptions& options,
                                      const CancelToken& cancel) {
  const bool whole = initial.loops.size() == 1 || initial.origin == InitialPatch::Origin::evolved ||
                     initial.alike == InitialPatch::Alike::known;
  if (whole) return {initial};
  InitialPatch known = initial;
  if (known.outcomes.empty())
    known.outcomes = make_initial_patch(scan.model, initial.loops, options.initial, cancel).outcomes;
  std::vector<InitialPatch> parts;
  if (options.evolution && is_judged(*options.evolution)) {
    try {
      const std::vector<LoopsAlike> groups = groups_alike(scan.model, known, *options.evolution);
      if (groups.size() > 1)
        for (const LoopsAlike& group : groups) {
          parts.push_back(part_of(scan.model, known, group.members, options.initial));
          parts.back().split = group.split;
        }
      else
        known.split = groups.front().split;
    } catch (const std::exception&) {  // where it is unknown, all loops stay together
      parts.clear();
    }
  }
  if (parts.empty()) parts.push_back(std::move(known));
  for (InitialPatch& part : parts) part.alike = InitialPatch::Alike::known;
  return parts;
}

GroupResult solve_group(const ScanIndex& scan, const InitialPatch& initial, const GroupOptions& options,
                        const SolveObserver& observer, const CancelToken& cancel) {
  return GroupSolver(scan, options, observer, cancel).solve(initial);
}

}  // namespace loopmend
