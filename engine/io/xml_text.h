// SPDX-License-Identifier: GPL-3.0-or-later
// Text within XML and HTML.
#pragma once

#include <string>
#include <string_view>

namespace loopmend {

/// As the value of an attribute in double quotes, or as text. Control characters and bytes that are no UTF-8 become "?".
std::string xml_text(std::string_view text);

}  // namespace loopmend
