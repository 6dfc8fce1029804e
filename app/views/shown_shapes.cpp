// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/shown_shapes.h"

#include "jobs/near_shape.h"

#include <algorithm>

namespace loopmend {
namespace {

using ShapePtr = ShownShapes::ShapePtr;

/// Without the triangles of hidden pieces; null where nothing is left.
ShapePtr shown_part(const SurfaceShape& shape, const ScanPieces& pieces, const std::vector<char>& hidden) {
  std::vector<char> left_out(shape.triangles.size() / 3, 0);
  for (std::size_t t = 0; t < left_out.size(); ++t) {
    const int v = shape.triangles[3 * t];
    const int of_view = shape.view_vertex.empty() ? v : shape.view_vertex[v];
    left_out[t] = hidden[pieces.piece_of(of_view)];
  }
  ShapePtr rest = without_triangles(shape, left_out);
  return rest->triangles.empty() ? nullptr : rest;
}

}  // namespace

const ShownShapes::Shown& ShownShapes::of(const Document& document, const SceneVisibility& visibility, int scan) {
  const auto opened = document.scan(scan);
  std::vector<char> hidden(static_cast<std::size_t>(visibility.piece_count(scan)), 0);
  for (std::size_t k = 0; k < hidden.size(); ++k) hidden[k] = visibility.is_hidden({scan, static_cast<int>(k)});
  Entry& entry = entries_[scan];
  if (entry.source == opened->shape && entry.hidden == hidden) return entry.shown;
  entry = {opened->shape, std::move(hidden), {}};
  const auto count = std::count(entry.hidden.begin(), entry.hidden.end(), 1);
  if (count == 0) {
    entry.shown = {opened->shape, opened->colored};
  } else if (static_cast<std::size_t>(count) < entry.hidden.size()) {
    entry.shown.whole = shown_part(*opened->shape, opened->pieces, entry.hidden);
    for (const ShapePtr& part : opened->colored)
      if (ShapePtr rest = shown_part(*part, opened->pieces, entry.hidden)) entry.shown.parts.push_back(std::move(rest));
  }
  return entry.shown;
}

}  // namespace loopmend
