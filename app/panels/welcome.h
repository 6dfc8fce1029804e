// SPDX-License-Identifier: GPL-3.0-or-later
// What the middle says while nothing is open.
#pragma once

#include <QStringList>
#include <QWidget>

class QVBoxLayout;

namespace loopmend {

class Gallery;

class Welcome : public QWidget {
  Q_OBJECT

 public:
  explicit Welcome(QWidget* parent = nullptr);

  void show_recent(const QStringList& files);

 Q_SIGNALS:
  void file_wanted(const QString& path);
  void open_wanted();
  void sample_wanted();
  void example_wanted(const QString& id);

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  Gallery* gallery_ = nullptr;
  QWidget* recent_ = nullptr;
  QVBoxLayout* recent_layout_ = nullptr;
};

}  // namespace loopmend
