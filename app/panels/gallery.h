// SPDX-License-Identifier: GPL-3.0-or-later
// Small pictures of the paper's examples; a click opens one.
#pragma once

#include "problems/paper_examples.h"

#include <QList>
#include <QWidget>

class QGridLayout;
class QToolButton;

namespace loopmend {

/// In the window's language.
QString example_name(const PaperExample& example);
QString example_title(const PaperExample& example);

class Gallery : public QWidget {
  Q_OBJECT

 public:
  explicit Gallery(QWidget* parent = nullptr);

  /// In as many columns as fit into so many pixels.
  void lay_out(int width);

 Q_SIGNALS:
  void example_wanted(const QString& id);

 private:
  void place(int columns);

  QGridLayout* grid_ = nullptr;
  QList<QToolButton*> buttons_;
  int columns_ = 0;
};

}  // namespace loopmend
