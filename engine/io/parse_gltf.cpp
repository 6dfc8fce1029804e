// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/single_precision.h"
#include "io/color_spaces.h"
#include "io/first_occurrence.h"
#include "io/gltf_document.h"
#include "io/gltf_materials.h"
#include "io/gltf_nodes.h"
#include "io/polygon_soup.h"
#include "io/text_cursor.h"

#include <Eigen/Geometry>
#include <Eigen/LU>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <utility>

namespace loopmend {

namespace {

using Json = GltfDocument::Json;

enum class Mode { triangles = 4, strip = 5, fan = 6 };

/// The arrays of a primitive.
struct Primitive {
  Mode mode = Mode::triangles;
  int material = -1;
  GltfNumbers positions;
  std::optional<GltfNumbers> indices, normals, texture, colors;

  std::size_t size() const { return indices ? indices->count : positions.count; }
};

class GltfReader {
 public:
  explicit GltfReader(const FileContent& file) : document_(file), first_(first_point_table(soup_.points)) {}

  PolygonSoup read() {
    soup_.attributes.materials = read_gltf_materials(document_, soup_.not_kept);
    soup_.attributes.unit = "meter";
    const std::vector<GltfInstance> instances = gltf_instances(document_);
    for (const GltfInstance& instance : instances) read_instance(instance);
    finish_colors();
    finish_values(soup_.attributes.texture, 2);
    finish_values(soup_.attributes.normals, 3);
    finish_names(instances);
    count_asides(instances);
    return std::move(soup_);
  }

 private:
  // -- One mesh at its place -----------------------------------------------------------------------------------------

  void read_instance(const GltfInstance& instance) {
    place_ = instance.place;
    is_placed_ = !place_.isIdentity(0);
    moved_ += is_placed_;
    if (!place_.allFinite())
      document_.errors().fail(say("the transforms of its nodes are too large"), mesh_place(instance.mesh));
    const Eigen::Matrix3d linear = place_.topLeftCorner<3, 3>();
    const double determinant = linear.determinant();
    is_mirrored_ = determinant < 0;
    turn_ = linear;
    if (is_placed_ && std::isfinite(determinant) && determinant != 0) turn_ = linear.inverse().transpose();
    const Json& mesh = document_.element("meshes", instance.mesh, say("nodes"));
    const Json& primitives = document_.list(mesh, "primitives", mesh_place(instance.mesh));
    const std::size_t faces = soup_.polygon_count();
    for (std::size_t k = 0; k < primitives.size(); ++k) {
      where_ = say("mesh %1, primitive %2", instance.mesh, k);
      if (const std::optional<Primitive> primitive = open(primitives[k])) read_primitive(*primitive);
    }
    object_faces_.push_back(soup_.polygon_count() - faces);
  }

  static Message mesh_place(std::size_t mesh) { return say("mesh %1", mesh); }

  /// Nothing for points and lines.
  std::optional<Primitive> open(const Json& json) {
    if (!json.is_object()) document_.errors().fail(say("is no object"), where_);
    const std::size_t mode = document_.whole(json, "mode", where_).value_or(4);
    if (mode < 4) {
      ++soup_.skipped_elements;
      count_not_kept(soup_.not_kept, say("primitives of points and lines"));
      return {};
    }
    if (mode > 6) document_.errors().fail(say("has the unknown mode %1", mode), where_);
    const Json* attributes = GltfDocument::find(json, "attributes");
    const std::optional<std::size_t> positions =
        attributes ? document_.whole(*attributes, "POSITION", where_) : std::nullopt;
    if (!positions) document_.errors().fail(say("has no POSITION"), where_);
    Primitive primitive;
    primitive.mode = static_cast<Mode>(mode);
    primitive.positions = numbers(*positions, 3, 3, "POSITION");
    if (const auto indices = document_.whole(json, "indices", where_)) {
      primitive.indices = numbers(*indices, 1, 1, "indices");
      const int type = primitive.indices->component_type;
      if (type != 5121 && type != 5123 && type != 5125)
        document_.errors().fail(say("its indices are no unsigned numbers"), where_);
      primitive.indices->normalized = false;
    }
    const std::size_t count = primitive.positions.count;
    primitive.normals = of_vertices(*attributes, "NORMAL", 3, 3, count);
    primitive.texture = of_vertices(*attributes, "TEXCOORD_0", 2, 2, count);
    primitive.colors = of_vertices(*attributes, "COLOR_0", 3, 4, count);
    for (const auto& [name, value] : attributes->items())
      if (name != "POSITION" && name != "NORMAL" && name != "TEXCOORD_0" && name != "COLOR_0")
        count_not_kept(soup_.not_kept, say("vertex attributes %1", in_quotes(name)), count);
    if (GltfDocument::find(json, "targets")) count_not_kept(soup_.not_kept, say("primitives with morph targets"));
    if (const auto material = document_.whole(json, "material", where_)) {
      document_.element("materials", *material, where_);
      primitive.material = static_cast<int>(*material);
    }
    return primitive;
  }

