// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/engine_words.h"

#include "document/engine_templates.h"

#include <QLocale>
#include <QRegularExpression>
#include <QStringList>

#include <algorithm>
#include <optional>
#include <vector>

namespace loopmend::labels {
namespace {

struct Pattern {
  QStringList literals;  ///< what stands before, between and after the placeholders
  int length = 0;        ///< of all literals
  const char* words = nullptr;
};

/// Those with the most text first: of several that fit, the one that says most is meant.
std::vector<Pattern> make_patterns() {
  const QRegularExpression placeholder(QStringLiteral("%\\d"));
  std::vector<Pattern> patterns;
  for (const auto& templates :
       {EngineTemplates::of_patches(), EngineTemplates::of_files(), EngineTemplates::of_formats()})
    for (const EngineTemplate& one : templates) {
      const QStringList literals = QString::fromUtf8(one.engine).split(placeholder);
      patterns.push_back({literals, literals.join(QString()).size(), one.words});
    }
  std::stable_sort(patterns.begin(), patterns.end(), [](const auto& a, const auto& b) { return a.length > b.length; });
  return patterns;
}

const QLatin1String opening(" (");  ///< of the place within a file, which stands behind what is wrong there

/// What stands at the placeholders; nothing where the text is another one.
std::optional<QStringList> values_in(const QString& text, const QStringList& literals) {
  if (!text.startsWith(literals.front())) return std::nullopt;
  QStringList values;
  int at = literals.front().size();
  for (int k = 1; k < literals.size(); ++k) {
    const QString& next = literals[k];
    const int to = k + 1 == literals.size() ? text.size() - next.size() : text.indexOf(next, at + 1);
    if (to <= at || text.mid(to, next.size()) != next) return std::nullopt;
    values << text.mid(at, to - at);
    at = to + next.size();
  }
  const bool takes_the_place = literals.size() > 1 && literals.back().isEmpty() && values.back().contains(opening);
  return at == text.size() && !takes_the_place ? std::optional(values) : std::nullopt;
}

/// In one pass, as a name may hold "%1" itself.
QString filled(const QString& words, const QStringList& values) {
  QString text;
  for (int at = 0; at < words.size(); ++at) {
    const int k = words[at] == QLatin1Char('%') && at + 1 < words.size() ? words[at + 1].digitValue() : 0;
    if (k < 1 || k > values.size()) {
      text += words[at];
    } else {
      text += values[k - 1];
      ++at;
    }
  }
  return text;
}

QString words_of(const QString& text);

QString words_of_value(const QString& value) {
  bool is_number = false;
  value.toDouble(&is_number);
  return is_number ? QString(value).replace(QLatin1Char('.'), QLocale().decimalPoint()) : words_of(value);
}

std::optional<QString> words_in_table(const QString& text) {
  static const std::vector<Pattern> patterns = make_patterns();
  for (const Pattern& pattern : patterns)
    if (auto values = values_in(text, pattern.literals)) {
      for (QString& value : *values) value = words_of_value(value);
      return filled(EngineTemplates::tr(pattern.words), *values);
    }
  return std::nullopt;
}

QString words_of(const QString& text) {
  if (const auto words = words_in_table(text)) return *words;
  if (text.endsWith(QLatin1Char('.'))) return words_of(text.chopped(1)) + QLatin1Char('.');
  for (const char* mark : {". ", "; ", ": "}) {
    const QString between = QLatin1String(mark);
    const int at = text.indexOf(between);
    if (at >= 0) return words_of(text.left(at)) + between + words_of(text.mid(at + between.size()));
  }
  const int at = text.lastIndexOf(opening);
  if (at < 0 || !text.endsWith(QLatin1Char(')'))) return text;
  return words_of(text.left(at)) + opening + words_of(text.mid(at + opening.size()).chopped(1)) + QLatin1Char(')');
}

}  // namespace

QString engine_words(const std::string& message) {
  constexpr std::size_t longest = 2000;  // what a damaged session holds is not taken apart
  const QString text = QString::fromStdString(message);
  return message.size() > longest ? text : words_of(text);
}

}  // namespace loopmend::labels
