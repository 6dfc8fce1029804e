// SPDX-License-Identifier: GPL-3.0-or-later
#include "scan_runs.h"

#include "child.h"
#include "core/error.h"
#include "core/path_text.h"
#include "core/seconds_since.h"
#include "core/system_memory.h"
#include "core/threads.h"
#include "exit_codes.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <list>
#include <system_error>
#include <thread>

namespace loopmend {

namespace {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;

constexpr auto patience = std::chrono::seconds(5);            ///< with a child that was asked to end
constexpr auto between_looks = std::chrono::milliseconds(5);  ///< at the children

/// A path that no program takes for an option.
std::string as_argument(const fs::path& path) {
  return path_text(path).starts_with("-") ? "./" + path_text(path) : path_text(path);
}

bool names(const std::vector<std::string>& options, const std::string& option) {
  return std::any_of(options.begin(), options.end(),
                     [&](const std::string& word) { return word == option || word.starts_with(option + "="); });
}

/// The last line that the child wrote, without the names of program and input; if it wrote none, how it ended.
Message reason_of(const ChildEnd& end, const fs::path& input) {
  std::string said = end.said;
  while (!said.empty() && (said.back() == '\n' || said.back() == ' ')) said.pop_back();
  const std::string name = "loopmend: ";
  if (const std::size_t line = said.rfind("\n" + name); line != std::string::npos) said.erase(0, line + 1);
  for (const std::string& known : {name, as_argument(input) + ": "})
    if (said.starts_with(known)) said.erase(0, known.size());
  std::replace(said.begin(), said.end(), '\n', ' ');
  if (!said.empty()) return verbatim(said);
  if (end.code == 128 + 9) return say("its process was killed (SIGKILL), as the system does where memory runs out");
  if (end.code > 128) return say("its process was ended by signal %1", end.code - 128);
  return say("its process ended with exit code %1", end.code);
}

class ScanRuns {
 public:
  ScanRuns(const std::vector<Scan>& scans, const BatchJob& job, Ledger& ledger, const BatchEvents& events)
      : scans_(scans),
        job_(job),
        ledger_(ledger),
        events_(events),
        settings_(settings_of(job, scans.size())),
        ends_(scans.size()) {}

  std::vector<ScanEnd> run(const CancelToken& cancel) {
    std::size_t next = 0;
    while (true) {
      while (!cancel.cancelled() && next < scans_.size() && running_.size() < static_cast<std::size_t>(settings_.jobs))
        start(next++);
      if (cancel.cancelled() && !running_.empty()) stop();
      if (running_.empty()) break;
      for (auto one = running_.begin(); one != running_.end();) {
        const auto end = one->child.end();
        if (!end) {
          ++one;
          continue;
        }
        const std::size_t scan = one->scan;
        const bool was_picture = one->is_picture;
        const auto input = one->input;
        const double seconds = seconds_since(one->since);
        one = running_.erase(one);
        if (was_picture)
          end_picture(scan, *end, cancel);
        else
          end_fill(scan, *end, input, seconds, cancel);
      }
      std::this_thread::sleep_for(between_looks);
    }
    return std::move(ends_);
  }

 private:
  struct Running {
    std::size_t scan;
    bool is_picture;
    std::optional<FileState> input;  ///< before the work
    Clock::time_point since;
    Child child;
    Running(std::size_t which, bool picture, const std::optional<FileState>& file, const fs::path& program,
            const std::vector<std::string>& words)
        : scan(which),
          is_picture(picture),
          input(file),
          since(Clock::now()),
          child(program, words) {}
  };

  ScanFiles files(std::size_t k) const { return files_of(job_.output, scans_[k].name); }

  void start(std::size_t k) {
    const Scan& scan = scans_[k];
    if (!scan.fault.empty()) return refuse(k, scan.fault);
    const auto entry = ledger_.complete(scan);
    const bool again = job_.again == BatchJob::Again::all ||
                       (job_.again == BatchJob::Again::open && entry && entry->code != exit_done);
    if (entry && !again) {
      ends_[k] = {ScanEnd::State::as_before, entry->code, {}, entry->seconds, {}};
      if (!make_picture(k)) finished(k);
      return;
    }
    if (const auto file = ledger_.foreign_file(scan.name)) {
      if (job_.existing == BatchJob::Existing::keep)
        return refuse(k, say("%1 is there, and no batch wrote it, or it has changed since: move it away, or give "
                             "--overwrite",
                             path_text(*file)));
      tell(say("%1 is overwritten, though no batch wrote it", path_text(*file)));
    }
    ledger_.begin(scan.name);
    running_.emplace_back(k, false, state_of(scan.input), job_.program, fill_words(k));
    if (events_.begun) events_.begun(k);
  }

