// SPDX-License-Identifier: GPL-3.0-or-later
#include "fill_words.h"

#include "io/text_cursor.h"

#include "cli/option_parser.h"

#include <cmath>
#include <cstdio>
#include <string_view>
#include <utility>

namespace loopmend {

namespace {

constexpr std::array<Named<std::optional<TextureFill>>, 3> texture_names{
    {{"grain", TextureFill::grain}, {"smooth", TextureFill::smooth}, {"none", std::nullopt}}};
constexpr std::array<Named<MaterialFiles>, 2> materials_names{
    {{"copy", MaterialFiles::copy}, {"reference", MaterialFiles::reference}}};

/// @throws UsageError unless the text is two whole numbers.
std::pair<int, int> two_vertices(const char* option, const std::string& text) {
  int a = 0, b = 0, used = 0;
  if (std::sscanf(text.c_str(), "%d,%d%n", &a, &b, &used) != 2 || used != static_cast<int>(text.size()))
    throw UsageError(std::string(option) + " takes two input vertices such as 17,230, not '" + text + "'");
  return {a, b};
}

/// @throws UsageError unless the text is six finite numbers, the last three not all 0.
MirrorPlane mirror_plane_of(const std::string& text) {
  Vec3 point, normal;
  int used = 0;
  if (std::sscanf(text.c_str(), "%lf,%lf,%lf,%lf,%lf,%lf%n", &point[0], &point[1], &point[2], &normal[0], &normal[1],
                  &normal[2], &used) != 6 ||
      used != static_cast<int>(text.size()))
    throw UsageError("--mirror-plane takes a point and a normal, six numbers such as 0,0,0,1,0,0, not '" + text + "'");
  try {
    return make_mirror_plane(point, normal);
  } catch (const InvalidArgument& error) {
    throw UsageError("--mirror-plane " + text + ": " + error.what());
  }
}

void take_mirror(const FillWords& words, FillOptions& options) {
  if (words.mirror) options.mirror = FillOptions::Mirror::find;
  if (!words.mirror_plane.empty()) options.mirror_planes = {mirror_plane_of(words.mirror_plane)};
  if ((words.mirror || !words.mirror_plane.empty()) && words.flow.flow == "none")
    throw UsageError("--mirror has no effect with --flow none, which leaves the first shape");
}

void take_edge_edits(const FillWords& words, FillOptions& options) {
  if (words.drawn_edges.empty() && words.stopped_edges.empty()) return;
  if (!options.evolution || !continues_edges(*options.evolution))
    throw UsageError(
        "--draw-edge and --stop-edge take effect with the default flow, boundary and continuity, and without --edges "
        "round");
  EdgeEdits& edits = options.evolution->edge_edits;
  for (const std::string& text : words.drawn_edges) edits.drawn.push_back(two_vertices("--draw-edge", text));
  if (!words.stopped_edges.empty()) edits.stopped = vertex_numbers_of(words.stopped_edges);
}

bool is_tolerance(std::string_view word) {
  if (word.ends_with('%')) word.remove_suffix(1);
  const std::optional<double> number = parse_double(word);
  return number && std::isfinite(*number);
}

}  // namespace

/// --weld, for the commands whose loops follow from it.
void add_weld(CLI::App& command, CoincidentVertices& coincident) {
  command.add_flag_callback(
      "--weld", [&coincident] { coincident = CoincidentVertices::weld; },
      "Join vertices at exactly the same place first, such as along the seams of a texture");
}

/// --double, for the commands whose output has the coordinates of the input.
void add_double(CLI::App& command, FloatText& float_text) {
  command.add_flag_callback(
      "--double", [&float_text] { float_text = FloatText::all_digits; },
      "Keep all digits of a text PLY that declares single precision; without it, as every reader of floats gets them");
}

void add_verbose(CLI::App& command, Detail& detail) {
  command.add_flag_callback(
      "--verbose", [&detail] { detail = Detail::all; },
      "Print every loop, and report each with all figures; of more than 50 only counts and the largest are printed");
}

void add_check(CLI::App& command, Check& check, const char* what) {
  command.add_flag_callback(
      "--check", [&check] { check = Check::printable; }, what);
}

void add_fill(CLI::App& app, FillCommand& command, FillWords& words) {
  CLI::App* fill = app.add_subcommand("fill", "Fill boundary loops with smooth patches");
  fill->add_option("IN", command.input, "Mesh to read (PLY, STL, OBJ, OFF, glTF, 3MF, VTK polydata)")->required();
  fill->add_option("-o,--output", command.output, "Mesh to write; its extension chooses the format")->required();
  add_weld(*fill, command.coincident);
  add_double(*fill, command.float_text);
  add_check(*fill, command.check, "Say whether the written mesh could be 3D-printed, as 'info --check' does");
  fill->add_flag_callback(
      "--patches-only", [&command] { command.content = FillCommand::Content::patches; },
      "Write the patches alone, without the scan");
  add_verbose(*fill, command.detail);
  fill->add_option("--loops", words.loops,
                   "Loops by the numbers that 'info' prints, or 'all'; behind a number or 'all' how the patch meets "
                   "the scan: flat "
                   "(a plane or minimal surface), tangent, smooth")
      ->type_name("all[:flat]|1,3:flat,...")
      ->capture_default_str();
  fill->add_option("--at-vertex", words.at_vertices, "Loops through these input vertices, 0-based")->type_name("V,...");
  fill->add_option("--max-edges", command.job.loops.max_edges, "Leave loops with more edges")
      ->check(between(1e-300, 1e300));
  fill->add_option("--max-diameter", command.job.loops.max_diameter, "Leave wider loops (mesh units)")
      ->check(between(1e-300, 1e300));
  fill->add_option("--all-but-largest", command.job.loops.all_but_largest,
                   "Leave the N largest loops, those of outer rims among them")
      ->check(between(0, 2147483647))
      ->type_name("N");
  fill->add_flag("--include-outer-rim", words.include_outer_rim, "Fill the outer rim of an open sheet as well");
  add_named(
      *fill, "--islands", words.islands, islands_names,
      "Components within a hole, and walls that end in one plane: join them by one patch, or give each hole its own");
  fill->add_flag_callback(
      "--auto", [&command] { command.job.prepare.extent = PrepareOptions::Extent::where_needed; },
      "Do first what this mesh needs, and nothing else: --cut-no-data where vertices mark missing data, --stitch where "
      "boundaries nearly coincide, --repair where loops run along edges of more than two faces, --trim-crossing where "
      "no patch "
      "could be valid");
  fill->add_flag_callback(
      "--turn-around", [&command] { command.job.prepare.sides = PrepareOptions::Sides::turned; },
      "Turn all faces round first, as those of a scan that is inside out");
  fill->add_option("--stitch", words.stitch,
                   "Zip boundaries that lie within L of each other first (mesh units), or within P percent of their "
                   "edges; 10% where nothing follows. With a length, tiles that overlap within it are joined, too: the "
                   "smaller one "
                   "loses what lies on the larger one, and the gap is filled")
      ->type_name("[L|P%]");
  fill->add_flag(
      "--repair", words.repair,
      "Make an oriented manifold of the mesh first: separate edges with more than two faces, turn faces, bodies "
      "that are inside out among them, remove "
      "degenerate and duplicate faces and fragments");
  fill->add_flag(
      "--cut-intersections", words.cut_intersections,
      "Repair as --repair does, and remove faces that cut others; the holes that this leaves are filled; closed "
      "bodies that overlap stay");
  fill->add_flag("--union", words.unite,
                 "Repair as --repair does, and make one body of closed ones that overlap; cavities stay");
  fill->add_flag(
      "--cut-handles", words.cut_handles,
      "Repair as --repair does, and cut open handles of at most eight edges, as noise leaves them, for their holes to "
      "be filled");
  fill->add_flag_callback(
      "--cut-no-data", [&command] { command.job.prepare.no_data = PrepareOptions::NoData::cut; },
      "Remove first the faces at vertices that mark missing data, such as heights of -9999; their holes are filled");
  fill->add_option("--cut-plane", words.cut_plane,
                   "Cut by a plane first, given by a point and its normal: what lies on the side of the normal is "
                   "removed, and the section is closed by plane faces")
      ->type_name("X,Y,Z,NX,NY,NZ");
  fill->add_option("--base", words.base,
                   "Build a base first under the largest loop, or loop N: a straight wall to a plane D below it (mesh "
                   "units), for prints")
      ->type_name("[N:]D");
  fill->add_option(
          "--bridge", words.bridges,
          "Lay a strip between the boundary vertices A and B (0-based) first, to part a complex hole; repeatable")
      ->type_name("A,B")
      ->expected(1)
      ->take_all();
  fill->add_option("--draw-edge", words.drawn_edges,
                   "Draw a sharp edge across a hole, between its boundary vertices A and B (0-based); repeatable")
      ->type_name("A,B")
      ->expected(1)
      ->take_all();
  fill->add_option("--stop-edge", words.stopped_edges,
                   "Do not continue the sharp edges that end at these boundary vertices (0-based)")
      ->type_name("V,...");
  fill->add_option("--trim-boundary", command.job.prepare.trim_rounds,
                   "First remove up to N rings of bad boundary triangles (dangling, slivers, spikes, flipped), and up "
                   "to ten of those that cross the surface")
      ->check(between(0, 100))
      ->type_name("N");
  fill->add_flag("--trim-crossing", words.trim_crossing,
                 "First remove the boundary triangles that run through the surface where no patch could be valid, and "
                 "nothing else");
  add_named(*fill, "--texture", command.write.texture, texture_names,
            "Texture of patches in a scan with a texture (OBJ, PLY): like the scan's, smooth colours, or none");
  add_named(*fill, "--materials", command.write.materials, materials_names,
            "Material files and pictures of OBJ: copied beside an output in another folder, or named where they are");
  fill->add_flag_callback(
      "--mark", [&command] { command.write.new_faces = NewFaces::labelled; },
      "Label the new triangles: face property patch of PLY and polydata, group loopmend_patch of OBJ, object of glTF "
      "and 3MF");
  fill->add_flag_callback(
      "--deviation", [&command] { command.deviations = FillCommand::Deviations::written; },
      "PLY: write how far each new vertex is likely from what was there, as vertex property expected_deviation");
  CLI::Option* mirror = fill->add_flag(
      "--mirror", words.mirror,
      "Close holes by a copy of the other side, mirrored, where the surface around them fits its image; the planes of "
      "symmetry are looked for");
  fill->add_option("--mirror-plane", words.mirror_plane, "The same with this plane: a point of it, and its normal")
      ->type_name("X,Y,Z,NX,NY,NZ")
      ->excludes(mirror);
  add_flow_options(*fill, words.flow, DensityOption::offer, ReliefOption::offer);
  fill->add_option("--threads", command.job.fill.threads, "Loops worked on at once; 0: one for each core")
      ->check(between(0, 1024))
      ->capture_default_str();
  fill->add_flag("--keep-partial", words.keep_partial, "Write what is finished when stopped by Ctrl-C or a signal");
  fill->add_option("--max-time", command.max_seconds,
                   "Leave what is not finished after so many seconds, and write the rest")
      ->check(between(1e-300, 1e9))
      ->type_name("SECONDS");
  fill->add_option("--max-memory", command.job.max_memory_mb,
                   "Leave loops whose patches would need more memory in all (default: 90 % of what is free)")
      ->check(between(1e-300, 1e9))
      ->type_name("MB");
  fill->footer(
      "All holes are filled by default; the outer rim of an open sheet is left.\n"
      "The input's vertices and faces come first in the output, in their order, bit-identical.\n"
      "Examples:\n"
      "  loopmend fill scan.ply -o filled.ply\n"
      "  loopmend fill scan.ply -o filled.stl --loops 2,5 --report report.json\n"
      "  loopmend fill scan.obj -o filled.ply --flow wf --mode steps --steps 20 --sigma 1\n"
      "Exit codes: 0 all done; 1 some loops failed, have a bad patch, or none could be filled, the rest is written; 2 "
      "wrong usage;\n"
      "3 input unreadable; 4 output unwritable; 128 + signal: stopped, 130 by Ctrl-C.");
}

void take_words(const FillWords& words, FillCommand& command) {
  command.verbosity = words.flow.verbosity();
  command.write.encoding = words.flow.encoding();
  command.report = words.flow.report;
  if (words.keep_partial) command.when_stopped = FillCommand::WhenStopped::keep_finished;

  command.job.source = command.input;
  if (command.coincident == CoincidentVertices::weld) command.job.numbering = ScanJob::Numbering::of_prepared;

  LoopSelection& loops = command.job.loops;
  take_loops(words.loops, loops);
  if (words.at_vertices) loops.at_vertices = vertex_numbers_of(*words.at_vertices);
  if (words.include_outer_rim) loops.outer_rim = LoopSelection::OuterRim::include;

  FillOptions& fill = command.job.fill;
  const int threads = fill.threads;
  fill = options_of(words.flow);
  fill.threads = threads;
  take_mirror(words, fill);
  take_edge_edits(words, fill);
  fill.islands = words.islands;

  PrepareOptions& prepare = command.job.prepare;
  if (!words.stitch.empty()) {
    prepare.stitch = PrepareOptions::Stitch::yes;
    prepare.stitch_tolerance = stitch_tolerance_of(words.stitch);
  }
  if (words.trim_crossing) prepare.trim_pierced = PrepareOptions::TrimPierced::yes;
  if (words.repair || words.cut_intersections || words.cut_handles || words.unite) prepare.repair = harmless_repairs;
  if (words.cut_intersections) prepare.repair.insert(Defect::intersections);
  if (words.cut_handles) prepare.repair.insert(Defect::handles);
  if (words.unite) prepare.repair.insert(Defect::overlaps);
  if (!words.cut_plane.empty()) prepare.cut_plane = cut_plane_of(words.cut_plane);
  if (!words.base.empty()) prepare.base = base_of(words.base);
  for (const std::string& text : words.bridges) prepare.bridges.push_back(two_vertices("--bridge", text));
}

std::vector<std::string> with_stitch_tolerances(std::vector<std::string> words) {
  std::vector<std::string> result;
  for (std::size_t k = 0; k < words.size(); ++k) {
    result.push_back(words[k]);
    if (words[k] != "--stitch") continue;
    const bool has_tolerance = k + 1 < words.size() && is_tolerance(words[k + 1]);
    result.back() += has_tolerance ? "=" + words[++k] : "=10%";
  }
  return result;
}

}  // namespace loopmend
