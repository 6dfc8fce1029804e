// SPDX-License-Identifier: GPL-3.0-or-later
#include "dispatch.h"

#include "batch/batch_command.h"
#include "commands.h"
#include "exit_codes.h"
#include "flow_words.h"
#include "interrupt.h"
#include "number_range.h"
#include "outputs.h"
#include "paper/paper_commands.h"
#include "stitch_words.h"

#include "core/memory.h"
#include "core/threads.h"
#include "core/version.h"

#include "cli/option_parser.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <iostream>
#include <new>
#include <thread>

namespace {

using namespace loopmend;

/// The command as it could be pasted into a shell.
std::string quoted_command_line(int argc, char** argv) {
  std::string line;
  for (int k = 0; k < argc; ++k) {
    const std::string word = argv[k];
    const bool plain = !word.empty() && word.find_first_not_of(
                                            "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz"
                                            "0123456789_-./,:=+@%") == std::string::npos;
    std::string shown = word;
    if (!plain) {
      shown = "'";
      for (char c : word) shown += c == '\'' ? std::string("'\\''") : std::string(1, c);
      shown += "'";
    }
    line += (k ? " " : "") + shown;
  }
  return line;
}

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

void add_info(CLI::App& app, InfoCommand& command) {
  CLI::App* info = app.add_subcommand("info", "Tell what is in a mesh: counts, repairs, boundary loops");
  info->add_option("IN", command.input, "Mesh to read (PLY, STL, OBJ, OFF, glTF, 3MF)")->required();
  add_weld(*info, command.coincident);
  add_double(*info, command.float_text);
  info->add_option("--json", command.json, "Write JSON to FILE, or to standard output for -")->type_name("FILE|-");
  add_check(*info, command.check,
            "Tell whether the surface could be printed: open, non-manifold and reversed edges, intersections");
  add_verbose(*info, command.detail);
  info->footer("Example:\n  loopmend info scan.ply\n  loopmend info scan.ply --json -");
}

/// Options whose types need a word-to-value table or a lambda.
struct FillWords {
  FlowWords flow;
  bool include_outer_rim = false, trim_crossing = false, repair = false, cut_intersections = false, cut_handles = false,
       keep_partial = false;
  std::string stitch;                ///< "0.5" or "5%"; empty: no stitching
  std::string base;                  ///< "5" or "2:5"; empty: none
  std::vector<std::string> bridges;  ///< "A,B"
  std::string islands = "join", texture = "grain", materials = "copy";
  bool mirror = false;
  std::string mirror_plane;  ///< "x,y,z,nx,ny,nz"; empty: none
};

void add_fill(CLI::App& app, FillCommand& command, FillWords& words) {
  CLI::App* fill = app.add_subcommand("fill", "Fill boundary loops with smooth patches");
  fill->add_option("IN", command.input, "Mesh to read (PLY, STL, OBJ, OFF, glTF, 3MF)")->required();
  fill->add_option("-o,--output", command.output, "Mesh to write; the extension tells the format")->required();
  add_weld(*fill, command.coincident);
  add_double(*fill, command.float_text);
  add_check(*fill, command.check, "Tell whether what was written could be printed, as 'info --check' does");
  fill->add_flag_callback(
      "--patches-only", [&command] { command.content = FillCommand::Content::patches; },
      "Write the patches alone, without the scan");
  add_verbose(*fill, command.detail);
  fill->add_option(
          "--loops", command.loops,
          "Loops by the numbers that 'info' prints, or 'all'; behind a number how its patch meets the scan: flat "
          "(a plane or minimal surface), tangent, smooth")
      ->type_name("all|1,3:flat,...")
      ->capture_default_str();
  fill->add_option("--at-vertex", command.at_vertices, "Loops through these input vertices, 0-based")
      ->type_name("V,...");
  fill->add_option("--max-edges", command.max_edges, "Leave loops with more edges")->check(between(1e-300, 1e300));
  fill->add_option("--max-diameter", command.max_diameter, "Leave wider loops (mesh units)")
      ->check(between(1e-300, 1e300));
  fill->add_option("--all-but-largest", command.all_but_largest,
                   "Leave the N largest loops, those of outer rims among them")
      ->check(between(0, 2147483647))
      ->type_name("N");
  fill->add_flag("--include-outer-rim", words.include_outer_rim, "Fill the outer rim of an open sheet as well");
  fill->add_option("--islands", words.islands,
                   "Pieces of surface within a hole: join them to its patch, or cover them with it")
      ->check(CLI::IsMember({"join", "cover"}))
      ->capture_default_str();
  fill->add_flag_callback(
      "--auto", [&command] { command.prepare = FillCommand::Prepare::where_needed; },
      "Do first what this mesh needs, and nothing else: --stitch where boundaries nearly coincide, --repair where "
      "loops "
      "run along edges of more than two faces, --trim-crossing where no patch could be valid");
  fill->add_option("--stitch", words.stitch,
                   "Zip boundaries that lie within L of each other first (mesh units), or within P percent of their "
                   "edges; 10% where nothing follows")
      ->type_name("[L|P%]");
  fill->add_flag(
      "--repair", words.repair,
      "Make an oriented manifold of the mesh first: separate edges with more than two faces, turn faces, bodies "
      "that are inside out among them, remove "
      "degenerate and duplicate faces and crumbs");
  fill->add_flag("--cut-intersections", words.cut_intersections,
                 "Repair as --repair does, and remove faces that cut others; the holes that this leaves are filled");
  fill->add_flag(
      "--cut-handles", words.cut_handles,
      "Repair as --repair does, and cut open handles of at most eight edges, as noise leaves them, for their holes to "
      "be filled");
  fill->add_flag_callback(
      "--cut-no-data", [&command] { command.no_data = FillCommand::NoData::cut; },
      "Remove first the faces at vertices that mark missing data, such as heights of -9999; their holes are filled");
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
  fill->add_option("--trim-rim", command.trim_rounds)->check(between(0, 100))->group("");  // its name before
  fill->add_option("--trim-boundary", command.trim_rounds,
                   "First remove up to N rings of bad boundary triangles (dangling, slivers, spikes, flipped), and up "
                   "to ten of those that cross the surface")
      ->check(between(0, 100))
      ->type_name("N");
  fill->add_flag("--trim-crossing", words.trim_crossing,
                 "First remove the boundary triangles that run through the surface where no patch could be valid, and "
                 "nothing else");
  fill->add_option("--texture", words.texture,
                   "Texture of patches in a scan with a texture (OBJ, PLY): like the scan's, smooth colours, or none")
      ->check(CLI::IsMember({"grain", "smooth", "none"}))
      ->capture_default_str();
  fill->add_option(
          "--materials", words.materials,
          "Material files and pictures of OBJ: copied beside an output in another folder, or named where they are")
      ->check(CLI::IsMember({"copy", "reference"}))
      ->capture_default_str();
  fill->add_flag_callback(
      "--mark", [&command] { command.write.new_faces = NewFaces::labelled; },
      "Label the new triangles: face property patch of PLY, group loopmend_patch of OBJ, object of glTF and 3MF");
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
  fill->add_option("--threads", command.fill.threads, "Loops worked on at once; 0: one for each core")
      ->check(between(0, 1024))
      ->capture_default_str();
  fill->add_flag("--keep-partial", words.keep_partial, "Write what is finished when stopped by Ctrl-C or a signal");
  fill->add_option("--max-time", command.max_seconds,
                   "Leave what is not finished after so many seconds, and write the rest")
      ->check(between(1e-300, 1e9))
      ->type_name("SECONDS");
  fill->add_option("--max-memory", command.max_memory_mb,
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

/// @throws UsageError unless the text is two whole numbers.
std::pair<int, int> bridge_ends(const std::string& text) {
  int a = 0, b = 0, used = 0;
  if (std::sscanf(text.c_str(), "%d,%d%n", &a, &b, &used) != 2 || used != static_cast<int>(text.size()))
    throw UsageError("--bridge takes two input vertices such as 17,230, not '" + text + "'");
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

void take_words(const FillWords& words, FillCommand& command) {
  command.outer_rim = words.include_outer_rim ? FillCommand::OuterRim::include : FillCommand::OuterRim::leave;
  command.verbosity = words.flow.verbosity();
  command.write.encoding = words.flow.encoding();
  command.write.texture = std::nullopt;
  if (words.texture != "none")
    command.write.texture = words.texture == "grain" ? TextureFill::grain : TextureFill::smooth;
  command.write.materials = words.materials == "copy" ? MaterialFiles::copy : MaterialFiles::reference;
  command.report = words.flow.report;
  const int threads = command.fill.threads;
  command.fill = options_of(words.flow);
  command.fill.threads = threads;
  take_mirror(words, command.fill);
  command.fill.islands = words.islands == "cover" ? FillOptions::Islands::cover : FillOptions::Islands::join;
  if (words.keep_partial) command.when_stopped = FillCommand::WhenStopped::keep_finished;
  if (!words.stitch.empty()) {
    command.stitch = FillCommand::Stitch::yes;
    command.stitch_tolerance = stitch_tolerance_of(words.stitch);
  }
  if (words.trim_crossing) command.trim_pierced = FillCommand::TrimPierced::yes;
  if (words.repair || words.cut_intersections || words.cut_handles) command.repair = harmless_repairs;
  if (words.cut_intersections) command.repair.insert(Defect::intersections);
  if (words.cut_handles) command.repair.insert(Defect::handles);
  if (!words.base.empty()) command.base = base_of(words.base);
  for (const std::string& text : words.bridges) command.bridges.push_back(bridge_ends(text));
}

/// @throws UsageError unless `loopmend fill` takes these options, and batch leaves them to the caller.
void check_fill_options(const std::vector<std::string>& options) {
  CLI::App app("", "loopmend");
  app.allow_windows_style_options(false);
  FillCommand fill;
  FillWords words;
  add_fill(app, fill, words);
  std::vector<std::string> all{"fill", "IN", "-o", "OUT"};
  all.insert(all.end(), options.begin(), options.end());
  all = with_stitch_tolerances(std::move(all));
  std::reverse(all.begin(), all.end());  // as parse() takes them
  try {
    app.parse(all);
  } catch (const CLI::Success&) {
    throw UsageError("--help is no option of a batch's scans: see 'loopmend fill --help'");
  } catch (const CLI::ParseError& error) {
    throw UsageError(std::string("options of fill, behind -- or in a manifest: ") + error.what());
  }
  if (!words.stitch.empty()) stitch_tolerance_of(words.stitch);
  if (!words.base.empty()) base_of(words.base);
  FillOptions mirrored;
  take_mirror(words, mirrored);
  if (!words.flow.report.empty()) throw UsageError("--report is not for batch: every scan has a report of its own");
  if (words.keep_partial)
    throw UsageError("--keep-partial is not for batch: the next run fills again what was stopped");
}

void add_render(CLI::App& app, RenderCommand& command) {
  CLI::App* render = app.add_subcommand("render", "Make a picture of a mesh; needs no display");
  render->add_option("IN", command.inputs, "One mesh, or two to be shown side by side")->required()->expected(1, 2);
  render->add_option("-o,--output", command.output, "PNG file to write")->required();
  render
      ->add_option("--color", command.color,
                   "scan: the scan's own colours or texture; h: mean curvature; plain; "
                   "zebra: reflection lines; auto: scan where it has colours, else h")
      ->check(CLI::IsMember({"auto", "scan", "h", "plain", "zebra"}))
      ->capture_default_str();
  const auto take_size = [&command](const std::string& text) {
    int used = 0;
    if (std::sscanf(text.c_str(), "%dx%d%n", &command.width, &command.height, &used) != 2 ||
        used != static_cast<int>(text.size()) || command.width < 64 || command.height < 64 || command.width > 8192 ||
        command.height > 8192)
      throw CLI::ValidationError("--size", "takes WIDTHxHEIGHT in pixels, 64x64 to 8192x8192, not '" + text + "'");
  };
  render->add_option_function<std::string>("--size", take_size, "Size of the picture in pixels")->type_name("WxH");
  CLI::Option* view =
      render
          ->add_option(
              "--view", command.view,
              "From where to look; up is z where the mesh is tallest along z, y otherwise (default: into most of "
              "the holes)")
          ->check(CLI::IsMember({"front", "back", "left", "right", "top", "bottom", "iso"}));
  const auto take_direction = [&command](const std::string& text) {
    Vec3 eye;
    int used = 0;
    if (std::sscanf(text.c_str(), "%lf,%lf,%lf%n", &eye[0], &eye[1], &eye[2], &used) != 3 ||
        used != static_cast<int>(text.size()) || !eye.allFinite() || eye.isZero(0))
      throw CLI::ValidationError("--direction", "takes three numbers such as 1,-2,0.5, not all 0, not '" + text + "'");
    command.direction = eye;
  };
  render->add_option_function<std::string>("--direction", take_direction, "From the middle of the mesh towards the eye")
      ->type_name("X,Y,Z")
      ->excludes(view);
  render->add_option("--loop", command.loop, "Frame this boundary loop, by the number that 'info' prints")
      ->check(between(1, 2147483647))
      ->type_name("N");
  render->footer(
      "Examples:\n  loopmend render filled.ply -o filled.png\n"
      "  loopmend render scan.ply filled.ply -o before_after.png --color zebra --size 1600x800\n"
      "  loopmend render scan.ply -o hole_3.png --loop 3");
}

int say(const std::exception& error, int code) {
  std::fprintf(stderr, "loopmend: %s\n", error.what());
  return code;
}

/// Where files are at stake: with what became of them.
int say_with_files(const std::string& words, int code) {
  std::fprintf(stderr, "loopmend: %s %s\n", words.c_str(), what_was_written().c_str());
  return code;
}

/// @param threads  wanted at once; 0: one for each core.
/// @returns for how many the address space suffices. @throws LimitError where it suffices for none.
int affordable_threads(int threads) {
  const int wanted = threads > 0 ? threads : static_cast<int>(std::max(1U, std::thread::hardware_concurrency()));
  const int affordable = claim_work_memory(wanted);
  if (affordable > 0) return affordable == wanted ? threads : affordable;
  throw LimitError("the address space of this process is limited (ulimit -v), and " +
                   std::to_string(least_work_memory >> 20) + " MB that the work needs are not left. Raise the limit.");
}

/// How many words are batch's own: those behind "--" are options of fill.
int words_before_those_of_fill(int argc, char** argv) {
  if (argc < 2 || std::string("batch") != argv[1]) return argc;
  return static_cast<int>(std::find(argv, argv + argc, std::string("--")) - argv);
}

int run(int argc, char** argv) {
  CLI::App app("Loopmend closes holes in scanned meshes with patches whose curvature runs through the seam.",
               "loopmend");
  app.allow_windows_style_options(false);  // the same words on every system; there, "/name" would be an option
  app.set_version_flag("--version", std::string("loopmend ") + version());
  app.require_subcommand(1);
  app.footer("'loopmend COMMAND --help' tells more about a command, with examples.");
  InfoCommand info;
  FillCommand fill;
  FillWords words;
  RenderCommand render;
  std::filesystem::path sample_output;
  add_info(app, info);
  add_fill(app, fill, words);
  CLI::App* sample = app.add_subcommand("sample", "Write the embedded sample, a scan-like relief with holes");
  sample->add_option("-o,--output", sample_output, "Mesh to write")->required();
  add_render(app, render);
  PaperCommands paper;
  paper.add_to(app);
  BatchCommand batch;
  add_batch(app, batch);
  const int own_words = words_before_those_of_fill(argc, argv);
  try {
    std::vector<std::string> all = with_stitch_tolerances({argv + 1, argv + own_words});
    std::reverse(all.begin(), all.end());  // as parse() takes them
    app.parse(std::move(all));
  } catch (const CLI::Success& asked) {
    return app.exit(asked);  // --help, --version
  } catch (const CLI::ParseError& error) {
    std::fprintf(stderr, "loopmend: %s\nTry 'loopmend --help'.\n", error.what());
    return exit_usage;
  }
  if (app.got_subcommand("info")) return run_info(info);
  if (app.got_subcommand("sample")) return run_sample(sample_output);
  if (app.got_subcommand("render")) return run_render(render);
  if (app.got_subcommand("batch")) {
    if (batch.prepare == BatchCommand::Prepare::where_needed) batch.fill_options.emplace_back("--auto");
    if (own_words < argc) batch.fill_options.insert(batch.fill_options.end(), argv + own_words + 1, argv + argc);
    batch.command_line = quoted_command_line(argc, argv);
    return run_batch(batch, check_fill_options);
  }
  fill.fill.threads = affordable_threads(fill.fill.threads);
  fill.command_line = quoted_command_line(argc, argv);
  return with_thread_budget(fill.fill.threads, [&] {
    if (const auto code = paper.run(app, fill.command_line)) return *code;
    take_words(words, fill);
    return run_fill(fill);
  });
}

}  // namespace

namespace loopmend {

int dispatch(int argc, char** argv) {
  try {
    const int code = run(argc, argv);
    const bool flushed = std::fflush(stdout) == 0 && std::ferror(stdout) == 0;
    if (std::cout.flush() && flushed) return code;
    if (reader_has_gone()) return exit_reader_gone;
    return say_with_files("standard output cannot be written; is the disk full?", exit_unwritable);
  } catch (const ReadError& error) {
    return say(error, exit_unreadable);
  } catch (const WriteError& error) {
    return say_with_files(error.what(), exit_unwritable);
  } catch (const LimitError& error) {
    return say_with_files(error.what(), exit_internal);
  } catch (const UsageError& error) {
    return say(error, exit_usage);
  } catch (const InvalidArgument& error) {
    return say(error, exit_usage);
  } catch (const std::bad_alloc&) {
    return say_with_files("out of memory. A smaller --density or fewer loops at once need less.", exit_internal);
  } catch (const Error& error) {
    return say_with_files(error.what(), exit_internal);
  } catch (const std::exception& error) {
    return say_with_files(std::string("internal error: ") + error.what() + ".", exit_internal);
  }
}

}  // namespace loopmend
