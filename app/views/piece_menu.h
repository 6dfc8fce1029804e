// SPDX-License-Identifier: GPL-3.0-or-later
// Hides, isolates and shows pieces of the scans, by menu and by key.
#pragma once

#include "document/hole_selection.h"
#include "document/scene_visibility.h"

class QMenu;
class QPoint;
class QWidget;

namespace loopmend {

class MeshView;

class PieceMenu : public QObject {
  Q_OBJECT

 public:
  PieceMenu(const Document& document, SceneVisibility& visibility, const HoleSelection& selection, MeshView& view,
            QWidget* window);

  std::set<PieceId> of_selected_holes() const;
  /// At the end of a menu, for these pieces.
  void add_entries(QMenu* menu, const std::set<PieceId>& pieces);
  /// @param at  of the screen
  void show(const PieceId& piece, const QPoint& at) { show_for({piece}, at); }
  void show_for(const std::set<PieceId>& pieces, const QPoint& at);
  /// The piece under the mouse, else those of the selected holes.
  void hide();
  void isolate();

 Q_SIGNALS:
  void notice(const QString& words);

 private:
  std::set<PieceId> meant();
  /// "piece 2 of bunny.ply", "3 pieces".
  QString name_of(const std::set<PieceId>& pieces) const;

  const Document& document_;
  SceneVisibility& visibility_;
  const HoleSelection& selection_;
  MeshView& view_;
  QWidget* window_;
};

}  // namespace loopmend
