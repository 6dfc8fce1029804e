// SPDX-License-Identifier: GPL-3.0-or-later
#include "panels/icons.h"

#include <QFile>
#include <QPainter>
#include <QPixmap>
#include <QSvgRenderer>

// The list lives in a static library, so it has to be asked for; the macro works outside namespaces only.
static void load_resources() { Q_INIT_RESOURCE(resources); }

namespace loopmend {
namespace {

QByteArray svg(const char* name) {
  load_resources();
  QFile file(QStringLiteral(":/icons/%1.svg").arg(QLatin1String(name)));
  return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

QPixmap draw(const QByteArray& source, int size) {
  QPixmap pixmap(size, size);
  pixmap.fill(Qt::transparent);
  QPainter painter(&pixmap);
  QSvgRenderer(source).render(&painter);
  return pixmap;
}

}  // namespace

QIcon icon(const char* name, const QColor& ink) {
  QIcon result;
  QColor faint = ink;
  faint.setAlphaF(0.35);
  for (int size : {16, 20, 24, 32, 40, 48}) {
    QByteArray source = svg(name);
    QPixmap drawn = draw(source.replace("currentColor", ink.name().toLatin1()), size);
    QPixmap pale(drawn.size());
    pale.fill(Qt::transparent);
    QPainter painter(&pale);
    painter.setOpacity(faint.alphaF());
    painter.drawPixmap(0, 0, drawn);
    painter.end();
    result.addPixmap(drawn);
    result.addPixmap(pale, QIcon::Disabled);
  }
  return result;
}

QIcon application_icon() {
  QIcon result;
  for (int size : {16, 24, 32, 48, 64, 128, 256}) result.addPixmap(draw(svg("loopmend"), size));
  return result;
}

}  // namespace loopmend
