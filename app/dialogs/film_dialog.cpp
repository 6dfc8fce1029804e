// SPDX-License-Identifier: GPL-3.0-or-later
#include "dialogs/film_dialog.h"

#include "document/file_path.h"
#include "panels/parts.h"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QDir>
#include <QFileDialog>
#include <QFormLayout>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>

namespace loopmend {
namespace {

/// Pictures that the colors are chosen by: of the first state, one in the middle, and the last.
constexpr std::size_t film_samples = 3;

RgbPicture film_picture_of(const QImage& image) {
  const QImage rgb = image.convertToFormat(QImage::Format_RGB888);
  RgbPicture picture{rgb.width(), rgb.height(), {}};
  for (int y = 0; y < rgb.height(); ++y) {
    const uchar* line = rgb.constScanLine(y);
    picture.bytes.insert(picture.bytes.end(), line, line + std::ptrdiff_t{3} * rgb.width());
  }
  return picture;
}

}  // namespace

FilmDialog::FilmDialog(FilmSource source, QWidget* parent) : QDialog(parent), source_(std::move(source)) {
  setObjectName(QStringLiteral("filmDialog"));
  setWindowTitle(tr("Film of the flow"));
  setWindowModality(Qt::WindowModal);  // the camera stands still meanwhile
  build();
  clock_.setInterval(5);
  connect(&clock_, &QTimer::timeout, this, &FilmDialog::draw_next);
}

FilmDialog::~FilmDialog() { stop(); }

void FilmDialog::build() {
  size_ = new QComboBox;
  explain(size_, "filmSize", tr("Size"), tr("How many pixels each picture has"));
  for (const int height : {360, 480, 720}) {
    const QSize size(height * source_.seen.width() / std::max(1, source_.seen.height()), height);
    size_->addItem(tr("%1 \u00d7 %2 pixels").arg(size.width()).arg(size.height()), size);
  }
  size_->setCurrentIndex(1);
  rate_ = new QComboBox;
  rate_->setObjectName(QStringLiteral("filmRate"));
  explain(rate_, tr("Speed"), tr("How many states are shown in a second"));
  rate_->addItem(tr("By the number of states"), 0.0);
  for (const double rate : {1.0, 2.0, 4.0, 10.0, 25.0}) rate_->addItem(tr("%1 a second").arg(rate), rate);
  length_ = new QComboBox;
  length_->setObjectName(QStringLiteral("filmLength"));
  explain(length_, tr("Length"), tr("A film that would be shorter shows each state for longer"));
  length_->addItem(tr("As it comes"), 0.0);
  for (const double seconds : {10.0, 20.0, 30.0})
    length_->addItem(tr("At least %1 seconds").arg(seconds), seconds);
  auto* about = new QLabel(tr("The view as it is now, through %Ln state(s) of the flow.", nullptr,
                              static_cast<int>(states_of_film(source_.states).size())));
  about->setWordWrap(true);
  progress_ = new QProgressBar;
  explain(progress_, "filmProgress", tr("Pictures drawn"), tr("How many of the film's pictures are drawn"));
  progress_->setVisible(false);
  fault_ = new QLabel;
  fault_->setObjectName(QStringLiteral("filmTrouble"));
  fault_->setWordWrap(true);
  fault_->hide();
  auto* buttons = new QDialogButtonBox;
  save_ = make_button("filmSave", tr("&Save\u2026"), tr("Choose a file and write the film, an animated GIF"));
  save_->setDefault(true);
  buttons->addButton(save_, QDialogButtonBox::AcceptRole);
  buttons->addButton(QDialogButtonBox::Cancel)->setObjectName(QStringLiteral("filmCancel"));
  connect(save_, &QPushButton::clicked, this, &FilmDialog::ask_and_save);
  connect(buttons, &QDialogButtonBox::rejected, this, &FilmDialog::reject);
  auto* form = new QFormLayout(this);
  form->setContentsMargins(18, 18, 18, 14);
  form->setVerticalSpacing(10);
  form->addRow(about);
  form->addRow(tr("Si&ze"), size_);
  form->addRow(tr("S&peed"), rate_);
  form->addRow(tr("&Length"), length_);
  form->addRow(progress_);
  form->addRow(fault_);
  form->addRow(buttons);
}

QSize FilmDialog::wanted_size() const { return size_->currentData().toSize(); }

FilmPace FilmDialog::wanted_pace() const {
  return {rate_->currentData().toDouble(), length_->currentData().toDouble()};
}

void FilmDialog::ask_and_save() {
  QString path =
      QFileDialog::getSaveFileName(this, tr("Film of the flow"), QStringLiteral("loopmend.gif"), tr("GIF (*.gif)"));
  if (path.isEmpty()) return;
  if (QFileInfo(path).suffix().isEmpty()) path += QStringLiteral(".gif");
  save(path);
}

void FilmDialog::save(const QString& path) {
  if (busy() || source_.states == 0) return;
  path_ = path;
  pixels_ = wanted_size();
  shown_ = states_of_film(source_.states);
  durations_ = film_durations(shown_.size(), wanted_pace());
  samples_.clear();
  drawn_ = 0;
  writing_ = nullptr;
  job_ = std::make_shared<Job>(this);
  fault_->hide();
  progress_->setRange(0, static_cast<int>(film_samples + shown_.size()));
  progress_->setValue(0);
  progress_->show();
  save_->setEnabled(false);
  for (QComboBox* box : {size_, rate_, length_}) box->setEnabled(false);
  clock_.start();
}

/// One picture at a time: between two of them the window answers.
void FilmDialog::draw_next() {
  if (writing_ && !writing_->has_room()) return;
  const bool sample = samples_.size() < film_samples;
  const std::size_t at = sample ? samples_.size() * (shown_.size() - 1) / (film_samples - 1) : drawn_;
  const QImage image = source_.draw(shown_[at], pixels_);
  if (image.isNull()) return fail(tr("The graphics cannot draw a picture of this size. Choose a smaller one."));
  progress_->setValue(progress_->value() + 1);
  if (sample) {
    samples_.push_back(film_picture_of(image));
    if (samples_.size() == film_samples) begin_writing();
    return;
  }
  writing_->put({film_picture_of(image), durations_[at]});
  if (++drawn_ < shown_.size()) return;
  writing_->end();
  clock_.stop();
}

void FilmDialog::begin_writing() {
  writing_ = std::make_shared<FilmWriting>();
  runner_.run(
      job_,
      [job = job_, writing = writing_, path = file_path(path_), samples = samples_] {
        return writing->write(path, samples, job->token());
      },
      [this](bool written) {
        stop();
        if (!written) return;
        Q_EMIT saved(QDir::toNativeSeparators(path_));
        accept();
      },
      [this](const QString& words) { fail(words); });
}

void FilmDialog::stop() {
  clock_.stop();
  drop(job_);
  if (writing_) writing_->end();
  progress_->hide();
  save_->setEnabled(true);
  for (QComboBox* box : {size_, rate_, length_}) box->setEnabled(true);
}

void FilmDialog::fail(const QString& words) {
  stop();
  fault_->setText(words);
  fault_->show();
}

void FilmDialog::reject() {
  if (!busy()) return QDialog::reject();
  stop();
}

}  // namespace loopmend
