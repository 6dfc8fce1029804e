// SPDX-License-Identifier: GPL-3.0-or-later
// Worker threads, one per job. A job that was given up goes on to its next look at the token, unseen; the window does
// not wait for it.
#pragma once

#include "core/cancel.h"

#include <QObject>
#include <QPointer>
#include <QString>

#include <atomic>
#include <chrono>
#include <deque>
#include <functional>
#include <list>
#include <memory>
#include <mutex>
#include <thread>
#include <utility>

namespace loopmend {

/// Runs on the window's thread, in their order, what other threads put into it. Events of Qt alone would do, but the thread
/// sanitizer cannot see that Qt's queue hands them over.
class Mailbox : public QObject {
 public:
  /// @param receiver  where it is no more, letters are thrown away
  explicit Mailbox(QObject* receiver) : receiver_(receiver) {}
  /// From any thread.
  void post(std::function<void()> letter);
  bool event(QEvent* event) override;

 private:
  const QPointer<QObject> receiver_;
  std::mutex mutex_;
  std::deque<std::function<void()>> letters_;
};

/// One job: how it is cancelled, and how it reaches the window.
class Job {
 public:
  /// On the window's thread.
  explicit Job(QObject* window_side);

  const CancelToken& token() const { return token_; }
  /// Asked to stop after the present step, keeping everything.
  bool asked_to_pause() const { return pause_.cancelled(); }
  void ask_to_pause() { pause_.cancel(); }
  /// Set by a pause and by cancelling alike: for work that keeps what it has when it is stopped.
  const CancelToken& pause_token() const { return pause_; }
  /// Waits on the worker's thread; a pause or a cancel ends it.
  void linger(std::chrono::milliseconds time) const;
  /// Give it up: what it says from now on is not heard.
  void cancel() {
    token_.cancel();
    pause_.cancel();
  }

  /// From the worker: runs `act` on the window's thread, unless the job has been cancelled by then.
  void post(std::function<void()> act) const;

 private:
  std::shared_ptr<Mailbox> mailbox_;
  CancelToken token_, pause_;
};
using JobPtr = std::shared_ptr<Job>;

/// Gives the job up, where there is one, and forgets it.
inline void drop(JobPtr& job) {
  if (job) std::exchange(job, nullptr)->cancel();
}

/// How far workers, and the threads that they start, step back behind the window's thread when both want the processor.
enum class Yielding {
  mostly,     ///< the window is smooth, and the work goes on beside it
  as_it_can,  ///< many workers at once, which together would still keep the window waiting
};

/// For workers that write files. A save that was given up goes on unseen, and must never land on a later one: it either
/// ends before the later one begins, or does not begin any more.
class WriteTurns {
 public:
  /// Waits until no other writer is at work. @returns what write() returns; nothing where the job was cancelled by then.
  template <class Write>
  auto take(const Job& job, Write write) -> decltype(write()) {
    const std::lock_guard turn(mutex_);
    if (job.token().cancelled()) return {};
    return write();
  }

 private:
  std::mutex mutex_;
};

class TaskRunner {
 public:
  explicit TaskRunner(Yielding yielding = Yielding::mostly) : yielding_(yielding) {}
  /// Gives every job up, and waits for all of them.
  ~TaskRunner();
  TaskRunner(const TaskRunner&) = delete;
  TaskRunner& operator=(const TaskRunner&) = delete;

  using Failed = std::function<void(const QString& words)>;
  /// work() on a worker. What it throws, or that the system allows no further thread, goes to failed() in words, on the
  /// window's thread. That is not called once the job was cancelled.
  void start(const JobPtr& job, std::function<void()> work, Failed failed);
  /// The same; what work() returns goes to done(), on the window's thread, unless the job was cancelled.
  template <class Work, class Done>
  void run(const JobPtr& job, Work work, Done done, Failed failed) {
    start(
        job,
        [job, work = std::move(work), done = std::move(done)]() mutable {
          auto result = std::make_shared<decltype(work())>(work());
          job->post([done, result]() mutable { done(std::move(*result)); });
        },
        std::move(failed));
  }
  /// @returns whether every job has ended within the time.
  bool wait(std::chrono::milliseconds at_most);
  /// The same, after every job was given up.
  bool stop(std::chrono::milliseconds at_most);

 private:
  struct Worker {
    std::thread thread;
    JobPtr job;
    std::shared_ptr<std::atomic<bool>> done;
  };
  void reap();

  Yielding yielding_;
  std::list<Worker> workers_;
};

}  // namespace loopmend
