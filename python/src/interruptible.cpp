// SPDX-License-Identifier: GPL-3.0-or-later
#include "interruptible.h"

#include "core/error.h"

#include <chrono>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <system_error>
#include <thread>
#include <utility>
#include <vector>

namespace loopmend {

namespace {

namespace py = pybind11;

/// From the working thread to the calling one.
class Mailbox {
 public:
  void post(Event event) {
    const std::lock_guard lock(mutex_);
    events_.push_back(std::move(event));
    news_.notify_one();
  }

  void finish() {
    const std::lock_guard lock(mutex_);
    finished_ = true;
    news_.notify_one();
  }

  /// Waits for news, but no longer than this. @returns whether the work has ended.
  bool wait(std::chrono::milliseconds longest, std::vector<Event>& events) {
    std::unique_lock lock(mutex_);
    news_.wait_for(lock, longest, [&] { return finished_ || !events_.empty(); });
    events = std::exchange(events_, {});
    return finished_;
  }

 private:
  std::mutex mutex_;
  std::condition_variable news_;
  std::vector<Event> events_;
  bool finished_ = false;
};

void answer(const std::vector<Event>& events, const py::object& on_event) {
  if (PyErr_CheckSignals() != 0) throw py::error_already_set();
  for (const Event& event : events) on_event(*event());
}

std::thread started(const std::function<void()>& work) {
  try {
    return std::thread(work);
  } catch (const std::system_error&) {
    throw Error(
        say("the work needs a thread of its own, and the system allows no more (ulimit -u). Raise that limit."));
  }
}

}  // namespace

void run_interruptibly(const std::function<void(const CancelToken& cancel, const PostEvent& post)>& work,
                       const py::object& on_event, OnInterrupt on_interrupt) {
  constexpr std::chrono::milliseconds between_looks{50};
  const CancelToken cancel;
  Mailbox box;
  PostEvent post = [](const Event&) {};
  if (!on_event.is_none()) post = [&](Event event) { box.post(std::move(event)); };
  std::exception_ptr fault, stop;
  std::thread worker = started([&] {
    try {
      work(cancel, post);
    } catch (...) {
      fault = std::current_exception();
    }
    box.finish();
  });
  for (bool finished = false; !finished;) {
    std::vector<Event> events;
    {
      const py::gil_scoped_release others_may_run;
      finished = box.wait(between_looks, events);
    }
    if (stop) continue;
    try {
      answer(events, on_event);
    } catch (const py::error_already_set& raised) {
      const bool is_kept =
          on_interrupt == OnInterrupt::keep_finished && !cancel.cancelled() && raised.matches(PyExc_KeyboardInterrupt);
      if (!is_kept) stop = std::current_exception();
      cancel.cancel();
    } catch (...) {
      stop = std::current_exception();
      cancel.cancel();
    }
  }
  {
    const py::gil_scoped_release others_may_run;
    worker.join();
  }
  if (stop) std::rethrow_exception(stop);
  if (fault) std::rethrow_exception(fault);
}

}  // namespace loopmend
