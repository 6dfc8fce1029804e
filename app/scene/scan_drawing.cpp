// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/scan_drawing.h"

#include "core/release.h"

#include <vtkActor.h>
#include <vtkMatrix4x4.h>
#include <vtkRenderWindow.h>

#include <numeric>
#include <utility>

namespace loopmend {
namespace {

// Software graphics take 10 to 20 ms to take in or to draw as many.
constexpr std::size_t triangles_of_a_slice = 40'000;

}  // namespace

ScanDrawing::ScanDrawing(CachedBackground* renderer, std::function<std::unique_ptr<SurfaceActor>()> make)
    : renderer_(renderer),
      make_(std::move(make)) {}

ScanDrawing::~ScanDrawing() {
  drop(reduced_);
  drop(drawn_);
  forget_coming();
}

/// What was sent and never drawn can go only where the window's graphics are current.
void ScanDrawing::forget_coming() {
  to_make_.clear();
  if (coming_.empty()) return;
  if (vtkRenderWindow* window = renderer_->GetRenderWindow(); window && !window->GetNeverRendered())
    window->MakeCurrent();
  coming_.clear();
}

void ScanDrawing::drop(Actors& actors) {
  for (auto& actor : actors) {
    renderer_->remove_still(actor->actor());
    renderer_->RemoveActor(actor->actor());
  }
  actors.clear();
}

std::unique_ptr<SurfaceActor> ScanDrawing::make(ShapePtr shape, const Actors& others) {
  auto actor = make_();
  if (!others.empty()) actor->share_texture(*others.back());
  actor->set_shape(std::move(shape));
  actor->actor()->SetUserMatrix(placement_);
  return actor;
}

void ScanDrawing::add(const SurfaceActor& actor, CachedBackground::Part part) {
  renderer_->AddActor(actor.actor());
  renderer_->add_still(actor.actor(), part);
}

void ScanDrawing::show(const Shapes& shapes) {
  if (shapes == shapes_) return;
  shapes_ = shapes;
  forget_coming();
  drop(reduced_);
  for (const ShapePtr& shape : shapes) {
    if (shape->reduced) {
      reduced_.push_back(make(shape->reduced, reduced_));
      add(*reduced_.back(), CachedBackground::Part::reduced_surface);
    }
    const std::size_t triangles = shape->triangles.size() / 3;
    const std::size_t count = shape->reduced ? 1 + triangles / triangles_of_a_slice : 1;
    for (std::size_t k = 0; k < count; ++k)
      to_make_.push_back({shape, triangles * k / count, triangles * (k + 1) / count});
  }
  changing_ = true;
  new_ = !reduced_.empty();
  if (new_) drop(drawn_);  // a large one is not kept twice
  if (reduced_.empty()) finish();
}

void ScanDrawing::make_next() {
  const Slice slice = std::move(to_make_.front());
  to_make_.pop_front();
  ShapePtr shape = slice.shape;
  if (slice.end - slice.begin < shape->triangles.size() / 3) {
    std::vector<int> triangles(slice.end - slice.begin);
    std::iota(triangles.begin(), triangles.end(), static_cast<int>(slice.begin));
    shape = with_triangles(*shape, triangles, number_);
  }
  coming_.push_back(make(std::move(shape), coming_));
}

bool ScanDrawing::send_one() {
  if (!to_make_.empty()) {
    make_next();
    coming_.back()->send(renderer_);
    coming_.back()->actor()->GetBounds();  // a walk over all triangles; the first picture of all slices needs it
    if (to_make_.empty()) {
      finish();
      sent_ = drawn_.size();
    }
  } else if (sent_ < drawn_.size()) {
    drawn_[sent_++]->send(renderer_);
  }
  return !to_make_.empty() || sent_ < drawn_.size();
}

void ScanDrawing::finish() {
  if (!changing_) return;
  while (!to_make_.empty()) make_next();
  drop(drawn_);
  drawn_ = std::exchange(coming_, {});
  using Part = CachedBackground::Part;
  for (auto& actor : drawn_) add(*actor, reduced_.empty() ? Part::surface : Part::large_surface);
  release(number_);
  changing_ = false;
  sent_ = 0;
}

void ScanDrawing::place(vtkMatrix4x4* placement) {
  placement_ = placement;
  for (Actors* actors : {&reduced_, &drawn_, &coming_})
    for (auto& actor : *actors) actor->actor()->SetUserMatrix(placement);
}

void ScanDrawing::each_actor(const std::function<void(SurfaceActor&)>& change) {
  for (Actors* actors : {&reduced_, &drawn_, &coming_})
    for (auto& actor : *actors) change(*actor);
  sent_ = 0;
}

}  // namespace loopmend
