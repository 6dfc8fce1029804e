#include "paper_commands.h"

#include <CLI/CLI.hpp>

namespace loopmend {

namespace {

constexpr const char* exit_codes_help =
    "Exit codes: 0 done; 1 no valid surface was found, nothing is written; 2 wrong usage; 3 input unreadable;\n"
    "4 output unwritable; 130 cancelled.";

void add_blend(CLI::App& app, BlendCommand& command) {
  CLI::App* blend = app.add_subcommand("blend", "Join loops of one or several meshes by one smooth patch");
  blend->add_option("IN", command.inputs, "Meshes to read (PLY, STL, OBJ, OFF)")->required();
  blend->add_option("-o,--output", command.output, "Mesh to write; the extension tells the format")->required();
  blend
      ->add_option("--loops", command.loops,
                   "Loops as FILE:LOOP; files count from 1 in the order given, loops as 'info' prints them")
      ->type_name("1:2,2:1,...");
  add_flow_options(*blend, command.words, DensityOption::offer);
  blend->footer(
      std::string("Without --loops: of each file the loop that faces the others most; of one file its two loops.\n"
                  "The files' vertices and faces come first in the output, in their order.\n"
                  "Examples:\n"
                  "  loopmend blend left.ply right.ply -o joined.ply\n"
                  "  loopmend blend tube.ply -o whole.ply --loops 1:2,1:3\n"
                  "  loopmend blend a.ply b.ply c.ply -o abc.ply --loops 1:1,2:2,3:1 --report report.json\n") +
      exit_codes_help);
}

}  // namespace

void PaperCommands::add_to(CLI::App& app) { add_blend(app, blend_); }

std::optional<int> PaperCommands::run(const CLI::App& app, const std::string& command_line) {
  if (app.got_subcommand("blend")) {
    blend_.command_line = command_line;
    return run_blend(blend_);
  }
  return std::nullopt;
}

}  // namespace loopmend
