// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/part_loops.h"

#include "core/error.h"
#include "mesh/facing_loops.h"

#include <charconv>
#include <sstream>

namespace loopmend {

namespace {

std::string name_of(std::size_t part, std::size_t loop) {
  return std::to_string(part + 1) + ":" + std::to_string(loop + 1);
}

/// A number from 1 to `count`, or 0.
std::size_t number_in(const std::string& text, std::size_t count) {
  std::size_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc() && end == text.data() + text.size() && value <= count ? value : 0;
}

NamedLoop loop_named(const JoinedParts& parts, const std::string& word) {
  const std::size_t colon = word.find(':');
  if (colon == std::string::npos)
    throw InvalidArgument(say("--loops takes FILE:LOOP,FILE:LOOP,..., such as 1:2,2:1, not '%1'", word));
  const std::size_t part = number_in(word.substr(0, colon), parts.loops.size());
  if (part == 0)
    throw InvalidArgument(
        say("--loops %1: there is no file %2; %3 were given", word, word.substr(0, colon), parts.loops.size()));
  const auto& loops = parts.loops[part - 1];
  const std::size_t loop = number_in(word.substr(colon + 1), loops.size());
  if (loop == 0)
    throw InvalidArgument(
        say("--loops %1: file %2 has %3 loops; 'loopmend info' lists them", word, part, loops.size()));
  return {word, loops[loop - 1]};
}

Vec3 middle_of(const JoinedParts& parts, std::size_t part) {
  Vec3 sum = Vec3::Zero();
  for (std::size_t i = parts.first_point[part]; i < parts.first_point[part + 1]; ++i) sum += parts.model.soup.points[i];
  return sum / static_cast<double>(parts.first_point[part + 1] - parts.first_point[part]);
}

std::vector<NamedLoop> loops_that_face(const JoinedParts& parts) {
  std::vector<FacingPart> facing;
  for (std::size_t k = 0; k < parts.loops.size(); ++k)
    facing.push_back({&parts.model, parts.loops[k], middle_of(parts, k)});
  std::vector<NamedLoop> chosen;
  for (const std::size_t loop : facing_loops(facing)) {
    const std::size_t part = chosen.size();
    chosen.push_back({name_of(part, loop), parts.loops[part][loop]});
  }
  return chosen;
}

}  // namespace

std::vector<NamedLoop> choose_part_loops(const JoinedParts& parts, const std::string& words) {
  std::vector<NamedLoop> chosen;
  if (!words.empty()) {
    std::istringstream stream(words);
    for (std::string word; std::getline(stream, word, ',');) chosen.push_back(loop_named(parts, word));
  } else if (parts.loops.size() > 1) {
    chosen = loops_that_face(parts);
  } else {
    const auto& loops = parts.loops.front();
    if (loops.size() != 2)
      throw InvalidArgument(
          loops.size() == 1
              ? say("the file has 1 loop, not two: name those to be joined, such as --loops 1:1,1:2")
              : say("the file has %1 loops, not two: name those to be joined, such as --loops 1:1,1:2", loops.size()));
    for (std::size_t l = 0; l < 2; ++l) chosen.push_back({name_of(0, l), loops[l]});
  }
  if (chosen.size() < 2) throw InvalidArgument(say("a blend needs at least two loops: --loops names one"));
  for (std::size_t k = 0; k < chosen.size(); ++k)
    for (std::size_t l = 0; l < k; ++l)
      if (chosen[k].loop.number == chosen[l].loop.number)
        throw InvalidArgument(say("--loops names loop %1 twice", chosen[k].name));
  return chosen;
}

}  // namespace loopmend