  GltfNumbers numbers(std::size_t accessor, int least, int most, const char* name) {
    const GltfNumbers result = document_.numbers(accessor, where_);
    if (result.components < least || result.components > most)
      document_.errors().fail(say("%1 has %2 numbers each", std::string(name), result.components), where_);
    return result;
  }

  std::optional<GltfNumbers> of_vertices(const Json& attributes, const char* name, int least, int most,
                                         std::size_t count) {
    const std::optional<std::size_t> accessor = document_.whole(attributes, name, where_);
    if (!accessor) return {};
    GltfNumbers result = numbers(*accessor, least, most, name);
    if (result.count != count)
      document_.errors().fail(say("%1 has %2 elements for %3 positions", std::string(name), result.count, count),
                              where_);
    if (result.component_type != 5126 && std::string_view(name) == "COLOR_0")
      result.normalized = true;  // else they are none
    return result;
  }

  // -- Vertices ------------------------------------------------------------------------------------------------------

  /// What a vertex of the primitive became.
  struct Vertex {
    int point = -1, texture = -1, normal = -1;
  };

  void read_primitive(const Primitive& primitive) {
    const std::vector<std::size_t> corners = corners_of(primitive);
    require_moderate(corners.size());
    // Only those that are used, in their order: one array may serve many primitives.
    std::vector<std::size_t> used = corners;
    std::sort(used.begin(), used.end());
    used.erase(std::unique(used.begin(), used.end()), used.end());
    unused_ += primitive.positions.count - used.size();
    std::vector<Vertex> vertices;
    vertices.reserve(used.size());
    for (const std::size_t v : used) vertices.push_back(read_vertex(primitive, v));
    const auto vertex_of = [&](std::size_t v) -> const Vertex& {
      if (used.size() == used.back() + 1) return vertices[v];
      return vertices[static_cast<std::size_t>(std::lower_bound(used.begin(), used.end(), v) - used.begin())];
    };
    for (std::size_t f = 0; f + 2 < corners.size(); f += 3) {
      for (std::size_t k = 0; k < 3; ++k) {
        const Vertex& vertex = vertex_of(corners[f + (is_mirrored_ && k > 0 ? 3 - k : k)]);
        soup_.corners.push_back(vertex.point);
        soup_.attributes.texture.at.push_back(vertex.texture);
        soup_.attributes.normals.at.push_back(vertex.normal);
      }
      soup_.close_polygon();
      materials_.push_back(primitive.material);
    }
  }

  /// Three for each triangle. In strips and fans, triangles with a vertex twice only lead to the next ones.
  std::vector<std::size_t> corners_of(const Primitive& primitive) const {
    std::vector<std::size_t> all(primitive.size());
    for (std::size_t k = 0; k < all.size(); ++k) {
      all[k] = primitive.indices ? static_cast<std::size_t>(primitive.indices->value(k, 0)) : k;
      if (all[k] >= primitive.positions.count)
        document_.errors().bad_index(k / 3, all[k], say("there are %1, from 0 on", primitive.positions.count), where_);
    }
    if (primitive.mode == Mode::triangles) {
      if (all.size() % 3 != 0)
        document_.errors().fail(say("%1 corners, which are not three for each triangle", all.size()), where_);
      return all;
    }
    std::vector<std::size_t> corners;
    for (std::size_t k = 0; k + 2 < all.size(); ++k) {
      std::array<std::size_t, 3> t = {all[primitive.mode == Mode::fan ? 0 : k], all[k + 1], all[k + 2]};
      if (primitive.mode == Mode::strip && k % 2 == 1) std::swap(t[1], t[2]);
      if (t[0] != t[1] && t[1] != t[2] && t[2] != t[0]) corners.insert(corners.end(), t.begin(), t.end());
    }
    return corners;
  }

  /// A few bytes can ask for the same triangles again and again.
  void require_moderate(std::size_t more) const {
    constexpr std::size_t always = 6'000'000;
    constexpr std::size_t for_each_byte = 4;
    if (soup_.corners.size() + more > std::max(always, for_each_byte * document_.bytes_read()))
      document_.errors().fail(
          say("the same triangles are shown again and again, in all more than %1", soup_.polygon_count()), where_,
          say("Export it with fewer instances."));
  }

  Vertex read_vertex(const Primitive& primitive, std::size_t v) {
    Vec3 point(primitive.positions.value(v, 0), primitive.positions.value(v, 1), primitive.positions.value(v, 2));
    if (is_placed_) point = (place_ * point.homogeneous()).head<3>();
    if (!point.allFinite()) document_.errors().not_finite(v, where_);
    if (soup_.points.size() == std::numeric_limits<int>::max())
      document_.errors().fail(say("more than 2147483647 vertices"), {});
    const int last = static_cast<int>(soup_.points.size());
    soup_.points.push_back(point);
    Vertex vertex;
    vertex.point = first_.find_or_add(last);
    if (vertex.point != last) {
      soup_.points.pop_back();
      ++soup_.vertices_welded;
    }
    read_color(primitive, v, vertex.point);
    if (primitive.texture) vertex.texture = add_texture(*primitive.texture, v);
    if (primitive.normals) vertex.normal = add_normal(*primitive.normals, v);
    return vertex;
  }