  std::vector<std::string> fill_words(std::size_t k) const {
    const Scan& scan = scans_[k];
    const ScanFiles to = files(k);
    for (const fs::path& folder : {to.mesh.parent_path(), to.report.parent_path()}) {
      std::error_code error;
      fs::create_directories(folder, error);
      if (error) throw WriteError(folder, verbatim(error.message()), say("Choose another folder for the results."));
    }
    std::vector<std::string> words{"fill",     as_argument(scan.input), "-o",     as_argument(to.mesh),
                                   "--report", as_argument(to.report),  "--quiet"};
    if (!names(scan.options, "--threads")) words.insert(words.end(), {"--threads", std::to_string(settings_.threads)});
    if (settings_.max_memory && !names(scan.options, "--max-memory"))
      words.insert(words.end(), {"--max-memory", std::to_string(static_cast<long long>(*settings_.max_memory))});
    words.insert(words.end(), scan.options.begin(), scan.options.end());
    return words;
  }

  void end_fill(std::size_t k, const ChildEnd& end, const std::optional<FileState>& input, double seconds,
                const CancelToken& cancel) {
    ScanEnd& result = ends_[k];
    result.code = end.code;
    result.seconds = seconds;
    if (end.code == exit_done || end.code == exit_loops_failed) {
      ledger_.finish(scans_[k], input, end.code, seconds);
      result.state = ScanEnd::State::filled;
      remove(files(k).picture);
      if (cancel.cancelled() || !make_picture(k)) finished(k);
      return;
    }
    if (cancel.cancelled()) return;  // waits for the next run
    // What an earlier run made belongs to another input or to other options.
    const ScanFiles stale = files(k);
    bool removed = false;
    for (const fs::path& file : {stale.mesh, stale.report, stale.picture}) removed = remove(file) || removed;
    refuse(k, joined(reason_of(end, scans_[k].input), " ",
                     removed ? say("What an earlier run made of it was removed.") : Message()));
  }

  static bool remove(const fs::path& file) {
    std::error_code error;
    return fs::remove(file, error);
  }

  /// @returns false where none is wanted, or there is one.
  bool make_picture(std::size_t k) {
    const bool wanted = job_.pictures == BatchJob::Pictures::all ||
                        (job_.pictures == BatchJob::Pictures::open && ends_[k].code != exit_done);
    const fs::path picture = files(k).picture;
    if (!wanted || state_of(picture)) return false;
    std::error_code error;
    fs::create_directories(picture.parent_path(), error);  // a failure shows when the picture is written
    running_.emplace_back(k, true, std::nullopt, job_.program,
                          std::vector<std::string>{"render", as_argument(scans_[k].input), as_argument(files(k).mesh),
                                                   "-o", as_argument(picture), "--seams", "--size", "1200x600"});
    return true;
  }

  void end_picture(std::size_t k, const ChildEnd& end, const CancelToken& cancel) {
    if (end.code != exit_done)
      ends_[k].picture_fault =
          cancel.cancelled() ? say("the batch was stopped before it was made") : reason_of(end, scans_[k].input);
    finished(k);
  }

  void refuse(std::size_t k, const Message& why) {
    ends_[k].state = ScanEnd::State::error;
    ends_[k].why = why;
    tell(say("%1: %2", path_text(scans_[k].input), why));
    finished(k);
  }

  void finished(std::size_t k) const {
    if (events_.ended) events_.ended(k, ends_[k]);
  }

  void tell(const Message& words) const {
    if (events_.said) events_.said(words);
  }

  void stop() {
    if (!stopped_) {
      stopped_ = Clock::now();
      for (const Running& one : running_) one.child.stop();
    } else if (Clock::now() - *stopped_ > patience) {
      for (const Running& one : running_) one.child.kill();
    }
  }

  const std::vector<Scan>& scans_;
  const BatchJob& job_;
  Ledger& ledger_;
  const BatchEvents& events_;
  RunSettings settings_;
  std::vector<ScanEnd> ends_;
  std::list<Running> running_;
  std::optional<Clock::time_point> stopped_;
};

}  // namespace

RunSettings settings_of(const BatchJob& job, std::size_t scans) {
  const int cores = thread_budget();
  RunSettings settings;
  settings.jobs = static_cast<int>(std::min(scans, static_cast<std::size_t>(job.jobs > 0 ? job.jobs : cores)));
  settings.threads = std::max(1, cores / settings.jobs);
  const double memory = memory_left_mb({}) / settings.jobs;
  if (std::isfinite(memory) && settings.jobs > 1) settings.max_memory = std::max(1.0, std::floor(memory));
  return settings;
}

std::vector<ScanEnd> run_scans(const std::vector<Scan>& scans, const BatchJob& job, Ledger& ledger,
                               const BatchEvents& events, const CancelToken& cancel) {
  return ScanRuns(scans, job, ledger, events).run(cancel);
}

}  // namespace loopmend
