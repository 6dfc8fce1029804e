// SPDX-License-Identifier: GPL-3.0-or-later
// The right dock: fill, smooth by a flow, look back and decide. What runs, and its Cancel, never scroll away.
#pragma once

#include <QWidget>

class QScrollArea;

namespace loopmend {

class DecisionBox;
class Document;
class FillBox;
class FlowBox;
class HoleSelection;
class FillController;

class PatchPanel : public QWidget {
  Q_OBJECT

 public:
  PatchPanel(const Document& document, const HoleSelection& selection, FillController& controller,
             QWidget* parent = nullptr);

  FillBox& fill_box() { return *fill_; }
  FlowBox& flow_box() { return *flow_; }
  DecisionBox& decision_box() { return *decision_; }

 Q_SIGNALS:
  /// What the buttons can do is another.
  void updated();

 private:
  void update_state();
  void scroll_to_step();

  const Document& document_;
  const HoleSelection& selection_;
  QScrollArea* scroll_;
  FillBox* fill_;
  FlowBox* flow_;
  DecisionBox* decision_;
};

}  // namespace loopmend
