// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/tried_advice.h"

#include "core/error.h"
#include "pipeline/hand_bridge.h"
#include "repair/base.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <set>
#include <string>
#include <tuple>
#include <utility>

namespace loopmend {

namespace {

/// Larger ones would make a run several times as long.
constexpr std::size_t most_edges_of_trial = 200, most_triangles_of_trial = 500'000;
constexpr int most_bridges_of_trial = 3, rounds_of_trial = 3;

/// Loops of the model through one of these soup points at least.
std::vector<BoundaryLoop> loops_through(const SurfaceModel& model, const std::vector<BoundaryLoop>& loops,
                                        const std::vector<int>& points) {
  const std::set<int> wanted(points.begin(), points.end());
  std::vector<BoundaryLoop> found;
  for (const BoundaryLoop& loop : loops)
    if (std::ranges::any_of(loop.vertices,
                            [&](int v) { return wanted.contains(model.soup_vertex[static_cast<std::size_t>(v)]); }))
      found.push_back(loop);
  return found;
}

/// Pairs of places on a loop that lie near each other across it and not along it, the nearest first; none beside an earlier one.
std::vector<std::pair<int, int>> waists(const Points& points, const std::vector<int>& loop) {
  const std::size_t count = loop.size(), apart = std::max<std::size_t>(3, count / 6);
  std::vector<std::tuple<double, std::size_t, std::size_t>> pairs;
  for (std::size_t i = 0; i < count; ++i)
    for (std::size_t k = i + apart; k < count && count - (k - i) >= apart; ++k) {
      const double along = static_cast<double>(std::min(k - i, count - (k - i)));
      const Vec3 across = points[static_cast<std::size_t>(loop[k])] - points[static_cast<std::size_t>(loop[i])];
      pairs.emplace_back(across.norm() / along, i, k);
    }
  std::sort(pairs.begin(), pairs.end());
  const auto are_near = [&](std::size_t a, std::size_t b) {
    const std::size_t d = a > b ? a - b : b - a;
    return std::min(d, count - d) < apart / 2 + 1;
  };
  std::vector<std::pair<std::size_t, std::size_t>> chosen;
  for (const auto& [ratio, i, k] : pairs) {
    if (chosen.size() == most_bridges_of_trial) break;
    if (std::ranges::none_of(chosen, [&, a = i, b = k](const auto& one) {
          return (are_near(a, one.first) && are_near(b, one.second)) ||
                 (are_near(b, one.first) && are_near(a, one.second));
        }))
      chosen.emplace_back(i, k);
  }
  std::vector<std::pair<int, int>> result;
  for (const auto& [i, k] : chosen) result.emplace_back(loop[i], loop[k]);
  return result;
}

}  // namespace

bool is_open_for_its_shape(const HoleResult& result) {
  const std::string& code = result.message.code;
  return result.status == PatchStatus::failed && (code == "every_patch_crosses" || code == "boundary_crosses" ||
                                                  code == "no_triangulation" || code == "nonmanifold");
}

Message with_advice(const Message& why_open, Message advice) {
  const bool has_advice = why_open.text == "%1; %2";
  Message result = joined(has_advice ? why_open.arguments.front() : why_open, "; ", std::move(advice));
  return std::move(result).with_code(why_open.code);
}

AdviceTrials::AdviceTrials(TriangleSoup soup, std::vector<std::vector<int>> chosen, PrepareOptions used,
                           FillOptions fill, CancelToken cancel)
    : soup_(std::move(soup)),
      chosen_(std::move(chosen)),
      used_(std::move(used)),
      fill_(std::move(fill)),
      cancel_(std::move(cancel)) {}

bool AdviceTrials::are_small(const std::vector<int>& loop) const {
  return loop.size() <= most_edges_of_trial && soup_.triangles.size() <= most_triangles_of_trial;
}

FillOptions AdviceTrials::options_with(std::optional<SeamContinuity> continuity) const {
  FillOptions options = fill_;
  if (continuity && options.evolution) options.evolution->continuity = *continuity;
  return options;
}

bool AdviceTrials::closes(SurfaceModel model, const std::vector<BoundaryLoop>& loops,
                          const FillOptions& options) const {
  if (loops.empty() || cancel_.cancelled()) return false;
  if (std::ranges::any_of(loops, [](const BoundaryLoop& loop) { return loop.kind == LoopKind::cut; })) return false;
  const std::vector<HoleResult> results = fill_holes(model, loops, options, nullptr, cancel_);
  return !cancel_.cancelled() && !results.empty() && std::ranges::all_of(results, [](const HoleResult& result) {
    return is_filled(result.status) && result.verdict().grade != Grade::bad;
  });
}

/// @param rounds  0: only what runs through the surface
bool AdviceTrials::is_closed_trimmed(const std::vector<int>& loop, const FillOptions& options, int rounds) const {
  const SurfaceModel model = make_surface_model(soup_);
  std::set<int> points;
  for (const std::vector<int>& one : chosen_) points.insert(one.begin(), one.end());
  std::vector<BoundaryLoop> asked = find_boundary_loops(model);
  std::erase_if(asked, [&](const BoundaryLoop& one) {
    return !std::ranges::all_of(one.vertices,
                                [&](int v) { return points.contains(model.soup_vertex[static_cast<std::size_t>(v)]); });
  });
  TrimmedModel trimmed = rounds > 0 ? trim_boundary(model, asked, rounds) : trim_pierced(model, asked);
  if (trimmed.removed.empty()) return false;
  const std::vector<BoundaryLoop> own = loops_through(trimmed.model, trimmed.loops, loop);
  return closes(std::move(trimmed.model), own, options);
}

bool AdviceTrials::is_closed_repaired(const std::vector<int>& loop, const FillOptions& options, Defect more) const {
  std::set<Defect> defects = harmless_repairs;
  defects.insert(more);
  RepairedSurface repaired = repair_surface(soup_, defects, cancel_);
  if (!repaired.counts.any() || cancel_.cancelled()) return false;
  SurfaceModel model = make_surface_model(std::move(repaired.soup));
  const std::vector<BoundaryLoop> own = loops_through(model, find_boundary_loops(model), loop);
  return closes(std::move(model), own, options);
}

std::optional<std::pair<int, int>> AdviceTrials::bridge_that_closes(const std::vector<int>& loop,
                                                                    const FillOptions& options) const {
  const SurfaceModel model = make_surface_model(soup_);
  for (const auto& [a, b] : waists(soup_.points, loop)) {
    try {
      SurfaceModel parted = make_surface_model(with_bridge(model, a, b));
      const std::vector<BoundaryLoop> own = loops_through(parted, find_boundary_loops(parted), loop);
      if (closes(std::move(parted), own, options)) return std::pair(a, b);
    } catch (const InvalidArgument&) {  // no strip fits there
    }
  }
  return std::nullopt;
}

Message AdviceTrials::base_that_closes(const BoundaryLoop& loop, const std::vector<int>& points) const {
  const SurfaceModel model = make_surface_model(soup_);
  const std::vector<BoundaryLoop> own = loops_through(model, find_boundary_loops(model), points);
  if (own.size() != 1 || own.front().number != loop.number) return {};
  for (const double share : {0.05, 0.2}) {
    char distance[32];
    std::snprintf(distance, sizeof distance, "%.2g", share * loop.diameter);
    try {
      with_base(model, own.front(), std::strtod(distance, nullptr));
      return say("--base %1:%2 closes it below the surface", loop.number, distance);
    } catch (const InvalidArgument&) {  // it would cut the surface
    }
  }
  return {};
}

bool AdviceTrials::trimming_closes(const std::vector<int>& loop, std::optional<SeamContinuity> continuity) const {
  try {
    return is_closed_trimmed(loop, options_with(continuity), rounds_of_trial);
  } catch (const InvalidArgument&) {  // nothing would be left
    return false;
  }
}

Message AdviceTrials::untried() const {
  std::string names;
  const auto add = [&](const char* option) { names += (names.empty() ? "" : ", ") + std::string(option); };
  if (!used_.trims()) add("--trim-crossing");
  if (used_.trim_rounds == 0) add("--trim-boundary 3");
  if (used_.repair.empty()) add("--repair");
  if (!used_.repair.contains(Defect::intersections)) add("--cut-intersections");
  add("--bridge A,B");
  return say("not tried, but may help: %1", names);
}

Message AdviceTrials::advice(const BoundaryLoop& loop, const std::vector<int>& points,
                             std::optional<SeamContinuity> continuity) const {
  const FillOptions options = options_with(continuity);
  std::string names;
  // Whether it closes the loop; else its name is kept.
  const auto closes_with = [&](const char* option, const auto& trial) {
    try {
      if (trial()) return true;
    } catch (const InvalidArgument&) {  // nothing would be left
    }
    names += (names.empty() ? "" : ", ") + std::string(option);
    return false;
  };
  const auto trimmed = [&](int rounds) { return [&, rounds] { return is_closed_trimmed(points, options, rounds); }; };
  const auto repaired = [&](Defect more) { return [&, more] { return is_closed_repaired(points, options, more); }; };
  std::optional<std::pair<int, int>> ends;
  const auto bridged = [&] {
    ends = bridge_that_closes(points, options);
    return ends.has_value();
  };
  if (loop.kind == LoopKind::outer_rim)
    if (Message base = base_that_closes(loop, points); !base.empty()) return base;
  if (!used_.trims() && closes_with("--trim-crossing", trimmed(0))) return say("%1 closes it", "--trim-crossing");
  if (used_.trim_rounds == 0 && closes_with("--trim-boundary 3", trimmed(rounds_of_trial)))
    return say("%1 closes it", "--trim-boundary 3");
  if (used_.repair.empty() && closes_with("--repair", repaired(Defect::non_manifold)))
    return say("%1 closes it", "--repair");
  if (!used_.repair.contains(Defect::intersections) &&
      closes_with("--cut-intersections", repaired(Defect::intersections)))
    return say("%1 closes it", "--cut-intersections");
  if (closes_with("--bridge", bridged)) return say("--bridge %1,%2 closes it", ends->first, ends->second);
  return say("%1 would not close it: remove the faces in its way in an editor, and fill again", names);
}

}  // namespace loopmend
