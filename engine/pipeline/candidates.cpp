// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/candidates.h"

#include "core/seconds_since.h"
#include "edges/sharp_patch.h"
#include "filling/sphere_cap.h"
#include "filling/straight_base.h"
#include "filling/two_faces.h"
#include "pipeline/edge_preview.h"
#include "pipeline/initial_patch.h"
#include "pipeline/mirror_candidate.h"
#include "pipeline/multi_start.h"
#include "pipeline/plane_face.h"

#include <algorithm>
#include <chrono>
#include <optional>
#include <utility>

namespace loopmend {

namespace {

/// Largest distance, in radii, of a patch from the sphere on which all vertices around lie.
constexpr double off_sphere = 1e-3;

/// One problem with all that decides which candidates there are.
struct Situation {
  AttemptContext context;
  EvolutionOptions options;            ///< as asked for
  std::optional<SplitEstimate> split;  ///< where the options leave the treatment of the boundary to be judged
  std::optional<CleanNeighborhood>
      clean_neighborhood;                ///< where single vertices stand off a neighborhood that is smooth without them
  std::optional<Patch> triangulation;    ///< the initial patch before it was relaxed
  std::vector<LoopEnd> ends;             ///< of each loop; empty where the loops bound no holes
  std::optional<SharpPatch> sharp;       ///< where sharp edges run on into the hole
  std::optional<Sphere> sphere;          ///< on which all vertices around lie; patch frame
  bool has_clear_edges = false;          ///< whether sharp edges end at the hole beyond doubt
  bool is_in_plane_face = false;         ///< bounds_plane_face()
  std::optional<LoopPatch> two_faces{};  ///< two_plane_faces()

