// SPDX-License-Identifier: GPL-3.0-or-later
// CLI11, which reads paths as UTF-8, and two kinds of options.
#pragma once

#include "core/path_text.h"
#include "evolution/option_names.h"

#include <array>
#include <filesystem>
#include <string>

namespace CLI::detail {
/// Preferred to CLI11's own, which leaves the encoding to the system.
inline bool lexical_cast(const std::string& input, std::filesystem::path& output) {
  output = loopmend::path_of_text(input);
  return true;
}
}  // namespace CLI::detail

#include <CLI/CLI.hpp>

namespace loopmend {

/// Takes a number within these bounds.
CLI::Validator between(double low, double high);

/// An option that takes one of the names in a table, which must outlive the parser.
template <class T, std::size_t n>
CLI::Option* add_named(CLI::App& command, const std::string& option, T& value, const std::array<Named<T>, n>& table,
                       const std::string& help) {
  const auto take = [&value, &table](const std::string& name) { value = value_named(table, name).value(); };
  return command.add_option_function<std::string>(option, take, help)
      ->check(CLI::IsMember(names_in(table)))
      ->default_str(name_of(table, value));
}

}  // namespace loopmend
