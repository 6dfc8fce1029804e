// SPDX-License-Identifier: GPL-3.0-or-later
#include "batch_command.h"

#include "cli/option_parser.h"

#include <array>

namespace loopmend {

namespace {

using Pictures = BatchJob::Pictures;
using FailOn = BatchCommand::FailOn;
using Again = BatchJob::Again;

constexpr std::array<Named<Pictures>, 3> pictures_names{
    {{"all", Pictures::all}, {"none", Pictures::none}, {"open", Pictures::open}}};
constexpr std::array<Named<FailOn>, 3> fail_on_names{
    {{"error", FailOn::error}, {"never", FailOn::never}, {"open", FailOn::open}}};
constexpr std::array<Named<Again>, 3> again_names{{{"all", Again::all}, {"none", Again::none}, {"open", Again::open}}};

}  // namespace

void add_batch(CLI::App& app, BatchCommand& command) {
  BatchJob& job = command.job;
  CLI::App* batch = app.add_subcommand("batch", "Fill many scans, several at once, with one summary");
  batch->add_option("IN", job.inputs, "Scans, folders of scans, manifests (.jsonl)")->required();
  batch->add_option("-o,--output", job.output, "Folder to write to; made if need be")->type_name("DIR")->required();
  batch->add_option("--jobs", job.jobs, "Scans worked on at once; 0: one for each core")
      ->check(between(0, 1024))
      ->capture_default_str();
  batch->add_option("--format", job.format, "Format of the outputs (default: that of each input)")
      ->check(CLI::IsMember({"ply", "stl", "obj", "off", "glb", "gltf", "3mf", "vtp", "vtk"}));
  add_named(*batch, "--pictures", job.pictures, pictures_names,
            "Pictures before and after: of all scans, of those left open, or none");
  add_named(*batch, "--fail-on", command.fail_on, fail_on_names,
            "Exit code 1: never, where a scan has no output, or also where one is left open");
  add_named(*batch, "--again", job.again, again_names,
            "Complete scans that are filled once more: none, those left open, or all");
  batch->add_flag_callback(
      "--overwrite", [&job] { job.existing = BatchJob::Existing::overwrite; },
      "Replace files in DIR that no batch wrote, or that have changed since");
  batch->add_flag_callback(
      "--no-auto", [&job] { job.prepare = BatchJob::Prepare::as_asked; },
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
