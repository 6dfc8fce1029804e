// SPDX-License-Identifier: GPL-3.0-or-later
// The engine writes its messages for the command line, in English. This is the one place that turns them into the
// window's words.
#pragma once

#include <QString>

#include <string>

namespace loopmend::labels {

/// The message in the window's language, with the window's controls in place of options. It is taken apart at ". ", "; ",
/// ": " and a last pair of parentheses; parts that engine_templates.h does not know, such as a path, stay as they are.
QString engine_words(const std::string& message);

}  // namespace loopmend::labels
