// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/message.h"

#include <cstdio>
#include <ostream>

namespace loopmend {

std::string Message::english() const {
  if (is_verbatim) return text;
  std::string words;
  for (std::size_t at = 0; at < text.size(); ++at) {
    const int place = text[at] == '%' && at + 1 < text.size() ? text[at + 1] - '1' : -1;
    if (place < 0 || place >= static_cast<int>(arguments.size())) {
      words += text[at];
    } else {
      words += arguments[place].english();
      ++at;
    }
  }
  return words;
}

Message Message::with_code(std::string_view name) && {
  code = name;
  return std::move(*this);
}

Message verbatim(std::string_view text) {
  Message message{std::string(text), {}, {}, true};
  for (char& c : message.text)
    if (static_cast<unsigned char>(c) < ' ' || c == '\x7F') c = '?';
  return message;
}

Message as_argument(double number) {
  char text[32];
  std::snprintf(text, sizeof text, "%g", number);
  return verbatim(text);
}

Message joined(Message first, std::string_view between, Message second) {
  if (first.empty()) return second;
  if (second.empty()) return first;
  std::string code = first.code.empty() ? second.code : first.code;
  Message both{"%1" + std::string(between) + "%2", {}, std::move(code), false};
  both.arguments = {std::move(first), std::move(second)};
  return both;
}

std::ostream& operator<<(std::ostream& out, const Message& message) { return out << message.english(); }

}  // namespace loopmend
