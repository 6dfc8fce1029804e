// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/evolve_region.h"

#include "pipeline/evolve_patch.h"

namespace loopmend {

std::string flaws_of(const Validity& validity) {
  return std::to_string(validity.folds) + " folded edges and " + std::to_string(validity.intersections) +
         " self-intersections";
}

PatchResult evolve_region(const Region& region, EvolutionOptions options, const Evolution::OnStep& on_step,
                          const CancelToken& cancel) {
  options.triangles = PatchTriangles::kept;  // the file's numbering is to stay
  return evolve_patch(region.patch, options, on_step, cancel);
}

std::string refusal_of(const Region& region, const PatchResult& evolved) {
  return no_worse(evolved.validity, patch_validity(region.patch))
             ? std::string()
             : "the flow would leave " + flaws_of(evolved.validity) + " in the region";
}

}  // namespace loopmend
