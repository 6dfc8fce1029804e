// SPDX-License-Identifier: GPL-3.0-or-later
// The plane of symmetry of a scan, and which open holes its mirror image fits, computed beside other work.
#pragma once

#include "document/document.h"
#include "document/hole_selection.h"
#include "jobs/plane_guide.h"
#include "jobs/scan_context.h"
#include "jobs/task_runner.h"
#include "mirror/mirror_patch.h"

#include <QObject>

#include <functional>
#include <optional>
#include <vector>

namespace loopmend {

class MirrorGuide : public PlaneGuide {
  Q_OBJECT

 public:
  using ContextOf = std::function<ScanContextPtr(int scan)>;
  MirrorGuide(Document& document, const HoleSelection& selection, ContextOf context_of, QObject* parent = nullptr);

  /// The open holes that are selected, else the largest ones.
  struct Fit {
    int loop = 0;
    MirrorFit fit;
    SurfaceShapePtr ghost;  ///< the patch that would be copied; null: it does not fit
  };

  enum class Watch { nothing, scan };
  /// That of the selected hole, else the first. Its planes are looked for once.
  void watch(Watch what);
  int scan() const override { return scan_; }
  bool busy() const { return job_ != nullptr; }
  bool has_failed() const { return has_failed_; }                              ///< of the last search or comparison
  const std::vector<MirrorPlane>& planes() const { return planes_; }           ///< found, the best first
  const std::optional<MirrorPlane>& plane() const override { return plane_; }  ///< what holes are compared in
  const std::vector<Fit>& fits() const { return fits_; }

  /// The holes are compared when it is let go.
  void move_plane(const MirrorPlane& plane) override;
  void let_go() override;
  Sides sides() const override { return Sides::alike; }
  /// Whether fills of this scan copy from the image where it fits.
  enum class Use { no, where_it_fits };
  void use(Use use);
  /// Whether selected holes alone are compared.
  bool is_of_selection() const { return !selection_.selected().empty(); }
  Use use() const { return document_.mirror_plane(scan_) ? Use::where_it_fits : Use::no; }
  bool shut_down(std::chrono::milliseconds at_most);

 private:
  void follow();
  template <class Work, class Done>
  void start(Work work, Done done);
  void stop();
  void find_planes();
  void compare();
  std::vector<int> loops() const;

  Document& document_;
  const HoleSelection& selection_;
  ContextOf context_of_;
  Watch watch_ = Watch::nothing;
  int scan_ = -1;
  std::vector<MirrorPlane> planes_;
  std::optional<MirrorPlane> plane_;
  std::vector<Fit> fits_;
  std::vector<int> compared_;
  bool has_failed_ = false;
  JobPtr job_;
  TaskRunner tasks_;
};

}  // namespace loopmend
