// SPDX-License-Identifier: GPL-3.0-or-later
#include "batch_command.h"

#include "cli/number_range.h"

#include "cli/option_parser.h"

#include <map>

namespace loopmend {

namespace {

/// An option that takes one of some words.
template <class Value>
void add_choice(CLI::App& app, const std::string& option, Value& value, const std::map<std::string, Value>& words,
                const std::string& standard, const std::string& help) {
  std::vector<std::string> names;
  for (const auto& [name, meaning] : words) names.push_back(name);
  app.add_option_function<std::string>(
         option, [&value, words](const std::string& word) { value = words.at(word); }, help)
      ->check(CLI::IsMember(names))
      ->default_str(standard);
}

}  // namespace

void add_batch(CLI::App& app, BatchCommand& command) {
  CLI::App* batch = app.add_subcommand("batch", "Fill many scans, several at once, with one summary");
  batch->add_option("IN", command.inputs, "Scans, folders of scans, manifests (.jsonl)")->required();
  batch->add_option("-o,--output", command.output, "Folder to write to; made if need be")->type_name("DIR")->required();
  batch->add_option("--jobs", command.jobs, "Scans worked on at once; 0: one for each core")
      ->check(between(0, 1024))
      ->capture_default_str();
  batch->add_option("--format", command.format, "Format of the outputs (default: that of each input)")
      ->check(CLI::IsMember({"ply", "stl", "obj", "off", "glb", "gltf", "3mf", "vtp", "vtk"}));
  using Pictures = BatchCommand::Pictures;
  add_choice<Pictures>(*batch, "--pictures", command.pictures,
                       {{"none", Pictures::none}, {"open", Pictures::open}, {"all", Pictures::all}}, "all",
                       "Pictures before and after: of all scans, of those to look at, or none");
  using FailOn = BatchCommand::FailOn;
  add_choice<FailOn>(*batch, "--fail-on", command.fail_on,
                     {{"never", FailOn::never}, {"error", FailOn::error}, {"open", FailOn::open}}, "error",
                     "Exit code 1: never, where a scan has no output, or also where one is to be looked at");
  using Again = BatchCommand::Again;
  add_choice<Again>(*batch, "--again", command.again,
                    {{"none", Again::none}, {"open", Again::open}, {"all", Again::all}}, "none",
                    "Complete scans that are filled once more: none, those to look at, or all");
  batch->add_flag_callback(
      "--overwrite", [&command] { command.existing = BatchCommand::Existing::overwrite; },
      "Replace files in DIR that no batch wrote, or that have changed since");
  batch->add_flag_callback(
      "--no-auto", [&command] { command.prepare = BatchCommand::Prepare::as_asked; },
      "Fill scans as they are; without it each is stitched, repaired and trimmed where it needs that (fill --auto)");
  batch->add_flag_callback(
      "--quiet", [&command] { command.verbosity = Verbosity::quiet; },
      "No progress and no summary, only error messages");
  batch->footer(
      "Options behind -- are those of 'loopmend fill', for every scan.\n"
      "Written: filled/, reports/, pictures/, summary.csv and summary.html; batch.jsonl, by which the next run with "
      "the\n"
      "same folder skips what is complete: same input, options and version.\n"
      "A manifest has one object a line: {\"input\": \"a.ply\", \"output\": \"b.stl\", \"options\": [\"--stitch\"]}.\n"
      "Examples:\n"
      "  loopmend batch scans -o results\n"
      "  loopmend batch scans -o results --jobs 4 -- --max-time 60 --stitch\n"
      "Exit codes: 0 done; 1 some scans went wrong (--fail-on); 2 wrong usage; 4 DIR unwritable; 128 + signal: "
      "stopped.");
}

}  // namespace loopmend
