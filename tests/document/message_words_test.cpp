// SPDX-License-Identifier: GPL-3.0-or-later
// That every text has a translation with the same places is checked by make_ts.py --check.
#include "document/message_words.h"

#include "core/error.h"
#include "document/labels.h"
#include "document/language.h"

#include <gtest/gtest.h>

#include <QCoreApplication>
#include <QLocale>
#include <QTranslator>

namespace loopmend {
namespace {

using labels::in_words;

class MessageWords : public testing::Test {
 protected:
  ~MessageWords() override {
    qDeleteAll(QCoreApplication::instance()->findChildren<QTranslator*>());
    QLocale::setDefault(before_);
  }
  const QLocale before_;
};

TEST_F(MessageWords, OptionsBecomeControls) {
  const Message crosses =
      joined(say("%1 boundary edges intersect the surface, so that no valid patch exists: left open", 4), "; ",
             say("remove what crosses (--trim-crossing)"));
  install_language(QStringLiteral("en"));
  EXPECT_EQ(in_words(crosses),
            QStringLiteral("4 boundary edges intersect the surface, so that no valid patch exists: left open; Trim "
                           "crossing triangles in the menu Patch may help"));
  install_language(QStringLiteral("de"));
  EXPECT_EQ(in_words(say("--boundary exact runs the flow itself")),
            QStringLiteral("mit dem Rand \u201eExakt\u201c l\u00e4uft der Fluss selbst"));
  EXPECT_FALSE(in_words(crosses).contains(QStringLiteral("--")));
}

TEST_F(MessageWords, ArgumentsMayComeInAnotherOrderAndNumbersHaveADecimalComma) {
  install_language(QStringLiteral("de"));
  EXPECT_EQ(in_words(say("relief continued at random, rms %1 (%2 around the hole)", 0.0123, 1.5e-5)),
            QStringLiteral("zuf\u00e4lliges Relief fortgesetzt, quadratisches Mittel 0,0123 (um das Loch 1,5e-05)"));
}

TEST_F(MessageWords, HostileNamesStayAsTheyAre) {
  const char* const path = "/tmp/a. b; c: d (1)/the 50%1 hole %2\n.ply";
  const ReadError error(path, say("%1 stands where a coordinate should be", "\"%2\""), say("line %1", 3),
                        say("It is incomplete; export or copy it again."));
  install_language(QStringLiteral("de"));
  EXPECT_EQ(in_words(error.message()),
            QStringLiteral("/tmp/a. b; c: d (1)/the 50%1 hole %2?.ply: \"%2\" steht, wo eine Koordinate stehen sollte "
                           "(Zeile 3). Sie ist unvollst\u00e4ndig; sie noch einmal exportieren oder kopieren."));
}

TEST_F(MessageWords, EnglishIsWhatTheCommandLinePrints) {
  install_language(QStringLiteral("en"));
  const ReadError error("/a b.ply", say("face %1 names vertex %2, but %3", 7, 12, say("there are %1, from 0 on", 9)),
                        say("line %1", 3), say("The file is damaged or incomplete; export or copy it again."));
  EXPECT_EQ(in_words(error.message()).toStdString(), error.what());
  EXPECT_EQ(in_words(say("a text that is not known: %1 and %3", "0x")).toStdString(),
            "a text that is not known: 0x and %3");
  EXPECT_EQ(in_words({}), QString());
}

TEST_F(MessageWords, WhatAFileDoesNotKeepIsListedInGerman) {
  install_language(QStringLiteral("de"));
  EXPECT_EQ(labels::not_kept({{say("beam lattices"), 2}, {say("normals"), 3}}),
            QStringLiteral("Stabgitter (2), Normalen (3)"));
}

}  // namespace
}  // namespace loopmend
