// SPDX-License-Identifier: GPL-3.0-or-later
// Many lines of numbers at once, in blocks shared by threads.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <string_view>

namespace loopmend {

/// Called for each row, in any order and from several threads, with its numbers. @returns false where they will not do.
using KeepRow = std::function<bool(std::size_t row, const double* numbers)>;
using KeepIntegers = std::function<bool(std::size_t row, const std::int64_t* numbers)>;

/// Reads the first `rows` lines of a text, each of which must hold so many numbers (at most 16), as parse_double and
/// parse_integer read them, with blanks between them and nothing else.
/// @param keyword  what each line begins with, one blank included; may be empty
/// @returns how many bytes these lines are; nothing where one is otherwise, or does not do: read line by line, an error can name it.
std::optional<std::size_t> read_rows(std::string_view text, std::size_t rows, int numbers, const KeepRow& keep,
                                     std::string_view keyword = "");
std::optional<std::size_t> read_rows(std::string_view text, std::size_t rows, int numbers, const KeepIntegers& keep,
                                     std::string_view keyword = "");

/// How many lines from the first on begin with the keyword.
std::size_t count_rows(std::string_view text, std::string_view keyword);

}  // namespace loopmend
