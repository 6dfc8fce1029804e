// SPDX-License-Identifier: GPL-3.0-or-later
// Small pictures of the files that were opened lately, in the user's cache.
#pragma once

#include <QImage>
#include <QString>
#include <QStringList>

namespace loopmend {

/// Makes it small. What cannot be written is left out: nothing depends on it.
void save_recent_picture(const QString& path, const QImage& picture);
/// Null: there is none, or the file has changed since.
QImage recent_picture(const QString& path);
/// Those of all other files go.
void keep_recent_pictures(const QStringList& paths);

}  // namespace loopmend
