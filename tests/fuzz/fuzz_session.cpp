// SPDX-License-Identifier: GPL-3.0-or-later
// A session of the window: it is read, or refused with a ReadError; what was read is written and read again as the same.
#include "analysis/curvature_field.h"
#include "core/error.h"
#include "core/threads.h"
#include "document/session.h"

#include <QFile>
#include <QFileInfo>
#include <QTemporaryDir>

#include <unistd.h>

#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

namespace {

using namespace loopmend;

void require(bool holds, const char* promise) {
  if (holds) return;
  std::fprintf(stderr, "broken promise: %s\n", promise);
  std::abort();
}

QString input_file() {
  const std::filesystem::path memory = "/dev/shm";
  const std::filesystem::path folder =
      std::filesystem::exists(memory) ? memory : std::filesystem::temp_directory_path();
  return QString::fromStdString(folder / ("loopmend-fuzz-" + std::to_string(::getpid()) + ".loopmend"));
}

void write(const QString& path, const QByteArray& bytes) {
  QFile file(path);
  require(file.open(QIODevice::WriteOnly) && file.write(bytes) == bytes.size(), "the folder can be written");
}

void require_patch(const Patch& patch) {
  const int n = patch.vertex_count();
  for (const Triangle& t : patch.triangles)
    for (const int v : t) require(v >= 0 && v < n, "corners are vertices");
  for (const auto& loop : patch.loops)
    for (const int v : loop) require(v >= patch.free_count && v < n, "loops are fixed vertices");
  with_thread_budget(1, [&] { curvature_field(patch); });  // the window asks for it at once
}

/// Places are looked for on the disk, and would not come back as they were.
QByteArray without_places(Session session) {
  std::vector<KeptFilePtr> files;
  for (SessionScan& scan : session.scans) {
    scan.path.clear();
    files.push_back(scan.file);
  }
  return pack(to_bytes(session, QStringLiteral("/")), files);
}

/// Files that a session holds are laid out to be read; those that are damaged are refused, and none leaves its folder.
void lay_out_files(const Session& session) {
  static const QTemporaryDir folder;
  for (const SessionScan& scan : session.scans) {
    if (!scan.file) continue;
    try {
      const QString path = lay_out(*scan.file, folder.path());
      require(QFileInfo(path).path() == folder.path(), "a kept file stays in the folder");
      require(QFile::remove(path), "a kept file is there");
    } catch (const ReadError&) {
    } catch (const WriteError&) {  // its name is none
    }
  }
}

void read_a_session(const QString& path) {
  const Session session = session_from_file(path);
  lay_out_files(session);
  for (const SessionPatch& patch : session.patches) {
    require(patch.scan >= 0 && patch.scan < static_cast<int>(session.scans.size()), "patches belong to scans");
    require(patch.loop_numbers.size() == patch.state->patch.loops.size(), "each loop has its number");
    require_patch(patch.state->patch);
  }
  const QByteArray bytes = without_places(session);
  write(path, bytes);
  require(without_places(session_from_file(path)) == bytes, "what was written is read again");
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const QString path = input_file();
  write(path, QByteArray::fromRawData(reinterpret_cast<const char*>(data), static_cast<int>(size)));
  try {
    read_a_session(path);
  } catch (const ReadError& error) {
    require(std::string(error.what()).find('\n') == std::string::npos, "a refusal is one line");
  }
  return 0;
}
