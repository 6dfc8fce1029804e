// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/preferences.h"

#include "document/recent_pictures.h"

#include <QFileInfo>
#include <QSettings>

#include <algorithm>

namespace loopmend {
namespace {

constexpr int most_recent_files = 10;
const QString recent_key = QStringLiteral("recentFiles");

QSettings settings() {
  return QSettings(QSettings::IniFormat, QSettings::UserScope, QStringLiteral("loopmend"), QStringLiteral("loopmend"));
}

}  // namespace

Preferences load_preferences() {
  const QSettings stored = settings();
  Preferences p;
  const auto whole = [&stored](const char* key, int fallback, int low, int high) {
    return std::clamp(stored.value(QLatin1String(key), fallback).toInt(), low, high);
  };
  p.language = stored.value(QStringLiteral("language")).toString();
  p.theme = static_cast<Theme>(whole("theme", 0, 0, static_cast<int>(Theme::dark)));
  p.undo_megabytes = whole("undoMegabytes", p.undo_megabytes, 64, 8192);
  p.timeline_megabytes = whole("timelineMegabytes", p.timeline_megabytes, 16, 4096);
  p.autosave_seconds = whole("autosaveSeconds", p.autosave_seconds, 5, 600);
  p.color_map = stored.value(QStringLiteral("colorMap")).toString();
  return p;
}

void save_preferences(const Preferences& p) {
  QSettings stored = settings();
  stored.setValue(QStringLiteral("language"), p.language);
  stored.setValue(QStringLiteral("theme"), static_cast<int>(p.theme));
  stored.setValue(QStringLiteral("undoMegabytes"), p.undo_megabytes);
  stored.setValue(QStringLiteral("timelineMegabytes"), p.timeline_megabytes);
  stored.setValue(QStringLiteral("autosaveSeconds"), p.autosave_seconds);
  stored.setValue(QStringLiteral("colorMap"), p.color_map);
}

QStringList recent_files() {
  QStringList files = settings().value(recent_key).toStringList();
  files.erase(std::remove_if(files.begin(), files.end(), [](const QString& f) { return !QFileInfo::exists(f); }),
              files.end());
  return files;
}

void add_recent_file(const QString& path) {
  if (path.isEmpty()) return;
  QSettings stored = settings();
  QStringList files = stored.value(recent_key).toStringList();
  files.removeAll(path);
  files.prepend(path);
  files = files.mid(0, most_recent_files);
  stored.setValue(recent_key, files);
  keep_recent_pictures(files);
}

void clear_recent_files() {
  QSettings stored = settings();
  stored.remove(recent_key);
  keep_recent_pictures({});
}

WindowLayout load_window_layout() {
  const QSettings stored = settings();
  return {stored.value(QStringLiteral("window/geometry")).toByteArray(),
          stored.value(QStringLiteral("window/docks")).toByteArray()};
}

void save_window_layout(const WindowLayout& layout) {
  QSettings stored = settings();
  stored.setValue(QStringLiteral("window/geometry"), layout.geometry);
  stored.setValue(QStringLiteral("window/docks"), layout.docks);
}

QByteArray load_compare_place() { return settings().value(QStringLiteral("compare/geometry")).toByteArray(); }

void save_compare_place(const QByteArray& geometry) {
  QSettings stored = settings();
  stored.setValue(QStringLiteral("compare/geometry"), geometry);
}

Look load_look() {
  const QSettings stored = settings();
  const auto whole = [&stored](const char* key, int fallback, int low, int high) {
    return std::clamp(stored.value(QLatin1String(key), fallback).toInt(), low, high);
  };
  Look look;
  look.shading = static_cast<Shading>(whole("look/shading", 0, 0, static_cast<int>(Shading::isophotes)));
  look.edges = static_cast<Edges>(whole("look/edges", static_cast<int>(look.edges), 0, 1));
  look.seams = static_cast<Seams>(whole("look/seams", static_cast<int>(look.seams), 0, 1));
  look.tint = static_cast<Tint>(whole("look/tint", static_cast<int>(look.tint), 0, 1));
  look.stripes = whole("look/stripes", look.stripes, 3, 40);
  look.up = static_cast<UpAxis>(whole("look/up", 0, 0, static_cast<int>(UpAxis::minus_z)));
  return look;
}

void save_look(const Look& look) {
  QSettings stored = settings();
  const bool suits_every_scan = look.shading <= Shading::isophotes;
  if (suits_every_scan) stored.setValue(QStringLiteral("look/shading"), static_cast<int>(look.shading));
  stored.setValue(QStringLiteral("look/edges"), static_cast<int>(look.edges));
  stored.setValue(QStringLiteral("look/seams"), static_cast<int>(look.seams));
  stored.setValue(QStringLiteral("look/tint"), static_cast<int>(look.tint));
  stored.setValue(QStringLiteral("look/stripes"), look.stripes);
  stored.setValue(QStringLiteral("look/up"), static_cast<int>(look.up));
}

NavigationStyle load_navigation() {
  const QString word = settings().value(QStringLiteral("navigation")).toString();
  for (NavigationStyle style : all_navigation_styles)
    if (word == QLatin1String(navigation(style).word)) return style;
  return NavigationStyle::loopmend;
}

void save_navigation(NavigationStyle style) {
  QSettings stored = settings();
  stored.setValue(QStringLiteral("navigation"), QLatin1String(navigation(style).word));
}

}  // namespace loopmend
