// SPDX-License-Identifier: GPL-3.0-or-later
#include "scan_list.h"

#include "core/path_text.h"
#include "io/read_mesh.h"
#include "io/text_cursor.h"
#include "usage_error.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <fstream>
#include <map>
#include <system_error>

namespace loopmend {

namespace {

namespace fs = std::filesystem;

/// A scan that is to be named.
struct Found {
  fs::path input;
  fs::path base;       ///< folder that it was found in, or below
  std::string output;  ///< as a manifest names it; empty: by its place
  std::vector<std::string> options;
  Message fault;
};

/// From the root on, without a slash at its end, whatever there is. "" is the present folder.
fs::path absolute_place(const fs::path& path) {
  const fs::path there = (fs::current_path() / path).lexically_normal();
  return there.has_filename() ? there : there.parent_path();
}

/// The same with symbolic links followed.
fs::path plain(const fs::path& path) {
  std::error_code error;
  const fs::path there = fs::weakly_canonical(absolute_place(path), error);
  return error ? absolute_place(path) : there;
}

bool is_within(const fs::path& path, const fs::path& folder) {
  return std::mismatch(folder.begin(), folder.end(), path.begin(), path.end()).first == folder.end();
}

/// The meshes of a folder and of those in it, by their names. Names with a point in front are left, and so are linked folders.
void walk(const fs::path& folder, const fs::path& base, const fs::path& results, std::vector<Found>& found) {
  std::error_code error;
  std::vector<fs::path> files, folders;
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error)) {
    std::error_code gone;
    if (path_text(entry->path().filename()).starts_with(".")) continue;
    if (entry->is_directory(gone)) {
      if (!entry->is_symlink(gone) && plain(entry->path()) != results) folders.push_back(entry->path());
    } else if (is_mesh_name(entry->path())) {
      files.push_back(entry->path());
    }
  }
  if (error) found.push_back({folder, base, {}, {}, say("the folder cannot be read: %1", error.message())});
  std::sort(files.begin(), files.end());
  std::sort(folders.begin(), folders.end());
  for (const fs::path& file : files) found.push_back({file, base, {}, {}, {}});
  for (const fs::path& next : folders) walk(next, base, results, found);
}

/// @throws UsageError, without the place.
Found manifest_entry(const std::string& line, const fs::path& folder) {
  const auto json = nlohmann::json::parse(line, nullptr, false);
  if (!json.is_object() || !json.contains("input") || !json["input"].is_string())
    throw UsageError("is no object with an \"input\", such as {\"input\": \"a.ply\", \"options\": [\"--stitch\"]}");
  Found found;
  for (const auto& [key, value] : json.items()) {
    if (key == "options") {
      if (!value.is_array() ||
          !std::all_of(value.begin(), value.end(), [](const auto& word) { return word.is_string(); }))
        throw UsageError("\"options\" takes an array of texts, such as [\"--loops\", \"2,3\"]");
      found.options = value.template get<std::vector<std::string>>();
    } else if ((key == "input" || key == "output") && value.is_string()) {
      (key == "input" ? found.input : found.base) = path_of_text(value.template get<std::string>());
    } else {
      throw UsageError("\"" + key + "\" is not one of input, output, options, or is no text");
    }
  }
  found.output = generic_path_text(found.base);
  const fs::path output = found.base.lexically_normal();
  if (!found.output.empty() &&
      (output.has_root_path() || !output.has_filename() || *output.begin() == ".." || output == "."))
    throw UsageError("\"output\" takes the name of a file within the folder of the results, not \"" + found.output +
                     "\"");
  if (!found.output.empty()) found.output = generic_path_text(output);
  found.input = folder / found.input;
  found.base = found.input.parent_path();
  return found;
}

void read_manifest(const fs::path& path, std::vector<Found>& found) {
  std::ifstream file(path);
  std::string line;
  int number = 0;
  try {
    while (std::getline(file, line)) {
      ++number;
      if (line.find_first_not_of(" \t\r") != std::string::npos)
        found.push_back(manifest_entry(line, path.parent_path()));
    }
  } catch (const UsageError& error) {
    throw UsageError(path_text(path) + ", line " + std::to_string(number) + ": " + error.what());
  }
  if (!file.eof()) throw UsageError(path_text(path) + ": the manifest cannot be read");
}

std::vector<Found> find_scans(const BatchJob& job) {
  const fs::path results = plain(job.output);
  std::vector<Found> found;
  for (const fs::path& input : job.inputs) {
    std::error_code error;
    const std::size_t before = found.size();
    if (fs::is_directory(input, error)) {
      if (!is_within(plain(input), results)) walk(input, input, results, found);
    } else if (equals_ignoring_case(path_text(input.extension()), ".jsonl")) {
      read_manifest(input, found);
    } else if (input.extension().empty() && !fs::exists(input, error)) {
      throw UsageError(say("there is no folder %1", path_text(input)));
    } else {
      found.push_back({input, input.parent_path(), {}, {}, {}});
    }
    if (found.size() > before) continue;
    if (fs::is_directory(input, error) && is_within(plain(input), results))
      throw UsageError(say("the results would go among the scans of %1; choose another folder", path_text(input)));
    throw UsageError(say("there is no scan in %1", path_text(input)));
  }
  for (const Found& scan : found)
    if (is_within(plain(scan.input), results))
      throw UsageError(say("%1 lies in the folder of the results, %2: choose another folder for the results",
                           path_text(scan.input), path_text(job.output)));
  return found;
}

/// The deepest folder that holds all of them.
fs::path common_folder(const std::vector<Found>& found) {
  fs::path common = absolute_place(found.front().base);
  for (const Found& scan : found) {
    fs::path shared;
    const fs::path base = absolute_place(scan.base);
    for (auto a = common.begin(), b = base.begin(); a != common.end() && b != base.end() && *a == *b; ++a, ++b)
      shared /= *a;
    common = shared;
  }
  return common;
}

std::string name_of(const Found& scan, const fs::path& common, const std::string& format) {
  if (!scan.output.empty()) return scan.output;
  const std::string name = generic_path_text(absolute_place(scan.input).lexically_relative(common));
  const bool as_it_is = format.empty() || equals_ignoring_case(path_text(scan.input.extension()), "." + format);
  return as_it_is ? name : name + "." + format;
}

}  // namespace

std::vector<Scan> list_scans(const BatchJob& job) {
  const std::vector<Found> found = find_scans(job);
  const std::vector<std::string> options = job.options_of_all();
  const fs::path common = common_folder(found);
  std::map<std::string, std::size_t> known;
  std::vector<Scan> scans;
  for (const Found& one : found) {
    Scan scan{one.input, name_of(one, common, job.format), options, one.fault};
    scan.options.insert(scan.options.end(), one.options.begin(), one.options.end());
    const auto [entry, is_new] = known.try_emplace(scan.name, scans.size());
    if (is_new) {
      scans.push_back(std::move(scan));
      continue;
    }
    const Scan& other = scans[entry->second];
    if (plain(other.input) != plain(scan.input) || other.options != scan.options)
      throw UsageError(say("the outputs of %1 and of %2 would both be %3: name them in a manifest",
                           path_text(other.input), path_text(scan.input), scan.name));
  }
  return scans;
}

}  // namespace loopmend
