// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/labels.h"
#include "document/message_words.h"

#include <QCoreApplication>
#include <QLocale>
#include <QStringList>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace loopmend::labels {
namespace {

QString tr(const char* text, int n = -1) { return QCoreApplication::translate("loopmend::labels", text, nullptr, n); }

// One sided fits on a triangulated scan differ by about this much even when the surface is smooth.
constexpr double tangent_seen_deg = 2.0;
constexpr double sharp_crease_deg = 45;
constexpr double curvature_seen = 0.5;  ///< jump of H times the hole's diameter

/// As the language writes it; four digits have no mark that could be taken for a decimal one.
QString in_digits(double value, char format, int digits) {
  constexpr double five_digits = 1e4;
  QLocale locale;
  if (std::abs(value) < five_digits) locale.setNumberOptions(QLocale::OmitGroupSeparator);
  return locale.toString(value, format, digits);
}

/// 3.44\u00b710\u2076
QString with_power(double value) {
  if (!std::isfinite(value)) return QString::number(value);
  static const QString raised = QStringLiteral("\u2070\u00b9\u00b2\u00b3\u2074\u2075\u2076\u2077\u2078\u2079");
  const QString text = in_digits(value, 'e', 2);
  const int at = text.indexOf(QLatin1Char('e'));
  const int power = text.mid(at + 1).toInt();
  QString exponent = power < 0 ? QStringLiteral("\u207b") : QString();
  for (QChar digit : QString::number(std::abs(power))) exponent += raised.at(digit.digitValue());
  return text.left(at) + QStringLiteral("\u00b710") + exponent;
}

}  // namespace

QString count(std::size_t n) { return QLocale().toString(static_cast<qulonglong>(n)); }

QString sentence(QString text) {
  if (!text.isEmpty()) text[0] = text[0].toUpper();
  return text;
}

QString kind(LoopKind kind) {
  switch (kind) {
    case LoopKind::hole: return tr("hole");
    case LoopKind::outer_rim: return tr("outer rim");
    case LoopKind::crack: return tr("crack");
    case LoopKind::cut: return tr("cut");
  }
  return {};
}

QString kind_help(LoopKind kind) {
  switch (kind) {
    case LoopKind::hole: return tr("A hole in the surface.");
    case LoopKind::outer_rim:
      return tr("The outline of an open sheet. It is left out unless you select it yourself and press Fill.");
    case LoopKind::crack:
      return tr("A crack: nothing is missing here, the two sides only are not joined. Stitch joins them.");
    case LoopKind::cut:
      return tr(
          "Not a hole: more than two triangles meet along this edge, so the surface was cut here. Repair\u2026 in the "
          "tab "
          "Patch lists such edges and removes them.");
  }
  return {};
}

QString state(HoleState state) {
  switch (state) {
    case HoleState::open: return tr("open");
    case HoleState::left_out: return tr("left out");
    case HoleState::filled: return tr("filled");
    case HoleState::running: return tr("running");
    case HoleState::stepped: return tr("in progress");
    case HoleState::converged: return tr("converged");
    case HoleState::early_stop: return tr("all steps taken");
    case HoleState::faired: return tr("faired");
    case HoleState::look: return tr("look");
    case HoleState::bad: return tr("bad");
    case HoleState::stalled: return tr("stopped early");
    case HoleState::cutting: return tr("cuts surface");
    case HoleState::accepted: return tr("accepted");
    case HoleState::failed: return tr("failed");
  }
  return {};
}

int urgency(HoleState state) {
  switch (state) {
    case HoleState::bad: return 0;
    case HoleState::cutting: return 1;
    case HoleState::failed: return 2;
    case HoleState::look: return 3;
    case HoleState::stalled: return 4;
    case HoleState::open: return 5;
    case HoleState::running:
    case HoleState::stepped: return 6;
    case HoleState::filled: return 7;
    case HoleState::faired:
    case HoleState::early_stop:
    case HoleState::converged: return 8;
    case HoleState::accepted: return 9;
    case HoleState::left_out: return 10;
  }
  return 10;
}

