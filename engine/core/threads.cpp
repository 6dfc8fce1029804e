// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/threads.h"

#include <tbb/global_control.h>
#include <tbb/info.h>
#include <tbb/task_arena.h>
#include <tbb/task_group.h>

#include <algorithm>
#include <atomic>
#include <exception>
#include <latch>
#include <mutex>
#include <stdexcept>
#include <thread>
#include <utility>
#include <vector>

#ifdef LOOPMEND_THREAD_SANITIZER
// The thread sanitizer cannot look into oneTBB, and does not look into this file (CMakeLists.txt): so this file states what is
// handed from thread to thread.
extern "C" void __tsan_acquire(void* at);
extern "C" void __tsan_release(void* at);
#endif

namespace loopmend {

namespace {

/// Threads that can run at once, at most one for each core. oneTBB ends the program where it cannot start a thread (`ulimit -u`,
/// `ulimit -v`): so that is tried first, and oneTBB is not asked for more.
int available_threads() {
  static const int count = [] {
    std::latch end(1);
    std::vector<std::thread> others;
    try {
      for (int k = tbb::info::default_concurrency(); k > 1; --k) others.emplace_back([&end] { end.wait(); });
    } catch (const std::exception&) {
      // No further thread is to be had.
    }
    end.count_down();
    for (std::thread& other : others) other.join();
    return 1 + static_cast<int>(others.size());
  }();
  static const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(count));
  return count;
}

#ifdef LOOPMEND_THREAD_SANITIZER
void hand_over(void* at) { __tsan_release(at); }
void take_over(void* at) { __tsan_acquire(at); }
#else
void hand_over(void*) {}
void take_over(void*) {}
#endif

/// Offers work, which must not throw, to other threads. If none takes it, wait() does it.
template <class Work>
void share(tbb::task_group& group, const Work& work) {
  hand_over(&group);
  try {
    group.run([&group, work] {
      take_over(&group);
      work();
      hand_over(&group);
    });
  } catch (const std::runtime_error&) {
    // A thread could not be started after all. The work is in the group nevertheless.
  }
}

void wait(tbb::task_group& group) {
  group.wait();
  take_over(&group);
}

}  // namespace

int thread_budget() {
  const int wanted = tbb::this_task_arena::max_concurrency();
  return wanted < 2 ? 1 : std::min(wanted, available_threads());
}

void call_with_thread_budget(int n, const std::function<void()>& f) {
  if (n <= 0 || n >= tbb::this_task_arena::max_concurrency()) return f();
  tbb::task_arena(n).execute(f);
}

struct SideWork::State {
  std::function<void()> work;
  std::atomic<bool> begun = false;
  std::exception_ptr failure;
  tbb::task_group group;

  void run() {
    if (begun.exchange(true)) return;
    try {
      work();
    } catch (...) {
      failure = std::current_exception();
    }
  }
};

SideWork::SideWork(std::function<void()> work) : state_(std::make_unique<State>()) {
  state_->work = std::move(work);
  if (thread_budget() > 1) share(state_->group, [state = state_.get()] { state->run(); });
}

SideWork::~SideWork() {
  state_->begun = true;
  wait(state_->group);
}

void SideWork::finish() {
  wait(state_->group);
  state_->run();
  if (state_->failure) std::rethrow_exception(std::exchange(state_->failure, nullptr));
}

void share_loop(int begin, int end, int grain, const std::function<LoopPart()>& make_part) {
  if (begin >= end) return;
  const int parts = (end - begin - 1) / grain + 1;
  if (parts == 1 || thread_budget() == 1) return make_part()(begin, end);
  std::atomic<int> next = 0;
  std::mutex failing;
  std::pair<int, std::exception_ptr> failure(parts, nullptr);  // the lowest part that failed
  const auto take_parts = [&] {
    LoopPart do_part;
    for (int k = next++; k < parts; k = next++) {
      try {
        if (!do_part) do_part = make_part();
        const int from = begin + k * grain;
        // While a thread waits within this part, it must not begin another part of this loop on top of it.
        tbb::this_task_arena::isolate([&] { do_part(from, from + std::min(grain, end - from)); });
      } catch (...) {
        const std::lock_guard lock(failing);
        if (k < failure.first) failure = {k, std::current_exception()};
        next = parts;
      }
    }
  };
  tbb::task_group others;
  for (int k = std::min(parts, thread_budget()); k > 1; --k) share(others, take_parts);
  take_parts();
  wait(others);
  if (failure.second) std::rethrow_exception(failure.second);
}

}  // namespace loopmend
