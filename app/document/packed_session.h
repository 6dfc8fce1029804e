// SPDX-License-Identifier: GPL-3.0-or-later
// A session that holds the files of its scans, compressed, so that it needs nothing beside it.
#pragma once

#include <QByteArray>
#include <QString>

#include <memory>
#include <vector>

namespace loopmend {

/// A scan's file as it was read: every byte of it.
struct KeptFile {
  QString name;           ///< without its folder
  QByteArray compressed;  ///< by qCompress
};
using KeptFilePtr = std::shared_ptr<const KeptFile>;

/// @throws ReadError where it cannot be read; InvalidArgument where it is too large, or of a kind whose content lies in other
/// files (glTF text).
KeptFilePtr keep_file(const QString& path);

/// Writes the file into this folder. @returns its path. @throws ReadError where it is damaged, WriteError.
QString lay_out(const KeptFile& file, const QString& folder);

bool is_packed(const QByteArray& bytes);
/// @param files  one for each scan of the session; null: its file lies elsewhere
QByteArray pack(const QByteArray& session, const std::vector<KeptFilePtr>& files);

struct UnpackedSession {
  QByteArray session;
  std::vector<KeptFilePtr> files;
};
/// @param path  for messages. @throws ReadError
UnpackedSession unpack(const QByteArray& bytes, const QString& path);

}  // namespace loopmend
