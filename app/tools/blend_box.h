// SPDX-License-Identifier: GPL-3.0-or-later
// The part of the tools dock that joins loops, and places parts before.
#pragma once

#include "document/hole_selection.h"
#include "tools/part_tool.h"

#include <QWidget>

class QComboBox;
class QDoubleSpinBox;
class QLabel;
class QPushButton;

namespace loopmend {

class BlendBox : public QWidget {
  Q_OBJECT

 public:
  BlendBox(const Document& document, const HoleSelection& selection, PartTool& tool, QWidget* parent = nullptr);

  /// Those selected, in the order of the table.
  std::vector<int> loops() const;
  double density() const;
  QString wanting() const;
  /// Parts came or went, or another one has the handle.
  void follow() { follow_scans(); }

 Q_SIGNALS:
  void changed();
  void select_facing_wanted();

 private:
  void follow_scans();
  void update_state();

  const Document& document_;
  const HoleSelection& selection_;
  PartTool& tool_;
  QLabel* chosen_;
  QPushButton* facing_;
  QDoubleSpinBox* density_;
  QComboBox* part_;
};

}  // namespace loopmend
