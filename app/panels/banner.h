// SPDX-License-Identifier: GPL-3.0-or-later
// A line over the top of the picture that says what went wrong, or right. It stops nothing, and moves nothing.
#pragma once

#include <QFrame>
#include <QTimer>

#include <functional>
#include <vector>

class QHBoxLayout;
class QLabel;
class QPushButton;
class QToolButton;

namespace loopmend {

class Banner : public QFrame {
  Q_OBJECT

 public:
  /// Lies over the top of its parent.
  explicit Banner(QWidget* parent);

  /// Stays until it is closed or another one comes.
  void show_problem(const QString& words);
  /// Goes by itself after a while.
  void show_notice(const QString& words);
  struct Answer {
    QString text;
    const char* name;  ///< of the button, for tests
    std::function<void()> act;
  };
  /// A question in place: the person may go on with something else meanwhile. Closing it means none of the answers.
  void ask(const QString& words, std::vector<Answer> answers);
  QString text() const;

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void settle();
  enum class Tone { problem, notice, question };
  void drop_answers();
  void show_words(const QString& words, Tone tone);

  QLabel* sign_;
  QLabel* words_;
  QToolButton* close_;
  QHBoxLayout* layout_;
  std::vector<QPushButton*> answers_;
  QTimer timer_;
};

}  // namespace loopmend
