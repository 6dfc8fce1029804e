// SPDX-License-Identifier: GPL-3.0-or-later
#include "tools/tools_panel.h"

#include "panels/parts.h"

#include <QGridLayout>
#include <QGroupBox>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

#include <algorithm>

namespace loopmend {
namespace {

QGroupBox* group(const QString& title, QWidget* content) {
  auto* box = new QGroupBox(title);
  auto* layout = new QVBoxLayout(box);
  layout->addWidget(content);
  return box;
}

}  // namespace

ToolsPanel::ToolsPanel(RegionBox* region, PointsBox* points, BlendBox* blend, EdgesBox* edges, MirrorBox* mirror,
                       CutBox* cut, MeasureBox* measure, ProblemBox* trial, QWidget* parent)
    : QScrollArea(parent),
      trial_(trial) {
  setObjectName(QStringLiteral("toolsPanel"));
  setFrameShape(QFrame::NoFrame);
  setWidgetResizable(true);
  setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  auto* row = new QGridLayout;
  row->setSpacing(4);
  const auto choice = [&](const char* name, const QString& text, const QString& help, Tool tool) {
    auto* button = make_button(name, text, help);
    button->setCheckable(true);
    button->setMinimumWidth(40);
    connect(button, &QPushButton::clicked, this, [this, tool](bool on) {
      show_choice();  // until it is chosen
      Q_EMIT tool_wanted(on ? tool : Tool::none);
    });
    constexpr int columns = 3;
    const int place = static_cast<int>(choices_.size());
    choices_.push_back(button);
    row->addWidget(button, place / columns, place % columns);
  };
  choice("toolRegion", tr("Region"), tr("Make a region of a surface smooth, its neighborhood held (R)"), Tool::region);
  choice("toolPoints", tr("Points"), tr("A smooth surface through the vertices of a polyhedron (I)"), Tool::points);
  choice("toolBlend", tr("Blend"), tr("Join two or more boundaries by one patch (B)"), Tool::blend);
  choice("toolBridge", tr("Bridge"), tr("Part a hole into two by a strip between two of its vertices (G)"),
         Tool::bridge);
  choice("toolFillPart", tr("Fill part"), tr("Fill a part of a hole, between two of its vertices (Shift+G)"),
         Tool::fill_part);
  choice("toolEdges", tr("Edges"), tr("See, remove or draw the sharp edges that run on across holes (Shift+E)"),
         Tool::edges);
  choice("toolMirror", tr("Mirror"), tr("See the plane of symmetry, and what its image would fill (Shift+M)"),
         Tool::mirror);
  choice("toolCut", tr("Plane cut"), tr("Cut off one side of a plane, and close the section flat (Shift+X)"),
         Tool::cut);
  choice("toolMeasure", tr("Distance"), tr("The distance between two vertices (D)"), Tool::measure);
  auto* none = make_note(
      "toolsHint",
      tr("Choose a tool. Region makes a part of a surface smooth; Points finds a surface through the vertices "
         "of a polyhedron; Blend joins boundaries of one or several parts; Bridge parts a hole into two; Fill part "
         "closes "
         "a hole between two of its vertices; Edges shows where sharp edges run on; Mirror what the other side of the "
         "scan would fill; Plane cut removes one side of a plane; Distance measures between two "
         "vertices."));
  none->setAlignment(Qt::AlignTop);
  auto* bridge = make_note(
      "bridgeHint",
      tr("Click two vertices of a boundary. A strip of surface is laid between them, at once; Ctrl+Z takes it back. On "
         "one loop it makes two simpler holes. Between two loops it joins them into one."));
  bridge->setAlignment(Qt::AlignTop);
  auto* fill_part = make_note(
      "fillPartHint",
      tr("Click two vertices of one hole. A bridge is laid between them, and the marked part of the hole is filled and "
         "smoothed: the shorter one, or with Ctrl the longer one. One Ctrl+Z takes all of it back."));
  fill_part->setAlignment(Qt::AlignTop);
  pages_ = {none,
            group(tr("Region"), region),
            group(tr("Surface through points"), points),
            group(tr("Join boundaries"), blend),
            group(tr("Bridge"), bridge),
            group(tr("Fill a part of a hole"), fill_part),
            group(tr("Sharp edges across holes"), edges),
            group(tr("Mirror image"), mirror),
            group(tr("Plane cut"), cut),
            group(tr("Distance"), measure)};
  auto* content = new QWidget;
  auto* layout = new QVBoxLayout(content);
  layout->setContentsMargins(8, 6, 8, 8);
  layout->setSpacing(8);
  layout->addLayout(row);
  for (QWidget* page : pages_) layout->addWidget(page);
  layout->addWidget(trial_);
  layout->addStretch(1);
  setWidget(content);
  int widest = 0;
  for (QWidget* part : std::initializer_list<QWidget*>{region, points, blend, edges, mirror, cut, measure, trial})
    widest = std::max(widest, part->minimumSizeHint().width());
  constexpr int frames = 46;  // of the boxes, and the dock's own margins
  setMinimumWidth(widest + frames);
  choose(Tool::none);
}

void ToolsPanel::show_choice() {
  for (std::size_t k = 0; k < choices_.size(); ++k)
    choices_[k]->setChecked(static_cast<int>(k) + 1 == static_cast<int>(tool_));
}

void ToolsPanel::choose(Tool tool) {
  tool_ = tool;
  const int page = static_cast<int>(tool);
  for (std::size_t k = 0; k < pages_.size(); ++k) pages_[k]->setVisible(static_cast<int>(k) == page);
  show_choice();
  trial_->setVisible(makes_surfaces(tool));
  Q_EMIT tool_chosen(tool);
}

}  // namespace loopmend
