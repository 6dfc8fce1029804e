// SPDX-License-Identifier: GPL-3.0-or-later
#include "texture/texture_of_triangles.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace loopmend {

namespace {

/// Pictures are repeated, but not as often as damaged files say.
constexpr double most_repeats = 10000;

}  // namespace

TextureOfTriangles::TextureOfTriangles(const TriangleSoup& soup, std::function<const Picture*(std::size_t)> picture_of)
    : soup_(soup),
      scan_(*soup.attributes),
      picture_of_(std::move(picture_of)) {}

std::optional<TextureOfTriangles::Place> TextureOfTriangles::find(std::size_t triangle) const {
  const int row = triangle_row(soup_, triangle);
  if (row < 0 || scan_.corners.empty() || scan_.texture.count() == 0) return {};
  const std::size_t face = scan_.face_of_triangle(static_cast<std::size_t>(row));
  Place place;
  place.picture = picture_of_(face);
  if (!place.picture) return {};
  for (std::size_t k = 0; k < 3; ++k) {
    const int point = point_row(soup_, static_cast<std::size_t>(soup_.triangles[triangle][k]));
    int value = -1;
    for (std::size_t c = scan_.first_corner(face); c < scan_.corner_end(face) && value < 0; ++c)
      if (scan_.corners[c] == point) value = scan_.texture.at[c];
    if (value < 0) return {};
    const double* uv =
        &scan_.texture.values[static_cast<std::size_t>(value) * static_cast<std::size_t>(scan_.texture.dimension)];
    place.at[k] = {uv[0], scan_.texture.dimension > 1 ? uv[1] : 0};
    if (!place.at[k].allFinite() || place.at[k].cwiseAbs().maxCoeff() > most_repeats) return {};
  }
  return place;
}

Color color_at(const Picture& picture, const Vec2& uv) {
  const double x = (uv.x() - std::floor(uv.x())) * picture.width - 0.5;
  const double y = (1 - (uv.y() - std::floor(uv.y()))) * picture.height - 0.5;
  const int x0 = static_cast<int>(std::floor(x)), y0 = static_cast<int>(std::floor(y));
  const double fx = x - x0, fy = y - y0;
  std::array<double, 4> sum{};
  for (int k = 0; k < 4; ++k) {
    const int px = (x0 + k % 2 + picture.width) % picture.width, py = (y0 + k / 2 + picture.height) % picture.height;
    const double weight = (k % 2 ? fx : 1 - fx) * (k / 2 ? fy : 1 - fy);
    for (std::size_t c = 0; c < 4; ++c) sum[c] += weight * picture.at(px, py)[c];
  }
  Color color;
  for (std::size_t c = 0; c < 4; ++c)
    color[c] = static_cast<unsigned char>(std::lround(std::clamp(sum[c], 0.0, 255.0)));
  return color;
}

}  // namespace loopmend
