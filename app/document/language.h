// SPDX-License-Identifier: GPL-3.0-or-later
// The texts of the program in the person's language.
#pragma once

#include <QString>

namespace loopmend {

/// Installs the translators. @param wanted  "en", "de"; empty: the system's. English where there is no translation.
void install_language(const QString& wanted);

}  // namespace loopmend