QString verdict_or_state(const Document& document, int loop) {
  const HoleState now = document.state(loop);
  const bool came_to_an_end = now == HoleState::converged || now == HoleState::early_stop || now == HoleState::faired ||
                              now == HoleState::filled;
  if (now == HoleState::left_out && document.present(loop)) return kind(document.loop(loop).kind);
  return came_to_an_end && document.verdict(loop) ? tr("good") : state(now);
}

QString shape(SeamContinuity shape) {
  switch (shape) {
    case SeamContinuity::position: return tr("flat");
    case SeamContinuity::tangent: return tr("tangent");
    case SeamContinuity::curvature: return tr("smooth");
  }
  return {};
}

QString shape_help(SeamContinuity shape) {
  switch (shape) {
    case SeamContinuity::position: return tr("Closed flat, as chosen: a plane, or a taut skin.");
    case SeamContinuity::tangent: return tr("Closed without a crease, as chosen: position and tangent.");
    case SeamContinuity::curvature: return tr("Closed smoothly, as chosen: position, tangent and curvature.");
  }
  return {};
}

QString state_help(HoleState state) {
  switch (state) {
    case HoleState::open: return tr("Not filled yet.");
    case HoleState::left_out: return tr("Not filled unless you select it yourself.");
    case HoleState::filled: return tr("Closed by the initial patch; no flow has run yet.");
    case HoleState::running: return tr("A flow is moving this patch now.");
    case HoleState::stepped: return tr("A flow has moved this patch; more steps can be taken.");
    case HoleState::converged: return tr("The flow has converged to its steady state.");
    case HoleState::early_stop: return tr("The flow has taken the steps that were planned for this hole.");
    case HoleState::faired: return tr("Shaped by linear fairing, not by the flow.");
    case HoleState::look: return tr("Filled; look at this patch before you accept it.");
    case HoleState::bad:
      return tr("Filled, but the patch has a fault: look at it, then accept it, or discard it and trim the boundary.");
    case HoleState::stalled:
      return tr(
          "The flow stopped before it converged; this is its last good state. Run goes on from here; Accept keeps it.");
    case HoleState::cutting:
      return tr(
          "This patch cuts the surface or itself. It is not exported unless you accept it. Discard opens the hole "
          "again; "
          "then trim its boundary, or erase a ring of faces, and fill anew.");
    case HoleState::accepted: return tr("Accepted: no flow moves it until you open it again.");
    case HoleState::failed:
      return tr(
          "This hole could not be filled. Trim its boundary, erase a ring of faces around it, or bridge it, and fill "
          "again.");
  }
  return {};
}

QString flow(FlowKind flow) {
  switch (flow) {
    case FlowKind::mmcvf: return tr("MMCVF \u2013 curvature");
    case FlowKind::wf: return tr("WF \u2013 tangent, round");
    case FlowKind::sdf: return tr("SDF \u2013 tangent, taut");
    case FlowKind::mcf: return tr("MCF \u2013 position, soap film");
  }
  return {};
}

QString flow_name(FlowKind flow) { return labels::flow(flow).section(QLatin1Char(' '), 0, 0); }

QString flow_help(FlowKind flow) {
  switch (flow) {
    case FlowKind::mmcvf:
      return tr("Minimal mean-curvature variation, sixth order: position, tangent and curvature match at the seam.");
    case FlowKind::wf:
      return tr("Willmore flow, fourth order: position and tangent match; bends as little as possible.");
    case FlowKind::sdf:
      return tr("Surface diffusion, fourth order: position and tangent match; mean curvature spreads evenly.");
    case FlowKind::mcf: return tr("Mean curvature flow, second order: least area; a crease stays at the seam.");
  }
  return {};
}

QString unit_symbol(const std::string& unit) {
  if (unit == "micron") return QStringLiteral("\u00b5m");
  if (unit == "millimeter") return QStringLiteral("mm");
  if (unit == "centimeter") return QStringLiteral("cm");
  if (unit == "meter") return QStringLiteral("m");
  if (unit == "inch") return QStringLiteral("in");
  if (unit == "foot") return QStringLiteral("ft");
  return {};
}

