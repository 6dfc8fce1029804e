// SPDX-License-Identifier: GPL-3.0-or-later
// Relief and noise of the neighborhood drawn at random over a smooth patch, so that a fill in a rough scan is no bald spot.
#pragma once

#include "core/cancel.h"
#include "mesh/patch.h"
#include "split/split_estimate.h"

#include <array>
#include <cstdint>
#include <optional>

namespace loopmend {

/// Rms of a height in three bands of wavelengths, about 3, 6 and 12 boundary edges. Patch frame.
using ReliefBands = std::array<double, 3>;

/// What a patch shows of the relief around its hole.
struct ReliefChoice {
  enum class Kind { smooth, continued } kind = Kind::smooth;
  std::uint64_t seed = 1;  ///< of the random waves

  bool operator==(const ReliefChoice&) const = default;
};

struct ContinuedRelief {
  Points positions;    ///< of the free vertices, patch frame
  ReliefBands around;  ///< what the neighborhood has
  ReliefBands patch;   ///< what the patch has with these positions
};

/// A conditional simulation (Journel and Huijbregts 1978): random waves that bring the patch in each band to the strength of the
/// neighborhood, less their own continuation from the neighborhood into the patch, so that nothing is added at the seam.
/// docs/math/irregular_boundaries.md, "Relief on request".
/// @param patch  a smooth patch in its rough neighborhood. @param estimate  of that neighborhood: its edge and radius count
/// @param seed  the same seed and patch give the same bits
/// @returns nothing where the neighborhood is smooth, or where cancelled.
std::optional<ContinuedRelief> continue_relief(const Patch& patch, const SplitEstimate& estimate, std::uint64_t seed,
                                               const CancelToken& cancel = {});

}  // namespace loopmend
