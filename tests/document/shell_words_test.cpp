// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/shell_words.h"

#include "document/sheet.h"

#include <gtest/gtest.h>

#include <QProcess>

#include <cmath>
#include <limits>

namespace loopmend::test {
namespace {

TEST(ShellWords, NumbersReadBackAsTheSameDouble) {
  EXPECT_EQ(shell::exact(0.1), QStringLiteral("0.1"));
  EXPECT_EQ(shell::exact(10), QStringLiteral("10"));
  for (double value :
       {1.0 / 3, std::sqrt(2.0), 1e-300, 12345678.9, std::nextafter(1.0, 2.0), std::numeric_limits<double>::max()})
    EXPECT_EQ(shell::exact(value).toDouble(), value);
}

TEST(ShellWords, PathsAreQuotedWhereTheyHaveTo) {
  EXPECT_EQ(shell::quoted(QStringLiteral("/scans/a-1_b.ply")), QStringLiteral("/scans/a-1_b.ply"));
  EXPECT_EQ(shell::quoted(QStringLiteral("my scan.ply")), QStringLiteral("'my scan.ply'"));
  EXPECT_EQ(shell::quoted(QStringLiteral("it's")), QStringLiteral("'it'\\''s'"));
  EXPECT_EQ(shell::quoted(QString()), QStringLiteral("''"));
}

TEST(ShellWords, AShellReadsQuotedPathsAsTheyAre) {
  for (const char* path :
       {"plain.ply", "a b", "it's", "''", "$HOME", "`id`", "a;b&c|d", "*?[x]", "\"", "back\\slash", "~", "#x", "!x",
        "Gr\xc3\xb6\xc3\x9f"
        "e.ply",
        "line\nbreak", "a=b", "{1,2}"}) {
    QProcess sh;
    sh.start(QStringLiteral("/bin/sh"),
             {QStringLiteral("-c"), QStringLiteral("printf %s ") + shell::quoted(QString::fromUtf8(path))});
    ASSERT_TRUE(sh.waitForFinished());
    EXPECT_EQ(sh.readAllStandardOutput(), QByteArray(path));
  }
}

TEST(ShellWords, OutputsLieBesideTheirInput) {
  EXPECT_EQ(shell::beside(QStringLiteral("scan.ply"), QStringLiteral("-filled.ply")),
            QStringLiteral("scan-filled.ply"));
  EXPECT_EQ(shell::beside(QStringLiteral("/a/b.c/scan.v2.obj"), QStringLiteral("-x.ply")),
            QStringLiteral("/a/b.c/scan.v2-x.ply"));
  EXPECT_EQ(shell::beside(QStringLiteral("/a/scan"), QStringLiteral("-x.ply")), QStringLiteral("/a/scan-x.ply"));
}

TEST(ShellWords, OnlyOptionsThatDifferFromTheDefaultAreNamed) {
  EXPECT_EQ(shell::boundary_options(BoundaryTrust::automatic, SeamContinuity::curvature), QString());
  EXPECT_EQ(shell::boundary_options(BoundaryTrust::robust, SeamContinuity::tangent),
            QStringLiteral(" --boundary robust --continuity tangent"));
  EXPECT_EQ(shell::boundary_options(BoundaryTrust::exact, SeamContinuity::position),
            QStringLiteral(" --boundary exact --continuity position"));
  EXPECT_EQ(shell::relief_options({}), QString());
  EXPECT_EQ(shell::relief_options({ReliefChoice::Kind::continued, 1}), QStringLiteral(" --relief continued"));
  EXPECT_EQ(shell::relief_options({ReliefChoice::Kind::continued, 7}),
            QStringLiteral(" --relief continued --relief-seed 7"));
}

TEST(ShellWords, AScanIsNamedByItsFile) {
  const QString file = QStringLiteral("/scans/sheet.ply");
  EXPECT_EQ(shell::file_of(*scan_from(file)), file);
  EXPECT_EQ(shell::file_of(*scan_from({}, ScanOrigin::sample)), QStringLiteral("sample.ply"));
  EXPECT_EQ(shell::file_of(*scan_from({}, ScanOrigin::made)), QStringLiteral("surface.ply"));
  EXPECT_EQ(shell::file_of(*scan_from({}, ScanOrigin::made), QStringLiteral("part.ply")), QStringLiteral("part.ply"));
}

}  // namespace
}  // namespace loopmend::test
