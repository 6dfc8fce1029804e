// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/shell_words.h"

#include "evolution/option_names.h"
#include "flows/flow_terms.h"

#include <QDir>
#include <QFileInfo>
#include <QLocale>

namespace loopmend::shell {

QString exact(double value) { return QString::number(value, 'g', QLocale::FloatingPointShortest); }

QString word(FlowKind flow) { return QLatin1String(to_string(flow)); }

QString boundary_options(BoundaryTrust boundary, SeamContinuity continuity) {
  QString text;
  if (boundary != BoundaryTrust::automatic)
    text += QStringLiteral(" --boundary ") + QLatin1String(name_of(boundary_names, boundary));
  if (continuity != SeamContinuity::curvature)
    text += QStringLiteral(" --continuity ") + QLatin1String(name_of(continuity_names, continuity));
  return text;
}

QString loop_shape(SeamContinuity shape) {
  switch (shape) {
    case SeamContinuity::position: return QStringLiteral(":flat");
    case SeamContinuity::tangent: return QStringLiteral(":tangent");
    case SeamContinuity::curvature: return {};
  }
  return {};
}

QString edges_options(SharpEdges edges, const EdgeEdits& edits) {
  QString text = edges == SharpEdges::rounded ? QStringLiteral(" --edges round") : QString();
  for (const auto& [a, b] : edits.drawn) text += QStringLiteral(" --draw-edge %1,%2").arg(a).arg(b);
  QStringList stopped;
  for (int vertex : edits.stopped) stopped << QString::number(vertex);
  if (!stopped.isEmpty()) text += QStringLiteral(" --stop-edge ") + stopped.join(QLatin1Char(','));
  return text;
}

QString relief_options(const ReliefChoice& relief) {
  if (relief.kind == ReliefChoice::Kind::smooth) return {};
  const QString seed =
      relief.seed == ReliefChoice().seed ? QString() : QStringLiteral(" --relief-seed %1").arg(relief.seed);
  return QStringLiteral(" --relief continued") + seed;
}

QString file_of(const OpenedScan& scan, const QString& made) {
  if (scan.from == ScanOrigin::sample) return QStringLiteral("sample.ply");
  return scan.from == ScanOrigin::made ? made : QDir::toNativeSeparators(scan.path);
}

QString beside(const QString& file, const QString& ending) {
  const QFileInfo info(file);
  const QString base = info.path() == QStringLiteral(".") ? QString() : info.path() + QLatin1Char('/');
  return base + info.completeBaseName() + ending;
}

}  // namespace loopmend::shell
