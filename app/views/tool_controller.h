// SPDX-License-Identifier: GPL-3.0-or-later
// Region, points, blend: wires the tools in hand, the box they end in, and the picture.
#pragma once

#include "jobs/cut_guide.h"
#include "jobs/edge_guide.h"
#include "jobs/mirror_guide.h"
#include "jobs/place_part.h"
#include "jobs/problem_controller.h"
#include "tools/bridge_tool.h"
#include "tools/edges_tool.h"
#include "tools/measure_tool.h"
#include "tools/plane_tool.h"
#include "tools/tools_panel.h"

#include <QObject>

#include <functional>

namespace loopmend {

class MeshView;

class ToolController : public QObject {
  Q_OBJECT

 public:
  ToolController(Document& document, const SceneVisibility& visibility, HoleSelection& selection,
                 FillController& controller, MeshView& view, QObject* parent);

  ToolsPanel* panel() { return panel_; }
  ProblemController& trial() { return *trial_; }
  RegionTool& region() { return *region_; }
  PointsTool& points() { return *points_; }
  PartTool& part() { return *part_; }
  BridgeTool& bridge() { return *bridge_; }
  MeasureTool& measure() { return *measure_; }
  EdgesTool& edges() { return *edges_; }
  EdgeGuide& edge_guide() { return *edge_guide_; }
  PlaneTool& mirror() { return *mirror_; }
  PlaneTool& cut() { return *cut_; }
  CutGuide& cut_guide() { return *cut_guide_; }
  MirrorGuide& mirror_guide() { return *mirror_guide_; }

  void take(Tool tool);
  /// As the buttons do.
  void evolve() { pose(Then::evolve); }
  void compare() { pose(Then::compare); }
  /// Of each part the loop that looks at the others most.
  void select_facing();
  /// Whether a tool holds a result that was neither accepted nor discarded.
  bool has_result() const { return trial_->stage() == ProblemController::Stage::solved; }
  /// Esc: @returns whether there was something to step back from.
  bool step_back();
  bool shut_down(std::chrono::milliseconds at_most);

 Q_SIGNALS:
  void tool_changed(Tool tool);
  void compare_wanted();
  /// To be filled as it is chosen in the patch dock.
  void part_wanted(const HolePart& part);
  /// These points of a scan to be erased, and the hole filled likewise.
  void refill_wanted(int scan, const std::vector<int>& points);
  /// Its result would be lost by this.
  void result_would_go(const std::function<void()>& act);
  void failed(const QString& words);
  void notice(const QString& words);

 private:
  enum class Then { look, evolve, compare };
  void on_tool(Tool tool);
  void pose(Then then);
  void on_stage();
  void give_up_trial();
  void update_wanting();
  void show_region();
  void show_mirrored();
  ProblemRequest request() const;
  void copy_command();
  void on_placed(int old_scan, int new_scan);
  ProblemRequest request_on(int scan, const QString& name) const;
  ProblemRequest region_request() const;
  ProblemRequest points_request() const;
  ProblemRequest blend_request() const;

  Document& document_;
  HoleSelection& selection_;
  MeshView& view_;
  RegionTool* region_;
  PointsTool* points_;
  PartTool* part_;
  BridgeTool* bridge_;
  MeasureTool* measure_;
  EdgeGuide* edge_guide_;
  EdgesTool* edges_;
  MirrorGuide* mirror_guide_;
  PlaneTool* mirror_;
  CutGuide* cut_guide_;
  PlaneTool* cut_;
  ProblemController* trial_;
  PlacePart* place_;
  PointsBox* points_box_;
  BlendBox* blend_box_;
  ProblemBox* trial_box_;
  RegionBox* region_box_;
  ToolsPanel* panel_;
  Then then_ = Then::look;
  bool region_is_used_ = false;  ///< what was painted goes because something was made of it
  bool current_ = false;         ///< the trial is of what is chosen now
};

}  // namespace loopmend
