// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/not_kept.h"

#include <algorithm>

namespace loopmend {

void count_not_kept(std::vector<NotKept>& list, const std::string& what, std::size_t count) {
  if (count == 0 || what.empty()) return;
  const auto known = std::find_if(list.begin(), list.end(), [&](const NotKept& entry) { return entry.what == what; });
  if (known != list.end())
    known->count += count;
  else
    list.push_back({what, count});
}

std::string to_string(const std::vector<NotKept>& list) {
  std::string text;
  for (const NotKept& entry : list) {
    if (!text.empty()) text += ", ";
    text += entry.what + " (" + std::to_string(entry.count) + ")";
  }
  return text;
}

}  // namespace loopmend
