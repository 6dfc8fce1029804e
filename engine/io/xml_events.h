// SPDX-License-Identifier: GPL-3.0-or-later
// XML read piece by piece, by expat.
#pragma once

#include "core/message.h"
#include "io/file_content.h"

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

namespace loopmend {

/// The attributes of an element, by their names without a prefix.
class XmlAttributes {
 public:
  /// @param pairs  as expat has them: name, value, …, null
  explicit XmlAttributes(const char* const* pairs) : pairs_(pairs) {}
  std::optional<std::string_view> find(std::string_view name) const;
  /// By the name with its prefix.
  std::optional<std::string_view> find_whole(std::string_view name) const;

 private:
  const char* const* pairs_;
};

/// A name without its prefix.
std::string_view local_name(std::string_view name);

struct XmlHandlers {
  std::function<void(std::string_view element, const XmlAttributes& attributes)> begin;  ///< names without a prefix
  std::function<void(std::string_view element)> end;
  std::function<void(std::string_view text)> text;  ///< may be empty
};

/// No document type, so no entities; depth is limited. An exception of a handler ends the reading and is passed on.
class XmlReader {
 public:
  /// @param part  for messages. @param file  kept by reference, as the handlers are
  XmlReader(const FileContent& file, std::string part, const XmlHandlers& handlers);
  ~XmlReader();
  XmlReader(const XmlReader&) = delete;
  XmlReader& operator=(const XmlReader&) = delete;

  /// @throws ReadError for bad XML
  void feed(std::string_view piece);
  void finish();
  /// "line 12 of 3D/3dmodel.model"
  Message place() const;

 private:
  struct State;
  void parse(std::string_view piece, bool is_last);
  std::unique_ptr<State> state_;
};

}  // namespace loopmend
