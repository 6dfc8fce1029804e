// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/material_library.h"

#include "io/file_content.h"
#include "io/text_cursor.h"

#include <algorithm>
#include <array>
#include <set>
#include <string_view>

namespace loopmend {

namespace {

/// The name after options such as "-s 1 1 1" and "-clamp on": it may hold blanks, so it is what comes after the last option.
std::string picture_name(std::string_view rest) {
  const auto is_blank = [](char c) { return c == ' ' || c == '\t'; };
  const auto strip = [&] {
    while (!rest.empty() && is_blank(rest.front())) rest.remove_prefix(1);
    while (!rest.empty() && is_blank(rest.back())) rest.remove_suffix(1);
  };
  const auto word = [&] {
    strip();
    const std::string_view first = rest.substr(0, rest.find_first_of(" \t"));
    rest.remove_prefix(first.size());
    return first;
  };
  for (strip(); !rest.empty() && rest.front() == '-'; strip()) {
    const std::string_view option = word();
    int values = 1;
    if (option == "-mm") values = 2;
    if (option == "-o" || option == "-s" || option == "-t") values = 3;
    for (int k = 0; k < values; ++k) {
      strip();
      const std::string_view next = rest.substr(0, rest.find_first_of(" \t"));
      if (k > 0 && !parse_double(next)) break;  // -s and its like may have one or two numbers only
      word();
    }
  }
  std::string name(rest);
  std::replace(name.begin(), name.end(), '\\', '/');
  return name;
}

/// Colours, gloss and transparency.
bool is_plain_statement(std::string_view word) {
  constexpr std::array<std::string_view, 15> words = {"Ka", "Kd", "Ks",    "Ke",        "Tf", "Ns", "Ni", "d",
                                                      "Tr", "Pr", "illum", "sharpness", "Pm", "Ps", "Pc"};
  return std::find(words.begin(), words.end(), word) != words.end();
}

}  // namespace

MaterialLibrary read_material_library(const std::filesystem::path& path) {
  const FileContent file = load_file(path);
  MaterialLibrary library{path, {}, {}, {}};
  TextCursor cursor(mesh_text(file), '#');
  std::string material;
  std::set<std::string> known;
  while (cursor.next_line()) {
    const std::string_view word = cursor.next_token();
    if (word == "newmtl") {
      material = picture_name(cursor.rest_with_comment());
    } else if (word.substr(0, 4) == "map_" || word == "bump" || word == "disp" || word == "decal" || word == "refl" ||
               word == "norm") {
      const std::string name = picture_name(cursor.rest_with_comment());
      if (name.empty()) continue;
      if (word == "map_Kd") library.color_pictures[material] = name;
      if (known.insert(name).second) library.pictures.push_back(name);
    } else if (!material.empty() && is_plain_statement(word)) {
      library.statements[material].push_back(std::string(word) + std::string(cursor.rest_of_line()));
    }
  }
  return library;
}

}  // namespace loopmend
