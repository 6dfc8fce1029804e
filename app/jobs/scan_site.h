// SPDX-License-Identifier: GPL-3.0-or-later
// What the tests for cuts read of a scan: made by the first worker that needs it, then shared.
#pragma once

#include "pipeline/validate.h"

#include <memory>
#include <mutex>

namespace loopmend {

class ScanSite {
 public:
  explicit ScanSite(std::shared_ptr<const SurfaceModel> model) : model_(std::move(model)) {}

  const SurfaceModel& model() const { return *model_; }
  /// Takes a second for a million triangles, the first time. Safe from several threads.
  const ScanIndex& site() {
    std::call_once(made_, [this] { site_ = std::make_unique<ScanIndex>(*model_); });
    return *site_;
  }

 private:
  std::shared_ptr<const SurfaceModel> model_;
  std::once_flag made_;
  std::unique_ptr<ScanIndex> site_;
};
using ScanSitePtr = std::shared_ptr<ScanSite>;

}  // namespace loopmend
