// SPDX-License-Identifier: GPL-3.0-or-later
// Typed errors: wrong input throws one of these. Numerical outcomes and cancellation are values, never exceptions.
#pragma once

#include "core/message.h"

#include <exception>
#include <filesystem>
#include <stdexcept>

namespace loopmend {

/// Base of everything the engine throws on purpose. One line for a person: what, where, what to do.
class Error : public std::runtime_error {
 public:
  explicit Error(Message message) : runtime_error(message.english()), message_(std::move(message)) {}
  const Message& message() const { return message_; }

 private:
  Message message_;
};

/// A file cannot be read: missing, not a mesh, malformed, or damaged. "PATH: PROBLEM (PLACE). CURE".
class ReadError : public Error {
 public:
  /// @param place  where in the file ("line 12", "byte 431", "vertex 7"); may be empty.
  /// @param cure   what the person can do about it; a whole sentence; may be empty.
  ReadError(const std::filesystem::path& path, Message problem, Message place = {}, Message cure = {});
};

/// A file cannot be written. Whatever stood at the path before is still there, untouched.
class WriteError : public Error {
 public:
  WriteError(const std::filesystem::path& path, Message problem, Message cure = {});
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

/// What an exception says; where it is none of ours, as it is.
Message message_of(const std::exception& error);

}  // namespace loopmend
