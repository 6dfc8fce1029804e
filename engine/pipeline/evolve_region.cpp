// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/evolve_region.h"

#include "pipeline/evolve_patch.h"

namespace loopmend {

Message flaws_of(const Validity& validity) {
  return say("%1 folded edges and %2 self-intersections", validity.folds, validity.intersections);
}

PatchResult evolve_region(const Region& region, EvolutionOptions options, const Evolution::OnStep& on_step,
                          const CancelToken& cancel) {
  options.triangles = PatchTriangles::kept;  // the file's numbering is to stay
  return evolve_patch(region.patch, options, on_step, cancel);
}

Message refusal_of(const Region& region, const PatchResult& evolved) {
  return no_worse(evolved.validity, patch_validity(region.patch))
             ? Message()
             : say("the flow would leave %1 in the region", flaws_of(evolved.validity));
}

}  // namespace loopmend
