// SPDX-License-Identifier: GPL-3.0-or-later
// What closes a loop that no patch could close: options are tried on a copy of the surface before they are proposed.
#pragma once

#include "core/cancel.h"
#include "core/message.h"
#include "pipeline/fill_holes.h"
#include "pipeline/prepare.h"

#include <optional>
#include <utility>
#include <vector>

namespace loopmend {

/// A run tries options for so many of its loops: a trial costs about as much as the loop did.
inline constexpr int most_tried_loops = 3;

/// Whether the loop is open since it or the surface beside it is in the way, so that other triangles there would help.
bool is_open_for_its_shape(const HoleResult& result);

/// What is said of such a loop, with this advice in place of what may help.
Message with_advice(const Message& why_open, Message advice);

/// Tries options on a surface as it was before its holes were filled.
class AdviceTrials {
 public:
  /// @param soup    points and triangles of the surface, as its model holds them
  /// @param chosen  soup points of each loop that is to be filled
  /// @param used    options of the run: none of them is tried
  /// @param fill    how the run fills
  AdviceTrials(TriangleSoup soup, std::vector<std::vector<int>> chosen, PrepareOptions used, FillOptions fill,
               CancelToken cancel);

  /// Whether loop and surface are small enough for a trial.
  bool are_small(const std::vector<int>& loop) const;

  /// The option that closes the loop through these soup points by a patch that is not bad, or those that were tried in vain.
  /// @param loop  of the surface
  Message advice(const BoundaryLoop& loop, const std::vector<int>& points,
                 std::optional<SeamContinuity> continuity) const;

  /// Options that may help.
  Message untried() const;

  /// Whether --trim-boundary 3 closes it so.
  bool trimming_closes(const std::vector<int>& loop, std::optional<SeamContinuity> continuity) const;

 private:
  bool closes(SurfaceModel model, const std::vector<BoundaryLoop>& loops, const FillOptions& options) const;
  bool is_closed_trimmed(const std::vector<int>& loop, const FillOptions& options, int rounds) const;
  bool is_closed_repaired(const std::vector<int>& loop, const FillOptions& options, Defect more) const;
  std::optional<std::pair<int, int>> bridge_that_closes(const std::vector<int>& loop, const FillOptions& options) const;
  Message base_that_closes(const BoundaryLoop& loop, const std::vector<int>& points) const;
  FillOptions options_with(std::optional<SeamContinuity> continuity) const;

  TriangleSoup soup_;
  std::vector<std::vector<int>> chosen_;
  PrepareOptions used_;
  FillOptions fill_;
  CancelToken cancel_;
};

}  // namespace loopmend
