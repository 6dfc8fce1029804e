// SPDX-License-Identifier: GPL-3.0-or-later
// Fills a folder of scans beside the window, by the function that `loopmend batch` calls (batch/fill_scans.h).
#pragma once

#include "batch/fill_scans.h"
#include "jobs/task_runner.h"

#include <QObject>
#include <QString>

#include <chrono>
#include <filesystem>
#include <vector>

namespace loopmend {

class BatchController : public QObject {
  Q_OBJECT

 public:
  using QObject::QObject;

  /// Of the command line, which does the work: it lies beside this one.
  static std::filesystem::path program();

  /// One of finished() and failed() reports its end.
  void start(BatchJob job);
  /// Ends the scans that are being filled. What is done stays, and the next run goes on there.
  void stop();
  bool busy() const { return job_ != nullptr; }
  /// Asked to end; the summary is still written.
  bool is_stopping() const { return job_ && job_->asked_to_pause(); }
  /// For the end of the program. @returns whether every worker has ended.
  bool shut_down(std::chrono::milliseconds at_most);

 Q_SIGNALS:
  void listed(const std::vector<Scan>& scans, const std::vector<double>& bytes);
  void begun(std::size_t scan);
  void ended(std::size_t scan, const SummaryRow& row);
  void finished(const std::vector<SummaryRow>& rows);
  void failed(const QString& words);

 private:
  TaskRunner tasks_;
  JobPtr job_;
};

}  // namespace loopmend
