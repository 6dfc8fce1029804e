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

class CachedBackground : public vtkOpenGLRenderer {
 public:
  static CachedBackground* New();
  vtkTypeMacro(CachedBackground, vtkOpenGLRenderer) CachedBackground(const CachedBackground&) = delete;
  void operator=(const CachedBackground&) = delete;

  /// Whether the picture of what stands still is kept although the camera has moved since the last one: something is on its
  /// way in front of it. Where the camera rests it is kept in any case, since what changes is then what moves.
  enum class Keep { while_camera_rests, always };
  void set_keep(Keep keep) { keep_ = keep; }
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
  CachedBackground();
  ~CachedBackground() override;

 private:
  /// What a picture of what stands still depends on, but for how it looks.
  using View = std::array<vtkMTimeType, 6>;
  struct Key {
    View view{};
    vtkMTimeType version = 0;
    bool operator==(const Key&) const = default;
  };
  Key key();
  enum class Way { into_store, out_of_store };
  bool copy(Way way);
  void draw(vtkProp** from, vtkProp** to, vtkFrameBufferObjectBase* fbo);

  vtkNew<vtkOpenGLFramebufferObject> store_;
  std::set<vtkProp*> still_;
  Key stored_{};
  View last_view_{};
  Keep keep_ = Keep::while_camera_rests;
  vtkMTimeType version_ = 1;
  int still_drawn_ = 0;
  bool in_store_ = false;  ///< stored_ says of what
  bool restored_ = false;  ///< this picture began with what is stored
  bool works_ = true;      ///< these graphics can copy depths
};

}  // namespace loopmend
