// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/patch_batch.h"

#include <vtkActor.h>

#include <algorithm>
#include <limits>

namespace loopmend {
namespace {

/// Appends triangles first..last of a shape whose points begin at `shift`.
void append_triangles(std::vector<int>& to, const SurfaceShape& from, std::size_t first, std::size_t last, int shift) {
  for (std::size_t k = 3 * first; k < 3 * last; ++k) to.push_back(from.triangles[k] + shift);
}

SurfaceShapePtr joined(const PatchBatch::Shapes& shapes) {
  auto all = std::make_shared<SurfaceShape>();
  std::vector<int> shifts, corners;
  for (const auto& [id, shape] : shapes) {
    shifts.push_back(static_cast<int>(all->points.size() / 3));
    all->points.insert(all->points.end(), shape->points.begin(), shape->points.end());
    all->normals.insert(all->normals.end(), shape->normals.begin(), shape->normals.end());
    all->H.insert(all->H.end(), shape->H.begin(), shape->H.end());
    all->K.insert(all->K.end(), shape->K.begin(), shape->K.end());
    all->deviation.insert(all->deviation.end(), shape->deviation.begin(), shape->deviation.end());
    if (shape->deviation.empty())  // beside others that have one
      all->deviation.resize(all->points.size() / 3, std::numeric_limits<float>::quiet_NaN());
    if (shape->colors.empty())  // beside those of a scan with colours
      for (std::size_t v = 0; v < shape->points.size() / 3; ++v)
        for (const double channel : patch_color) all->colors.push_back(static_cast<unsigned char>(255 * channel));
    else
      all->colors.insert(all->colors.end(), shape->colors.begin(), shape->colors.end());
    append_triangles(corners, *shape, 0, static_cast<std::size_t>(shape->own_triangles), shifts.back());
  }
  if (std::all_of(shapes.begin(), shapes.end(), [](const auto& entry) { return entry.second->deviation.empty(); }))
    all->deviation.clear();
  all->own_triangles = static_cast<int>(corners.size() / 3);
  std::size_t k = 0;
  for (const auto& [id, shape] : shapes)
    append_triangles(corners, *shape, static_cast<std::size_t>(shape->own_triangles), shape->triangles.size() / 3,
                     shifts[k++]);
  all->triangles = std::move(corners);
  return all;
}

}  // namespace

void PatchBatch::show(const Shapes& shapes) {
  if (shapes == shown_) return;
  shown_ = shapes;
  surface_.actor()->SetVisibility(!shapes.empty());
  if (!shapes.empty()) surface_.set_shape(joined(shapes));
}

}  // namespace loopmend
