// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/parse_errors.h"
#include "io/ply_header.h"
#include "io/ply_rows.h"
#include "io/polygon_soup.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>

namespace loopmend {

namespace {

/// What a property of a vertex is for us: 0..2 a coordinate, 3..6 red, green, blue, alpha, -1 nothing.
int vertex_role(const PlyProperty& property) {
  static const std::map<std::string_view, int> roles = {
      {"x", 0}, {"y", 1}, {"z", 2}, {"red", 3}, {"green", 4},       {"blue", 5},          {"alpha", 6},
      {"r", 3}, {"g", 4}, {"b", 5}, {"a", 6},   {"diffuse_red", 3}, {"diffuse_green", 4}, {"diffuse_blue", 5}};
  const auto found = roles.find(property.name);
  return property.is_list || found == roles.end() ? -1 : found->second;
}

double full_intensity(PlyType type) {
  if (!is_integer(type)) return 1.0;
  return type == PlyType::uint16 ? 65535.0 : 255.0;
}

/// How to read one row of vertices.
struct VertexPlan {
  std::vector<int> roles;          // per property
  std::array<double, 7> scales{};  // per role
  std::array<bool, 7> present{};   // per role
  bool has_colors() const { return present[3] && present[4] && present[5]; }
};

VertexPlan plan_vertices(const PlyElement& element, const ParseErrors& errors) {
  VertexPlan plan;
  for (const PlyProperty& property : element.properties) {
    int role = vertex_role(property);
    if (role >= 0 && plan.present[static_cast<std::size_t>(role)]) role = -1;  // a second colour of another name
    plan.roles.push_back(role);
    if (role < 0) continue;
    plan.present[static_cast<std::size_t>(role)] = true;
    plan.scales[static_cast<std::size_t>(role)] = full_intensity(property.type);
  }
  if (!plan.present[0] || !plan.present[1] || !plan.present[2]) {
    errors.fail("the vertices have no coordinates x, y and z", element.place, "Export the mesh with vertex positions.");
  }
  return plan;
}

bool is_one_of(const std::string& name, std::initializer_list<const char*> names) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

/// What is lost with a property that is read over, in words. Properties that belong together share theirs.
std::string words_for(const std::string& element, const std::string& property) {
  if (is_one_of(property, {"nx", "ny", "nz"})) return element == "face" ? "face normals" : "normals";
  if (is_one_of(property, {"s", "t", "u", "v", "texture_u", "texture_v", "texcoord"}))
    return element == "face" ? "texture coordinates of faces" : "texture coordinates";
  if (element == "face" && is_one_of(property, {"red", "green", "blue", "alpha", "r", "g", "b", "a"}))
    return "face colours";
  return element + " properties \"" + property + "\"";
}

/// Where the corners stand in a face's row.
struct FacePlan {
  std::size_t corners_at = 0;  // index of the property
};

FacePlan plan_faces(const PlyElement& element, const ParseErrors& errors) {
  for (std::size_t i = 0; i < element.properties.size(); ++i) {
    const PlyProperty& property = element.properties[i];
    if (property.name != "vertex_indices" && property.name != "vertex_index") continue;
    if (!property.is_list || !is_integer(property.type)) {
      errors.fail("the faces' vertex indices are not a list of whole numbers", element.place);
    }
    return {i};
  }
  errors.fail("the faces have no list vertex_indices", element.place, "Export the mesh with polygon faces.");
}

/// Goes through the body once, in the order of the header.
template <class Rows>
class PlyBody {
 public:
  PlyBody(const FileContent& file, const PlyHeader& header)
      : errors_(file),
        header_(header),
        rows_(file, header),
        vertices_(header.find("vertex")),
        file_bytes_(file.bytes.size()) {}

  PolygonSoup read() {
    require_counts();
    std::uint64_t last_row_bytes = 1;
    for (const PlyElement& element : header_.elements) {
      if (element.name == "vertex") {
        read_vertices(element);
      } else if (element.name == "face") {
        read_faces(element);
      } else {
        skip_element(element);
      }
      if (element.count > 0) last_row_bytes = std::max<std::uint64_t>(1, element.least_row_bytes(header_.encoding));
    }
    rows_.end_body(last_row_bytes);
    require_no_strips();
    return std::move(soup_);
  }

 private:
  void require_counts() const {
    if (vertices_ == nullptr) {
      errors_.fail("the header announces no element \"vertex\"", "", "This PLY file holds something else than a mesh.");
    }
    constexpr std::uint64_t most = std::numeric_limits<int>::max();
    if (vertices_->count > most) errors_.fail("more than 2147483647 vertices", vertices_->place);
  }

  void read_vertices(const PlyElement& element) {
    const VertexPlan plan = plan_vertices(element, errors_);
    for (std::size_t i = 0; i < plan.roles.size(); ++i) {
      const bool is_color = plan.roles[i] >= 3 && plan.has_colors();
      const bool is_used = (plan.roles[i] >= 0 && plan.roles[i] < 3) || is_color;
      if (!is_used) note_not_kept(element, element.properties[i]);
    }
    soup_.points.reserve(element.count);
    if (plan.has_colors()) soup_.colors.reserve(element.count);
    for (std::uint64_t v = 0; v < element.count; ++v) {
      rows_.begin_row(element, v);
      read_vertex(element, plan, v);
      rows_.end_row();
    }
  }

