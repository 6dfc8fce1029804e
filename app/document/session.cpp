// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/session.h"

#include "core/error.h"
#include "document/document.h"
#include "document/file_path.h"
#include "document/session_patch.h"
#include "document/timeline.h"
#include "io/atomic_file.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>

#include <algorithm>

namespace loopmend {
namespace {

constexpr char magic[] = "Loopmend session\n";
constexpr int format_version = 19;  ///< no other one is read

void fields(auto& stream, Is<ColorRange> auto& range) {
  stream.word(range.rule, ColorRange::Rule::percentile_each);
  stream.number(range.percent);
  stream.number(range.half_width);
}

void fields(auto& stream, Is<SessionView> auto& view) {
  for (auto* v : {&view.from.focus, &view.from.eye, &view.from.up}) stream.vector(*v);
  stream.word(view.look.shading, Shading::deviation);
  stream.word(view.look.edges, Edges::shown);
  stream.word(view.look.seams, Seams::shown);
  stream.word(view.look.map, ColorMap::grey);
  fields(stream, view.look.H);
  fields(stream, view.look.K);
  stream.whole(view.look.stripes);
  stream.word(view.look.up, UpAxis::minus_z);
}

void fields(auto& stream, Is<std::map<int, SeamContinuity>> auto& shapes) {
  std::vector<std::pair<int, SeamContinuity>> all(shapes.begin(), shapes.end());
  stream.list(all, sizeof(qint32), [&](auto& of_loop) {
    stream.whole(of_loop.first);
    stream.word(of_loop.second, SeamContinuity::curvature);
  });
  if constexpr (is_reading<decltype(stream)>) shapes = {all.begin(), all.end()};
}

void fields(auto& stream, Is<TriangleSoup> auto& surface) {
  stream.array(surface.points);
  stream.array(surface.triangles);
  stream.array(surface.colors);
}

void check(const SessionReader& in, const SessionView& view) {
  const Viewpoint& from = view.from;
  if (!from.focus.allFinite() || !from.eye.allFinite() || !from.up.allFinite())
    in.fail(say("a coordinate is not a finite number"));
  if (from.focus == from.eye || !(from.up.norm() > 0)) in.fail(say("the view is from nowhere"));
  for (const ColorRange* range : {&view.look.H, &view.look.K})
    if (!(range->percent >= 50 && range->percent <= 100 && range->half_width > 0))
      in.fail(say("a range of colours is not known"));
  if (view.look.stripes < 3 || view.look.stripes > 40) in.fail(say("the number of stripes is out of range"));
}

void check(const SessionReader& in, const TriangleSoup& surface) {
  const int n = static_cast<int>(surface.points.size());
  for (const Triangle& t : surface.triangles)
    for (int v : t)
      if (v < 0 || v >= n) in.fail(say("a triangle names a vertex that does not exist"));
  for (const Vec3& p : surface.points)
    if (!p.allFinite()) in.fail(say("a coordinate is not a finite number"));
  if (!surface.colors.empty() && surface.colors.size() != surface.points.size())
    in.fail(say("the colours are not complete"));
}

QString found(const QString& absolute, const QString& relative, const QString& session) {
  if (absolute.isEmpty() || QFileInfo::exists(absolute)) return absolute;
  const QDir folder = QFileInfo(session).dir();
  for (const QString& place :
       {folder.absoluteFilePath(relative), folder.absoluteFilePath(QFileInfo(absolute).fileName())})
    if (QFileInfo::exists(place)) return QDir::cleanPath(place);
  return absolute;
}

std::size_t bytes_recorded(const Session& session) {
  std::size_t sum = 0;
  for (const SessionPatch& patch : session.patches)
    for (const PatchStatePtr& state : patch.timeline)
      if (state != patch.state) sum += size_beside(*state, *patch.state);
  return sum;
}

/// Within a bound. The state that a patch is in stays in its timeline.
void thin_timelines(Session& session, std::size_t most) {
  while (bytes_recorded(session) > most) {
    bool any = false;
    for (SessionPatch& patch : session.patches) {
      Timeline fewer = thinned(patch.timeline, patch.state);
      any = any || fewer.size() < patch.timeline.size();
      patch.timeline = std::move(fewer);
    }
    if (any) continue;
    for (SessionPatch& patch : session.patches) patch.timeline.clear();
  }
}

}  // namespace

Session session_of(const Document& document, const ViewSource& view, std::size_t recorded) {
  Session session;
  if (view) session.view = view();
  std::map<int, int> place;
  for (int index : document.scans()) {
    place[index] = static_cast<int>(session.scans.size());
    const auto scan = document.scan(index);
    SessionScan entry{scan->path, scan->fingerprint, scan->name, nullptr, {}, scan->kept};
    for (const auto& [loop, shape] : document.chosen_shapes())
      if (document.scan_of(loop) == index) entry.shapes.emplace(document.loop(loop).number, shape);
    if (const auto chosen = document.chosen_units().find(index); chosen != document.chosen_units().end())
      entry.unit = chosen->second;
    // Shares the model: a session may be written while the window goes on.
    if (scan->from == ScanOrigin::made)
      entry.made = std::shared_ptr<const TriangleSoup>(scan->model, &scan->model->soup);
    session.scans.push_back(std::move(entry));
  }
  for (const OpenPatch& patch : document.patches()) {
    SessionPatch entry{place.at(patch.scan), {}, patch.state, patch.acceptance, {}};
    if (patch.timeline->size() > 1) entry.timeline = *patch.timeline;
    for (int loop : patch.loops) entry.loop_numbers.push_back(document.loop(loop).number);
    session.patches.push_back(std::move(entry));
  }
  thin_timelines(session, recorded);
  return session;
}

QByteArray to_bytes(const Session& session, const QString& beside) {
  QByteArray bytes;
  SessionWriter out(bytes);
  out.raw(magic, sizeof magic - 1);
  out.whole(format_version);
  out.list(session.scans, 0, [&](const SessionScan& scan) {
    out.text(scan.path);
    out.text(scan.path.isEmpty() ? QString() : QDir(beside).relativeFilePath(scan.path));
    out.whole(scan.fingerprint);
    out.flag(scan.made != nullptr);
    if (!scan.made) return;
    out.text(scan.name);
    fields(out, *scan.made);
  });
  out.list(session.patches, 0, [&](const SessionPatch& patch) {
    out.whole(patch.scan);
    out.array(patch.loop_numbers);
    out.word(patch.acceptance, Acceptance::accepted);
    put(out, *patch.state);
    out.list(patch.timeline, 0, [&](const PatchStatePtr& state) {
      out.flag(state == patch.state);
      if (state != patch.state) put_beside(out, *state, *patch.state);
    });
  });
  out.flag(session.view.has_value());
  if (session.view) fields(out, *session.view);
  for (const SessionScan& scan : session.scans) {
    out.text(scan.unit);
    fields(out, scan.shapes);
  }
  return bytes;
}

namespace {

/// @param size  of all recorded states that were read, bytes of memory: a file may need few for many
void read_timeline(SessionReader& in, SessionPatch& patch, std::size_t& size) {
  constexpr std::size_t most_states = 10000, most_in_memory = std::size_t{1} << 30;
  int present = 0;
  in.list(patch.timeline, sizeof(qint32), [&](PatchStatePtr& state) {
    bool is_present = false;
    in.flag(is_present);
    present += is_present;
    state = is_present ? patch.state : read_state_beside(in, *patch.state);
    size += size_of(*state);
    if (patch.timeline.size() > most_states || size > most_in_memory)
      in.fail(say("there are more recorded states than there should be"));
  });
  if (present != (patch.timeline.empty() ? 0 : 1)) in.fail(say("the recorded states of a patch are not complete"));
}

Session session_from_bytes(const QByteArray& bytes, const QString& path) {
  constexpr int magic_size = sizeof magic - 1;
  if (!bytes.startsWith(QByteArray::fromRawData(magic, magic_size)))
    throw ReadError(file_path(path), say("this is not a session of Loopmend"), {},
                    say("Choose a file that Loopmend saved."));
  SessionReader in(bytes.mid(magic_size), path);
  if (in.taken<qint32>() != format_version)
    throw ReadError(file_path(path), say("this session is of another version of Loopmend"), {},
                    say("Open it with the version that saved it."));
  Session session;
  in.list(session.scans, sizeof(quint64), [&](SessionScan& scan) {
    const auto absolute = in.taken<QString>(), relative = in.taken<QString>();
    scan.path = found(absolute, relative, path);
    in.whole(scan.fingerprint);
    bool is_made = false;
    in.flag(is_made);
    if (!is_made) return;
    in.text(scan.name);
    const auto surface = std::make_shared<TriangleSoup>();
    fields(in, *surface);
    check(in, *surface);
    scan.made = surface;
  });
  std::size_t size = 0;
  in.list(session.patches, sizeof(quint64), [&](SessionPatch& patch) {
    in.whole(patch.scan);
    if (patch.scan < 0 || patch.scan >= static_cast<int>(session.scans.size()))
      in.fail(say("a patch belongs to no scan"));
    in.array(patch.loop_numbers);
    in.word(patch.acceptance, Acceptance::accepted);
    patch.state = read_state(in);
    if (patch.loop_numbers.size() != patch.state->patch.loops.size())
      in.fail(say("the loops of a patch are not complete"));
    read_timeline(in, patch, size);
  });
  bool has_view = false;
  in.flag(has_view);
  if (has_view) {
    fields(in, session.view.emplace());
    check(in, *session.view);
  }
  for (SessionScan& scan : session.scans) {
    in.text(scan.unit);
    fields(in, scan.shapes);
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
