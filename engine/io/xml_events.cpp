// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/xml_events.h"

#include "core/error.h"

#include <expat.h>

#include <algorithm>
#include <cstdint>
#include <exception>
#include <new>
#include <utility>

namespace loopmend {

namespace {

constexpr int deepest_element = 64;
/// Since 2.9, expat wants the names with 64 here (Debian 13 has 2.9, Debian 12 2.5).
#if XML_MAJOR_VERSION > 2 || XML_MINOR_VERSION >= 9
std::uint64_t current_line(XML_Parser parser) { return static_cast<std::uint64_t>(XML_GetCurrentLineNumber64(parser)); }
std::int64_t current_byte(XML_Parser parser) { return static_cast<std::int64_t>(XML_GetCurrentByteIndex64(parser)); }
#else
std::uint64_t current_line(XML_Parser parser) { return XML_GetCurrentLineNumber(parser); }
std::int64_t current_byte(XML_Parser parser) { return XML_GetCurrentByteIndex(parser); }
#endif

/// Of one element or text: expat looks at it again with each piece that arrives.
constexpr std::size_t longest_token = 1 << 22;

}  // namespace

std::string_view local_name(std::string_view name) {
  const std::size_t colon = name.rfind(':');
  return colon == std::string_view::npos ? name : name.substr(colon + 1);
}

std::optional<std::string_view> XmlAttributes::find(std::string_view name) const {
  for (const char* const* pair = pairs_; *pair; pair += 2)
    if (local_name(*pair) == name) return pair[1];
  return {};
}

std::optional<std::string_view> XmlAttributes::find_whole(std::string_view name) const {
  for (const char* const* pair = pairs_; *pair; pair += 2)
    if (*pair == name) return pair[1];
  return {};
}

struct XmlReader::State {
  const FileContent& file;
  std::string part;
  const XmlHandlers& handlers;
  XML_Parser parser;
  int depth = 0;
  std::size_t fed = 0;
  std::exception_ptr thrown{};

  Message place() const { return say("line %1 of %2", current_line(parser), part); }
  [[noreturn]] void fail(const Message& problem) const {
    throw ReadError(file.path, problem, place(), say("The file is damaged or incomplete; export or copy it again."));
  }

  /// Nothing may be thrown through expat.
  template <class Act>
  void guarded(const Act& act) noexcept {
    if (thrown) return;
    try {
      act();
    } catch (...) {
      thrown = std::current_exception();
      XML_StopParser(parser, XML_FALSE);
    }
  }

  static void begin(void* data, const char* name, const char** attributes) {
    auto& state = *static_cast<State*>(data);
    state.guarded([&] {
      if (++state.depth > deepest_element) state.fail(say("the XML is nested more than %1 deep", deepest_element));
      state.handlers.begin(local_name(name), XmlAttributes(attributes));
    });
  }
  static void end(void* data, const char* name) {
    auto& state = *static_cast<State*>(data);
    state.guarded([&] {
      --state.depth;
      state.handlers.end(local_name(name));
    });
  }
  static void text(void* data, const char* text, int size) {
    auto& state = *static_cast<State*>(data);
    state.guarded([&] { state.handlers.text(std::string_view(text, static_cast<std::size_t>(size))); });
  }
  static void doctype(void* data, const char*, const char*, const char*, int) {
    auto& state = *static_cast<State*>(data);
    state.guarded([&] { state.fail(say("the XML has a document type, which 3MF forbids")); });
  }
};

XmlReader::XmlReader(const FileContent& file, std::string part, const XmlHandlers& handlers)
    : state_(new State{file, std::move(part), handlers, XML_ParserCreate(nullptr)}) {
  if (!state_->parser) throw std::bad_alloc();
  XML_SetUserData(state_->parser, state_.get());
  XML_SetElementHandler(state_->parser, &State::begin, &State::end);
  if (handlers.text) XML_SetCharacterDataHandler(state_->parser, &State::text);
  XML_SetStartDoctypeDeclHandler(state_->parser, &State::doctype);
}

XmlReader::~XmlReader() { XML_ParserFree(state_->parser); }

void XmlReader::feed(std::string_view piece) { parse(piece, false); }
void XmlReader::finish() { parse({}, true); }
Message XmlReader::place() const { return state_->place(); }

void XmlReader::parse(std::string_view piece, bool is_last) {
  const XML_Status status = XML_Parse(state_->parser, piece.data(), static_cast<int>(piece.size()), is_last);
  if (state_->thrown) std::rethrow_exception(state_->thrown);
  state_->fed += piece.size();
  if (status == XML_STATUS_OK) {
    const auto done = static_cast<std::size_t>(std::max<std::int64_t>(0, current_byte(state_->parser)));
    if (state_->fed > done + longest_token) state_->fail(say("an element of the XML has no end"));
    return;
  }
  const XML_Error error = XML_GetErrorCode(state_->parser);
  if (error == XML_ERROR_NO_MEMORY) throw std::bad_alloc();
  state_->fail(say("the XML is damaged: %1", XML_ErrorString(error)));
}

}  // namespace loopmend
