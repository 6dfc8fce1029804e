// SPDX-License-Identifier: GPL-3.0-or-later
#include "problems.h"

namespace loopmend {

void define_problems(pybind11::module_&) {}

}  // namespace loopmend
