// SPDX-License-Identifier: GPL-3.0-or-later
// A patch from the mirror image of what the surface has on the other side of a plane (docs/math/mirror_image.md).
#pragma once

#include "core/cancel.h"
#include "core/notice.h"
#include "mesh/patch.h"
#include "mesh/self_intersections.h"
#include "mirror/mirror_plane.h"

#include <functional>
#include <optional>
#include <vector>

namespace loopmend {

/// How well the image fits the surface around a hole, and whether it may be taken.
struct MirrorFit {
  enum class Answer {
    not_asked,    ///< without a plane
    proposed,     ///< it fits
    misfit,       ///< it fits too badly, or hardly better than a plain quadric would
    no_symmetry,  ///< the surface is not its own image in any plane
    open_there,   ///< nothing to copy: the surface has a hole or its end there, or the hole lies across the plane
    no_disc,      ///< what is there does not close the hole in one part
    faulty,       ///< the patch folds or cuts the surface
    several_loops,
  } answer = Answer::not_asked;
  MirrorPlane plane;   ///< that fits this hole best
  double misfit = 0;   ///< rms distance of the surface around the hole from its image, in loop diameters
  double quadric = 0;  ///< the same from a quadric

  bool is_proposed() const { return answer == Answer::proposed; }
};

/// The word of reports.
const char* to_string(MirrorFit::Answer answer);

/// What a person has to know of a fit, with its figures.
Notice notice_on(const MirrorFit& fit);

/// Whether an image with this misfit is taken.
bool fits(double misfit, double quadric);

struct MirrorPatch {
  MirrorFit fit;
  std::optional<Patch>
      patch;  ///< where it is proposed: the loop and the surface outside are those of the initial patch
};

/// Tells whether a patch folds or cuts anything.
using IsSound = std::function<bool(const Patch&)>;

/// @param initial  any patch with one loop. @param is_sound  is asked for patches with wider and wider strips, until one is.
MirrorPatch mirror_patch(const SurfaceModel& model, const TriangleIndex& index, const Patch& initial,
                         const std::vector<MirrorPlane>& planes, const IsSound& is_sound,
                         const CancelToken& cancel = {});

}  // namespace loopmend
