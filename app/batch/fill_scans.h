// SPDX-License-Identifier: GPL-3.0-or-later
// Fills many scans, several at once, each by a `loopmend fill` of its own, and writes one summary. `loopmend batch` and the
// window both call this.
#pragma once

#include "scan_runs.h"
#include "summary.h"

namespace loopmend {

/// Cancelled, it stops the scans that are being filled, and writes the summary of those that are done.
/// @returns one row for each scan. @throws UsageError, WriteError, Error.
std::vector<SummaryRow> fill_scans(const BatchJob& job, const BatchEvents& events, const CancelToken& cancel);

}  // namespace loopmend
