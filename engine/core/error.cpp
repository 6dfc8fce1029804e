// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/error.h"
#include "core/path_text.h"

namespace loopmend {

namespace {
std::string sentence(const std::filesystem::path& path, const std::string& problem, const std::string& place,
                     const std::string& cure) {
  std::string text = path_text(path) + ": " + problem;
  if (!place.empty()) text += " (" + place + ")";
  text += ".";
  if (!cure.empty()) text += " " + cure;
  return text;
}
}  // namespace

ReadError::ReadError(const std::filesystem::path& path, const std::string& problem, const std::string& place,
                     const std::string& cure)
    : Error(sentence(path, problem, place, cure)) {}

WriteError::WriteError(const std::filesystem::path& path, const std::string& problem, const std::string& cure)
    : Error(sentence(path, problem, "", cure)) {}

}  // namespace loopmend
