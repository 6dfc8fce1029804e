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
#include <utility>

namespace loopmend {

vtkStandardNewMacro(CachedBackground);

CachedBackground::CachedBackground() = default;
CachedBackground::~CachedBackground() = default;

void CachedBackground::add_still(vtkProp* prop) {
  still_.insert(prop);
  still_changed();
}

void CachedBackground::remove_still(vtkProp* prop) {
  still_.erase(prop);
  still_changed();
}

CachedBackground::Key CachedBackground::key() {
  int width = 0, height = 0, left = 0, bottom = 0;
  GetTiledSizeAndOrigin(&width, &height, &left, &bottom);
  const auto whole = [](int n) { return static_cast<vtkMTimeType>(n); };
  return {{GetActiveCamera()->GetMTime(), whole(width), whole(height), whole(left), whole(bottom),
           whole(GetRenderWindow()->GetSize()[0]) << 16 | whole(GetRenderWindow()->GetSize()[1])},
          version_};
}

/// Between the picture that is being made and the store. @returns whether the graphics could.
bool CachedBackground::copy(Way way) {
  auto* window = vtkOpenGLRenderWindow::SafeDownCast(GetRenderWindow());
  if (!window || !works_) return false;
  const int* size = window->GetSize();
  vtkOpenGLState* state = window->GetState();
  GLint drawn = 0;
  glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &drawn);
  state->PushFramebufferBindings();
  if (!store_->GetFBOIndex() || store_->GetLastSize()[0] != size[0] || store_->GetLastSize()[1] != size[1]) {
    // Depths can be copied only between buffers of one format.
    GLint bits = 0;
    glGetFramebufferAttachmentParameteriv(GL_DRAW_FRAMEBUFFER, GL_DEPTH_ATTACHMENT,
                                          GL_FRAMEBUFFER_ATTACHMENT_DEPTH_SIZE, &bits);
    store_->SetContext(window);
    store_->PopulateFramebuffer(size[0], size[1], true, 1, VTK_UNSIGNED_CHAR, true, bits, 0,
                                window->GetStencilCapable() != 0);
  }
  const auto stored = static_cast<GLuint>(store_->GetFBOIndex());
  const bool storing = way == Way::into_store;
  state->vtkglBindFramebuffer(GL_READ_FRAMEBUFFER, storing ? static_cast<GLuint>(drawn) : stored);
  state->vtkglBindFramebuffer(GL_DRAW_FRAMEBUFFER, storing ? stored : static_cast<GLuint>(drawn));
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
  vtkOpenGLState* state = vtkOpenGLRenderWindow::SafeDownCast(GetRenderWindow())->GetState();
  // Qt leaves another one, now and then; for software graphics each of the two makes a program a different one.
  state->vtkglDepthFunc(GL_LEQUAL);
  restored_ = false;
  if (in_store_ && stored_ == key()) restored_ = copy(Way::out_of_store);
  if (!restored_) return Superclass::Clear();
  // Clear() does this as well: legends and letters of the last picture leave it switched off.
  state->vtkglEnable(GL_DEPTH_TEST);
  state->vtkglDepthMask(GL_TRUE);
}

/// A part of the props alone.
void CachedBackground::draw(vtkProp** from, vtkProp** to, vtkFrameBufferObjectBase* fbo) {
  vtkProp** const all = std::exchange(PropArray, from);
  const int count = std::exchange(PropArrayCount, static_cast<int>(to - from));
  Superclass::DeviceRenderOpaqueGeometry(fbo);
  PropArray = all;
  PropArrayCount = count;
}

void CachedBackground::DeviceRenderOpaqueGeometry(vtkFrameBufferObjectBase* fbo) {
  vtkProp** const end = PropArray + PropArrayCount;
  const Key now = key();
  const bool rests = std::exchange(last_view_, now.view) == now.view;
  if (GetSelector() || (keep_ == Keep::while_camera_rests && !rests && !restored_)) {
    draw(PropArray, end, fbo);
    return;
  }
  vtkProp** const moving =
      std::stable_partition(PropArray, end, [this](vtkProp* prop) { return still_.contains(prop); });
  if (!restored_) {
    draw(PropArray, moving, fbo);
    ++still_drawn_;
    in_store_ = copy(Way::into_store);
    stored_ = now;
  }
  draw(moving, end, fbo);
}

void CachedBackground::ReleaseGraphicsResources(vtkWindow* window) {
  in_store_ = false;
  store_->ReleaseGraphicsResources(window);
  Superclass::ReleaseGraphicsResources(window);
}

}  // namespace loopmend
