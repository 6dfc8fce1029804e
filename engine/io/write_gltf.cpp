// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/error.h"
#include "core/single_precision.h"
#include "io/base64.h"
#include "io/color_spaces.h"
#include "io/format_writers.h"
#include "io/gltf_materials.h"
#include "io/written_triangles.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <tuple>
#include <unordered_map>
#include <utility>
#include <vector>

namespace loopmend {

namespace {

using Json = nlohmann::json;

constexpr std::uint32_t json_chunk = 0x4E4F534A, binary_chunk = 0x004E4942;
constexpr int array_buffer = 34962, index_buffer = 34963;

/// The buffer and what lies in it.
class Buffer {
 public:
  /// The next numbers begin a view of their own. @returns its number
  std::size_t begin_view(int target) {
    bytes_.resize((bytes_.size() + 3) / 4 * 4, '\0');
    Json view = {{"buffer", 0}, {"byteOffset", bytes_.size()}};
    if (target) view["target"] = target;
    views_.push_back(std::move(view));
    return views_.size() - 1;
  }
  void end_view() { views_.back()["byteLength"] = bytes_.size() - views_.back()["byteOffset"].get<std::size_t>(); }

  template <class T>
  void put(T value) {
    bytes_.append(reinterpret_cast<const char*>(&value), sizeof value);  // little endian, as every machine we build for
  }
  void put_bytes(std::string_view bytes) { bytes_ += bytes; }

  /// An accessor of the whole last view.
  std::size_t add_accessor(std::size_t view, int component_type, std::size_t count, const char* shape) {
    accessors_.push_back({{"bufferView", view}, {"componentType", component_type}, {"count", count}, {"type", shape}});
    return accessors_.size() - 1;
  }
  Json& accessor(std::size_t index) { return accessors_[index]; }

  const std::string& bytes() const { return bytes_; }
  const Json& views() const { return views_; }
  const Json& accessors() const { return accessors_; }

 private:
  std::string bytes_;
  Json views_ = Json::array(), accessors_ = Json::array();
};

/// A vertex of a primitive: what its corners have in common. By values, so that a patch shares those at its edge.
struct VertexKey {
  int point = 0;
  std::array<float, 2> texture{};
  std::array<float, 3> normal{};
  bool operator==(const VertexKey&) const = default;
};
struct VertexHash {
  std::size_t operator()(const VertexKey& key) const {
    std::size_t hash = static_cast<std::size_t>(key.point) * 0x9E3779B97F4A7C15ULL;
    for (const float x : {key.texture[0], key.texture[1], key.normal[0], key.normal[1], key.normal[2]})
      hash = (hash ^ std::bit_cast<std::uint32_t>(x + 0.0F)) * 0x9E3779B97F4A7C15ULL;
    return hash ^ (hash >> 29);
  }
};

class GltfWriter {
 public:
  GltfWriter(const std::filesystem::path& path, const TriangleSoup& soup)
      : path_(path),
        soup_(soup),
        shift_(gltf_shift(soup)),
        texture_(soup, &ScanAttributes::texture),
        normals_(soup, &ScanAttributes::normals),
        materials_(write_gltf_materials(written_materials(soup))) {
    read_point_texture();
    const std::vector<AttributeColumn>& columns = attributes_of(soup).points;
    has_point_normals_ = !has_rows(attributes_of(soup).normals) && find_column(columns, "nx") &&
                         find_column(columns, "ny") && find_column(columns, "nz");
    if (!has_point_normals_) return;
    PointRows rows(soup);
    for (std::size_t v = 0; v < soup.points.size(); ++v) {
      const AttributeRow row = rows.next();
      std::array<float, 3>& normal = point_normals_.emplace_back();
      constexpr std::array<const char*, 3> names = {"nx", "ny", "nz"};
      for (std::size_t k = 0; k < 3 && row.table; ++k)
        normal[k] = static_cast<float>(find_column(row.table->points, names[k])->value(row.row));
    }
  }

