// SPDX-License-Identifier: GPL-3.0-or-later
// loopmend_real_scans: `loopmend fill` with default options on every scan of some folders; what was filled, and whether the
// output is clean, judged from the file alone.
#include "io/read_mesh.h"
#include "output_check.h"
#include "table.h"

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <sys/wait.h>

#include <algorithm>
#include <array>
#include <chrono>
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
  double seconds = 0, slowest = 0;
};

std::string in_quotes(const fs::path& path) { return "'" + path.string() + "'"; }

/// "exit 0", "time limit", "crash": what became of the command.
std::string run(const std::string& command, int time_limit, double& seconds) {
  const auto start = std::chrono::steady_clock::now();
  const int status = std::system(("timeout " + std::to_string(time_limit) + " " + command).c_str());
  seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
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
    if (loop.contains("seconds")) row.slowest = std::max(row.slowest, loop["seconds"].at("total").get<double>());
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

void count_parts(const fs::path& scan, const fs::path& output, Row& row, const Arguments& arguments) {
  const bool verbose = arguments.verbose;
  if (!fs::exists(output)) return;
  TriangleSoup input = read_mesh(scan).soup, filled = read_mesh(output).soup;
  if (!arguments.peer.empty()) filled = as_appended(input, filled);
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

Row measured(const fs::path& scan, const Arguments& arguments) {
  Row row;
  row.scan = scan.filename().string();
  const fs::path output = fs::path(arguments.work) / (row.scan + ".ply"), report = output.string() + ".json";
  fs::remove(output);
  fs::remove(report);
  const std::string command = arguments.peer.empty() ? in_quotes(arguments.program) + " fill " + in_quotes(scan) +
                                                           " -o " + in_quotes(output) + " --report " +
                                                           in_quotes(report) + " --quiet " + arguments.options
                                                     : arguments.peer + " " + in_quotes(scan) + " " + in_quotes(output);
  row.ending = run(command + " > " + in_quotes(output.string() + ".log") + " 2>&1", arguments.time_limit, row.seconds);
  count_loops(report, row, arguments.verbose);
  count_parts(scan, output, row, arguments);
  return row;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App app("fills the holes of every scan in some folders and judges the files that come out");
  Arguments arguments;
  app.add_option("folders", arguments.folders, "folders with scans, or single files")->required();
  app.add_option("--program", arguments.program, "the loopmend to measure");
  app.add_option("--options", arguments.options, "further options for it");
  app.add_option("--peer", arguments.peer, "another program instead: called with the input and the output (PLY)");
  app.add_option("--work", arguments.work, "where its output goes");
  app.add_option("--time-limit", arguments.time_limit, "seconds for each scan");
  app.add_option("--markdown", arguments.markdown, "writes the table to this file");
  app.add_flag("--verbose", arguments.verbose, "a line for each loop left and each part that is not clean");
  CLI11_PARSE(app, argc, argv);
  fs::create_directories(arguments.work);

  const std::vector<std::string> columns{"scan",  "loops",     "filled", "failed",  "left",  "parts",
                                         "clean", "crossings", "s",      "slowest", "ending"};
  Table table(columns);
  Row sum;
  sum.scan = "all";
  const auto add = [&](const Row& row) {
    table.add({row.scan, number(row.loops), number(row.filled), number(row.failed), number(row.left), number(row.parts),
               number(row.clean), number(row.crossings), number(row.seconds), number(row.slowest), row.ending});
  };
  for (const fs::path& scan : scans_in(arguments.folders)) {
    const Row row = measured(scan, arguments);
    add(row);
    sum.loops += row.loops, sum.filled += row.filled, sum.failed += row.failed, sum.left += row.left;
    sum.parts += row.parts, sum.clean += row.clean, sum.crossings += row.crossings;
    sum.seconds += row.seconds;
    sum.slowest = std::max(sum.slowest, row.slowest);
    std::printf("%-24s %4d loops, %4d filled, %3d failed, %3d left; %4d parts, %4d clean, %d crossings; %.2f s, %s\n",
                row.scan.c_str(), row.loops, row.filled, row.failed, row.left, row.parts, row.clean, row.crossings,
                row.seconds, row.ending.c_str());
    std::fflush(stdout);
  }
  add(sum);
  std::printf("%s", table.markdown().c_str());
  write_text(arguments.markdown, table.markdown());
  return 0;
}
