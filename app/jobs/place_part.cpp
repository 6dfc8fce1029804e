// SPDX-License-Identifier: GPL-3.0-or-later
#include "jobs/place_part.h"

#include "jobs/trial_base.h"

namespace loopmend {

PlacePart::PlacePart(Document& document, Workbench& workbench, QObject* parent)
    : QObject(parent),
      document_(document),
      workbench_(workbench) {}

PlacePart::~PlacePart() {
  if (job_) job_->cancel();
}

void PlacePart::place(int scan, const Eigen::Affine3d& placement) {
  if (busy() || workbench_.busy() || !document_.scan(scan)) return;
  job_ = std::make_shared<Job>(this);
  tasks_.start([this, job = job_, parts = parts_of(document_, {scan}), placement, scan] {
    try {
      TriangleSoup soup = make_base(parts).model->soup;
      for (Vec3& p : soup.points) p = placement * (p - parts.origin) + parts.origin;
      const OpenedScanPtr made = made_scan(std::move(soup), parts.parts.front().scan->name, parts.origin);
      job->tell([this, made, scan] {
        job_.reset();
        if (!document_.scan(scan)) return;
        workbench_.replace_scans({scan}, made, tr("Place %1").arg(made->name));
        Q_EMIT placed(scan, document_.scans().back());
      });
    } catch (const std::exception& error) {
      job->tell([this, words = QString::fromUtf8(error.what())] {
        job_.reset();
        Q_EMIT failed(words);
      });
    }
  });
}

bool PlacePart::shut_down(std::chrono::milliseconds at_most) {
  if (job_) job_->cancel();
  return tasks_.wait(at_most);
}

}  // namespace loopmend
