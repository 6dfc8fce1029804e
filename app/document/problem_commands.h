// SPDX-License-Identifier: GPL-3.0-or-later
// The command line for what is no single hole: regions, points, bridges, and comparisons of flows.
#pragma once

#include "document/command_line.h"
#include "filling/subdivide_polyhedron.h"

namespace loopmend {

/// A problem as the command line names it.
struct ProblemWords {
  QStringList before;  ///< commands that make the files it reads
  QString verb;        ///< that solves it, such as "evolve"; empty: only a comparison does
  QStringList inputs;  ///< files
  QString ending;      ///< of the name of what is written
  QString options;     ///< each with a blank before it
  QStringList remarks;
};

/// @param vertices  as pose_region() takes them: of the scan with its patches.
ProblemWords region_words(const Document& document, int scan, const std::vector<int>& vertices);
ProblemWords points_words(const Document& document, int scan, const SubdivisionOptions& options);
/// @param loops  in their order.
ProblemWords blend_words(const Document& document, const std::vector<int>& loops, double density);
/// Holes of one scan, all at once.
ProblemWords holes_words(const Document& document, const std::set<int>& loops, double density);

CommandLine solving_command(const ProblemWords& problem, const EvolutionOptions& options);
CommandLine comparing_command(const ProblemWords& problem, const EvolutionOptions& options,
                              const std::vector<FlowKind>& flows);
/// Puts it into the clipboard. @returns what to tell the person.
QString copy_to_clipboard(const CommandLine& command);

}  // namespace loopmend
