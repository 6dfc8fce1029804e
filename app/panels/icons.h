// SPDX-License-Identifier: GPL-3.0-or-later
// Icons from the resources, in the palette's colours, sharp at every scale.
#pragma once

#include <QIcon>

namespace loopmend {

/// @param name  file name in resources/icons without extension.
QIcon icon(const char* name, const QColor& ink);
QIcon application_icon();

}  // namespace loopmend
