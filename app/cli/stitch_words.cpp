// SPDX-License-Identifier: GPL-3.0-or-later
#include "stitch_words.h"

#include "commands.h"

#include "io/text_cursor.h"

#include <cmath>
#include <optional>
#include <string_view>

namespace loopmend {

namespace {

/// A number, and whether % follows it; nothing for other words.
struct Tolerance {
  double number;
  bool percent;
};

std::optional<Tolerance> tolerance_in(std::string_view word) {
  const bool percent = !word.empty() && word.back() == '%';
  if (percent) word.remove_suffix(1);
  const std::optional<double> number = parse_double(word);
  if (!number || !std::isfinite(*number)) return std::nullopt;
  return Tolerance{*number, percent};
}

}  // namespace

StitchTolerance stitch_tolerance_of(const std::string& text) {
  const std::optional<Tolerance> tolerance = tolerance_in(text);
  const double most = 40;
  if (!tolerance || tolerance->number < 0 || (tolerance->percent && tolerance->number > most))
    throw UsageError("--stitch takes a length such as 0.5, or up to 40 % of the edges there such as 5%, not '" + text +
                     "'");
  if (tolerance->percent) return {tolerance->number / 100, std::nullopt};
  return {StitchTolerance().edges, tolerance->number};
}

std::vector<std::string> with_stitch_tolerances(std::vector<std::string> words) {
  std::vector<std::string> result;
  for (std::size_t k = 0; k < words.size(); ++k) {
    result.push_back(words[k]);
    if (words[k] != "--stitch") continue;
    const bool has_tolerance = k + 1 < words.size() && tolerance_in(words[k + 1]);
    result.back() += has_tolerance ? "=" + words[++k] : "=10%";
  }
  return result;
}

FillCommand::Base base_of(const std::string& text) {
  const std::size_t colon = text.find(':');
  const bool names_loop = colon != std::string::npos;
  const std::optional<double> loop = names_loop ? parse_double(std::string_view(text).substr(0, colon)) : 0;
  const std::optional<double> distance = parse_double(std::string_view(text).substr(names_loop ? colon + 1 : 0));
  const bool is_number = loop && *loop == std::floor(*loop) && *loop >= (names_loop ? 1 : 0) && *loop < 1e9;
  if (!is_number || !distance || !std::isfinite(*distance) || !(*distance > 0))
    throw UsageError("--base takes a length above 0 such as 5, or a loop and a length such as 2:5, not '" + text + "'");
  return {static_cast<int>(*loop), *distance};
}

}  // namespace loopmend
