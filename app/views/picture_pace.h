// SPDX-License-Identifier: GPL-3.0-or-later
// How long a view waits before it may draw again.
#pragma once

#include <QtGlobal>

#include <algorithm>

namespace loopmend {

/// Pictures come at most 30 times a second; where drawing is slow, everything else of the window gets its share of the
/// time before the next one.
/// @param took  ms, of the last picture. @returns ms.
inline int wait_after_picture(qint64 took) {
  constexpr qint64 pace = 33, longest_wait = 40;
  return static_cast<int>(std::min(longest_wait, std::max(pace - took, took / 3)));
}

}  // namespace loopmend
