// SPDX-License-Identifier: GPL-3.0-or-later
// A line over the top of the picture that says what went wrong, or right. It stops nothing, and moves nothing. Words wrap, and
// what is too long to wrap, such as a file name, is shortened in its middle: the tooltip has it whole.
#pragma once

#include <QFrame>
#include <QTimer>

#include <functional>
#include <vector>

class QGridLayout;
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
  /// Something that helps, which nothing waits for: the keys stay where they are.
  void offer(const QString& words, std::vector<Answer> answers);
  /// What it says, nothing shortened.
  QString text() const { return text_; }

 Q_SIGNALS:
  void covered(int height);  ///< of what it lies over
  void changed();            ///< it says something else, or nothing

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
  void showEvent(QShowEvent* event) override;
  void hideEvent(QHideEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  void settle();
  void fit_words();
  enum class Tone { problem, notice, question };
  void drop_answers();
  void add_answers(std::vector<Answer> answers);
  void show_words(const QString& words, Tone tone);

  QLabel* sign_;
  QLabel* words_;
  QToolButton* close_;
  QWidget* answer_row_;
  QGridLayout* layout_;
  QString text_;
  std::vector<QPushButton*> answers_;
  QTimer timer_;
};

}  // namespace loopmend
