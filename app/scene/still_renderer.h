// SPDX-License-Identifier: GPL-3.0-or-later
// A renderer that keeps the picture of what stands still, colours and depths, and draws only what moves over it: software
// graphics take a hundred times as long for a scan as for the patch in it.
#pragma once

#include <vtkNew.h>
#include <vtkOpenGLRenderer.h>

#include <array>
#include <set>

class vtkOpenGLFramebufferObject;

namespace loopmend {

class StillRenderer : public vtkOpenGLRenderer {
 public:
  static StillRenderer* New();
  vtkTypeMacro(StillRenderer, vtkOpenGLRenderer) StillRenderer(const StillRenderer&) = delete;
  void operator=(const StillRenderer&) = delete;

  /// Something is about to move in front of what stands still, or nothing is any more. What was kept is used either way.
  enum class Use { draw_all, keep_still };
  void set_use(Use use) { use_ = use; }
  /// This prop stands still. To be called again when the prop comes anew; takes no part in its lifetime.
  void add_still(vtkProp* prop);
  void remove_still(vtkProp* prop);
  /// Something of what stands still, or the ground behind it, looks otherwise now.
  void still_changed() { ++version_; }
  /// How often what stands still was drawn; for tests.
  int still_drawn() const { return still_drawn_; }

  void Clear() override;
  void DeviceRenderOpaqueGeometry(vtkFrameBufferObjectBase* fbo) override;
  void ReleaseGraphicsResources(vtkWindow* window) override;

 protected:
  StillRenderer();
  ~StillRenderer() override;

 private:
  using Key = std::array<vtkMTimeType, 7>;
  Key key();
  enum class Way { into_store, out_of_store };
  bool copy(Way way);

  vtkNew<vtkOpenGLFramebufferObject> store_;
  std::set<vtkProp*> still_;
  Key stored_{};
  Use use_ = Use::draw_all;
  vtkMTimeType version_ = 1;
  int still_drawn_ = 0;
  bool in_store_ = false;  ///< stored_ says of what
  bool restored_ = false;  ///< this picture began with what is stored
  bool works_ = true;      ///< these graphics can copy depths
};

}  // namespace loopmend
