// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/session.h"

#include "core/error.h"
#include "document/document.h"
#include "document/file_path.h"
#include "document/session_stream.h"
#include "io/atomic_file.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>

#include <algorithm>
#include <cmath>

namespace loopmend {
namespace {

constexpr char magic[] = "Loopmend session\n";
constexpr qint32 format_version = 11;  ///< no other one is read

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

template <class E>
E word(Reader& in, E last) {
  const auto value = in.number<qint32>();
  if (value < 0 || value > static_cast<qint32>(last)) in.fail(say("a word is not known"));
  return static_cast<E>(value);
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
  }
}

PatchRecipe recipe(Reader& in) {
  PatchRecipe r;
  r.density = in.number<double>();
  if (!(r.density > 0) || !std::isfinite(r.density)) in.fail(say("a density is out of range"));
  r.start = word(in, PatchRecipe::Start::bridge);
  for (int runs = in.count(sizeof(double)); runs > 0; --runs) {
    RunRecipe run;
    run.flow = word(in, FlowKind::mmcvf);
    run.mode = word(in, EvolutionMode::steps);
    run.sigma = in.number<double>();
    run.steps = in.number<qint32>();
    run.end = word(in, RunRecipe::End::unnamed);
    run.boundary = word(in, BoundaryTrust::robust);
    run.continuity = word(in, SeamContinuity::curvature);
    run.relief.kind = word(in, ReliefChoice::Kind::continued);
    run.relief.seed = in.number<quint64>();
    run.edges = word(in, SharpEdges::rounded);
    run.mirror = word(in, RunRecipe::Mirror::found);
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

void put(Writer& out, const PatchState& state) {
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
  out.put(static_cast<quint64>(state.deviation.vertices.size()));
  for (double distance : state.deviation.vertices) out.put(distance);
}

Verdict verdict(Reader& in) {
  Verdict v;
  v.grade = word(in, Grade::bad);
  for (double* x : {&v.crease_deg, &v.height}) *x = in.number<double>();
  v.folds = in.number<qint32>();
  const int findings = in.count(sizeof(qint32));
  for (int i = 0; i < findings; ++i) {
    Notice finding{word(in, NoticeCode::mirror_faulty), {}};
    const int arguments = in.count(sizeof(double));
    for (int k = 0; k < arguments; ++k) finding.arguments.push_back(in.number<double>());
    v.findings.push_back(std::move(finding));
  }
  return v;
}

PatchStatePtr state(Reader& in) {
  auto s = std::make_shared<PatchState>();
  s->patch = patch(in);
  s->status = word(in, PatchStatus::step_limit);
  s->message = message(in);
  s->recipe = recipe(in);
  s->patch.grading.density = s->recipe.density;
  s->flow = word(in, FlowKind::mmcvf);
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
  for (int vertices = in.count(sizeof(double)); vertices > 0; --vertices)
    s->deviation.vertices.push_back(in.number<double>());
  if (!s->deviation.vertices.empty() &&
      s->deviation.vertices.size() != static_cast<std::size_t>(s->patch.free_count))
    in.fail(say("the likely errors of a patch are not complete"));
  return s;
}

void put(Writer& out, const ColorRange& range) {
  out.put(static_cast<qint32>(range.rule));
  out.put(range.percent);
  out.put(range.half_width);
}

ColorRange color_range(Reader& in) {
  ColorRange range;
  range.rule = word(in, ColorRange::Rule::percentile_each);
  range.percent = in.number<double>();
  range.half_width = in.number<double>();
  if (!(range.percent >= 50 && range.percent <= 100 && range.half_width > 0))
    in.fail(say("a range of colours is not known"));
  return range;
}

void put(Writer& out, const SessionView& view) {
  for (const Vec3* v : {&view.from.focus, &view.from.eye, &view.from.up}) out.put(*v);
  out.put(static_cast<qint32>(view.look.shading));
  out.put(static_cast<qint32>(view.look.edges));
  out.put(static_cast<qint32>(view.look.seams));
  out.put(static_cast<qint32>(view.look.map));
  put(out, view.look.H);
  put(out, view.look.K);
  out.put(static_cast<qint32>(view.look.stripes));
}

SessionView session_view(Reader& in) {
  SessionView view;
  for (Vec3* v : {&view.from.focus, &view.from.eye, &view.from.up}) {
    *v = in.vector();
    if (!v->allFinite()) in.fail(say("a coordinate is not a finite number"));
  }
  if (view.from.focus == view.from.eye || !(view.from.up.norm() > 0)) in.fail(say("the view is from nowhere"));
  view.look.shading = word(in, Shading::deviation);
  view.look.edges = word(in, Edges::shown);
  view.look.seams = word(in, Seams::shown);
  view.look.map = word(in, ColorMap::grey);
  view.look.H = color_range(in);
  view.look.K = color_range(in);
  view.look.stripes = in.number<qint32>();
  if (view.look.stripes < 3 || view.look.stripes > 40) in.fail(say("the number of stripes is out of range"));
  return view;
}

std::shared_ptr<const TriangleSoup> made_surface(Reader& in) {
  auto soup = std::make_shared<TriangleSoup>();
  soup->points = in.array<Vec3>();
  soup->triangles = in.array<Triangle>();
  soup->colors = in.array<Color>();
  const int n = static_cast<int>(soup->points.size());
  for (const Triangle& t : soup->triangles)
    for (int v : t)
      if (v < 0 || v >= n) in.fail(say("a triangle names a vertex that does not exist"));
  for (const Vec3& p : soup->points)
    if (!p.allFinite()) in.fail(say("a coordinate is not a finite number"));
  if (!soup->colors.empty() && soup->colors.size() != soup->points.size()) in.fail(say("the colours are not complete"));
  return soup;
}

QString found(const QString& absolute, const QString& relative, const QString& session) {
  if (absolute.isEmpty() || QFileInfo::exists(absolute)) return absolute;
  const QDir folder = QFileInfo(session).dir();
  for (const QString& place :
       {folder.absoluteFilePath(relative), folder.absoluteFilePath(QFileInfo(absolute).fileName())})
    if (QFileInfo::exists(place)) return QDir::cleanPath(place);
  return absolute;
}

}  // namespace

Session session_of(const Document& document, const ViewSource& view) {
  Session session;
  if (view) session.view = view();
  std::map<int, int> place;
  for (int index : document.scans()) {
    place[index] = static_cast<int>(session.scans.size());
    const auto scan = document.scan(index);
    SessionScan entry{scan->path, scan->fingerprint, scan->name, nullptr, {}, scan->kept};
    if (const auto chosen = document.chosen_units().find(index); chosen != document.chosen_units().end())
      entry.unit = chosen->second;
    // Shares the model: a session may be written while the window goes on.
    if (scan->from == ScanOrigin::made)
      entry.made = std::shared_ptr<const TriangleSoup>(scan->model, &scan->model->soup);
    session.scans.push_back(std::move(entry));
  }
  for (const OpenPatch& patch : document.patches()) {
    SessionPatch entry{place.at(patch.scan), {}, patch.state, patch.acceptance};
    for (int loop : patch.loops) entry.loop_numbers.push_back(document.loop(loop).number);
    session.patches.push_back(std::move(entry));
  }
  return session;
}

QByteArray to_bytes(const Session& session, const QString& beside) {
  QByteArray bytes;
  Writer out(bytes);
  out.raw(magic, sizeof magic - 1);
  out.put(format_version);
  out.put(static_cast<quint64>(session.scans.size()));
  for (const SessionScan& scan : session.scans) {
    out.put(scan.path);
    out.put(scan.path.isEmpty() ? QString() : QDir(beside).relativeFilePath(scan.path));
    out.put(static_cast<quint64>(scan.fingerprint));
    out.put(static_cast<qint32>(scan.made ? 1 : 0));
    if (!scan.made) continue;
    out.put(scan.name);
    out.put(scan.made->points);
    out.put(scan.made->triangles);
    out.put(scan.made->colors);
  }
  out.put(static_cast<quint64>(session.patches.size()));
  for (const SessionPatch& patch : session.patches) {
    out.put(static_cast<qint32>(patch.scan));
    out.put(patch.loop_numbers);
    out.put(static_cast<qint32>(patch.acceptance));
    put(out, *patch.state);
  }
  out.put(static_cast<qint32>(session.view.has_value()));
  if (session.view) put(out, *session.view);
  for (const SessionScan& scan : session.scans) out.put(QString::fromStdString(scan.unit));
  return bytes;
}

namespace {

SessionPatch session_patch(Reader& in, int scans) {
  SessionPatch entry;
  entry.scan = in.number<qint32>();
  if (entry.scan < 0 || entry.scan >= scans) in.fail(say("a patch belongs to no scan"));
  entry.loop_numbers = in.array<int>();
  entry.acceptance = word(in, Acceptance::accepted);
  entry.state = state(in);
  if (entry.loop_numbers.size() != entry.state->patch.loops.size())
    in.fail(say("the loops of a patch are not complete"));
  return entry;
}

Session session_from_bytes(const QByteArray& bytes, const QString& path) {
  constexpr int magic_size = sizeof magic - 1;
  if (!bytes.startsWith(QByteArray::fromRawData(magic, magic_size)))
    throw ReadError(file_path(path), say("this is not a session of Loopmend"), {},
                    say("Choose a file that Loopmend saved."));
  Reader in(bytes.mid(magic_size), path);
  if (in.number<qint32>() != format_version)
    throw ReadError(file_path(path), say("this session is of another version of Loopmend"), {},
                    say("Open it with the version that saved it."));
  Session session;
  const int scans = in.count(sizeof(quint64));
  for (int i = 0; i < scans; ++i) {
    const QString absolute = in.text(), relative = in.text();
    SessionScan entry{found(absolute, relative, path), in.number<quint64>(), {}, nullptr, {}, nullptr};
    if (in.number<qint32>() != 0) {
      entry.name = in.text();
      entry.made = made_surface(in);
    }
    session.scans.push_back(std::move(entry));
  }
  const int patches = in.count(sizeof(quint64));
  for (int i = 0; i < patches; ++i) session.patches.push_back(session_patch(in, scans));
  if (in.number<qint32>() != 0) session.view = session_view(in);
  for (SessionScan& scan : session.scans) {
    scan.unit = in.text().toStdString();
    if (!scan.unit.empty() && !is_length_unit(scan.unit)) in.fail(say("a unit of length is not known"));
  }
  if (!in.at_end()) in.fail(say("there is more in the file than there should be"));
  return session;
}

}  // namespace

Session session_from_file(const QString& path) {
  QFile file(path);
  if (!file.open(QIODevice::ReadOnly))
    throw ReadError(file_path(path), verbatim(file.errorString().toStdString()), {},
                    say("Check the path and its permissions."));
  const QByteArray bytes = file.readAll();
  if (!is_packed(bytes)) return session_from_bytes(bytes, path);
  const UnpackedSession unpacked = unpack(bytes, path);
  Session session = session_from_bytes(unpacked.session, path);
  for (std::size_t k = 0; k < std::min(session.scans.size(), unpacked.files.size()); ++k)
    session.scans[k].file = unpacked.files[k];
  return session;
}

void keep_scans(Session& session, KeepScans keep) {
  for (SessionScan& scan : session.scans) {
    if (scan.made || scan.path.isEmpty()) continue;
    const bool elsewhere = QFileInfo::exists(scan.path);
    if (keep == KeepScans::outside && elsewhere) scan.file = nullptr;
    if (keep == KeepScans::inside && elsewhere && !scan.file) scan.file = keep_file(scan.path);
  }
}

void write_session(const Session& session, const QString& path, const CancelToken& cancel) {
  QByteArray bytes = to_bytes(session, QFileInfo(path).absolutePath());
  std::vector<KeptFilePtr> files;
  for (const SessionScan& scan : session.scans) files.push_back(scan.file);
  if (std::any_of(files.begin(), files.end(), [](const KeptFilePtr& file) { return file != nullptr; }))
    bytes = pack(bytes, files);
  if (cancel.cancelled()) return;
  OutputTransaction output;
  output.add(file_path(path), [&bytes](std::ostream& out) { out.write(bytes.constData(), bytes.size()); });
  if (!cancel.cancelled()) output.commit();
}

bool is_session_path(const QString& path) {
  return QFileInfo(path).suffix().compare(QLatin1String(session_suffix), Qt::CaseInsensitive) == 0;
}

}  // namespace loopmend
