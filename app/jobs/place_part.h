// SPDX-License-Identifier: GPL-3.0-or-later
// A scan at another place: moved, turned, scaled, with its patches. Comes into the document in place of the old one.
#pragma once

#include "jobs/fill_controller.h"

#include <Eigen/Geometry>

namespace loopmend {

class PlacePart : public QObject {
  Q_OBJECT

 public:
  PlacePart(Document& document, FillController& controller, QObject* parent = nullptr);

  bool busy() const { return job_ != nullptr; }
  /// @param placement  in the scene's frame.
  void place(int scan, const Eigen::Affine3d& placement);
  bool shut_down(std::chrono::milliseconds at_most);

 Q_SIGNALS:
  void placed(int old_scan, int new_scan);
  void failed(const QString& words);

 private:
  Document& document_;
  FillController& controller_;
  JobPtr job_;
  TaskRunner tasks_;
};

}  // namespace loopmend