  void write(Output& out, GltfContainer container) {
    const std::vector<WrittenTriangle> triangles = written_triangles(soup_);
    Json meshes = Json::array(), nodes = Json::array();
    const std::vector<std::string> names = object_names(soup_);
    for (auto& [object, parts] : parts_of(triangles)) {
      Json mesh = Json::object();
      for (const auto& [key, members] : parts) mesh["primitives"].push_back(primitive(key, triangles, members));
      Json node = {{"mesh", meshes.size()}};
      if (object >= 0) mesh["name"] = node["name"] = names.at(static_cast<std::size_t>(object));
      if (shift_ != Vec3::Zero()) node["translation"] = {shift_[0], shift_[1], shift_[2]};
      meshes.push_back(std::move(mesh));
      nodes.push_back(std::move(node));
    }
    Json root = materials_.members;
    root["asset"] = {{"version", "2.0"}, {"generator", "Loopmend"}};
    if (!materials_.copyright.empty()) root["asset"]["copyright"] = materials_.copyright;
    std::vector<std::size_t> roots(nodes.size());
    std::iota(roots.begin(), roots.end(), std::size_t{0});
    root["scene"] = 0;
    root["scenes"] = Json::array({{{"nodes", roots}}});
    root["nodes"] = std::move(nodes);
    root["meshes"] = std::move(meshes);
    add_images(root);
    root["bufferViews"] = buffer_.views();
    root["accessors"] = buffer_.accessors();
    root["buffers"] = Json::array({{{"byteLength", buffer_.bytes().size()}}});
    if (container == GltfContainer::text)
      root["buffers"][0]["uri"] = "data:application/octet-stream;base64," + to_base64(buffer_.bytes());
    put(out, container, dump(root, container == GltfContainer::text ? 1 : -1));
  }

 private:
  /// Primitives have one material, and either all or none of their corners have texture and normals.
  using PartKey = std::tuple<int, bool, bool>;
  using Parts = std::map<PartKey, std::vector<std::size_t>>;

  /// Of scans whose vertices have texture coordinates, and not their corners.
  void read_point_texture() {
    const auto [u, v] = point_texture(attributes_of(soup_));
    if (!u) return;
    PointRows rows(soup_);
    for (std::size_t k = 0; k < soup_.points.size(); ++k) {
      const AttributeRow row = rows.next();
      std::array<float, 2>& texture = point_texture_.emplace_back();
      const AttributeColumn* own_u = row.table ? find_column(row.table->points, u->name()) : nullptr;
      const AttributeColumn* own_v = row.table ? find_column(row.table->points, v->name()) : nullptr;
      if (own_u && own_v) texture = {finite(own_u->value(row.row)), finite(1 - own_v->value(row.row))};
    }
  }

  /// By object, −1 last.
  static std::vector<std::pair<int, Parts>> parts_of(const std::vector<WrittenTriangle>& triangles) {
    std::map<unsigned, Parts> by_object;
    for (std::size_t f = 0; f < triangles.size(); ++f) {
      const WrittenTriangle& t = triangles[f];
      by_object[static_cast<unsigned>(t.object)][{t.material, t.texture[0] >= 0, t.normals[0] >= 0}].push_back(f);
    }
    std::vector<std::pair<int, Parts>> result;
    for (auto& [object, parts] : by_object) result.emplace_back(static_cast<int>(object), std::move(parts));
    return result;
  }

  static std::string dump(const Json& json, int indent) {
    return json.dump(indent, indent < 0 ? ' ' : '\t', false, Json::error_handler_t::replace);  // names may be no UTF-8
  }

  VertexKey key_of(const WrittenTriangle& triangle, std::size_t corner) const {
    VertexKey key{triangle.points[corner], {}, {}};
    if (const int at = triangle.texture[corner]; at >= 0)
      key.texture = {finite(texture_.value(at, 0)), finite(1 - texture_.value(at, 1))};
    if (const int at = triangle.normals[corner]; at >= 0)
      key.normal = {finite(normals_.value(at, 0)), finite(normals_.value(at, 1)), finite(normals_.value(at, 2))};
    return key;
  }
  static float finite(double value) {
    const auto narrow = static_cast<float>(value);
    return std::isfinite(narrow) ? narrow : 0;
  }

