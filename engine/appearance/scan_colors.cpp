// SPDX-License-Identifier: GPL-3.0-or-later
#include "appearance/scan_colors.h"

#include "core/error.h"
#include "core/path_text.h"
#include "filling/fairing.h"
#include "io/texture_files.h"
#include "operators/operator_set.h"
#include "texture/texture_of_triangles.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>
#include <optional>
#include <utility>

namespace loopmend {

namespace {

constexpr Color without_color{204, 200, 193, 255};

unsigned char channel(double value) { return static_cast<unsigned char>(std::lround(std::clamp(value, 0.0, 255.0))); }

/// A colour's channel, 0..255. @param value  in the column's type: fractions of 1, or integers up to 255, of 16 bits up to 65535
double full_channel(const AttributeColumn& column, double value) {
  if (!is_integer(column.type())) return 255 * value;
  return column.type() == ScalarType::uint16 ? value * 255 / 65535 : value;
}

/// Of the faces of a PLY file (red, green, blue) or an OFF file (a list of three or four numbers).
class FaceColors {
 public:
  explicit FaceColors(const ScanAttributes* scan) {
    if (!scan) return;
    constexpr std::array<const char*, 3> names{"red", "green", "blue"};
    for (std::size_t k = 0; k < names.size(); ++k) columns_[k] = find_column(scan->faces, names[k]);
    is_ply_ = std::all_of(columns_.begin(), columns_.end(),
                          [](const AttributeColumn* column) { return column && !column->is_list(); });
    list_ = scan->format == "OFF" ? find_column(scan->faces, "color") : nullptr;
    if (list_ && !list_->is_list()) list_ = nullptr;
  }

  std::optional<Color> of(std::size_t face) const {
    Vec3 rgb = Vec3::Zero();
    if (is_ply_) {
      for (std::size_t k = 0; k < 3; ++k)
        rgb[static_cast<int>(k)] = full_channel(*columns_[k], columns_[k]->value(face));
    } else if (list_ && list_->items(face) >= 3) {
      for (std::size_t k = 0; k < 3; ++k) rgb[static_cast<int>(k)] = list_->value(face, k);
      if (rgb.maxCoeff() <= 1) rgb *= 255;  // fractions
    } else {
      return {};
    }
    if (!rgb.allFinite()) return {};
    return Color{channel(rgb.x()), channel(rgb.y()), channel(rgb.z()), 255};
  }

 private:
  std::array<const AttributeColumn*, 3> columns_{};
  const AttributeColumn* list_ = nullptr;
  bool is_ply_ = false;
};

class Colorer {
 public:
  Colorer(const SurfaceModel& model, const CancelToken& cancel)
      : model_(model),
        soup_(model.soup),
        cancel_(cancel),
        face_colors_(soup_.attributes.get()),
        first_(model.mesh.n_vertices(), -1),
        sum_(model.mesh.n_vertices(), {0, 0, 0, 0}) {
    if (!soup_.attributes) return;
    const std::filesystem::path& file = soup_.attributes->file;
    files_.emplace(*soup_.attributes, file.has_parent_path() ? file.parent_path() : std::filesystem::path("."));
    texture_.emplace(soup_, [this](std::size_t face) { return picture_of(face).get(); });
  }

  ScanColors result() {
    if (files_) result_.problems = files_->problems();
    for (std::size_t f = 0; f < model_.soup_face.size(); ++f) {
      if (f % 4096 == 0 && cancel_.cancelled()) return {};
      add_face(f);
    }
    if (!any_) {
      result_.parts.clear();
      return std::move(result_);
    }
    result_.at_vertices.resize(sum_.size(), without_color);
    for (std::size_t v = 0; v < sum_.size(); ++v)
      for (std::size_t k = 0; k < 3 && sum_[v][3] > 0; ++k)
        result_.at_vertices[v][k] = static_cast<unsigned char>(std::lround(sum_[v][k] / sum_[v][3]));
    if (only_vertices_) result_.parts.clear();
    return std::move(result_);
  }

