// SPDX-License-Identifier: GPL-3.0-or-later
#include "jobs/print_check.h"

#include "document/targets.h"
#include "jobs/export_scene.h"

namespace loopmend {

PrintCheck::PrintCheck(const Document& document, const FillController& controller, QObject* parent)
    : QObject(parent),
      document_(document),
      controller_(controller) {
  constexpr int leisure_ms = 700;
  leisure_.setSingleShot(true);
  leisure_.setInterval(leisure_ms);
  connect(&leisure_, &QTimer::timeout, this, &PrintCheck::start_unasked);
  for (const auto change : {&Document::opened, &Document::scans_changed, &Document::patches_changed})
    connect(&document_, change, this, &PrintCheck::forget);
  connect(&document_, &Document::patch_moved, this, &PrintCheck::forget);
  connect(&controller_, &FillController::activity_changed, this, [this] {
    if (!result_ && !job_) leisure_.start();
  });
}

void PrintCheck::forget() {
  drop(job_);
  leisure_.start();
  if (!std::exchange(result_, std::nullopt)) return;
  Q_EMIT changed();
}

void PrintCheck::start_unasked() {
  std::size_t triangles = 0;
  for (int scan : document_.scans()) triangles += document_.scan(scan)->model->soup.triangles.size();
  if (!controller_.busy() && triangles <= most_triangles_unasked) start();
}

void PrintCheck::start() {
  if (result_ || job_ || !document_.has_scan()) return;
  job_ = std::make_shared<Job>(this);
  tasks_.run(
      job_,
      [job = job_, task = export_task(document_, {})] { return watertightness(plain_surface(task), job->token()); },
      [this](const Watertightness& found) {
        job_.reset();
        result_ = found;
        // As the table counts them: where several touch at a vertex, the check takes them for one.
        if (const int open = open_loops(document_); open > 0 && found.open_boundaries > 0)
          result_->open_boundaries = static_cast<std::size_t>(open);
        Q_EMIT changed();
      },
      [this](const QString&) { job_.reset(); });
}

bool PrintCheck::shut_down(std::chrono::milliseconds at_most) {
  leisure_.stop();
  return tasks_.stop(at_most);
}

}  // namespace loopmend
