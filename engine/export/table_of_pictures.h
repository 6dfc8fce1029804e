// SPDX-License-Identifier: GPL-3.0-or-later
// Pictures that PLY and OBJ name in files beside the scan, as materials that glTF has in its own file.
#pragma once

#include "core/message.h"
#include "mesh/scan_attributes.h"

#include <memory>
#include <vector>

namespace loopmend {

/// The attributes with a MaterialTable: of OBJ a material for each name, of PLY one for each picture, each with its colour and
/// its picture. Null where the scan names no picture, or has a table already.
/// @param problems  sentences are added: pictures that glTF cannot hold, and material files that cannot be read
std::shared_ptr<const ScanAttributes> with_table_of_pictures(const ScanAttributes& scan,
                                                             std::vector<Message>& problems);

}  // namespace loopmend
