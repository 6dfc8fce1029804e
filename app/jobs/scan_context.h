// SPDX-License-Identifier: GPL-3.0-or-later
// What work on the patches of a scan reads of it. What the tests for cuts need is made by the first worker that needs it, then shared.
#pragma once

#include "pipeline/validate.h"

#include <memory>
#include <mutex>
#include <vector>

namespace loopmend {

class ScanContext {
 public:
  /// @param colors  per vertex of the view; null: the scan has none
  ScanContext(std::shared_ptr<const SurfaceModel> model, std::shared_ptr<const std::vector<Color>> colors)
      : model_(std::move(model)),
        colors_(std::move(colors)) {}

  const SurfaceModel& model() const { return *model_; }
  const std::shared_ptr<const std::vector<Color>>& colors() const { return colors_; }
  /// Takes a second for a million triangles, the first time. Safe from several threads.
  const ScanIndex& index() {
    std::call_once(made_, [this] { index_ = std::make_unique<ScanIndex>(*model_); });
    return *index_;
  }

 private:
  std::shared_ptr<const SurfaceModel> model_;
  std::shared_ptr<const std::vector<Color>> colors_;
  std::once_flag made_;
  std::unique_ptr<ScanIndex> index_;
};
using ScanContextPtr = std::shared_ptr<ScanContext>;

}  // namespace loopmend
