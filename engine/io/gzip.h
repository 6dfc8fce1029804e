// SPDX-License-Identifier: GPL-3.0-or-later
// Files compressed with gzip, by zlib.
#pragma once

#include <filesystem>
#include <memory>
#include <ostream>
#include <string>
#include <string_view>

namespace loopmend {

bool is_gzip(std::string_view bytes);

/// All members of the file one after the other.
/// @throws ReadError where it is cut off or damaged, or takes more than half of the computer's memory.
std::string gunzip(const std::filesystem::path& path, std::string_view bytes);

/// Whether the name ends in .gz, in any case; and the name without it.
bool has_gzip_name(const std::filesystem::path& path);
std::filesystem::path without_gzip_name(const std::filesystem::path& path);

/// Compresses what it is given; finish() writes the end. The same bytes for the same input: no name and no time.
class GzipWriter {
 public:
  explicit GzipWriter(std::ostream& stream);
  ~GzipWriter();
  GzipWriter(const GzipWriter&) = delete;
  GzipWriter& operator=(const GzipWriter&) = delete;

  void write(std::string_view bytes);
  void finish();

 private:
  struct State;
  void run(std::string_view bytes, int flush);

  std::ostream& stream_;
  std::unique_ptr<State> state_;
};

}  // namespace loopmend
