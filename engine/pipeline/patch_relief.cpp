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

/// "0.0123", in mesh units.
std::string height(const ReliefBands& bands, double scale) {
  char text[32];
  std::snprintf(text, sizeof text, "%.3g", rms(bands) * scale);
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
  if (!relief)
    return add_message(result, say("the scan around the hole has no relief to continue").with_code("no_relief"));
  const std::string own = height(relief->patch, result.patch.scale),
                    around = height(relief->around, result.patch.scale);
  Patch rough = result.patch;
  std::copy(relief->positions.begin(), relief->positions.end(), rough.positions.begin());
  if (rough.positions == result.patch.positions)
    return add_message(
        result,
        say("the patch has as much relief as the scan without any added, rms %1 (%2 around the hole)", own, around)
            .with_code("relief_enough"));
  Validity validity = validate(problem.scan, rough);
  if (!validity.is_clean() && !no_worse(validity, validate(problem.scan, problem.initial)) &&
      !no_worse(validity, result.validity))
    return add_message(
        result,
        say("with relief the patch would fold or cut the surface: it stays smooth").with_code("relief_crosses"));
  result.patch = std::move(rough);
  result.validity = std::move(validity);
  result.seams = seam_reports(result.patch);
  add_message(
      result,
      say("relief continued at random, rms %1 (%2 around the hole)", own, around).with_code("relief_continued"));
}

}  // namespace loopmend
