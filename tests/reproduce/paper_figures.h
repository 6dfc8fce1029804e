// SPDX-License-Identifier: GPL-3.0-or-later
// The paper's experiments (section 5), each from its input to its numbers. No files, no pictures.
#pragma once

#include "mesh/surface_model.h"
#include "pipeline/compare.h"

#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace loopmend {

enum class Reproduction { reproduced, partly, not_reproduced };
const char* to_string(Reproduction verdict);
/// @param pattern  one conversion for a double, as of printf.
std::string number_text(const char* pattern, double value);

/// A row of Table 5.1: what the paper prints, and ours where it has been run. Times in seconds for one step.
struct TableRow {
  int unknowns = 0;  ///< 3 n
  double tau = 0, form = 0, solve = 0;
  int steps = 0;
};

struct FigureRun {
  std::string id, title;  ///< "fig5.1a", "A cylinder from which parts are missing"
  std::string claim;      ///< the paper's, in a sentence
  Reproduction verdict = Reproduction::not_reproduced;
  std::string why;  ///< the figures that decide, and what was assumed
  SurfaceModel before, initial, after;
  std::string initial_caption = "Initial surface";
  std::optional<SurfaceModel> between;  ///< a state on the way, where the paper shows one
  std::string between_caption;
  enum class Look { curvature, polyhedron } look = Look::curvature;  ///< of the first picture
  std::optional<Vec3> eye;  ///< where the pictures are taken from, see RenderOptions
  std::optional<TableRow> paper, ours;
  double sigma = 0;  ///< our time step without unit; 0 where there were none
  std::vector<std::pair<std::string, std::string>> numbers;
  std::optional<FlowComparison> comparison;  ///< Fig. 5.5, 5.6
  Patch start;                               ///< of the comparison
  std::function<TriangleSoup(const Patch&)> surface;
};

/// Their ids in the paper's order.
std::vector<std::string> paper_figure_ids();

/// @throws InvalidArgument for an id that does not exist.
FigureRun run_paper_figure(const std::string& id);

}  // namespace loopmend
