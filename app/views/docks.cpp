// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/docks.h"

#include <QAction>
#include <QDockWidget>
#include <QLayout>
#include <QMainWindow>
#include <QToolBar>

#include <algorithm>
#include <utility>

namespace loopmend {

Docks::Docks(QMainWindow* window) : QObject(window), window_(window) {
  soon_.setSingleShot(true);
  soon_.setInterval(0);
  connect(&soon_, &QTimer::timeout, this, &Docks::update_titles);
}

QDockWidget* Docks::add(const char* name, const QString& title, QWidget* content, Qt::DockWidgetArea area) {
  auto* dock = new QDockWidget(title);
  dock->setObjectName(QLatin1String(name));
  dock->setWidget(content);
  window_->addDockWidget(area, dock);
  docks_ << dock;
  toggles_ << dock->toggleViewAction();
  const auto later = QOverload<>::of(&QTimer::start);
  connect(dock, &QDockWidget::visibilityChanged, &soon_, later);
  connect(dock, &QDockWidget::dockLocationChanged, &soon_, later);
  connect(dock, &QDockWidget::topLevelChanged, &soon_, later);
  return dock;
}

void Docks::put_away(bool away) {
  if (away != kept_.isEmpty()) return;
  if (away) {
    kept_ = window_->saveState();
    if (at_first_.isEmpty()) at_first_ = kept_;
    for (QDockWidget* dock : docks_) dock->hide();
    for (auto* bar : window_->findChildren<QToolBar*>()) bar->hide();
    window_->layout()->activate();  // a window that is not shown yet would keep the least size that it had with them
  } else {
    if (!window_->restoreState(std::exchange(kept_, {}))) window_->restoreState(at_first_);
    for (auto* bar : window_->findChildren<QToolBar*>()) bar->show();
  }
  for (QAction* toggle : toggles_) toggle->setEnabled(!away);
  update_titles();  // before they are laid out
}

QByteArray Docks::state() const { return kept_.isEmpty() ? window_->saveState() : kept_; }

void Docks::restore(const QByteArray& state) {
  if (kept_.isEmpty())
    window_->restoreState(state);
  else if (!state.isEmpty())
    kept_ = state;
}

/// A tab can be pulled out of its row, as a title can.
void Docks::update_titles() {
  for (QDockWidget* dock : docks_) {
    const QList<QDockWidget*> beside = window_->tabifiedDockWidgets(dock);
    const bool has_tab =
        !dock->isFloating() && std::any_of(beside.begin(), beside.end(), [](auto* other) { return !other->isHidden(); });
    if (has_tab == (dock->titleBarWidget() != nullptr)) continue;
    QWidget* old = dock->titleBarWidget();
    dock->setTitleBarWidget(has_tab ? new QWidget(dock) : nullptr);
    delete old;
  }
}

}  // namespace loopmend