QString unit_name(const std::string& unit) {
  if (unit == "micron") return tr("micrometres");
  if (unit == "millimeter") return tr("millimetres");
  if (unit == "centimeter") return tr("centimetres");
  if (unit == "meter") return tr("metres");
  if (unit == "inch") return tr("inches");
  if (unit == "foot") return tr("feet");
  return tr("not known");
}

QString length(const Document& document, double value) {
  const QString symbol = unit_symbol(document.unit());
  return symbol.isEmpty() ? number(value) : number(value) + QChar(QChar::Nbsp) + symbol;
}

QString seconds(qint64 milliseconds) { return in_digits(static_cast<double>(milliseconds) / 1000, 'f', 1); }

QString number(double value) {
  constexpr int digits = 3;
  const double size = std::abs(value);
  if (std::isnan(value)) return QStringLiteral("\u2013");  // nothing was there to be measured
  if (size == 0) return QStringLiteral("0");
  if (!(size >= 1e-3 && size < 1e5)) return with_power(value);
  const int decimals = std::max(0, digits - 1 - static_cast<int>(std::floor(std::log10(size))));
  return in_digits(value, 'f', decimals);
}

QString time_left(double seconds) {
  constexpr double minute = 60, most_in_seconds = 90;
  if (seconds < 1) return {};
  return seconds < most_in_seconds ? tr("about %1 s left").arg(static_cast<int>(std::ceil(seconds)))
                                   : tr("about %1 min left").arg(static_cast<int>(std::lround(seconds / minute)));
}

QString seam_sentence(const SeamReport& before, const SeamReport& now, PatchStatus stage, Grade grade) {
  if (std::isnan(now.g1_rms_deg)) return tr("The scan around the hole is too small for its seam to be measured.");
  const bool tangent = now.g1_rms_deg < tangent_seen_deg;
  const bool curvature = tangent && now.h_jump_rms_times_diameter < curvature_seen;
  QString sentence = tr("Tangent and curvature run through the seam.");
  if (!tangent)
    sentence = tr("At the seam the normals of patch and scan differ by %1\u00b0 (rms).").arg(number(now.g1_rms_deg));
  if (tangent && !curvature)
    sentence =
        tr("The tangent runs through the seam; the mean curvature jumps by %1 (rms).").arg(number(now.h_jump_rms));
  if (stage == PatchStatus::filled) return sentence + QLatin1Char(' ') + tr("No flow has run yet.");
  if (grade == Grade::bad) return sentence;
  // No praise for a sharp crease, nor for one that is sharper than before.
  const bool creased = now.g1_rms_deg > sharp_crease_deg || now.g1_rms_deg > before.g1_rms_deg + 1;
  constexpr double worth_a_word = 0.95;  // "1.00 times smaller" says nothing
  constexpr int enough = 1000;           // times
  if (before.h_jump_rms > 0 && now.h_jump_rms < worth_a_word * before.h_jump_rms && !creased)
    sentence += QLatin1Char(' ') +
                (stage == PatchStatus::faired ? tr("Fairing made the jump of curvature %1 times smaller.")
                                              : tr("The flow made the jump of curvature %1 times smaller."))
                    .arg(enough * now.h_jump_rms < before.h_jump_rms ? tr("over %1").arg(count(std::size_t{enough}))
                                                                     : number(before.h_jump_rms / now.h_jump_rms));
  return sentence;
}

