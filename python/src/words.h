// SPDX-License-Identifier: GPL-3.0-or-later
// Options as Python hands them over: the words and numbers of the command line, by name.
#pragma once

#include "core/error.h"
#include "pipeline/fill_holes.h"

#include <pybind11/pybind11.h>

#include <map>
#include <string>

namespace loopmend {

/// @throws TypeError where it is of another type.
template <class T>
T option(const pybind11::dict& options, const char* name) {
  namespace py = pybind11;
  try {
    return options[name].cast<T>();
  } catch (const py::cast_error&) {
    throw py::type_error(std::string(name) + " does not take " + py::repr(options[name]).cast<std::string>());
  }
}

/// @throws InvalidArgument for a word that is not in the table; the message lists those that are.
template <class T>
T worded(const pybind11::dict& options, const char* name, const std::map<std::string, T>& table) {
  const auto word = option<std::string>(options, name);
  if (const auto found = table.find(word); found != table.end()) return found->second;
  std::string words;
  for (const auto& [known, value] : table) words += (words.empty() ? "" : ", ") + known;
  throw InvalidArgument(std::string(name) + " takes one of " + words + ", not '" + word + "'");
}

/// flow, mode, steps, sigma, solver, boundary, continuity, density.
/// @throws InvalidArgument, TypeError.
GroupOptions group_options(const pybind11::dict& options);

}  // namespace loopmend
