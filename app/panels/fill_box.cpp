// SPDX-License-Identifier: GPL-3.0-or-later
#include "panels/fill_box.h"

#include "document/labels.h"
#include "document/targets.h"
#include "jobs/fill_controller.h"
#include "panels/parts.h"

#include <QCheckBox>
#include <QDoubleSpinBox>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QToolButton>

#include <algorithm>
#include <cmath>

namespace loopmend {
namespace {

constexpr int preview_delay_ms = 200;
constexpr std::size_t most_previewed = 200;

}  // namespace

FillBox::FillBox(const Document& document, const HoleSelection& selection, FillController& controller, QWidget* parent)
    : QGroupBox(tr("1  Fill and smooth"), parent),
      document_(document),
      selection_(selection),
      controller_(controller) {
  build();
  preview_timer_.setSingleShot(true);
  preview_timer_.setInterval(preview_delay_ms);
  connect(&preview_timer_, &QTimer::timeout, this, &FillBox::preview_now);
  connect(whole_, &QPushButton::clicked, this, qOverload<>(&FillBox::fill_and_smooth));
  connect(fill_, &QPushButton::clicked, this, &FillBox::fill);
  connect(prepare_, &QPushButton::clicked, this, [this] { repair_scans(ScanRepair::prepare); });
  connect(trim_, &QPushButton::clicked, this, [this] { repair_scans(ScanRepair::trim); });
  connect(stitch_, &QPushButton::clicked, this, [this] { repair_scans(ScanRepair::stitch); });
  connect(repair_, &QPushButton::clicked, this, &FillBox::repair_wanted);
  connect(preview_, &QCheckBox::toggled, this, &FillBox::preview_now);
  connect(islands_, &QCheckBox::toggled, this, &FillBox::preview_soon);
  connect(density_, QOverload<double>::of(&QDoubleSpinBox::valueChanged), this, [this] {
    update_state();
    preview_soon();
  });
  connect(&selection_, &HoleSelection::selection_changed, this, &FillBox::preview_soon);
}

void FillBox::build() {
  auto* grid = new QGridLayout(this);
  grid->setContentsMargins(box_margins);
  grid->setHorizontalSpacing(10);
  grid->setVerticalSpacing(4);
  target_ = make_note("fillTarget");
  target_->keep_room_for({QStringLiteral("1\n2")});
  estimate_ = make_note("fillEstimate");
  estimate_->keep_room_for({QStringLiteral("1")});
  density_ = new QDoubleSpinBox;
  density_->setRange(0.25, 4);
  density_->setSingleStep(0.25);
  density_->setDecimals(2);
  density_->setValue(1);
  density_->setPrefix(QStringLiteral("\u00d7 "));
  density_->setKeyboardTracking(false);
  explain(density_, "density", tr("Density"),
          tr("Density of the patch relative to the scan around it; 2 halves the edge length"));
  auto* density_label = new QLabel(tr("Density"));
  density_label->setBuddy(density_);
  preview_ = make_option<QCheckBox>("preview", tr("Preview"),
                                    tr("Show the patch with its edges before it is made; for up to 200 holes at once"));
  islands_ = make_option<QCheckBox>(
      "islands", tr("Join islands"),
      tr("Join islands, components that lie within a hole, to its patch, and walls that end in one plane by one face; "
         "otherwise each hole gets a patch of its own"));
  islands_->setChecked(true);
  prepare_ = make_button("prepare", tr("Prepare"),
                         tr("Stitch, repair and trim where the scan needs that to be filled, and change nothing else; "
                            "shows first what it would change"));
  trim_ = make_button(
      "trim", tr("Trim"),
      tr("Remove dangling, folded, needle-like and crossing triangles at the boundaries of these holes, up to "
         "three rings of them, before they are filled; Ctrl+Z brings them back"));
  stitch_ = make_button(
      "stitch", tr("Stitch"),
      tr("Zip boundaries that lie within a tenth of their edges of each other, such as cracks and the seams "
         "between tiles; Ctrl+Z takes it back"));
  repair_ = make_button(
      "repair", tr("Repair\u2026"),
      tr("The defects of the scan, each with its count and a button: vertices to be joined, degenerate, duplicate "
         "and intersecting faces, non-manifold edges, fragments"));
  whole_ = make_button("fillAndSmooth", tr("Fill and smooth"),
                       tr("Close the selected holes, or all holes when none is selected, and let the flow run to its "
                          "steady state (Ctrl+F)"));
  QFont strong = whole_->font();
  strong.setBold(true);
  whole_->setFont(strong);
  fill_ = make_button("fill", tr("Initial patch only"),
                      tr("Close the holes by their initial patches, and let no flow run yet (Ctrl+Shift+F)"));
  QSizePolicy keep = estimate_->sizePolicy();
  keep.setRetainSizeWhenHidden(true);  // nothing moves under the mouse
  estimate_->setSizePolicy(keep);
  auto* more = new QWidget;
  auto* head = new QHBoxLayout;  // one row less: what decides on a patch is seen without scrolling
  head->addWidget(target_, 1);
  head->addWidget(make_fold("moreOfFill", tr("More options"), more), 0, Qt::AlignTop);
  grid->addLayout(head, 0, 0, 1, 3);
  grid->addWidget(estimate_, 1, 0, 1, 3);
  auto* do_it = new QHBoxLayout;
  do_it->addWidget(prepare_);
  do_it->addWidget(whole_, 1);
  grid->addLayout(do_it, 2, 0, 1, 3);
  auto* repairs = new QHBoxLayout;
  for (QPushButton* button : {trim_, stitch_, repair_}) repairs->addWidget(button);
  grid->addLayout(repairs, 4, 0, 1, 3);
  rest_ = make_layout<QGridLayout>(more);
  rest_->addWidget(density_label, 0, 0);
  rest_->addWidget(density_, 0, 1);
  rest_->addWidget(preview_, 0, 2);
  rest_->addWidget(islands_, 1, 0, 1, 3);
  rest_->addWidget(fill_, 3, 0, 1, 3);
  rest_->setColumnStretch(1, 1);
  grid->addWidget(more, 6, 0, 1, 3);
  grid->setColumnStretch(1, 1);
}

void FillBox::add_options(QWidget* options) { rest_->addWidget(options, 2, 0, 1, 3); }

/// The initial patches among those that may be moved; all of these where there is none.
std::set<int> FillBox::patches_to_smooth() const {
  const std::set<int> all = patches_to_move(document_, selection_);
  std::set<int> initial = all;
  std::erase_if(initial, [&](int id) { return !document_.patch(id)->state->recipe.runs.empty(); });
  return initial.empty() && loops_to_fill(document_, selection_).empty() ? all : initial;
}

void FillBox::fill_and_smooth() {
  if (whole_->isEnabled()) Q_EMIT wanted(loops_to_fill(document_, selection_), patches_to_smooth(), choice());
}

void FillBox::fill_and_smooth(const std::set<int>& loops) { Q_EMIT wanted(loops, {}, choice()); }

void FillBox::fill() {
  if (fill_->isEnabled()) controller_.fill(loops_to_fill(document_, selection_), choice());
}

FillChoice FillBox::choice() const {
  return {density_->value(), islands_->isChecked() ? FillOptions::Islands::join : FillOptions::Islands::cover};
}

void FillBox::repair_scans(ScanRepair what) {
  const bool of_holes = what == ScanRepair::trim || what == ScanRepair::trim_crossing;
  // The others concern whole scans, whatever is filled already.
  controller_.repair_scans(what, of_holes ? loops_to_fill(document_, selection_) : selection_.selected());
}

void FillBox::preview_soon() {
  if (preview_->isChecked()) preview_timer_.start();
}

void FillBox::preview_now() {
  const std::set<int> loops = loops_to_fill(document_, selection_);
  const bool wanted = preview_->isChecked() && !loops.empty() && loops.size() <= most_previewed;
  wanted ? controller_.preview_fill(loops, choice()) : controller_.drop_fill_preview();
}

QString FillBox::target_words(const std::set<int>& loops) const {
  if (!document_.has_scan()) return tr("Open a scan first.");
  const bool chosen = !selection_.selected().empty();
  if (!loops.empty())
    return chosen ? tr("%1, selected").arg(labels::sentence(labels::holes(document_, loops)))
                  : tr("All open holes (%L1)").arg(loops.size());
  const auto is_cut = [this](int loop) {
    return document_.present(loop) && document_.loop(loop).kind == LoopKind::cut && !document_.patch_of(loop);
  };
  const std::set<int>& selected = selection_.selected();
  if (std::any_of(selected.begin(), selected.end(), is_cut)) return tr("A cut is no hole to be filled.");
  if (chosen) return tr("The selection is filled already.");
  if (const int cutting = count_cutting()) return tr("%Ln patch(es) cut the surface.", nullptr, cutting);
  return tr("No open hole is left.");
}

/// Patches that are not exported.
int FillBox::count_cutting() const {
  return static_cast<int>(std::count_if(
      document_.patches().begin(), document_.patches().end(),
      [this](const OpenPatch& patch) { return document_.state(patch.loops.front()) == HoleState::cutting; }));
}

/// Of a patch that may still be discarded, whether a flow left it with an angle at the seam that the eye sees.
bool FillBox::has_crease(int loop) const {
  constexpr double seen_deg = 8;
  const OpenPatch* patch = document_.patch_of(loop);
  if (!patch || patch->acceptance == Acceptance::accepted || patch->state->steps == 0) return false;
  for (std::size_t k = 0; k < std::min(patch->loops.size(), patch->state->seams.size()); ++k)
    if (patch->loops[k] == loop) return patch->state->seams[k].g1_rms_deg > seen_deg;
  return false;
}

/// One line each, so that the buttons below stay where they are.
QString FillBox::advice(const std::set<int>& loops) const {
  const std::set<int>& selected = selection_.selected();
  const auto all_are = [](const std::set<int>& some, const auto& holds) {
    return !some.empty() && std::all_of(some.begin(), some.end(), holds);
  };
  const auto is = [this](LoopKind kind) {
    return [this, kind](int loop) { return document_.present(loop) && document_.loop(loop).kind == kind; };
  };
  const auto is_in = [this](HoleState state) {
    return [this, state](int loop) { return document_.state(loop) == state; };
  };
  if (all_are(loops, is(LoopKind::crack))) return tr("Stitch joins the sides of a crack.");
  if (all_are(loops, is_in(HoleState::failed))) return tr("Not fillable as it is: press Trim.");
  if (!loops.empty()) return estimate(loops);
  if (std::any_of(selected.begin(), selected.end(), is(LoopKind::cut))) return tr("Repair\u2026 removes such edges.");
  if (all_are(selected, is_in(HoleState::cutting))) return tr("It cuts the surface: Discard, then Trim.");
  if (std::any_of(selected.begin(), selected.end(), [this](int loop) { return has_crease(loop); }))
    return tr("A crease at the seam? Discard, then Trim.");
  if (!selected.empty()) return {};
  if (count_cutting() > 0) return tr("Select one: Discard, then Trim.");
  int cracks = 0, cuts = 0, others = 0;  // that are left out
  for (int loop = 0; loop < document_.loop_count(); ++loop) {
    if (!document_.present(loop) || document_.state(loop) != HoleState::left_out) continue;
    const LoopKind kind = document_.loop(loop).kind;
    ++(kind == LoopKind::crack ? cracks : kind == LoopKind::cut ? cuts : others);
  }
  if (cracks > 0) return tr("%Ln crack(s): press Stitch.", nullptr, cracks);
  if (cuts > 0) return tr("%Ln cut(s): press Repair\u2026", nullptr, cuts);
  return others > 0 ? tr("To fill one that is left out, select it.") : QString();
}

/// From the projected areas and the mean length of the boundaries' edges: equilateral triangles of that size.
QString FillBox::estimate(const std::set<int>& loops) const {
  constexpr double equilateral = 0.433;
  double triangles = 0, smallest = 0, largest = 0;
  for (int loop : loops) {
    const BoundaryLoop& l = document_.loop(loop);
    const double edge = l.perimeter / l.edges() / density_->value();
    if (!(edge > 0)) continue;
    triangles += std::max(l.area / (equilateral * edge * edge), l.edges() - 2.0);
    smallest = smallest > 0 ? std::min(smallest, edge) : edge;
    largest = std::max(largest, edge);
  }
  if (!(triangles > 0)) return {};
  const double step = std::pow(10.0, std::max(0.0, std::floor(std::log10(triangles)) - 1));
  const auto rounded = static_cast<std::size_t>(std::round(triangles / step) * step);
  const QString edges = largest > 1.2 * smallest
                            ? tr("%1\u2013%2").arg(labels::number(smallest), labels::number(largest))
                            : labels::number(largest);
  return tr("\u2248 %1 triangles, edges %2").arg(labels::count(rounded), edges);
}

void FillBox::update_state() {
  const std::set<int> loops = loops_to_fill(document_, selection_);
  const bool idle = !controller_.busy();
  target_->setText(target_words(loops));
  estimate_->setText(advice(loops));
  estimate_->setVisible(!estimate_->text().isEmpty());
  fill_->setEnabled(idle && !loops.empty());
  whole_->setEnabled(idle && (!loops.empty() || !patches_to_smooth().empty()));
  whole_->setDefault(whole_->isEnabled());
  whole_->setText(loops.empty() && whole_->isEnabled() ? tr("Smooth") : tr("Fill and smooth"));
  density_->setEnabled(idle && document_.has_scan());
  islands_->setEnabled(idle && document_.has_scan());
  prepare_->setEnabled(idle && document_.has_scan());
  trim_->setEnabled(idle && !loops.empty());
  stitch_->setEnabled(idle && document_.has_scan());
  const int cracks = cracks_left(document_);
  stitch_->setAccessibleName(cracks > 0 ? tr("Stitch %Ln crack(s)", nullptr, cracks) : tr("Stitch"));
  repair_->setEnabled(idle && document_.has_scan());
  preview_->setEnabled(idle && !loops.empty() && loops.size() <= most_previewed);
}

}  // namespace loopmend
