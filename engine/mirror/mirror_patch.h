// SPDX-License-Identifier: GPL-3.0-or-later
// A patch from the mirror image of what the surface has on the other side of a plane (docs/math/mirror_image.md).
#pragma once

#include "core/cancel.h"
#include "core/notice.h"
#include "mesh/patch.h"
#include "mesh/self_intersections.h"
#include "mirror/mirror_plane.h"

#include <functional>
#include <limits>
#include <vector>

namespace loopmend {

/// How well the image fits the surface around a hole, and whether it may be taken.
struct MirrorFit {
  enum class Answer {
    not_asked,    ///< without a plane
    proposed,     ///< it fits
    misfit,       ///< it fits too badly
    no_gain,      ///< it fits, but the ordinary patch is as near to it as the surface around is
    no_symmetry,  ///< the surface is not its own image in any plane
    across,       ///< it fits, but the hole lies across the plane
    symmetric,    ///< the same, and the patch was made symmetric
    open_there,   ///< nothing to copy: the surface has a hole or its end there
    no_disc,      ///< what is there does not close the hole in one part
    faulty,       ///< the patch folds or cuts the surface
    several_loops,
  } answer = Answer::not_asked;
  MirrorPlane plane;  ///< that fits this hole best
  double misfit = 0;  ///< rms distance of the surface around the hole from its image, in loop diameters
  double difference = std::numeric_limits<double>::quiet_NaN();  ///< of the image from the ordinary patch, likewise

  bool is_proposed() const { return answer == Answer::proposed; }
  /// Whether it is seen in the patch.
  bool is_used() const { return is_proposed() || answer == Answer::symmetric; }
};

/// The word of reports.
const char* to_string(MirrorFit::Answer answer);

/// What a person has to know of a fit, with its figures.
Notice notice_on(const MirrorFit& fit);

/// Takes a patch, unless it folds or cuts anything.
using Take = std::function<bool(const Patch&)>;

/// @param initial  any patch with one loop; its loop and the surface outside are those of the image, too.
/// @param take  is asked for patches with wider and wider strips, until it takes one.
/// @returns `proposed` where one was taken.
MirrorFit mirror_patch(const SurfaceModel& model, const TriangleIndex& index, const Patch& initial,
                       const std::vector<MirrorPlane>& planes, const Take& take, const CancelToken& cancel = {});

}  // namespace loopmend
