// SPDX-License-Identifier: GPL-3.0-or-later
#include "paper_commands.h"

#include "cli/option_parser.h"

namespace loopmend {

namespace {

constexpr const char* exit_codes_help =
    "Exit codes: 0 done; 1 no valid surface was found, nothing is written; 2 wrong usage; 3 input unreadable;\n"
    "4 output unwritable; 130 cancelled.";

void add_blend(CLI::App& app, BlendCommand& command) {
  CLI::App* blend = app.add_subcommand("blend", "Join loops of one or several meshes by one smooth patch");
  blend->add_option("IN", command.inputs, "Meshes to read (PLY, STL, OBJ, OFF, glTF, 3MF)")->required();
  blend->add_option("-o,--output", command.output, "Mesh to write; its extension chooses the format")->required();
  blend
      ->add_option("--loops", command.loops,
                   "Loops as FILE:LOOP; files count from 1 in the order given, loops as 'info' prints them. Give it "
                   "once for each patch")
      ->allow_extra_args(false)
      ->type_name("1:2,2:1,...");
  add_flow_options(*blend, command.words, DensityOption::offer);
  blend->footer(
      std::string("Without --loops: of each file the loop that faces the others most; of one file its two loops.\n"
                  "The files' vertices and faces come first in the output, in their order.\n"
                  "Examples:\n"
                  "  loopmend blend left.ply right.ply -o joined.ply\n"
                  "  loopmend blend tube.ply -o whole.ply --loops 1:2,1:3\n"
                  "  loopmend blend pipe.ply -o whole.ply --loops 1:1,1:3 --loops 1:2,1:4\n"
                  "  loopmend blend a.ply b.ply c.ply -o abc.ply --loops 1:1,2:2,3:1 --report report.json\n") +
      exit_codes_help);
}

void add_interpolate(CLI::App& app, InterpolateCommand& command) {
  CLI::App* interpolate =
      app.add_subcommand("interpolate", "Find a smooth surface through the vertices of a polyhedron");
  interpolate->add_option("POLY", command.input, "Polyhedron to read (PLY, STL, OBJ, OFF, glTF, 3MF)")->required();
  interpolate->add_option("-o,--output", command.output, "Mesh to write; its extension chooses the format")->required();
  interpolate->add_option("--subdivide", command.subdivide, "Each triangle into 4^K")
      ->type_name("K")
      ->capture_default_str();
  interpolate->add_option("--fixed", command.fixed, "File of vertex numbers, 0-based: go through these alone")
      ->type_name("FILE");
  interpolate->add_flag_callback(
      "--open", [&command] { command.boundary = PolyhedronBoundary::smooth; },
      "Take an open polyhedron; its boundary loops become smooth curves through their vertices");
  add_flow_options(*interpolate, command.words, DensityOption::leave_out);
  interpolate->footer(std::string("The fixed vertices come first in the output, in their order, bit-identical.\n"
                                  "Examples:\n"
                                  "  loopmend interpolate dodecahedron.off -o ball.ply\n"
                                  "  loopmend interpolate hull.obj -o body.ply --subdivide 4 --open\n") +
                      exit_codes_help);
}

void add_evolve(CLI::App& app, EvolveCommand& command) {
  CLI::App* evolve = app.add_subcommand("evolve", "Evolve a region of a mesh with its neighborhood fixed");
  evolve->add_option("IN", command.input, "Mesh to read (PLY, STL, OBJ, OFF, glTF, 3MF)")->required();
  evolve->add_option("-o,--output", command.output, "Mesh to write; its extension chooses the format")->required();
  evolve->add_option("--region", command.region, "File of the region's vertex numbers, 0-based")->type_name("FILE");
  evolve->add_option("--where", command.where, "The region by a condition on x, y, z, H or K, such as z>0.725")
      ->type_name("CONDITION");
  add_flow_options(*evolve, command.words, DensityOption::leave_out);
  evolve->footer(std::string("Vertices and faces keep their numbers; all outside the region are bit-identical.\n"
                             "Examples:\n"
                             "  loopmend evolve part.ply -o fair.ply --region bump.txt\n"
                             "  loopmend evolve terrain.ply -o flat.ply --where 'z>0.725' --flow wf --report -\n") +
                 exit_codes_help);
}

void add_compare(CLI::App& app, CompareCommand& command) {
  CLI::App* compare = app.add_subcommand("compare", "Run MCF, SDF, WF and MMCVF from one start, side by side");
  compare->add_option("IN", command.inputs, "Meshes to read: one with holes, or parts to be blended")->required();
  compare->add_option("-o,--output", command.output, "Folder to write to; made if need be")
      ->type_name("DIR")
      ->required();
  compare->add_option("--loops", command.loops, "Blend these loops, as FILE:LOOP")->type_name("1:2,2:1,...");
  compare->add_option("--region", command.region, "Compare in a region: file of vertex numbers")->type_name("FILE");
  compare->add_option("--where", command.where, "Compare in a region: condition, such as z>0.725")
      ->type_name("CONDITION");
  compare
      ->add_option("--subdivide", command.subdivide, "Compare through the vertices of a polyhedron, as 'interpolate'")
      ->type_name("K")
      ->check(CLI::Range(1, 8));
  compare->add_option("--fixed", command.fixed, "With --subdivide: go through these vertices alone")->type_name("FILE");
  compare->add_flag_callback(
      "--open", [&command] { command.boundary = PolyhedronBoundary::smooth; },
      "With --subdivide: take an open polyhedron");
  command.words.evolution.boundary = BoundaryTrust::exact;  // the flows themselves are compared
  add_flow_options(*compare, command.words, DensityOption::offer);
  compare->get_option("--boundary")->check(CLI::IsMember({"exact", "robust"}));
  compare->remove_option(compare->get_option("--flow"));
  compare->remove_option(compare->get_option("--ascii"));
  compare->footer(
      "Written: start.ply and a mesh for each flow; compare.png with one range of colours; the section of H across "
      "the\n"
      "seam as profile.csv and profile.svg; energies and seam figures as table.csv and table.md.\n"
      "MCF takes at most 40 small steps: it has no steady state between tubes.\n"
      "Examples:\n"
      "  loopmend compare scan.ply -o flows\n"
      "  loopmend compare a.ply b.ply c.ply -o flows\n"
      "  loopmend compare graph.ply -o flows --where 'z>0.725'\n"
      "  loopmend compare dodecahedron.off -o flows --subdivide 3");
}

}  // namespace

void PaperCommands::add_to(CLI::App& app) {
  add_blend(app, blend_);
  add_interpolate(app, interpolate_);
  add_evolve(app, evolve_);
  add_compare(app, compare_);
}

std::optional<int> PaperCommands::run(const CLI::App& app, const std::string& command_line) {
  blend_.command_line = interpolate_.command_line = evolve_.command_line = compare_.command_line = command_line;
  if (app.got_subcommand("blend")) return run_blend(blend_);
  if (app.got_subcommand("interpolate")) return run_interpolate(interpolate_);
  if (app.got_subcommand("evolve")) return run_evolve(evolve_);
  if (app.got_subcommand("compare")) return run_compare(compare_);
  return std::nullopt;
}

}  // namespace loopmend
