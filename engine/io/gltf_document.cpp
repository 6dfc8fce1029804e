// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/gltf_document.h"

#include "core/error.h"
#include "core/path_text.h"
#include "io/base64.h"
#include "io/text_cursor.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>

namespace loopmend {

namespace {

using Json = GltfDocument::Json;

constexpr int most_depth = 64;
constexpr double most_whole = 9007199254740992.0;  // 2^53

std::uint32_t word_at(std::string_view bytes, std::size_t at) {
  std::uint32_t word = 0;
  std::memcpy(&word, bytes.data() + at, sizeof word);  // little endian, as every machine we build for
  return word;
}

/// 0: no such type.
std::size_t component_size(int type) {
  switch (type) {
    case 5120:
    case 5121: return 1;
    case 5122:
    case 5123: return 2;
    case 5125:
    case 5126: return 4;
    default: return 0;
  }
}

std::size_t element_size(const GltfNumbers& numbers) {
  return component_size(numbers.component_type) * static_cast<std::size_t>(numbers.components);
}

template <class T>
double load(const char* at, bool normalized) {
  T value;
  std::memcpy(&value, at, sizeof value);
  if (!normalized || std::is_floating_point_v<T>) return static_cast<double>(value);
  return std::max(static_cast<double>(value) / static_cast<double>(std::numeric_limits<T>::max()), -1.0);
}

/// "%20" and its like; nothing where two digits are missing.
std::optional<std::string> without_percent(std::string_view uri) {
  std::string name;
  for (std::size_t k = 0; k < uri.size(); ++k) {
    if (uri[k] != '%') {
      name += uri[k];
      continue;
    }
    const auto digit = [&](std::size_t at) {
      constexpr std::string_view hex = "0123456789abcdef";
      return at < uri.size() ? hex.find(ascii_lower(uri[at])) : std::string_view::npos;
    };
    const std::size_t high = digit(k + 1), low = digit(k + 2);
    if (high == std::string_view::npos || low == std::string_view::npos) return {};
    name += static_cast<char>(16 * high + low);
    k += 2;
  }
  return name;
}

}  // namespace

double GltfNumbers::value(std::size_t element, int component) const {
  const char* at = data + element * stride + static_cast<std::size_t>(component) * component_size(component_type);
  switch (component_type) {
    case 5120: return load<std::int8_t>(at, normalized);
    case 5121: return load<std::uint8_t>(at, normalized);
    case 5122: return load<std::int16_t>(at, normalized);
    case 5123: return load<std::uint16_t>(at, normalized);
    case 5125: return load<std::uint32_t>(at, normalized);
    default: return load<float>(at, normalized);
  }
}

GltfDocument::GltfDocument(const FileContent& file) : file_(file), errors_(file), bytes_read_(file.bytes.size()) {
  open_container();
  try {
    root_ = Json::parse(json_, [&](int depth, Json::parse_event_t, Json&) {
      if (depth > most_depth) errors_.fail(say("the JSON text is nested more than %1 deep", most_depth), {});
      return true;
    });
  } catch (const Json::parse_error& error) {
    errors_.fail(say("the JSON text of this glTF file is damaged"), say("byte %1 of the text", error.byte));
  } catch (const Json::out_of_range&) {
    errors_.fail(say("a number in the JSON text of this glTF file is too large"), {});
  }
  if (!root_.is_object()) errors_.fail(say("the JSON text of this glTF file is no object"), {});
  const Json* asset = find(root_, "asset");
  if (!asset || !asset->is_object()) errors_.fail(say("\"asset\" is missing, which every glTF file has"), {});
  const std::string version = text(*asset, "version");
  if (version.substr(0, 2) != "2.")
    errors_.fail(say("version %1 of glTF", in_quotes(version)), say("asset"),
                 say("Loopmend reads glTF 2; export it again as such."));
  require_known_extensions();
}

void GltfDocument::open_container() {
  const std::string_view bytes = file_.bytes;
  if (bytes.substr(0, 4) != "glTF") {
    json_ = mesh_text(file_);
    return;
  }
  if (bytes.size() < 20) errors_.truncated(say("the header of the GLB file"), {});
  if (word_at(bytes, 4) != 2)
    errors_.fail(say("version %1 of GLB", word_at(bytes, 4)), say("byte 4"),
                 say("Loopmend reads version 2; export it again as such."));
  const std::uint32_t length = word_at(bytes, 8);
  if (length > bytes.size()) errors_.truncated(say("a GLB file of %1 bytes", length), say("byte %1", bytes.size()));
  std::size_t at = 12;
  for (int chunk = 0; at + 8 <= length; ++chunk) {
    const std::size_t size = word_at(bytes, at), left = length - at - 8;
    const std::string_view kind = bytes.substr(at + 4, 4);
    if (size > left)
      errors_.fail(say("chunk %1 says %2 bytes, but there are %3", chunk, size, left), say("byte %1", at));
    const std::string_view content = bytes.substr(at + 8, size);
    if (chunk == 0 && kind != "JSON") errors_.fail(say("the first chunk of the GLB file is no JSON"), say("byte 12"));
    if (chunk == 0) json_ = content;
    if (chunk == 1 && kind == std::string_view("BIN\0", 4)) {
      binary_ = content;
      has_binary_ = true;
    }
    at += 8 + size;
  }
  if (json_.empty()) errors_.fail(say("the GLB file has no JSON chunk"), say("byte 12"));
}

void GltfDocument::require_known_extensions() const {
  for (const Json& name : list("extensionsRequired")) {
    const std::string extension = name.is_string() ? name.get<std::string>() : "?";
    const auto begins = [&](std::string_view with) { return extension.substr(0, with.size()) == with; };
    if (begins("KHR_materials_") || begins("KHR_texture_") || begins("EXT_texture_") ||
        extension == "KHR_mesh_quantization")
      continue;
    const bool compressed = extension == "KHR_draco_mesh_compression" || extension == "EXT_meshopt_compression" ||
                            extension == "KHR_meshopt_compression";
    errors_.fail(compressed ? say("the mesh is compressed with %1, which Loopmend does not know", in_quotes(extension))
                            : say("needs the extension %1, which Loopmend does not know", in_quotes(extension)),
                 say("extensionsRequired"),
                 compressed ? say("Export it without mesh compression.") : say("Export it without."));
  }
}

const Json* GltfDocument::find(const Json& object, const char* name) {
  if (!object.is_object()) return nullptr;
  const auto found = object.find(name);
  return found == object.end() ? nullptr : &*found;
}

const Json& GltfDocument::list(const Json& object, const char* name, const Message& place) const {
  static const Json none = Json::array();
  const Json* value = find(object, name);
  if (!value) return none;
  if (!value->is_array()) errors_.fail(say("%1 is no array", in_quotes(name)), place);
  return *value;
}

const Json& GltfDocument::element(const char* name, std::size_t index, const Message& place) const {
  const Json& all = list(name);
  if (index >= all.size())
    errors_.fail(say("names element %1 of %2, but there are %3, from 0 on", index, in_quotes(name), all.size()), place);
  if (!all[index].is_object()) errors_.fail(say("element %1 of %2 is no object", index, in_quotes(name)), place);
  return all[index];
}

std::optional<std::size_t> GltfDocument::whole(const Json& object, const char* name, const Message& place) const {
  const Json* value = find(object, name);
  if (!value) return {};
  const double number = value->is_number() ? value->get<double>() : -1;
  if (!(number >= 0) || number > most_whole || number != std::floor(number))
    errors_.fail(say("%1 is no whole number from 0 on", in_quotes(name)), place);
  return static_cast<std::size_t>(number);
}

double GltfDocument::number(const Json& value, const Message& place) const {
  if (!value.is_number() || !std::isfinite(value.get<double>()))
    errors_.fail(say("something else stands where a number should be"), place);
  return value.get<double>();
}

std::string GltfDocument::text(const Json& object, const char* name) {
  const Json* value = find(object, name);
  if (!value || !value->is_string()) return {};
  std::string result = value->get<std::string>();
  for (char& c : result)
    if (static_cast<unsigned char>(c) < ' ' || c == '\x7F') c = '_';
  return result;
}

std::string_view GltfDocument::buffer(std::size_t index, const Message& place) {
  const Json& buffer = element("buffers", index, place);
  const Message where = say("buffer %1", index);
  const std::optional<std::size_t> length = whole(buffer, "byteLength", where);
  if (!length) errors_.fail(say("\"byteLength\" is missing"), where);
  std::string_view bytes;
  if (const Json* uri = find(buffer, "uri"); uri && uri->is_string()) {
    const auto [known, is_new] = buffers_.try_emplace(index);
    if (is_new) {
      const auto& name = uri->get_ref<const std::string&>();
      if (is_data(name)) {
        known->second = data_of(name, where);
      } else {
        std::filesystem::path path;
        if (const Message why = find_beside(name, path); !why.empty())
          errors_.fail(why, where, say("Put the buffer beside the file, or export one .glb file."));
        try {
          known->second = load_bytes(path).bytes;
        } catch (const ReadError&) {
          errors_.fail(say("the buffer %1 cannot be read", in_quotes(name)), where,
                       say("Put the buffer beside the file, or export one .glb file."));
        }
      }
      bytes_read_ += known->second.size();
    }
    bytes = known->second;
  } else if (index == 0 && has_binary_) {
    bytes = binary_;
  } else {
    errors_.fail(say("has neither a \"uri\" nor a binary chunk"), where,
                 say("If the mesh is compressed, export it without compression."));
  }
  if (*length > bytes.size()) errors_.fail(say("announces %1 bytes, but there are %2", *length, bytes.size()), where);
  return bytes.substr(0, *length);
}

std::string_view GltfDocument::view(std::size_t index, const Message& place) {
  const Json& view = element("bufferViews", index, place);
  const Message where = say("buffer view %1", index);
  const std::optional<std::size_t> number = whole(view, "buffer", where), length = whole(view, "byteLength", where);
  if (!number || !length) errors_.fail(say("\"buffer\" or \"byteLength\" is missing"), where);
  const std::size_t offset = whole(view, "byteOffset", where).value_or(0);
  const std::string_view all = buffer(*number, where);
  if (offset > all.size() || *length > all.size() - offset)
    errors_.fail(say("bytes %1 to %2 of a buffer of %3", offset, offset + *length, all.size()), where);
  return all.substr(offset, *length);
}

GltfNumbers GltfDocument::numbers(std::size_t index, const Message& place) {
  const Json& accessor = element("accessors", index, place);
  const Message where = say("accessor %1", index);
  const Json* sparse = find(accessor, "sparse");
  GltfNumbers result;
  const std::optional<std::size_t> count = whole(accessor, "count", where),
                                   type = whole(accessor, "componentType", where);
  const std::optional<std::size_t> view_index = whole(accessor, "bufferView", where);
  if (!count || !type) errors_.fail(say("\"count\" or \"componentType\" is missing"), where);
  if (!view_index && !sparse)
    errors_.fail(say("has no data"), where,
                 say("If the mesh is compressed (Draco, meshopt), export it without compression."));
  constexpr std::array<std::string_view, 4> shapes = {"SCALAR", "VEC2", "VEC3", "VEC4"};
  const std::string shape = text(accessor, "type");
  const auto known = std::find(shapes.begin(), shapes.end(), shape);
  const std::size_t size = *type <= 5126 ? component_size(static_cast<int>(*type)) : 0;
  if (known == shapes.end() || size == 0) errors_.fail(say("is of an unknown type"), where);
  result.count = *count;
  result.component_type = static_cast<int>(*type);
  result.components = 1 + static_cast<int>(known - shapes.begin());
  const Json* normalized = find(accessor, "normalized");
  result.normalized = normalized && normalized->is_boolean() && normalized->get<bool>();
  if (view_index) find_elements(result, accessor, where);
  if (sparse) {
    result.data = replaced_elements(result, *sparse, index);
    result.stride = element_size(result);
  }
  return result;
}

void GltfDocument::find_elements(GltfNumbers& numbers, const Json& from, const Message& where) {
  const std::optional<std::size_t> view_index = whole(from, "bufferView", where);
  if (!view_index) errors_.fail(say("\"bufferView\" is missing"), where);
  const std::size_t size = element_size(numbers);
  const std::string_view bytes = view(*view_index, where);
  numbers.stride = whole(element("bufferViews", *view_index, where), "byteStride", where).value_or(size);
  if (numbers.stride < size || numbers.stride > 252)
    errors_.fail(say("its elements of %1 bytes stand %2 bytes apart", size, numbers.stride), where);
  const std::size_t offset = whole(from, "byteOffset", where).value_or(0);
  if (numbers.count > 0 && (offset > bytes.size() || bytes.size() - offset < size ||
                            (bytes.size() - offset - size) / numbers.stride < numbers.count - 1))
    errors_.too_many(say("elements"), numbers.count, say("%1, byte %2 of %3", where, offset, bytes.size()));
  if (numbers.count > 0) numbers.data = bytes.data() + offset;
}

const char* GltfDocument::replaced_elements(const GltfNumbers& numbers, const Json& sparse, std::size_t accessor) {
  const auto [made, is_new] = sparse_.try_emplace(accessor);
  std::string& all = made->second;
  if (!is_new) return all.data();
  const Message where = say("accessor %1, sparse", accessor);
  const Json *places = find(sparse, "indices"), *values = find(sparse, "values");
  const std::optional<std::size_t> count = whole(sparse, "count", where);
  const auto type = places ? whole(*places, "componentType", where) : std::nullopt;
  if (!count || !type || !values) errors_.fail(say("\"count\", \"indices\" or \"values\" is missing"), where);
  if (*type != 5121 && *type != 5123 && *type != 5125) errors_.fail(say("its indices are no unsigned numbers"), where);
  GltfNumbers which, what = numbers;
  which.component_type = static_cast<int>(*type);
  which.components = 1;
  which.count = what.count = *count;
  find_elements(which, *places, where);
  find_elements(what, *values, where);
  const std::size_t size = element_size(numbers);
  // Zeros take no bytes of the file, and many lists may replace elements of one view.
  constexpr std::size_t always = 1 << 26, for_each_byte = 16;
  if (numbers.count > (std::max(always, for_each_byte * bytes_read_) - sparse_bytes_) / size)
    errors_.too_many(say("elements"), numbers.count, where);
  sparse_bytes_ += numbers.count * size;
  all.resize(numbers.count * size, '\0');
  for (std::size_t k = 0; k < numbers.count && numbers.data; ++k)
    std::memcpy(&all[k * size], numbers.data + k * numbers.stride, size);
  for (std::size_t k = 0; k < which.count; ++k) {
    const auto at = static_cast<std::size_t>(which.value(k, 0));
    if (at >= numbers.count)
      errors_.fail(say("replaces element %1, but there are %2, from 0 on", at, numbers.count), where);
    std::memcpy(&all[at * size], what.data + k * what.stride, size);
  }
  return all.data();
}

std::string GltfDocument::data_of(std::string_view uri, const Message& place, std::string* media_type) const {
  const std::size_t comma = uri.find(',');
  const std::string_view head = uri.substr(5, comma == std::string_view::npos ? 0 : comma - 5);
  constexpr std::string_view base64 = ";base64";
  if (comma == std::string_view::npos || head.size() < base64.size() ||
      head.substr(head.size() - base64.size()) != base64)
    errors_.fail(say("the data URI is not of base64"), place);
  std::optional<std::string> bytes = from_base64(uri.substr(comma + 1));
  if (!bytes) errors_.fail(say("the data URI is damaged"), place);
  if (media_type) *media_type = head.substr(0, head.find(';'));
  return std::move(*bytes);
}

Message GltfDocument::find_beside(std::string_view uri, std::filesystem::path& path) const {
  const std::optional<std::string> name = without_percent(uri);
  if (!name || name->empty() || name->find('\0') != std::string::npos) return say("%1 names no file", in_quotes(uri));
  if (name->find(':') != std::string::npos) return say("%1 is not beside the file", in_quotes(*name));
  std::string plain = *name;
  std::replace(plain.begin(), plain.end(), '\\', '/');
  const std::filesystem::path relative = path_of_text(plain);
  if (relative.has_root_path() || std::find(relative.begin(), relative.end(), "..") != relative.end())
    return say("%1 is outside the folder of the file, where nothing is read", in_quotes(*name));
  path = std::filesystem::absolute(file_.path).parent_path() / relative;
  return {};
}

}  // namespace loopmend
