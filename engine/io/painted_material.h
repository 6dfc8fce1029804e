// SPDX-License-Identifier: GPL-3.0-or-later
// A material for what was painted onto the patches of a glTF scan.
#pragma once

#include "mesh/material_table.h"

#include <string>

namespace loopmend {

/// A further material with a picture of its own, otherwise like `like` (−1: none) without its pictures. @returns its number
int add_painted_material(MaterialTable& table, const std::string& name, int like, std::string png);

}  // namespace loopmend
