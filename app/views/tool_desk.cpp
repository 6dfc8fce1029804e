// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/tool_desk.h"

#include "document/words.h"
#include "jobs/trial_base.h"
#include "problems/facing_loops.h"
#include "views/mesh_view.h"

#include <algorithm>

namespace loopmend {

ToolDesk::ToolDesk(Document& document, HoleSelection& selection, Workbench& workbench, MeshView& view, QObject* parent)
    : QObject(parent),
      document_(document),
      selection_(selection),
      view_(view),
      region_(new RegionTool(document, this)),
      points_(new PointsTool(document, this)),
      part_(new PartTool(document, this)),
      trial_(new Trial(document, workbench, this)),
      place_(new PlacePart(document, workbench, this)),
      points_box_(new PointsBox(document, *points_)),
      blend_box_(new BlendBox(document, selection, *part_)),
      trial_box_(new TrialBox(*trial_)),
      panel_(new ToolsPanel(new RegionBox(*region_), points_box_, blend_box_, trial_box_)) {
  connect(panel_, &ToolsPanel::tool_chosen, this, &ToolDesk::on_tool);
  connect(region_, &RegionTool::changed, this, [this] {
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
  connect(blend_box_, &BlendBox::select_facing_wanted, this, &ToolDesk::select_facing);
  connect(part_, &PartTool::placed, this, [this] {
    give_up_trial();
    view_.place_scan(part_->scan(), part_->placement().matrix());
  });
  connect(part_, &PartTool::released, this, [this] {
    if (part_->is_moved()) place_->place(part_->scan(), part_->placement());
  });
  connect(place_, &PlacePart::placed, this, &ToolDesk::on_placed);
  connect(place_, &PlacePart::failed, this, &ToolDesk::failed);
  connect(trial_, &Trial::picture_changed, this, [this] {
    view_.show_trial(trial_->picture());
    // What is shown now is not what the handle holds.
    if (panel_->tool() == Tool::blend) view_.set_tool(trial_->picture().patch ? nullptr : part_);
    show_region();
  });
  connect(trial_, &Trial::stage_changed, this, &ToolDesk::on_stage);
  connect(trial_, &Trial::failed, this, &ToolDesk::failed);
  connect(trial_, &Trial::accepted, this, &ToolDesk::notice);
  connect(trial_box_, &TrialBox::preview_wanted, this, [this] { pose(Then::look); });
  connect(trial_box_, &TrialBox::evolve_wanted, this, [this] { pose(Then::evolve); });
  connect(trial_box_, &TrialBox::compare_wanted, this, [this] { pose(Then::compare); });
  connect(trial_box_, &TrialBox::cancel_wanted, trial_, &Trial::cancel);
  connect(trial_box_, &TrialBox::accept_wanted, trial_, &Trial::accept);
  connect(trial_box_, &TrialBox::discard_wanted, trial_, &Trial::discard);
  connect(trial_box_, &TrialBox::copy_wanted, this, &ToolDesk::copy_command);
}

void ToolDesk::take(Tool tool) { panel_->choose(tool); }

void ToolDesk::on_tool(Tool tool) {
  give_up_trial();
  if (tool != Tool::blend) part_->set_scan(-1);
  switch (tool) {
    case Tool::none: view_.set_tool(nullptr); break;
    case Tool::region: view_.set_tool(region_); break;
    case Tool::points: view_.set_tool(points_); break;
    case Tool::blend: view_.set_tool(part_); break;
  }
  show_region();
  update_wanting();
  Q_EMIT tool_changed(tool);
}

bool ToolDesk::step_back() {
  if (trial_->busy()) {
    trial_->cancel();
  } else if (trial_->stage() != Trial::Stage::none) {
    trial_->discard();
  } else if (panel_->tool() != Tool::none) {
    take(Tool::none);
  } else {
    return false;
  }
  return true;
}

/// What was posed is no longer what is chosen.
void ToolDesk::give_up_trial() {
  current_ = false;
  trial_->discard();
  update_wanting();
}

void ToolDesk::update_wanting() {
  QString words;
  switch (panel_->tool()) {
    case Tool::none: break;
    case Tool::region: words = region_->count() > 0 ? QString() : tr("Paint a region first."); break;
    case Tool::points: words = points_box_->wanting(); break;
    case Tool::blend: words = blend_box_->wanting(); break;
  }
  trial_box_->set_wanting(words);
}

/// The painted triangles, until what becomes of them is shown.
void ToolDesk::show_region() {
  const bool shown = panel_->tool() == Tool::region && trial_->picture().patch == nullptr;
  view_.show_marked(shown ? region_->shape() : nullptr);
}

void ToolDesk::pose(Then then) {
  then_ = then;
  if (current_ && trial_->can_compare()) {
    on_stage();
    return;
  }
  if (panel_->tool() == Tool::none) return;
  trial_->pose(wish());
  current_ = true;
}

TrialWish ToolDesk::wish() const {
  switch (panel_->tool()) {
    case Tool::none: break;
    case Tool::region: return region_wish();
    case Tool::points: return points_wish();
    case Tool::blend: return blend_wish();
  }
  return {};
}

void ToolDesk::copy_command() {
  if (panel_->tool() != Tool::none)
    Q_EMIT notice(copy_to_clipboard(solving_command(wish().command, trial_box_->options())));
}

void ToolDesk::on_stage() {
  if (trial_->stage() == Trial::Stage::none) current_ = false;
  if (!trial_->can_compare()) return;
  switch (std::exchange(then_, Then::look)) {
    case Then::look: break;
    case Then::evolve: trial_->evolve(trial_box_->options()); break;
    case Then::compare: Q_EMIT compare_wanted(); break;
  }
}

TrialWish ToolDesk::region_wish() const {
  TrialWish wish;
  const QString scan = document_.scan(region_->scan())->name;
  wish.name = tr("Region of %1").arg(scan);
  wish.made_name = scan;
  wish.scans = {region_->scan()};
  wish.command = region_words(document_, region_->scan(), region_->vertices());
  wish.pose = [vertices = region_->vertices()](const TrialBase& base, const CancelToken&) {
    return pose_region(base.model, vertices);
  };
  return wish;
}

TrialWish ToolDesk::points_wish() const {
  TrialWish wish;
  const QString scan = document_.scan(points_->scan())->name;
  wish.name = tr("Surface through the points of %1").arg(scan);
  wish.made_name = scan;
  wish.scans = {points_->scan()};
  wish.command = points_words(document_, points_->scan(), points_box_->options());
  wish.pose = [options = points_box_->options()](const TrialBase& base, const CancelToken&) {
    return pose_points(base.model, options);
  };
  wish.around = TrialWish::Around::hidden;
  return wish;
}

TrialWish ToolDesk::blend_wish() const {
  struct Chosen {
    std::size_t part;
    std::shared_ptr<const OpenedScan> scan;
    BoundaryLoop loop;
  };
  TrialWish wish;
  std::vector<Chosen> chosen;
  const std::vector<int> loops = blend_box_->loops();
  for (int loop : loops) {
    const int scan = document_.scan_of(loop);
    auto at = std::find(wish.scans.begin(), wish.scans.end(), scan);
    if (at == wish.scans.end()) at = wish.scans.insert(wish.scans.end(), scan);
    chosen.push_back({static_cast<std::size_t>(at - wish.scans.begin()), document_.scan(scan), document_.loop(loop)});
  }
  QStringList names;
  for (int scan : wish.scans) names << document_.scan(scan)->name;
  wish.name = tr("Blend of %1").arg(words::holes(document_, {loops.begin(), loops.end()}));
  wish.made_name = names.join(QStringLiteral(" + "));
  wish.command = blend_words(document_, loops, blend_box_->density());
  wish.pose = [chosen, density = blend_box_->density()](const TrialBase& base, const CancelToken& cancel) {
    std::vector<BoundaryLoop> ends;
    for (const Chosen& one : chosen) ends.push_back(loop_in_base(base, one.part, *one.scan, one.loop));
    return pose_bridge(base.model, ends, FillerOptions{density}, cancel);
  };
  return wish;
}

void ToolDesk::select_facing() {
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
    Q_EMIT failed(words::sentence(QString::fromUtf8(error.what())));
  }
}

/// The part is another scan now; what was selected on it stays selected.
void ToolDesk::on_placed(int old_scan, int new_scan) {
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

bool ToolDesk::shut_down(std::chrono::milliseconds at_most) {
  const bool tried = trial_->shut_down(at_most);
  return place_->shut_down(at_most) && tried;
}

}  // namespace loopmend
