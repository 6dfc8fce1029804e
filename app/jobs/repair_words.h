// SPDX-License-Identifier: GPL-3.0-or-later
// Names of the repairs, of the one at work, and of those done.
#pragma once

#include "repair/repair_surface.h"

#include <QString>
#include <QStringList>

namespace loopmend {

enum class ScanRepair;

QString repair_title(ScanRepair what);
/// "Repairing the scan: cutting out faces that intersect others (4 of 6)"
QString repair_step(const QString& title, const RepairStep& step);
/// "12 vertices joined"
QStringList list_of(const RepairCounts& counts);
/// What overlaps still, and the next thing to do; empty: nothing.
QString bodies_left(const UnionCounts& united);
/// The notice where no scan had anything to repair.
QString nothing_to_repair(ScanRepair what);

}  // namespace loopmend
