// What the middle says while nothing is open.
#pragma once

#include <QWidget>

namespace loopmend {

class Welcome : public QWidget {
  Q_OBJECT

 public:
  explicit Welcome(QWidget* parent = nullptr);

 Q_SIGNALS:
  void open_wanted();
  void sample_wanted();
};

}  // namespace loopmend
