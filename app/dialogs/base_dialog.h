// SPDX-License-Identifier: GPL-3.0-or-later
// Asks how far below a surface its base lies.
#pragma once

#include "jobs/fill_controller.h"

class QWidget;

namespace loopmend {

/// Builds a base under the loop once a person has said its distance. @param loop  of the document
void ask_base(int loop, const Document& document, FillController& controller, QWidget* over);

}  // namespace loopmend
