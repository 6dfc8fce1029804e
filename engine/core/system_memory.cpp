// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/system_memory.h"

#include <algorithm>

namespace loopmend {

double memory_left_mb(std::optional<double> most_mb) {
  constexpr double least = 1e-3, megabyte = 1 << 20, share_of_available = 0.9;
  if (most_mb) return std::max(least, *most_mb - memory_of_process() / megabyte);
  return std::max(least, share_of_available * memory_to_be_had() / megabyte);
}

}  // namespace loopmend
