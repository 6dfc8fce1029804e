// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/parse_errors.h"

#include "core/error.h"
#include "io/text_cursor.h"

namespace loopmend {

void ParseErrors::not_finite(std::uint64_t vertex, const Message& place) const {
  fail(say("vertex %1 has a coordinate that is not a finite number", vertex), place,
       say("Remove or repair that vertex in the program the file comes from."));
}

void ParseErrors::bad_index(std::uint64_t face, std::int64_t index, const Message& valid, const Message& place) const {
  fail(say("face %1 names vertex %2, but %3", face, index, valid), place);
}

void ParseErrors::not_a_number(std::string_view token, const Message& what, const Message& place) const {
  if (token.empty()) fail(say("%1 is missing", what), place);
  const bool decimal_comma = token.find(',') != std::string_view::npos;
  fail(say("%1 stands where %2 should be", in_quotes(token), what), place,
       decimal_comma ? say("Numbers are written with a point, not a comma.")
                     : say("Correct that place, or export the mesh again."));
}

void ParseErrors::truncated(const Message& where, const Message& place) const {
  fail(say("the file ends too early, in %1", where), place, say("It is incomplete; export or copy it again."));
}

void ParseErrors::too_many(const Message& elements, std::uint64_t count, const Message& place) const {
  fail(say("announces %1 %2, more than a file of %3 bytes can hold", count, elements, file_.bytes.size()), place);
}

void ParseErrors::fail(const Message& problem, const Message& place, const Message& cure) const {
  throw ReadError(file_.path, problem, place, cure);
}

}  // namespace loopmend
