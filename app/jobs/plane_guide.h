// SPDX-License-Identifier: GPL-3.0-or-later
// A plane across a scan that a person drags.
#pragma once

#include "mirror/mirror_plane.h"

#include <QObject>

#include <optional>

namespace loopmend {

class PlaneGuide : public QObject {
  Q_OBJECT

 public:
  using QObject::QObject;

  virtual int scan() const = 0;  ///< -1: none
  virtual const std::optional<MirrorPlane>& plane() const = 0;
  /// Shown at once.
  virtual void move_plane(const MirrorPlane& plane) = 0;
  virtual void let_go() = 0;
  /// Whether the side to which the normal points is another than the one behind it.
  enum class Sides { alike, one_goes };
  virtual Sides sides() const = 0;

 Q_SIGNALS:
  void changed();
};

}  // namespace loopmend
