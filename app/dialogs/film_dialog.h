// SPDX-License-Identifier: GPL-3.0-or-later
// A film of the flow: how large, how far it is, and a button that gives it up.
#pragma once

#include "jobs/film_writing.h"
#include "jobs/task_runner.h"

#include <QDialog>
#include <QImage>
#include <QTimer>

#include <functional>

class QComboBox;
class QLabel;
class QProgressBar;
class QPushButton;

namespace loopmend {

/// What a film is made of.
struct FilmSource {
  std::size_t states = 0;
  QSize seen;  ///< of the view, logical pixels
  /// Of one state. A null image when the graphics cannot.
  std::function<QImage(std::size_t state, const QSize& pixels)> draw;
};

class FilmDialog : public QDialog {
  Q_OBJECT

 public:
  explicit FilmDialog(FilmSource source, QWidget* parent = nullptr);
  ~FilmDialog() override;

  /// Begins to write; saved() reports its end, and a line in the dialog a failure.
  void save(const QString& path);
  bool busy() const { return job_ != nullptr; }

 Q_SIGNALS:
  void saved(const QString& path);

 protected:
  void reject() override;

 private:
  void build();
  QSize wanted_size() const;
  FilmPace wanted_pace() const;
  void ask_and_save();
  void draw_next();
  void begin_writing();
  void stop();
  void fail(const QString& words);

  FilmSource source_;
  QComboBox *size_ = nullptr, *rate_ = nullptr, *length_ = nullptr;
  QLabel* fault_ = nullptr;
  QProgressBar* progress_ = nullptr;
  QPushButton* save_ = nullptr;
  QTimer clock_;
  QString path_;
  QSize pixels_;
  std::vector<std::size_t> shown_;
  std::vector<int> durations_;
  std::vector<RgbPicture> samples_;
  std::size_t drawn_ = 0;
  std::shared_ptr<FilmWriting> writing_;
  JobPtr job_;
  TaskRunner runner_;
};

}  // namespace loopmend
