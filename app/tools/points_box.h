// SPDX-License-Identifier: GPL-3.0-or-later
// The part of the tools dock for a surface through points.
#pragma once

#include "filling/subdivide_polyhedron.h"
#include "tools/points_tool.h"

#include <QWidget>

class QCheckBox;
class QComboBox;
class QLabel;
class QPushButton;
class QRadioButton;
class QSpinBox;

namespace loopmend {

class PointsBox : public QWidget {
  Q_OBJECT

 public:
  PointsBox(const Document& document, PointsTool& tool, QWidget* parent = nullptr);

  SubdivisionOptions options() const;
  QString wanting() const;

 Q_SIGNALS:
  void changed();

 private:
  void follow_scans();
  void update_state();

  const Document& document_;
  PointsTool& tool_;
  QComboBox* scan_;
  QRadioButton *all_, *picked_;
  QPushButton* clear_;
  QSpinBox* subdivide_;
  QCheckBox* open_;
  QLabel *count_, *size_;
};

}  // namespace loopmend
