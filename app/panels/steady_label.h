// SPDX-License-Identifier: GPL-3.0-or-later
// Text of changing length above things that must stay where they are.
#pragma once

#include <QLabel>
#include <QStringList>

namespace loopmend {

class SteadyLabel : public QLabel {
  Q_OBJECT

 public:
  explicit SteadyLabel(const QString& text = {}, QWidget* parent = nullptr);

  /// As high as the highest of these and of its own.
  void keep_room_for(const QStringList& texts);
  int heightForWidth(int width) const override;

 private:
  QStringList texts_;
};

}  // namespace loopmend
