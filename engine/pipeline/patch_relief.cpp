// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/patch_relief.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace loopmend {

namespace {

double rms(const ReliefBands& bands) {
  double sum = 0;
  for (double band : bands) sum += band * band;
  return std::sqrt(sum);
}

/// "0.0123 (0.0131 around the hole)", in mesh units.
std::string heights(const ReliefBands& patch, const ReliefBands& around, double scale) {
  char text[96];
  std::snprintf(text, sizeof text, "%.3g (%.3g around the hole)", rms(patch) * scale, rms(around) * scale);
  return text;
}

}  // namespace

void add_relief(const PatchProblem& problem, const SplitEstimate& estimate, const ReliefChoice& choice,
                const CancelToken& cancel, PatchResult& result) {
  if (result.patch.free_count == 0) return;
  // Each hole its own waves.
  const std::uint64_t seed =
      choice.seed * 1'000'003 + (result.patch.loop_numbers.empty() ? 0 : result.patch.loop_numbers.front());
  const std::optional<ContinuedRelief> relief = continue_relief(result.patch, estimate, seed, cancel);
  if (cancel.cancelled()) return;
  if (!relief) return add_message(result, "the scan around the hole has no relief to continue");
  const std::string strength = heights(relief->patch, relief->around, result.patch.scale);
  Patch rough = result.patch;
  std::copy(relief->positions.begin(), relief->positions.end(), rough.positions.begin());
  if (rough.positions == result.patch.positions)
    return add_message(result, "the patch has as much relief as the scan without any added, rms " + strength);
  Validity validity = validate(problem.scan, rough);
  if (!validity.is_clean() && !no_worse(validity, validate(problem.scan, problem.initial)) &&
      !no_worse(validity, result.validity))
    return add_message(result, "with relief the patch would fold or cut the surface: it stays smooth");
  result.patch = std::move(rough);
  result.validity = std::move(validity);
  result.seams = seam_reports(result.patch);
  add_message(result, "relief continued at random, rms " + strength);
}

}  // namespace loopmend
