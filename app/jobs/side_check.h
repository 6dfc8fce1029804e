// SPDX-License-Identifier: GPL-3.0-or-later
// Whether the faces of an opened scan look inward: looked for beside other work, once for each scan.
#pragma once

#include "document/document.h"
#include "jobs/fill_controller.h"
#include "jobs/task_runner.h"

#include <QObject>
#include <QTimer>

#include <memory>
#include <vector>

namespace loopmend {

class SideCheck : public QObject {
  Q_OBJECT

 public:
  SideCheck(const Document& document, const FillController& controller, QObject* parent = nullptr);

  /// For the end of the program. @returns whether every worker has ended.
  bool shut_down(std::chrono::milliseconds at_most);

 Q_SIGNALS:
  /// An open body looks inward, as a room scanned from within does; no program knows which of both it is.
  void open_body_looks_inward(int scan);
  /// So many bodies or cavities, closed but for small holes, are inside out.
  void bodies_are_inside_out(int scan, int count);

 private:
  void start_next();

  const Document& document_;
  const FillController& controller_;
  TaskRunner tasks_{Yielding::as_it_can};
  JobPtr job_;
  QTimer leisure_;
  std::vector<std::weak_ptr<const OpenedScan>> known_;
};

}  // namespace loopmend