QString notice(const Notice& notice) {
  const auto value = [&](std::size_t k) { return k < notice.arguments.size() ? notice.arguments[k] : std::nan(""); };
  const auto whole = [&](std::size_t k) { return in_digits(std::round(value(k)), 'f', 0); };
  const auto digits = [&](std::size_t k) { return std::abs(value(k)) < 100 ? in_digits(value(k), 'g', 2) : whole(k); };
  const int n = notice.arguments.empty() ? 0 : static_cast<int>(std::lround(notice.arguments.front()));
  // By themselves: lupdate does not see them within the call.
  const char* const crossings =
      QT_TRANSLATE_N_NOOP("loopmend::labels", "crosses the surface or itself in %Ln place(s)");
  const char* const nonmanifold = QT_TRANSLATE_N_NOOP("loopmend::labels", "%Ln edge(s) of more than two faces");
  const char* const folds = QT_TRANSLATE_N_NOOP("loopmend::labels", "%Ln edge(s) folded by more than 150\u00b0");
  switch (notice.code) {
    case NoticeCode::crosses_surface: return tr(crossings, n);
    case NoticeCode::nonmanifold_edges: return tr(nonmanifold, n);
    case NoticeCode::folded_edges: return tr(folds, n);
    case NoticeCode::torn_seam:
      return tr("a crease of %1\u00b0 along %2 edges of the seam, where the initial patch had %3\u00b0")
          .arg(whole(0), whole(1), whole(2));
    case NoticeCode::dome_over_flat_loop: return tr("a dome %1 diameters high over a flat loop").arg(digits(0));
    case NoticeCode::flat_or_dome: return tr("closed flat, where the surface bends as if it went on as a dome");
    case NoticeCode::bubble:
      return tr("a bubble of %1 times the area of the initial patch, reaching %2 diameters beyond it")
          .arg(digits(0), digits(1));
    case NoticeCode::curvature_torn:
      return tr("mean curvature jumps at the seam by %1 / diameter, before the flow by %2").arg(digits(0), digits(1));
    case NoticeCode::initial_patch_kept: return tr("no flow or fairing gave a sound patch: the initial patch was kept");
    case NoticeCode::edges_rounded: return tr("sharp edges of the scan end here, and the patch rounds them");
    case NoticeCode::wall_ends:
      return tr("a wall ends here and at another loop, and a ring between them is more likely than this patch");
    case NoticeCode::crease: return tr("a crease of %1\u00b0 along %2 edges of the seam").arg(whole(0), whole(1));
    case NoticeCode::bent_inside:
      return tr("edges inside the patch bend by %1\u00b0 along %2 diameters").arg(whole(0), digits(1));
    case NoticeCode::seam_worse:
      return tr("the seam bends by %1\u00b0 (rms), in the initial patch by %2\u00b0").arg(whole(0), whole(1));
    case NoticeCode::high_over_loop:
      return tr("rises %1 diameters over its loop; a ball through the seam would rise %2").arg(digits(0), digits(1));
    case NoticeCode::likely_far:
      return tr("what was there may lie %1 diameters away: the shape is a guess").arg(digits(0));
    case NoticeCode::mirror_image:
      return tr("copied from the mirror image, from which the surface around is %1 diameters away").arg(digits(0));
    case NoticeCode::mirror_misfit:
      return tr("not copied from the mirror image, from which the surface around is %1 diameters away: more than 0.02")
          .arg(digits(0));
    case NoticeCode::mirror_no_gain:
      return tr("not copied from the mirror image: the surface around is %1 diameters away from it, and the patch "
                "hardly "
                "more, %2")
          .arg(digits(0), digits(1));
    case NoticeCode::mirror_no_symmetry:
      return tr("not copied from the mirror image, since the scan is not symmetric: its best image is %1 of its extent "
                "away")
          .arg(digits(0));
    case NoticeCode::mirror_across:
      return tr("not made symmetric, though the hole lies across the plane of symmetry: the surface around is %1 "
                "diameters from its image")
          .arg(digits(0));
    case NoticeCode::mirror_symmetric:
      return tr("made symmetric, since the hole lies across the plane of symmetry; the surface around is %1 diameters "
                "from its image")
          .arg(digits(0));
    case NoticeCode::mirror_open: return tr("not copied from the mirror image, which has no surface there");
    case NoticeCode::mirror_faulty:
      return tr("not copied from the mirror image, which folds there, cuts the surface or does not close the hole");
  }
  return {};
}

QString deviation_sentence(const ExpectedDeviation& deviation) {
  return deviation.is_known()
             ? tr("Likely within %1 of what was there (80 %).").arg(in_digits(deviation.likely, 'g', 2))
             : QString();
}

QString sentence_of(const Verdict& verdict) {
  return verdict.findings.empty() ? QString() : sentence(notice(verdict.findings.front())) + QLatin1Char('.');
}

