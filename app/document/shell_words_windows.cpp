// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/shell_words.h"

#include <algorithm>

namespace loopmend::shell {

// No name has a quotation mark there. In quotes cmd takes all else as it is but a variable between two percent signs, for which
// its prompt has no other spelling.
QString quoted(const QString& path) {
  static const QString plain = QStringLiteral("_-./\\:+@");
  const bool simple = !path.isEmpty() && std::all_of(path.begin(), path.end(), [](QChar c) {
    return (c.unicode() < 128 && c.isLetterOrNumber()) || plain.contains(c);
  });
  return simple ? path : QLatin1Char('"') + path + QLatin1Char('"');
}

QString writing(const QString& file, const QStringList& lines) {
  QString text = QStringLiteral("(\n");
  for (const QString& line : lines) text += QStringLiteral("echo ") + line + QLatin1Char('\n');
  return text + QStringLiteral(") > ") + quoted(file);
}

}  // namespace loopmend::shell
