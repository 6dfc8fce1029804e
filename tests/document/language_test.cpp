// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/language.h"

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
  EXPECT_EQ(QCoreApplication::translate("loopmend::FileDesk", "&Locate\u2026"), QStringLiteral("&Suchen\u2026"));
  EXPECT_EQ(QCoreApplication::translate("QPlatformTheme", "Cancel"), QStringLiteral("Abbrechen"));
  EXPECT_EQ(QCoreApplication::translate("QFileDialog", "Look in:"), QStringLiteral("Suchen in:"));
}

TEST_F(Language, WithoutATranslationItIsEnglish) {
  install_language(QStringLiteral("fi"));
  EXPECT_EQ(QCoreApplication::translate("QPlatformTheme", "Cancel"), QStringLiteral("Cancel"));
}

}  // namespace
}  // namespace loopmend
