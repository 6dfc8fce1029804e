// SPDX-License-Identifier: GPL-3.0-or-later
// Paths as text, UTF-8 on every system: on Windows a path from a std::string would take it for another encoding.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <system_error>

namespace loopmend {

/// Where the system's paths are bytes, the same bytes.
inline std::string path_text(const std::filesystem::path& path) {
  const std::u8string text = path.u8string();
  return {text.begin(), text.end()};
}
/// The same with / between folders.
inline std::string generic_path_text(const std::filesystem::path& path) {
  const std::u8string text = path.generic_u8string();
  return {text.begin(), text.end()};
}
/// What is no UTF-8, as a name in a file may be, is taken byte by byte.
inline std::filesystem::path path_of_text(std::string_view text) {
  try {
    return std::u8string(text.begin(), text.end());
  } catch (const std::system_error&) {  // on Windows alone
    return std::string(text);
  }
}

}  // namespace loopmend
