// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/language.h"

#include "document/labels.h"

#include <gtest/gtest.h>

#include <QCoreApplication>
#include <QLocale>
#include <QTranslator>

namespace loopmend {
namespace {

class Language : public testing::Test {
 protected:
  ~Language() override {
    qDeleteAll(QCoreApplication::instance()->findChildren<QTranslator*>());
    QLocale::setDefault(before_);
  }
  const QLocale before_;
};

TEST_F(Language, OwnWordsAndThoseOfQtsDialogsAreGerman) {
  install_language(QStringLiteral("de"));
  EXPECT_EQ(QCoreApplication::translate("loopmend::FileController", "&Locate\u2026"), QStringLiteral("&Suchen\u2026"));
  EXPECT_EQ(QCoreApplication::translate("QPlatformTheme", "Cancel"), QStringLiteral("Abbrechen"));
  EXPECT_EQ(QCoreApplication::translate("QFileDialog", "Look in:"), QStringLiteral("Suchen in:"));
}

TEST_F(Language, NumbersAreThoseOfTheLanguage) {
  EXPECT_EQ(labels::number(0.1234), QStringLiteral("0.123"));
  install_language(QStringLiteral("de"));
  EXPECT_EQ(labels::number(0.1234), QStringLiteral("0,123"));
  EXPECT_EQ(labels::number(1234.4), QStringLiteral("1234")) << "no mark that could be a decimal one";
  EXPECT_EQ(labels::number(74786), QStringLiteral("74.786"));
  EXPECT_EQ(labels::number(1.2e-7), QStringLiteral("1,20\u00b710\u207b\u2077"));
  EXPECT_EQ(labels::seconds(1500), QStringLiteral("1,5"));
}

TEST_F(Language, WithoutATranslationItIsEnglish) {
  install_language(QStringLiteral("fi"));
  EXPECT_EQ(QCoreApplication::translate("QPlatformTheme", "Cancel"), QStringLiteral("Cancel"));
}

}  // namespace
}  // namespace loopmend
