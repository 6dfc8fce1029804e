// SPDX-License-Identifier: GPL-3.0-or-later
#include "jobs/batch_controller.h"

#include "document/file_path.h"

#include <QCoreApplication>
#include <QFileInfo>

#include <memory>

namespace loopmend {

std::filesystem::path BatchController::program() {
#ifdef Q_OS_WIN
  const QString name = QStringLiteral("/loopmend.exe");
#else
  const QString name = QStringLiteral("/loopmend");
#endif
  return file_path(QCoreApplication::applicationDirPath() + name);
}

void BatchController::start(BatchJob asked) {
  if (busy()) return;
  if (const QString path = QString::fromStdString(path_text(asked.program)); !QFileInfo(path).isExecutable()) {
    Q_EMIT failed(
        tr("%1 is missing: the command line, which fills the scans. Install it beside the window.").arg(path));
    return;
  }
  job_ = std::make_shared<Job>(this);
  tasks_.run(
      job_,
      [this, job = job_, asked = std::move(asked)] {
        auto scans = std::make_shared<std::vector<Scan>>();
        BatchEvents events;
        events.listed = [&](const std::vector<Scan>& found) {
          *scans = found;
          std::vector<double> bytes;
          for (const Scan& scan : found) {
            const auto state = state_of(scan.input);
            bytes.push_back(state ? static_cast<double>(state->size) : 0);
          }
          job->post([this, scans, bytes] { Q_EMIT listed(*scans, bytes); });
        };
        events.begun = [&](std::size_t scan) { job->post([this, scan] { Q_EMIT begun(scan); }); };
        events.ended = [&](std::size_t scan, const ScanEnd& end) {
          job->post([this, scan, row = summary_row(asked.output, (*scans)[scan], end)] { Q_EMIT ended(scan, row); });
        };
        return fill_scans(asked, events, job->pause_token());
      },
      [this](const std::vector<SummaryRow>& rows) {
        job_.reset();
        Q_EMIT finished(rows);
      },
      [this](const QString& words) {
        job_.reset();
        Q_EMIT failed(words);
      });
}

void BatchController::stop() {
  if (job_) job_->ask_to_pause();
}

bool BatchController::shut_down(std::chrono::milliseconds at_most) {
  stop();  // the summary is written
  return tasks_.wait(at_most);
}

}  // namespace loopmend