QString neighborhood(NeighborhoodKind kind) {
  switch (kind) {
    case NeighborhoodKind::smooth: return tr("smooth");
    case NeighborhoodKind::noisy: return tr("noisy");
    case NeighborhoodKind::rough: return tr("rough");
  }
  return {};
}

QString boundary_help(const BoundarySummary& boundary) {
  return tr("Relief around the hole is %1 % of an edge high, noise %2 %. The fits tell the normal at the boundary to "
            "%3\u00b0 and the mean curvature to %4 (it is %5 there, rms); the band in the section shows it.")
      .arg(in_digits(100 * boundary.relief_per_edge, 'g', 2), in_digits(100 * boundary.noise_per_edge, 'g', 2),
           number(boundary.normal_sigma_deg), number(boundary.H_sigma), number(boundary.H));
}

QString hole_name(const Document& document, int loop) {
  const QString number = QString::number(document.loop(loop).number);
  if (document.scans().size() < 2) return number;
  const auto scan = document.scan(document.scan_of(loop));
  return scan ? tr("%1 of %2").arg(number, scan->name) : number;
}

QString holes(const Document& document, const std::set<int>& loops) {
  constexpr std::size_t spelled_out = 4;
  if (loops.size() == 1) return tr("hole %1").arg(hole_name(document, *loops.begin()));
  if (loops.size() > spelled_out || loops.empty()) return tr("%L1 holes").arg(loops.size());
  QStringList names;
  for (int loop : loops) names << hole_name(document, loop);
  const QString last = names.takeLast();
  return tr("holes %1 and %2").arg(names.join(QStringLiteral(", ")), last);
}

QString import_summary(const OpenedScan& scan) {
  const ImportReport& in = scan.import;
  const ModelRepairs& repairs = scan.model->repairs;
  const auto counted = [](std::size_t n, const char* words) { return tr(words, static_cast<int>(n)).arg(count(n)); };
  QString text = tr("%1: %2, %3, %4.")
                     .arg(scan.name, counted(in.triangles, QT_TRANSLATE_N_NOOP("loopmend::labels", "%1 triangles")),
                          counted(in.vertices, QT_TRANSLATE_N_NOOP("loopmend::labels", "%1 vertices")),
                          counted(scan.loops.size(), QT_TRANSLATE_N_NOOP("loopmend::labels", "%1 boundary loops")));
  QStringList notes;
  const auto note = [&](std::size_t n, const char* words) {
    if (n > 0) notes << counted(n, words);
  };
  note(in.polygons_triangulated, QT_TRANSLATE_N_NOOP("loopmend::labels", "%1 polygons cut into triangles"));
  note(repairs.reoriented_faces, QT_TRANSLATE_N_NOOP("loopmend::labels", "%1 faces turned round"));
  note(repairs.degenerate_faces, QT_TRANSLATE_N_NOOP("loopmend::labels", "%1 degenerate faces left aside"));
  note(repairs.duplicate_faces, QT_TRANSLATE_N_NOOP("loopmend::labels", "%1 duplicate faces left aside"));
  note(repairs.non_manifold_edges, QT_TRANSLATE_N_NOOP("loopmend::labels", "cut along %1 non-manifold edges"));
  note(repairs.non_manifold_vertices, QT_TRANSLATE_N_NOOP("loopmend::labels", "split at %1 non-manifold vertices"));
  note(in.vertices_joined, QT_TRANSLATE_N_NOOP("loopmend::labels", "%1 touching boundary vertices joined"));
  note(in.near_vertices_joined,
       QT_TRANSLATE_N_NOOP("loopmend::labels", "%1 vertices joined along cracks no wider than rounding"));
  note(in.unreferenced_vertices, QT_TRANSLATE_N_NOOP("loopmend::labels", "%1 vertices that no face uses"));
  note(in.missing_colors, QT_TRANSLATE_N_NOOP("loopmend::labels", "%1 vertices without a colour, made white"));
  if (!in.oddities.empty()) notes << not_kept(in.oddities);
  int coincident = 0;
  for (const BoundaryLoop& loop : scan.loops) coincident += loop.kind == LoopKind::cut ? 0 : loop.coincident;
  if (in.coincident_vertices > 0)
    note(static_cast<std::size_t>(coincident),
         QT_TRANSLATE_N_NOOP(
             "loopmend::labels",
             "%1 boundary edges that lie exactly on another (the mesh is split there; Stitch joins them)"));
  if (!notes.isEmpty()) text += QLatin1Char(' ') + tr("Noted: %1.").arg(notes.join(QStringLiteral(", ")));
  if (!in.not_kept.empty()) text += QLatin1Char(' ') + tr("Will not be saved: %1.").arg(not_kept(in.not_kept));
  return text;
}

