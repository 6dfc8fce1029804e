// SPDX-License-Identifier: GPL-3.0-or-later
#include "panels/scene_panel.h"

#include "document/labels.h"
#include "panels/parts.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>
#include <QScopedValueRollback>
#include <QStyledItemDelegate>
#include <QTreeWidget>
#include <QVBoxLayout>

#include <algorithm>

namespace loopmend {
namespace {

constexpr int kind_role = Qt::UserRole, scan_role = Qt::UserRole + 1, number_role = Qt::UserRole + 2;
constexpr int wait_ms = 60;

/// With boxes that can be seen on a dark ground: the style draws their outline in a darker shade of the window's.
class RowDelegate : public QStyledItemDelegate {
 public:
  using QStyledItemDelegate::QStyledItemDelegate;

 protected:
  void initStyleOption(QStyleOptionViewItem* option, const QModelIndex& index) const override {
    QStyledItemDelegate::initStyleOption(option, index);
    const QColor text = option->palette.color(QPalette::Text), ground = option->palette.color(QPalette::Base);
    option->palette.setColor(QPalette::Window,
                             QColor((text.red() + ground.red()) / 2, (text.green() + ground.green()) / 2,
                                    (text.blue() + ground.blue()) / 2));
  }
};

}  // namespace

ScenePanel::ScenePanel(const Document& document, SceneVisibility& visibility, QWidget* parent)
    : QWidget(parent),
      document_(document),
      visibility_(visibility),
      tree_(new QTreeWidget),
      isolate_(make_button("sceneIsolate", tr("Isolate"), tr("Hide everything but the chosen row (Shift+H)"))),
      show_all_(make_button("sceneShowAll", tr("Show all"), tr("Show everything that was hidden (Ctrl+H)"))),
      note_(make_note("sceneNote")),
      unit_(new QComboBox) {
  setObjectName(QStringLiteral("scenePanel"));
  explain(tree_, "sceneTree", tr("Scene"),
          tr("Scans, their components and patches; the check boxes hide and show them"));
  tree_->setToolTip({});
  tree_->setItemDelegate(new RowDelegate(tree_));
  tree_->setColumnCount(2);
  tree_->setHeaderLabels({tr("Shown"), tr("Triangles")});
  tree_->header()->setStretchLastSection(false);
  tree_->header()->setSectionResizeMode(0, QHeaderView::Stretch);
  tree_->header()->setSectionResizeMode(1, QHeaderView::ResizeToContents);
  tree_->setUniformRowHeights(true);
  tree_->setIndentation(14);
  tree_->setContextMenuPolicy(Qt::CustomContextMenu);
  note_->setText(tr("Hiding changes the picture alone: what is hidden is filled, checked and exported as before."));
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(8, 6, 8, 8);
  layout->setSpacing(6);
  layout->addWidget(tree_, 1);
  auto* row = new QHBoxLayout;
  row->addWidget(isolate_);
  row->addWidget(show_all_);
  row->addStretch(1);
  layout->addLayout(row);
  layout->addWidget(note_);
  unit_->addItem(labels::unit_name({}), QString());
  for (const char* unit : length_units) unit_->addItem(labels::unit_name(unit), QLatin1String(unit));
  explain(unit_, "sceneUnit", tr("Lengths in"),
          tr("What the lengths of the scans are measured in. Nothing is converted; it is shown, and written to 3MF"));
  auto* unit_label = new QLabel(tr("Lengths in"));
  unit_label->setBuddy(unit_);
  auto* unit_row = new QHBoxLayout;
  unit_row->addWidget(unit_label);
  unit_row->addWidget(unit_, 1);
  layout->addLayout(unit_row);

  later_.setSingleShot(true);
  later_.setInterval(wait_ms);
  connect(&later_, &QTimer::timeout, this, &ScenePanel::rebuild);
  for (auto signal : {&Document::opened, &Document::scans_changed, &Document::patches_changed})
    connect(&document_, signal, &later_, qOverload<>(&QTimer::start));
  for (auto signal : {&Document::opened, &Document::scans_changed, &Document::units_changed})
    connect(&document_, signal, this, &ScenePanel::show_unit);
  connect(&document_, &Document::units_changed, &later_, qOverload<>(&QTimer::start));
  connect(unit_, qOverload<int>(&QComboBox::activated), this,
          [this] { Q_EMIT unit_chosen(unit_->currentData().toString().toStdString()); });
  show_unit();
  connect(&visibility_, &SceneVisibility::changed, this, &ScenePanel::show_checks);
  connect(tree_, &QTreeWidget::itemChanged, this, &ScenePanel::on_checked);
  connect(tree_, &QTreeWidget::currentItemChanged, this, &ScenePanel::show_checks);
  connect(tree_, &QTreeWidget::customContextMenuRequested, this, [this](const QPoint& at) {
    if (const QTreeWidgetItem* item = tree_->itemAt(at); item && !later_.isActive() && !pieces_of(item).empty())
      Q_EMIT menu_wanted(pieces_of(item), tree_->viewport()->mapToGlobal(at));
  });
  connect(isolate_, &QPushButton::clicked, this, &ScenePanel::isolate_current);
  connect(show_all_, &QPushButton::clicked, &visibility_, &SceneVisibility::show_all);
  show_checks();
}

void ScenePanel::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  rebuild();
}

