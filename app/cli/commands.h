// SPDX-License-Identifier: GPL-3.0-or-later
// The commands of `loopmend`: options as the person gave them, and one function each that does the work.
#pragma once

#include "export/write_scan.h"
#include "io/read_mesh.h"
#include "io/write_mesh.h"
#include "pipeline/scan_job.h"
#include "progress_line.h"
#include "scene/shading.h"
#include "usage_error.h"

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace loopmend {

struct RenderOptions;

/// What is said of the loops of a mesh with very many: counts and the largest, or each.
enum class Detail { summary, all };
inline constexpr std::size_t most_loops_in_full = 50;      ///< of more there is a summary
inline constexpr std::size_t largest_loops = 10;           ///< in a summary
inline constexpr std::size_t most_loops_in_report = 1000;  ///< with all their figures, in JSON; of others the main ones

/// Whether the output says if the surface could be printed.
enum class Check { no, printable };

struct InfoCommand {
  std::filesystem::path input;
  std::string json;  ///< file or "-"; empty: a table for people
  CoincidentVertices coincident = CoincidentVertices::keep;
  FloatText float_text = FloatText::nearest_float;
  Detail detail = Detail::summary;
  Check check = Check::no;
};

struct FillCommand {
  std::filesystem::path input;
  std::filesystem::path output;
  CoincidentVertices coincident = CoincidentVertices::keep;
  FloatText float_text = FloatText::nearest_float;
  ScanJob job;                        ///< what is done between the files
  std::string report;                 ///< file or "-"; empty: none
  std::optional<double> max_seconds;  ///< for the whole command, above 0
  enum class WhenStopped { discard, keep_finished } when_stopped = WhenStopped::discard;  ///< by a signal
  enum class Content { surface, patches } content = Content::surface;                     ///< what is written
  enum class Deviations { not_written, written } deviations = Deviations::not_written;    ///< of each new vertex
  Check check = Check::no;                                                                ///< of what is written
  WriteScanOptions write;
  Verbosity verbosity = Verbosity::normal;
  Detail detail = Detail::summary;
  std::string command_line;  ///< as typed, for the report
};

struct RenderCommand {
  std::vector<std::filesystem::path> inputs;    ///< one, or two for before and after
  std::filesystem::path output;                 ///< a picture; empty: a film
  std::filesystem::path film;                   ///< of the flow on one hole; empty: a picture
  std::string flow = "mmcvf", mode = "steady";  ///< of a film
  double sigma = 10;                            ///< of a film by steps
  double film_rate = 0, film_length = 0;        ///< of a film, as FilmPace
  std::string color = "auto";
  Seams seams = Seams::hidden;
  int width = 0, height = 0;      ///< pixels; 0: the default
  std::string view;               ///< "front", ...; empty: towards the holes
  std::optional<Vec3> direction;  ///< from the middle towards the eye
  std::optional<int> loop;        ///< the boundary loop to be framed, as 'info' numbers it
};

/// @returns an ExitCode. @throws ReadError, WriteError, UsageError, InvalidArgument.
int run_info(const InfoCommand& command);
int run_fill(const FillCommand& command);
int run_sample(const std::filesystem::path& output);
int run_render(const RenderCommand& command);
/// The part of run_render() that makes a film.
/// @param options  of its pictures
int run_film(const RenderCommand& command, RenderOptions options);

}  // namespace loopmend
