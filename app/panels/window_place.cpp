// SPDX-License-Identifier: GPL-3.0-or-later
#include "panels/window_place.h"

#include <QGuiApplication>
#include <QScreen>

#include <algorithm>

namespace loopmend {
namespace {

QRect within(const QRect& wanted, const QRect& room) {
  const QSize size = wanted.size().boundedTo(room.size());
  const int x = std::clamp(wanted.x(), room.left(), room.left() + room.width() - size.width());
  const int y = std::clamp(wanted.y(), room.top(), room.top() + room.height() - size.height());
  return {QPoint(x, y), size};
}

}  // namespace

QRect onto_screen(const QRect& was) {
  const QScreen* screen = QGuiApplication::screenAt(was.center());
  if (!screen) screen = QGuiApplication::primaryScreen();
  return within(was, screen->availableGeometry().marginsRemoved(usual_frame));
}

QRect place_beside(const QRect& main, const QRect& needed, const QSize& size, int least_width, const QRect& room) {
  const int frame = usual_frame.left() + usual_frame.right();
  QRect place(QPoint(), size);
  place.moveCenter(main.center());
  for (const QRect& to_be_seen : {main, needed}) {
    const int left = to_be_seen.left() - frame - room.left(),
              right = room.left() + room.width() - (to_be_seen.right() + frame);
    if (std::max(left, right) < least_width) continue;
    place.setWidth(std::min(size.width(), std::max(left, right)));
    right >= left ? place.moveLeft(to_be_seen.right() + frame) : place.moveRight(to_be_seen.left() - frame);
    break;
  }
  return within(place, room);
}

}  // namespace loopmend
