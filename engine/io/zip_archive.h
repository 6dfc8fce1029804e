// SPDX-License-Identifier: GPL-3.0-or-later
// ZIP archives in memory, by libzip.
#pragma once

#include "io/file_content.h"

#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace loopmend {

class ZipArchive {
 public:
  /// @param file  kept by reference. @throws ReadError for a damaged archive
  explicit ZipArchive(const FileContent& file);
  ~ZipArchive();
  ZipArchive(const ZipArchive&) = delete;
  ZipArchive& operator=(const ZipArchive&) = delete;

  /// Names are compared without regard to case and to a slash before them, as in packages of 3MF.
  bool has(std::string_view name) const;
  std::vector<std::string> names() const;
  /// Unpacks an entry piece by piece; its checksum is compared at the end.
  /// @throws ReadError where it is not there, damaged, encrypted, or so well packed that it can only be a trap
  void read(std::string_view name, const std::function<void(std::string_view)>& piece) const;

 private:
  struct State;
  const FileContent& file_;
  std::unique_ptr<State> state_;
};

/// An archive of these entries (name, content), in their order, without dates: the same bytes for the same content.
/// @throws std::runtime_error if libzip fails
std::string zip_archive(const std::vector<std::pair<std::string, std::string>>& entries);

}  // namespace loopmend
