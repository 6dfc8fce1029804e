// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/piece_menu.h"

#include "views/mesh_view.h"

#include <QMenu>

namespace loopmend {

PieceMenu::PieceMenu(const Document& document, SceneVisibility& visibility, const HoleSelection& selection,
                     MeshView& view, QWidget* window)
    : QObject(window),
      document_(document),
      visibility_(visibility),
      selection_(selection),
      view_(view),
      window_(window) {}

std::set<PieceId> PieceMenu::of_selected_holes() const {
  std::set<PieceId> pieces;
  for (int loop : selection_.selected())
    if (document_.present(loop)) pieces.insert(visibility_.piece_of_loop(loop));
  return pieces;
}

std::set<PieceId> PieceMenu::meant() {
  if (const auto piece = view_.piece_under_mouse()) return {*piece};
  std::set<PieceId> pieces = of_selected_holes();
  if (pieces.empty())
    Q_EMIT notice(tr("Move the mouse over the component, or select one of its holes, and press the key again."));
  return pieces;
}

void PieceMenu::hide() { visibility_.set_pieces(meant(), SceneVisibility::Visible::hidden); }

void PieceMenu::isolate() {
  if (const std::set<PieceId> pieces = meant(); !pieces.empty()) visibility_.isolate(pieces);
}

QString PieceMenu::name_of(const std::set<PieceId>& pieces) const {
  if (pieces.size() > 1) return tr("%Ln component(s)", nullptr, static_cast<int>(pieces.size()));
  const PieceId& one = *pieces.begin();
  const QString scan = document_.scan(one.scan)->name;
  return visibility_.piece_count(one.scan) > 1 ? tr("component %1 of %2").arg(one.piece + 1).arg(scan) : scan;
}

void PieceMenu::add_entries(QMenu* menu, const std::set<PieceId>& pieces) {
  if (pieces.empty()) return;
  if (!menu->isEmpty()) menu->addSeparator();
  const auto entry = [this, menu](const char* name, const QString& text, const QString& help, const auto& act) {
    QAction* action = menu->addAction(text);
    action->setObjectName(QLatin1String(name));
    action->setStatusTip(help);
    connect(action, &QAction::triggered, &visibility_, act);
    return action;
  };
  const QString name = name_of(pieces);
  entry("hideThis", tr("&Hide %1").arg(name), tr("It is filled and exported as before"),
        [this, pieces] { visibility_.set_pieces(pieces, SceneVisibility::Visible::hidden); });
  entry("isolateThis", tr("&Isolate %1").arg(name), tr("Hide all other components"),
        [this, pieces] { visibility_.isolate(pieces); });
  entry("showAll", tr("Sho&w all components"), tr("Show everything that was hidden"), [this] {
    visibility_.show_all();
  })->setEnabled(visibility_.hidden_count() > 0);
}

void PieceMenu::show_for(const std::set<PieceId>& pieces, const QPoint& at) {
  auto* menu = new QMenu(window_);
  menu->setObjectName(QStringLiteral("pieceMenu"));
  menu->setAttribute(Qt::WA_DeleteOnClose);
  add_entries(menu, pieces);
  menu->popup(at);
}

}  // namespace loopmend
