// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/session_patch.h"

#include <algorithm>
#include <cmath>

namespace loopmend {
namespace {

using Writer = SessionWriter;
using Reader = SessionReader;

void put(Writer& out, const SeamReport& seam) {
  for (double x : {seam.g1_rms_deg, seam.g1_max_deg, seam.h_jump_rms, seam.h_jump_max, seam.h_jump_rms_times_diameter})
    out.put(x);
}

SeamReport seam(Reader& in) {
  SeamReport s;
  for (double* x : {&s.g1_rms_deg, &s.g1_max_deg, &s.h_jump_rms, &s.h_jump_max, &s.h_jump_rms_times_diameter})
    *x = in.number<double>();
  return s;
}

void put(Writer& out, const Verdict& verdict) {
  out.put(static_cast<qint32>(verdict.grade));
  for (double x : {verdict.crease_deg, verdict.height}) out.put(x);
  out.put(static_cast<qint32>(verdict.folds));
  out.put(static_cast<quint64>(verdict.findings.size()));
  for (const Notice& finding : verdict.findings) {
    out.put(static_cast<qint32>(finding.code));
    out.put(static_cast<quint64>(finding.arguments.size()));
    for (double argument : finding.arguments) out.put(argument);
  }
}

void put(Writer& out, const Patch& patch) {
  out.put(static_cast<qint32>(patch.free_count));
  out.put(static_cast<qint32>(patch.patch_triangles));
  out.put(patch.positions);
  out.put(patch.triangles);
  out.put(patch.ring);
  out.put(patch.view_vertex);
  out.put(static_cast<quint64>(patch.loops.size()));
  for (const auto& loop : patch.loops) out.put(loop);
  out.put(patch.loop_numbers);
  out.put(patch.center);
  out.put(patch.scale);
}

bool in_range(const std::vector<int>& values, int low, int high) {
  return std::all_of(values.begin(), values.end(), [=](int v) { return v >= low && v < high; });
}

/// What the engine takes for granted of a patch, and would follow into memory that is not there.
void check_sizes(const Reader& in, const Patch& patch) {
  const int n = patch.vertex_count();
  const bool sizes = patch.free_count >= 0 && patch.free_count <= n && patch.patch_triangles >= 0 &&
                     patch.patch_triangles <= static_cast<int>(patch.triangles.size()) &&
                     static_cast<int>(patch.ring.size()) == n && static_cast<int>(patch.view_vertex.size()) == n &&
                     !patch.loops.empty() && patch.loop_numbers.size() == patch.loops.size();
  if (!sizes) in.fail(say("the sizes of a patch disagree"));
}

void check_vertices(const Reader& in, const Patch& patch) {
  for (int v = 0; v < patch.vertex_count(); ++v) {
    const auto at = static_cast<std::size_t>(v);
    if (!patch.positions[at].allFinite()) in.fail(say("a coordinate is not a finite number"));
    const bool is_free = v < patch.free_count;
    if (is_free != (patch.ring[at] == 0) || patch.ring[at] < 0 || is_free != (patch.view_vertex[at] == -1))
      in.fail(say("free and fixed vertices of a patch are mixed up"));
  }
}

void check_triangles(const Reader& in, const Patch& patch) {
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

void check_loops(const Reader& in, const Patch& patch) {
  for (const auto& loop : patch.loops) {
    if (loop.empty() || !in_range(loop, 0, patch.vertex_count()))
      in.fail(say("a loop names a vertex that does not exist"));
    for (int v : loop)
      if (patch.ring[static_cast<std::size_t>(v)] != 1) in.fail(say("a loop is not the boundary of its patch"));
  }
}

void check(const Reader& in, const Patch& patch) {
  check_sizes(in, patch);
  check_vertices(in, patch);
  check_triangles(in, patch);
  check_loops(in, patch);
  if (!(patch.scale > 0) || !std::isfinite(patch.scale) || !patch.center.allFinite())
    in.fail(say("the frame of a patch is not known"));
}

Patch patch(Reader& in) {
  Patch p;
  p.free_count = in.number<qint32>();
  p.patch_triangles = in.number<qint32>();
  p.positions = in.array<Vec3>();
  p.triangles = in.array<Triangle>();
  p.ring = in.array<int>();
  p.view_vertex = in.array<int>();
  const int loops = in.count(sizeof(quint64));
  for (int i = 0; i < loops; ++i) p.loops.push_back(in.array<int>());
  p.loop_numbers = in.array<int>();
  p.center = in.vector();
  p.scale = in.number<double>();
  check(in, p);
  return p;
}

void put(Writer& out, const PatchRecipe& recipe) {
  out.put(recipe.density);
  out.put(static_cast<qint32>(recipe.start));
  out.put(static_cast<quint64>(recipe.runs.size()));
  for (const RunRecipe& run : recipe.runs) {
    out.put(static_cast<qint32>(run.flow));
    out.put(static_cast<qint32>(run.mode));
    out.put(run.sigma);
    out.put(static_cast<qint32>(run.steps));
    out.put(static_cast<qint32>(run.end));
    out.put(static_cast<qint32>(run.boundary));
    out.put(static_cast<qint32>(run.continuity));
    out.put(static_cast<qint32>(run.relief.kind));
    out.put(static_cast<quint64>(run.relief.seed));
    for (const qint32 word : {static_cast<qint32>(run.edges), static_cast<qint32>(run.mirror)}) out.put(word);
    std::vector<int> drawn;
    for (const auto& [a, b] : run.edge_edits.drawn) drawn.insert(drawn.end(), {a, b});
    out.put(drawn);
    out.put(run.edge_edits.stopped);
    out.put(run.mirror_plane.point);
    out.put(run.mirror_plane.normal);
  }
}

PatchRecipe recipe(Reader& in) {
  PatchRecipe r;
  r.density = in.number<double>();
  if (!(r.density > 0) || !std::isfinite(r.density)) in.fail(say("a density is out of range"));
  r.start = in.word(PatchRecipe::Start::bridge);
  for (int runs = in.count(sizeof(double)); runs > 0; --runs) {
    RunRecipe run;
    run.flow = in.word(FlowKind::mmcvf);
    run.mode = in.word(EvolutionMode::steps);
    run.sigma = in.number<double>();
    run.steps = in.number<qint32>();
    run.end = in.word(RunRecipe::End::unnamed);
    run.boundary = in.word(BoundaryTrust::robust);
    run.continuity = in.word(SeamContinuity::curvature);
    run.relief.kind = in.word(ReliefChoice::Kind::continued);
    run.relief.seed = in.number<quint64>();
    run.edges = in.word(SharpEdges::rounded);
    run.mirror = in.word(RunRecipe::Mirror::placed);
    const std::vector<int> drawn = in.array<int>();
    if (drawn.size() % 2 != 0) in.fail(say("a sharp edge has one end only"));
    for (std::size_t k = 0; k < drawn.size(); k += 2) run.edge_edits.drawn.emplace_back(drawn[k], drawn[k + 1]);
    run.edge_edits.stopped = in.array<int>();
    run.mirror_plane.point = in.vector();
    run.mirror_plane.normal = in.vector();
    if (!run.mirror_plane.point.allFinite() || !(std::abs(run.mirror_plane.normal.norm() - 1) < 1e-6))
      in.fail(say("a mirror plane is out of range"));
    r.runs.push_back(run);
  }
  return r;
}

void put(Writer& out, const StepRecord& step) {
  out.put(static_cast<qint32>(step.step));
  for (double x : {step.energy, step.sigma, step.tau, step.max_move}) out.put(x);
}

StepRecord step(Reader& in) {
  StepRecord s;
  s.step = in.number<qint32>();
  for (double* x : {&s.energy, &s.sigma, &s.tau, &s.max_move}) *x = in.number<double>();
  return s;
}

void put(Writer& out, const Message& message) {
  for (const std::string* text : {&message.text, &message.code}) out.put(QString::fromStdString(*text));
  out.put(static_cast<qint32>(message.is_verbatim));
  out.put(static_cast<quint64>(message.arguments.size()));
  for (const Message& argument : message.arguments) put(out, argument);
}

/// @param depth  of arguments within arguments that may still come: a damaged file must not exhaust the stack
Message message(Reader& in, int depth = 16) {
  if (depth == 0) in.fail(say("a message is nested too deep"));
  Message m;
  for (std::string* text : {&m.text, &m.code}) *text = in.text().toStdString();
  m.is_verbatim = in.number<qint32>() != 0;
  for (int arguments = in.count(sizeof(qint32)); arguments > 0; --arguments)
    m.arguments.push_back(message(in, depth - 1));
  return m;
}

Verdict verdict(Reader& in) {
  Verdict v;
  v.grade = in.word(Grade::bad);
  for (double* x : {&v.crease_deg, &v.height}) *x = in.number<double>();
  v.folds = in.number<qint32>();
  const int findings = in.count(sizeof(qint32));
  for (int i = 0; i < findings; ++i) {
    Notice finding{in.word(NoticeCode::mirror_faulty), {}};
    const int arguments = in.count(sizeof(double));
    for (int k = 0; k < arguments; ++k) finding.arguments.push_back(in.number<double>());
    v.findings.push_back(std::move(finding));
  }
  return v;
}

}  // namespace

void put(SessionWriter& out, const PatchState& state) {
  put(out, state.patch);
  out.put(static_cast<qint32>(state.status));
  put(out, state.message);
  put(out, state.recipe);
  out.put(static_cast<qint32>(state.flow));
  out.put(static_cast<qint32>(state.steps));
  StepRecord last = state.last_step;
  last.energy = state.energy.final;
  put(out, last);
  out.put(state.energy.initial);
  out.put(state.seconds.total);
  for (const auto* reports : {&state.seams_before, &state.seams}) {
    out.put(static_cast<quint64>(reports->size()));
    for (const SeamReport& report : *reports) put(out, report);
  }
  out.put(static_cast<quint64>(state.verdicts.size()));
  for (const Verdict& verdict : state.verdicts) put(out, verdict);
  out.put(static_cast<quint64>(state.deviation.loops.size()));
  for (const auto& e : state.deviation.loops)
    for (double figure : {e.half, e.likely, e.most, e.second_order}) out.put(figure);
  out.put(state.deviation.vertices);
}

PatchStatePtr read_state(SessionReader& in) {
  auto s = std::make_shared<PatchState>();
  s->patch = patch(in);
  s->status = in.word(PatchStatus::step_limit);
  s->message = message(in);
  s->recipe = recipe(in);
  s->patch.grading.density = s->recipe.density;
  s->flow = in.word(FlowKind::mmcvf);
  s->steps = in.number<qint32>();
  s->last_step = step(in);
  s->energy = {in.number<double>(), s->last_step.energy};
  s->seconds.total = in.number<double>();
  for (auto* reports : {&s->seams_before, &s->seams}) {
    const int count = in.count(5 * sizeof(double));
    for (int i = 0; i < count; ++i) reports->push_back(seam(in));
  }
  if (s->seams.size() != s->patch.loops.size() || s->seams_before.size() != s->seams.size())
    in.fail(say("the seams of a patch are not complete"));
  for (int verdicts = in.count(3 * sizeof(double)); verdicts > 0; --verdicts) s->verdicts.push_back(verdict(in));
  if (!s->verdicts.empty() && s->verdicts.size() != s->seams.size())
    in.fail(say("the verdicts of a patch are not complete"));
  for (int loops = in.count(4 * sizeof(double)); loops > 0; --loops) {
    ExpectedDeviation& e = s->deviation.loops.emplace_back();
    for (double* figure : {&e.half, &e.likely, &e.most, &e.second_order}) *figure = in.number<double>();
  }
  s->deviation.vertices = in.array<double>();
  if (!s->deviation.vertices.empty() && s->deviation.vertices.size() != static_cast<std::size_t>(s->patch.free_count))
    in.fail(say("the likely errors of a patch are not complete"));
  return s;
}

}  // namespace loopmend
