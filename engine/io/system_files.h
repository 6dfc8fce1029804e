// SPDX-License-Identifier: GPL-3.0-or-later
// What files need of the operating system beyond std::filesystem; in system_files_posix.cpp and system_files_windows.cpp.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <system_error>

namespace loopmend {

/// Who may read a new file while it is written.
enum class Readers { by_default, owner };

/// A descriptor of a new file, to write bytes to. @returns −1, with the reason in errno, where it cannot be made or is there already.
int open_new_file(const std::filesystem::path& path, Readers readers);

/// What was written to the descriptor is on the disk when this returns 0; otherwise −1, with the reason in errno.
int flush_to_disk(int descriptor);

/// So that a new name in the folder survives a power cut. A folder that cannot be flushed is no failure: the file stands already.
void flush_folder(const std::filesystem::path& folder);

/// Whether this user may write to the file; if not, the reason is in errno.
bool may_write(const std::filesystem::path& path);

/// Gives the open file the mode of `from` and, where the system permits, its owner, group and extended attributes. On
/// Windows a new file has the rights of its folder. @returns 0, or the reason as a value of errno.
int take_properties(int descriptor, const std::filesystem::path& from);

/// Puts a file in the place of another in one step. Windows refuses while another program has the other one open.
std::error_code replace_file(const std::filesystem::path& from, const std::filesystem::path& to);

std::int32_t process_id();
/// False where that is not known.
bool process_has_ended(std::int32_t process);
/// Where process ids mean the same: this machine, and this container of it.
std::string process_namespace();
/// Whether it is a regular file, no link, of the user that runs this process.
bool is_own_file(const std::filesystem::path& path);

/// For an exit path: neither memory nor locks. @param path  UTF-8. @returns 0, or the reason as a value of errno.
int remove_file_at_exit(const char* path) noexcept;
void remove_folder_at_exit(const char* path) noexcept;

}  // namespace loopmend
