// SPDX-License-Identifier: GPL-3.0-or-later
// Internal: the JSON text of a glTF file and the arrays of numbers that it describes, every access within its bounds.
#pragma once

#include "core/message.h"
#include "io/file_content.h"
#include "io/parse_errors.h"

#include <nlohmann/json.hpp>

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <string_view>

namespace loopmend {

/// Numbers in a buffer: `count` elements of `components` numbers.
struct GltfNumbers {
  const char* data = nullptr;
  std::size_t count = 0, stride = 0;
  int component_type = 0, components = 0;
  bool normalized = false;

  /// Normalised integers as fractions of 1. Both indices must be in range.
  double value(std::size_t element, int component) const;
};

class GltfDocument {
 public:
  using Json = nlohmann::json;

  /// @param file  kept by reference. @throws ReadError for a damaged container, bad JSON, another version, or an extension
  /// that must be known and is not
  explicit GltfDocument(const FileContent& file);

  const Json& root() const { return root_; }
  const ParseErrors& errors() const { return errors_; }

  /// The array of that name at the root; an empty one where there is none.
  const Json& list(const char* name) const { return list(root_, name, say("the file")); }
  const Json& list(const Json& object, const char* name, const Message& place) const;
  /// An element of a list at the root, an object. @throws ReadError where it is not there
  const Json& element(const char* name, std::size_t index, const Message& place) const;
  /// A whole number from 0 on; nothing where there is none of that name.
  std::optional<std::size_t> whole(const Json& object, const char* name, const Message& place) const;
  /// A finite number, 0 where the element of the array is none.
  double number(const Json& value, const Message& place) const;
  /// A string, its control characters replaced; empty where there is none.
  static std::string text(const Json& object, const char* name);
  static const Json* find(const Json& object, const char* name);

  /// @throws ReadError where it is none, compressed, or not wholly within its buffer
  GltfNumbers numbers(std::size_t accessor, const Message& place);
  /// The bytes of a buffer view. @throws ReadError where it does not lie within its buffer
  std::string_view view(std::size_t index, const Message& place);
  /// What the file and its buffers hold: the parts that were asked for.
  std::size_t bytes_read() const { return bytes_read_; }

  /// "data:MEDIA;base64,…": the bytes, and the media type. @throws ReadError for another kind of data URI
  static bool is_data(std::string_view uri) { return uri.substr(0, 5) == "data:"; }
  std::string data_of(std::string_view uri, const Message& place, std::string* media_type = nullptr) const;
  /// A file beside this one. @returns why the URI names none that may be read; empty: `path` is set
  Message find_beside(std::string_view uri, std::filesystem::path& path) const;

 private:
  void open_container();
  void require_known_extensions() const;
  std::string_view buffer(std::size_t index, const Message& place);
  /// Sets the data and the stride. @param from  with "bufferView" and "byteOffset"
  void find_elements(GltfNumbers& numbers, const Json& from, const Message& where);
  /// A copy of the elements, of zeros where they have no data, with those that the sparse list names replaced.
  const char* replaced_elements(const GltfNumbers& numbers, const Json& sparse, std::size_t accessor);

  const FileContent& file_;
  ParseErrors errors_;
  std::string_view json_, binary_;
  bool has_binary_ = false;
  Json root_;
  std::map<std::size_t, std::string> buffers_;
  std::map<std::size_t, std::string> sparse_;  // per accessor that is one
  std::size_t bytes_read_, sparse_bytes_ = 0;
};

}  // namespace loopmend
