// SPDX-License-Identifier: GPL-3.0-or-later
// Typed errors: wrong input throws one of these. Numerical outcomes and cancellation are values, never exceptions.
#pragma once

#include <filesystem>
#include <stdexcept>
#include <string>

namespace loopmend {

/// Base of everything the engine throws on purpose. what() is one line for a person: what, where, what to do.
class Error : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A file cannot be read: missing, not a mesh, malformed, or damaged. what() is "PATH: PROBLEM (PLACE). CURE".
class ReadError : public Error {
 public:
  /// @param place  where in the file ("line 12", "byte 431", "vertex 7"); may be empty.
  /// @param cure   what the person can do about it; a whole sentence; may be empty.
  ReadError(const std::filesystem::path& path, const std::string& problem, const std::string& place,
            const std::string& cure);
};

/// A file cannot be written. Whatever stood at the path before is still there, untouched.
class WriteError : public Error {
 public:
  WriteError(const std::filesystem::path& path, const std::string& problem, const std::string& cure);
};

/// A parameter is out of its documented range, or names something that does not exist.
class InvalidArgument : public Error {
 public:
  using Error::Error;
};

/// The system withholds what the work needs, such as address space (ulimit -v) or threads (ulimit -u).
class LimitError : public Error {
 public:
  using Error::Error;
};

}  // namespace loopmend