  Json primitive(const PartKey& part, const std::vector<WrittenTriangle>& triangles,
                 const std::vector<std::size_t>& members) {
    const auto& [material, has_texture, has_normals] = part;
    std::vector<VertexKey> vertices;
    std::vector<std::int64_t> order;  // per vertex: its place in the file, what is new after it
    std::vector<int> corners;
    std::unordered_map<VertexKey, int, VertexHash> known;
    corners.reserve(3 * members.size());
    for (const std::size_t f : members)
      for (std::size_t k = 0; k < 3; ++k) {
        const WrittenTriangle& t = triangles[f];
        const VertexKey key = key_of(t, k);
        const auto [entry, is_new] = known.try_emplace(key, static_cast<int>(vertices.size()));
        std::int64_t place = has_texture ? t.texture[k] : has_normals ? t.normals[k] : t.points[k];
        // Corner values of patches at old points are new, too: of the file's own vertices the place is the least.
        if (is_new) {
          vertices.push_back(key);
          order.push_back(place);
        } else {
          place = std::min(order[static_cast<std::size_t>(entry->second)], place);
          order[static_cast<std::size_t>(entry->second)] = place;
        }
        corners.push_back(entry->second);
      }
    std::vector<int> sorted(vertices.size()), number(vertices.size());
    std::iota(sorted.begin(), sorted.end(), 0);
    std::stable_sort(sorted.begin(), sorted.end(), [&](int a, int b) {
      return order[static_cast<std::size_t>(a)] < order[static_cast<std::size_t>(b)];
    });
    std::vector<VertexKey> in_order;
    in_order.reserve(vertices.size());
    for (const int v : sorted) {
      number[static_cast<std::size_t>(v)] = static_cast<int>(in_order.size());
      in_order.push_back(vertices[static_cast<std::size_t>(v)]);
    }
    for (int& corner : corners) corner = number[static_cast<std::size_t>(corner)];
    Json json = {{"attributes", attributes(in_order, has_texture, has_normals)},
                 {"indices", indices(corners, in_order.size())}};
    const bool shows_pictures = has_texture || !point_texture_.empty();
    if (material >= 0) json["material"] = shows_pictures ? material : materials_.without_pictures(material);
    return json;
  }

  Json attributes(const std::vector<VertexKey>& vertices, bool has_texture, bool has_normals) {
    Json result = {{"POSITION", positions(vertices)}};
    const auto floats = [&](const char* name, const char* shape, const auto& put) {
      const std::size_t view = buffer_.begin_view(array_buffer);
      for (const VertexKey& vertex : vertices) put(vertex);
      buffer_.end_view();
      result[name] = buffer_.add_accessor(view, 5126, vertices.size(), shape);
    };
    if (has_normals)
      floats("NORMAL", "VEC3", [&](const VertexKey& v) { put_normal(v.normal); });
    else if (has_point_normals_)
      floats("NORMAL", "VEC3",
             [&](const VertexKey& v) { put_normal(point_normals_[static_cast<std::size_t>(v.point)]); });
    if (has_texture)
      floats("TEXCOORD_0", "VEC2", [&](const VertexKey& v) {
        for (const float x : v.texture) buffer_.put(x);
      });
    else if (!point_texture_.empty())
      floats("TEXCOORD_0", "VEC2", [&](const VertexKey& v) {
        for (const float x : point_texture_[static_cast<std::size_t>(v.point)]) buffer_.put(x);
      });
    if (!soup_.colors.empty()) {
      const std::size_t view = buffer_.begin_view(array_buffer);
      for (const VertexKey& vertex : vertices) put_color(soup_.colors[static_cast<std::size_t>(vertex.point)]);
      buffer_.end_view();
      const std::size_t accessor = buffer_.add_accessor(view, 5123, vertices.size(), "VEC4");
      buffer_.accessor(accessor)["normalized"] = true;
      result["COLOR_0"] = accessor;
    }
    return result;
  }

  void put_normal(const std::array<float, 3>& normal) {
    for (const float x : normal) buffer_.put(x);
  }

  /// Linear, with 16 bits: with 8, dark colours would not come back.
  void put_color(const Color& color) {
    for (std::size_t k = 0; k < 4; ++k) {
      const double value = color.at(k) / 255.0;
      buffer_.put(static_cast<std::uint16_t>(std::lround(65535 * (k < 3 ? linear_from_srgb(value) : value))));
    }
  }

