// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/parse_errors.h"

#include "core/error.h"
#include "io/text_cursor.h"

namespace loopmend {

void ParseErrors::not_finite(std::uint64_t vertex, const std::string& place) const {
  fail("vertex " + std::to_string(vertex) + " has a coordinate that is not a finite number", place,
       "Remove or repair that vertex in the program the file comes from.");
}

void ParseErrors::bad_index(std::uint64_t face, const std::string& index, const std::string& valid,
                            const std::string& place) const {
  fail("face " + std::to_string(face) + " names vertex " + index + ", but " + valid, place);
}

void ParseErrors::not_a_number(std::string_view token, const std::string& what, const std::string& place) const {
  if (token.empty()) fail(what + " is missing", place);
  const bool decimal_comma = token.find(',') != std::string_view::npos;
  fail(in_quotes(token) + " stands where " + what + " should be", place,
       decimal_comma ? "Numbers are written with a point, not a comma."
                     : "Correct that place, or export the mesh again.");
}

void ParseErrors::truncated(const std::string& where, const std::string& place) const {
  fail("the file ends too early, in " + where, place, "It is incomplete; export or copy it again.");
}

void ParseErrors::too_many(const std::string& elements, const std::string& count, const std::string& place) const {
  fail("announces " + count + " " + elements + ", more than a file of " + std::to_string(file_.bytes.size()) +
           " bytes can hold",
       place);
}

void ParseErrors::fail(const std::string& problem, const std::string& place, const std::string& cure) const {
  std::string printable = problem;  // names from the file may hold anything
  for (char& c : printable) {
    if (static_cast<unsigned char>(c) < ' ' || c == '\x7F') c = '?';
  }
  throw ReadError(file_.path, printable, place, cure);
}

}  // namespace loopmend
