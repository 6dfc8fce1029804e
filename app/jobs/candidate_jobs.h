// SPDX-License-Identifier: GPL-3.0-or-later
// Other patches for holes that are filled: each as `loopmend fill` makes it with one option, off the window's thread.
#pragma once

#include "document/document.h"
#include "jobs/scan_context.h"
#include "mirror/mirror_plane.h"
#include "pipeline/solve_group.h"

#include <mutex>
#include <optional>
#include <vector>

namespace loopmend {

/// What a person may choose in place of what the engine chose. In this order they are shown.
enum class CandidateKind {
  as_it_is,   ///< of the document, and none of the others
  automatic,  ///< what Fill and smooth makes
  tangent,    ///< --continuity tangent
  flat,       ///< --continuity position
  robust,     ///< --boundary robust
  exact,      ///< --boundary exact
  rounded,    ///< --edges round
  mirror,     ///< --mirror
};

/// The planes of symmetry of one scan, found when they are first asked for.
class MirrorPlanes {
 public:
  /// Safe from several threads. @returns nothing when cancelled.
  std::vector<MirrorPlane> of(const SurfaceModel& model, const CancelToken& cancel);

 private:
  std::mutex mutex_;
  std::optional<std::vector<MirrorPlane>> planes_;
};

struct CandidateTask {
  OpenPatch patch;  ///< of the document: whose holes they close
  ScanContextPtr scan_context;
  std::vector<BoundaryLoop> loops;  ///< those of the patch
  std::shared_ptr<MirrorPlanes> mirror_planes;
  Vec3 origin = Vec3::Zero();
};

struct Candidate {
  CandidateKind kind = CandidateKind::as_it_is;
  std::vector<OpenPatch> patches;  ///< together they close the holes; ids are not set. Empty: there is no such patch
  Message why_not;                 ///< where there is none
};

/// What the recipe leads to, where it is one of the kinds.
std::optional<CandidateKind> kind_of(const PatchRecipe& recipe);

/// Those that may differ from the patch as it is. Sharp edges are rounded only where some were continued.
std::vector<CandidateKind> kinds_for(const OpenPatch& patch);

/// As `loopmend fill` makes it. @returns nothing of use when cancelled.
Candidate make_candidate(const CandidateTask& task, CandidateKind kind, const CancelToken& cancel);

/// Whether both have the same triangles and the same positions, to the bit.
bool are_equal(const Candidate& one, const Candidate& other);

}  // namespace loopmend
