// SPDX-License-Identifier: GPL-3.0-or-later
// Fills the scans of a batch, several at once, each in a child process.
#pragma once

#include "ledger.h"

#include "core/cancel.h"

#include <string>
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
  int code = 0;               ///< of its process; 0 where none was started
  std::string why;            ///< of an error
  double seconds = 0;         ///< of the process that filled it, with reading and writing
  std::string picture_fault;  ///< why there is no picture though one was asked for

  bool has_mesh() const { return state == State::as_before || state == State::filled; }
};

struct RunSettings {
  int jobs = 1;
  int threads = 1;                   ///< of each child
  std::optional<double> max_memory;  ///< of each child, MB
};

/// As many children at once as cores and memory allow for. @param scans  how many there are
RunSettings settings_of(const BatchCommand& command, std::size_t scans);

/// @returns one for each scan. @throws WriteError where the folder of the results cannot be written.
std::vector<ScanEnd> fill_scans(const std::vector<Scan>& scans, const BatchCommand& command, Ledger& ledger,
                                const CancelToken& cancel);

}  // namespace loopmend
