// SPDX-License-Identifier: GPL-3.0-or-later
// Tells English from German by the small words that only English has.
#pragma once

#include <QRegularExpression>
#include <QString>
#include <QStringList>

namespace loopmend::test {

/// The English words in a text, and whatever looks like an option of the command line. Names in quotes are no words.
inline QStringList english_in(QString text) {
  static const QRegularExpression quoted(QStringLiteral("\"[^\"]*\"|\u201e[^\u201c]*\u201c"));
  text.remove(quoted);
  static const QRegularExpression tells(
      QStringLiteral("--[a-z]+|\\b(the|of|is|are|and|or|its|it|with|without|that|there|this|which|from|to|than|by|has|"
                     "have|holds|cannot|would|left|hole|holes|patch|vertex|vertices|faces|edges|loop|surface|boundary|"
                     "file|mesh|more|names|missing|unknown|bytes)\\b"));
  QStringList found;
  for (auto matches = tells.globalMatch(text); matches.hasNext();) found << matches.next().captured();
  return found;
}

}  // namespace loopmend::test
