// SPDX-License-Identifier: GPL-3.0-or-later
// Under the table of holes: what was found about the patch of the selected hole, and what can be done. Its height does not
// depend on the text; before anything can be judged it is low.
#pragma once

#include <QScrollArea>
#include <QTimer>

class QLabel;

namespace loopmend {

class Document;
class HoleSelection;

class VerdictBox : public QScrollArea {
  Q_OBJECT

 public:
  VerdictBox(const Document& document, const HoleSelection& selection, QWidget* parent = nullptr);
  QString text() const;
  QSize sizeHint() const override;
  /// By how much it is lower than it will be, pixels.
  int spare_height() const;

 Q_SIGNALS:
  void spare_height_changed();

 private:
  int height_of(int line_count) const;
  void update_text();
  void update_height();
  QString text_of_selection() const;

  const Document& document_;
  const HoleSelection& selection_;
  QLabel* label_;
  QTimer soon_;
};

}  // namespace loopmend
