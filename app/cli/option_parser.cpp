// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/option_parser.h"

#include <sstream>

namespace loopmend {

namespace {
constexpr double smallest_named = 1e-100;  ///< smaller bounds mean "above 0"
}

CLI::Validator between(double low, double high) {
  return CLI::Validator(
      [low, high](std::string& text) {
        double value = 0;
        if (CLI::detail::lexical_cast(text, value) && value >= low && value <= high) return std::string();
        std::ostringstream words;
        words << "takes a number ";
        if (low > 0 && low < smallest_named)
          words << "above 0";
        else
          words << "from " << low << " to " << high;
        words << ", not '" << text << "'";
        return words.str();
      },
      "NUMBER");
}

}  // namespace loopmend
