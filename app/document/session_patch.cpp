// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/session_patch.h"

#include <algorithm>
#include <cmath>

namespace loopmend {
namespace {

void fields(auto& stream, Is<Patch> auto& patch) {
  stream.whole(patch.free_count);
  stream.whole(patch.patch_triangles);
  stream.array(patch.positions);
  stream.array(patch.triangles);
  stream.array(patch.ring);
  stream.array(patch.view_vertex);
  stream.list(patch.loops, sizeof(quint64), [&](auto& loop) { stream.array(loop); });
  stream.array(patch.loop_numbers);
  stream.vector(patch.center);
  stream.number(patch.scale);
}

/// @param depth  of arguments within arguments that may still come: a damaged file must not exhaust the stack
void fields(auto& stream, Is<Message> auto& message, int depth = 16) {
  if constexpr (is_reading<decltype(stream)>)
    if (depth == 0) stream.fail(say("a message is nested too deep"));
  stream.text(message.text);
  stream.text(message.code);
  stream.flag(message.is_verbatim);
  stream.list(message.arguments, sizeof(qint32), [&](auto& argument) { fields(stream, argument, depth - 1); });
}

void fields(auto& stream, Is<RunRecipe> auto& run) {
  stream.word(run.flow, FlowKind::mmcvf);
  stream.word(run.mode, EvolutionMode::steps);
  stream.number(run.sigma);
  stream.whole(run.steps);
  stream.word(run.end, RunRecipe::End::unnamed);
  stream.word(run.boundary, BoundaryTrust::robust);
  stream.word(run.continuity, SeamContinuity::curvature);
  stream.word(run.relief.kind, ReliefChoice::Kind::continued);
  stream.whole(run.relief.seed);
  stream.word(run.edges, SharpEdges::rounded);
  stream.word(run.mirror, RunRecipe::Mirror::placed);
  std::vector<int> drawn;
  for (const auto& [a, b] : run.edge_edits.drawn) drawn.insert(drawn.end(), {a, b});
  stream.array(drawn);
  if constexpr (is_reading<decltype(stream)>) {
    if (drawn.size() % 2 != 0) stream.fail(say("a sharp edge has one end only"));
    for (std::size_t k = 0; k < drawn.size(); k += 2) run.edge_edits.drawn.emplace_back(drawn[k], drawn[k + 1]);
  }
  stream.array(run.edge_edits.stopped);
  stream.vector(run.mirror_plane.point);
  stream.vector(run.mirror_plane.normal);
}

void fields(auto& stream, Is<PatchRecipe> auto& recipe) {
  stream.number(recipe.density);
  stream.word(recipe.start, PatchRecipe::Start::bridge);
  stream.list(recipe.runs, sizeof(double), [&](auto& run) { fields(stream, run); });
}

void fields(auto& stream, Is<StepRecord> auto& step) {
  stream.whole(step.step);
  for (auto* x : {&step.energy, &step.sigma, &step.tau, &step.max_move}) stream.number(*x);
}

void fields(auto& stream, Is<SeamReport> auto& seam) {
  for (auto* x :
       {&seam.g1_rms_deg, &seam.g1_max_deg, &seam.h_jump_rms, &seam.h_jump_max, &seam.h_jump_rms_times_diameter})
    stream.number(*x);
}

void fields(auto& stream, Is<Verdict> auto& verdict) {
  stream.word(verdict.grade, Grade::bad);
  bool has_crease = verdict.crease_deg.has_value();
  double crease = verdict.crease_deg.value_or(0);
  stream.flag(has_crease);
  stream.number(crease);
  if constexpr (is_reading<decltype(stream)>)
    verdict.crease_deg = has_crease ? std::optional<double>(crease) : std::nullopt;
  stream.number(verdict.height);
  stream.whole(verdict.folds);
  stream.list(verdict.findings, sizeof(qint32), [&](auto& finding) {
    stream.word(finding.code, NoticeCode::mirror_faulty);
    stream.list(finding.arguments, sizeof(double), [&](auto& argument) { stream.number(argument); });
  });
}

void fields(auto& stream, Is<BoundarySummary> auto& summary) {
  auto& split = summary.split;
  for (auto* x :
       {&split.relief, &split.noise, &split.resolution, &split.edge, &split.radius, &split.relief_height,
        &split.noise_height, &summary.relief, &summary.noise, &summary.relief_per_edge, &summary.noise_per_edge,
        &summary.normal_sigma_deg, &summary.H, &summary.H_sigma, &summary.gradient, &summary.gradient_sigma})
    stream.number(*x);
  stream.whole(summary.fitted);
}

/// All but its patch.
void fields(auto& stream, Is<PatchState> auto& state) {
  stream.word(state.status, PatchStatus::step_limit);
  fields(stream, state.message);
  fields(stream, state.recipe);
  stream.word(state.flow, FlowKind::mmcvf);
  stream.whole(state.steps);
  StepRecord last = state.last_step;
  last.energy = state.energy.final;
  fields(stream, last);
  if constexpr (is_reading<decltype(stream)>) {
    state.last_step = last;
    state.energy.final = last.energy;
  }
  stream.number(state.energy.initial);
  stream.number(state.seconds.total);
  for (auto* reports : {&state.seams_before, &state.seams})
    stream.list(*reports, 5 * sizeof(double), [&](auto& report) { fields(stream, report); });
  stream.list(state.verdicts, 3 * sizeof(double), [&](auto& verdict) { fields(stream, verdict); });
  stream.list(state.deviation.loops, 4 * sizeof(double), [&](auto& e) {
    for (auto* figure : {&e.half, &e.likely, &e.most, &e.predictors.second_order}) stream.number(*figure);
  });
  stream.array(state.deviation.vertices);
  stream.list(state.neighborhood, 16 * sizeof(double), [&](auto& summary) { fields(stream, summary); });
}

bool in_range(const std::vector<int>& values, int low, int high) {
  return std::all_of(values.begin(), values.end(), [=](int v) { return v >= low && v < high; });
}

/// What the engine takes for granted of a patch, and would follow into memory that is not there.
void check_sizes(const SessionReader& in, const Patch& patch) {
  const int n = patch.vertex_count();
  const bool sizes = patch.free_count >= 0 && patch.free_count <= n && patch.patch_triangles >= 0 &&
                     patch.patch_triangles <= static_cast<int>(patch.triangles.size()) &&
                     static_cast<int>(patch.ring.size()) == n && static_cast<int>(patch.view_vertex.size()) == n &&
                     !patch.loops.empty() && patch.loop_numbers.size() == patch.loops.size();
  if (!sizes) in.fail(say("the sizes of a patch disagree"));
}

void check_vertices(const SessionReader& in, const Patch& patch) {
  for (int v = 0; v < patch.vertex_count(); ++v) {
    const auto at = static_cast<std::size_t>(v);
    if (!patch.positions[at].allFinite()) in.fail(say("a coordinate is not a finite number"));
    const bool is_free = v < patch.free_count;
    if (is_free != (patch.ring[at] == 0) || patch.ring[at] < 0 || is_free != (patch.view_vertex[at] == -1))
      in.fail(say("free and fixed vertices of a patch are mixed up"));
  }
}

void check_triangles(const SessionReader& in, const Patch& patch) {
  const int n = patch.vertex_count();
  std::vector<std::pair<int, int>> edges;
  for (const Triangle& t : patch.triangles)
    for (int k = 0; k < 3; ++k) {
      const int from = t[k], to = t[(k + 1) % 3];
      if (from < 0 || from >= n) in.fail(say("a triangle names a vertex that does not exist"));
      if (from == to) in.fail(say("a triangle names a vertex twice"));
      edges.emplace_back(from, to);
    }
  std::sort(edges.begin(), edges.end());
  if (std::adjacent_find(edges.begin(), edges.end()) != edges.end())
    in.fail(say("the triangles of a patch do not fit"));
}

void check_loops(const SessionReader& in, const Patch& patch) {
  for (const auto& loop : patch.loops) {
    if (loop.empty() || !in_range(loop, 0, patch.vertex_count()))
      in.fail(say("a loop names a vertex that does not exist"));
    for (int v : loop)
      if (patch.ring[v] != 1) in.fail(say("a loop is not the boundary of its patch"));
  }
}

void check(const SessionReader& in, const Patch& patch) {
  check_sizes(in, patch);
  check_vertices(in, patch);
  check_triangles(in, patch);
  check_loops(in, patch);
  if (!(patch.scale > 0) || !std::isfinite(patch.scale) || !patch.center.allFinite())
    in.fail(say("the frame of a patch is not known"));
}

void check(const SessionReader& in, const PatchRecipe& recipe) {
  if (!(recipe.density > 0) || !std::isfinite(recipe.density)) in.fail(say("a density is out of range"));
  for (const RunRecipe& run : recipe.runs)
    if (!run.mirror_plane.point.allFinite() || !(std::abs(run.mirror_plane.normal.norm() - 1) < 1e-6))
      in.fail(say("a mirror plane is out of range"));
}

}  // namespace

namespace {

/// What is read of the state fits its patch.
void check(const SessionReader& in, const PatchState& state) {
  check(in, state.recipe);
  if (state.seams.size() != state.patch.loops.size() || state.seams_before.size() != state.seams.size())
    in.fail(say("the seams of a patch are not complete"));
  if (!state.verdicts.empty() && state.verdicts.size() != state.seams.size())
    in.fail(say("the verdicts of a patch are not complete"));
  if (!state.deviation.vertices.empty() &&
      state.deviation.vertices.size() != static_cast<std::size_t>(state.patch.free_count))
    in.fail(say("the likely errors of a patch are not complete"));
}

/// Whether they differ by their free vertices alone.
bool has_same_mesh(const Patch& a, const Patch& b) {
  return a.free_count == b.free_count && a.patch_triangles == b.patch_triangles && a.scale == b.scale &&
         a.center == b.center && a.positions.size() == b.positions.size() && a.ring == b.ring &&
         a.view_vertex == b.view_vertex && a.loops == b.loops && a.loop_numbers == b.loop_numbers &&
         a.triangles == b.triangles &&
         std::equal(a.positions.begin() + a.free_count, a.positions.end(), b.positions.begin() + b.free_count);
}

}  // namespace

void put(SessionWriter& out, const PatchState& state) {
  fields(out, state.patch);
  fields(out, state);
}

PatchStatePtr read_state(SessionReader& in) {
  auto s = std::make_shared<PatchState>();
  fields(in, s->patch);
  check(in, s->patch);
  fields(in, *s);
  check(in, *s);
  s->patch.grading.density = s->recipe.density;
  return s;
}

void put_beside(SessionWriter& out, const PatchState& state, const PatchState& present) {
  const bool is_alike = has_same_mesh(state.patch, present.patch);
  out.flag(is_alike);
  if (is_alike)
    out.array(Points(state.patch.positions.begin(), state.patch.positions.begin() + state.patch.free_count));
  else
    fields(out, state.patch);
  fields(out, state);
}

PatchStatePtr read_state_beside(SessionReader& in, const PatchState& present) {
  auto s = std::make_shared<PatchState>();
  bool is_alike = false;
  in.flag(is_alike);
  if (is_alike) {
    Points free;
    in.array(free);
    s->patch = present.patch;
    if (free.size() != static_cast<std::size_t>(present.patch.free_count))
      in.fail(say("the vertices of a recorded state are not complete"));
    std::copy(free.begin(), free.end(), s->patch.positions.begin());
  } else {
    fields(in, s->patch);
    if (s->patch.loop_numbers != present.patch.loop_numbers)
      in.fail(say("a recorded state is not of the loops of its patch"));
  }
  check(in, s->patch);
  fields(in, *s);
  check(in, *s);
  s->patch.grading.density = s->recipe.density;
  return s;
}

std::size_t size_beside(const PatchState& state, const PatchState& present) {
  constexpr std::size_t of_figures = 500;
  const Patch& patch = state.patch;
  const std::size_t of_errors = state.deviation.vertices.size() * sizeof(state.deviation.vertices.front());
  if (has_same_mesh(patch, present.patch))
    return of_figures + of_errors + static_cast<std::size_t>(patch.free_count) * sizeof(Vec3);
  return of_figures + of_errors + patch.positions.size() * (sizeof(Vec3) + 2 * sizeof(int)) +
         patch.triangles.size() * sizeof(Triangle);
}

}  // namespace loopmend
