// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/xml_text.h"

#include <cstddef>

namespace loopmend {

std::string xml_text(std::string_view text) {
  std::string result;
  for (std::size_t k = 0; k < text.size(); ++k) {
    const auto c = static_cast<unsigned char>(text[k]);
    if (c == '&')
      result += "&amp;";
    else if (c == '<')
      result += "&lt;";
    else if (c == '>')
      result += "&gt;";
    else if (c == '"')
      result += "&quot;";
    else if (c < ' ' && c != '\n' && c != '\t')
      result += '?';
    else if (c < 0x80)
      result += text[k];
    else {
      const std::size_t size = c >= 0xF0 ? 4 : c >= 0xE0 ? 3 : 2;
      bool valid = c >= 0xC2 && c <= 0xF4 && k + size <= text.size();
      for (std::size_t i = 1; valid && i < size; ++i) valid = (static_cast<unsigned char>(text[k + i]) & 0xC0) == 0x80;
      result += valid ? text.substr(k, size) : std::string_view("?");
      if (valid) k += size - 1;
    }
  }
  return result;
}

}  // namespace loopmend
