// SPDX-License-Identifier: GPL-3.0-or-later
// What the window says about one hole: what was found, what can be done, how the seam is.
#pragma once

#include <QString>

namespace loopmend {

class Document;
struct Verdict;

namespace labels {

/// What a person can do about the first finding, by the names of the window; empty where there is nothing to do.
QString advice(const Verdict& verdict);
/// For a filled hole the first finding, the advice, the likely error and the seam; else its state and why.
QString verdict_text(const Document& document, int loop);
/// The seam of a filled hole, and its likely error; empty where they were not measured.
QString seam_text(const Document& document, int loop);

}  // namespace labels
}  // namespace loopmend