  int add_texture(const GltfNumbers& texture, std::size_t v) {
    CornerValues& values = soup_.attributes.texture;
    const double u = texture.value(v, 0), down = texture.value(v, 1);  // glTF counts from above
    values.values.push_back(std::isfinite(u) ? u : 0);
    values.values.push_back(std::isfinite(down) ? 1 - down : 0);
    return static_cast<int>(values.values.size() / 2) - 1;
  }

  int add_normal(const GltfNumbers& normals, std::size_t v) {
    Vec3 normal(normals.value(v, 0), normals.value(v, 1), normals.value(v, 2));
    if (is_placed_) normal = (turn_ * normal).normalized();
    if (!normal.allFinite()) normal.setZero();
    CornerValues& values = soup_.attributes.normals;
    values.values.insert(values.values.end(), normal.begin(), normal.end());
    return static_cast<int>(values.values.size() / 3) - 1;
  }

  /// Linear in the file. Of several vertices at one place the first one counts.
  void read_color(const Primitive& primitive, std::size_t v, int point) {
    const auto at = static_cast<std::size_t>(point);
    if (!primitive.colors) return;
    Color color = opaque_white;
    for (int k = 0; k < primitive.colors->components; ++k) {
      const double value = primitive.colors->value(v, k);
      if (!std::isfinite(value)) return;
      color.at(static_cast<std::size_t>(k)) = color_channel(k < 3 ? srgb_from_linear(value) : value, 1);
    }
    soup_.colors.resize(soup_.points.size(), opaque_white);
    has_color_.resize(soup_.points.size(), 0);
    if (!std::exchange(has_color_[at], 1))
      soup_.colors[at] = color;
    else
      colors_apart_ += soup_.colors[at] != color;
  }

  // -- The whole -----------------------------------------------------------------------------------------------------

  void finish_colors() {
    if (soup_.colors.empty()) return;
    soup_.colors.resize(soup_.points.size(), opaque_white);
    has_color_.resize(soup_.points.size(), 0);
    soup_.missing_colors = static_cast<std::size_t>(std::count(has_color_.begin(), has_color_.end(), 0));
    count_not_kept(soup_.not_kept, say("further colours at one place"), colors_apart_);
  }

  static void finish_values(CornerValues& values, int dimension) {
    if (values.values.empty())
      values.at.clear();
    else
      values.dimension = dimension;
  }

  void finish_names(const std::vector<GltfInstance>& instances) {
    const std::size_t objects = static_cast<std::size_t>(
        std::count_if(object_faces_.begin(), object_faces_.end(), [](std::size_t n) { return n > 0; }));
    if (objects > 1 || (instances.size() == 1 && !instances[0].name.empty())) {
      FaceNames& names = soup_.attributes.names.emplace_back();
      names.keyword = "o";
      for (std::size_t k = 0; k < instances.size(); ++k) {
        if (object_faces_[k] == 0) continue;
        names.of_face.insert(names.of_face.end(), object_faces_[k], static_cast<int>(names.names.size()));
        names.names.push_back(instances[k].name.empty() ? "object_" + std::to_string(k) : instances[k].name);
      }
    }
    if (!soup_.attributes.materials || soup_.attributes.materials->materials.empty()) return;
    FaceNames& names = soup_.attributes.names.emplace_back();
    names.keyword = "usemtl";
    for (const ScanMaterial& material : soup_.attributes.materials->materials) names.names.push_back(material.name);
    names.of_face = std::move(materials_);
  }

  void count_asides(const std::vector<GltfInstance>& instances) {
    count_not_kept(soup_.not_kept, say("vertices without faces"), unused_);
    count_not_kept(soup_.not_kept, say("transforms of nodes, which are applied"), moved_);
    count_not_kept(soup_.not_kept, say("animations"), document_.list("animations").size());
    count_not_kept(soup_.not_kept, say("skins"), document_.list("skins").size());
    count_not_kept(soup_.not_kept, say("cameras"), document_.list("cameras").size());
    std::vector<char> shown(document_.list("meshes").size(), 0);
    for (const GltfInstance& instance : instances) shown[instance.mesh] = 1;
    count_not_kept(soup_.not_kept, say("meshes that the scene does not show"),
                   static_cast<std::size_t>(std::count(shown.begin(), shown.end(), 0)));
    if (holds_as_floats(soup_.points)) soup_.attributes.coordinates = ScalarType::float32;
  }

  GltfDocument document_;
  PolygonSoup soup_;
  FirstPoint first_;
  Eigen::Matrix4d place_ = Eigen::Matrix4d::Identity();
  Eigen::Matrix3d turn_ = Eigen::Matrix3d::Identity();
  bool is_placed_ = false, is_mirrored_ = false;
  Message where_;
  std::vector<int> materials_;             // per face
  std::vector<std::size_t> object_faces_;  // per instance
  std::vector<char> has_color_;            // per point
  std::size_t colors_apart_ = 0, unused_ = 0, moved_ = 0;
};

}  // namespace

PolygonSoup parse_gltf(const FileContent& file) { return GltfReader(file).read(); }

}  // namespace loopmend
