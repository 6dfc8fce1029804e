// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/verdict_words.h"

#include "document/document.h"
#include "document/labels.h"
#include "document/message_words.h"

#include <QCoreApplication>
#include <QStringList>

namespace loopmend::labels {
namespace {

QString tr(const char* text) { return QCoreApplication::translate("loopmend::labels", text); }

}  // namespace

QString advice(const Verdict& verdict) {
  if (verdict.findings.empty() || verdict.grade == Grade::good) return {};
  switch (verdict.findings.front().code) {
    case NoticeCode::crosses_surface:
    case NoticeCode::dome_over_flat_loop:
      return tr("Trim crossing triangles (right click), or cut out what intersects (Repair), then fill it again.");
    case NoticeCode::crease:
    case NoticeCode::torn_seam:
    case NoticeCode::seam_worse:
      return tr("If it shows, trim the boundary and fill it again, or compare Other patches (V).");
    case NoticeCode::nonmanifold_edges:
    case NoticeCode::folded_edges:
    case NoticeCode::curvature_torn:
    case NoticeCode::initial_patch_kept:
      return tr("Trim the boundary and fill it again, or take one of Other patches (V).");
    case NoticeCode::bubble: return tr("Take one of Other patches (V), or part the hole by a bridge (G).");
    case NoticeCode::edges_rounded:
    case NoticeCode::wall_ends:
    case NoticeCode::flat_or_dome:
    case NoticeCode::bent_inside:
    case NoticeCode::high_over_loop:
    case NoticeCode::likely_far: return tr("Compare it with Other patches (V).");
    case NoticeCode::mirror_image:
    case NoticeCode::mirror_misfit:
    case NoticeCode::mirror_no_gain:
    case NoticeCode::mirror_no_symmetry:
    case NoticeCode::mirror_across:
    case NoticeCode::mirror_symmetric:
    case NoticeCode::mirror_open:
    case NoticeCode::mirror_faulty: break;
  }
  return {};
}

QString seam_text(const Document& document, int loop) {
  const OpenPatch* patch = document.patch_of(loop);
  if (!patch) return {};
  const PatchState& state = *patch->state;
  const std::size_t at = patch->place_of(loop);
  if (at >= state.seams.size() || at >= state.seams_before.size()) return {};
  const Verdict* verdict = document.verdict(loop);
  QString text =
      seam_sentence(state.seams_before[at], state.seams[at], state.status, verdict ? verdict->grade : Grade::good);
  if (at < state.deviation.loops.size())
    if (const QString likely = deviation_sentence(state.deviation.loops[at]); !likely.isEmpty())
      text += QLatin1Char(' ') + likely;
  return text;
}

QString verdict_text(const Document& document, int loop) {
  const HoleState now = document.state(loop);
  const QString why = in_words(document.message(loop));
  QStringList sentences;
  const Verdict* verdict = document.patch_of(loop) ? document.verdict(loop) : nullptr;
  if (verdict) {
    sentences << verdict_or_state(document, loop) + QLatin1Char('.') << sentence_of(*verdict) << advice(*verdict);
    if (now == HoleState::cutting) sentences << state_help(now);
  } else {
    sentences << state_help(now);
    if (!why.isEmpty()) sentences << sentence(why) + (why.endsWith(QLatin1Char('.')) ? QString() : QStringLiteral("."));
  }
  sentences << seam_text(document, loop);
  sentences.removeAll(QString());
  return sentences.join(QLatin1Char(' '));
}

}  // namespace loopmend::labels
