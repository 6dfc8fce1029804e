// SPDX-License-Identifier: GPL-3.0-or-later
// A surface as a file holds it: points and triangles by index. This is what is read, and what is written back.
#pragma once

#include "core/types.h"

#include <cstddef>
#include <memory>
#include <vector>

namespace loopmend {

struct ScanAttributes;

/// Points may be unreferenced; triangles may be non-manifold or disagree in orientation. Indices are always in range
/// and coordinates finite (the readers see to that).
///
/// `attributes` is what else the file holds, by rows. Where points or triangles were taken away or changed places, the
/// rows of those that are left are listed; else point i has row i. What comes after the rows is new. So whoever appends
/// points and triangles has nothing to do, and whoever selects some calls copy_rows.
struct TriangleSoup {
  Points points{};              ///< #V, mesh units
  Triangles triangles{};        ///< #F
  std::vector<Color> colors{};  ///< #V, or empty when the file had no vertex colours

  std::shared_ptr<const ScanAttributes> attributes = nullptr;  ///< null: nothing else
  std::vector<int> point_rows{}, triangle_rows{};              ///< empty: those of the file in their order; −1: new
  /// Rows for the new points and triangles, in their order (pipeline/continue_attributes.h); null: not yet made.
  std::shared_ptr<const ScanAttributes> continued = nullptr;
};

/// The row of a point or triangle in `attributes`; −1 for what is new, or where there are no attributes.
int point_row(const TriangleSoup& soup, std::size_t point);
int triangle_row(const TriangleSoup& soup, std::size_t triangle);

/// `to` is made of points and triangles of `from`: these, in this order; what comes after them in `to` is new. −1: new.
void copy_rows(const TriangleSoup& from, const std::vector<int>& points, const std::vector<int>& triangles,
               TriangleSoup& to);

/// All points and some of the triangles. @param kept  one for each triangle: not 0 where it stays
TriangleSoup with_faces(const TriangleSoup& soup, const std::vector<char>& kept);

/// Adds the points and triangles of `part`; where only one of the two has colours, the other's points become white. The
/// attributes of neither are kept, but where `all` was empty.
void append(TriangleSoup& all, const TriangleSoup& part);
/// One soup from several, in their order, as append() does it; one alone keeps its attributes.
TriangleSoup joined(std::vector<TriangleSoup> parts);

}  // namespace loopmend
