// SPDX-License-Identifier: GPL-3.0-or-later
// Options as Python hands them over: the words and numbers of the command line, by name.
#pragma once

#include "core/error.h"
#include "evolution/option_names.h"
#include "pipeline/fill_holes.h"

#include <pybind11/pybind11.h>

#include <array>
#include <string>
#include <type_traits>

namespace loopmend {

/// @throws TypeError where it is of another type.
template <class T>
T option(const pybind11::dict& options, const char* name) {
  namespace py = pybind11;
  try {
    return options[name].cast<T>();
  } catch (const py::cast_error&) {
    const auto given = py::repr(options[name]).cast<std::string>();
    throw py::type_error(std::string(name) +
                         (std::is_same_v<T, bool> ? " takes True or False, not " : " does not take ") + given);
  }
}

/// @throws InvalidArgument for a name that is not in the table; the message lists those that are.
template <class T, std::size_t n>
T named(const pybind11::dict& options, const char* option_name, const std::array<Named<T>, n>& table) {
  const auto name = option<std::string>(options, option_name);
  if (const auto value = value_named(table, name)) return *value;
  std::string known;
  for (const Named<T>& entry : table) known += (known.empty() ? "" : ", ") + std::string(entry.name);
  throw InvalidArgument(say("%1 takes one of %2, not '%3'", std::string(option_name), known, name));
}

/// flow, mode, steps, sigma, solver, boundary, continuity, density.
/// @throws InvalidArgument, TypeError.
GroupOptions group_options(const pybind11::dict& options);

}  // namespace loopmend
