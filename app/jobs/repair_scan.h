// SPDX-License-Identifier: GPL-3.0-or-later
// What is done to a scan before it is filled: trimming, stitching, repairing, bridging, erasing, parting.
#pragma once

#include "document/opened_scan.h"
#include "jobs/carry_patches.h"
#include "jobs/load_scan.h"
#include "mesh/boundary_loops.h"
#include "repair/plane_cut.h"
#include "repair/repair_surface.h"

#include <QString>

#include <array>
#include <memory>
#include <optional>
#include <set>
#include <vector>

namespace loopmend {

enum class ScanRepair;

/// A scan to be repaired, and those of its loops that were chosen.
struct ScanRepairTask {
  int scan = 0;
  std::shared_ptr<const OpenedScan> opened;
  std::vector<BoundaryLoop> loops;
  std::array<int, 2> bridge_ends{-1, -1};  ///< soup points
  CutPlane cut_plane{};
  double base_distance = 0;  ///< below the surface, mesh units
  int part_to_fill = -1;     ///< a soup point of the boundary, in the part that is filled next; −1: neither
  std::vector<int> erased;   ///< points of the scan, its patches' own after them, in the order of `patches`
  std::set<Defect> defects = harmless_repairs;  ///< to be repaired
  std::vector<OpenPatch> patches{};             ///< all of the scan
  int first_loop = 0;                           ///< of the scan, in the numbers of the patches' loops
  CancelToken cancel{};
  OnRepairStep on_step{};
};

struct RepairedScan {
  int scan = 0;
  OpenedScanPtr made;                     ///< null: it could not be repaired, and `words` say why
  QString title, words;                   ///< of the change, and of what was done
  std::optional<NewPoints> new_points{};  ///< empty: points cannot be followed
  std::vector<OpenPatch> carried{};       ///< patches that are the same in the repaired scan; see carried_patches()
  int joined_patches = 0;                 ///< that are a part of it now
  int lost_patches = 0;
  std::size_t loops_before = 0, loops = 0;  ///< boundary loops of the scan, cuts aside
  std::vector<int> to_fill{};               ///< loops within the repaired scan
  QString proposal{};                       ///< what would be done, in words; empty: it is not shown before
  std::vector<int> changed_faces{};         ///< of the old scan's soup, with a proposal; ascending
};

/// The repaired scan; empty where there is nothing to repair. @throws Error as the function of the engine does.
std::optional<RepairedScan> repaired_scan(ScanRepair what, const ScanRepairTask& task);

}  // namespace loopmend