  void read_vertex(const PlyElement& element, const VertexPlan& plan, std::uint64_t v) {
    std::array<double, 7> values = {0.0, 0.0, 0.0, 0.0, 0.0, 0.0, plan.scales[6]};
    for (std::size_t i = 0; i < plan.roles.size(); ++i) {
      if (plan.roles[i] >= 0) {
        values[static_cast<std::size_t>(plan.roles[i])] = rows_.number(element.properties[i].type);
      } else {
        skip(element.properties[i]);
      }
    }
    const Vec3 point(values[0], values[1], values[2]);
    if (!point.allFinite()) errors_.not_finite(v, rows_.place());
    soup_.points.push_back(point);
    if (plan.has_colors()) add_color(plan, values);
  }

  void add_color(const VertexPlan& plan, const std::array<double, 7>& values) {
    Color color = opaque_white;
    const bool finite = std::isfinite(values[3] + values[4] + values[5]);
    soup_.missing_colors += finite ? 0 : 1;
    for (std::size_t c = 0; c < 3 && finite; ++c) color[c] = color_channel(values[3 + c], plan.scales[3 + c]);
    if (plan.present[6] && std::isfinite(values[6])) color[3] = color_channel(values[6], plan.scales[6]);
    soup_.colors.push_back(color);
  }

  void read_faces(const PlyElement& element) {
    if (element.count == 0) return;
    const FacePlan plan = plan_faces(element, errors_);
    for (std::size_t i = 0; i < element.properties.size(); ++i)
      if (i != plan.corners_at) note_not_kept(element, element.properties[i]);
    const std::uint64_t believable = std::min<std::uint64_t>(element.count, file_bytes_ / 4);  // 4 bytes: a list of 3
    soup_.ends.reserve(believable);
    soup_.corners.reserve(3 * believable);
    for (std::uint64_t f = 0; f < element.count; ++f) {
      rows_.begin_row(element, f);
      for (std::size_t i = 0; i < element.properties.size(); ++i) {
        if (i == plan.corners_at) {
          read_corners(element.properties[i], f);
        } else {
          skip(element.properties[i]);
        }
      }
      rows_.end_row();
    }
  }

  void read_corners(const PlyProperty& list, std::uint64_t f) {
    const std::uint64_t length = rows_.list_length(list);
    if (length < 3) errors_.too_few_corners(f, length, rows_.place());
    for (std::uint64_t i = 0; i < length; ++i) {
      const std::int64_t index = rows_.integer(list.type);
      if (index < 0 || static_cast<std::uint64_t>(index) >= vertices_->count) {
        errors_.bad_index(f, std::to_string(index), "there are " + std::to_string(vertices_->count) + ", from 0 on",
                          rows_.place());
      }
      soup_.corners.push_back(static_cast<int>(index));
    }
    soup_.close_polygon();
  }

  void skip_element(const PlyElement& element) {
    if (element.properties.empty()) return;
    soup_.skipped_elements += element.count;
    count_not_kept(soup_.not_kept, "elements \"" + element.name + "\"", element.count);
    for (std::uint64_t row = 0; row < element.count; ++row) {
      rows_.begin_row(element, row);
      for (const PlyProperty& property : element.properties) skip(property);
      rows_.end_row();
    }
  }

  /// Properties that share their words, such as nx, ny and nz, are one thing for each row.
  void note_not_kept(const PlyElement& element, const PlyProperty& property) {
    const std::string words = words_for(element.name, property.name);
    const bool known = std::any_of(soup_.not_kept.begin(), soup_.not_kept.end(),
                                   [&](const NotKept& entry) { return entry.what == words; });
    if (!known) count_not_kept(soup_.not_kept, words, element.count);
  }

  void skip(const PlyProperty& property) {
    const std::uint64_t count = property.is_list ? rows_.list_length(property) : 1;
    rows_.skip(property.type, count);
  }

  /// Leaving strips out would show a part of the file as if it were all.
  void require_no_strips() const {
    const PlyElement* strips = header_.find("tristrips");
    if (strips == nullptr || strips->count == 0) return;
    errors_.fail("the triangles are stored as strips, which Loopmend does not read", strips->place,
                 "Convert the file to plain faces, for example with MeshLab.");
  }

  ParseErrors errors_;
  const PlyHeader& header_;
  Rows rows_;
  const PlyElement* vertices_;
  std::uint64_t file_bytes_;
  PolygonSoup soup_;
};

}  // namespace

PolygonSoup parse_ply(const FileContent& file) {
  const PlyHeader header = parse_ply_header(file);
  if (header.encoding == PlyEncoding::ascii) return PlyBody<PlyTextRows>(file, header).read();
  return PlyBody<PlyBinaryRows>(file, header).read();
}

}  // namespace loopmend
