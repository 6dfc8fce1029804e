// SPDX-License-Identifier: GPL-3.0-or-later
#include "jobs/place_part.h"

#include "jobs/problem_base.h"

namespace loopmend {

PlacePart::PlacePart(Document& document, FillController& controller, QObject* parent)
    : QObject(parent),
      document_(document),
      controller_(controller) {}

void PlacePart::place(int scan, const Eigen::Affine3d& placement) {
  if (busy() || controller_.busy() || !document_.scan(scan)) return;
  job_ = std::make_shared<Job>(this);
  tasks_.run(
      job_,
      [parts = parts_of(document_, {scan}), placement] {
        TriangleSoup soup = make_base(parts).model->soup;
        for (Vec3& p : soup.points) p = placement * (p - parts.origin) + parts.origin;
        return made_scan(std::move(soup), parts.parts.front().scan->name, parts.origin);
      },
      [this, scan](const OpenedScanPtr& made) {
        job_.reset();
        if (!document_.scan(scan)) return;
        controller_.replace_scans({scan}, made, tr("Place %1").arg(made->name));
        Q_EMIT placed(scan, document_.scans().back());
      },
      [this](const QString& words) {
        job_.reset();
        Q_EMIT failed(words);
      });
}

bool PlacePart::shut_down(std::chrono::milliseconds at_most) { return tasks_.stop(at_most); }

}  // namespace loopmend
