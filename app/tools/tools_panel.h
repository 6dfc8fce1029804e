// SPDX-License-Identifier: GPL-3.0-or-later
// The tools dock: which tool is in hand, its settings, and the box in which what it makes is tried out.
#pragma once

#include "tools/blend_box.h"
#include "tools/cut_box.h"
#include "tools/edges_box.h"
#include "tools/measure_box.h"
#include "tools/mirror_box.h"
#include "tools/points_box.h"
#include "tools/problem_box.h"
#include "tools/region_box.h"

#include <QScrollArea>

class QPushButton;

namespace loopmend {

enum class Tool { none, region, points, blend, bridge, fill_part, edges, mirror, cut, measure };
/// Whether what it makes is tried out before it is accepted.
constexpr bool makes_surfaces(Tool tool) { return tool == Tool::region || tool == Tool::points || tool == Tool::blend; }

class ToolsPanel : public QScrollArea {
  Q_OBJECT

 public:
  ToolsPanel(RegionBox* region, PointsBox* points, BlendBox* blend, EdgesBox* edges, MirrorBox* mirror, CutBox* cut,
             MeasureBox* measure, ProblemBox* trial, QWidget* parent = nullptr);

  Tool tool() const { return tool_; }
  void choose(Tool tool);

 Q_SIGNALS:
  void tool_wanted(Tool tool);  ///< by a button; choose() does it
  void tool_chosen(Tool tool);

 private:
  void show_choice();

  Tool tool_ = Tool::none;
  std::vector<QPushButton*> choices_;
  std::vector<QWidget*> pages_;  ///< in the order of Tool
  ProblemBox* trial_;
};

}  // namespace loopmend