 private:
  std::shared_ptr<const Picture> picture_of(std::size_t face) {
    const auto path = files_->picture_of(face);
    if (!path) return nullptr;
    const auto [entry, is_new] = pictures_.try_emplace(path_text(*path));
    if (is_new) {
      try {
        entry->second = std::make_shared<Picture>(files_->read(*path));
      } catch (const ReadError& error) {
        result_.problems.push_back(say("A picture of the scan's texture cannot be used: %1", error.message()));
      }
    }
    return entry->second;
  }

  ColoredPart& part_with(const std::shared_ptr<const Picture>& picture) {
    const auto [entry, is_new] = part_of_.try_emplace(picture.get(), result_.parts.size());
    if (is_new) result_.parts.push_back({picture, {}, {}, {}, {}});
    return result_.parts[entry->second];
  }

  void add_face(std::size_t f) {
    std::array<int, 3> view{};
    std::size_t k = 0;
    for (const auto v : model_.mesh.fv_range(model_.mesh.face_handle(static_cast<unsigned>(f)))) view.at(k++) = v.idx();
    const auto triangle = static_cast<std::size_t>(model_.soup_face[f]);
    if (const auto place = texture_ ? texture_->find(triangle) : std::nullopt) {
      add_textured(triangle, view, *place);
      return;
    }
    const int row = triangle_row(soup_, triangle);
    std::optional<Color> one;
    if (soup_.colors.empty() && row >= 0) {
      const std::size_t face = soup_.attributes->face_of_triangle(static_cast<std::size_t>(row));
      one = face_colors_.of(face);
      if (!one) one = files_->color_of(face);
    }
    any_ = any_ || one || !soup_.colors.empty();
    only_vertices_ = only_vertices_ && !one;
    std::array<Color, 3> colors{};
    for (k = 0; k < 3; ++k) {
      const auto point = static_cast<std::size_t>(model_.soup_vertex[view[k]]);
      colors[k] = one ? *one : soup_.colors.empty() ? without_color : soup_.colors[point];
      if (one || !soup_.colors.empty()) add(view[k], colors[k]);
    }
    ColoredPart& part = part_with(nullptr);
    Triangle t{};
    for (k = 0; k < 3; ++k) {
      t[k] = vertex(part, view[k], {nullptr, colors[k], 0, 0});
      if (static_cast<std::size_t>(t[k]) == part.colors.size()) part.colors.push_back(colors[k]);
    }
    part.triangles.push_back(t);
  }

  void add_textured(std::size_t triangle, const std::array<int, 3>& view, const TextureOfTriangles::Place& place) {
    any_ = true;
    only_vertices_ = false;
    const auto picture = std::find_if(pictures_.begin(), pictures_.end(),
                                      [&](const auto& entry) { return entry.second.get() == place.picture; });
    ColoredPart& part = part_with(picture->second);
    Triangle t{};
    for (std::size_t k = 0; k < 3; ++k) {
      // The corner of the file's triangle that this vertex of the view is.
      const int point = model_.soup_vertex[view[k]];
      const Triangle& corners = soup_.triangles[triangle];
      const auto corner = static_cast<std::size_t>(std::find(corners.begin(), corners.end(), point) - corners.begin());
      const Vec2& uv = place.at.at(corner);
      t[k] = vertex(part, view[k], {place.picture, {}, uv.x(), uv.y()});
      if (2 * static_cast<std::size_t>(t[k]) == part.texture.size()) {
        part.texture.push_back(static_cast<float>(uv.x()));
        part.texture.push_back(static_cast<float>(uv.y()));
      }
      add(view[k], color_at(*place.picture, uv));
    }
    part.triangles.push_back(t);
  }

