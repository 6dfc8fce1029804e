// SPDX-License-Identifier: GPL-3.0-or-later
// Scans with their patches as one surface: what a trial begins from.
#pragma once

#include "document/document.h"
#include "jobs/problem_controller.h"

namespace loopmend {

/// What a worker needs to make the base; cheap to copy.
struct BaseParts {
  std::vector<int> scans;
  struct Part {
    std::shared_ptr<const OpenedScan> scan;
    SurfaceShapePtr shape;  ///< the scan's; the window may give that another one meanwhile
    std::vector<PatchStatePtr> patches;
  };
  std::vector<Part> parts;
  Vec3 origin = Vec3::Zero();
};

BaseParts parts_of(const Document& document, const std::vector<int>& scans);

/// On a worker. @throws InvalidArgument where parts cut each other.
ProblemBase make_base(const BaseParts& parts);

/// What is drawn of the base without these of its soup's triangles.
SurfaceShapePtr shape_without(const ProblemBase& base, const std::vector<int>& soup_triangles);

/// The loop of the base's model that runs through this loop of a scan, by its points.
/// @param part  which of the base's scans. @throws InvalidArgument where there is none: the loop has been filled.
BoundaryLoop loop_in_base(const ProblemBase& base, std::size_t part, const OpenedScan& scan, const BoundaryLoop& loop);

}  // namespace loopmend
