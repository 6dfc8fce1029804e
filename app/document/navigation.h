// SPDX-License-Identifier: GPL-3.0-or-later
// What the mouse does to the picture: one table of the styles that people know from other programs.
#pragma once

#include <QString>
#include <Qt>

#include <vector>

namespace loopmend {

enum class NavigationStyle { loopmend, blender, meshlab, cad };
inline constexpr NavigationStyle all_navigation_styles[] = {NavigationStyle::loopmend, NavigationStyle::blender,
                                                            NavigationStyle::meshlab, NavigationStyle::cad};

/// What a drag does to the picture.
enum class Motion { nothing, turn, slide, zoom, roll };

/// How a drag turns the picture.
enum class Turning {
  freely,    ///< as a ball under the mouse
  about_up,  ///< round the up axis, which stays upright
};

/// Whether a tool takes the mouse first.
enum class Hand { empty, tool };

struct MouseRule {
  Qt::MouseButton button;
  int modifiers;  ///< of Qt::KeyboardModifier: Shift, Ctrl, Alt
  Motion motion;
};

struct Navigation {
  NavigationStyle style;
  const char* word;  ///< in settings
  const char* name;  ///< of the program that it is known from
  Turning turning;
  std::vector<MouseRule> rules;  ///< the first that fits holds
};
const Navigation& navigation(NavigationStyle style);

/// With modifiers that the style does not name, a button does what it does alone. With a tool in hand, Shift and the left
/// button turn the picture in every style. A click, which is no drag, selects by the left button, and asks for the menu by the
/// right one, in every style.
Motion motion_of(NavigationStyle style, Qt::MouseButton button, Qt::KeyboardModifiers modifiers, Hand hand);

QString name_of(NavigationStyle style);
/// The drags that do this, in the language of the window; empty: none.
QString drags_for(NavigationStyle style, Motion motion);

}  // namespace loopmend