  const Patch& initial() const { return context.problem.initial; }
  bool is_rough() const { return split && !split->is_exact(options.literal_relief); }
  /// What a fairing of a rough neighborhood starts from.
  const Patch& start() const { return triangulation ? *triangulation : initial(); }
  bool is_cut() const {
    return is_judged(options) && !ends.empty() &&
           std::none_of(ends.begin(), ends.end(), [](LoopEnd end) { return end == LoopEnd::runs_on; });
  }
};

/// The initial patch of the same loops before it was relaxed. Empty if there is none.
std::optional<Patch> triangulation_of(const PatchProblem& problem, const CancelToken& cancel) {
  const Patch& initial = problem.initial;
  std::vector<BoundaryLoop> closed;  // a joint patch leaves out those that have none
  for (const BoundaryLoop& loop : problem.loops)
    if (std::find(initial.loop_numbers.begin(), initial.loop_numbers.end(), loop.number) != initial.loop_numbers.end())
      closed.push_back(loop);
  if (closed.empty()) return std::nullopt;
  std::optional<Patch> patch =
      make_initial_patch(problem.scan.model, closed, {initial.grading.density, InitialShape::triangulated}, cancel)
          .patch;
  return patch && patch->loop_numbers == initial.loop_numbers && patch->free_count > 0 ? patch : std::nullopt;
}

std::vector<LoopEnd> ends_of(const PatchProblem& problem) {
  std::vector<LoopEnd> ends;
  for (int number : problem.initial.loop_numbers)
    for (const BoundaryLoop& loop : problem.loops)
      if (loop.number == number) ends.push_back(loop_end(problem.scan.model, loop));
  return ends.size() == problem.initial.loops.size() ? ends : std::vector<LoopEnd>();
}

Judge judge_for(const PatchProblem& problem, const EvolutionOptions& options, std::vector<LoopEnd> ends) {
  const bool position = options.flow == FlowKind::mcf ||
                        (options.flow == FlowKind::mmcvf && options.continuity == SeamContinuity::position);
  const bool tangent = options.flow == FlowKind::mmcvf && options.continuity == SeamContinuity::tangent;
  if (tangent) std::ranges::fill(ends, LoopEnd::runs_on);  // over a flat loop, a dome is what was asked for
  return {problem.initial, std::move(ends), position ? Judge::Creases::asked_for : Judge::Creases::unwanted};
}

PatchResult judged_initial(const PatchProblem& problem, const EvolutionOptions& options, const Judge& judge) {
  const auto start = std::chrono::steady_clock::now();
  PatchResult result;
  result.status = PatchStatus::filled;
  result.flow = options.flow;
  result.patch = problem.initial;
  result.validity = validate(problem.scan, problem.initial);
  result.seams = result.seams_before = judge.initial_seams();
  result.verdicts = judge(result.patch, result.validity, result.seams);
  result.seconds.checks = result.seconds.total = seconds_since(start);
  return result;
}

bool base_below_teeth(const Situation& s, PatchResult& result) {
  const auto start = std::chrono::steady_clock::now();
  const PatchProblem& problem = s.context.problem;
  const std::optional<LoopPatch> base =
      straight_base(problem.scan.model, problem.loops.front(), {problem.initial.grading.density}, s.context.cancel);
  if (!base) return false;
  Patch patch = make_patch(problem.scan.model, problem.loops, {*base});
  patch.grading = problem.initial.grading;
  take_patch(s.context, s.context.judge, s.options.flow, std::move(patch), result);
  result.status = PatchStatus::faired;
  result.method = Method::straight_base;
  result.reason = joined(say("the surface ends at this loop, which is ragged, so that its wall was continued straight "
                             "to a plane base"),
                         "; ", say("--loops %1:flat closes the loop as it is", problem.loops.front().number))
                      .with_code("surface_ends");
  result.seconds.total = seconds_since(start);
  return true;
}

bool position(const Situation& s, PatchResult& result) {
  EvolutionOptions options = s.options;
  options.continuity = SeamContinuity::position;
  return run_once(s.context, s.initial(), options, result);
}

/// Where the walls of a part leave its plane face, the seam bends as it has to.
bool plane_face(const Situation& s, PatchResult& result) {
  if (!position(s, result)) return false;
  std::vector<std::vector<char>> everywhere;
  for (const std::vector<int>& loop : result.patch.loops) everywhere.emplace_back(loop.size(), 1);
  const Judge judge = s.context.judge.expecting_creases(std::move(everywhere), 180);
  result.verdicts = judge(result.patch, result.validity, result.seams);
  return true;
}

bool cap(const Situation& s, PatchResult& result) {
  return (std::ranges::all_of(s.context.problem.loops, &BoundaryLoop::is_polygon) ? plane_face : position)(s, result);
}

/// As flat as a minimal surface, nearly, and less bold where the loop winds.
bool initial_patch(const Situation& s, PatchResult& result) {
  result = judged_initial(s.context.problem, s.options, s.context.judge);
  open_folds(s.context, s.options.flow, result);
  return true;
}

bool flow(const Situation& s, PatchResult& result) {
  // Stricter than the judge: a run that folds at all may have ended in another steady state than one from another start.
  const auto is_sound = [&](const PatchResult& run) {
    return run.status != PatchStatus::filled && worst(run.verdicts) != Grade::bad &&
           (run.validity.is_clean() || no_worse(run.validity, validate(s.context.problem.scan, s.initial())));
  };
  result = best_of_starts(
      s.initial(), s.options, s.context.cancel,
      [&](const Patch& start, const EvolutionOptions& from) {
        PatchResult run;
        run.patch = s.initial();
        run.status = run_once(s.context, start, from, run) ? run.status : PatchStatus::filled;
        return run;
      },
      [&](const PatchResult& run) { return rating_of(run, is_sound(run)); });
  return result.status != PatchStatus::filled;
}

bool sharp_edges(const Situation& s, PatchResult& result) {
  const auto start = std::chrono::steady_clock::now();
  const PatchProblem& problem = s.context.problem;
  Patch patch = make_patch(problem.scan.model, problem.loops, {s.sharp->patch});
  patch.grading = problem.initial.grading;
  take_patch(s.context, s.context.judge.expecting_creases({s.sharp->creased}, s.sharp->sharpest_deg), s.options.flow,
             std::move(patch), result);
  result.status = PatchStatus::faired;
  result.method = Method::sharp_edges;
  const auto edges = s.sharp->edges.size();
  result.reason = joined(edges == 0   ? say("the surface of one side alone runs on here")
                         : edges == 1 ? say("1 sharp edge runs on across the hole")
                                      : say("%1 sharp edges run on across the hole", edges),
                         "; ", say("--edges round runs the flow"))
                      .with_code("sharp_edges");
  result.seconds.total = seconds_since(start);
  return true;
}

bool two_faces(const Situation& s, PatchResult& result) {
  const auto start = std::chrono::steady_clock::now();
  const PatchProblem& problem = s.context.problem;
  Patch patch = make_patch(problem.scan.model, problem.loops, {*s.two_faces});
  patch.grading = problem.initial.grading;
  const Judge judge = s.context.judge.expecting_creases({std::vector<char>(patch.loops.front().size(), 1)}, 180);
  take_patch(s.context, judge, s.options.flow, std::move(patch), result);
  result.status = PatchStatus::faired;
  result.method = Method::sharp_edges;
  result.reason = joined(say("the loop bounds two plane faces, which meet at a sharp edge"), "; ",
                         say("--edges round runs the flow"))
                      .with_code("sharp_edges");
  result.seconds.total = seconds_since(start);
  return true;
}

bool cap_of_sphere(const Situation& s, PatchResult& result) {
  const auto start = std::chrono::steady_clock::now();
  const PatchProblem& problem = s.context.problem;
  std::optional<Patch> cap =
      sphere_cap(problem.scan.model, problem.loops.front(), problem.initial, *s.sphere, s.context.cancel);
  if (!cap) return false;
  take_patch(s.context, s.context.judge.expecting_known_surface(), s.options.flow, std::move(*cap), result);
  result.status = PatchStatus::faired;
  result.method = Method::sphere;
  result.seconds.total = seconds_since(start);
  return true;
}

bool split(const Situation& s, PatchResult& result) { return run_once(s.context, s.start(), s.options, result); }

bool robust(const Situation& s, PatchResult& result) {
  EvolutionOptions options = s.options;
  options.boundary = BoundaryTrust::robust;
  options.continuity = SeamContinuity::curvature;
  return run_once(s.context, s.start(), options, result);
}

bool tangent(const Situation& s, PatchResult& result) {
  EvolutionOptions options = s.options;
  options.continuity = SeamContinuity::tangent;
  return run_once(s.context, s.initial(), options, result);
}

bool is_exact(const Situation& s) { return !s.is_rough(); }
bool is_rough(const Situation& s) { return s.is_rough(); }
bool is_cut(const Situation& s) { return s.is_cut(); }
bool is_toothed(const Situation& s) { return s.is_cut() && s.ends.size() == 1 && s.ends.front() == LoopEnd::toothed; }
bool is_on_sphere(const Situation& s) { return s.sphere.has_value(); }
bool is_in_plane_face(const Situation& s) { return s.is_in_plane_face; }
bool has_two_faces(const Situation& s) { return s.two_faces.has_value(); }
bool has_sharp_edges(const Situation& s) { return s.sharp.has_value(); }
/// The flow for which there is anything else to fall back on.
bool can_fall_back(const Situation& s) {
  return s.options.flow == FlowKind::mmcvf && s.options.mode == EvolutionMode::steady && !s.options.bending;
}
bool of_lower_order(const Situation& s) { return can_fall_back(s) && s.options.continuity != SeamContinuity::position; }
bool of_curvature(const Situation& s) { return can_fall_back(s) && s.options.continuity == SeamContinuity::curvature; }

struct Candidate {
  const char* name;
  bool (*applies)(const Situation&);
  bool (*run)(const Situation&, PatchResult&);  ///< true if there is a patch
  bool gives_way = false;                       ///< sound, but with a remark, to an alternative that is good
  bool is_alternative = false;
};

const char* const plane_face_name = text_to_say("plane face");
const char* const two_faces_name = text_to_say("two plane faces");

const Candidate candidates[] = {
    {text_to_say("base below teeth"), is_toothed, base_below_teeth},
    {text_to_say("minimal surface over a cut"), is_cut, cap},
    {text_to_say("initial patch over a cut"), is_cut, initial_patch},
    {two_faces_name, has_two_faces, two_faces},
    {text_to_say("sharp edges"), has_sharp_edges, sharp_edges},
    {plane_face_name, is_in_plane_face, plane_face},
    {text_to_say("flow"), is_exact, flow},
    {text_to_say("split flow"), is_rough, split, true},
    {text_to_say("sphere"), is_on_sphere, cap_of_sphere},
    {text_to_say("robust fairing"), of_curvature, robust, true, true},
    {text_to_say("tangent fairing"), of_curvature, tangent, false, true},
    {text_to_say("minimal surface"), of_lower_order, position},
};

/// Whether the candidate is kept without looking at others. Where a person has chosen the treatment of the boundary, only what
/// folds or crosses is passed over.
bool is_kept(const Situation& s, const PatchResult& result) {
  if (s.sphere && distance_from(*s.sphere, result.patch) > off_sphere) return false;
  if (is_judged(s.options)) return worst(result.verdicts) != Grade::bad;
  const Faults found = faults(result.verdicts);
  return found.crossings == 0 && found.folds == 0;
}

/// "split flow: 3 edges are folded by more than 150°". Of a candidate that is not good.
Message fault_of(const Situation& s, const char* name, const PatchResult& result) {
  for (const Verdict& verdict : result.verdicts)
    if (verdict.grade == Grade::bad) return joined(say(name), ": ", verdict.message()).with_code("first_candidate_bad");
  if (s.sphere)
    return joined(say(name), ": ", say("off the sphere on which all vertices around lie")).with_code("off_sphere");
  for (const Verdict& verdict : result.verdicts)
    if (verdict.grade == Grade::look)
      return joined(say(name), ": ", verdict.message()).with_code("first_candidate_remarked");
  return joined(say(name), ": ", result.message);
}

Message reason_of_cut(const Situation& s) {
  const bool flat = std::find(s.ends.begin(), s.ends.end(), LoopEnd::curved) == s.ends.end();
  return joined(flat ? say("the surface ends at this loop, which is flat, so that it was closed flat")
                     : say("the surface ends at this loop, so that it was closed by a minimal surface"),
                "; ", say("--boundary exact runs the flow itself"))
      .with_code("surface_ends");
}

Message reason_of_plane() {
  return joined(say("the loop bounds a plane face, which was closed flat"), "; ",
                say("--boundary exact runs the flow itself"))
      .with_code("plane_face");
}

/// Of edges that a person drew, or that the scan has, where no patch was made that continues them.
Message why_no_edges(const Situation& s, const LoopEdits& edits) {
  if (s.sharp || !continues_edges(s.options)) return {};
  if (!edits.drawn.empty())
    return say(
        "the edges drawn could not be continued: no surfaces fit the faces beside them and meet across the hole");
  if (!s.has_clear_edges || !edits.empty()) return {};
  return say("sharp edges of the scan end at this hole and were not continued");
}

/// A person sees an edge that is rounded, whatever else is right.
void judge_edges(const Situation& s, const LoopEdits& edits, PatchResult& result) {
  const bool are_found = s.has_clear_edges || (s.sharp && !s.sharp->edges.empty());
  if (!are_found || !edits.empty() || result.method == Method::sharp_edges) return;
  for (Verdict& verdict : result.verdicts) add_finding(verdict, Grade::look, {NoticeCode::edges_rounded, {}});
}

PatchResult best_candidate(const Situation& s) {
  const auto start = std::chrono::steady_clock::now();
  PatchResult best;
  std::vector<std::string> tried;
  Message why_not_the_first;
  bool is_sound = false;  // the best, which gives way to a good alternative only
  for (const Candidate& candidate : candidates) {
    if (!candidate.applies(s) || (is_sound && !candidate.is_alternative)) continue;
    PatchResult result;
    result.patch = s.initial();
    tried.emplace_back(candidate.name);
    const bool made = candidate.run(s, result);
    if (s.context.cancel.cancelled()) {
      result.status = PatchStatus::cancelled;
      result.attempts = std::move(tried);
      return result;
    }
    const bool kept = made && is_kept(s, result);
    const bool is_good = kept && worst(result.verdicts) == Grade::good;
    if (!is_good && tried.size() == 1) why_not_the_first = fault_of(s, candidate.name, result);
    if (!made) continue;
    result.made_by = candidate.name;
    if (candidate.applies == is_cut) result.reason = reason_of_cut(s);
    if (candidate.applies == is_in_plane_face) result.reason = reason_of_plane();
    if (tried.size() > 1) result.reason = why_not_the_first;
    if (candidate.applies == is_on_sphere)
      result.reason = say("all vertices around lie on one sphere, off which the flow ended: the missing part of the "
                          "sphere was taken")
                          .with_code("sphere");
    if (is_sound ? is_good : kept || best.made_by.empty() || faults(result.verdicts) < faults(best.verdicts))
      best = std::move(result);
    is_sound = is_sound || kept;
    if (is_good || (kept && !(candidate.gives_way && is_judged(s.options) && of_curvature(s)))) break;
  }
  if (best.made_by.empty() || !is_kept(s, best)) {
    PatchResult initial = judged_initial(s.context.problem, s.options, s.context.judge);
    open_folds(s.context, s.options.flow, initial);
    if (best.made_by.empty() || faults(initial.verdicts) < faults(best.verdicts)) {
      initial.message =
          joined(why_not_the_first, ": ", say("the initial patch was kept")).with_code("initial_patch_kept");
      for (Verdict& verdict : initial.verdicts) add_finding(verdict, Grade::look, {NoticeCode::initial_patch_kept, {}});
      best = std::move(initial);
    }
  }
  best.attempts = std::move(tried);
  best.seconds.rejected = std::max(0.0, seconds_since(start) - best.seconds.total);
  return best;
}

/// With the surface around it.
bool lies_on_sphere(const Patch& patch) {
  if (patch.loops.size() != 1) return false;
  const std::optional<Sphere> sphere = sphere_around(patch);
  return sphere && distance_from(*sphere, patch) <= off_sphere;
}

}  // namespace

PatchResult initial_result(const PatchProblem& problem, FlowKind flow) {
  EvolutionOptions options;
  options.flow = flow;
  return judged_initial(problem, options, judge_for(problem, options, ends_of(problem)));
}

void judge_again(const PatchProblem& problem, const EvolutionOptions& options, PatchResult& result) {
  result.verdicts = judge_for(problem, options, ends_of(problem))(result.patch, result.validity, result.seams);
}

void expect_deviation(const EvolutionOptions& options, const CancelToken& cancel, PatchResult& result) {
  if (result.method == Method::mirror_image) {
    result.deviation = expected_mirror_deviation(result);
    judge_deviation(result.patch, result.deviation, result.verdicts);
    return;
  }
  const bool is_calibrated =
      is_judged(options) &&
      (result.method == Method::flow || result.method == Method::split_flow || result.method == Method::robust_fairing);
  if (!is_calibrated || result.verdicts.empty()) return;
  result.deviation = expected_deviation(result.patch, result.seams, result.seams_before, cancel);
  if (!lies_on_sphere(result.patch)) judge_deviation(result.patch, result.deviation, result.verdicts);
}

namespace {

bool may_continue_edges(const Situation& s) {
  return continues_edges(s.options) && s.context.problem.loops.size() == 1 && !s.is_cut();
}

void continue_edges(const LoopEdits& edits, Situation& s) {
  ContinuedEdges continued = continue_sharp_edges(s.initial(), edits, s.context.cancel);
  s.sharp = std::move(continued.patch);
  if (s.sharp) s.sphere.reset();
  s.has_clear_edges = continued.are_clear;
}

}  // namespace

PatchResult solve_patch(const PatchProblem& problem, const EvolutionOptions& options, const Evolution::OnStep& on_step,
                        const CancelToken& cancel) {
  if (problem.initial.free_count == 0) {
    PatchResult result = initial_result(problem, options.flow);
    result.message =
        say("too small to hold a free vertex: closed by triangles between its own vertices").with_code("tiny");
    return result;
  }
  const auto start = std::chrono::steady_clock::now();
  PatchResult mirrored;
  if (problem.mirror_planes && !problem.mirror_planes->empty() && problem.loops.size() == 1)
    mirrored = mirrored_patch(problem, options, cancel);
  const LoopEdits edits =
      continues_edges(options) ? edits_of(problem.scan.model, problem.initial, options.edge_edits) : LoopEdits();
  // A loop with an edge across it is no flat cut.
  std::vector<LoopEnd> ends = edits.drawn.empty() ? ends_of(problem) : std::vector<LoopEnd>();
  std::optional<Sphere> sphere;
  if (is_judged(options) && problem.loops.size() == 1 && edits.empty()) sphere = sphere_around(problem.initial);
  if (sphere) ends.assign(ends.size(), LoopEnd::runs_on);
  const Judge judge = judge_for(problem, options, ends);
  Situation situation{{problem, nullptr, judge, on_step, cancel},
                      options,
                      std::nullopt,
                      std::nullopt,
                      std::nullopt,
                      ends,
                      std::nullopt,
                      sphere,
                      false,
                      is_judged(options) && edits.empty() && bounds_plane_face(problem.initial)};
  if (is_judged(options)) {
    const bool has_edges = may_continue_edges(situation) && !situation.is_in_plane_face;
    if (has_edges && edits.empty())
      situation.two_faces =
          two_plane_faces(problem.scan.model, problem.loops.front(), {problem.initial.grading.density}, cancel);
    if (has_edges && !situation.two_faces) continue_edges(edits, situation);
    if (CleanNeighborhood clean_neighborhood =
            situation.is_in_plane_face ? CleanNeighborhood() : remove_outliers(problem.initial);
        clean_neighborhood.outliers > 0) {
      const SplitEstimate without = estimate_split(clean_neighborhood.patch, cancel);
      if (without.is_exact(SplitEstimate::exact_construction)) {
        situation.split = without;
        situation.options.fits.reset();  // they are of the neighborhood as it is
        situation.clean_neighborhood = std::move(clean_neighborhood);
        situation.context.clean_neighborhood = &*situation.clean_neighborhood;
      }
    }
    if (!situation.split) situation.split = options.split ? options.split : estimate_split(problem.initial, cancel);
    situation.options.split = situation.split;
    if (!problem.loops.empty()) situation.options.literal_relief = SplitEstimate::exact_hole;
  }
  if (situation.is_rough() && !situation.is_cut() && problem.triangles == PatchProblem::Triangles::any)
    situation.triangulation = triangulation_of(problem, cancel);
  const double choice = seconds_since(start);
  PatchResult result = best_candidate(situation);
  if ((situation.is_in_plane_face || situation.two_faces) && result.made_by != plane_face_name &&
      result.made_by != two_faces_name && may_continue_edges(situation) && !cancel.cancelled()) {
    situation.is_in_plane_face = false;  // nor are there two
    situation.two_faces.reset();
    continue_edges(edits, situation);
    std::vector<std::string> attempts = std::move(result.attempts);
    result = best_candidate(situation);
    result.attempts.insert(result.attempts.begin(), attempts.begin(), attempts.begin() + 1);
  }
  result.seconds.choice = choice;
  result.flow = options.flow;
  result.seams_before = judge.initial_seams();
  if (is_filled(mirrored.status) && !cancel.cancelled() && is_copied(result, cancel, mirrored)) {
    mirrored.attempts.insert(mirrored.attempts.end(), result.attempts.begin(), result.attempts.end());
    mirrored.seconds.rejected = result.seconds.total + result.seconds.rejected;
    return mirrored;
  }
  result.mirror = mirrored.mirror;
  result.attempts.insert(result.attempts.begin(), mirrored.attempts.begin(), mirrored.attempts.end());
  make_symmetric(problem, judge, cancel, result);
  if (result.mirror.answer != MirrorFit::Answer::not_asked)
    result.reason = joined(message_of(notice_on(result.mirror)), "; ", std::move(result.reason));
  if (Message missing = why_no_edges(situation, edits); !missing.empty() && result.method != Method::sharp_edges)
    result.reason = joined(std::move(missing), "; ", std::move(result.reason));
  judge_edges(situation, edits, result);
  if (!is_judged(options) && !result.verdicts.empty() && worst(result.verdicts) == Grade::bad &&
      lies_on_sphere(result.patch))
    result.verdicts = judge.expecting_known_surface()(result.patch, result.validity, result.seams);
  if (cancel.cancelled()) result.status = PatchStatus::cancelled;
  return result;
}

}  // namespace loopmend
