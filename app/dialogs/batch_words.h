// SPDX-License-Identifier: GPL-3.0-or-later
// What became of the scans of a folder, in words and signs.
#pragma once

#include "batch/summary.h"
#include "document/document.h"

#include <QIcon>
#include <QString>
#include <QStringList>

namespace loopmend {

/// The sign that the table of holes has.
QIcon sign_icon(HoleState state);

namespace labels {

/// "filled", "to look at".
QString status_of(const SummaryRow& row);
/// Of the worst that it has.
HoleState sign_of(const SummaryRow& row);
/// What is said of the scan: reasons by their codes, shorter than in the report and without options of the command line.
QStringList remarks_on(const SummaryRow& row);
/// Counts of scans and of patches.
QString summary_of(const std::vector<SummaryRow>& rows);

}  // namespace labels
}  // namespace loopmend