/// Invisible while another tab lies over it.
void ScenePanel::rebuild() {
  if (!isVisible()) return;
  {
    const QScopedValueRollback guard(syncing_, true);
    tree_->clear();
    for (int scan : document_.scans()) add_scan(scan);
  }
  show_checks();
}

QTreeWidgetItem* ScenePanel::add_row(QTreeWidgetItem* parent, Row kind, int scan, int number, const QString& name,
                                     const QString& size) {
  auto* row = new QTreeWidgetItem({name, size});
  row->setData(0, kind_role, static_cast<int>(kind));
  row->setData(0, scan_role, scan);
  row->setData(0, number_role, number);
  row->setFlags(Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemIsUserCheckable);
  row->setCheckState(0, Qt::Checked);
  row->setTextAlignment(1, Qt::AlignRight | Qt::AlignVCenter);
  row->setToolTip(0, name);
  parent ? parent->addChild(row) : tree_->addTopLevelItem(row);
  return row;
}

void ScenePanel::add_scan(int scan) {
  const auto opened = document_.scan(scan);
  QTreeWidgetItem* top =
      add_row(nullptr, Row::scan, scan, 0, opened->name, labels::count(opened->model->soup_face.size()));
  const std::vector<ScanPieces::Piece>& pieces = opened->pieces.list;
  const std::size_t own = std::min(pieces.size(), static_cast<std::size_t>(most_rows));
  if (pieces.size() > 1)
    for (std::size_t k = 0; k < own; ++k)
      add_row(top, Row::piece, scan, static_cast<int>(k),
              tr("Component %1, %2 across").arg(k + 1).arg(labels::length(document_, pieces[k].diameter)),
              labels::count(pieces[k].triangles));
  if (own < pieces.size()) {
    std::size_t triangles = 0;
    for (std::size_t k = own; k < pieces.size(); ++k) triangles += pieces[k].triangles;
    add_row(top, Row::small_pieces, scan, static_cast<int>(own),
            tr("%Ln smaller component(s)", nullptr, static_cast<int>(pieces.size() - own)), labels::count(triangles));
  }
  add_patches(top, scan);
  top->setExpanded(true);
}

void ScenePanel::add_patches(QTreeWidgetItem* scan_row, int scan) {
  std::vector<const OpenPatch*> patches;
  std::size_t triangles = 0;
  for (const OpenPatch& patch : document_.patches())
    if (patch.scan == scan) {
      patches.push_back(&patch);
      triangles += static_cast<std::size_t>(patch.state->patch.patch_triangles);
    }
  if (patches.empty()) return;
  QTreeWidgetItem* all =
      add_row(scan_row, Row::patches, scan, 0, tr("%Ln patch(es)", nullptr, static_cast<int>(patches.size())),
              labels::count(triangles));
  if (patches.size() > most_rows) return;
  for (const OpenPatch* patch : patches)
    add_row(all, Row::patch, scan, patch->id,
            labels::sentence(labels::holes(document_, {patch->loops.begin(), patch->loops.end()})),
            labels::count(static_cast<std::size_t>(patch->state->patch.patch_triangles)));
}

