// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/surface_probe.h"

#include "document/labels.h"

#include <QCoreApplication>

#include <cmath>
#include <limits>

namespace loopmend {
namespace {

QString tr(const char* text) { return QCoreApplication::translate("loopmend", text); }

struct Nearest {
  const SurfaceShape* shape = nullptr;
  std::size_t vertex = 0;
  float distance2 = std::numeric_limits<float>::max();

  /// @param count  how many of the shape's vertices may be meant.
  bool look(const SurfaceShape& in, std::size_t count, const Eigen::Vector3f& at) {
    bool found = false;
    for (std::size_t v = 0; v < count; ++v) {
      const Eigen::Map<const Eigen::Vector3f> p(in.points.data() + 3 * v);
      const float d2 = (p - at).squaredNorm();
      if (d2 >= distance2) continue;
      distance2 = d2;
      shape = &in;
      vertex = v;
      found = true;
    }
    return found;
  }
};

QString value(const std::vector<float>& values, std::size_t vertex) {
  if (values.empty() || !std::isfinite(values[vertex])) return tr("not known");
  return labels::number(static_cast<double>(values[vertex]));
}

}  // namespace

std::optional<Probe> probe(const Document& document, const Vec3& at) {
  Nearest nearest;
  QString where;
  const Eigen::Vector3f point = at.cast<float>();
  std::shared_ptr<const OpenedScan> in_scan;
  for (int index : document.scans()) {
    const auto scan = document.scan(index);
    if (nearest.look(*scan->shape, scan->shape->points.size() / 3, point)) {
      where = scan->name;
      in_scan = scan;
    }
  }
  for (const OpenPatch& patch : document.patches()) {
    const auto free = static_cast<std::size_t>(patch.state->patch.free_count);
    if (nearest.look(*patch.state->shape, free, point)) {
      where = tr("Patch of %1").arg(labels::holes(document, {patch.loops.begin(), patch.loops.end()}));
      in_scan = nullptr;
    }
  }
  if (!nearest.shape) return std::nullopt;
  if (in_scan) where += tr(", vertex %1").arg(in_scan->model->soup_vertex[nearest.vertex]);  // its number in the file
  Probe found;
  for (int k = 0; k < 3; ++k) found.at[k] = nearest.shape->points[3 * nearest.vertex + static_cast<std::size_t>(k)];
  const Vec3 place = found.at + document.origin();
  found.lines << where
              << QStringLiteral("x %1   y %2   z %3")
                     .arg(labels::number(place.x()), labels::number(place.y()), labels::number(place.z()))
              << QStringLiteral("H %1   K %2")
                     .arg(value(nearest.shape->H, nearest.vertex), value(nearest.shape->K, nearest.vertex));
  return found;
}

}  // namespace loopmend
