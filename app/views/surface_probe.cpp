// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/surface_probe.h"

#include "document/labels.h"

#include <QCoreApplication>

#include <cmath>
#include <limits>

namespace loopmend {
namespace {

QString tr(const char* text) { return QCoreApplication::translate("loopmend", text); }

QString value(const std::vector<float>& values, std::size_t vertex) {
  if (values.empty() || !std::isfinite(values[vertex])) return tr("not known");
  return labels::number(static_cast<double>(values[vertex]));
}

const SurfaceShape& shape_at(const Document& document, const SurfacePlace& place) {
  return place.patch < 0 ? *document.scan(place.scan)->shape : *document.patch(place.patch)->state->shape;
}

}  // namespace

std::optional<SurfacePlace> place_near(const Document& document, const SceneVisibility& visibility, const Vec3& at) {
  std::optional<SurfacePlace> found;
  const Eigen::Vector3f point = at.cast<float>();
  float best = std::numeric_limits<float>::max();
  const auto look = [&](const SurfaceShape& shape, std::size_t count, int scan, int patch, const auto& is_shown) {
    for (std::size_t v = 0; v < count; ++v) {
      const float d2 = (Eigen::Map<const Eigen::Vector3f>(shape.points.data() + 3 * v) - point).squaredNorm();
      if (d2 >= best || !is_shown(static_cast<int>(v))) continue;
      best = d2;
      found = SurfacePlace{scan, patch, static_cast<int>(v), {}};
    }
  };
  for (int index : document.scans()) {
    const SurfaceShape& shape = *document.scan(index)->shape;
    const bool whole = !visibility.hides_pieces_of(index);
    look(shape, shape.points.size() / 3, index, -1,
         [&](int v) { return whole || !visibility.is_hidden_vertex(index, v); });
  }
  for (const OpenPatch& patch : document.patches())
    if (!visibility.is_hidden_patch(patch))
      look(*patch.state->shape, static_cast<std::size_t>(patch.state->patch.free_count), patch.scan, patch.id,
           [](int) { return true; });
  if (!found) return std::nullopt;
  const SurfaceShape& shape = shape_at(document, *found);
  for (int k = 0; k < 3; ++k)
    found->at[k] = shape.points[3 * static_cast<std::size_t>(found->vertex) + static_cast<std::size_t>(k)];
  return found;
}

PieceId piece_at(const Document& document, const SceneVisibility& visibility, const SurfacePlace& place) {
  if (place.patch >= 0) return visibility.piece_of_loop(document.patch(place.patch)->loops.front());
  return {place.scan, document.scan(place.scan)->pieces.piece_of(place.vertex)};
}

Probe probe(const Document& document, const SurfacePlace& place) {
  const SurfaceShape& shape = shape_at(document, place);
  const auto vertex = static_cast<std::size_t>(place.vertex);
  const auto scan = document.scan(place.scan);
  QString where;
  if (place.patch < 0) {
    where = scan->name + tr(", vertex %1").arg(scan->model->soup_vertex[vertex]);  // its number in the file
  } else {
    const std::vector<int>& loops = document.patch(place.patch)->loops;
    where = tr("Patch of %1").arg(labels::holes(document, {loops.begin(), loops.end()}));
  }
  const Vec3 at = place.at + document.origin();
  Probe found{
      place.at,
      {where,
       QStringLiteral("x %1   y %2   z %3").arg(labels::number(at.x()), labels::number(at.y()), labels::number(at.z())),
       QStringLiteral("H %1   K %2").arg(value(shape.H, vertex), value(shape.K, vertex))}};
  if (!shape.deviation.empty())
    found.lines.push_back(tr("likely error %1").arg(labels::number(static_cast<double>(shape.deviation[vertex]))));
  return found;
}

}  // namespace loopmend
