// SPDX-License-Identifier: GPL-3.0-or-later
// A report of the holes as a file, off the window's thread.
#pragma once

#include "core/cancel.h"
#include "document/fill_report.h"

#include <filesystem>

namespace loopmend {

/// HTML with its pictures within, or PDF where the name ends in .pdf. @throws WriteError; then no file is left.
/// @returns whether it was written: not when cancelled
bool write_report(const std::filesystem::path& path, const FillReport& report, const CancelToken& cancel);

}  // namespace loopmend
