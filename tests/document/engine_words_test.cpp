// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/engine_words.h"

#include "document/engine_messages.h"
#include "document/engine_templates.h"
#include "document/file_messages.h"
#include "document/labels.h"
#include "document/language.h"
#include "support/english_words.h"

#include <gtest/gtest.h>

#include <QCoreApplication>
#include <QLocale>
#include <QTranslator>

#include <set>
#include <string>
#include <vector>

namespace loopmend {
namespace {

using labels::engine_words;

class EngineWords : public testing::Test {
 protected:
  ~EngineWords() override {
    qDeleteAll(QCoreApplication::instance()->findChildren<QTranslator*>());
    QLocale::setDefault(before_);
  }
  const QLocale before_;
};

std::vector<std::string> all_messages() {
  std::vector<std::string> all(std::begin(test::engine_messages), std::end(test::engine_messages));
  all.insert(all.end(), std::begin(test::file_messages), std::end(test::file_messages));
  return all;
}

std::vector<EngineTemplate> all_templates() {
  std::vector<EngineTemplate> all;
  for (const auto& some : {EngineTemplates::of_patches(), EngineTemplates::of_files(), EngineTemplates::of_formats()})
    all.insert(all.end(), some.begin(), some.end());
  return all;
}

TEST_F(EngineWords, EveryMessageIsGermanInTheGermanWindow) {
  install_language(QStringLiteral("de"));
  for (const std::string& message : all_messages()) {
    const QString words = engine_words(message);
    EXPECT_NE(words.toStdString(), message);
    EXPECT_EQ(test::english_in(words).join(QLatin1Char(' ')).toStdString(), "") << message << "\n" << qPrintable(words);
    EXPECT_FALSE(words.contains(QLatin1Char('%'))) << qPrintable(words);
  }
}

TEST_F(EngineWords, NoOptionOfTheCommandLineIsNamed) {
  install_language(QStringLiteral("en"));
  for (const std::string& message : all_messages()) {
    const QString words = engine_words(message);
    EXPECT_FALSE(words.contains(QStringLiteral("--"))) << qPrintable(words);
    if (message.find("--") == std::string::npos && message.find("loopmend blend") == std::string::npos) continue;
    EXPECT_NE(words.toStdString(), message);
  }
}

TEST_F(EngineWords, OptionsBecomeControls) {
  install_language(QStringLiteral("en"));
  EXPECT_EQ(
      engine_words("4 boundary edges intersect the surface, so that no valid patch exists: left open; remove "
                   "what crosses (--trim-crossing)"),
      QStringLiteral("4 boundary edges intersect the surface, so that no valid patch exists: left open; Trim crossing "
                     "triangles in the menu Patch may help"));
  install_language(QStringLiteral("de"));
  EXPECT_EQ(engine_words("the scan around the hole has relief, so that its curvature counts little; --boundary exact "
                         "runs the flow itself"),
            QStringLiteral("der Scan um das Loch hat Relief, sodass seine Kr\u00fcmmung wenig z\u00e4hlt; mit dem Rand "
                           "\u201eExakt\u201c l\u00e4uft der Fluss selbst"));
}

TEST_F(EngineWords, NumbersHaveADecimalCommaInGerman) {
  install_language(QStringLiteral("de"));
  EXPECT_EQ(engine_words("relief continued at random, rms 0.0123 (1.5e-05 around the hole)"),
            QStringLiteral("zuf\u00e4lliges Relief fortgesetzt, quadratisches Mittel 0,0123 (um das Loch 1,5e-05)"));
}

TEST_F(EngineWords, PathsStayAsTheyAre) {
  install_language(QStringLiteral("de"));
  const std::string path = "/tmp/a. b; c: d (1)/the 50%1 hole.ply";
  EXPECT_EQ(
      engine_words(path + ": \"%2\" stands where a coordinate should be (line 3). It is incomplete; export or copy "
                          "it again."),
      QString::fromStdString(path) +
          QStringLiteral(": \"%2\" steht, wo eine Koordinate stehen sollte (Zeile 3). Sie ist unvollst\u00e4ndig; "
                         "sie noch einmal exportieren oder kopieren."));
}

TEST_F(EngineWords, UnknownMessagesPassUnchanged) {
  install_language(QStringLiteral("de"));
  std::string endless;
  for (int k = 0; k < 1'000'000; ++k) endless += "; ";
  EXPECT_EQ(engine_words(endless).toStdString(), endless);
  for (const std::string message : {"", ".", "(", "something new: 3.5 of it; and (so) on. Really.", "%1", "loop 3 (x"})
    EXPECT_EQ(engine_words(message).toStdString(), message);
}

/// A message is taken apart at these marks before a part is looked up.
TEST_F(EngineWords, TemplatesAreSinglePartsWithPlaceholdersInOrder) {
  std::set<std::string> seen;
  for (const EngineTemplate& one : all_templates()) {
    const QString engine = QString::fromUtf8(one.engine), words = QString::fromUtf8(one.words);
    EXPECT_TRUE(seen.insert(one.engine).second) << one.engine << " is there twice";
    for (const char* mark : {". ", "; ", ": "}) EXPECT_FALSE(engine.contains(QLatin1String(mark))) << one.engine;
    EXPECT_FALSE(engine.endsWith(QLatin1Char('.'))) << one.engine;
    for (int k = 1; k <= engine.count(QLatin1Char('%')); ++k)
      EXPECT_EQ(engine.section(QLatin1Char('%'), k, k).left(1), QString::number(k)) << one.engine;
    EXPECT_LE(words.count(QLatin1Char('%')), engine.count(QLatin1Char('%'))) << one.words;
  }
}

TEST_F(EngineWords, WhatAFileDoesNotKeepIsListedInGerman) {
  install_language(QStringLiteral("de"));
  EXPECT_EQ(labels::not_kept({{"beam lattices", 2}, {"normals", 3}}), QStringLiteral("Stabgitter (2), Normalen (3)"));
}

}  // namespace
}  // namespace loopmend
