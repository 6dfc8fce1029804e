// SPDX-License-Identifier: GPL-3.0-or-later
// The run that led to a patch's state, as curves against its steps.
#pragma once

#include "document/patch_state.h"

#include <QVector>

namespace loopmend {

/// What a step lowers: J of a split flow (split/split_energy.h), or the flow's own energy. Fairings, also those that a split flow
/// sets out with, lower neither: each minimizes an energy of its own.
enum class Lowered { J, energy, nothing };
Lowered lowered_by_last_step(const PatchState& state);

struct RunCurves {
  explicit RunCurves(const OpenPatch& patch);

  QVector<double> step, lowered, smooth, relief;  ///< the parts of J: empty unless `split`
  QVector<double> residual_step, residual;
  bool split = false;    ///< `lowered` is J
  bool fairing = false;  ///< there were steps, none of which lowers J or the flow's energy

 private:
  void add(const PatchState& state, const PatchState* before);
};

}  // namespace loopmend
