// SPDX-License-Identifier: GPL-3.0-or-later
// Lists to choose from that more than one panel has; the values are the enumerators, as int.
#pragma once

#include <QString>

class QComboBox;

namespace loopmend {

/// The four flows, the one of highest order first.
QComboBox* make_flow_choice(const char* name, const QString& help);
/// Every BoundaryTrust, automatic first.
QComboBox* make_boundary_choice(const char* name);
/// Every SeamContinuity, curvature first.
QComboBox* make_continuity_choice(const char* name);
/// The shadings of every surface, in the order of the keys 1 to 5.
QComboBox* make_shading_choice(const char* name, const QString& help);

}  // namespace loopmend
