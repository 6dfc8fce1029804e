// What things are called on the screen.
#pragma once

#include "document/document.h"

#include <QString>

namespace loopmend::words {

QString kind(LoopKind kind);
QString kind_help(LoopKind kind);
QString state(HoleState state);
QString state_help(HoleState state);
QString flow(FlowKind flow);
QString flow_name(FlowKind flow);
QString flow_help(FlowKind flow);

/// Three digits: 0.123, 12.3, 1230, 1.20e-05.
QString number(double value);

/// One sentence on how the patch meets the scan at a loop.
QString seam_sentence(const SeamReport& before, const SeamReport& now, PatchStage stage);

/// "Hole 3", "Holes 1, 2 and 5", "12 holes".
QString holes(const Document& document, const std::set<int>& loops);

/// What the reader met and mended, in one or two sentences; the first gives the counts.
QString import_summary(const OpenedScan& scan);

}  // namespace loopmend::words
