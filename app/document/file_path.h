// SPDX-License-Identifier: GPL-3.0-or-later
// Paths of the window for the engine. Qt's own functions take a QString; a path made of a std::string would be another file on Windows.
#pragma once

#include "core/path_text.h"

#include <QString>

namespace loopmend {

inline std::filesystem::path file_path(const QString& path) { return path_of_text(path.toStdString()); }

}  // namespace loopmend
