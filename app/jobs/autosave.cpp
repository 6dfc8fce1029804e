// SPDX-License-Identifier: GPL-3.0-or-later
#include "jobs/autosave.h"

#include <QCoreApplication>
#include <QDateTime>
#include <QDir>
#include <QFileInfo>
#include <QLocale>
#include <QStandardPaths>
#include <QUuid>

namespace loopmend {
namespace {

QDir folder() {
  return QDir(QStandardPaths::writableLocation(QStandardPaths::GenericDataLocation) +
              QStringLiteral("/loopmend/recovery"));
}

QString lock_path(const QString& path) { return path + QStringLiteral(".lock"); }

}  // namespace

Autosave::Autosave(const Document& document, const UndoHistory& undo, QObject* parent)
    : QObject(parent),
      document_(document),
      undo_(undo) {
  timer_.setSingleShot(true);
  set_delay(20);
  connect(&timer_, &QTimer::timeout, this, &Autosave::write);
  connect(&document, &Document::patches_changed, this, &Autosave::change_soon);
  connect(&document, &Document::patch_moved, this, &Autosave::change_soon);
  connect(&document, &Document::scans_changed, this, &Autosave::change_soon);
  connect(&undo, &UndoHistory::changed, this, &Autosave::change_soon);
}

void Autosave::set_delay(int seconds) { timer_.setInterval(seconds * 1000); }

void Autosave::change_soon() {
  // Not started again by each change: a flow that runs for an hour is saved on the way.
  if (!timer_.isActive() && document_.has_scan()) timer_.start();
}

void Autosave::write() {
  if (!document_.has_work() || undo_.is_saved()) {
    finish();
    return;
  }
  if (path_.isEmpty()) {
    const QDir at = folder();
    at.mkpath(QStringLiteral("."));
    path_ = at.filePath(QUuid::createUuid().toString(QUuid::WithoutBraces) + QLatin1Char('.') +
                        QLatin1String(session_suffix));
    lock_ = std::make_unique<QLockFile>(lock_path(path_));
    lock_->setStaleLockTime(0);
    lock_->tryLock(0);
  }
  drop(job_);
  job_ = std::make_shared<Job>(this);
  const auto work = [this, job = job_, session = session_of(document_, view_, most_recorded_in_copy), path = path_] {
    const bool whole = writing_.take(*job, [&] {
      write_session(session, path, job->token());
      return true;
    });
    if (!whole) return;
    job->post([this] {
      failure_told_ = false;
      for (const Leftover& leftover : std::exchange(taken_over_, {})) discard(leftover);
      Q_EMIT written();
    });
  };
  tasks_.start(job_, work, [this](const QString& words) {
    if (!std::exchange(failure_told_, true))
      Q_EMIT failed(tr("The copy that would survive a crash could not be written: %1").arg(words));
  });
}

void Autosave::take_over(const Leftover& leftover) {
  taken_over_.push_back(leftover);
  timer_.stop();
  write();
}

void Autosave::finish() {
  timer_.stop();
  if (path_.isEmpty()) return;
  tasks_.stop(std::chrono::seconds(2));
  QFile::remove(path_);
  lock_.reset();
  path_.clear();
}

QString Autosave::place() { return folder().path(); }

std::vector<Leftover> Autosave::leftovers() {
  std::vector<Leftover> found;
  const QDir at = folder();
  for (const QFileInfo& file :
       at.entryInfoList({QStringLiteral("*.") + QLatin1String(session_suffix)}, QDir::Files, QDir::Time)) {
    QLockFile lock(lock_path(file.filePath()));
    lock.setStaleLockTime(0);
    if (!lock.tryLock(0)) continue;  // its program is alive
    lock.unlock();
    Leftover leftover{file.filePath(), {}};
    try {
      const Session session = session_from_file(file.filePath());
      QStringList names;
      for (const SessionScan& scan : session.scans)
        names << (scan.made ? scan.name : scan.path.isEmpty() ? tr("Sample") : QFileInfo(scan.path).fileName());
      leftover.words =
          tr("%1, %Ln patch(es), %2", nullptr, static_cast<int>(session.patches.size()))
              .arg(names.join(QStringLiteral(", ")), QLocale().toString(file.lastModified(), QLocale::ShortFormat));
    } catch (const std::exception&) {
      continue;  // of another version, or damaged: not ours to throw away
    }
    found.push_back(std::move(leftover));
  }
  return found;
}

void Autosave::discard(const Leftover& leftover) {
  QFile::remove(leftover.path);
  QFile::remove(lock_path(leftover.path));
}

}  // namespace loopmend
