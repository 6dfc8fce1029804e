// SPDX-License-Identifier: GPL-3.0-or-later
// What came of a call, as dictionaries for loopmend/results.py. The names are those of the command line's reports.
#pragma once

#include "fill_job.h"

#include "repair/watertight.h"

#include <pybind11/pybind11.h>

namespace loopmend {

/// Number, kind and lengths of a loop, without its vertices.
pybind11::dict loop_figures(const BoundaryLoop& loop);

/// Energies, steps, quality of a patch, and the seams of its loops.
pybind11::dict patch_figures(const PatchResult& result);

pybind11::dict check_figures(const Watertightness& surface);

pybind11::dict fill_result(FilledScan done);

}  // namespace loopmend
