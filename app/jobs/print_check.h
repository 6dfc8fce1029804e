// SPDX-License-Identifier: GPL-3.0-or-later
// Whether what is on the screen could be printed: looked for beside other work, whenever the scene has changed.
#pragma once

#include "document/document.h"
#include "jobs/fill_controller.h"
#include "jobs/task_runner.h"
#include "repair/watertight.h"

#include <QObject>
#include <QTimer>

#include <optional>

namespace loopmend {

class PrintCheck : public QObject {
  Q_OBJECT

 public:
  PrintCheck(const Document& document, const FillController& controller, QObject* parent = nullptr);

  /// Nothing while it is looked for, or where the scene is too large to be looked at unasked.
  const std::optional<Watertightness>& result() const { return result_; }
  bool is_running() const { return job_ != nullptr; }
  /// Also of a large scene. changed() comes when it is known.
  void start();
  /// For the end of the program. @returns whether every worker has ended.
  bool shut_down(std::chrono::milliseconds at_most);

  static constexpr std::size_t most_triangles_unasked = 2'000'000;

 Q_SIGNALS:
  void changed();

 private:
  void forget();
  void start_unasked();

  const Document& document_;
  const FillController& controller_;
  TaskRunner tasks_{Yielding::as_it_can};
  JobPtr job_;
  QTimer leisure_;
  std::optional<Watertightness> result_;
};

}  // namespace loopmend
