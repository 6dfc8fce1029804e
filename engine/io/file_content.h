// SPDX-License-Identifier: GPL-3.0-or-later
// A whole file in memory, and the guess what kind of mesh it holds.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace loopmend {

struct FileContent {
  std::filesystem::path path;
  std::string bytes;  ///< exactly what the file holds; of one compressed with gzip, what is packed in it
};

enum class MeshFormat { ply, stl_ascii, stl_binary, obj, off, gltf, three_mf, polydata };

/// The file as it is. @throws ReadError as load_file
FileContent load_bytes(const std::filesystem::path& path);

/// Loads the file, unpacked.
/// @throws ReadError if it is missing, a directory, not a regular file, unreadable or empty.
FileContent load_file(const std::filesystem::path& path);

/// The extension in small letters, without ".gz" after it.
std::string lower_extension(const std::filesystem::path& path);

/// Detects the format by content first, by the extension only where the content does not say.
/// @throws ReadError for content that is known to be something else (Git LFS pointer, UTF-16) or unknown.
MeshFormat detect_format(const FileContent& file);

/// The bytes without a UTF-8 byte order mark.
std::string_view mesh_text(const FileContent& file);

}  // namespace loopmend