QString not_kept(const std::vector<NotKept>& list) {
  QStringList words;
  for (const NotKept& entry : list) words << QStringLiteral("%1 (%2)").arg(in_words(entry.what), count(entry.count));
  return words.join(QStringLiteral(", "));
}

namespace {

// By itself: lupdate does not see it within a call.
const char* const touching_words = QT_TRANSLATE_N_NOOP("loopmend::labels", "%Ln edge(s) along which it touches itself");

/// Edges of more than two faces that agree in pairs enclose a volume, and are still edges that other programs take for faults.
bool is_plainly_watertight(const Watertightness& surface) { return surface.encloses() && surface.touching_edges == 0; }

QStringList faults_in_words(const Watertightness& surface) {
  QStringList words;
  const auto add = [&words](std::size_t n, const char* one_or_more) {
    if (n > 0) words << tr(one_or_more, static_cast<int>(n));
  };
  add(surface.open_boundaries, QT_TRANSLATE_N_NOOP("loopmend::labels", "%Ln open boundary loop(s)"));
  add(surface.non_manifold_edges, QT_TRANSLATE_N_NOOP("loopmend::labels", "%Ln edge(s) of more than two faces"));
  add(surface.reversed_edges,
      QT_TRANSLATE_N_NOOP("loopmend::labels", "%Ln edge(s) whose faces look to opposite sides"));
  add(surface.intersections, QT_TRANSLATE_N_NOOP("loopmend::labels", "%Ln pair(s) of faces that intersect"));
  if (surface.encloses() && !(surface.volume > 0))
    words << tr("the surface is inside out");
  else
    add(surface.inverted_shells, QT_TRANSLATE_N_NOOP("loopmend::labels", "%Ln body(s) or cavity(s) inside out"));
  if (!words.isEmpty()) add(surface.touching_edges, touching_words);
  return words;
}

}  // namespace

QString verdict(const Watertightness& surface) {
  if (surface.printable()) return tr("Watertight, ready to print");
  const QStringList words = faults_in_words(surface);
  const QString first = words.value(0);
  if (is_plainly_watertight(surface)) return tr("Watertight, not ready to print: %1").arg(first);
  if (surface.encloses())
    return words.size() > 1 ? tr("Not ready to print: %1 and more").arg(first)
                            : tr("Not ready to print: %1").arg(first);
  return words.size() > 1 ? tr("Not watertight: %1 and more").arg(first) : tr("Not watertight: %1").arg(first);
}

QString verdict_in_full(const Watertightness& surface) {
  if (surface.printable()) return verdict(surface);
  const QString all = faults_in_words(surface).join(QStringLiteral(", "));
  if (is_plainly_watertight(surface)) return tr("Watertight, not ready to print: %1").arg(all);
  return surface.encloses() ? tr("Not ready to print: %1").arg(all) : tr("Not watertight: %1").arg(all);
}

QString verdict_help(const Watertightness& surface) {
  QStringList lines = faults_in_words(surface);
  const char* const pieces = QT_TRANSLATE_N_NOOP("loopmend::labels", "%Ln component(s)");
  lines << tr(pieces, static_cast<int>(surface.pieces));
  if (surface.encloses()) lines << tr("volume %1, in cubic units of the scan").arg(number(surface.volume));
  if (surface.printable() && surface.touching_edges > 0)
    lines << tr(touching_words, static_cast<int>(surface.touching_edges));
  for (QString& line : lines) line = sentence(line);
  return lines.join(QLatin1Char('\n'));
}

}  // namespace loopmend::labels