  /// Distinguishes the vertices of parts at one vertex of the view.
  struct Look {
    const Picture* picture;
    Color color;
    double u, v;
    bool operator==(const Look&) const = default;
  };

  /// The vertex of the part, made if there is none.
  int vertex(ColoredPart& part, int view, const Look& look) {
    constexpr int most_steps = 64;
    int steps = 0;
    int& first = first_[view];
    for (int at = first; at >= 0 && steps < most_steps; ++steps, at = known_[at].next)
      if (known_[at].look == look) return known_[at].vertex;
    // A double of a vertex does no harm, where thousands of faces in a fan would take for ever.
    const int made = static_cast<int>(part.view_vertex.size());
    part.view_vertex.push_back(view);
    known_.push_back({look, made, std::exchange(first, static_cast<int>(known_.size()))});
    return made;
  }

  void add(int vertex, const Color& color) {
    auto& sum = sum_[vertex];
    for (std::size_t k = 0; k < 3; ++k) sum[k] += color[k];
    sum[3] += 1;
  }

  const SurfaceModel& model_;
  const TriangleSoup& soup_;
  const CancelToken& cancel_;
  std::optional<TextureFiles> files_;
  std::optional<TextureOfTriangles> texture_;
  FaceColors face_colors_;
  std::map<std::string, std::shared_ptr<const Picture>> pictures_;
  std::map<const Picture*, std::size_t> part_of_;
  struct Known {
    Look look;
    int vertex, next;
  };
  std::vector<Known> known_;
  std::vector<int> first_;                  ///< per vertex of the view: in known_, a chain
  std::vector<std::array<double, 4>> sum_;  ///< per vertex of the view: of the colours there, and how many
  bool any_ = false, only_vertices_ = true;
  ScanColors result_;
};

}  // namespace

ScanColors scan_colors(const SurfaceModel& model, const CancelToken& cancel) {
  const TriangleSoup& soup = model.soup;
  const ScanAttributes* more = soup.attributes.get();
  const bool has_more = more && (more->texture.count() > 0 || !more->material_libraries.empty() || more->materials ||
                                 find_column(more->faces, "red") || find_column(more->faces, "color"));
  if (has_more) return Colorer(model, cancel).result();
  ScanColors colors;  // the common case at once
  if (soup.colors.empty()) return colors;
  colors.at_vertices.reserve(model.soup_vertex.size());
  for (int point : model.soup_vertex) colors.at_vertices.push_back(soup.colors[point]);
  return colors;
}

std::vector<Color> patch_colors(const Patch& patch, const std::vector<Color>& of_view) {
  std::vector<Color> colors(patch.positions.size(), without_color);
  const int vertices = patch.vertex_count();
  Points rgb(patch.positions.size(), Vec3::Zero());
  Vec3 mean = Vec3::Zero();
  int known = 0;
  for (int v = patch.free_count; v < vertices; ++v) {
    const auto at = static_cast<std::size_t>(v);
    colors[at] = of_view[patch.view_vertex[at]];
    rgb[at] = Vec3(colors[at][0], colors[at][1], colors[at][2]);
    if (patch.ring[at] != 1) continue;
    mean += rgb[at];
    ++known;
  }
  if (patch.free_count == 0 || known == 0) return colors;
  for (int v = 0; v < patch.free_count; ++v) rgb[v] = mean / known;
  std::vector<int> faces(static_cast<std::size_t>(patch.patch_triangles));
  std::iota(faces.begin(), faces.end(), 0);
  const SparseMatrix stiffness = clamped_cotan_stiffness(patch.positions, patch.triangles, faces, robust_clamp);
  minimise_quadratic_form(stiffness, rgb, 0, patch.free_count);
  for (std::size_t v = 0; v < static_cast<std::size_t>(patch.free_count); ++v)
    colors[v] = {channel(rgb[v].x()), channel(rgb[v].y()), channel(rgb[v].z()), 255};
  return colors;
}

}  // namespace loopmend
