// SPDX-License-Identifier: GPL-3.0-or-later
// Small glTF files made by code: a JSON text with its buffer, in each of the containers.
#pragma once

#include "io/base64.h"

#include <nlohmann/json.hpp>

#include <cstdint>
#include <initializer_list>
#include <string>
#include <string_view>

namespace loopmend {

struct GltfFile {
  nlohmann::json json = {{"asset", {{"version", "2.0"}}}};
  std::string buffer;

  template <class T>
  static std::string packed(std::initializer_list<T> numbers) {
    std::string bytes;
    for (const T x : numbers) bytes.append(reinterpret_cast<const char*>(&x), sizeof x);
    return bytes;
  }

  /// An accessor with a view of its own. @returns its number
  std::size_t add(std::string_view bytes, int component_type, std::size_t count, const char* shape) {
    buffer.resize((buffer.size() + 3) / 4 * 4, '\0');
    json["bufferViews"].push_back({{"buffer", 0}, {"byteOffset", buffer.size()}, {"byteLength", bytes.size()}});
    buffer += bytes;
    json["accessors"].push_back({{"bufferView", json["bufferViews"].size() - 1},
                                 {"componentType", component_type},
                                 {"count", count},
                                 {"type", shape}});
    return json["accessors"].size() - 1;
  }

  nlohmann::json& primitive(std::size_t mesh = 0, std::size_t index = 0) {
    return json["meshes"][mesh]["primitives"][index];
  }

  std::string glb() const {
    nlohmann::json whole = json;
    if (!whole.contains("buffers")) whole["buffers"] = {{{"byteLength", buffer.size()}}};
    return glb_of(whole.dump(), buffer);
  }
  std::string text() const { return text_with("data:application/octet-stream;base64," + to_base64(buffer)); }
  std::string text_with(const std::string& uri) const {
    nlohmann::json whole = json;
    whole["buffers"] = {{{"byteLength", buffer.size()}, {"uri", uri}}};
    return whole.dump();
  }

  static std::string glb_of(std::string text, std::string binary) {
    text.resize((text.size() + 3) / 4 * 4, ' ');
    binary.resize((binary.size() + 3) / 4 * 4, '\0');
    const auto word = [](std::size_t value) { return packed({static_cast<std::uint32_t>(value)}); };
    return "glTF" + word(2) + word(12 + 8 + text.size() + 8 + binary.size()) + word(text.size()) + "JSON" + text +
           word(binary.size()) + std::string("BIN\0", 4) + binary;
  }
};

/// A square of two triangles, four vertices with indices of 16 bits; its texture coordinates are the places, from above.
inline GltfFile gltf_square() {
  GltfFile file;
  const std::size_t positions =
      file.add(GltfFile::packed<float>({0, 0, 0.1F, 1, 0, 0, 1, 1, 0, 0, 1, 0}), 5126, 4, "VEC3");
  const std::size_t indices = file.add(GltfFile::packed<std::uint16_t>({0, 1, 2, 0, 2, 3}), 5123, 6, "SCALAR");
  const std::size_t texture = file.add(GltfFile::packed<float>({0, 1, 1, 1, 1, 0, 0, 0}), 5126, 4, "VEC2");
  file.primitive() = {{"attributes", {{"POSITION", positions}, {"TEXCOORD_0", texture}}}, {"indices", indices}};
  return file;
}

}  // namespace loopmend
