// SPDX-License-Identifier: GPL-3.0-or-later
// The options of `loopmend fill` as words on the command line.
#pragma once

#include "commands.h"
#include "flow_words.h"

#include <optional>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace loopmend {

/// Options whose types need a word-to-value table or a lambda.
struct FillWords {
  FlowWords flow;
  std::string loops = "all";               ///< or "1,3:flat"
  std::optional<std::string> at_vertices;  ///< "17,230"
  bool include_outer_rim = false, trim_crossing = false, repair = false, cut_intersections = false, cut_handles = false,
       unite = false, keep_partial = false;
  std::string stitch;                             ///< "0.5" or "5%"; empty: no stitching
  std::string base;                               ///< "5" or "2:5"; empty: none
  std::vector<std::string> bridges, drawn_edges;  ///< "A,B"
  std::string stopped_edges;                      ///< "17,230"; empty: none
  FillOptions::Islands islands = FillOptions::Islands::join;
  bool mirror = false;
  std::string mirror_plane;  ///< "x,y,z,nx,ny,nz"; empty: none
  std::string cut_plane;     ///< likewise
};

/// Adds the command `fill`. Its options that need no table of words stand in `command` when it was parsed.
void add_fill(CLI::App& app, FillCommand& command, FillWords& words);

/// Puts the words into the command. @throws UsageError, InvalidArgument for words that say nothing.
void take_words(const FillWords& words, FillCommand& command);

/// The words of a command line with the tolerance that follows --stitch, or the default, joined to it ("--stitch=10%"), so that a
/// file's name is not taken for one.
std::vector<std::string> with_stitch_tolerances(std::vector<std::string> words);

/// Options of several commands.
void add_weld(CLI::App& command, CoincidentVertices& coincident);
void add_double(CLI::App& command, FloatText& float_text);
void add_verbose(CLI::App& command, Detail& detail);
void add_check(CLI::App& command, Check& check, const char* what);

}  // namespace loopmend
