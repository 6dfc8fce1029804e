// SPDX-License-Identifier: GPL-3.0-or-later
// The messages of the parsers in one place, so that all formats report alike. Every function throws.
#pragma once

#include "core/message.h"
#include "io/file_content.h"

#include <cstdint>
#include <string_view>

namespace loopmend {

class ParseErrors {
 public:
  explicit ParseErrors(const FileContent& file) : file_(file) {}

  /// @param vertex  numbered as the format does: from 1 in OBJ, from 0 elsewhere.
  [[noreturn]] void not_finite(std::uint64_t vertex, const Message& place) const;
  /// @param valid  the range of indices there is, in words.
  [[noreturn]] void bad_index(std::uint64_t face, std::int64_t index, const Message& valid, const Message& place) const;
  /// @param what  what should stand there: "a coordinate".
  [[noreturn]] void not_a_number(std::string_view token, const Message& what, const Message& place) const;
  /// @param where  what was being read when the file ended: "vertex 7 of 20".
  [[noreturn]] void truncated(const Message& where, const Message& place) const;
  [[noreturn]] void too_many(const Message& elements, std::uint64_t count, const Message& place) const;
  [[noreturn]] void fail(
      const Message& problem, const Message& place,
      const Message& cure = say("The file is damaged or incomplete; export or copy it again.")) const;

 private:
  const FileContent& file_;
};

}  // namespace loopmend
