// SPDX-License-Identifier: GPL-3.0-or-later
// Draws the pictures of a report, one between two looks at the window's events, and has it written.
#pragma once

#include "document/fill_report.h"
#include "jobs/task_runner.h"

#include <QObject>
#include <QProgressDialog>
#include <QTimer>

#include <memory>

namespace loopmend {

class MeshView;
class SceneVisibility;

class ReportWriter : public QObject {
  Q_OBJECT

 public:
  ReportWriter(const Document& document, const SceneVisibility& visibility, MeshView& view, QWidget* window);
  ~ReportWriter() override;

  /// Asks for the name of the file.
  void ask(const QString& proposal);
  void write(const QString& path);
  bool busy() const { return progress_ != nullptr; }
  bool shut_down(std::chrono::milliseconds at_most);

 Q_SIGNALS:
  void written(const QString& path);
  void failed(const QString& words);

 private:
  void draw_next();
  void begin_writing();
  void stop();
  void stop_drawing();

  const Document& document_;
  const SceneVisibility& visibility_;
  MeshView& view_;
  QWidget* window_;
  std::unique_ptr<QProgressDialog> progress_;
  QTimer clock_;
  FillReport report_;
  std::size_t drawn_ = 0;
  QString path_;
  JobPtr job_;
  WriteTurns writing_;
  TaskRunner tasks_;
};

}  // namespace loopmend
