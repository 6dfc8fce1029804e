// SPDX-License-Identifier: GPL-3.0-or-later
// The plane by which a scan is to be cut: that of the selected hole, else the first one.
#pragma once

#include "document/document.h"
#include "document/hole_selection.h"
#include "jobs/plane_guide.h"

#include <optional>

namespace loopmend {

class CutGuide : public PlaneGuide {
  Q_OBJECT

 public:
  CutGuide(const Document& document, const HoleSelection& selection, QObject* parent = nullptr);

  enum class Watch { nothing, scan };
  void watch(Watch what);

  int scan() const override { return scan_; }
  const std::optional<MirrorPlane>& plane() const override { return plane_; }
  void move_plane(const MirrorPlane& plane) override;
  void let_go() override {}
  Sides sides() const override { return Sides::one_goes; }

  /// Square to an axis of the file, 0 for x, through the middle of the scan.
  void place_across(int axis);
  /// The other side goes.
  void turn();

 private:
  void follow();

  const Document& document_;
  const HoleSelection& selection_;
  Watch watch_ = Watch::nothing;
  int scan_ = -1;
  std::optional<MirrorPlane> plane_;
};

}  // namespace loopmend
