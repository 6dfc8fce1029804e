// SPDX-License-Identifier: GPL-3.0-or-later
// A surface as the scene draws it: plain float arrays that a worker fills and the graphics take over without a copy.
#pragma once

#include "analysis/curvature_field.h"
#include "appearance/scan_colors.h"
#include "mesh/patch.h"
#include "mesh/surface_model.h"
#include "scene/shading.h"

#include <cstddef>
#include <memory>
#include <span>
#include <utility>
#include <vector>

namespace loopmend {

/// Corners of triangles, three a triangle, which never change: copies share them. Those of a large scan take 12 bytes a triangle.
class TriangleList {
 public:
  TriangleList() = default;
  TriangleList(std::vector<int> corners) : corners_(std::make_shared<const std::vector<int>>(std::move(corners))) {}

  std::size_t size() const { return corners_ ? corners_->size() : 0; }  ///< corners, not triangles
  bool empty() const { return size() == 0; }
  int operator[](std::size_t corner) const { return (*corners_)[corner]; }
  const int* data() const { return corners_ ? corners_->data() : nullptr; }
  const int* begin() const { return data(); }
  const int* end() const { return data() + size(); }

  friend bool operator==(const TriangleList& a, const TriangleList& b) {
    return a.corners_ == b.corners_ || (a.corners_ && b.corners_ && *a.corners_ == *b.corners_);
  }

 private:
  std::shared_ptr<const std::vector<int>> corners_;
};

struct SurfaceShape;
using SurfaceShapePtr = std::shared_ptr<const SurfaceShape>;

/// Positions are relative to an origin that the whole scene shares, so that far-off scans keep their digits as floats.
struct SurfaceShape {
  std::vector<float> points;          ///< 3 × #V, mesh units, minus the scene's origin
  std::vector<float> normals;         ///< 3 × #V, unit
  TriangleList triangles;             ///< a patch's own come first, then those of the rings around it
  int own_triangles = 0;              ///< of a patch: how many are its own; of a scan: all
  std::vector<float> H;               ///< #V, mean curvature, 1/length, NaN where unknown; empty before it was computed
  std::vector<float> K;               ///< #V, Gaussian curvature, 1/length², likewise
  std::vector<float> deviation;       ///< #V, of a patch: likely distance from what was there, mesh units; else empty
  std::vector<float> difference;      ///< #V, of a compared patch: signed distance from another surface; else empty
  std::vector<unsigned char> colors;  ///< 3 × #V, red, green, blue; empty: it has none of its own
  std::vector<float> texture;         ///< 2 × #V, of a part of a scan that has a picture; else empty
  std::shared_ptr<const Picture> picture;  ///< of `texture`
  std::vector<int> view_vertex;            ///< of a part of a scan: the vertex of its view that each one is; else empty
  /// Of a patch: colours of the scan, per vertex of its view; null: it has none.
  std::shared_ptr<const std::vector<Color>> scan_colors;
  SurfaceShapePtr reduced;  ///< of a large one: reduced_shape(); else null
};

/// What the colours of a shading stand for; empty: not known, or not coloured by values.
const std::vector<float>& values_of(const SurfaceShape& shape, Shading shading);

/// The shape of a patch with the likely distance of each vertex; 0 at the vertices of the scan.
/// @param of_free_vertices  DeviationEstimate::vertices; empty: not known
SurfaceShapePtr with_deviation(const SurfaceShape& shape, std::span<const double> of_free_vertices);

/// Some triangles of a surface, in this order, with the vertices that they need.
/// @param number  -1 for every vertex of the surface, or shorter; so it is left
std::shared_ptr<SurfaceShape> with_triangles(const SurfaceShape& whole, std::span<const int> triangles,
                                             std::vector<int>& number);

/// The reduced version of a large surface, which is drawn while the eye moves: at most some 30 000 vertices, the means of those in
/// one cell of a grid. Null: the surface is not large.
SurfaceShapePtr reduced_shape(const SurfaceShape& shape);

/// Gives a large surface its reduced version. Its triangles come in another order: near ones follow each other.
SurfaceShape with_reduced(SurfaceShape shape);

/// The middle of the bounding box.
Vec3 scene_origin(const TriangleSoup& soup);

/// The first picture: area-weighted normals, no H.
SurfaceShape shape_of(const TriangleSoup& soup, const Vec3& origin);

/// In the order of the view's faces.
TriangleList triangles_of_view(const TriMesh& mesh);

/// The view's vertices; area-weighted normals, no H.
SurfaceShape shape_of(const TriMesh& mesh, const Vec3& origin);

/// The same surface with a vertex for each side of a crease, so that light does not run round sharp edges.
/// @param shape    without values and colours
/// @param degrees  0..180; an edge that bends by more is a crease
SurfaceShape parted_at_creases(SurfaceShape shape, double degrees);

/// The same surface with fitted normals and H; the shape's normals where there is no fit.
/// @param field  of the shape's vertices; each of its arrays is freed when it has been read, since a large scan needs the memory
SurfaceShape with_curvature(const SurfaceShape& shape, CurvatureField field);

/// The patch with its curvature, and the three rings around it, where its H runs into that of the open scan.
/// @param scan_colors  ScanColors::at_vertices, from which its colours go on; null: the scan has none
SurfaceShapePtr shape_of(const Patch& patch, const Vec3& origin,
                         const std::shared_ptr<const std::vector<Color>>& scan_colors = nullptr);

/// Gives the shape of a scan's view its colours at vertices, and makes shapes of the parts that it is drawn by where these do
/// not say it all; normals are those of the shape.
std::vector<SurfaceShapePtr> colored_parts(const ScanColors& colors, SurfaceShape& view);

/// Half-width R of the colour range [−R, R] that holds `percent` of the values on either side of 0, rounded to two digits
/// so that the legend reads well; 1 when nothing is known. Twice that where the values are nearly constant, as on a ball, which
/// would have the darkest colour all over. Of more than a million values, every second, third, ... counts.
/// @param percent  50..100, of the known values
double symmetric_range(std::span<const float> values, double percent = 98);

}  // namespace loopmend
