// SPDX-License-Identifier: GPL-3.0-or-later
#include "jobs/task_runner.h"

#include "core/error.h"
#include "core/threads.h"
#include "document/message_words.h"
#include "jobs/thread_priority.h"

#include <QCoreApplication>
#include <QEvent>

#include <exception>
#include <system_error>

namespace loopmend {

namespace {

const auto letter_arrived = static_cast<QEvent::Type>(QEvent::registerEventType());

}  // namespace

void Mailbox::post(std::function<void()> letter) {
  {
    const std::lock_guard lock(mutex_);
    letters_.push_back(std::move(letter));
  }
  QCoreApplication::postEvent(this, new QEvent(letter_arrived));
}

bool Mailbox::event(QEvent* event) {
  if (event->type() != letter_arrived) return QObject::event(event);
  std::function<void()> letter;
  {
    const std::lock_guard lock(mutex_);
    letter = std::move(letters_.front());
    letters_.pop_front();
  }
  if (receiver_) letter();
  return true;
}

// The last to hold a job may be its worker.
Job::Job(QObject* window_side) : mailbox_(new Mailbox(window_side), [](Mailbox* mailbox) { mailbox->deleteLater(); }) {}

void Job::post(std::function<void()> act) const {
  mailbox_->post([act = std::move(act), token = token_] {
    if (!token.cancelled()) act();
  });
}

void Job::linger(std::chrono::milliseconds time) const {
  constexpr std::chrono::milliseconds look{10};
  const auto until = std::chrono::steady_clock::now() + time;
  while (!pause_.cancelled() && std::chrono::steady_clock::now() < until) std::this_thread::sleep_for(look);
}

TaskRunner::~TaskRunner() {
  for (Worker& worker : workers_) worker.job->cancel();
  for (Worker& worker : workers_) worker.thread.join();
}

void TaskRunner::start(const JobPtr& job, std::function<void()> work, Failed failed) {
  reap();
  auto done = std::make_shared<std::atomic<bool>>(false);
  const auto whole = [job, work = std::move(work), failed, done, yielding = yielding_] {
    yield_to_window(yielding);
    try {
      // Among many, a second thread for each only makes the window wait.
      with_thread_budget(yielding == Yielding::as_it_can ? 1 : 0, work);
    } catch (const std::exception& error) {
      job->post([failed, words = labels::in_words(message_of(error))] { failed(words); });
    }
    done->store(true);
  };
  try {
    workers_.push_back({std::thread(whole), job, done});
  } catch (const std::system_error&) {
    job->post([failed = std::move(failed)] {
      failed(QCoreApplication::translate(
          "loopmend::TaskRunner",
          "The system allows no further thread for this work (ulimit -u). Close other programs, or raise that limit."));
    });
  }
}

bool TaskRunner::wait(std::chrono::milliseconds at_most) {
  const auto end = std::chrono::steady_clock::now() + at_most;
  for (;;) {
    reap();
    if (workers_.empty()) return true;
    if (std::chrono::steady_clock::now() >= end) return false;
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
}

bool TaskRunner::stop(std::chrono::milliseconds at_most) {
  for (Worker& worker : workers_) worker.job->cancel();
  return wait(at_most);
}

void TaskRunner::reap() {
  for (auto it = workers_.begin(); it != workers_.end();) {
    if (it->done->load()) {
      it->thread.join();
      it = workers_.erase(it);
    } else {
      ++it;
    }
  }
}

}  // namespace loopmend
