// SPDX-License-Identifier: GPL-3.0-or-later
// Where the defects of scans are: the faces that a repair would remove or change, to be marked in the view.
#pragma once

#include "core/cancel.h"
#include "document/opened_scan.h"
#include "repair/repair_surface.h"

#include <memory>
#include <vector>

namespace loopmend {

/// Marked faces that hang together.
struct DefectPlace {
  Vec3 center = Vec3::Zero();      ///< of their corners, in the scan's frame
  Vec3 direction = Vec3::UnitZ();  ///< from which they are seen best, unit
  double radius = 0;               ///< of a ball around the center that holds them
  std::size_t faces = 0;
};

struct DefectPlaces {
  SurfaceShapePtr shape;            ///< seen from both sides, in the colour of a warning; null: no face would change
  std::vector<DefectPlace> places;  ///< the largest first
};

/// Faces of the soup that are not in the repaired one, or have other corners or another side there; ascending.
/// @param after  made of `before` by repair_surface()
std::vector<int> changed_faces(const TriangleSoup& before, const TriangleSoup& after);

/// Faces of a scan's soup that would be removed or changed; ascending.
struct FacesToChange {
  std::shared_ptr<const OpenedScan> scan;
  std::vector<int> faces;
};

/// @param origin  of the scene
DefectPlaces mark_faces(const std::vector<FacesToChange>& changes, const Vec3& origin);

/// What repair_surface() would remove or change if this defect were the only one to be repaired.
/// @param origin  of the scene
DefectPlaces find_defect_places(const std::vector<std::shared_ptr<const OpenedScan>>& scans, Defect defect,
                                const Vec3& origin, const CancelToken& cancel = {});

}  // namespace loopmend
