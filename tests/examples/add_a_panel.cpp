// SPDX-License-Identifier: GPL-3.0-or-later
// A panel that follows the document and the selection, and its test: docs/dev/add_a_panel.md, "Add a panel".
#include "document/hole_selection.h"
#include "document/labels.h"
#include "document/sheet.h"
#include "panels/parts.h"

#include <QApplication>
#include <QLabel>
#include <QPushButton>
#include <QSignalSpy>
#include <QVBoxLayout>
#include <QWidget>

#include <gtest/gtest.h>

#include <set>

namespace loopmend {

/// What is left to do: how many holes are open, how long the selected boundaries are, and the way to the next open hole.
class WorkLeftPanel : public QWidget {
  Q_OBJECT

 public:
  WorkLeftPanel(const Document& document, HoleSelection& selection, QWidget* parent = nullptr);

  void select_next();

 Q_SIGNALS:
  void fly_to(int loop);

 private:
  void update_state();
  std::set<int> open_holes() const;

  const Document& document_;
  HoleSelection& selection_;
  QLabel *left_, *chosen_;
  QPushButton* next_;
};

WorkLeftPanel::WorkLeftPanel(const Document& document, HoleSelection& selection, QWidget* parent)
    : QWidget(parent),
      document_(document),
      selection_(selection),
      left_(make_note("workLeft")),
      chosen_(make_note("workChosen")),
      next_(make_button("workNext", tr("&Next open hole"), tr("Select the next hole without a patch and show it"))) {
  setObjectName(QStringLiteral("workLeftPanel"));
  auto* layout = new QVBoxLayout(this);
  layout->addWidget(left_);
  layout->addWidget(chosen_);
  layout->addWidget(next_);
  layout->addStretch(1);
  connect(&document, &Document::opened, this, &WorkLeftPanel::update_state);
  connect(&document, &Document::scans_changed, this, &WorkLeftPanel::update_state);
  connect(&document, &Document::holes_changed, this, &WorkLeftPanel::update_state);
  connect(&selection, &HoleSelection::selection_changed, this, &WorkLeftPanel::update_state);
  connect(next_, &QPushButton::clicked, this, &WorkLeftPanel::select_next);
  update_state();
}

std::set<int> WorkLeftPanel::open_holes() const {
  std::set<int> holes;
  for (int loop = 0; loop < document_.loop_count(); ++loop)
    if (document_.fillable(loop) && !document_.patch_of(loop)) holes.insert(loop);
  return holes;
}

/// Goes through the document's loops and asks which are selected, not the other way round: while another scene opens, the
/// selection may still name loops of the one before.
void WorkLeftPanel::update_state() {
  int chosen = 0;
  double length = 0;
  for (int loop = 0; loop < document_.loop_count(); ++loop) {
    if (!selection_.selected().contains(loop) || !document_.present(loop)) continue;
    ++chosen;
    length += document_.loop(loop).perimeter;
  }
  const std::size_t left = open_holes().size();
  left_->setText(left == 0 ? tr("No hole is open.") : tr("%1 open").arg(labels::count(left)));
  chosen_->setText(chosen == 0 ? QString() : tr("%1 selected, length %2").arg(chosen).arg(labels::number(length)));
  next_->setEnabled(left > 0);
}

/// From the last selected loop on, and round again from the first.
void WorkLeftPanel::select_next() {
  const std::set<int> open = open_holes();
  if (open.empty()) return;
  const std::set<int>& selected = selection_.selected();
  const auto after = selected.empty() ? open.begin() : open.upper_bound(*selected.rbegin());
  const int loop = after == open.end() ? *open.begin() : *after;
  selection_.select({loop});
  Q_EMIT fly_to(loop);
}

namespace test {
namespace {

struct Shown {
  SheetDocument document;
  HoleSelection selection;
  WorkLeftPanel panel{document, selection};

  QString text(const char* name) const { return panel.findChild<QLabel*>(QLatin1String(name))->text(); }
  QPushButton& next() const { return *panel.findChild<QPushButton*>(QStringLiteral("workNext")); }
};

TEST(AddAPanel, CountsTheOpenHolesAsPatchesComeAndGo) {
  Shown shown;
  EXPECT_EQ(shown.text("workLeft"), QStringLiteral("2 open"));
  const int id = add_patch(shown.document, {square}, state_at(PatchStatus::filled));
  EXPECT_EQ(shown.text("workLeft"), QStringLiteral("1 open"));
  add_patch(shown.document, {diamond}, state_at(PatchStatus::converged));
  EXPECT_EQ(shown.text("workLeft"), QStringLiteral("No hole is open."));
  EXPECT_FALSE(shown.next().isEnabled());
  shown.document.replace({id}, {});
  EXPECT_EQ(shown.text("workLeft"), QStringLiteral("1 open"));
  shown.document.set_outer_rims(OuterRims::include);
  EXPECT_EQ(shown.text("workLeft"), QStringLiteral("2 open"));
}

TEST(AddAPanel, AddsUpTheSelectedBoundaries) {
  Shown shown;
  EXPECT_EQ(shown.text("workChosen"), QString());
  shown.selection.select({square});
  EXPECT_EQ(shown.text("workChosen"), QStringLiteral("1 selected, length 8.00"));
  shown.selection.toggle(diamond);
  EXPECT_EQ(shown.text("workChosen"), QStringLiteral("2 selected, length 13.7"));  // 8 + 4 √2
  shown.selection.clear();
  EXPECT_EQ(shown.text("workChosen"), QString());
}

TEST(AddAPanel, NextGoesRoundTheOpenHoles) {
  Shown shown;
  const QSignalSpy flights(&shown.panel, &WorkLeftPanel::fly_to);
  for (int loop : {square, diamond, square}) {
    shown.next().click();
    EXPECT_EQ(shown.selection.selected(), std::set<int>{loop});
    EXPECT_EQ(flights.last().front().toInt(), loop);
  }
  add_patch(shown.document, {diamond}, state_at(PatchStatus::filled));
  shown.next().click();
  EXPECT_EQ(shown.selection.selected(), std::set<int>{square}) << "the only one left";
}

TEST(AddAPanel, AnotherSceneTakesTheOldSelectionAway) {
  Shown shown;
  shown.selection.select({square, diamond});
  shown.document.clear();
  EXPECT_EQ(shown.text("workLeft"), QStringLiteral("No hole is open."));
  EXPECT_EQ(shown.text("workChosen"), QString());
}

TEST(AddAPanel, EveryControlSaysWhatItIs) {
  Shown shown;
  for (const QPushButton* button : shown.panel.findChildren<QPushButton*>()) {
    EXPECT_FALSE(button->accessibleName().isEmpty());
    EXPECT_FALSE(button->toolTip().isEmpty());
  }
}

}  // namespace
}  // namespace test
}  // namespace loopmend

int main(int argc, char** argv) {
  qputenv("QT_QPA_PLATFORM", "offscreen");  // no display is needed: nothing is drawn by OpenGL
  ::testing::InitGoogleTest(&argc, argv);
  const QApplication application(argc, argv);
  return RUN_ALL_TESTS();
}

#include "add_a_panel.moc"
