// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/language.h"

#include <QCoreApplication>
#include <QLibraryInfo>
#include <QLocale>
#include <QTranslator>

// The list lives in a static library, so it has to be asked for; the macro works outside namespaces only.
static void load_translations() { Q_INIT_RESOURCE(translations); }

namespace loopmend {
namespace {

constexpr const char* built_in_words = ":/translations";

/// From the folder, else from the program itself.
void install(const QString& file, const QString& folder) {
  auto* translator = new QTranslator(QCoreApplication::instance());
  if (translator->load(file, folder) || translator->load(file, QLatin1String(built_in_words))) {
    QCoreApplication::installTranslator(translator);
  } else {
    delete translator;
  }
}

}  // namespace

void install_language(const QString& wanted) {
  load_translations();
  qDeleteAll(
      QCoreApplication::instance()->findChildren<QTranslator*>(QString(), Qt::FindDirectChildrenOnly));  // of another
  QString language = wanted.isEmpty() ? QLocale::system().name().section(QLatin1Char('_'), 0, 0) : wanted;
  if (language != QStringLiteral("de")) language = QStringLiteral("en");
  install(QStringLiteral("qtbase_") + language, QLibraryInfo::location(QLibraryInfo::TranslationsPath));
  install(QStringLiteral("loopmend_") + language, QLatin1String(built_in_words));
  QLocale::setDefault(QLocale(language));
}

}  // namespace loopmend
