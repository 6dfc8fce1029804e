#include "panels/holes_panel.h"

#include "document/document.h"
#include "document/hole_selection.h"
#include "document/hole_table.h"
#include "panels/hole_delegate.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QScopedValueRollback>
#include <QSortFilterProxyModel>
#include <QTableView>
#include <QVBoxLayout>

namespace loopmend {

HolesPanel::HolesPanel(const Document& document, HoleSelection& selection, QWidget* parent)
    : QWidget(parent),
      document_(document),
      selection_(selection),
      model_(new HoleTable(document, this)),
      sorted_(new QSortFilterProxyModel(this)),
      table_(new QTableView),
      summary_(new QLabel),
      all_(new QPushButton(tr("Select all holes"))) {
  setObjectName(QStringLiteral("holesPanel"));
  summary_->setObjectName(QStringLiteral("holesSummary"));
  all_->setObjectName(QStringLiteral("selectAllHoles"));
  all_->setToolTip(tr("Select every hole; outer rims and cuts are left out"));
  build_table();
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(8, 6, 8, 8);
  layout->setSpacing(6);
  auto* top = new QHBoxLayout;
  top->addWidget(summary_, 1);
  top->addWidget(all_);
  layout->addLayout(top);
  layout->addWidget(table_, 1);

  connect(&document, &Document::opened, this, &HolesPanel::on_opened);
  connect(&document, &Document::holes_changed, this, &HolesPanel::update_summary);
  connect(all_, &QPushButton::clicked, this, &HolesPanel::select_all_holes);
  connect(table_->selectionModel(), &QItemSelectionModel::selectionChanged, this, &HolesPanel::take_selection);
  connect(table_, &QTableView::entered, this, [this](const QModelIndex& i) { selection_.hover(loop_at(i)); });
  connect(table_, &QTableView::doubleClicked, this, [this](const QModelIndex& i) { Q_EMIT fly_to(loop_at(i)); });
  connect(&selection, &HoleSelection::selection_changed, this, &HolesPanel::show_selection);
  connect(&selection, &HoleSelection::hover_changed, this, &HolesPanel::show_hover);
  update_summary();
}

void HolesPanel::build_table() {
  sorted_->setSourceModel(model_);
  sorted_->setSortRole(HoleTable::sort_role);
  table_->setObjectName(QStringLiteral("holesTable"));
  table_->setModel(sorted_);
  table_->setItemDelegate(new HoleDelegate(document_, selection_, table_));
  table_->setSelectionBehavior(QAbstractItemView::SelectRows);
  table_->setSelectionMode(QAbstractItemView::ExtendedSelection);
  table_->setEditTriggers(QAbstractItemView::NoEditTriggers);
  table_->setMouseTracking(true);
  table_->viewport()->installEventFilter(this);
  table_->setShowGrid(false);
  table_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
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
  header->setStretchLastSection(true);
  header->setMinimumSectionSize(30);
  header->setResizeContentsPrecision(100);
  fit_columns();
}

/// The state column takes what is left; it should be enough for its longest word.
void HolesPanel::fit_columns() {
  constexpr int margin = 14, arrow = 14;
  const QFontMetrics letters(table_->horizontalHeader()->font());
  for (int column = HoleTable::number; column < HoleTable::state; ++column) {
    const int title = letters.horizontalAdvance(model_->headerData(column, Qt::Horizontal, Qt::DisplayRole).toString());
    const int content = static_cast<const QAbstractItemView*>(table_)->sizeHintForColumn(column);
    table_->setColumnWidth(column,
                           std::max(title + margin + (column == HoleTable::number ? arrow : 0), content + margin / 2));
  }
}

void HolesPanel::on_opened() {
  fit_columns();
  update_summary();
}

int HolesPanel::loop_at(const QModelIndex& proxy_index) const {
  return proxy_index.isValid() ? sorted_->mapToSource(proxy_index).row() : no_loop;
}

bool HolesPanel::eventFilter(QObject* watched, QEvent* event) {
  if (watched == table_->viewport() && event->type() == QEvent::Leave) selection_.hover(no_loop);
  return QWidget::eventFilter(watched, event);
}

void HolesPanel::take_selection() {
  if (syncing_) return;
  const QScopedValueRollback guard(syncing_, true);
  std::set<int> loops;
  for (const QModelIndex& row : table_->selectionModel()->selectedRows()) loops.insert(loop_at(row));
  selection_.select(loops);
}

void HolesPanel::show_selection() {
  if (syncing_) return;
  const QScopedValueRollback guard(syncing_, true);
  QItemSelection rows;
  for (int loop : selection_.selected()) {
    const QModelIndex first = sorted_->mapFromSource(model_->index(loop, 0));
    rows.select(first, first.siblingAtColumn(HoleTable::column_count - 1));
  }
  table_->selectionModel()->select(rows, QItemSelectionModel::ClearAndSelect);
  if (!rows.isEmpty()) table_->scrollTo(rows.indexes().first());
}

void HolesPanel::show_hover() {
  table_->viewport()->update();
  const int loop = selection_.hovered();
  if (loop != no_loop && !table_->viewport()->underMouse())
    table_->scrollTo(sorted_->mapFromSource(model_->index(loop, 0)));
}

void HolesPanel::update_summary() {
  const int count = static_cast<int>(document_.loops().size());
  int holes = 0, open = 0;
  for (int loop = 0; loop < count; ++loop) {
    if (!document_.fillable(loop)) continue;
    ++holes;
    if (!document_.patch_of(loop)) ++open;
  }
  all_->setEnabled(holes > 0);
  if (!document_.has_scan()) {
    summary_->setText(tr("No scan is open"));
  } else if (count == 0) {
    summary_->setText(tr("No holes: closed surface"));
  } else {
    QString text = holes == 1 ? tr("1 hole, %1 open").arg(open) : tr("%1 holes, %2 open").arg(holes).arg(open);
    if (count > holes) text += tr("; %1 left out").arg(count - holes);
    summary_->setText(text);
  }
}

void HolesPanel::select_all_holes() {
  std::set<int> loops;
  for (int loop = 0; loop < static_cast<int>(document_.loops().size()); ++loop)
    if (document_.fillable(loop)) loops.insert(loop);
  selection_.select(loops);
}

}  // namespace loopmend
