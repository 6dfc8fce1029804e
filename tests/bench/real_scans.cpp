// SPDX-License-Identifier: GPL-3.0-or-later
// loopmend_real_scans: `loopmend fill` with default options on every scan of some folders; what was filled, and whether the
// output is clean, judged from the file alone.
#include "io/read_mesh.h"
#include "output_check.h"
#include "table.h"

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <sys/resource.h>
#include <sys/wait.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <map>
#include <set>

namespace {

using namespace loopmend;
using namespace loopmend::bench;
namespace fs = std::filesystem;

struct Arguments {
  std::string program, work = "/tmp/loopmend_real_scans", options, markdown, peer;
  std::vector<std::string> folders;
  int time_limit = 300;
  bool verbose = false;
};

std::vector<fs::path> scans_in(const std::vector<std::string>& folders) {
  const std::set<std::string> formats{".ply", ".obj", ".off", ".stl"};
  std::vector<fs::path> scans;
  for (const std::string& folder : folders) {
    if (fs::is_regular_file(folder)) scans.emplace_back(folder);
    if (!fs::is_directory(folder)) continue;
    for (const auto& entry : fs::directory_iterator(folder))
      if (formats.contains(entry.path().extension().string())) scans.push_back(entry.path());
  }
  std::sort(scans.begin(), scans.end());
  return scans;
}

struct Row {
  std::string scan, ending;
  int loops = 0, filled = 0, failed = 0, left = 0, parts = 0, clean = 0, crossings = 0, defects = 0;
  double seconds = 0;
};

std::string in_quotes(const fs::path& path) { return "'" + path.string() + "'"; }

/// Of all commands that have ended. Other work on the machine matters less for it than for the time that passes.
double processor_seconds() {
  rusage used{};
  ::getrusage(RUSAGE_CHILDREN, &used);
  const auto seconds = [](const timeval& t) {
    return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
  };
  return seconds(used.ru_utime) + seconds(used.ru_stime);
}

/// "exit 0", "time limit", "crash": what became of the command.
std::string run(const std::string& command, int time_limit, double& seconds) {
  const double start = processor_seconds();
  const int status = std::system(("timeout " + std::to_string(time_limit) + " " + command).c_str());
  seconds = processor_seconds() - start;
  if (!WIFEXITED(status)) return "crash";
  const int code = WEXITSTATUS(status);
  if (code == 124) return "time limit";
  return code > 128 ? "crash" : "exit " + std::to_string(code);
}

void count_loops(const fs::path& report, Row& row, bool verbose) {
  std::ifstream file(report);
  if (!file) return;
  const nlohmann::json json = nlohmann::json::parse(file);
  for (const auto& loop : json.at("loops")) {
    ++row.loops;
    const std::string status = loop.at("status");
    const bool failed = status == "failed" || status == "invalid", left = status == "skipped";
    row.failed += failed;
    row.left += left;
    row.filled += !failed && !left;
    if (verbose && (failed || left))
      std::printf("  %s loop %d, %d edges, %s: %s: %s\n", row.scan.c_str(), loop.at("number").get<int>(),
                  loop.at("edges").get<int>(), loop.at("kind").get<std::string>().c_str(), status.c_str(),
                  loop.at("message").get<std::string>().c_str());
  }
}

using Place = std::array<float, 3>;

Place place_of(const Vec3& p) {
  return {static_cast<float>(p.x()), static_cast<float>(p.y()), static_cast<float>(p.z())};
}

/// What a peer wrote as the input with the new triangles behind it: other programs number again and round to single precision.
/// The input is rounded likewise, and loses what the peer changed: triangles beside the hole that it split or flipped.
TriangleSoup as_appended(TriangleSoup& input, const TriangleSoup& output) {
  std::map<Place, int> number;
  for (Vec3& p : input.points) {
    const Place place = place_of(p);
    p = Vec3(place[0], place[1], place[2]);
  }
  for (std::size_t v = 0; v < input.points.size(); ++v) number.emplace(place_of(input.points[v]), static_cast<int>(v));
  const auto key = [&](const TriangleSoup& soup, const Triangle& t) {
    std::array<Place, 3> places{place_of(soup.points[t[0]]), place_of(soup.points[t[1]]), place_of(soup.points[t[2]])};
    std::sort(places.begin(), places.end());
    return places;
  };
  std::set<std::array<Place, 3>> known, written;
  for (const Triangle& t : output.triangles) written.insert(key(output, t));
  std::erase_if(input.triangles, [&](const Triangle& t) { return !written.contains(key(input, t)); });
  for (const Triangle& t : input.triangles) known.insert(key(input, t));
  TriangleSoup all = input;
  for (const Triangle& t : output.triangles) {
    if (known.contains(key(output, t))) continue;
    Triangle added;
    for (int k = 0; k < 3; ++k) {
      const auto [entry, is_new] = number.emplace(place_of(output.points[t[k]]), static_cast<int>(all.points.size()));
      if (is_new) all.points.push_back(output.points[t[k]]);
      added[k] = entry->second;
    }
    all.triangles.push_back(added);
  }
  return all;
}

enum class Filler { loopmend, peer };

void count_parts(const fs::path& scan, const fs::path& output, Row& row, Filler filler, bool verbose) {
  if (!fs::exists(output)) return;
  TriangleSoup input = read_mesh(scan).soup, filled = read_mesh(output).soup;
  if (filler == Filler::peer) filled = as_appended(input, filled);
  const OutputCheck check = check_output(input, filled);
  if (!check.exterior_kept) row.ending += ", exterior changed";
  for (const FilledPart& part : check.parts) {
    ++row.parts;
    row.clean += part.is_clean();
    row.crossings += part.crossings;
    if (verbose && !part.is_clean())
      std::printf(
          "  %s: part of %d triangles: %d open, %d crowded, %d crossings, %d folds (and %d forced), area %.2f\n",
          row.scan.c_str(), part.triangles, part.open_edges, part.crowded_edges, part.crossings, part.folds,
          part.forced_folds, part.area_ratio);
  }
}

Row measured(const fs::path& scan, const Arguments& arguments, Filler filler) {
  Row row;
  row.scan = scan.filename().string();
  const fs::path output = fs::path(arguments.work) / (row.scan + ".ply"), report = output.string() + ".json";
  fs::remove(output);
  fs::remove(report);
  const std::string files = " " + in_quotes(scan) + " -o " + in_quotes(output) + " --report " + in_quotes(report);
  const std::string command = filler == Filler::loopmend
                                  ? in_quotes(arguments.program) + " fill" + files + " --quiet " + arguments.options
                                  : arguments.peer + " " + in_quotes(scan) + " " + in_quotes(output);
  row.ending = run(command + " > " + in_quotes(output.string() + ".log") + " 2>&1", arguments.time_limit, row.seconds);
  count_loops(report, row, arguments.verbose);
  count_parts(scan, output, row, filler, arguments.verbose);
  return row;
}

void add(Row& sum, const Row& row) {
  sum.loops += row.loops, sum.filled += row.filled, sum.failed += row.failed, sum.left += row.left;
  sum.parts += row.parts, sum.clean += row.clean, sum.crossings += row.crossings;
  sum.seconds += row.seconds;
}

std::vector<std::string> cells(const Row& ours, const Row& theirs, bool with_peer) {
  std::vector<std::string> all{ours.scan,           number(ours.loops), number(ours.filled),    number(ours.left),
                               number(ours.failed), number(ours.clean), number(ours.crossings), number(ours.seconds)};
  if (with_peer)
    for (const std::string& cell :
         {number(theirs.parts), number(theirs.clean), number(theirs.crossings), number(theirs.seconds)})
      all.push_back(cell);
  return all;
}

/// The same scans by the peer, too, where there is one.
Table measure_all(const Arguments& arguments) {
  const bool with_peer = !arguments.peer.empty();
  std::vector<std::string> columns{"scan", "loops", "filled", "left", "failed", "clean", "crossings", "s"};
  if (with_peer) columns.insert(columns.end(), {"peer: patches", "clean", "crossings", "s"});
  Table table(columns);
  Row ours_in_all, theirs_in_all;
  ours_in_all.scan = "all";
  for (const fs::path& scan : scans_in(arguments.folders)) {
    const Row ours = measured(scan, arguments, Filler::loopmend);
    const Row theirs = with_peer ? measured(scan, arguments, Filler::peer) : Row();
    table.add(cells(ours, theirs, with_peer));
    add(ours_in_all, ours);
    add(theirs_in_all, theirs);
    std::fprintf(stderr, "%-24s %s; %d parts, of these %d clean; %s\n", ours.scan.c_str(), ours.ending.c_str(),
                 ours.parts, ours.clean, theirs.ending.c_str());
  }
  table.add(cells(ours_in_all, theirs_in_all, with_peer));
  return table;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("fills the holes of every scan in some folders and judges the files that come out");
  Arguments arguments;
  app.add_option("folders", arguments.folders, "folders with scans, or single files")->required();
  app.add_option("--program", arguments.program, "the loopmend to measure")->required();
  app.add_option("--options", arguments.options, "further options for it");
  app.add_option("--peer", arguments.peer, "another program beside it: called with the input and the output (PLY)");
  app.add_option("--work", arguments.work, "where the output goes");
  app.add_option("--time-limit", arguments.time_limit, "seconds for each scan");
  app.add_option("--markdown", arguments.markdown, "writes the table to this file");
  app.add_flag("--verbose", arguments.verbose, "a line for each loop left and each part that is not clean");
  CLI11_PARSE(app, argc, argv);
  fs::create_directories(arguments.work);
  const Table table = measure_all(arguments);
  std::printf("%s", table.markdown().c_str());
  write_text(arguments.markdown, table.markdown());
  return 0;
}
