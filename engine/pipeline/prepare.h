// SPDX-License-Identifier: GPL-3.0-or-later
// What is done to a scan before its loops are chosen: faces of missing data removed, boundaries stitched, defects repaired, strips
// laid across holes, a plane cut made, a base built.
#pragma once

#include "core/cancel.h"
#include "mesh/no_data.h"
#include "mesh/surface_model.h"
#include "pipeline/join_tiles.h"
#include "repair/plane_cut.h"
#include "repair/repair_surface.h"
#include "repair/stitch_boundaries.h"

#include <cstddef>
#include <functional>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace loopmend {

struct PrepareOptions {
  /// Whether cutting of missing data, stitching, repair and trimming of what crosses are done where the mesh needs them,
  /// beside the options that are set.
  enum class Extent { as_asked, where_needed } extent = Extent::as_asked;
  enum class Sides { as_given, turned } sides = Sides::as_given;  ///< turned: every face looks the other way
  enum class Stitch { no, yes } stitch = Stitch::no;              ///< zip boundaries that nearly coincide
  StitchTolerance stitch_tolerance{};  ///< with a length, tiles that overlap within it are joined as well
  enum class NoData {
    keep,
    cut
  } no_data = NoData::keep;  ///< faces at marks for missing data, such as heights of -9999
  std::set<Defect> repair;
  /// A base under a loop: its number, or 0 for the largest, and how far the plane lies below (mesh units, above 0).
  struct Base {
    int loop = 0;
    double distance = 0;
  };
  std::optional<Base> base;
  std::optional<CutPlane> cut_plane;         ///< what lies before it is removed, and the section closed; before a base
  std::vector<std::pair<int, int>> bridges;  ///< input vertices between which a strip is laid
  int trim_rounds = 0;                       ///< rings of bad boundary triangles to be removed, 0..100
  /// Without rings: boundary triangles that run through the surface, so that their hole could not be filled, are removed.
  enum class TrimPierced { no, yes } trim_pierced = TrimPierced::no;

  bool trims() const { return trim_rounds > 0 || trim_pierced == TrimPierced::yes; }
};

/// "0.5": a length in mesh units; "5%": of the boundary edges there. @throws InvalidArgument for anything else.
StitchTolerance stitch_tolerance_of(const std::string& text);

/// "5", or "2:5" for loop 2. @throws InvalidArgument for anything else.
PrepareOptions::Base base_of(const std::string& text);

/// Six numbers: "0,0,5,0,0,1". @throws InvalidArgument for anything else.
CutPlane cut_plane_of(const std::string& text);

/// What was done to the mesh.
struct Preparation {
  std::optional<StitchedSurface> stitched;  ///< without its soup
  std::optional<RepairCounts> repaired;
  std::size_t joined_again = 0;  ///< vertices at cracks that the repair left, where both stitching and repair are done
  JoinedTiles tiles;             ///< that overlapped, with a length as tolerance of stitching
  std::size_t bridges = 0;
  std::size_t sides_turned = 0;  ///< faces, all of the mesh where that was asked for
  std::optional<PlaneCutCounts> cut;
  int base_loop = 0;                         ///< under which a base was built; 0: none
  NoDataVertices no_data;                    ///< that were found
  std::optional<std::size_t> no_data_faces;  ///< that were removed there, where it was asked for
  ModelRepairs before;                       ///< of the mesh as it was read
  std::size_t turned_faces = 0;              ///< in the mesh as it was read, where another mesh came out of it

  /// Whether the mesh is still as it was read.
  bool changed_nothing() const;
};

/// Makes a model of each soup on the way.
using MakeModel = std::function<SurfaceModel(TriangleSoup)>;

/// Prepares the model, all but trimming, which needs the loops to be chosen first.
/// @param options  what was done is added to it where the mesh needs it and the options leave that open: no later advice
/// proposes it again.
/// @throws InvalidArgument for loops, vertices or bridges that do not exist.
Preparation prepare(SurfaceModel& model, PrepareOptions& options, const MakeModel& make_model,
                    const CancelToken& cancel = {}, const OnRepairStep& on_step = {});

}  // namespace loopmend
