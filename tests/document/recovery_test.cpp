// SPDX-License-Identifier: GPL-3.0-or-later
// What a program that ended badly left behind, and what else may lie where it is looked for at the start.
#include "document/sheet.h"
#include "jobs/autosave.h"

#include <gtest/gtest.h>

#include <QDir>
#include <QFile>
#include <QTemporaryDir>

namespace loopmend::test {
namespace {

struct RecoveryTest : testing::Test {
  RecoveryTest() {
    qputenv("XDG_DATA_HOME", home.path().toLocal8Bit());
    at.setPath(home.filePath(QStringLiteral("loopmend/recovery")));
    EXPECT_TRUE(at.mkpath(QStringLiteral(".")));
  }
  ~RecoveryTest() override { before.isNull() ? qunsetenv("XDG_DATA_HOME") : qputenv("XDG_DATA_HOME", before); }
  void put(const char* name, const QByteArray& bytes) const {
    QFile file(at.filePath(QLatin1String(name)));
    ASSERT_TRUE(file.open(QIODevice::WriteOnly));
    file.write(bytes);
  }
  QByteArray before = qEnvironmentVariableIsSet("XDG_DATA_HOME") ? qgetenv("XDG_DATA_HOME") : QByteArray();
  QTemporaryDir home;
  QDir at;
};

TEST_F(RecoveryTest, OnlyWholeSessionsAreOffered) {
  SheetDocument document;
  const QByteArray whole = to_bytes(session_of(document, {}), at.path());
  QByteArray other_version = whole;
  other_version[17] = 99;
  put("empty.loopmend", {});
  put("cut.loopmend", whole.left(whole.size() / 2));
  put("version.loopmend", other_version);
  put("long.loopmend", whole + whole);
  put("mesh.loopmend", "ply\nformat ascii 1.0\n");
  put("whole.loopmend", whole);
  put("whole.txt", whole);
  ASSERT_TRUE(at.mkdir(QStringLiteral("folder.loopmend")));
  ASSERT_TRUE(QFile::link(QStringLiteral("nowhere"), at.filePath(QStringLiteral("dangling.loopmend"))));
  const std::vector<Leftover> found = Autosave::leftovers();
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].path, at.filePath(QStringLiteral("whole.loopmend")));
  EXPECT_TRUE(found[0].words.startsWith(QStringLiteral("sheet.ply, 0 "))) << found[0].words.toStdString();
  // What cannot be read is not ours to throw away.
  EXPECT_TRUE(at.exists(QStringLiteral("cut.loopmend")));
}

}  // namespace
}  // namespace loopmend::test
