// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/single_precision.h"
#include "core/threads.h"
#include "io/lone_places.h"
#include "io/parse_errors.h"
#include "io/ply_header.h"
#include "io/ply_rows.h"
#include "io/polygon_soup.h"
#include "io/text_rows.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <limits>
#include <map>
#include <optional>

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
    if (role >= 0 && plan.present[role]) role = -1;  // a second colour of another name
    plan.roles.push_back(role);
    if (role < 0) continue;
    plan.present[role] = true;
    plan.scales[role] = full_intensity(property.type);
  }
  if (!plan.present[0] || !plan.present[1] || !plan.present[2]) {
    errors.fail(say("the vertices have no coordinates x, y and z"), element.place,
                say("Export the mesh with vertex positions."));
  }
  return plan;
}

AttributeColumn column_for(const PlyProperty& property) {
  return {property.name, property.type, property.is_list ? std::optional(property.count_type) : std::nullopt};
}

/// Whether the coordinates may be written as single precision: the file says so of all of them.
bool are_floats(const PlyElement& vertices) {
  return std::none_of(vertices.properties.begin(), vertices.properties.end(), [](const PlyProperty& property) {
    const int role = vertex_role(property);
    return role >= 0 && role < 3 && property.type != PlyType::float32;
  });
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
      errors.fail(say("the faces' vertex indices are not a list of whole numbers"), element.place);
    }
    return {i};
  }
  errors.fail(say("the faces have no list vertex_indices"), element.place, say("Export the mesh with polygon faces."));
}

constexpr std::size_t rows_in_block = 1 << 16;
int block_count(std::size_t rows) { return static_cast<int>((rows + rows_in_block - 1) / rows_in_block); }
std::size_t block_begin(int block) { return rows_in_block * static_cast<std::size_t>(block); }

