// SPDX-License-Identifier: GPL-3.0-or-later
// A few linear fairings in place of a flow: in an irregular neighborhood, and for less than curvature continuity.
#pragma once

#include "evolution/evolving_patch.h"

namespace loopmend {

class RobustFairing : public Stepper {
 public:
  /// @param radius  R of the neighborhood, patch frame.
  RobustFairing(const EvolvingPatch& patch, double radius);
  void step(EvolvingPatch& patch, const CancelToken& cancel) override;

 private:
  bool weighs_boundary_;  ///< in a rough neighborhood; else the order is that of EvolutionOptions::continuity
  double radius_;
  Eigen::VectorXd data_confidence_;  ///< of the neighborhood, on rough ones
  int passes_left_;
};

}  // namespace loopmend
