// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/not_kept.h"

#include <algorithm>

namespace loopmend {

void count_not_kept(std::vector<NotKept>& list, const Message& what, std::size_t count) {
  if (count == 0 || what.empty()) return;
  const auto known = std::find_if(list.begin(), list.end(), [&](const NotKept& entry) { return entry.what == what; });
  if (known != list.end())
    known->count += count;
  else
    list.push_back({what, count});
}

std::string to_string(const std::vector<NotKept>& list) {
  constexpr std::size_t most_named = 20;
  std::string text;
  for (std::size_t k = 0; k < std::min(list.size(), most_named); ++k)
    text += (k > 0 ? ", " : "") + list[k].what.english() + " (" + std::to_string(list[k].count) + ")";
  if (list.size() > most_named) text += " and " + std::to_string(list.size() - most_named) + " more";
  return text;
}

}  // namespace loopmend
