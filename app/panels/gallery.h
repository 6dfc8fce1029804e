// SPDX-License-Identifier: GPL-3.0-or-later
// Small pictures of the paper's examples; a click opens one.
#pragma once

#include "problems/paper_examples.h"

#include <QWidget>

namespace loopmend {

/// In the window's language.
QString example_name(const PaperExample& example);
QString example_title(const PaperExample& example);

class Gallery : public QWidget {
  Q_OBJECT

 public:
  explicit Gallery(QWidget* parent = nullptr);

 Q_SIGNALS:
  void example_wanted(const QString& id);
};

}  // namespace loopmend
