// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/session.h"

#include "core/error.h"
#include "document/document.h"
#include "document/file_path.h"
#include "document/session_patch.h"
#include "io/atomic_file.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>

#include <algorithm>
#include <cmath>

namespace loopmend {
namespace {

constexpr char magic[] = "Loopmend session\n";
constexpr qint32 format_version = 12;  ///< no other one is read

using Writer = SessionWriter;
using Reader = SessionReader;

void put(Writer& out, const ColorRange& range) {
  out.put(static_cast<qint32>(range.rule));
  out.put(range.percent);
  out.put(range.half_width);
}

ColorRange color_range(Reader& in) {
  ColorRange range;
  range.rule = in.word(ColorRange::Rule::percentile_each);
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
  out.put(static_cast<qint32>(view.look.up));
}

SessionView session_view(Reader& in) {
  SessionView view;
  for (Vec3* v : {&view.from.focus, &view.from.eye, &view.from.up}) {
    *v = in.vector();
    if (!v->allFinite()) in.fail(say("a coordinate is not a finite number"));
  }
  if (view.from.focus == view.from.eye || !(view.from.up.norm() > 0)) in.fail(say("the view is from nowhere"));
  view.look.shading = in.word(Shading::deviation);
  view.look.edges = in.word(Edges::shown);
  view.look.seams = in.word(Seams::shown);
  view.look.map = in.word(ColorMap::grey);
  view.look.H = color_range(in);
  view.look.K = color_range(in);
  view.look.stripes = in.number<qint32>();
  if (view.look.stripes < 3 || view.look.stripes > 40) in.fail(say("the number of stripes is out of range"));
  view.look.up = in.word(UpAxis::minus_z);
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
  entry.acceptance = in.word(Acceptance::accepted);
  entry.state = read_state(in);
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
