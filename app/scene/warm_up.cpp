// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/warm_up.h"

#include "scene/still_renderer.h"
#include "scene/surface_actor.h"

#include <vtkActor.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace loopmend {
namespace {

/// Triangles that cover no pixel; more than a few, since software graphics make another program for these.
std::shared_ptr<const SurfaceShape> speck() {
  constexpr float tiny = 1e-6F;
  auto shape = std::make_shared<SurfaceShape>();
  shape->points = {0, 0, 0, tiny, 0, 0, 0, tiny, 0};
  shape->normals = {0, 0, 1, 0, 0, 1, 0, 0, 1};
  shape->own_triangles = 300;
  for (int k = 0; k < shape->own_triangles; ++k) shape->triangles.insert(shape->triangles.end(), {0, 1, 2});
  return shape;
}

/// As long as many of a scan, for the same reason.
std::vector<float> tiny_loop() {
  constexpr int points = 99;
  constexpr double tiny = 1e-6;
  std::vector<float> loop;
  for (int k = 0; k < points; ++k) {
    const double angle = 2 * std::numbers::pi * k / points;
    for (double x : {tiny * std::cos(angle), tiny * std::sin(angle), 0.0}) loop.push_back(static_cast<float>(x));
  }
  return loop;
}

}  // namespace

WarmUp::WarmUp(StillRenderer* renderer, vtkLookupTable* table, Legend& legend)
    : renderer_(renderer),
      table_(table),
      legend_(legend) {
  const std::vector<float> loop = tiny_loop();
  lines_.set_lines({{loop, LoopStyle::open}, {loop, LoopStyle::selected}});
  for (vtkActor* line : lines_.actors()) line->UseBoundsOff();
}

WarmUp::~WarmUp() { end(); }

WarmUp::Program WarmUp::program_of(Shading shading, Edges edges) {
  if (edges == Edges::hidden) return has_stripes(shading) ? Program::striped : Program::smooth;
  return has_stripes(shading) ? Program::striped_edged : Program::smooth_edged;
}

std::vector<WarmUp::Turn> WarmUp::turns_for(Program surface) {
  return {{surface, Stage::source}, {surface, Stage::fresh},  {surface, Stage::renewed},         {Program::letters},
          {Program::areas},         {Program::colored_areas}, {Program::casings, Stage::source}, {Program::casings},
          {Program::cores}};
}

std::optional<WarmUp::Turn> WarmUp::missing(Program surface) const {
  const auto is_done = [this](const Turn& turn) { return std::find(done_.begin(), done_.end(), turn) != done_.end(); };
  const std::vector<Turn> turns = turns_for(surface);
  const auto turn = std::find_if_not(turns.begin(), turns.end(), is_done);
  if (turn == turns.end()) return {};
  // A texture is filled anew only in the picture after the one that it was made for.
  const Turn before{turn->program, Stage::fresh};
  const bool too_late = turn->stage == Stage::renewed && (!surface_ || done_.back() != before);
  return too_late ? before : *turn;
}

bool WarmUp::next_for(Shading shading, Edges edges) {
  const std::optional<Turn> turn = missing(program_of(shading, edges));
  take(turn);
  if (!turn) something_is_ready_ = true;
  using Curtain = StillRenderer::Curtain;
  renderer_->set_curtain(something_is_ready_ ? Curtain::up : Curtain::down);
  return turn.has_value();
}

bool WarmUp::next() {
  std::optional<Turn> turn;
  for (Program surface : {Program::smooth, Program::striped, Program::smooth_edged, Program::striped_edged})
    if (!turn) turn = missing(surface);
  take(turn);
  return turn.has_value();
}

void WarmUp::take(const std::optional<Turn>& turn) {
  if (!turn) return end();
  begin(*turn);
  done_.push_back(*turn);
}

void WarmUp::begin(const Turn& turn) {
  if (turn.stage != Stage::renewed) end();
  switch (turn.program) {
    case Program::smooth: return begin_surface(Shading::curvature, Edges::hidden, turn.stage);
    case Program::striped: return begin_surface(Shading::zebra, Edges::hidden, turn.stage);
    case Program::smooth_edged: return begin_surface(Shading::curvature, Edges::shown, turn.stage);
    case Program::striped_edged: return begin_surface(Shading::zebra, Edges::shown, turn.stage);
    case Program::letters: return begin_legend(Legend::Kind::letters);
    case Program::areas: return begin_legend(Legend::Kind::areas);
    case Program::colored_areas: return begin_legend(Legend::Kind::colored_areas);
    case Program::casings: return begin_lines(lines_.casings(), turn.stage);
    case Program::cores: return begin_lines(lines_.cores(), turn.stage);
  }
}

StillRenderer::Rehearsal WarmUp::rehearsal(Stage stage) {
  return stage == Stage::source ? StillRenderer::Rehearsal::source : StillRenderer::Rehearsal::whole;
}

void WarmUp::begin_surface(Shading shading, Edges edges, Stage stage) {
  if (stage == Stage::renewed) return surface_->recolor();
  surface_ = std::make_unique<SurfaceActor>(SurfaceActor::Role::scan, table_);
  surface_->set_shading(shading);
  surface_->set_edges(edges);
  surface_->set_shape(speck());
  surface_->actor()->UseBoundsOff();
  renderer_->AddActor(surface_->actor());
  renderer_->rehearse({surface_->actor()}, rehearsal(stage));
}

void WarmUp::begin_lines(const std::vector<vtkActor*>& lines, Stage stage) {
  for (vtkActor* line : lines) renderer_->AddActor(line);
  renderer_->rehearse({lines.begin(), lines.end()}, rehearsal(stage));
}

/// Left of the picture, where nobody sees it.
void WarmUp::begin_legend(Legend::Kind kind) {
  constexpr int no_width = 0, some_height = 400;
  legend_.lay_out(no_width, some_height);
  legend_.show_only(kind);
}

/// What the last turn has drawn goes; but the legend's part, which is the scene's.
void WarmUp::end() {
  renderer_->rehearse({}, StillRenderer::Rehearsal::whole);
  if (surface_) renderer_->RemoveActor(surface_->actor());
  surface_.reset();
  for (vtkActor* line : lines_.actors()) renderer_->RemoveActor(line);
}

}  // namespace loopmend
