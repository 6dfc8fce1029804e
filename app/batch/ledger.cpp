// SPDX-License-Identifier: GPL-3.0-or-later
#include "ledger.h"

#include "core/path_text.h"
#include "core/version.h"
#include "usage_error.h"

#include <chrono>
#include <fstream>
#include <sstream>
#include <system_error>

namespace loopmend {

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr int ledger_version = 1;

/// Bytes that are no UTF-8, as a name may have, become the same mark everywhere.
std::string text(const Json& json) { return json.dump(-1, ' ', false, Json::error_handler_t::replace); }
std::string key_of(const std::string& name) { return text(Json(name)); }

Json json_of(const std::optional<FileState>& state) {
  return state ? Json{{"size", state->size}, {"modified", state->modified}} : Json(nullptr);
}

std::optional<FileState> file_state(const Json& json) {
  if (json.is_null()) return {};
  return FileState{json.at("size").get<std::uintmax_t>(), json.at("modified").get<std::int64_t>()};
}

/// It stays the same when input and results are moved together.
std::string seen_from(const fs::path& folder, const fs::path& input) {
  std::error_code error;
  const fs::path seen = fs::proximate(fs::weakly_canonical(input, error), fs::weakly_canonical(folder, error), error);
  return Json::parse(key_of(seen.empty() ? generic_path_text(input) : generic_path_text(seen))).get<std::string>();
}

}  // namespace

ScanFiles files_of(const fs::path& folder, const std::string& name) {
  return {folder / "filled" / path_of_text(name), folder / "reports" / path_of_text(name + ".json"),
          folder / "pictures" / path_of_text(name + ".png")};
}

ResultFiles result_files(const fs::path& folder) { return {folder / "summary.csv", folder / "summary.html"}; }

std::optional<FileState> state_of(const fs::path& path) {
  std::error_code no_size, no_time;
  const std::uintmax_t size = fs::file_size(path, no_size);
  const auto modified = std::chrono::file_clock::to_sys(fs::last_write_time(path, no_time));
  if (no_size || no_time) return {};
  return FileState{size, std::chrono::duration_cast<std::chrono::nanoseconds>(modified.time_since_epoch()).count()};
}

namespace {

fs::path made(const fs::path& folder) {
  std::error_code error;
  fs::create_directories(folder, error);
  if (error) throw WriteError(folder, verbatim(error.message()), say("Choose another folder for the results."));
  return folder;
}

}  // namespace

Ledger::Ledger(const fs::path& folder) : folder_(made(folder)), path_(folder / "batch.jsonl"), file_(path_) { read(); }

void Ledger::read() {
  std::ostringstream content;
  content << std::ifstream(path_, std::ios::binary).rdbuf();
  std::string all = content.str();
  const std::size_t whole = all.rfind('\n') == std::string::npos ? 0 : all.rfind('\n') + 1;
  std::istringstream lines(all.substr(0, whole));
  int number = 0;
  try {
    for (std::string line; std::getline(lines, line);) {
      const Json json = Json::parse(line);
      if (++number == 1) {
        if (json.at("loopmend_batch").get<int>() != ledger_version) throw std::runtime_error("another version");
      } else if (json.contains("summary")) {
        summary_is_ours_ = true;
      } else if (json.contains("begun")) {
        entries_[text(json["begun"])] = std::nullopt;
      } else {
        entries_[text(json.at("filled"))] = LedgerEntry{json.at("input").get<std::string>(),
                                                        file_state(json.at("input_file")),
                                                        file_state(json.at("mesh")),
                                                        file_state(json.at("report")),
                                                        json.at("options").get<std::vector<std::string>>(),
                                                        json.at("version").get<std::string>(),
                                                        json.at("code").get<int>(),
                                                        json.at("seconds").get<double>()};
      }
    }
  } catch (const std::exception&) {
    throw UsageError(
        say("%1, line %2: not what batch writes there: move the file away, or choose another folder for the "
            "results",
            path_text(path_), std::max(1, number)));
  }
  if (number == 0 && all.size() > 200)
    throw UsageError(say("%1 is no record of a batch: choose another folder for the results", path_text(path_)));
  if (whole < all.size()) file_.cut(whole);
  if (number == 0) append({{"loopmend_batch", ledger_version}});
}

void Ledger::append(const Json& json) { file_.append(text(json) + "\n"); }

std::optional<LedgerEntry> Ledger::complete(const Scan& scan) const {
  const auto found = entries_.find(key_of(scan.name));
  if (found == entries_.end() || !found->second) return {};
  const LedgerEntry& entry = *found->second;
  const ScanFiles files = files_of(folder_, scan.name);
  const bool is_so = entry.input == seen_from(folder_, scan.input) && entry.version == version() &&
                     text(entry.options) == text(scan.options) && entry.input_file &&
                     entry.input_file == state_of(scan.input) && entry.mesh && entry.mesh == state_of(files.mesh) &&
                     entry.report && entry.report == state_of(files.report);
  return is_so ? found->second : std::nullopt;
}

std::optional<fs::path> Ledger::foreign_file(const std::string& name) const {
  const ScanFiles files = files_of(folder_, name);
  const auto found = entries_.find(key_of(name));
  const bool begun = found != entries_.end();
  const auto is_foreign = [&](const fs::path& path, std::optional<FileState> LedgerEntry::*written) {
    const auto now = state_of(path);
    if (!now) return false;
    return !begun || (found->second && (*found->second).*written != now);
  };
  if (is_foreign(files.mesh, &LedgerEntry::mesh)) return files.mesh;
  if (is_foreign(files.report, &LedgerEntry::report)) return files.report;
  if (!begun && state_of(files.picture)) return files.picture;
  return {};
}

std::optional<fs::path> Ledger::foreign_summary() const {
  const ResultFiles files = result_files(folder_);
  for (const fs::path& path : {files.table, files.page})
    if (!summary_is_ours_ && state_of(path)) return path;
  return {};
}

void Ledger::begin(const std::string& name) {
  append({{"begun", name}});
  entries_[key_of(name)] = std::nullopt;
}

void Ledger::begin_summary() {
  if (!summary_is_ours_) append({{"summary", true}});
  summary_is_ours_ = true;
}

LedgerEntry Ledger::finish(const Scan& scan, const std::optional<FileState>& input_file, int code, double seconds) {
  const ScanFiles files = files_of(folder_, scan.name);
  LedgerEntry entry{seen_from(folder_, scan.input),
                    input_file,
                    state_of(files.mesh),
                    state_of(files.report),
                    scan.options,
                    version(),
                    code,
                    seconds};
  append({{"filled", scan.name},
          {"input", entry.input},
          {"input_file", json_of(entry.input_file)},
          {"options", entry.options},
          {"version", entry.version},
          {"code", code},
          {"seconds", seconds},
          {"mesh", json_of(entry.mesh)},
          {"report", json_of(entry.report)}});
  entries_[key_of(scan.name)] = entry;
  return entry;
}

}  // namespace loopmend
