// SPDX-License-Identifier: GPL-3.0-or-later
// Under the table of holes: what was found about the patch of the selected hole, and what can be done. Its height does not
// depend on the text.
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

 private:
  int height_of(int line_count) const;
  void update_text();
  QString text_of_selection() const;

  const Document& document_;
  const HoleSelection& selection_;
  QLabel* label_;
  QTimer soon_;
};

}  // namespace loopmend
