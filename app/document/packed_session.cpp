// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/packed_session.h"

#include "core/error.h"
#include "document/file_path.h"
#include "io/atomic_file.h"

#include <QDataStream>
#include <QDir>
#include <QFile>
#include <QFileInfo>

namespace loopmend {
namespace {

constexpr char packed_magic[] = "Loopmend packed session\n";
constexpr int packed_magic_size = sizeof packed_magic - 1;
constexpr qint32 version_of_packing = 1;
constexpr qint64 largest_file = qint64{1} << 30;  // QByteArray of Qt 5 counts in int
constexpr quint64 most_scans = 100000;

[[noreturn]] void fail(const QString& path, Message problem) {
  throw ReadError(file_path(path), std::move(problem), {},
                  say("Open the scan itself instead; the session file is damaged."));
}

void settle(QDataStream& stream) {
  stream.setVersion(QDataStream::Qt_5_15);
  stream.setByteOrder(QDataStream::LittleEndian);
}

}  // namespace

KeptFilePtr keep_file(const QString& path) {
  const QFileInfo info(path);
  if (info.suffix().compare(QLatin1String("gltf"), Qt::CaseInsensitive) == 0)
    throw InvalidArgument(
        say("%1 has its numbers in files beside it: export it as GLB, or save the session without scans",
            info.fileName().toStdString()));
  if (info.size() > largest_file)
    throw InvalidArgument(say("%1 is larger than 1 GB: save the session without scans, and keep the file beside it",
                              info.fileName().toStdString()));
  QFile file(path);
  if (!file.open(QIODevice::ReadOnly))
    throw ReadError(file_path(path), verbatim(file.errorString().toStdString()), {},
                    say("Check the path and its permissions."));
  return std::make_shared<const KeptFile>(KeptFile{info.fileName(), qCompress(file.readAll())});
}

QString lay_out(const KeptFile& file, const QString& folder) {
  const QByteArray bytes = qUncompress(file.compressed);
  if (bytes.isEmpty()) fail(file.name, say("the scan in the session cannot be unpacked"));
  // A name from a file must not lead out of the folder.
  const QString path = QDir(folder).filePath(QFileInfo(file.name).fileName());
  write_file_atomically(file_path(path), [&](std::ostream& out) { out.write(bytes.constData(), bytes.size()); });
  return path;
}

bool is_packed(const QByteArray& bytes) {
  return bytes.startsWith(QByteArray::fromRawData(packed_magic, packed_magic_size));
}

QByteArray pack(const QByteArray& session, const std::vector<KeptFilePtr>& files) {
  QByteArray bytes;
  QDataStream out(&bytes, QIODevice::WriteOnly);
  settle(out);
  out.writeRawData(packed_magic, packed_magic_size);
  out << version_of_packing << static_cast<quint64>(files.size());
  for (const KeptFilePtr& file : files)
    out << (file ? file->name : QString()) << (file ? file->compressed : QByteArray());
  out << session;
  return bytes;
}

UnpackedSession unpack(const QByteArray& bytes, const QString& path) {
  QDataStream in(bytes);
  settle(in);
  in.skipRawData(packed_magic_size);
  qint32 version = 0;
  quint64 count = 0;
  in >> version >> count;
  if (version != version_of_packing)
    throw ReadError(file_path(path), say("this session is of another version of Loopmend"), {},
                    say("Open it with the version that saved it."));
  if (count > most_scans) fail(path, say("the number of scans is out of range"));
  UnpackedSession unpacked;
  for (quint64 k = 0; k < count && in.status() == QDataStream::Ok; ++k) {
    KeptFile file;
    in >> file.name >> file.compressed;
    unpacked.files.push_back(file.compressed.isEmpty() ? nullptr : std::make_shared<const KeptFile>(std::move(file)));
  }
  in >> unpacked.session;
  if (in.status() != QDataStream::Ok) fail(path, say("the file ends too early"));
  if (!in.atEnd()) fail(path, say("there is more in the file than there should be"));
  return unpacked;
}

}  // namespace loopmend
