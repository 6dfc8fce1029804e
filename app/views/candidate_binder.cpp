// SPDX-License-Identifier: GPL-3.0-or-later
#include "views/candidate_binder.h"

#include "jobs/candidate_controller.h"
#include "panels/candidate_card.h"
#include "panels/candidates_panel.h"
#include "views/candidate_pictures.h"
#include "views/mesh_view.h"

#include <QPalette>

#include <utility>

namespace loopmend {
namespace {

CameraPose pose_of_view(const MeshView& view) {
  const Viewpoint from = view.viewpoint();
  return {from.focus, from.eye, from.up};
}

}  // namespace

CandidateBinder::CandidateBinder(const Document& document, CandidateController& candidates, CandidatesPanel& panel,
                                 MeshView& view, QObject* parent)
    : QObject(parent),
      document_(document),
      candidates_(candidates),
      panel_(panel),
      view_(view) {
  timer_.setSingleShot(true);
  connect(&timer_, &QTimer::timeout, this, &CandidateBinder::draw_next);
  turned_.setSingleShot(true);
  turned_.setInterval(120);  // while the picture turns, it comes first
  connect(&turned_, &QTimer::timeout, this, &CandidateBinder::draw_again_if_turned);
  connect(&panel_, &CandidatesPanel::look_changed, this, &CandidateBinder::show_looked_at);
  connect(&panel_, &CandidatesPanel::cards_changed, this, &CandidateBinder::draw_soon);
  connect(&candidates_, &CandidateController::changed, this, [this] {
    if (candidates_.loops().empty()) pictures_.reset();
    if (std::exchange(neighborhood_, candidates_.neighborhood()) != neighborhood_) draw_soon();
  });
  connect(&view_, &MeshView::drawn, this, [this] {
    if (is_shown()) turned_.start();
  });
  connect(&view_, &MeshView::look_set, this, &CandidateBinder::draw_soon);
}

CandidateBinder::~CandidateBinder() = default;

bool CandidateBinder::is_shown() const { return panel_.isVisible() && !candidates_.candidates().empty(); }

void CandidateBinder::show_looked_at() {
  const int index = panel_.looked_at();
  if (index < 0 || index == candidates_.in_place()) {
    view_.show_instead({}, {});
    return;
  }
  std::vector<SurfaceShapePtr> shapes;
  for (const OpenPatch& patch : candidates_.candidates()[index].patches) shapes.push_back(patch.state->shape);
  view_.show_instead(candidates_.loops(), shapes);
}

void CandidateBinder::draw_soon() {
  waiting_.clear();
  for (const Candidate& candidate : candidates_.candidates()) waiting_.push_back(candidate.kind);
  timer_.start(0);
}

void CandidateBinder::draw_again_if_turned() {
  const CameraPose pose = pose_of_view(view_);
  const Eigen::Vector3d towards_eye = (pose.position - pose.focus).normalized();
  if ((towards_eye - towards_eye_).norm() > 1e-3 || (pose.up - up_).norm() > 1e-3) draw_soon();
}

/// One at a time: no picture keeps the window waiting for all of them.
void CandidateBinder::draw_next() {
  if (!is_shown() || !candidates_.neighborhood() || waiting_.empty()) return;
  if (!pictures_) pictures_ = std::make_unique<CandidatePictures>();
  const CandidateKind kind = waiting_.front();
  CandidatePictures::Setting setting;
  setting.neighborhood = candidates_.neighborhood();
  for (int loop : candidates_.loops()) setting.loops.push_back(view_.line_of_loop(loop));
  setting.look = view_.look();
  setting.half_width = view_.range_of(document_.scan_of(*candidates_.loops().begin()));
  setting.eye = pose_of_view(view_);
  setting.dark = view_.palette().color(QPalette::Window).lightness() < 128;
  towards_eye_ = (setting.eye.position - setting.eye.focus).normalized();
  up_ = setting.eye.up;
  pictures_->set(setting);
  waiting_.pop_front();
  CandidateCard* card = panel_.card(kind);
  for (const Candidate& candidate : candidates_.candidates()) {
    if (candidate.kind != kind || !card) continue;
    std::vector<SurfaceShapePtr> shapes;
    for (const OpenPatch& patch : candidate.patches) shapes.push_back(patch.state->shape);
    card->set_picture(pictures_->draw(shapes, card->picture_size(), card->devicePixelRatioF()));
  }
  if (!waiting_.empty()) timer_.start(0);
}

}  // namespace loopmend
