// SPDX-License-Identifier: GPL-3.0-or-later
#include "dialogs/help_window.h"

#include "panels/parts.h"

#include <QDesktopServices>
#include <QFile>
#include <QHBoxLayout>
#include <QListWidget>
#include <QLocale>
#include <QTextBrowser>
#include <QTextDocument>
#include <QUrl>

namespace loopmend {
namespace {

struct Page {
  const char* name;
  const char* title;
};

constexpr Page pages[] = {
    {"first-steps", QT_TRANSLATE_NOOP("loopmend::HelpWindow", "First steps")},
    {"holes", QT_TRANSLATE_NOOP("loopmend::HelpWindow", "Holes")},
    {"patch", QT_TRANSLATE_NOOP("loopmend::HelpWindow", "Patch and flow")},
    {"display", QT_TRANSLATE_NOOP("loopmend::HelpWindow", "Looking at curvature")},
    {"inspect", QT_TRANSLATE_NOOP("loopmend::HelpWindow", "Inspecting the seam")},
    {"tools", QT_TRANSLATE_NOOP("loopmend::HelpWindow", "Tools")},
    {"files", QT_TRANSLATE_NOOP("loopmend::HelpWindow", "Files, sessions, recovery")},
    {"problems", QT_TRANSLATE_NOOP("loopmend::HelpWindow", "When something goes wrong")}};

/// A page or picture in the language of the window; English where it has not been translated.
QString help_file(const QString& name) {
  const QString language = QLocale().name().section(QLatin1Char('_'), 0, 0);
  const QString translated = QStringLiteral(":/help/%1/%2").arg(language, name);
  return QFile::exists(translated) ? translated : QStringLiteral(":/help/") + name;
}

QString page_file(const QString& name) { return help_file(name + QStringLiteral(".md")); }

/// Links between pages are "page.md", to pictures "pictures/name.png".
class Browser : public QTextBrowser {
 public:
  QVariant loadResource(int type, const QUrl& name) override {
    if (type != QTextDocument::ImageResource) return QTextBrowser::loadResource(type, name);
    constexpr int widest = 650;  // fits beside the list of pages
    const QImage picture(help_file(QStringLiteral("pictures/") + name.fileName()));
    return picture.width() > widest ? picture.scaledToWidth(widest, Qt::SmoothTransformation) : picture;
  }
};

}  // namespace

HelpWindow::HelpWindow(QWidget* parent) : QDialog(parent), list_(new QListWidget), page_(new Browser) {
  setObjectName(QStringLiteral("helpWindow"));
  setWindowTitle(tr("Help"));
  setWindowFlag(Qt::Window);
  resize(980, 720);
  list_->setFixedWidth(236);
  list_->setSpacing(3);
  explain(list_, "helpPages", tr("Pages"), tr("The pages of the help"));
  list_->setToolTip({});
  page_->setOpenLinks(false);
  page_->document()->setDocumentMargin(18);
  explain(page_, "helpPage", tr("Page"), {});
  for (const Page& page : pages) {
    auto* item = new QListWidgetItem(tr(page.title), list_);
    item->setData(Qt::UserRole, QLatin1String(page.name));
  }
  connect(list_, &QListWidget::currentItemChanged, this,
          [this](QListWidgetItem* item) { show_page(item->data(Qt::UserRole).toString()); });
  connect(page_, &QTextBrowser::anchorClicked, this, [this](const QUrl& link) {
    if (link.isRelative()) {
      show_page(link.path().section(QLatin1Char('.'), 0, 0));
    } else {
      QDesktopServices::openUrl(link);
    }
  });
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(8, 8, 8, 8);
  layout->addWidget(list_);
  layout->addWidget(page_, 1);
  list_->setCurrentRow(0);
}

void HelpWindow::show_page(const QString& name) {
  QFile file(page_file(name));
  if (!file.open(QIODevice::ReadOnly)) return;
  page_->document()->setMarkdown(QString::fromUtf8(file.readAll()));
  page_->moveCursor(QTextCursor::Start);
  for (int row = 0; row < list_->count(); ++row)
    if (list_->item(row)->data(Qt::UserRole).toString() == name && list_->currentRow() != row)
      list_->setCurrentRow(row);
}

QString HelpWindow::shown_text() const { return page_->toPlainText(); }

}  // namespace loopmend
