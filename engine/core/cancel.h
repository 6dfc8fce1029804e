// SPDX-License-Identifier: GPL-3.0-or-later
// Cancellation: a flag that the person's side sets and long work reads.
#pragma once

#include <atomic>
#include <memory>

namespace loopmend {

/// Copies share one flag. A default-constructed token is live and never cancelled until cancel() is called.
class CancelToken {
 public:
  CancelToken() : flag_(std::make_shared<std::atomic<bool>>(false)) {}
  void cancel() const { flag_->store(true, std::memory_order_relaxed); }
  bool cancelled() const { return flag_->load(std::memory_order_relaxed); }

 private:
  std::shared_ptr<std::atomic<bool>> flag_;
};

}  // namespace loopmend
