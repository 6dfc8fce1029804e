// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/shell_words.h"

#include <algorithm>

namespace loopmend::shell {

QString quoted(const QString& path) {
  static const QString plain = QStringLiteral("_-./,:=+@%");
  const bool simple = !path.isEmpty() && std::all_of(path.begin(), path.end(), [](QChar c) {
    return (c.unicode() < 128 && c.isLetterOrNumber()) || plain.contains(c);
  });
  if (simple) return path;
  QString inside = path;
  return QLatin1Char('\'') + inside.replace(QLatin1Char('\''), QStringLiteral("'\\''")) + QLatin1Char('\'');
}

QString writing(const QString& file, const QStringList& lines) {
  return QStringLiteral("cat > ") + quoted(file) + QStringLiteral(" <<'END'\n") + lines.join(QLatin1Char('\n')) +
         QStringLiteral("\nEND");
}

}  // namespace loopmend::shell
