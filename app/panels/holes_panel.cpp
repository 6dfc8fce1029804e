// SPDX-License-Identifier: GPL-3.0-or-later
#include "panels/holes_panel.h"

#include "document/document.h"
#include "document/hole_filter.h"
#include "document/hole_selection.h"
#include "document/hole_table.h"
#include "document/labels.h"
#include "panels/hole_delegate.h"
#include "panels/parts.h"
#include "panels/small_holes_box.h"
#include "panels/verdict_box.h"

#include <QAction>
#include <QComboBox>
#include <QEvent>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QPushButton>
#include <QScopedValueRollback>
#include <QTableView>
#include <QToolButton>
#include <QVBoxLayout>

#include <algorithm>
#include <utility>

namespace loopmend {
namespace {

constexpr int lowest = 76;  ///< of the table: the head and two rows

/// Home and End go to the first and the last row, not along a row: with Shift they extend the selection until there.
class RowsView : public QTableView {
 protected:
  QModelIndex moveCursor(CursorAction action, Qt::KeyboardModifiers modifiers) override {
    if (action == MoveHome || action == MoveEnd) modifiers |= Qt::ControlModifier;
    return QTableView::moveCursor(action, modifiers);
  }
};

}  // namespace

HolesPanel::HolesPanel(Document& document, HoleSelection& selection, QWidget* parent)
    : QWidget(parent),
      document_(document),
      selection_(selection),
      model_(new HoleTable(document, this)),
      sorted_(new HoleFilter(document, this)),
      table_(new RowsView),
      summary_(new QLabel),
      all_(make_button("selectAllHoles", tr("Select all"),
                       tr("Select every hole; outer rims, cracks and cuts are left out"))),
      next_(make_button("nextToLookAtButton", tr("Next to look at"),
                        tr("Select the next hole whose patch has a fault or a doubt, or that stayed open, and fly "
                           "there (L)"))),
      small_(new SmallHolesBox(document)) {
  setObjectName(QStringLiteral("holesPanel"));
  summary_->setObjectName(QStringLiteral("holesSummary"));
  build_table();
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(8, 6, 8, 8);
  layout->setSpacing(6);
  layout->addWidget(table_, 1);
  auto* below = new QHBoxLayout;
  below->addWidget(summary_, 1);
  below->addWidget(next_);
  auto* verdict = new VerdictBox(document, selection);
  layout->addWidget(verdict);
  // Together they need the same height at all times: in a low window the buttons below would move.
  const auto share = [this, verdict] { table_->setMinimumHeight(lowest + verdict->spare_height()); };
  connect(verdict, &VerdictBox::spare_height_changed, table_, share);
  share();
  layout->addLayout(below);
  auto* last = new QHBoxLayout;
  auto* rest = new QWidget;
  auto* folded = make_layout<QVBoxLayout>(rest);
  folded->addWidget(build_filter());
  folded->addWidget(small_);
  fold_ = make_fold("fillBySize", tr("Filter, fill by size"), rest);
  last->addWidget(fold_);
  last->addStretch(1);
  last->addWidget(all_);
  layout->addLayout(last);
  layout->addWidget(rest);
  const QMargins around = layout->contentsMargins();
  setMinimumWidth(small_->minimumSizeHint().width() + around.left() +
                  around.right());  // opened, it must not make the column wider

  connect(&document, &Document::opened, this, &HolesPanel::update_summary);
  connect(&document, &Document::scans_changed, this, [this] {
    const bool several = document_.scans().size() > 1;
    if (several != std::exchange(several_, several)) table_->setColumnHidden(HoleTable::scan, !several);
    fit_columns();
    update_summary();
    show_selection();
  });
  connect(&document, &Document::holes_changed, this, [this] {
    fit_state_column();
    update_summary();
  });
  connect(model_, &QAbstractItemModel::headerDataChanged, this, &HolesPanel::fit_columns);
  connect(all_, &QPushButton::clicked, this, &HolesPanel::select_all_holes);
  connect(next_, &QPushButton::clicked, this, [this] { go(Way::next_to_look_at); });
  connect(small_, &SmallHolesBox::fill_wanted, this, &HolesPanel::fill_wanted);
  connect(table_->selectionModel(), &QItemSelectionModel::selectionChanged, this, &HolesPanel::take_selection);
  connect(table_, &QTableView::entered, this, [this](const QModelIndex& i) { selection_.hover(loop_at(i)); });
  connect(table_, &QTableView::doubleClicked, this, [this](const QModelIndex& i) { Q_EMIT fly_to(loop_at(i)); });
  connect(&selection, &HoleSelection::selection_changed, this, &HolesPanel::show_selection);
  connect(&selection, &HoleSelection::hover_changed, this, &HolesPanel::show_hover);
  update_summary();
}

QWidget* HolesPanel::build_filter() {
  words_ = new QLineEdit;
  words_->setPlaceholderText(tr("Filter: number, kind, state"));
  words_->setClearButtonEnabled(true);
  explain(words_, "holesFilter", tr("Filter"),
          tr("Show only the loops with these words: a number, a kind, a state, a file (Ctrl+L)"));
  group_ = new QComboBox;
  for (const auto& [text, group] : {std::pair{tr("All loops"), HoleGroup::all},
                                    {tr("Open loops"), HoleGroup::to_do},
                                    {tr("Filled"), HoleGroup::filled},
                                    {tr("Accepted"), HoleGroup::accepted},
                                    {tr("To look at"), HoleGroup::fault},
                                    {tr("Left out"), HoleGroup::left_out}})
    group_->addItem(text, static_cast<int>(group));
  explain(group_, "holesGroup", tr("Group"), tr("Show only the loops of one group"));
  // Narrowing the table must not change what is selected: hidden rows stay selected.
  const auto narrow = [this](const auto& act) {
    const QScopedValueRollback guard(syncing_, true);
    act();
  };
  connect(words_, &QLineEdit::textChanged, this, [this, narrow](const QString& text) {
    narrow([&] { sorted_->set_words(text); });
    show_selection();
    update_summary();
  });
  connect(group_, QOverload<int>::of(&QComboBox::currentIndexChanged), this, [this, narrow] {
    narrow([&] { sorted_->set_group(static_cast<HoleGroup>(group_->currentData().toInt())); });
    show_selection();
    update_summary();
  });
  auto* row = new QWidget;
  auto* layout = make_layout<QHBoxLayout>(row);
  layout->addWidget(words_, 1);
  layout->addWidget(group_);
  return row;
}

void HolesPanel::focus_filter() {
  fold_->setChecked(true);
  words_->setFocus(Qt::ShortcutFocusReason);
  words_->selectAll();
}

void HolesPanel::build_table() {
  sorted_->setSourceModel(model_);
  explain(table_, "holesTable", tr("Boundary loops"), tr("Every boundary loop; double click or Return flies there"));
  table_->setToolTip({});  // the cells have their own
  table_->setModel(sorted_);
  table_->setItemDelegate(new HoleDelegate(document_, selection_, table_));
  table_->setSelectionBehavior(QAbstractItemView::SelectRows);
  table_->setSelectionMode(QAbstractItemView::ExtendedSelection);
  table_->setEditTriggers(QAbstractItemView::NoEditTriggers);
  table_->setMouseTracking(true);
  table_->viewport()->installEventFilter(this);
  table_->installEventFilter(this);
  table_->setShowGrid(false);
  table_->setWordWrap(false);
  table_->setTabKeyNavigation(false);
  table_->setSortingEnabled(true);
  table_->sortByColumn(HoleTable::number, Qt::AscendingOrder);
  table_->verticalHeader()->hide();
  table_->verticalHeader()->setSectionResizeMode(QHeaderView::Fixed);
  table_->verticalHeader()->setDefaultSectionSize(fontMetrics().height() + 9);
  QHeaderView* header = table_->horizontalHeader();
  header->setHighlightSections(false);
  header->setSectionResizeMode(QHeaderView::Interactive);
  header->setSectionResizeMode(HoleTable::state, QHeaderView::Stretch);
  header->setMinimumSectionSize(30);
  header->setResizeContentsPrecision(100);
  header->setContextMenuPolicy(Qt::CustomContextMenu);
  connect(header, &QHeaderView::customContextMenuRequested, this,
          [this, header](const QPoint& at) { show_column_menu(header->mapToGlobal(at)); });
  table_->setContextMenuPolicy(Qt::CustomContextMenu);
  connect(table_, &QTableView::customContextMenuRequested, this, [this](const QPoint& at) {
    const QPoint place = table_->viewport()->mapToGlobal(at);
    table_->indexAt(at).isValid() ? Q_EMIT hole_menu_wanted(place) : show_column_menu(place);
  });
  for (int column : {HoleTable::edges, HoleTable::perimeter, HoleTable::area, HoleTable::planarity, HoleTable::kind,
                     HoleTable::scan, HoleTable::boundary})
    table_->setColumnHidden(column, true);
  fit_columns();
}

void HolesPanel::show_column_menu(const QPoint& at) {
  QMenu menu(this);
  menu.setObjectName(QStringLiteral("columnMenu"));
  QMenu* sort = menu.addMenu(tr("&Sort by"));
  for (int column = HoleTable::number; column < HoleTable::column_count; ++column) {
    if (table_->isColumnHidden(column)) continue;
    QAction* action = sort->addAction(model_->headerData(column, Qt::Horizontal, Qt::DisplayRole).toString());
    connect(action, &QAction::triggered, this, [this, column] {
      const QHeaderView* header = table_->horizontalHeader();
      const bool again = header->sortIndicatorSection() == column && header->sortIndicatorOrder() == Qt::AscendingOrder;
      table_->sortByColumn(column, again ? Qt::DescendingOrder : Qt::AscendingOrder);
    });
  }
  menu.addSeparator();
  for (int column = HoleTable::edges; column < HoleTable::state; ++column) {
    QAction* action = menu.addAction(model_->headerData(column, Qt::Horizontal, Qt::DisplayRole).toString());
    action->setCheckable(true);
    action->setChecked(!table_->isColumnHidden(column));
    connect(action, &QAction::toggled, this, [this, column](bool on) {
      table_->setColumnHidden(column, !on);
      fit_columns();
    });
  }
  menu.exec(at);
}

/// Takes what is left; where that is too little for its longest word, the table scrolls.
void HolesPanel::fit_state_column() {
  constexpr int sign_and_margins = 32;
  int needed = 0;
  std::set<QString> texts;
  for (int loop = 0; loop < document_.loop_count(); ++loop)
    if (document_.present(loop)) texts.insert(labels::verdict_or_state(document_, loop));
  for (const QString& text : texts) needed = std::max(needed, fontMetrics().horizontalAdvance(text));
  needed += sign_and_margins;
  int left = table_->viewport()->width();
  for (int column = 0; column < HoleTable::state; ++column)
    if (!table_->isColumnHidden(column)) left -= table_->columnWidth(column);
  QHeaderView* header = table_->horizontalHeader();
  header->setSectionResizeMode(HoleTable::state, left < needed ? QHeaderView::Fixed : QHeaderView::Stretch);
  if (left < needed) header->resizeSection(HoleTable::state, needed);
}

void HolesPanel::fit_columns() {
  constexpr int margin = 10, arrow = 14;
  const QFontMetrics letters(table_->horizontalHeader()->font());
  for (int column = HoleTable::number; column < HoleTable::state; ++column) {
    if (table_->isColumnHidden(column)) continue;
    const int title = letters.horizontalAdvance(model_->headerData(column, Qt::Horizontal, Qt::DisplayRole).toString());
    int content = static_cast<const QAbstractItemView*>(table_)->sizeHintForColumn(column);
    if (column == HoleTable::boundary)  // its words come when holes are filled
      for (const NeighborhoodKind kind : {NeighborhoodKind::smooth, NeighborhoodKind::noisy, NeighborhoodKind::rough})
        content = std::max(content, letters.horizontalAdvance(labels::neighborhood(kind)) + margin);
    table_->setColumnWidth(column,
                           std::max(title + margin + (column == HoleTable::number ? arrow : 0), content + margin / 2));
  }
  fit_state_column();
}

int HolesPanel::loop_at(const QModelIndex& proxy_index) const {
  return proxy_index.isValid() ? sorted_->mapToSource(proxy_index).row() : no_loop;
}

bool HolesPanel::eventFilter(QObject* watched, QEvent* event) {
  if (watched == table_->viewport() && event->type() == QEvent::Leave) selection_.hover(no_loop);
  if (watched == table_->viewport() && event->type() == QEvent::Resize) fit_state_column();
  if (watched == table_ && event->type() == QEvent::KeyPress) {
    const int key = static_cast<QKeyEvent*>(event)->key();
    if ((key == Qt::Key_Return || key == Qt::Key_Enter) && table_->currentIndex().isValid()) {
      Q_EMIT fly_to(loop_at(table_->currentIndex()));
      return true;
    }
  }
  return QWidget::eventFilter(watched, event);
}

void HolesPanel::take_selection() {
  if (syncing_) return;
  const QScopedValueRollback guard(syncing_, true);
  std::set<int> loops;
  for (const QModelIndex& row : table_->selectionModel()->selectedRows()) loops.insert(loop_at(row));
  selection_.select(loops);
}

/// Neighbouring rows as one range: thousands of single ones would take the selection model seconds.
void HolesPanel::show_selection() {
  if (syncing_) return;
  const QScopedValueRollback guard(syncing_, true);
  std::vector<int> rows;
  for (int loop : selection_.selected())
    if (const QModelIndex at = sorted_->mapFromSource(model_->index(loop, 0)); at.isValid()) rows.push_back(at.row());
  std::sort(rows.begin(), rows.end());
  // What was selected in the picture is where the keys go on from.
  if (!rows.empty() && !std::binary_search(rows.begin(), rows.end(), table_->currentIndex().row()))
    table_->setCurrentIndex(sorted_->index(rows.front(), HoleTable::number));
  QItemSelection ranges;
  for (std::size_t i = 0; i < rows.size();) {
    std::size_t last = i;
    while (last + 1 < rows.size() && rows[last + 1] == rows[last] + 1) ++last;
    ranges.append(
        QItemSelectionRange(sorted_->index(rows[i], 0), sorted_->index(rows[last], HoleTable::column_count - 1)));
    i = last + 1;
  }
  table_->selectionModel()->select(ranges, QItemSelectionModel::ClearAndSelect);
  if (!rows.empty() && rows.size() < 100) table_->scrollTo(sorted_->index(rows.front(), 0));
}

void HolesPanel::go(Way way) {
  const int count = sorted_->rowCount();
  if (count == 0) return;
  const bool forward = way != Way::previous;
  int row = forward ? -1 : count;
  if (!selection_.selected().empty()) {
    const int loop = forward ? *selection_.selected().rbegin() : *selection_.selected().begin();
    if (const QModelIndex at = sorted_->mapFromSource(model_->index(loop, 0)); at.isValid()) row = at.row();
  }
  // Outer rims and cracks are passed over, unless there is nothing else.
  int tried = 0;
  for (; tried < count; ++tried) {
    row = (row + (forward ? 1 : count - 1)) % count;
    const int loop = loop_at(sorted_->index(row, 0));
    if (way == Way::next_to_look_at ? document_.to_look_at(loop) : document_.fillable(loop)) break;
  }
  if (way == Way::next_to_look_at && tried == count) return;
  const int loop = loop_at(sorted_->index(std::clamp(row, 0, count - 1), 0));
  selection_.select({loop});
  Q_EMIT fly_to(loop);
}

/// Only the two rows: to paint the whole table takes longer than all else that hovering does.
void HolesPanel::show_hover() {
  const int loop = selection_.hovered();
  paint_row(std::exchange(lit_, loop));
  paint_row(loop);
  if (loop >= document_.loop_count()) return;
  if (loop != no_loop && !table_->viewport()->underMouse())
    table_->scrollTo(sorted_->mapFromSource(model_->index(loop, 0)));
}

void HolesPanel::paint_row(int loop) {
  const QModelIndex row = sorted_->mapFromSource(model_->index(loop, 0));
  if (!row.isValid()) return;
  const QRect place(0, table_->rowViewportPosition(row.row()), table_->viewport()->width(),
                    table_->rowHeight(row.row()));
  table_->viewport()->update(place);
}

void HolesPanel::update_summary() {
  int holes = 0, open = 0;
  bool any_to_look_at = false;
  for (int loop = 0; loop < document_.loop_count(); ++loop) {
    if (!document_.present(loop)) continue;
    any_to_look_at = any_to_look_at || document_.to_look_at(loop);
    if (is_left_out(document_, loop)) continue;
    ++holes;
    if (!document_.patch_of(loop)) ++open;
  }
  const int left_out = loops_left_out(document_);
  all_->setEnabled(holes > 0);
  next_->setEnabled(any_to_look_at);
  if (!document_.has_scan()) {
    summary_->setText(tr("No scan is open"));
  } else if (holes + left_out == 0) {
    summary_->setText(tr("No holes: closed surface"));
  } else {
    QString text = tr("%Ln hole(s), %L1 open", nullptr, holes).arg(open);
    if (left_out > 0) text += tr("; %L1 left out").arg(left_out);
    if (sorted_->narrowed()) text += tr("; %L1 shown").arg(sorted_->rowCount());
    summary_->setText(text);
  }
}

void HolesPanel::select_all_holes() {
  std::set<int> loops;
  for (int loop = 0; loop < document_.loop_count(); ++loop)
    if (document_.fillable(loop)) loops.insert(loop);
  selection_.select(loops);
}

}  // namespace loopmend
