// SPDX-License-Identifier: GPL-3.0-or-later
// The sentences of the parsers: one place for the words, so that all formats complain alike. Every function throws.
#pragma once

#include "io/file_content.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace loopmend {

class ParseErrors {
 public:
  explicit ParseErrors(const FileContent& file) : file_(file) {}

  /// @param vertex  numbered as the format does: from 1 in OBJ, from 0 elsewhere.
  [[noreturn]] void not_finite(std::uint64_t vertex, const std::string& place) const;
  /// @param valid  the range of indices there is, in words.
  [[noreturn]] void bad_index(std::uint64_t face, const std::string& index, const std::string& valid,
                              const std::string& place) const;
  /// @param what  what should stand there: "a coordinate".
  [[noreturn]] void not_a_number(std::string_view token, const std::string& what, const std::string& place) const;
  /// @param where  what was being read when the file ended: "vertex 7 of 20".
  [[noreturn]] void truncated(const std::string& where, const std::string& place) const;
  [[noreturn]] void too_many(const std::string& elements, const std::string& count, const std::string& place) const;
  [[noreturn]] void fail(const std::string& problem, const std::string& place,
                         const std::string& cure = "The file is damaged or incomplete; export or copy it again.") const;

 private:
  const FileContent& file_;
};

}  // namespace loopmend
