// The `loopmend` command line: parses the words, calls one command, turns errors into one line and an exit code.
#include "commands.h"
#include "exit_codes.h"
#include "flow_words.h"
#include "interrupt.h"
#include "number_range.h"
#include "paper/paper_commands.h"

#include "core/memory.h"
#include "core/version.h"

#include <CLI/CLI.hpp>

#include <clocale>
#include <cstdio>
#include <iostream>
#include <new>

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

void add_info(CLI::App& app, InfoCommand& command) {
  CLI::App* info = app.add_subcommand("info", "Tell what is in a mesh: counts, repairs, boundary loops");
  info->add_option("IN", command.input, "Mesh to read (PLY, STL, OBJ, OFF)")->required();
  info->add_option("--json", command.json, "Write JSON to FILE, or to standard output for -")->type_name("FILE|-");
  info->footer("Example:\n  loopmend info scan.ply\n  loopmend info scan.ply --json -");
}

/// Options whose types need a word-to-value table or a lambda.
struct FillWords {
  FlowWords flow;
  bool include_outer_rim = false, bridge_islands = false;
};

void add_fill(CLI::App& app, FillCommand& command, FillWords& words) {
  CLI::App* fill = app.add_subcommand("fill", "Fill boundary loops with smooth patches");
  fill->add_option("IN", command.input, "Mesh to read (PLY, STL, OBJ, OFF)")->required();
  fill->add_option("-o,--output", command.output, "Mesh to write; the extension tells the format")->required();
  fill->add_option("--loops", command.loops, "Loops by the numbers that 'info' prints, or 'all'")
      ->type_name("all|1,3,...")
      ->capture_default_str();
  fill->add_option("--at-vertex", command.at_vertices, "Loops through these input vertices, 0-based")
      ->type_name("V,...");
  fill->add_option("--max-edges", command.max_edges, "Leave loops with more edges")->check(between(1e-300, 1e300));
  fill->add_option("--max-diameter", command.max_diameter, "Leave wider loops (mesh units)")
      ->check(between(1e-300, 1e300));
  fill->add_flag("--include-outer-rim", words.include_outer_rim, "Fill the outer rim of an open sheet as well");
  fill->add_flag("--bridge-islands", words.bridge_islands,
                 "Join a hole to the pieces of surface that lie within it, instead of covering these");
  fill->add_option("--trim-rim", command.trim_rounds,
                   "First remove up to N rings of bad rim triangles (dangling, slivers, spikes, flipped)")
      ->check(between(0, 100))
      ->type_name("N");
  add_flow_options(*fill, words.flow, DensityOption::offer);
  fill->add_option("--threads", command.fill.threads, "Loops worked on at once; 0: one for each core")
      ->check(between(0, 1024))
      ->capture_default_str();
  fill->footer(
      "All holes are filled by default; the outer rim of an open sheet is left.\n"
      "The input's vertices and faces come first in the output, in their order, bit-identical.\n"
      "Examples:\n"
      "  loopmend fill scan.ply -o filled.ply\n"
      "  loopmend fill scan.ply -o filled.stl --loops 2,5 --report report.json\n"
      "  loopmend fill scan.obj -o filled.ply --flow wf --mode steps --steps 20 --sigma 1\n"
      "Exit codes: 0 all done; 1 some loops failed, the rest is written; 2 wrong usage; 3 input unreadable;\n"
      "4 output unwritable; 130 cancelled.");
}

void take_words(const FillWords& words, FillCommand& command) {
  command.outer_rim = words.include_outer_rim ? FillCommand::OuterRim::include : FillCommand::OuterRim::leave;
  command.islands = words.bridge_islands ? FillCommand::Islands::bridge : FillCommand::Islands::leave;
  command.verbosity = words.flow.verbosity();
  command.encoding = words.flow.encoding();
  command.report = words.flow.report;
  const int threads = command.fill.threads;
  command.fill = options_of(words.flow);
  command.fill.threads = threads;
}

void add_render(CLI::App& app, RenderCommand& command) {
  CLI::App* render = app.add_subcommand("render", "Make a picture of a mesh; needs no display");
  render->add_option("IN", command.inputs, "One mesh, or two to be shown side by side")->required()->expected(1, 2);
  render->add_option("-o,--output", command.output, "PNG file to write")->required();
  render->add_option("--color", command.color, "h: mean curvature; plain; zebra: reflection lines")
      ->check(CLI::IsMember({"h", "plain", "zebra"}))
      ->capture_default_str();
  const auto take_size = [&command](const std::string& text) {
    int used = 0;
    if (std::sscanf(text.c_str(), "%dx%d%n", &command.width, &command.height, &used) != 2 ||
        used != static_cast<int>(text.size()) || command.width < 64 || command.height < 64 || command.width > 8192 ||
        command.height > 8192)
      throw CLI::ValidationError("--size", "takes WIDTHxHEIGHT in pixels, 64x64 to 8192x8192, not '" + text + "'");
  };
  render->add_option_function<std::string>("--size", take_size, "Size of the picture in pixels")->type_name("WxH");
  render->footer(
      "Examples:\n  loopmend render filled.ply -o filled.png\n"
      "  loopmend render scan.ply filled.ply -o before_after.png --color zebra --size 1600x800");
}

int say(const std::exception& error, int code) {
  std::fprintf(stderr, "loopmend: %s\n", error.what());
  return code;
}

int run(int argc, char** argv) {
  CLI::App app("Loopmend closes holes in scanned meshes with patches whose curvature runs through the seam.",
               "loopmend");
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
  try {
    app.parse(argc, argv);
  } catch (const CLI::Success& asked) {
    return app.exit(asked);  // --help, --version
  } catch (const CLI::ParseError& error) {
    std::fprintf(stderr, "loopmend: %s\nTry 'loopmend --help'.\n", error.what());
    return exit_usage;
  }
  if (app.got_subcommand("info")) return run_info(info);
  if (app.got_subcommand("sample")) return run_sample(sample_output);
  if (app.got_subcommand("render")) return run_render(render);
  if (const auto code = paper.run(app, quoted_command_line(argc, argv))) return *code;
  take_words(words, fill);
  fill.command_line = quoted_command_line(argc, argv);
  return run_fill(fill);
}

}  // namespace

int main(int argc, char** argv) {
  loopmend::keep_freed_memory();
  std::setlocale(LC_NUMERIC, "C");
  loopmend::exit_on_interrupt();
  try {
    const int code = run(argc, argv);
    if (std::fflush(stdout) == 0 && std::cout.flush()) return code;
    std::fprintf(stderr, "loopmend: standard output cannot be written; is the disk full?\n");
    return loopmend::exit_unwritable;
  } catch (const loopmend::ReadError& error) {
    return say(error, loopmend::exit_unreadable);
  } catch (const loopmend::WriteError& error) {
    return say(error, loopmend::exit_unwritable);
  } catch (const loopmend::UsageError& error) {
    return say(error, loopmend::exit_usage);
  } catch (const loopmend::InvalidArgument& error) {
    return say(error, loopmend::exit_usage);
  } catch (const std::bad_alloc&) {
    std::fprintf(stderr, "loopmend: out of memory. A smaller --density or fewer loops at once need less.\n");
    return loopmend::exit_internal;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "loopmend: internal error: %s\n", error.what());
    return loopmend::exit_internal;
  }
}
