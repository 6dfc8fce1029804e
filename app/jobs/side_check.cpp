// SPDX-License-Identifier: GPL-3.0-or-later
#include "jobs/side_check.h"

#include "repair/inverted_shells.h"

#include <algorithm>

namespace loopmend {

SideCheck::SideCheck(const Document& document, const FillController& controller, QObject* parent)
    : QObject(parent),
      document_(document),
      controller_(controller) {
  constexpr int leisure_ms = 500;
  leisure_.setSingleShot(true);
  leisure_.setInterval(leisure_ms);
  connect(&leisure_, &QTimer::timeout, this, &SideCheck::start_next);
  for (const auto change : {&Document::opened, &Document::scans_changed})
    connect(&document_, change, &leisure_, qOverload<>(&QTimer::start));
  connect(&controller_, &FillController::activity_changed, &leisure_, qOverload<>(&QTimer::start));
}

void SideCheck::start_next() {
  if (job_ || controller_.busy()) return;
  std::erase_if(known_, [](const auto& scan) { return scan.expired(); });
  for (int index : document_.scans()) {
    const std::shared_ptr<const OpenedScan> scan = document_.scan(index);
    if (std::any_of(known_.begin(), known_.end(), [&](const auto& other) { return other.lock() == scan; })) continue;
    known_.push_back(scan);
    job_ = std::make_shared<Job>(this);
    tasks_.run(
        job_, [scan] { return find_inverted_shells(*scan->model, scan->loops); },
        [this, index, scan](const InvertedShells& found) {
          job_.reset();
          leisure_.start();
          if (document_.scan(index) != scan) return;
          if (found.open > 0)
            Q_EMIT open_body_looks_inward(index);
          else if (found.closed > 0)
            Q_EMIT bodies_are_inside_out(index, static_cast<int>(found.closed));
        },
        [this](const QString&) { job_.reset(); });
    return;
  }
}

bool SideCheck::shut_down(std::chrono::milliseconds at_most) {
  leisure_.stop();
  return tasks_.stop(at_most);
}

}  // namespace loopmend
