// SPDX-License-Identifier: GPL-3.0-or-later
// A check of the command line's numbers.
#pragma once

#include "cli/option_parser.h"

namespace loopmend {

/// Like CLI::Range, but NaN is out of range, and the numbers in the message are readable.
/// @param low  above 0 but below 1e-100: the message says "above 0".
CLI::Validator between(double low, double high);

}  // namespace loopmend
