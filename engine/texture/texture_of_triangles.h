// SPDX-License-Identifier: GPL-3.0-or-later
// Where the triangles of a scan lie in its pictures.
#pragma once

#include "core/picture.h"
#include "mesh/scan_attributes.h"
#include "mesh/triangle_soup.h"
#include "texture/chart.h"

#include <array>
#include <functional>
#include <optional>

namespace loopmend {

class TextureOfTriangles {
 public:
  /// @param soup        has attributes; kept by reference
  /// @param picture_of  the picture of a face of the file; null: none
  TextureOfTriangles(const TriangleSoup& soup, std::function<const Picture*(std::size_t)> picture_of);

  struct Place {
    const Picture* picture = nullptr;
    std::array<Vec2, 3> at;  ///< u to the right, v upward, in the order of the triangle's vertices
  };
  /// Nothing where the triangle is none of the file, has no texture coordinates or no picture.
  std::optional<Place> find(std::size_t triangle) const;

 private:
  const TriangleSoup& soup_;
  const ScanAttributes& scan_;
  std::function<const Picture*(std::size_t)> picture_of_;
};

/// Between the four nearest pixels; beyond its edges the picture is repeated.
Color color_at(const Picture& picture, const Vec2& uv);

}  // namespace loopmend
