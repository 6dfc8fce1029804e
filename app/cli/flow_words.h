// SPDX-License-Identifier: GPL-3.0-or-later
// The options of a flow as words on the command line, shared by the commands that evolve a patch.
#pragma once

#include "io/write_mesh.h"
#include "pipeline/fill_holes.h"
#include "progress_line.h"

#include <string>

namespace CLI {
class App;
}

namespace loopmend {

struct FlowWords {
  std::string flow = "mmcvf";  ///< or "none"
  EvolutionOptions evolution;  ///< but the flow
  double density = 1;
  std::string report;  ///< file or "-"; empty: none
  bool ascii = false, quiet = false;

  Encoding encoding() const { return ascii ? Encoding::ascii : Encoding::binary; }
  Verbosity verbosity() const { return quiet ? Verbosity::quiet : Verbosity::normal; }
};

/// Options that only some commands have.
enum class DensityOption { offer, leave_out };
enum class ReliefOption { offer, leave_out };

/// --flow, --mode, --steps, --sigma, --solver, --boundary, --continuity, --report, --ascii, --quiet, and --density where
/// offered, --relief and --relief-seed likewise.
void add_flow_options(CLI::App& command, FlowWords& words, DensityOption density,
                      ReliefOption relief = ReliefOption::leave_out);

FillOptions options_of(const FlowWords& words);

}  // namespace loopmend
