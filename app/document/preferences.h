// SPDX-License-Identifier: GPL-3.0-or-later
// What a person has chosen once and for all. Kept in the user's configuration.
#pragma once

#include "document/navigation.h"
#include "scene/look.h"

#include <QByteArray>
#include <QString>
#include <QStringList>

namespace loopmend {

enum class Theme { system, light, dark };

struct Preferences {
  QString language;  ///< "en", "de"; empty: the system's
  Theme theme = Theme::system;
  int undo_megabytes = 512;      ///< 64..8192, memory for what can be taken back
  int timeline_megabytes = 256;  ///< 16..4096, memory for the recorded states of one patch
  int autosave_seconds = 20;     ///< 5..600, between a change and the copy that survives a crash
  QString color_map;             ///< a word of scene/color_map.h; empty: the default
};

Preferences load_preferences();
void save_preferences(const Preferences& preferences);

/// Newest first, at most ten; files that are gone are left out.
QStringList recent_files();
void add_recent_file(const QString& path);
void clear_recent_files();

/// Where the window was and how its docks lay, as Qt writes it.
struct WindowLayout {
  QByteArray geometry, docks;  ///< empty: not known yet
};
WindowLayout load_window_layout();
void save_window_layout(const WindowLayout& layout);
/// The place of the comparison window, as Qt writes it; empty: not known yet.
QByteArray load_compare_place();
void save_compare_place(const QByteArray& geometry);

/// How surfaces were shown when the window was closed. Without the colour map, which is a preference, ranges in the units of one
/// scan, and a scan's own colours, which are shown where there are some.
Look load_look();
void save_look(const Look& look);

NavigationStyle load_navigation();
void save_navigation(NavigationStyle style);

}  // namespace loopmend
