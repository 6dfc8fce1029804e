// SPDX-License-Identifier: GPL-3.0-or-later
// Files that appear whole or not at all: one by itself, or all that a command writes together.
#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <memory>
#include <ostream>

namespace loopmend {

/// Writes to a temporary file in the same folder, checks the stream, fsyncs, renames over `path`. On any failure the
/// temporary file is removed and `path` is as it was. A symbolic link is written through; an existing file keeps its
/// mode and, where the system permits, its owner, group and extended attributes; a new one follows the umask. Other
/// names of a file with several hard links keep the old file (other_names()). Temporary files in the folder that a dead
/// process of the same user on this machine has left are removed. What `write` throws is passed on.
/// @throws WriteError naming the path and the system's reason.
void write_file_atomically(const std::filesystem::path& path, const std::function<void(std::ostream&)>& write);

/// Files that are written beside their targets one by one and get their names together, once all of them are complete.
/// Until commit() every target is as it was; without it nothing stays behind.
class OutputTransaction {
 public:
  OutputTransaction();
  ~OutputTransaction();
  OutputTransaction(const OutputTransaction&) = delete;
  OutputTransaction& operator=(const OutputTransaction&) = delete;

  /// Makes a folder, and those above it, unless it is there. What was made goes again if no file comes to stand in it.
  /// @throws WriteError
  void add_folder(const std::filesystem::path& path);

  /// As write_file_atomically, but for the rename. @throws WriteError; what `write` throws is passed on.
  void add(const std::filesystem::path& path, const std::function<void(std::ostream&)>& write);

  /// Renames in the order of add(). Once, as the last thing.
  /// @throws WriteError when a rename fails; file_in_place() then says which files had their names by then.
  void commit();

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

/// The k-th target that a transaction of this process has put in place, as it was given to add(); null beyond the last.
/// For programs that say in the end, also on a signal, what they wrote. Knows up to 128.
const char* file_in_place(std::size_t k) noexcept;

/// True if both names mean one file, whether it is there already or not: hard and symbolic links, ./x and x.
/// @throws WriteError for a circle of symbolic links.
bool same_file(const std::filesystem::path& a, const std::filesystem::path& b);

/// How many other names (hard links) the file at `path` has; 0 where there is no file. They keep the old file when `path`
/// is written: to write into it in place would put all of them at risk.
std::size_t other_names(const std::filesystem::path& path);

/// Checks before long work whether write_file_atomically could begin: the folder is there and takes a new file, and what
/// stands at `path` is a regular file that may be replaced. Leaves nothing behind.
/// @throws WriteError as write_file_atomically.
void check_writable(const std::filesystem::path& path);

/// Removes temporary files, and new folders, of writes that are under way in this process; file_in_place() is exact
/// afterwards. Async-signal-safe enough for an exit path: call it only right before _exit.
void remove_unfinished_files() noexcept;

}  // namespace loopmend
