// SPDX-License-Identifier: GPL-3.0-or-later
// "Fill all up to ...": closes every hole below a size in one go, and says before how many that are.
#pragma once

#include "document/targets.h"

#include <QWidget>

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QPushButton;

namespace loopmend {

class SmallHolesBox : public QWidget {
  Q_OBJECT

 public:
  explicit SmallHolesBox(Document& document, QWidget* parent = nullptr);

  enum class Use { possible, busy };
  void set_use(Use use);

 Q_SIGNALS:
  void fill_wanted(const std::set<int>& loops);

 private:
  void build();
  void propose_limit();
  void update_state();
  SizeMeasure measure() const;
  std::set<int> meant() const;

  Document& document_;
  QDoubleSpinBox* limit_ = nullptr;
  QComboBox* measure_ = nullptr;
  QPushButton* fill_ = nullptr;
  QCheckBox* outer_rims_ = nullptr;
  Use use_ = Use::possible;
};

}  // namespace loopmend
