// SPDX-License-Identifier: GPL-3.0-or-later
// Whether a surface could be printed, as `--check` reports it.
#pragma once

#include "repair/watertight.h"

#include <nlohmann/json.hpp>

#include <cstdio>

namespace loopmend {

nlohmann::ordered_json verdict_json(const Watertightness& surface);
void print_verdict(std::FILE* out, const Watertightness& surface);

}  // namespace loopmend