  std::size_t positions(const std::vector<VertexKey>& vertices) {
    const std::size_t view = buffer_.begin_view(array_buffer);
    std::array<float, 3> low{}, high{};
    low.fill(std::numeric_limits<float>::max());
    high.fill(std::numeric_limits<float>::lowest());
    for (const VertexKey& vertex : vertices) {
      const Vec3 p = soup_.points[static_cast<std::size_t>(vertex.point)] - shift_;
      for (std::size_t k = 0; k < 3; ++k) {
        const auto x = static_cast<float>(p[static_cast<Eigen::Index>(k)]);
        if (!std::isfinite(x))
          throw WriteError(path_, say("the coordinates are too large for glTF"),
                           say("Save as PLY, or scale the mesh down."));
        low[k] = std::min(low[k], x);
        high[k] = std::max(high[k], x);
        buffer_.put(x);
      }
    }
    buffer_.end_view();
    const std::size_t accessor = buffer_.add_accessor(view, 5126, vertices.size(), "VEC3");
    buffer_.accessor(accessor)["min"] = low;  // as doubles, in which floats have all their digits
    buffer_.accessor(accessor)["max"] = high;
    return accessor;
  }

  std::size_t indices(const std::vector<int>& corners, std::size_t vertices) {
    const bool is_short = vertices < 65535;
    const std::size_t view = buffer_.begin_view(index_buffer);
    for (const int corner : corners) {
      if (is_short)
        buffer_.put(static_cast<std::uint16_t>(corner));
      else
        buffer_.put(static_cast<std::uint32_t>(corner));
    }
    buffer_.end_view();
    return buffer_.add_accessor(view, is_short ? 5123 : 5125, corners.size(), "SCALAR");
  }

  void add_images(Json& root) {
    for (const ScanPicture& image : materials_.images) {
      const std::size_t view = buffer_.begin_view(0);
      buffer_.put_bytes(image.bytes);
      buffer_.end_view();
      Json entry = {{"bufferView", view}, {"mimeType", image.kind}};
      if (!image.name.empty()) entry["name"] = image.name;
      root["images"].push_back(std::move(entry));
    }
  }

  void put(Output& out, GltfContainer container, std::string text) const {
    if (container == GltfContainer::text) {
      out << text << '\n';
      return;
    }
    text.resize((text.size() + 3) / 4 * 4, ' ');
    const std::size_t binary = (buffer_.bytes().size() + 3) / 4 * 4, length = 12 + 8 + text.size() + 8 + binary;
    if (length > std::numeric_limits<std::uint32_t>::max())
      throw WriteError(path_, say("the mesh takes more than the 4 GB of a GLB file"), say("Save as PLY."));
    out << "glTF";
    out.little_endian(std::uint32_t{2});
    out.little_endian(static_cast<std::uint32_t>(length));
    out.little_endian(static_cast<std::uint32_t>(text.size()));
    out.little_endian(json_chunk);
    out << text;
    out.little_endian(static_cast<std::uint32_t>(binary));
    out.little_endian(binary_chunk);
    out << buffer_.bytes() << std::string(binary - buffer_.bytes().size(), '\0');
  }

  const std::filesystem::path& path_;
  const TriangleSoup& soup_;
  Vec3 shift_;
  CornerNumbers texture_, normals_;
  GltfMaterials materials_;
  bool has_point_normals_ = false;
  std::vector<std::array<float, 3>> point_normals_;
  std::vector<std::array<float, 2>> point_texture_;  ///< empty: corners have them, or nothing has
  Buffer buffer_;
};

}  // namespace

Vec3 gltf_shift(const TriangleSoup& soup) {
  Vec3 low = Vec3::Constant(std::numeric_limits<double>::max()), high = -low;
  for (const Vec3& p : soup.points) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  Vec3 shift = Vec3::Zero();
  if (soup.points.empty() || holds_as_floats(soup.points)) return shift;
  // Worth it only where the place costs more digits than the size.
  const double size = (high - low).maxCoeff();
  for (int k = 0; k < 3; ++k) {
    const double middle = low[k] / 2 + high[k] / 2;
    if (!(std::abs(middle) > 2 * size) || !(size > 0)) continue;
    const double step = std::exp2(std::ceil(std::log2(size)));
    shift[k] = std::round(middle / step) * step;
  }
  return shift;
}

void write_gltf(Output& out, const std::filesystem::path& path, const TriangleSoup& soup, GltfContainer container) {
  GltfWriter(path, soup).write(out, container);
}

}  // namespace loopmend
