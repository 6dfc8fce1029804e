// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/fill_report.h"

#include "core/version.h"
#include "document/command_line.h"
#include "document/labels.h"
#include "document/laid_points.h"
#include "document/message_words.h"
#include "document/targets.h"
#include "operators/curvature_energy.h"

#include <QBuffer>
#include <QCoreApplication>
#include <QDateTime>
#include <QLocale>

#include <Eigen/Geometry>

#include <algorithm>
#include <utility>

namespace loopmend {
namespace {

constexpr int most_named = 200;  ///< of open loops

QString tr(const char* text, int n = -1) { return QCoreApplication::translate("loopmend", text, nullptr, n); }

double area_of(const TriangleSoup& soup) {
  double area = 0;
  for (const Triangle& t : soup.triangles) {
    const auto corner = [&](std::size_t k) -> const Vec3& { return soup.points[t[k]]; };
    area += 0.5 * (corner(1) - corner(0)).cross(corner(2) - corner(0)).norm();
  }
  return area;
}

/// In the order in which a person should look at them.
enum class Rank { bad, look, not_judged, good };

Rank rank_of(const Document& document, int loop) {
  if (document.state(loop) == HoleState::cutting) return Rank::bad;
  const Verdict* verdict = document.verdict(loop);
  if (!verdict) return Rank::not_judged;
  switch (verdict->grade) {
    case Grade::bad: return Rank::bad;
    case Grade::look: return Rank::look;
    case Grade::good: break;
  }
  return Rank::good;
}

QString color_of(const Document& document, int loop) {
  switch (rank_of(document, loop)) {
    case Rank::bad: return QStringLiteral("#b3261e");
    case Rank::look: return QStringLiteral("#9a6700");
    case Rank::not_judged: return QStringLiteral("#5f6368");
    case Rank::good: break;
  }
  return QStringLiteral("#1f7a3d");
}

FillReport::Hole hole_of(const Document& document, int loop) {
  const OpenPatch& patch = *document.patch_of(loop);
  const PatchState& state = *patch.state;
  const BoundaryLoop& boundary = document.loop(loop);
  FillReport::Hole hole{loop,
                        labels::sentence(labels::holes(document, {loop})),
                        labels::verdict_or_state(document, loop),
                        color_of(document, loop),
                        {},
                        {}};
  const auto add = [&](const QString& line) {
    if (!line.isEmpty()) hole.lines << line;
  };
  const Verdict* verdict = document.verdict(loop);
  if (verdict) add(labels::sentence_of(*verdict));
  if (document.state(loop) == HoleState::cutting) add(labels::state_help(HoleState::cutting));
  add(tr("Boundary of %1 edges, %2 in diameter.")
          .arg(labels::count(static_cast<std::size_t>(boundary.edges())), labels::length(document, boundary.diameter)));
  const std::size_t place = patch.place_of(loop);
  if (place < state.seams.size() && place < state.seams_before.size())
    add(labels::seam_sentence(state.seams_before[place], state.seams[place], state.status,
                              verdict ? verdict->grade : Grade::good));
  add(labels::deviation_sentence(document.deviation(loop)));
  const QString size = tr("New: %1 vertices, %2 triangles.")
                           .arg(labels::count(static_cast<std::size_t>(state.patch.free_count)),
                                labels::count(static_cast<std::size_t>(state.patch.patch_triangles)));
  add(patch.loops.size() > 1 ? tr("%1 This patch closes %2 as one.").arg(size, labels::holes(document, loops_of(patch)))
                             : size);
  if (const QString message = labels::in_words(document.message(loop)); !message.isEmpty())
    add(labels::sentence(message) + (message.endsWith(QLatin1Char('.')) ? QString() : QStringLiteral(".")));
  return hole;
}

/// Loops with a patch: bad, to look at, not judged, good; each by falling size.
std::vector<int> loops_in_order(const Document& document) {
  std::vector<int> loops;
  for (int loop = 0; loop < document.loop_count(); ++loop)
    if (document.present(loop) && document.patch_of(loop)) loops.push_back(loop);
  std::stable_sort(loops.begin(), loops.end(), [&](int a, int b) {
    return std::pair(rank_of(document, a), -document.loop(a).diameter) <
           std::pair(rank_of(document, b), -document.loop(b).diameter);
  });
  return loops;
}

/// Bridges are as new as patches are, though they are faces of the scan.
QString size_of_patches(const FillReport& report) {
  double area = 0, added = 0;
  std::size_t triangles = 0, new_triangles = 0;
  LaidTriangles laid;
  for (std::size_t k = 0; k < report.models.size(); ++k) {
    const TriangleSoup& soup = report.models[k]->soup;
    const LaidTriangles own = laid_triangles(soup, report.laid[k]);
    laid.count += own.count;
    laid.area += own.area;
    area += area_of(soup) - own.area;
    triangles += soup.triangles.size() - own.count;
  }
  for (const PatchStatePtr& state : report.patches) {
    added += patch_area(state->patch) * state->patch.scale * state->patch.scale;
    new_triangles += static_cast<std::size_t>(state->patch.patch_triangles);
  }
  const double all = area + added + laid.area;
  const QString share = labels::number(all > 0 ? 100 * (added + laid.area) / all : 0);
  const QString scan = labels::count(triangles), patches = labels::count(new_triangles);
  if (laid.count == 0)
    return tr("The scan has %1 triangles. The patches add %2 triangles; they are %3 % of the whole area.")
        .arg(scan, patches, share);
  return tr("The scan has %1 triangles. The patches add %2 triangles; bridges, and patches that became a part of the "
            "scan, have %3. Together these are %4 % of the whole area.")
      .arg(scan, patches, labels::count(laid.count), share);
}

/// @param unnamed  open loops beside those that the report names
QStringList facts_of(const Document& document, const FillReport& report, std::size_t unnamed) {
  QStringList facts;
  const auto count = [&](Rank rank) {
    return std::count_if(report.holes.begin(), report.holes.end(),
                         [&](const FillReport::Hole& hole) { return rank_of(document, hole.loop) == rank; });
  };
  const auto left_out = static_cast<std::size_t>(loops_left_out(document));
  facts << tr("Holes with a patch: %1 (%2 good, %3 to look at, %4 bad, %5 not judged). Open: %6. Left out: %7.")
               .arg(report.holes.size())
               .arg(count(Rank::good))
               .arg(count(Rank::look))
               .arg(count(Rank::bad))
               .arg(count(Rank::not_judged))
               .arg(static_cast<std::size_t>(report.open.size()) + unnamed - left_out)
               .arg(left_out);
  const std::vector<int> scans = document.scans();
  const bool is_changed = std::any_of(scans.begin(), scans.end(), [&](int scan) {
    return !document.scan(scan)->repaired_from.isEmpty() || document.scan(scan)->from == ScanOrigin::made;
  });
  facts << (is_changed ? tr("The scan was changed before its holes were filled: this page shows the patches alone.")
                       : tr("The vertices of the scan are where they were; only the patches shown here are new."));
  const QString unit = labels::unit_name(document.unit());
  facts << (document.unit().empty() ? tr("The unit of lengths is not known.") : tr("Lengths are in %1.").arg(unit));
  facts << tr("Loopmend %1, %2.")
               .arg(QLatin1String(version()), QLocale().toString(QDateTime::currentDateTime(), QLocale::LongFormat));
  return facts;
}

QString paragraph(const QString& text) {
  return QStringLiteral("<p>%1</p>\n").arg(text.toHtmlEscaped().replace(QLatin1Char('\n'), QLatin1String("<br>")));
}

QString picture_of(const FillReport::Hole& hole, std::size_t place, PictureLinks links) {
  if (hole.picture.isNull()) return {};
  QString source = QStringLiteral("picture:%1").arg(place);
  if (links == PictureLinks::within) {
    QByteArray bytes;
    QBuffer buffer(&bytes);
    hole.picture.save(&buffer, "PNG");
    source = QStringLiteral("data:image/png;base64,") + QString::fromLatin1(bytes.toBase64());
  }
  return QStringLiteral("<img src=\"%1\" width=\"300\" height=\"200\" alt=\"%2\">")
      .arg(source, hole.name.toHtmlEscaped());
}

}  // namespace

FillReport fill_report(const Document& document) {
  FillReport report;
  QStringList names;
  for (int scan : document.scans()) {
    names << document.scan(scan)->name;
    report.models.push_back(document.scan(scan)->model);
    report.laid.push_back(document.scan(scan)->laid);
  }
  report.title = tr("Holes of %1").arg(names.join(QStringLiteral(", ")));
  for (int loop : loops_in_order(document)) report.holes.push_back(hole_of(document, loop));
  std::size_t unnamed = 0;
  for (int loop = 0; loop < document.loop_count(); ++loop) {
    if (!document.present(loop) || document.patch_of(loop)) continue;
    if (report.open.size() == most_named) {
      ++unnamed;
      continue;
    }
    const QString why = labels::in_words(document.message(loop));
    const QString line =
        tr("%1: %2, %3 in diameter")
            .arg(labels::sentence(labels::holes(document, {loop})), labels::kind(document.loop(loop).kind),
                 labels::length(document, document.loop(loop).diameter));
    report.open << (why.isEmpty() ? line : line + QStringLiteral(": ") + why) + QLatin1Char('.');
  }
  report.facts = facts_of(document, report, unnamed);
  if (unnamed > 0) report.open << tr("%1 more are open.").arg(labels::count(unnamed));
  std::set<int> ids;
  for (const OpenPatch& patch : document.patches()) {
    ids.insert(patch.id);
    report.patches.push_back(patch.state);
  }
  const CommandLine command = command_line(document, ids);
  report.command = command.text;
  report.remarks = command.remarks;
  return report;
}

QString html_of(const FillReport& report, PictureLinks links) {
  const QString title = report.title.toHtmlEscaped();
  QString html = QStringLiteral(
                     "<!DOCTYPE html>\n<html><head><meta charset=\"utf-8\">"
                     "<meta name=\"viewport\" content=\"width=device-width\"><title>%1</title>\n"
                     "<style>body { font-family: sans-serif; max-width: 60em; margin: 2em auto; padding: 0 1em; } "
                     "td { vertical-align: top; padding: 8px; } td:first-child { width: 45%; } "
                     "img { width: 100%; height: auto; } "
                     "pre { white-space: pre-wrap; }</style></head>\n<body>\n<h1>%1</h1>\n")
                     .arg(title);
  html += paragraph(size_of_patches(report));
  for (const QString& fact : report.facts) html += paragraph(fact);
  // Pages of a PDF: below the head of the first there is room for three holes, on the others for four.
  constexpr std::size_t on_first = 3, on_others = 4;
  html += QStringLiteral("<table width=\"100%\">\n");
  for (std::size_t k = 0; k < report.holes.size(); ++k) {
    if (k >= on_first && (k - on_first) % on_others == 0)
      html += QStringLiteral("</table>\n<table width=\"100%\" style=\"page-break-before: always\">\n");
    const FillReport::Hole& hole = report.holes[k];
    html += QStringLiteral("<tr><td>%1</td><td><h3>%2: <span style=\"color:%3\">%4</span></h3>\n")
                .arg(picture_of(hole, k, links), hole.name.toHtmlEscaped(), hole.color, hole.verdict.toHtmlEscaped());
    html += paragraph(hole.lines.join(QLatin1Char('\n'))) + QStringLiteral("</td></tr>\n");
  }
  html += QStringLiteral("</table>\n");
  if (!report.open.isEmpty()) html += QStringLiteral("<h2>%1</h2>\n").arg(tr("Open loops"));
  for (const QString& line : report.open) html += paragraph(line);
  if (!report.command.isEmpty())
    html += QStringLiteral("<h2>%1</h2>\n<pre>%2</pre>\n")
                .arg(tr("The same on the command line"), report.command.toHtmlEscaped());
  for (const QString& remark : report.remarks) html += paragraph(remark);
  return html + QStringLiteral("</body></html>\n");
}

}  // namespace loopmend
