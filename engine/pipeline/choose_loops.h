// SPDX-License-Identifier: GPL-3.0-or-later
// Which boundary loops of a surface are filled, and why the others are not.
#pragma once

#include "core/message.h"
#include "evolution/evolution.h"
#include "mesh/boundary_loops.h"

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace loopmend {

struct LoopSelection {
  /// Loops by number, from 1, each with the continuity that was named for it alone. Loops that are named here or by a vertex are
  /// filled whatever their kind is; where none is named, every hole is.
  std::map<int, std::optional<SeamContinuity>> numbers;
  std::optional<SeamContinuity> continuity;  ///< of loops that are not named
  std::vector<int> at_vertices;              ///< input vertices, from 0: the loops through them
  std::optional<int> max_edges;              ///< loops with more edges are left
  std::optional<double> max_diameter;        ///< mesh units; wider loops are left
  int all_but_largest = 0;                   ///< so many of the largest loops are left
  enum class OuterRim { leave, include } outer_rim = OuterRim::leave;

  bool names_loops() const { return !numbers.empty() || !at_vertices.empty(); }
};

/// Chooses by a text: "all" or "all:flat", or numbers of loops between commas, each with a continuity if one is named:
/// "1,3:flat,7:tangent,8:smooth". @throws InvalidArgument for anything else.
void take_loops(const std::string& text, LoopSelection& selection);

/// "17,230", one at least. @throws InvalidArgument for anything else.
std::vector<int> vertex_numbers_of(const std::string& text);

struct LoopChoice {
  enum class Left {
    as_asked,
    no_hole,    ///< there is nothing that could be filled
    wide_crack  ///< --stitch would join the sides
  };
  enum class Cure { none, stitch, repair };
  bool fill = false;
  std::optional<SeamContinuity> continuity;  ///< named for this loop alone
  Message why_not;                           ///< where fill is false
  Cure cure = Cure::none;                    ///< what may make a hole of it, or close it
  Left left = Left::as_asked;
  bool is_outer_rim = false;  ///< bounds a sheet, and is no defect
};

/// "what (cure)".
Message with_cure(Message what, Message cure);

/// Of a loop that is left since others were named.
Message not_selected();

/// The choice for a loop that is not named.
LoopChoice choose_unnamed(const BoundaryLoop& loop, const LoopSelection& selection);

/// @param loops  all of the model, in the order of their numbers. @returns one choice per loop.
/// @throws InvalidArgument for a number or vertex that names no loop.
std::vector<LoopChoice> choose_loops(const SurfaceModel& model, const std::vector<BoundaryLoop>& loops,
                                     const LoopSelection& selection);

}  // namespace loopmend
