// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/report_writer.h"

#include "document/file_path.h"
#include "document/labels.h"
#include "document/scene_visibility.h"
#include "jobs/write_report.h"
#include "views/film_source.h"
#include "views/mesh_view.h"

#include <QDir>
#include <QFileDialog>
#include <QFileInfo>

#include <algorithm>

namespace loopmend {
namespace {

/// Of a report with a thousand holes, those to look at first have a picture.
constexpr std::size_t most_pictures = 200;

/// The patch of the hole from above, as the view colours it, with the hole's outline.
QImage picture_of_hole(MeshView& view, int loop) {
  constexpr int supersampling = 2;  // the graphics do not smooth edges
  const QSize size(720, 480);
  const Viewpoint before = view.viewpoint();
  view.set_viewpoint(view.viewpoint_above(loop));
  const QImage picture =
      view.picture({supersampling * size, PictureOptions::Ground::as_seen, PictureOptions::Extras::none, loop});
  view.set_viewpoint(before);
  return picture.isNull() ? picture : picture.scaled(size, Qt::IgnoreAspectRatio, Qt::SmoothTransformation);
}

}  // namespace

ReportWriter::ReportWriter(const Document& document, const SceneVisibility& visibility, MeshView& view, QWidget* window)
    : QObject(window),
      document_(document),
      visibility_(visibility),
      view_(view),
      window_(window) {
  clock_.setInterval(5);
  connect(&clock_, &QTimer::timeout, this, &ReportWriter::draw_next);
  for (auto signal : {&Document::opened, &Document::scans_changed, &Document::patches_changed})
    connect(&document_, signal, this, &ReportWriter::stop_drawing);
}

ReportWriter::~ReportWriter() { stop(); }

void ReportWriter::ask(const QString& proposal) {
  QFileDialog dialog(window_, tr("Report"), QFileInfo(proposal).path(), tr("Web page (*.html);;PDF (*.pdf)"));
  dialog.setAcceptMode(QFileDialog::AcceptSave);
  dialog.setDefaultSuffix(QStringLiteral("html"));
  dialog.selectFile(QFileInfo(proposal).fileName());
  connect(&dialog, &QFileDialog::filterSelected, &dialog, [&dialog](const QString& filter) {
    const bool pdf = filter.contains(QLatin1String("*.pdf"));
    dialog.setDefaultSuffix(pdf ? QStringLiteral("pdf") : QStringLiteral("html"));
    const QString chosen = QFileInfo(dialog.selectedFiles().value(0)).completeBaseName();
    dialog.selectFile(chosen + QLatin1Char('.') + dialog.defaultSuffix());
  });
  if (dialog.exec() == QDialog::Accepted && !dialog.selectedFiles().isEmpty()) write(dialog.selectedFiles().first());
}

void ReportWriter::write(const QString& path) {
  if (busy() || !document_.has_scan()) return;
  path_ = path;
  report_ = fill_report(document_);
  if (const Shading shading = view_.look().shading; is_colored(shading))
    report_.facts << tr("Colours: %1, up to %2 at the ends.").arg(shown_by(shading), labels::number(view_.range()));
  drawn_ = 0;
  const auto pictures = static_cast<int>(std::min(report_.holes.size(), most_pictures));
  progress_ = std::make_unique<QProgressDialog>(tr("Drawing the holes\u2026"), tr("Cancel"), 0, pictures + 1, window_);
  progress_->setObjectName(QStringLiteral("reportProgress"));
  progress_->setWindowTitle(tr("Report"));
  progress_->setWindowModality(Qt::WindowModal);
  progress_->setMinimumDuration(0);
  progress_->setAutoReset(false);
  connect(progress_.get(), &QProgressDialog::canceled, this, &ReportWriter::stop);
  progress_->show();
  clock_.start();
}

void ReportWriter::draw_next() {
  if (drawn_ == std::min(report_.holes.size(), most_pictures)) return begin_writing();
  FillReport::Hole& hole = report_.holes[drawn_++];
  if (!visibility_.is_hidden_loop(hole.loop)) hole.picture = picture_of_hole(view_, hole.loop);
  progress_->setValue(static_cast<int>(drawn_));
}

void ReportWriter::begin_writing() {
  clock_.stop();
  if (report_.holes.size() > most_pictures)
    report_.facts << tr("The first %1 holes have a picture.").arg(most_pictures);
  job_ = std::make_shared<Job>(this);
  tasks_.run(
      job_,
      [this, job = job_, path = file_path(path_), report = report_] {
        return writing_.take(*job, [&] { return write_report(path, report, job->token()); });
      },
      [this](bool done) {
        stop();
        if (done) Q_EMIT written(QDir::toNativeSeparators(path_));
      },
      [this](const QString& words) {
        stop();
        Q_EMIT failed(words);
      });
}

/// The scene is another one: its pictures would show what the text does not say.
void ReportWriter::stop_drawing() {
  if (clock_.isActive()) stop();
}

void ReportWriter::stop() {
  clock_.stop();
  drop(job_);
  if (progress_) progress_.release()->deleteLater();
  report_ = {};
}

bool ReportWriter::shut_down(std::chrono::milliseconds at_most) {
  stop();
  return tasks_.wait(at_most);
}

}  // namespace loopmend
