// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/error.h"

#include <string_view>

namespace loopmend {

/// Wrong usage that only shows once the input is read: exit code 2 of the command line.
class UsageError : public Error {
 public:
  explicit UsageError(std::string_view text) : Error(verbatim(text)) {}  // the command line speaks English
  using Error::Error;
};

}  // namespace loopmend
