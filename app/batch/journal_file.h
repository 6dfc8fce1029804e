// SPDX-License-Identifier: GPL-3.0-or-later
// A file that grows by lines, for one process at a time. In journal_file_posix.cpp and journal_file_windows.cpp.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>

namespace loopmend {

/// Open, and locked against every other process that opens it so, while it lives. Others may read it.
class JournalFile {
 public:
  /// Makes the file where it is not there. @throws UsageError where another process has it, WriteError.
  explicit JournalFile(const std::filesystem::path& path);
  ~JournalFile();
  JournalFile(const JournalFile&) = delete;
  JournalFile& operator=(const JournalFile&) = delete;

  /// Drops what follows the first `size` bytes. @throws WriteError
  void cut(std::uintmax_t size);
  /// It is on the disk when this returns. @throws WriteError
  void append(const std::string& bytes);

 private:
  std::filesystem::path path_;
  std::intptr_t file_;
};

}  // namespace loopmend
