// SPDX-License-Identifier: GPL-3.0-or-later
// A renderer that keeps the picture of what stands still, colours and depths, and draws only what moves over it: software
// graphics take a hundred times as long for a scan as for the patch in it. Of large scans it draws a reduced version while the
// eye moves, and the whole afterwards, some of it in each picture, so that no picture takes long.
#pragma once

#include <vtkOpenGLRenderer.h>
#include <vtkSmartPointer.h>

#include <array>
#include <map>
#include <vector>

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

  enum class LargeScans {
    whole,             ///< in every picture
    reduced_at_first,  ///< their reduced versions, until the picture of what stands still is ready; not where the whole takes
                       ///< no longer than a moment, as in a close view
  };
  void set_large_scans(LargeScans way) { large_scans_ = way; }
  enum class Whole {
    not_ready,  ///< large surfaces are still missing, or not as they will be
    later,      ///< the eye moves
    wanted,     ///< each picture does a part of the work, unless the camera has just moved
  };
  void set_whole(Whole whole) { whole_ = whole; }
  /// Whether the last picture was not yet what it will be: some of it was reduced, or looked as it did before.
  bool is_rough() const { return rough_; }

  enum class Part {
    surface,          ///< small
    large_surface,    ///< a slice of one that has a reduced version
    reduced_surface,  ///< drawn instead of large surfaces
    line,
  };
  /// This prop stands still. To be called again when the prop comes again; takes no part in its lifetime.
  void add_still(vtkProp* prop, Part part);
  void remove_still(vtkProp* prop);
  /// The surfaces that stand still, or the ground behind them, look otherwise now.
  void still_changed() { ++version_; }
  void lines_changed() { ++lines_version_; }
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
  using Props = std::vector<vtkProp*>;
  struct Sorted {
    Props surfaces, large, reduced, lines, moving;
  };
  Key key() const;
  Sorted sorted() const;
  bool reduces() const;
  enum class Way { into_store, out_of_store };
  bool copy(Way way);
  void prepare(vtkOpenGLFramebufferObject* store);
  void draw(const Props& props, vtkFrameBufferObjectBase* fbo);
  void draw_whole(const Sorted& props, const Key& now, vtkFrameBufferObjectBase* fbo);
  void draw_reduced(const Sorted& props, const Key& now, vtkFrameBufferObjectBase* fbo);
  void refine(const Sorted& props, const Key& now, vtkFrameBufferObjectBase* fbo);
  void ready_for_surfaces();

  vtkSmartPointer<vtkOpenGLFramebufferObject> store_, next_store_;
  std::map<vtkProp*, Part> parts_;
  Key stored_{};
  Key refined_{};               ///< of the picture that is being made in next_store_
  std::size_t refined_to_ = 0;  ///< how many surfaces it has
  View last_view_{};
  Keep keep_ = Keep::while_camera_rests;
  LargeScans large_scans_ = LargeScans::whole;
  Whole whole_ = Whole::wanted;
  vtkMTimeType version_ = 1, lines_version_ = 1;
  static constexpr double unknown_ms = 1e9;
  double whole_ms_ = unknown_ms;  ///< what the surfaces took when they were last drawn as a whole
  double refining_ms_ = 0;
  bool rests_ = false;  ///< the camera, since the last picture
  bool rough_ = false;
  int still_drawn_ = 0;
  bool in_store_ = false;  ///< stored_ says of what
  bool restored_ = false;  ///< this picture began with what is stored
  bool works_ = true;      ///< these graphics can copy depths
};

}  // namespace loopmend
