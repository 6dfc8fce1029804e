// SPDX-License-Identifier: GPL-3.0-or-later
// The one place where a message becomes the window's text.
#pragma once

#include "core/message.h"

#include <QString>

namespace loopmend::labels {

/// In the window's language, with the window's controls in place of the command line's options. Names stay as they are.
QString in_words(const Message& message);

}  // namespace loopmend::labels
