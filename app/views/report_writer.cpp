// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/report_writer.h"

#include "document/file_path.h"
#include "jobs/write_report.h"
#include "views/mesh_view.h"

#include <QDir>
#include <QFileDialog>
#include <QFileInfo>

#include <algorithm>

namespace loopmend {
namespace {

/// Of a report with a thousand holes, those to look at first have a picture.
constexpr std::size_t most_pictures = 200;

/// The patch of the hole from above, as the view colours it.
QImage picture_of_hole(MeshView& view, int loop) {
  constexpr int supersampling = 2;  // the graphics do not smooth edges
  const QSize size(720, 480);
  const Viewpoint before = view.viewpoint();
  view.set_viewpoint(view.viewpoint_above(loop));
  const QImage picture =
      view.picture({supersampling * size, PictureOptions::Ground::as_seen, PictureOptions::Extras::legend});
  view.set_viewpoint(before);
  return picture.isNull() ? picture : picture.scaled(size, Qt::IgnoreAspectRatio, Qt::SmoothTransformation);
}

}  // namespace

ReportWriter::ReportWriter(const Document& document, MeshView& view, QWidget* window)
    : QObject(window),
      document_(document),
      view_(view),
      window_(window) {
  clock_.setInterval(5);
  connect(&clock_, &QTimer::timeout, this, &ReportWriter::draw_next);
}

ReportWriter::~ReportWriter() { stop(); }

void ReportWriter::ask(const QString& proposal) {
  QString filter;
  QString path =
      QFileDialog::getSaveFileName(window_, tr("Report"), proposal, tr("Web page (*.html);;PDF (*.pdf)"), &filter);
  if (path.isEmpty()) return;
  if (QFileInfo(path).suffix().isEmpty())
    path += filter.contains(QLatin1String("pdf")) ? QStringLiteral(".pdf") : QStringLiteral(".html");
  write(path);
}

void ReportWriter::write(const QString& path) {
  if (busy() || !document_.has_scan()) return;
  path_ = path;
  report_ = fill_report(document_);
  drawn_ = 0;
  const auto pictures = static_cast<int>(std::min(report_.holes.size(), most_pictures));
  progress_ = std::make_unique<QProgressDialog>(tr("Drawing the holes\u2026"), tr("Cancel"), 0, pictures + 1, window_);
  progress_->setObjectName(QStringLiteral("reportProgress"));
  progress_->setWindowTitle(tr("Report"));
  progress_->setWindowModality(Qt::WindowModal);  // the scene stands still meanwhile
  progress_->setAutoReset(false);
  connect(progress_.get(), &QProgressDialog::canceled, this, &ReportWriter::stop);
  clock_.start();
}

void ReportWriter::draw_next() {
  if (drawn_ == std::min(report_.holes.size(), most_pictures)) return begin_writing();
  FillReport::Hole& hole = report_.holes[drawn_++];
  hole.picture = picture_of_hole(view_, hole.loop);
  progress_->setValue(static_cast<int>(drawn_));
}

void ReportWriter::begin_writing() {
  clock_.stop();
  if (report_.holes.size() > most_pictures)
    report_.facts << tr("The first %1 holes have a picture.").arg(most_pictures);
  job_ = std::make_shared<Job>(this);
  tasks_.run(
      job_,
      [path = file_path(path_), report = report_] {
        write_report(path, report);
        return 0;
      },
      [this](int) {
        stop();
        Q_EMIT written(QDir::toNativeSeparators(path_));
      },
      [this](const QString& words) {
        stop();
        Q_EMIT failed(words);
      });
}

void ReportWriter::stop() {
  clock_.stop();
  if (job_) job_->cancel();
  job_.reset();
  if (progress_) progress_.release()->deleteLater();
  report_ = {};
}

bool ReportWriter::shut_down(std::chrono::milliseconds at_most) {
  stop();
  return tasks_.wait(at_most);
}

}  // namespace loopmend
