// When loops over vertices are worth several threads, and two pieces of work side by side.
#pragma once

#include <omp.h>

#include <atomic>
#include <exception>
#include <functional>
#include <future>
#include <memory>
#include <thread>
#include <type_traits>

namespace loopmend {

/// Vertices from which on OpenMP is used. Below, its threads are soon waited for longer than they help: on a busy machine
/// all of them must have been there before any may go on.
inline constexpr int least_for_threads = 10000;
/// From here on work is shared by two threads.
inline constexpr int least_for_two = 400;

/// Of how many threads the caller may make use (OpenMP's own count); put back at the end of the scope.
class ThreadAllowance {
 public:
  explicit ThreadAllowance(int threads) : before_(omp_get_max_threads()) { omp_set_num_threads(threads); }
  ~ThreadAllowance() { omp_set_num_threads(before_); }
  ThreadAllowance(const ThreadAllowance&) = delete;
  ThreadAllowance& operator=(const ThreadAllowance&) = delete;

 private:
  int before_;
};

/// first() and second(), which must not touch what the other writes: side by side if the caller may use two threads or
/// more, of which each then has half; else one after the other. Worth it from some tenths of a millisecond each on. If the
/// other thread has not begun when first() has ended, as on a busy machine, second() is done here and nobody waits for it.
/// Throws what they throw; what first() threw, if both do.
template <class First, class Second>
void side_by_side(const First& first, const Second& second) {
  const int threads = omp_get_max_threads();
  if (threads < 2) {
    first();
    second();
    return;
  }
  struct Other {
    explicit Other(const Second& work) : task(std::ref(work)) {}
    std::packaged_task<void()> task;
    std::atomic<bool> taken{false};
  };
  const auto other = std::make_shared<Other>(second);
  std::future<void> done = other->task.get_future();
  // Detached: once the work is taken here, the thread only looks at what it owns itself.
  std::thread([other, share = threads / 2] {
    if (other->taken.exchange(true)) return;
    omp_set_num_threads(share);
    other->task();
  }).detach();
  std::exception_ptr failure;
  try {
    const ThreadAllowance allowance(threads - threads / 2);
    first();
  } catch (...) {
    failure = std::current_exception();
  }
  const bool taken_there = other->taken.exchange(true);
  if (taken_there) done.wait();
  if (failure) std::rethrow_exception(failure);
  if (taken_there)
    done.get();
  else
    second();
}

/// Runs work() in several threads, or once: it takes its share of the work from a common counter until that is used up.
/// @param vertices  how many the work is about.
void share_work(int vertices, const std::function<void()>& work);

}  // namespace loopmend
