// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene/cached_background.h"

#include <vtkCamera.h>
#include <vtkObjectFactory.h>
#include <vtkOpenGLFramebufferObject.h>
#include <vtkOpenGLRenderWindow.h>
#include <vtkOpenGLState.h>
#include <vtkProp.h>
#include <vtk_glew.h>

#include <algorithm>
#include <chrono>
#include <utility>

namespace loopmend {
namespace {

using Clock = std::chrono::steady_clock;

/// How long one picture may work at the picture of large scans.
constexpr double refining_in_one_ms = 30;
/// Surfaces that took no longer are not reduced.
constexpr double quick_ms = 50;
/// Of a stored picture with reduced versions.
constexpr vtkMTimeType reduced_version = 0;

double milliseconds_since(Clock::time_point start) {
  return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

GLuint handle(vtkOpenGLFramebufferObject* store) { return static_cast<GLuint>(store->GetFBOIndex()); }

GLuint framebuffer_drawn_to() {
  GLint drawn = 0;
  glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &drawn);
  return static_cast<GLuint>(drawn);
}

}  // namespace

vtkStandardNewMacro(CachedBackground);

CachedBackground::CachedBackground()
    : store_(vtkSmartPointer<vtkOpenGLFramebufferObject>::New()),
      next_store_(vtkSmartPointer<vtkOpenGLFramebufferObject>::New()) {}

CachedBackground::~CachedBackground() = default;

void CachedBackground::add_still(vtkProp* prop, Part part) {
  parts_[prop] = part;
  if (part == Part::large_surface) whole_ms_ = unknown_ms;
  part == Part::line ? lines_changed() : still_changed();
}

void CachedBackground::remove_still(vtkProp* prop) {
  const auto at = parts_.find(prop);
  if (at == parts_.end()) return;
  at->second == Part::line ? lines_changed() : still_changed();
  parts_.erase(at);
}

/// Whether large scans are there and to be drawn reduced at first. Lines are then drawn in every picture: they change at once
/// when a boundary is chosen.
bool CachedBackground::reduces() const {
  return large_scans_ == LargeScans::reduced_at_first && works_ &&
         std::any_of(parts_.begin(), parts_.end(),
                     [](const auto& part) { return part.second == Part::reduced_surface; });
}

CachedBackground::Key CachedBackground::key() const {
  auto* self = const_cast<CachedBackground*>(this);  // VTK's getters are not const
  int width = 0, height = 0, left = 0, bottom = 0;
  self->GetTiledSizeAndOrigin(&width, &height, &left, &bottom);
  const auto whole = [](int n) { return static_cast<vtkMTimeType>(n); };
  const int* size = self->GetRenderWindow()->GetSize();
  constexpr vtkMTimeType no_lines = 0xffffffff;
  return {{self->GetActiveCamera()->GetMTime(), whole(width), whole(height), whole(left), whole(bottom),
           whole(size[0]) << 16 | whole(size[1])},
          version_ << 32 | (reduces() ? no_lines : lines_version_)};
}

/// Made for the window's size, where it is not yet.
void CachedBackground::prepare(vtkOpenGLFramebufferObject* store) {
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(GetRenderWindow());
  const int* size = window->GetSize();
  if (store->GetFBOIndex() && store->GetLastSize()[0] == size[0] && store->GetLastSize()[1] == size[1]) return;
  // Depths can be copied only between buffers of one format.
  GLint bits = 0;
  glGetFramebufferAttachmentParameteriv(GL_DRAW_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_FRAMEBUFFER_ATTACHMENT_DEPTH_SIZE,
                                        &bits);
  store->SetContext(window);
  store->PopulateFramebuffer(size[0], size[1], true, 1, VTK_UNSIGNED_CHAR, true, bits, 0,
                             window->GetStencilCapable() != 0);
}

/// Between the picture that is being made and the store. @returns whether the graphics could.
bool CachedBackground::copy(Way way) {
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(GetRenderWindow());
  if (!window || !works_) return false;
  vtkOpenGLState* state = window->GetState();
  const GLuint drawn = framebuffer_drawn_to();
  state->PushFramebufferBindings();
  prepare(store_);
  const bool storing = way == Way::into_store;
  state->vtkglBindFramebuffer(GL_READ_FRAMEBUFFER, storing ? drawn : handle(store_));
  state->vtkglBindFramebuffer(GL_DRAW_FRAMEBUFFER, storing ? handle(store_) : drawn);
  int width = 0, height = 0, left = 0, bottom = 0;
  GetTiledSizeAndOrigin(&width, &height, &left, &bottom);
  while (glGetError() != GL_NO_ERROR) {
  }
  const bool scissor = state->GetEnumState(GL_SCISSOR_TEST);
  state->vtkglDisable(GL_SCISSOR_TEST);
  glBlitFramebuffer(left, bottom, left + width, bottom + height, left, bottom, left + width, bottom + height,
                    GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT, GL_NEAREST);
  works_ = glGetError() == GL_NO_ERROR;
  if (scissor) state->vtkglEnable(GL_SCISSOR_TEST);
  state->PopFramebufferBindings();
  return works_;
}

void CachedBackground::Clear() {
  const Key now = key();
  restored_ = false;
  // The picture of large scans as they were before stays until the new one is ready.
  if (in_store_ && (stored_ == now || (reduces() && stored_.view == now.view))) restored_ = copy(Way::out_of_store);
  if (!restored_) Superclass::Clear();
  ready_for_surfaces();
}

/// The state in which surfaces are drawn: Qt leaves another one, now and then; for software graphics each of the two makes a
/// program a different one. Legends and letters of the last picture leave the test switched off.
void CachedBackground::ready_for_surfaces() {
  vtkOpenGLState* state = vtkOpenGLRenderWindow::SafeDownCast(GetRenderWindow())->GetState();
  state->vtkglDepthFunc(GL_LEQUAL);
  state->vtkglEnable(GL_DEPTH_TEST);
  state->vtkglDepthMask(GL_TRUE);
}

CachedBackground::Sorted CachedBackground::sorted() const {
  Sorted props;
  for (vtkProp* prop : std::vector<vtkProp*>(PropArray, PropArray + PropArrayCount)) {
    const auto at = parts_.find(prop);
    if (at == parts_.end()) {
      props.moving.push_back(prop);
      continue;
    }
    switch (at->second) {
      case Part::surface: props.surfaces.push_back(prop); break;
      case Part::large_surface: props.large.push_back(prop); break;
      case Part::reduced_surface: props.reduced.push_back(prop); break;
      case Part::line: props.lines.push_back(prop); break;
    }
  }
  return props;
}

/// A part of the props alone.
void CachedBackground::draw(const Props& props, vtkFrameBufferObjectBase* fbo) {
  Props drawn = props;
  vtkProp** const all = std::exchange(PropArray, drawn.data());
  const int count = std::exchange(PropArrayCount, static_cast<int>(drawn.size()));
  Superclass::DeviceRenderOpaqueGeometry(fbo);
  PropArray = all;
  PropArrayCount = count;
}

void CachedBackground::DeviceRenderOpaqueGeometry(vtkFrameBufferObjectBase* fbo) {
  const Key now = key();
  rests_ = std::exchange(last_view_, now.view) == now.view;
  reduces() ? draw_reduced(sorted(), now, fbo) : draw_whole(sorted(), now, fbo);
}

void CachedBackground::draw_whole(const Sorted& props, const Key& now, vtkFrameBufferObjectBase* fbo) {
  rough_ = false;
  if (!restored_) {
    for (const Props* still : {&props.surfaces, &props.large, &props.lines}) draw(*still, fbo);
    if (!GetSelector() && (keep_ == Keep::always || rests_)) {
      ++still_drawn_;
      in_store_ = copy(Way::into_store);
      stored_ = now;
    }
  }
  draw(props.moving, fbo);
}

void CachedBackground::draw_reduced(const Sorted& props, const Key& now, vtkFrameBufferObjectBase* fbo) {
  rough_ = !(restored_ && stored_ == now);
  if (!restored_ && whole_ms_ < quick_ms && whole_ != Whole::not_ready) {
    const auto start = Clock::now();
    for (const Props* still : {&props.surfaces, &props.large}) draw(*still, fbo);
    whole_ms_ = milliseconds_since(start);
    rough_ = false;
    if (copy(Way::into_store)) {
      in_store_ = true;
      stored_ = now;
      ++still_drawn_;
    }
  } else if (!restored_) {
    for (const Props* still : {&props.surfaces, &props.reduced}) draw(*still, fbo);
    // The next pictures begin with this one while they work at the whole.
    if (rests_ && copy(Way::into_store)) {
      in_store_ = true;
      stored_ = {now.view, reduced_version};
    }
  }
  draw(props.lines, fbo);
  draw(props.moving, fbo);
  if (rough_ && rests_ && whole_ == Whole::wanted) refine(props, now, fbo);
}

/// Goes on with the picture of what stands still. The next picture begins with it when it is ready.
void CachedBackground::refine(const Sorted& props, const Key& now, vtkFrameBufferObjectBase* fbo) {
  const auto start = Clock::now();
  vtkOpenGLState* state = vtkOpenGLRenderWindow::SafeDownCast(GetRenderWindow())->GetState();
  Props all = props.surfaces;
  all.insert(all.end(), props.large.begin(), props.large.end());
  state->PushFramebufferBindings();
  prepare(next_store_);
  state->vtkglBindFramebuffer(GL_FRAMEBUFFER, handle(next_store_));
  if (!(refined_ == now)) {
    refined_ = now;
    refined_to_ = 0;
    refining_ms_ = 0;
    Superclass::Clear();
    ready_for_surfaces();
  }
  while (refined_to_ < all.size() && milliseconds_since(start) < refining_in_one_ms) draw({all[refined_to_++]}, fbo);
  refining_ms_ += milliseconds_since(start);
  state->PopFramebufferBindings();
  if (refined_to_ < all.size()) return;
  whole_ms_ = refining_ms_;
  std::swap(store_, next_store_);
  in_store_ = true;
  stored_ = std::exchange(refined_, {});
  ++still_drawn_;
}

void CachedBackground::ReleaseGraphicsResources(vtkWindow* window) {
  in_store_ = false;
  refined_ = {};
  for (vtkOpenGLFramebufferObject* store : {store_.Get(), next_store_.Get()}) store->ReleaseGraphicsResources(window);
  Superclass::ReleaseGraphicsResources(window);
}

}  // namespace loopmend
