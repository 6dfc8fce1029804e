// SPDX-License-Identifier: GPL-3.0-or-later
// CLI11, which reads paths as UTF-8.
#pragma once

#include "core/path_text.h"

#include <filesystem>
#include <string>

namespace CLI::detail {
/// Preferred to CLI11's own, which leaves the encoding to the system.
inline bool lexical_cast(const std::string& input, std::filesystem::path& output) {
  output = loopmend::path_of_text(input);
  return true;
}
}  // namespace CLI::detail

#include <CLI/CLI.hpp>
