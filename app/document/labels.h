// SPDX-License-Identifier: GPL-3.0-or-later
// What things are called on the screen.
#pragma once

#include "document/document.h"
#include "repair/watertight.h"

#include <QString>

namespace loopmend::labels {

QString kind(LoopKind kind);
QString kind_help(LoopKind kind);
QString state(HoleState state);
QString state_help(HoleState state);
/// The smaller, the sooner a person should look at it.
int urgency(HoleState state);
/// How the table names a hole: "good" where its patch has that verdict, its kind where it is left out, else the state.
QString verdict_or_state(const Document& document, int loop);
/// The words of `loopmend fill --loops N:flat`, in the person's language.
QString shape(SeamContinuity shape);
QString shape_help(SeamContinuity shape);
QString flow(FlowKind flow);
QString flow_name(FlowKind flow);
QString flow_help(FlowKind flow);

/// 12,345: with a separator that suits the language.
QString count(std::size_t n);

/// The text with its first letter large.
QString sentence(QString text);

/// Three digits: 0.123, 12.3, 1230, 1.20·10⁻⁵.
QString number(double value);

/// "mm"; empty where the unit is not known. @param unit  of length_unit.h
QString unit_symbol(const std::string& unit);
/// "millimetres", "not known".
QString unit_name(const std::string& unit);
/// A length of the scene with its unit, where that is known.
QString length(const Document& document, double value);

/// With one decimal place, without a unit.
QString seconds(qint64 milliseconds);
/// "about 12 s left"; empty where less than a second is.
QString time_left(double seconds);

/// One sentence on how the patch meets the scan at a loop.
QString seam_sentence(const SeamReport& before, const SeamReport& now, PatchStatus stage, Grade grade);

/// "a crease of 50° along 12 edges of the seam"
QString notice(const Notice& notice);
/// The first finding of the verdict as a sentence; empty where it is good.
QString sentence_of(const Verdict& verdict);
/// How far the patch is likely from what was there, mesh units; empty without an estimate.
QString deviation_sentence(const ExpectedDeviation& deviation);

/// "3", or "3 of bunny.ply" when several scans are open.
QString hole_name(const Document& document, int loop);

/// "rough": what the neighborhood of a hole are.
QString neighborhood(NeighborhoodKind kind);
/// How far they can be trusted, in sentences: their scatter, and the uncertainty of what the patch takes from them.
QString boundary_help(const BoundarySummary& boundary);

/// "hole 3", "holes 1, 2 and 5", "12 holes".
QString holes(const Document& document, const std::set<int>& loops);

/// What the reader found and repaired, in one or two sentences; the first gives the counts.
QString import_summary(const OpenedScan& scan);

/// "Watertight, ready to print", or what stands against it, most important first.
QString verdict(const Watertightness& surface);
/// With everything that stands against it.
QString verdict_in_full(const Watertightness& surface);
/// All that stands against it, pieces and volume, in lines.
QString verdict_help(const Watertightness& surface);

/// "normals (9,992), materials (3)".
QString not_kept(const std::vector<NotKept>& list);

}  // namespace loopmend::labels
