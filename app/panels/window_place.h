// SPDX-License-Identifier: GPL-3.0-or-later
// Where windows go on the screen.
#pragma once

#include <QRect>

namespace loopmend {

/// About what a window manager draws around a window; it is not known before the window is shown.
inline constexpr QMargins usual_frame{4, 30, 4, 8};

/// As large as it was, and as near to its place, as the screen there allows.
QRect onto_screen(const QRect& was);

/// Beside the main window where the room is wide enough; else over it, with what a person needs to see in sight if possible.
/// @param size         without frame
/// @param least_width  to which it may shrink for that
QRect place_beside(const QRect& main, const QRect& needed, const QSize& size, int least_width, const QRect& room);

}  // namespace loopmend
