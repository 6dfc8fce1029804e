// A line at the top of the picture that says what went wrong, or right. Never in the way: it does not stop anything.
#pragma once

#include <QFrame>
#include <QTimer>

class QLabel;
class QToolButton;

namespace loopmend {

class Banner : public QFrame {
  Q_OBJECT

 public:
  explicit Banner(QWidget* parent = nullptr);

  /// Stays until it is closed or another one comes.
  void show_problem(const QString& words);
  /// Goes by itself after a while.
  void show_notice(const QString& words);
  QString text() const;

 private:
  enum class Tone { problem, notice };
  void show_words(const QString& words, Tone tone);

  QLabel* sign_;
  QLabel* words_;
  QToolButton* close_;
  QTimer timer_;
};

}  // namespace loopmend
