// SPDX-License-Identifier: GPL-3.0-or-later
// The gallery of the paper's examples: one click opens the input, a second runs it.
#pragma once

#include "jobs/fill_controller.h"
#include "problems/paper_examples.h"

#include <QObject>

namespace loopmend {

class Banner;
class CompareController;
class HoleSelection;
class MeshView;
class ToolController;

class ExampleController : public QObject {
  Q_OBJECT

 public:
  struct Parts {
    Document& document;
    HoleSelection& selection;
    FillController& controller;
    ToolController& tools;
    CompareController& comparisons;
    MeshView& view;
    Banner& banner;
  };
  ExampleController(const Parts& parts, QObject* parent);

  void open(const QString& id);
  void run(const QString& id);

 private:
  void on_made(const PaperExample& example, const std::vector<OpenedScanPtr>& scans);
  void fill_and_run();

  Parts parts_;
  JobPtr job_;
  TaskRunner tasks_;
};

}  // namespace loopmend
