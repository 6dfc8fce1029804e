// SPDX-License-Identifier: GPL-3.0-or-later
// What the program says, as a value: a text and the arguments of its places. The command line prints it in English, and the
// window looks the text up in its language, as gettext does.
#pragma once

#include <concepts>
#include <iosfwd>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace loopmend {

struct Message {
  std::string text;                ///< in English; %1 to %9 stand for the arguments. Empty: nothing is said
  std::vector<Message> arguments;  ///< messages themselves: names and numbers, or parts of a sentence
  std::string code;                ///< for scripts, "outer_rim"; empty for errors and parts
  bool is_verbatim = false;        ///< a name, a number, or another program's text: not translated, has no places

  bool empty() const { return text.empty(); }
  std::string english() const;
  Message with_code(std::string_view name) &&;
  bool operator==(const Message&) const = default;
};

/// A name, a number, or what another program says. Control characters become '?', since files may hold any.
Message verbatim(std::string_view text);

inline Message as_argument(Message message) { return message; }
inline Message as_argument(std::string_view text) { return verbatim(text); }
inline Message as_argument(std::integral auto number) { return verbatim(std::to_string(number)); }
/// Six digits at most: "0.4", "1e-06".
Message as_argument(double number);

/// resources/translations/make_ts.py finds what is to be translated by this call, and by text_to_say(). @param text  a literal
template <class... Arguments>
Message say(const char* text, Arguments&&... arguments) {
  return {text, {as_argument(std::forward<Arguments>(arguments))...}, {}, false};
}

/// Marks a text that is passed on before it is said.
constexpr const char* text_to_say(const char* text) { return text; }

/// Both, one after the other; of an empty one only the other. The code is that of the first that has one.
Message joined(Message first, std::string_view between, Message second);

/// In English.
std::ostream& operator<<(std::ostream& out, const Message& message);

}  // namespace loopmend