/// Goes through the body once, in the order of the header.
template <class Rows>
class PlyBody {
 public:
  PlyBody(const FileContent& file, const PlyHeader& header, FloatText float_text)
      : errors_(file),
        header_(header),
        float_text_(float_text),
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
      } else if (element.name == "tristrips") {
        read_strips(element);
      } else {
        read_element(element);
      }
      if (element.count > 0) last_row_bytes = std::max<std::uint64_t>(1, element.least_row_bytes(header_.encoding));
    }
    rows_.end_body(last_row_bytes);
    lone_.finish(soup_, errors_);
    soup_.attributes.remarks = header_.remarks;
    drop_columns_of_some_faces();
    move_corner_texture();
    return std::move(soup_);
  }

 private:
  void require_counts() const {
    if (vertices_ == nullptr) {
      errors_.fail(say("the header announces no element \"vertex\""), {},
                   say("This PLY file holds something else than a mesh."));
    }
    constexpr std::uint64_t most = std::numeric_limits<int>::max();
    if (vertices_->count > most) errors_.fail(say("more than 2147483647 vertices"), vertices_->place);
  }

  void read_vertices(const PlyElement& element) {
    const VertexPlan plan = plan_vertices(element, errors_);
    std::vector<AttributeColumn>& columns = soup_.attributes.points;
    std::vector<int> column_of(plan.roles.size(), -1);  // all but the coordinates
    for (std::size_t i = 0; i < plan.roles.size(); ++i) {
      if (plan.roles[i] >= 0 && plan.roles[i] < 3) continue;
      column_of[i] = static_cast<int>(columns.size());
      columns.push_back(column_for(element.properties[i]));
      columns.back().reserve(believable(element));
    }
    if (columns.empty() && read_plain_points(element, plan)) {
      take_precision(element);
      return;
    }
    soup_.points.reserve(element.count);
    if (plan.has_colors()) soup_.colors.reserve(element.count);
    for (std::uint64_t v = 0; v < element.count; ++v) {
      rows_.begin_row(element, v);
      read_vertex(element, plan, column_of, v);
      rows_.end_row();
    }
    take_precision(element);
  }

  /// Coordinates that the file declares as floats are floats, also those of text, unless all its digits are asked for.
  void take_precision(const PlyElement& element) {
    bool floats = are_floats(element);
    if (floats && float_text_ == FloatText::all_digits) {
      floats = holds_as_floats(soup_.points);
    } else if (floats && Rows::is_text) {
      const FloatRounding rounding = round_to_floats(soup_.points);
      floats = rounding.in_range;
      Message what = say("vertices of more digits than the single precision that the file declares, kept");
      if (floats)
        what =
            say("vertices of more digits than the single precision that the file declares, rounded to it "
                "(--double keeps them)");
      count_not_kept(soup_.oddities, what, rounding.longer);
    }
    if (floats) soup_.attributes.coordinates = PlyType::float32;
  }

  /// Coordinates alone, by blocks, straight from the bytes. @returns false, and reads nothing, where something is out of the
  /// common: value by value, an error then names its place.
  bool read_plain_points(const PlyElement& element, const VertexPlan& plan) {
    const PlyType type = element.properties.front().type;
    const bool plain = element.properties.size() == 3 && (type == PlyType::float32 || type == PlyType::float64) &&
                       element.properties[1].type == type && element.properties[2].type == type;
    const std::size_t size = size_in_bytes(type), count = element.count;
    if constexpr (Rows::is_text) return plain && read_lines_of_points(plan, count);
    const std::string_view bytes = bytes_left();
    if (!plain || bytes.size() / (3 * size) < count) return false;
    soup_.points.resize(count);
    std::atomic<bool> finite{true};
    parallel_for(0, block_count(count), 1, [&](int block) {
      bool all_finite = true;
      for (std::size_t v = block_begin(block); v < std::min(block_begin(block + 1), count); ++v) {
        const char* row = bytes.data() + 3 * size * v;
        for (std::size_t c = 0; c < 3; ++c)
          soup_.points[v][plan.roles[c]] = type == PlyType::float32 ? static_cast<double>(loaded<float>(row + size * c))
                                                                    : loaded<double>(row + size * c);
        all_finite = all_finite && soup_.points[v].allFinite();
      }
      if (!all_finite) finite = false;
    });
    if (!finite) {
      soup_.points.clear();
      return false;
    }
    skip(3 * size * count);
    return true;
  }

  /// The same for faces that are triangles, with nothing else in their rows.
  bool read_plain_triangles(const PlyElement& element) {
    constexpr std::size_t row_size = 1 + 3 * sizeof(std::int32_t);
    const PlyProperty& list = element.properties.front();
    const bool plain = element.properties.size() == 1 &&
                       (list.count_type == PlyType::uint8 || list.count_type == PlyType::int8) &&
                       (list.type == PlyType::int32 || list.type == PlyType::uint32);
    const std::size_t count = element.count;
    if constexpr (Rows::is_text) return plain && read_lines_of_triangles(count);
    const std::string_view bytes = bytes_left();
    if (!plain || bytes.size() / row_size < count) return false;
    const std::size_t begin = soup_.corners.size();
    const auto most = static_cast<std::uint32_t>(vertices_->count);
    soup_.corners.resize(begin + 3 * count);
    std::atomic<bool> regular{true};
    parallel_for(0, block_count(count), 1, [&](int block) {
      bool all_regular = true;
      for (std::size_t f = block_begin(block); f < std::min(block_begin(block + 1), count); ++f) {
        const char* row = bytes.data() + row_size * f;
        all_regular = all_regular && *row == 3;
        for (std::size_t c = 0; c < 3; ++c) {
          const auto index = loaded<std::uint32_t>(row + 1 + sizeof(std::uint32_t) * c);
          all_regular = all_regular && index < most;
          soup_.corners[begin + 3 * f + c] = static_cast<int>(index);
        }
      }
      if (!all_regular) regular = false;
    });
    if (!regular) {
      soup_.corners.resize(begin);
      return false;
    }
    soup_.close_triangles(count);
    skip(row_size * count);
    return true;
  }

  /// Of text: a row on each line.
  bool read_lines_of_points(const VertexPlan& plan, std::size_t count) {
    if (count > file_bytes_ / 6) return false;  // "0 0 0\n"
    soup_.points.resize(count);
    const auto keep = [&](std::size_t v, const double* numbers) {
      for (std::size_t c = 0; c < 3; ++c) soup_.points[v][plan.roles[c]] = numbers[c];
      return soup_.points[v].allFinite();
    };
    if (skip_lines(read_rows(lines_left(), count, 3, KeepRow(keep)), count)) return true;
    soup_.points.clear();
    return false;
  }

  bool read_lines_of_triangles(std::size_t count) {
    if (count > file_bytes_ / 8) return false;  // "3 0 1 2\n"
    const std::size_t begin = soup_.corners.size();
    const auto most = static_cast<std::int64_t>(vertices_->count);
    soup_.corners.resize(begin + 3 * count);
    const auto keep = [&](std::size_t f, const std::int64_t* numbers) {
      for (std::size_t c = 0; c < 3; ++c) {
        if (numbers[c + 1] < 0 || numbers[c + 1] >= most) return false;
        soup_.corners[begin + 3 * f + c] = static_cast<int>(numbers[c + 1]);
      }
      return numbers[0] == 3;
    };
    if (skip_lines(read_rows(lines_left(), count, 4, KeepIntegers(keep)), count)) {
      soup_.close_triangles(count);
      return true;
    }
    soup_.corners.resize(begin);
    return false;
  }

  std::string_view lines_left() const {
    if constexpr (Rows::is_text) return rows_.next_lines();
    return {};
  }
  /// @returns whether there is something to skip.
  bool skip_lines(const std::optional<std::size_t>& bytes, std::size_t lines) {
    if constexpr (Rows::is_text)
      if (bytes) rows_.skip_lines(*bytes, lines);
    return bytes.has_value();
  }
  std::string_view bytes_left() const {
    if constexpr (!Rows::is_text) return rows_.native_bytes();
    return {};
  }
  void skip(std::size_t bytes) {
    if constexpr (!Rows::is_text) rows_.skip(bytes);
  }

  void read_vertex(const PlyElement& element, const VertexPlan& plan, const std::vector<int>& column_of,
                   std::uint64_t v) {
    std::array<double, 7> values = {0.0, 0.0, 0.0, 0.0, 0.0, 0.0, plan.scales[6]};
    for (std::size_t i = 0; i < plan.roles.size(); ++i) {
      double* value = plan.roles[i] >= 0 ? &values[plan.roles[i]] : nullptr;
      if (column_of[i] < 0) {
        *value = rows_.carried(element.properties[i].type);
      } else {
        const double carried = read_into(soup_.attributes.points[column_of[i]], element.properties[i]);
        if (value != nullptr) *value = carried;
      }
    }
    const Vec3 point(values[0], values[1], values[2]);
    soup_.points.push_back(lone_.checked(point, static_cast<int>(v), v, [&] { return rows_.place(); }));
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
    std::vector<AttributeColumn>& columns = soup_.attributes.faces;
    for (std::size_t i = 0; i < element.properties.size(); ++i)
      if (i != plan.corners_at) columns.push_back(column_for(element.properties[i]));
    for (AttributeColumn& column : columns) column.reserve(believable(element));
    if (columns.empty() && read_plain_triangles(element)) return;
    soup_.corners.reserve(soup_.corners.size() + 3 * believable(element));
    for (std::uint64_t f = 0; f < element.count; ++f) {
      rows_.begin_row(element, f);
      const std::size_t faces_before = soup_.polygon_count();
      std::size_t column = 0;
      for (std::size_t i = 0; i < element.properties.size(); ++i) {
        if (i == plan.corners_at) {
          read_corners(element.properties[i], f);
        } else {
          read_into(columns[column++], element.properties[i]);
        }
      }
      if (soup_.polygon_count() == faces_before)
        for (AttributeColumn& of_none : columns) of_none.pop_row();
      rows_.end_row();
    }
  }

  /// What is announced can be many times what is there.
  std::size_t believable(const PlyElement& element) const {
    return std::min<std::uint64_t>(element.count, file_bytes_ / 4);  // 4 bytes: a list of 3
  }

  void read_corners(const PlyProperty& list, std::uint64_t f) {
    const std::uint64_t length = rows_.list_length(list);
    const std::size_t begin = soup_.corners.size();
    for (std::uint64_t i = 0; i < length; ++i) {
      const std::int64_t index = rows_.integer(list.type);
      require_vertex(index, f);
      soup_.corners.push_back(static_cast<int>(index));
    }
    soup_.close_face(begin);
  }

  /// Rows that are neither vertices nor faces: kept as they are.
  void read_element(const PlyElement& element) {
    if (element.properties.empty()) return;
    OtherElement& other = soup_.attributes.elements.emplace_back();
    other.name = element.name;
    other.rows = element.count;
    for (const PlyProperty& property : element.properties) other.columns.push_back(column_for(property));
    for (std::uint64_t row = 0; row < element.count; ++row) {
      rows_.begin_row(element, row);
      for (std::size_t i = 0; i < element.properties.size(); ++i) read_into(other.columns[i], element.properties[i]);
      rows_.end_row();
    }
  }

  /// @returns the value, of a list the last.
  double read_into(AttributeColumn& column, const PlyProperty& property) {
    double value = 0;
    if (!property.is_list) {
      value = rows_.carried(property.type);
      column.push(value);
      return value;
    }
    for (std::uint64_t items = rows_.list_length(property); items > 0; --items)
      column.push_item(value = rows_.carried(property.type));
    column.end_list();
    return value;
  }

  /// Triangle strips: each vertex makes a triangle with the two before it, every second one turned round; −1 begins again.
  void read_strips(const PlyElement& element) {
    if (element.count == 0) return;
    const FacePlan plan = plan_faces(element, errors_);
    for (std::uint64_t row = 0; row < element.count; ++row) {
      rows_.begin_row(element, row);
      for (std::size_t i = 0; i < element.properties.size(); ++i) {
        if (i == plan.corners_at) {
          read_strip(element.properties[i], row);
        } else {
          AttributeColumn unused = column_for(element.properties[i]);
          read_into(unused, element.properties[i]);
        }
      }
      rows_.end_row();
    }
    for (std::size_t i = 0; i < element.properties.size(); ++i)
      if (i != plan.corners_at)
        count_not_kept(soup_.not_kept, say("strip properties \"%1\"", element.properties[i].name), element.count);
  }

  void read_strip(const PlyProperty& list, std::uint64_t row) {
    std::array<int, 2> last{};
    std::size_t length = 0;
    for (std::uint64_t left = rows_.list_length(list); left > 0; --left) {
      const std::int64_t index = rows_.integer(list.type);
      if (index == -1) {
        length = 0;
        continue;
      }
      require_vertex(index, row);
      const int v = static_cast<int>(index);
      if (length >= 2) {
        const bool turned = length % 2 == 1;
        // A vertex twice is how strips jump: no triangle.
        if (v != last[0] && v != last[1] && last[0] != last[1]) {
          soup_.corners.insert(soup_.corners.end(), {last[turned], last[!turned], v});
          soup_.close_polygon();
        }
      }
      last = {last[1], v};
      ++length;
    }
  }

  /// Of a file with both, faces have properties that strips have not.
  void drop_columns_of_some_faces() {
    std::erase_if(soup_.attributes.faces, [&](const AttributeColumn& column) {
      if (column.rows() == soup_.polygon_count()) return false;
      count_not_kept(soup_.not_kept, say("face properties \"%1\"", column.name()), column.rows());
      return true;
    });
  }

  /// MeshLab's texture coordinates, two for each corner of a face, follow the corners wherever those go.
  void move_corner_texture() {
    std::vector<AttributeColumn>& columns = soup_.attributes.faces;
    const auto found = std::find_if(columns.begin(), columns.end(), [](const AttributeColumn& column) {
      return column.name() == "texcoord" && column.is_list() && column.type() == PlyType::float32;
    });
    if (found == columns.end()) return;
    for (std::size_t f = 0; f < soup_.polygon_count(); ++f)
      if (const std::size_t items = found->items(f); items != 0 && items != 2 * soup_.polygon(f).size()) return;
    CornerValues& texture = soup_.attributes.texture;
    texture.dimension = 2;
    for (std::size_t f = 0; f < soup_.polygon_count(); ++f) {
      const bool has_any = found->items(f) > 0;
      for (std::size_t k = 0; k < soup_.polygon(f).size(); ++k) {
        texture.at.push_back(has_any ? static_cast<int>(texture.count()) : -1);
        if (has_any) texture.values.insert(texture.values.end(), {found->value(f, 2 * k), found->value(f, 2 * k + 1)});
      }
    }
    columns.erase(found);
  }

  void require_vertex(std::int64_t index, std::uint64_t row) const {
    if (index >= 0 && static_cast<std::uint64_t>(index) < vertices_->count) return;
    errors_.bad_index(row, index, say("there are %1, from 0 on", vertices_->count), rows_.place());
  }

  ParseErrors errors_;
  const PlyHeader& header_;
  FloatText float_text_;
  Rows rows_;
  const PlyElement* vertices_;
  std::uint64_t file_bytes_;
  LonePlaces lone_;
  PolygonSoup soup_;
};

}  // namespace

PolygonSoup parse_ply(const FileContent& file, FloatText float_text) {
  const PlyHeader header = parse_ply_header(file);
  if (header.encoding == PlyEncoding::ascii) return PlyBody<PlyTextRows>(file, header, float_text).read();
  return PlyBody<PlyBinaryRows>(file, header, float_text).read();
}

}  // namespace loopmend