std::set<PieceId> ScenePanel::pieces_of(const QTreeWidgetItem* row) const {
  const auto kind = static_cast<Row>(row->data(0, kind_role).toInt());
  const int scan = row->data(0, scan_role).toInt(), number = row->data(0, number_role).toInt();
  if (kind == Row::patch || kind == Row::patches) return {};
  const int first = kind == Row::scan ? 0 : number;
  const int last = kind == Row::piece ? number + 1 : visibility_.piece_count(scan);
  std::set<PieceId> pieces;
  for (int piece = first; piece < last; ++piece) pieces.insert({scan, piece});
  return pieces;
}

std::set<int> ScenePanel::patches_of(const QTreeWidgetItem* row) const {
  const auto kind = static_cast<Row>(row->data(0, kind_role).toInt());
  if (kind == Row::patch) return {row->data(0, number_role).toInt()};
  std::set<int> ids;
  for (const OpenPatch& patch : document_.patches())
    if (kind == Row::patches && patch.scan == row->data(0, scan_role).toInt()) ids.insert(patch.id);
  return ids;
}

Qt::CheckState ScenePanel::check_of(const QTreeWidgetItem* row) const {
  const std::set<PieceId> pieces = pieces_of(row);
  const std::set<int> patches = patches_of(row);
  const auto hidden =
      std::count_if(pieces.begin(), pieces.end(), [&](const PieceId& p) { return visibility_.is_hidden(p); }) +
      std::count_if(patches.begin(), patches.end(), [&](int id) {
        const OpenPatch* patch = document_.patch(id);
        return patch && visibility_.is_hidden_patch(*patch);
      });
  if (hidden == 0) return Qt::Checked;
  return static_cast<std::size_t>(hidden) == pieces.size() + patches.size() ? Qt::Unchecked : Qt::PartiallyChecked;
}

void ScenePanel::show_checks() {
  const QScopedValueRollback guard(syncing_, true);
  if (!later_.isActive())  // else the rows are of a scene that is gone
    for (QTreeWidgetItemIterator it(tree_); *it; ++it) (*it)->setCheckState(0, check_of(*it));
  const QTreeWidgetItem* current = tree_->currentItem();
  isolate_->setEnabled(!later_.isActive() && current && !pieces_of(current).empty());
  show_all_->setEnabled(visibility_.hidden_count() > 0);
}

void ScenePanel::on_checked(QTreeWidgetItem* row) {
  if (syncing_) return;
  using Visible = SceneVisibility::Visible;
  const Visible visible = row->checkState(0) == Qt::Unchecked ? Visible::hidden : Visible::shown;
  std::set<PieceId> pieces = pieces_of(row);
  const std::set<int> patches = patches_of(row);
  if (visible == Visible::shown)  // a patch alone would hang in the air
    for (int id : patches)
      if (const OpenPatch* patch = document_.patch(id))
        for (int loop : patch->loops) pieces.insert(visibility_.piece_of_loop(loop));
  if (!pieces.empty()) visibility_.set_pieces(pieces, visible);
  if (!patches.empty()) visibility_.set_patches(patches, visible);
}

void ScenePanel::show_unit() {
  unit_->setEnabled(document_.has_scan());
  unit_->setCurrentIndex(std::max(0, unit_->findData(QString::fromStdString(document_.unit()))));
}

void ScenePanel::isolate_current() {
  if (const QTreeWidgetItem* row = tree_->currentItem(); row && !pieces_of(row).empty())
    visibility_.isolate(pieces_of(row));
}

}  // namespace loopmend
