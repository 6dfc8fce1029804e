// SPDX-License-Identifier: GPL-3.0-or-later
// Python's blend(), interpolate() and evolve(): what `loopmend blend`, `interpolate` and `evolve` do between their files.
#pragma once

#include <pybind11/pybind11.h>

namespace loopmend {

void define_problems(pybind11::module_& m);

}  // namespace loopmend
