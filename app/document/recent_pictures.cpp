// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/recent_pictures.h"

#include <QCryptographicHash>
#include <QDateTime>
#include <QDir>
#include <QFileInfo>
#include <QSaveFile>
#include <QStandardPaths>

namespace loopmend {
namespace {

QDir folder() { return {QStandardPaths::writableLocation(QStandardPaths::CacheLocation) + QStringLiteral("/recent")}; }

QString name_of(const QString& path) {
  return QString::fromLatin1(QCryptographicHash::hash(path.toUtf8(), QCryptographicHash::Sha1).toHex()) +
         QStringLiteral(".png");
}

}  // namespace

void save_recent_picture(const QString& path, const QImage& picture) {
  const QSize size(144, 96);  // drawn at half of it, or whole on screens with small pixels
  if (picture.isNull() || !folder().mkpath(QStringLiteral("."))) return;
  const QImage scaled = picture.scaled(size, Qt::KeepAspectRatioByExpanding, Qt::SmoothTransformation);
  const QRect middle(QPoint((scaled.width() - size.width()) / 2, (scaled.height() - size.height()) / 2), size);
  QSaveFile file(folder().filePath(name_of(path)));
  if (file.open(QIODevice::WriteOnly) && scaled.copy(middle).save(&file, "PNG")) file.commit();
}

QImage recent_picture(const QString& path) {
  const QFileInfo picture(folder().filePath(name_of(path)));
  if (!picture.exists() || picture.lastModified() < QFileInfo(path).lastModified()) return {};
  return QImage(picture.filePath());
}

void keep_recent_pictures(const QStringList& paths) {
  QStringList kept;
  for (const QString& path : paths) kept << name_of(path);
  QDir all = folder();
  for (const QString& name : all.entryList({QStringLiteral("*.png")}, QDir::Files))
    if (!kept.contains(name)) all.remove(name);
}

}  // namespace loopmend
