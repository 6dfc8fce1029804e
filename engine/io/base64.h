// SPDX-License-Identifier: GPL-3.0-or-later
// Bytes as text, as data URIs have them (RFC 4648).
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace loopmend {

std::string to_base64(std::string_view bytes);
/// Nothing where the text is not wholly base64; the "=" at its end may be missing.
std::optional<std::string> from_base64(std::string_view text);

}  // namespace loopmend
