// SPDX-License-Identifier: GPL-3.0-or-later
// Fills the scans of a batch, several at once, each in a child process.
#pragma once

#include "ledger.h"

#include "core/cancel.h"

#include <functional>
#include <vector>

namespace loopmend {

/// What became of a scan.
struct ScanEnd {
  enum class State {
    waiting,    ///< the batch was stopped before it was done
    as_before,  ///< complete since an earlier run
    filled,     ///< mesh and report are written
    error       ///< there is neither
  } state = State::waiting;
  int code = 0;           ///< of its process; 0 where none was started
  Message why;            ///< of an error
  double seconds = 0;     ///< of the process that filled it, with reading and writing
  Message picture_fault;  ///< why there is no picture though one was asked for

  bool has_mesh() const { return state == State::as_before || state == State::filled; }
};

struct RunSettings {
  int jobs = 1;
  int threads = 1;                   ///< of each child
  std::optional<double> max_memory;  ///< of each child, MB
};

/// As many children at once as cores and memory allow for. @param scans  how many there are
RunSettings settings_of(const BatchJob& job, std::size_t scans);

/// Called on the thread that runs the batch. Each may be empty.
struct BatchEvents {
  /// Before anything is written. What it throws ends the batch.
  std::function<void(const std::vector<Scan>& scans)> listed{};
  std::function<void(std::size_t scan)> begun{};
  /// Also where nothing was to be done, or could be.
  std::function<void(std::size_t scan, const ScanEnd& end)> ended{};
  std::function<void(const Message& words)> said{};
};

/// @returns one for each scan. @throws WriteError where the folder of the results cannot be written.
std::vector<ScanEnd> run_scans(const std::vector<Scan>& scans, const BatchJob& job, Ledger& ledger,
                               const BatchEvents& events, const CancelToken& cancel);

}  // namespace loopmend
