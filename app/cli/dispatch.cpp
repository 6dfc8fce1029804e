// SPDX-License-Identifier: GPL-3.0-or-later
#include "dispatch.h"

#include "batch_command.h"
#include "commands.h"
#include "exit_codes.h"
#include "fill_words.h"
#include "interrupt.h"
#include "outputs.h"
#include "paper/paper_commands.h"

#include "core/memory.h"
#include "core/threads.h"
#include "core/version.h"
#include "evolution/option_names.h"

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

void add_info(CLI::App& app, InfoCommand& command) {
  CLI::App* info = app.add_subcommand("info", "Tell what is in a mesh: counts, repairs, boundary loops");
  info->add_option("IN", command.input, "Mesh to read (PLY, STL, OBJ, OFF, glTF, 3MF, VTK polydata)")->required();
  add_weld(*info, command.coincident);
  add_double(*info, command.float_text);
  info->add_option("--json", command.json, "Write JSON to FILE, or to standard output for -")->type_name("FILE|-");
  add_check(*info, command.check,
            "Say whether the surface could be 3D-printed: open, non-manifold and reversed edges, intersections");
  add_verbose(*info, command.detail);
  info->footer("Example:\n  loopmend info scan.ply\n  loopmend info scan.ply --json -");
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
  take_words(words, fill);
  if (!words.flow.report.empty()) throw UsageError("--report is not for batch: every scan has a report of its own");
  if (words.keep_partial)
    throw UsageError("--keep-partial is not for batch: the next run fills again what was stopped");
}

void add_render(CLI::App& app, RenderCommand& command) {
  CLI::App* render = app.add_subcommand("render", "Make a picture of a mesh, or a film of a flow; needs no display");
  render->add_option("IN", command.inputs, "One mesh, or two to be shown side by side")->required()->expected(1, 2);
  CLI::Option* picture = render->add_option("-o,--output", command.output, "PNG file to write");
  CLI::Option* film =
      render
          ->add_option("--film", command.film, "GIF file to write: the flow on the hole of --loop, or the largest one")
          ->excludes(picture);
  render->add_option("--flow", command.flow, "Of a film: the flow")
      ->check(CLI::IsMember(names_in(flow_names)))
      ->needs(film)
      ->capture_default_str();
  render
      ->add_option("--mode", command.mode,
                   "Of a film: steady: straight to the steady state; steps: by the time steps of the paper's scheme")
      ->check(CLI::IsMember(names_in(mode_names)))
      ->needs(film)
      ->capture_default_str();
  render
      ->add_option("--sigma", command.sigma, "Of a film by steps: their size; 10 is large, 0.1 shows the flow at work")
      ->check(between(1e-6, 1e8))
      ->needs(film)
      ->capture_default_str();
  render
      ->add_option("--film-rate", command.film_rate,
                   "Of a film: states a second (default: up to ten, some six seconds in all)")
      ->check(between(0.5, 50))
      ->needs(film);
  render
      ->add_option("--film-length", command.film_length,
                   "Of a film: it lasts at least so many seconds; each state is seen for longer")
      ->check(between(0, 600))
      ->needs(film);
  render
      ->add_option("--color", command.color,
                   "scan: the scan's own colours or texture; h: mean curvature; plain; "
                   "zebra: reflection lines; auto: scan where it has colours, else h")
      ->check(CLI::IsMember({"auto", "scan", "h", "plain", "zebra"}))
      ->excludes(film)
      ->capture_default_str();
  render
      ->add_flag_callback(
          "--seams", [&command] { command.seams = Seams::shown; },
          "Of two meshes: draw lines around the patches of the second")
      ->excludes(film);
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
      "  loopmend render scan.ply -o hole_3.png --loop 3\n"
      "  loopmend render scan.ply --film flow.gif --loop 3 --mode steps --sigma 0.1 --size 640x480");
}

int fail_with(const std::exception& error, int code) {
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
  throw LimitError(
      say("the address space of this process is limited (ulimit -v), and %1 MB that the work needs are not left. Raise "
          "the limit.",
          least_work_memory >> 20));
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
  app.footer("'loopmend COMMAND --help' explains a command, with examples.");
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
    if (app.get_subcommands().empty() && argc > 1 && argv[1][0] != '-') {
      std::fprintf(stderr, "loopmend: there is no command '%s'\nTry 'loopmend --help'.\n", argv[1]);
      return exit_usage;
    }
    std::fprintf(stderr, "loopmend: %s\nTry 'loopmend --help'.\n", error.what());
    return exit_usage;
  }
  if (app.got_subcommand("info")) return run_info(info);
  if (app.got_subcommand("sample")) return run_sample(sample_output);
  if (app.got_subcommand("render")) return run_render(render);
  if (app.got_subcommand("batch")) {
    if (own_words < argc) batch.job.fill_options.assign(argv + own_words + 1, argv + argc);
    batch.job.command_line = quoted_command_line(argc, argv);
    return run_batch(batch, check_fill_options);
  }
  fill.job.fill.threads = affordable_threads(fill.job.fill.threads);
  fill.command_line = quoted_command_line(argc, argv);
  return with_thread_budget(fill.job.fill.threads, [&] {
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
    return fail_with(error, exit_unreadable);
  } catch (const WriteError& error) {
    return say_with_files(error.what(), exit_unwritable);
  } catch (const LimitError& error) {
    return say_with_files(error.what(), exit_internal);
  } catch (const UsageError& error) {
    return fail_with(error, exit_usage);
  } catch (const InvalidArgument& error) {
    return fail_with(error, exit_usage);
  } catch (const std::bad_alloc&) {
    return say_with_files("out of memory. A smaller --density or fewer loops at once need less.", exit_internal);
  } catch (const Error& error) {
    return say_with_files(error.what(), exit_internal);
  } catch (const std::exception& error) {
    return say_with_files(std::string("internal error: ") + error.what() + ".", exit_internal);
  }
}

}  // namespace loopmend
