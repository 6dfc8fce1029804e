// SPDX-License-Identifier: GPL-3.0-or-later
// The commands for the paper's other problems: blend, interpolate, evolve, compare.
#pragma once

#include "cli/flow_words.h"

#include "filling/subdivide_polyhedron.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace loopmend {

struct BlendCommand {
  std::vector<std::filesystem::path> inputs;
  std::filesystem::path output;
  /// Of each patch "FILE:LOOP,..." by number; empty: one patch between those that face each other.
  std::vector<std::string> loops;
  FlowWords words;
  std::string command_line;  ///< as typed, for the report
};

struct InterpolateCommand {
  std::filesystem::path input, output;
  int subdivide = 3;            ///< each triangle into 4^k
  std::filesystem::path fixed;  ///< file of vertex numbers; empty: all
  PolyhedronBoundary boundary = PolyhedronBoundary::refuse;
  FlowWords words;
  std::string command_line;
};

struct EvolveCommand {
  std::filesystem::path input, output;
  std::filesystem::path region;  ///< file of vertex numbers
  std::string where;             ///< or a condition; see vertices_where
  FlowWords words;
  std::string command_line;
};

struct CompareCommand {
  std::vector<std::filesystem::path> inputs;
  std::filesystem::path output;  ///< folder
  std::string loops;             ///< of one patch, as in BlendCommand
  std::filesystem::path region;  ///< as in EvolveCommand
  std::string where;
  int subdivide = 0;            ///< as in InterpolateCommand; 0: no polyhedron is meant
  std::filesystem::path fixed;  ///< likewise
  PolyhedronBoundary boundary = PolyhedronBoundary::refuse;
  FlowWords words;
  std::string command_line;
};

/// @returns an ExitCode. @throws ReadError, WriteError, UsageError, InvalidArgument.
int run_blend(const BlendCommand& command);
int run_interpolate(const InterpolateCommand& command);
int run_evolve(const EvolveCommand& command);
int run_compare(const CompareCommand& command);

/// Options of all of them, and which one to run.
class PaperCommands {
 public:
  void add_to(CLI::App& app);
  /// @returns the exit code of the command that was given; empty if it was none of these.
  std::optional<int> run(const CLI::App& app, const std::string& command_line);

 private:
  BlendCommand blend_;
  InterpolateCommand interpolate_;
  EvolveCommand evolve_;
  CompareCommand compare_;
};

}  // namespace loopmend
