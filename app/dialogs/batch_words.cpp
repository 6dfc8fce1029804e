// SPDX-License-Identifier: GPL-3.0-or-later
#include "dialogs/batch_words.h"

#include "document/message_words.h"
#include "panels/hole_delegate.h"

#include <QCoreApplication>
#include <QPainter>

#include <utility>

namespace loopmend {
namespace {

QString tr(const char* text, int n = -1) { return QCoreApplication::translate("loopmend::labels", text, nullptr, n); }

/// Why a loop was left, by the code of the report.
constexpr std::pair<const char*, const char*> reasons[] = {
    {"outer_rim", QT_TRANSLATE_NOOP("loopmend::labels", "outline of an open sheet")},
    {"cut", QT_TRANSLATE_NOOP("loopmend::labels", "no hole: more than two faces meet there")},
    {"crack", QT_TRANSLATE_NOOP("loopmend::labels", "a crack: nothing is missing")},
    {"covered", QT_TRANSLATE_NOOP("loopmend::labels", "a crack: a face at the same place covers it")},
    {"one_sided", QT_TRANSLATE_NOOP("loopmend::labels", "the surface is one-sided")},
    {"split_mesh", QT_TRANSLATE_NOOP("loopmend::labels", "the mesh is split there")},
    {"wide_crack", QT_TRANSLATE_NOOP("loopmend::labels", "a gap whose sides nearly touch")},
    {"every_patch_crosses", QT_TRANSLATE_NOOP("loopmend::labels", "every patch that was found would cut the surface")},
    {"boundary_crosses", QT_TRANSLATE_NOOP("loopmend::labels", "its boundary runs through the surface")},
    {"no_memory", QT_TRANSLATE_NOOP("loopmend::labels", "not enough memory")},
    {"patches_cross", QT_TRANSLATE_NOOP("loopmend::labels", "its patch would cut another one")},
    {"covered_island", QT_TRANSLATE_NOOP("loopmend::labels", "a patch covers this island")},
    {"island_not_joined", QT_TRANSLATE_NOOP("loopmend::labels", "the island within it was not joined")},
    {"not_finished", QT_TRANSLATE_NOOP("loopmend::labels", "not finished")},
    {"out_of_time", QT_TRANSLATE_NOOP("loopmend::labels", "not finished")}};

Message with_window_words(Message message) {
  for (const auto& [code, text] : reasons)
    if (message.code == code) return verbatim(tr(text).toStdString());
  for (Message& argument : message.arguments) argument = with_window_words(std::move(argument));
  return message;
}

}  // namespace

QIcon sign_icon(HoleState state) {
  constexpr int size = 16, density = 2;  // pixels
  QPixmap picture(density * size, density * size);
  picture.fill(Qt::transparent);
  QPainter painter(&picture);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.scale(density, density);
  painter.translate(size / 2, size / 2);
  paint_sign(&painter, state, sign_color(state));
  painter.end();
  return QIcon(picture);
}

namespace labels {

QString status_of(const SummaryRow& row) {
  const QString status = QLatin1String(row.status());
  const QString text = status == QLatin1String("filled")    ? tr("filled")
                       : status == QLatin1String("nothing") ? tr("nothing to fill")
                       : status == QLatin1String("open")    ? tr("left open")
                       : status == QLatin1String("error")   ? tr("error")
                                                            : tr("waits for the next run");
  return row.end.state == ScanEnd::State::as_before ? tr("%1, as before").arg(text) : text;
}

HoleState sign_of(const SummaryRow& row) {
  const QString status = QLatin1String(row.status());
  if (status == QLatin1String("error")) return HoleState::failed;
  if (status == QLatin1String("waiting")) return HoleState::open;
  if (status == QLatin1String("nothing")) return HoleState::left_out;
  if (row.figures && row.figures->bad > 0) return HoleState::bad;
  return status == QLatin1String("open") || (row.figures && row.figures->look > 0) ? HoleState::look
                                                                                   : HoleState::converged;
}

QStringList remarks_on(const SummaryRow& row) {
  QStringList said;
  for (const Message& remark : row.remarks()) said << in_words(with_window_words(remark));
  return said;
}

QString summary_of(const std::vector<SummaryRow>& rows) {
  const SummaryCounts counts = counts_of(rows);
  int good = 0, look = 0, bad = 0;
  for (const SummaryRow& row : rows) {
    if (!row.figures) continue;
    good += row.figures->filled - row.figures->look - row.figures->bad;
    look += row.figures->look;
    bad += row.figures->bad;
  }
  QStringList parts{tr("%1 filled").arg(counts.filled)};
  if (counts.nothing > 0) parts << tr("%1 with nothing to fill").arg(counts.nothing);
  if (counts.open > 0) parts << tr("%1 left open").arg(counts.open);
  if (counts.error > 0) parts << tr("%1 with an error").arg(counts.error);
  if (counts.waiting > 0) parts << tr("%1 waiting for the next run").arg(counts.waiting);
  const char* const scans = QT_TRANSLATE_N_NOOP("loopmend::labels", "%Ln scan(s): ");
  QStringList sentences{tr(scans, static_cast<int>(rows.size())) + parts.join(QStringLiteral(", ")) + QLatin1Char('.')};
  sentences << tr("Patches: %1 good, %2 to look at, %3 bad.").arg(good).arg(look).arg(bad);
  if (counts.as_before > 0) sentences << tr("%1 were complete before.").arg(counts.as_before);
  return sentences.join(QLatin1Char(' '));
}

}  // namespace labels
}  // namespace loopmend
