// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/error.h"
#include "core/path_text.h"

#include <new>

namespace loopmend {

namespace {
Message of_file(const std::filesystem::path& path, Message problem, Message place, Message cure) {
  Message what = joined(verbatim(path_text(path)), ": ", std::move(problem));
  if (!place.empty()) what = Message{"%1 (%2)", {std::move(what), std::move(place)}, {}, false};
  what = Message{"%1.", {std::move(what)}, {}, false};
  return joined(std::move(what), " ", std::move(cure));
}
}  // namespace

ReadError::ReadError(const std::filesystem::path& path, Message problem, Message place, Message cure)
    : Error(of_file(path, std::move(problem), std::move(place), std::move(cure))) {}

WriteError::WriteError(const std::filesystem::path& path, Message problem, Message cure)
    : Error(of_file(path, std::move(problem), {}, std::move(cure))) {}

Message message_of(const std::exception& error) {
  if (const auto* own = dynamic_cast<const Error*>(&error)) return own->message();
  if (dynamic_cast<const std::bad_alloc*>(&error)) return say("there is not enough memory for this");
  return verbatim(error.what());
}

}  // namespace loopmend
