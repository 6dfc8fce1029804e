// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/navigation.h"

#include <QCoreApplication>
#include <QStringList>

#include <algorithm>
#include <utility>

namespace loopmend {
namespace {

constexpr int no_key = Qt::NoModifier, shift_key = Qt::ShiftModifier, ctrl_key = Qt::ControlModifier,
              alt_key = Qt::AltModifier;

const std::vector<Navigation>& navigation_table() {
  using enum Motion;
  constexpr auto left = Qt::LeftButton, middle = Qt::MiddleButton, right = Qt::RightButton;
  static const std::vector<Navigation> styles{
      {NavigationStyle::loopmend,
       "loopmend",
       "Loopmend",
       Turning::freely,
       {{left, no_key, turn},
        {left, shift_key, slide},
        {left, ctrl_key, roll},
        {left, ctrl_key | shift_key, zoom},
        {middle, no_key, slide},
        {right, no_key, zoom}}},
      // Alt and the left button stand for the middle one, as Blender does for mice that have none.
      {NavigationStyle::blender,
       "blender",
       "Blender",
       Turning::about_up,
       {{middle, no_key, turn},
        {middle, shift_key, slide},
        {middle, ctrl_key, zoom},
        {left, alt_key, turn},
        {left, alt_key | shift_key, slide},
        {left, alt_key | ctrl_key, zoom}}},
      {NavigationStyle::meshlab,
       "meshlab",
       "MeshLab",
       Turning::freely,
       {{left, no_key, turn}, {left, ctrl_key, slide}, {left, shift_key, zoom}, {middle, no_key, slide}}},
      {NavigationStyle::cad,
       "cad",
       "CAD",
       Turning::freely,
       {{middle, no_key, turn}, {middle, ctrl_key, slide}, {middle, shift_key, zoom}, {middle, alt_key, roll}}},
  };
  return styles;
}

constexpr const char* button_words[] = {QT_TRANSLATE_NOOP("loopmend::Navigation", "left button"),
                                        QT_TRANSLATE_NOOP("loopmend::Navigation", "middle button"),
                                        QT_TRANSLATE_NOOP("loopmend::Navigation", "right button")};
constexpr std::pair<int, const char*> key_words[] = {{ctrl_key, QT_TRANSLATE_NOOP("loopmend::Navigation", "Ctrl")},
                                                     {shift_key, QT_TRANSLATE_NOOP("loopmend::Navigation", "Shift")},
                                                     {alt_key, QT_TRANSLATE_NOOP("loopmend::Navigation", "Alt")}};

QString words_of(const MouseRule& rule) {
  const auto word = [](const char* text) { return QCoreApplication::translate("loopmend::Navigation", text); };
  QStringList words;
  for (const auto& [key, text] : key_words)
    if (rule.modifiers & key) words << word(text);
  const std::size_t place = rule.button == Qt::LeftButton ? 0 : rule.button == Qt::MiddleButton ? 1 : 2;
  return (words << word(button_words[place])).join(QLatin1Char('+'));
}

}  // namespace

const Navigation& navigation(NavigationStyle style) {
  const auto found = std::find_if(navigation_table().begin(), navigation_table().end(),
                                  [style](const Navigation& n) { return n.style == style; });
  return found == navigation_table().end() ? navigation_table().front() : *found;
}

Motion motion_of(NavigationStyle style, Qt::MouseButton button, Qt::KeyboardModifiers modifiers, Hand hand) {
  const int held = static_cast<int>(modifiers) & (shift_key | ctrl_key | alt_key);
  if (hand == Hand::tool && button == Qt::LeftButton && (held & shift_key)) return Motion::turn;
  const std::vector<MouseRule>& rules = navigation(style).rules;
  for (const int wanted : {held, no_key})
    for (const MouseRule& rule : rules)
      if (rule.button == button && rule.modifiers == wanted) return rule.motion;
  return Motion::nothing;
}

QString name_of(NavigationStyle style) { return QString::fromLatin1(navigation(style).name); }

QString drags_for(NavigationStyle style, Motion motion) {
  QStringList drags;
  for (const MouseRule& rule : navigation(style).rules)
    if (rule.motion == motion) drags << words_of(rule);
  return drags.join(QStringLiteral(", "));
}

}  // namespace loopmend
