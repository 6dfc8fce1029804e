// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/tool_controller.h"

#include "core/error.h"
#include "document/labels.h"
#include "document/message_words.h"
#include "jobs/problem_base.h"
#include "mesh/facing_loops.h"
#include "views/mesh_view.h"
#include "views/surface_probe.h"

#include <algorithm>
#include <utility>

namespace loopmend {

ToolController::ToolController(Document& document, const SceneVisibility& visibility, HoleSelection& selection,
                               FillController& controller, MeshView& view, QObject* parent)
    : QObject(parent),
      document_(document),
      selection_(selection),
      view_(view),
      region_(new RegionTool(document, visibility, this)),
      points_(new PointsTool(document, visibility, this)),
      part_(new PartTool(document, this)),
      bridge_(new BridgeTool(document, visibility, this)),
      measure_(new MeasureTool(
          [&document, &visibility](const Vec3& at) {
            const std::optional<SurfacePlace> found = place_near(document, visibility, at);
            return found ? std::optional(found->at) : std::nullopt;
          },
          this)),
      edge_guide_(new EdgeGuide(document, selection, this)),
      edges_(new EdgesTool(document, visibility, *edge_guide_, this)),
      mirror_guide_(new MirrorGuide(
          document, selection, [&controller](int scan) { return controller.context_of(scan); }, this)),
      mirror_(new PlaneTool(document, *mirror_guide_, this)),
      cut_guide_(new CutGuide(document, selection, this)),
      cut_(new PlaneTool(document, *cut_guide_, this)),
      trial_(new ProblemController(document, controller, this)),
      place_(new PlacePart(document, controller, this)),
      points_box_(new PointsBox(document, *points_)),
      blend_box_(new BlendBox(document, selection, *part_)),
      trial_box_(new ProblemBox(*trial_)),
      region_box_(new RegionBox(*region_)),
      panel_(new ToolsPanel(region_box_, points_box_, blend_box_, new EdgesBox(*edge_guide_),
                            new MirrorBox(document, *mirror_guide_), new CutBox(*cut_guide_, controller),
                            new MeasureBox(document, *measure_), trial_box_)) {
  connect(panel_, &ToolsPanel::tool_wanted, this, &ToolController::take);
  connect(panel_, &ToolsPanel::tool_chosen, this, &ToolController::on_tool);
  connect(region_, &RegionTool::changed, this, [this] {
    if (region_->count() > 0) region_is_used_ = false;
    if (has_result() && !region_is_used_)
      Q_EMIT notice(tr("The result was discarded, since the region is another now. Evolve makes a new one."));
    give_up_trial();
    show_region();
  });
  connect(points_box_, &PointsBox::changed, this, [this] {
    if (panel_->tool() == Tool::points) give_up_trial();
    view_.update_tool();
  });
  connect(blend_box_, &BlendBox::changed, this, [this] {
    if (panel_->tool() == Tool::blend) give_up_trial();
    view_.update_tool();
  });
  connect(blend_box_, &BlendBox::select_facing_wanted, this, &ToolController::select_facing);
  connect(bridge_, &BridgeTool::changed, &view_, &MeshView::update_tool);
  connect(measure_, &MeasureTool::changed, &view_, &MeshView::update_tool);
  connect(edges_, &EdgesTool::changed, &view_, &MeshView::update_tool);
  connect(mirror_, &PlaneTool::changed, this, &ToolController::show_mirrored);
  connect(cut_, &PlaneTool::changed, &view_, &MeshView::update_tool);
  for (auto signal : {&Document::opened, &Document::scans_changed, &Document::patches_changed})
    connect(&document_, signal, measure_, &MeasureTool::clear);
  connect(bridge_, &BridgeTool::bridge_wanted, &controller, &FillController::bridge);
  connect(bridge_, &BridgeTool::part_wanted, this, [this](int scan, int soup_a, int soup_b, int beside) {
    Q_EMIT part_wanted({scan, soup_a, soup_b, beside});
  });
  connect(region_box_, &RegionBox::erase_wanted, this, [this, &controller] {
    region_is_used_ = true;
    controller.erase(region_->scan(), region_->vertices(), std::nullopt);
  });
  connect(region_box_, &RegionBox::erase_and_fill_wanted, this, [this] {
    region_is_used_ = true;
    Q_EMIT refill_wanted(region_->scan(), region_->vertices());
  });
  connect(part_, &PartTool::placed, this, [this] {
    give_up_trial();
    view_.place_scan(part_->scan(), part_->placement().matrix());
  });
  connect(part_, &PartTool::released, this, [this] {
    if (part_->is_moved()) place_->place(part_->scan(), part_->placement());
  });
  connect(place_, &PlacePart::placed, this, &ToolController::on_placed);
  connect(place_, &PlacePart::failed, this, &ToolController::failed);
  connect(trial_, &ProblemController::picture_changed, this, [this] {
    view_.show_trial(trial_->picture());
    // What is shown now is not what the handle holds.
    if (panel_->tool() == Tool::blend) view_.set_tool(trial_->picture().patch ? nullptr : part_);
    show_region();
  });
  connect(trial_, &ProblemController::stage_changed, this, &ToolController::on_stage);
  connect(trial_, &ProblemController::failed, this, &ToolController::failed);
  connect(trial_, &ProblemController::accepted, this, &ToolController::notice);
  connect(trial_box_, &ProblemBox::preview_wanted, this, [this] { pose(Then::look); });
  connect(trial_box_, &ProblemBox::evolve_wanted, this, [this] { pose(Then::evolve); });
  connect(trial_box_, &ProblemBox::compare_wanted, this, [this] { pose(Then::compare); });
  connect(trial_box_, &ProblemBox::cancel_wanted, trial_, &ProblemController::cancel);
  connect(trial_box_, &ProblemBox::accept_wanted, trial_, [this] {
    region_is_used_ = true;
    trial_->accept();
  });
  connect(region_, &RegionTool::dropped, this, [this] {
    if (!std::exchange(region_is_used_, false))
      Q_EMIT notice(tr("What was painted is gone, since the surface is another now: paint it again."));
  });
  connect(region_, &RegionTool::beside_scan, this, [this](int scan) {
    Q_EMIT notice(
        tr("What is painted belongs to %1. Clear it to paint on another scan.").arg(document_.scan(scan)->name));
  });
  connect(trial_box_, &ProblemBox::discard_wanted, trial_, &ProblemController::discard);
  connect(trial_box_, &ProblemBox::copy_wanted, this, &ToolController::copy_command);
}

void ToolController::take(Tool tool) {
  const auto choose = [this, tool] { panel_->choose(tool); };
  if (has_result() && tool != panel_->tool())
    Q_EMIT result_would_go(choose);
  else
    choose();
}

void ToolController::on_tool(Tool tool) {
  give_up_trial();
  if (tool != Tool::blend) part_->set_scan(-1);
  bridge_->clear();
  edges_->clear();
  measure_->clear();
  edge_guide_->watch(tool == Tool::edges ? EdgeGuide::Watch::open_holes : EdgeGuide::Watch::nothing);
  if (tool != Tool::mirror && !mirror_guide_->fits().empty()) view_.show_ghosts({});
  mirror_guide_->watch(tool == Tool::mirror ? MirrorGuide::Watch::scan : MirrorGuide::Watch::nothing);
  cut_guide_->watch(tool == Tool::cut ? CutGuide::Watch::scan : CutGuide::Watch::nothing);
  switch (tool) {
    case Tool::none: view_.set_tool(nullptr); break;
    case Tool::region: view_.set_tool(region_); break;
    case Tool::points: view_.set_tool(points_); break;
    case Tool::blend: view_.set_tool(part_); break;
    case Tool::bridge:
    case Tool::fill_part:
      bridge_->set_purpose(tool == Tool::bridge ? BridgeTool::Purpose::bridge : BridgeTool::Purpose::fill_part);
      view_.set_tool(bridge_);
      break;
    case Tool::edges: view_.set_tool(edges_); break;
    case Tool::mirror: view_.set_tool(mirror_); break;
    case Tool::cut: view_.set_tool(cut_); break;
    case Tool::measure: view_.set_tool(measure_); break;
  }
  show_region();
  update_wanting();
  Q_EMIT tool_changed(tool);
}

bool ToolController::step_back() {
  if (trial_->busy()) {
    trial_->cancel();
  } else if (has_result()) {
    Q_EMIT result_would_go([this] { trial_->discard(); });
  } else if (trial_->stage() != ProblemController::Stage::none) {
    trial_->discard();
  } else if (bridge_->is_begun()) {
    bridge_->clear();
  } else if (edges_->is_begun()) {
    edges_->clear();
  } else if (measure_->is_begun()) {
    measure_->clear();
  } else if (panel_->tool() != Tool::none) {
    take(Tool::none);
  } else {
    return false;
  }
  return true;
}

/// What was posed is no longer what is chosen.
void ToolController::give_up_trial() {
  current_ = false;
  trial_->discard();
  update_wanting();
}

void ToolController::update_wanting() {
  QString words;
  switch (panel_->tool()) {
    case Tool::none:
    case Tool::bridge:
    case Tool::fill_part:
    case Tool::edges:
    case Tool::mirror:
    case Tool::cut:
    case Tool::measure: break;
    case Tool::region: words = region_->count() > 0 ? QString() : tr("Paint a region first."); break;
    case Tool::points: words = points_box_->wanting(); break;
    case Tool::blend: words = blend_box_->wanting(); break;
  }
  trial_box_->set_wanting(words);
}

/// The painted triangles, until what becomes of them is shown.
void ToolController::show_region() {
  const bool shown = panel_->tool() == Tool::region && trial_->picture().patch == nullptr;
  view_.show_marked(shown ? region_->shape() : nullptr);
}

/// What would be copied into the holes.
void ToolController::show_mirrored() {
  if (panel_->tool() != Tool::mirror) return;
  std::vector<SurfaceShapePtr> ghosts;
  for (const MirrorGuide::Fit& one : mirror_guide_->fits())
    if (one.ghost) ghosts.push_back(one.ghost);
  view_.show_ghosts(ghosts);
  view_.update_tool();
}

void ToolController::pose(Then then) {
  then_ = then;
  if (current_ && trial_->can_compare()) {
    on_stage();
    return;
  }
  if (!makes_surfaces(panel_->tool())) return;
  trial_->pose(request());
  current_ = true;
}

ProblemRequest ToolController::request() const {
  switch (panel_->tool()) {
    case Tool::none:
    case Tool::bridge:
    case Tool::fill_part:
    case Tool::edges:
    case Tool::mirror:
    case Tool::cut:
    case Tool::measure: break;
    case Tool::region: return region_request();
    case Tool::points: return points_request();
    case Tool::blend: return blend_request();
  }
  return {};
}

void ToolController::copy_command() {
  if (makes_surfaces(panel_->tool()))
    Q_EMIT notice(copy_to_clipboard(solving_command(request().command, trial_box_->options())));
}

void ToolController::on_stage() {
  if (trial_->stage() == ProblemController::Stage::none) current_ = false;
  if (!trial_->can_compare()) return;
  switch (std::exchange(then_, Then::look)) {
    case Then::look: break;
    case Then::evolve: trial_->evolve(trial_box_->options()); break;
    case Then::compare: Q_EMIT compare_wanted(); break;
  }
}

/// On one scan alone. @param name  with a place for the scan's
ProblemRequest ToolController::request_on(int scan, const QString& name) const {
  ProblemRequest request;
  request.made_name = document_.scan(scan)->name;
  request.name = name.arg(request.made_name);
  request.scans = {scan};
  return request;
}

ProblemRequest ToolController::region_request() const {
  ProblemRequest request = request_on(region_->scan(), tr("Region of %1"));
  request.command = region_words(document_, region_->scan(), region_->vertices());
  request.pose = [vertices = region_->vertices()](const ProblemBase& base, const CancelToken&) {
    return pose_region(base.model, vertices);
  };
  return request;
}

ProblemRequest ToolController::points_request() const {
  ProblemRequest request = request_on(points_->scan(), tr("Surface through the points of %1"));
  request.command = points_words(document_, points_->scan(), points_box_->options());
  request.pose = [options = points_box_->options()](const ProblemBase& base, const CancelToken&) {
    return pose_points(base.model, options);
  };
  request.around = ProblemRequest::Around::hidden;
  return request;
}

ProblemRequest ToolController::blend_request() const {
  struct Chosen {
    std::size_t part;
    std::shared_ptr<const OpenedScan> scan;
    BoundaryLoop loop;
  };
  ProblemRequest request;
  std::vector<Chosen> chosen;
  const std::vector<int> loops = blend_box_->loops();
  for (int loop : loops) {
    const int scan = document_.scan_of(loop);
    auto at = std::find(request.scans.begin(), request.scans.end(), scan);
    if (at == request.scans.end()) at = request.scans.insert(request.scans.end(), scan);
    chosen.push_back(
        {static_cast<std::size_t>(at - request.scans.begin()), document_.scan(scan), document_.loop(loop)});
  }
  QStringList names;
  for (int scan : request.scans) names << document_.scan(scan)->name;
  request.name = tr("Blend of %1").arg(labels::holes(document_, {loops.begin(), loops.end()}));
  request.made_name = names.join(QStringLiteral(" + "));
  request.command = blend_words(document_, loops, blend_box_->density());
  request.pose = [chosen, density = blend_box_->density()](const ProblemBase& base, const CancelToken& cancel) {
    std::vector<BoundaryLoop> ends;
    for (const Chosen& one : chosen) ends.push_back(loop_in_base(base, one.part, *one.scan, one.loop));
    return pose_bridge(base.model, ends, InitialPatchOptions{density}, cancel);
  };
  return request;
}

void ToolController::select_facing() {
  std::vector<FacingPart> parts;
  const std::vector<int> scans = document_.scans();
  for (int index : scans) {
    const auto scan = document_.scan(index);
    Vec3 sum = Vec3::Zero();
    for (const Vec3& p : scan->model->soup.points) sum += p;
    parts.push_back({scan->model.get(), scan->loops,
                     sum / static_cast<double>(std::max<std::size_t>(1, scan->model->soup.points.size()))});
  }
  try {
    std::set<int> loops;
    const std::vector<std::size_t> best = facing_loops(parts);
    for (std::size_t k = 0; k < best.size(); ++k)
      loops.insert(document_.first_loop_of(scans[k]) + static_cast<int>(best[k]));
    selection_.select(loops);
  } catch (const std::exception& error) {
    Q_EMIT failed(labels::sentence(labels::in_words(message_of(error))));
  }
}

/// The part is another scan now; what was selected on it stays selected.
void ToolController::on_placed(int old_scan, int new_scan) {
  std::set<int> loops;
  for (int loop : selection_.selected()) {
    if (document_.scan_of(loop) != old_scan) {
      loops.insert(loop);
      continue;
    }
    const int number = document_.loop(loop).number;
    for (int k = document_.first_loop_of(new_scan); k < document_.loop_count() && document_.scan_of(k) == new_scan; ++k)
      if (document_.loop(k).number == number) loops.insert(k);
  }
  selection_.select(loops);
  part_->set_scan(new_scan);
  blend_box_->follow();
  view_.update_tool();
}

bool ToolController::shut_down(std::chrono::milliseconds at_most) {
  const bool tried = trial_->shut_down(at_most), looked = edge_guide_->shut_down(at_most),
             compared = mirror_guide_->shut_down(at_most);
  return place_->shut_down(at_most) && tried && looked && compared;
}

}  // namespace loopmend
