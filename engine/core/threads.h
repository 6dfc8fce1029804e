// SPDX-License-Identifier: GPL-3.0-or-later
// When loops over vertices are worth several threads, and two pieces of work side by side.
#pragma once

#include <omp.h>

#include <atomic>
#include <exception>
#include <functional>
#include <future>
#include <memory>
#include <system_error>
#include <thread>
#include <utility>

namespace loopmend {

/// Vertices from which on OpenMP is used. Below, its threads are soon waited for longer than they help: on a busy machine
/// all of them must have been there before any may go on.
inline constexpr int least_for_threads = 10000;
/// From here on work is shared by two threads.
inline constexpr int least_for_two = 400;

/// A share of somebody's threads that works beside him; his again once `done` is true.
struct LentThreads {
  const std::atomic<bool>* done;
  int count;
};

/// Of how many threads the caller may make use (OpenMP's own count); put back at the end of the scope.
class ThreadAllowance {
 public:
  /// @param lent  that come on top of them once they are back. Null: none, nor any that were lent before.
  explicit ThreadAllowance(int threads, const LentThreads* lent = nullptr)
      : before_(omp_get_max_threads()),
        lent_before_(std::exchange(lent_, lent)) {
    omp_set_num_threads(threads);
  }
  ~ThreadAllowance() {
    omp_set_num_threads(before_);
    lent_ = lent_before_;
  }
  ThreadAllowance(const ThreadAllowance&) = delete;
  ThreadAllowance& operator=(const ThreadAllowance&) = delete;

  /// Threads that the caller may use now, itself included.
  static int now() { return omp_get_max_threads() + (lent_ != nullptr && lent_->done->load() ? lent_->count : 0); }

 private:
  inline static thread_local const LentThreads* lent_ = nullptr;
  int before_;
  const LentThreads* lent_before_;
};

/// first() and second(), which must not touch what the other writes: side by side if the caller may use two threads or
/// more, of which each then has half, and first() all again once second() has ended (ThreadAllowance::now()); else one
/// after the other. Worth it from some tenths of a millisecond each on. If the other thread has not begun when first() has ended, as on a busy
/// machine, second() is done here and nobody waits for it. Throws what they throw; what first() threw, if both do.
template <class First, class Second>
void side_by_side(const First& first, const Second& second) {
  const int threads = ThreadAllowance::now();
  if (threads < 2) {
    first();
    second();
    return;
  }
  struct Other {
    explicit Other(const Second& work) : task(std::ref(work)) {}
    std::packaged_task<void()> task;
    std::atomic<bool> taken{false}, done{false};
  };
  const auto other = std::make_shared<Other>(second);
  std::future<void> result = other->task.get_future();
  // Detached: once the work is taken here, the thread only looks at what it owns itself.
  try {
    std::thread([other, share = threads / 2] {
      if (other->taken.exchange(true)) return;
      omp_set_num_threads(share);
      other->task();
      other->done = true;
    }).detach();
  } catch (const std::system_error&) {
    // No further thread is to be had: the work is done here, after the first.
  }
  std::exception_ptr failure;
  try {
    const LentThreads lent{&other->done, threads / 2};
    const ThreadAllowance allowance(threads - threads / 2, &lent);
    first();
  } catch (...) {
    failure = std::current_exception();
  }
  const bool taken_there = other->taken.exchange(true);
  if (taken_there) result.wait();
  if (failure) std::rethrow_exception(failure);
  if (taken_there)
    result.get();
  else
    second();
}

/// Runs work() in several threads, or once: it takes its share of the work from a common counter until that is used up.
/// @param vertices  how many the work is about.
void share_work(int vertices, const std::function<void()>& work);

}  // namespace loopmend
