// A file that appears whole or not at all.
#pragma once

#include <filesystem>
#include <functional>
#include <ostream>

namespace loopmend {

/// Writes to a temporary file in the same folder, checks the stream, fsyncs, renames over `path`. On any failure the
/// temporary file is removed and `path` is as it was. A symbolic link is written through; an existing file keeps its
/// mode, a new one follows the umask. What `write` throws is passed on.
/// @throws WriteError naming the path and the system's reason.
void write_file_atomically(const std::filesystem::path& path, const std::function<void(std::ostream&)>& write);

/// Tells before long work whether write_file_atomically could begin: the folder is there and takes a new file, and what
/// stands at `path` is a regular file that may be replaced. Leaves nothing behind.
/// @throws WriteError as write_file_atomically.
void check_writable(const std::filesystem::path& path);

/// Removes temporary files of writes that are under way in this process. Async-signal-safe enough for an exit path:
/// call it only right before _exit.
void remove_unfinished_files() noexcept;

}  // namespace loopmend
