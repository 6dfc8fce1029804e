// SPDX-License-Identifier: GPL-3.0-or-later
#include "mirror/mirror_patch.h"

#include "mirror/carry_misfit.h"
#include "mirror/cut_image.h"

#include <limits>
#include <utility>

namespace loopmend {

namespace {

/// Largest misfit, in parts of the distance from a quadric and in diameters (docs/math/mirror_image.md, "The test").
constexpr double most_of_quadric = 0.1, most_misfit = 0.02;
/// Of a plane, in extents of the surface: beyond, the surface has no symmetry, and what fits does so by chance.
constexpr double most_plane_misfit = 0.012;

struct FittedImage {
  MirrorFit fit;
  MirrorImage image;
};

/// The image with the least misfit; of planes that are none of symmetry only where there are no others.
FittedImage best_image(const SurfaceModel& model, const TriangleIndex& index, const Patch& patch, const Collar& collar,
                       const std::vector<MirrorPlane>& planes, const CancelToken& cancel) {
  FittedImage best;
  best.fit.answer = MirrorFit::Answer::open_there;
  best.fit.quadric = collar.quadric;
  best.fit.misfit = std::numeric_limits<double>::quiet_NaN();
  if (!planes.empty()) best.fit.plane = planes.front();
  for (const MirrorPlane& plane : planes) {
    if (plane.misfit > most_plane_misfit && planes.front().misfit <= most_plane_misfit) break;
    MirrorImage image = mirror_image(model, index, patch, collar, plane, cancel);
    if (image.triangles.empty() || (!best.image.triangles.empty() && best.fit.misfit <= image.misfit)) continue;
    best.fit.plane = plane;
    best.fit.misfit = image.misfit;
    best.fit.answer = MirrorFit::Answer::misfit;
    if (plane.misfit > most_plane_misfit)
      best.fit.answer = MirrorFit::Answer::no_symmetry;
    else if (fits(image.misfit, collar.quadric))
      best.fit.answer = MirrorFit::Answer::proposed;
    best.image = std::move(image);
  }
  return best;
}

/// The patch with other triangles of its own. @param own  the loop's vertices first, in loop order
Patch with_own_mesh(const Patch& initial, const LoopPatch& own) {
  const int boundary = static_cast<int>(initial.loops[0].size());
  const int free = static_cast<int>(own.points.size()) - boundary, shift = free - initial.free_count;
  Patch patch = initial;
  patch.free_count = free;
  patch.positions.assign(own.points.begin() + boundary, own.points.end());
  patch.positions.insert(patch.positions.end(), initial.positions.begin() + initial.free_count,
                         initial.positions.end());
  patch.ring.assign(free, 0);
  patch.ring.insert(patch.ring.end(), initial.ring.begin() + initial.free_count, initial.ring.end());
  patch.view_vertex.assign(free, -1);
  patch.view_vertex.insert(patch.view_vertex.end(), initial.view_vertex.begin() + initial.free_count,
                           initial.view_vertex.end());
  for (int& v : patch.loops[0]) v += shift;
  patch.triangles.clear();
  for (Triangle t : own.triangles) {
    for (int& v : t) v = v < boundary ? patch.loops[0][v] : v - boundary;
    patch.triangles.push_back(t);
  }
  patch.patch_triangles = static_cast<int>(patch.triangles.size());
  for (std::size_t f = initial.patch_triangles; f < initial.triangles.size(); ++f) {
    Triangle t = initial.triangles[f];
    for (int& v : t) v += shift;
    patch.triangles.push_back(t);
  }
  return patch;
}

}  // namespace

const char* to_string(MirrorFit::Answer answer) {
  switch (answer) {
    case MirrorFit::Answer::not_asked: return "not_asked";
    case MirrorFit::Answer::proposed: return "proposed";
    case MirrorFit::Answer::misfit: return "misfit";
    case MirrorFit::Answer::no_symmetry: return "no_symmetry";
    case MirrorFit::Answer::open_there: return "open_there";
    case MirrorFit::Answer::no_disc: return "no_disc";
    case MirrorFit::Answer::faulty: return "faulty";
    case MirrorFit::Answer::several_loops: return "several_loops";
  }
  return "";
}

bool fits(double misfit, double quadric) { return misfit < most_misfit && misfit < most_of_quadric * quadric; }

Notice notice_on(const MirrorFit& fit) {
  switch (fit.answer) {
    case MirrorFit::Answer::proposed: return {NoticeCode::mirror_image, {fit.misfit}};
    case MirrorFit::Answer::misfit: return {NoticeCode::mirror_misfit, {fit.misfit, fit.quadric}};
    case MirrorFit::Answer::no_symmetry: return {NoticeCode::mirror_no_symmetry, {fit.plane.misfit}};
    case MirrorFit::Answer::not_asked:
    case MirrorFit::Answer::open_there: return {NoticeCode::mirror_open, {}};
    case MirrorFit::Answer::no_disc:
    case MirrorFit::Answer::faulty:
    case MirrorFit::Answer::several_loops: return {NoticeCode::mirror_faulty, {}};
  }
  return {};
}

MirrorPatch mirror_patch(const SurfaceModel& model, const TriangleIndex& index, const Patch& initial,
                         const std::vector<MirrorPlane>& planes, const IsSound& is_sound, const CancelToken& cancel) {
  using Answer = MirrorFit::Answer;
  if (planes.empty()) return {};
  if (initial.loops.size() != 1) {
    MirrorPatch none;
    none.fit.answer = Answer::several_loops;
    return none;
  }
  const Collar collar = collar_of(initial);
  FittedImage found = best_image(model, index, initial, collar, planes, cancel);
  MirrorPatch made{found.fit, std::nullopt};
  if (!made.fit.is_proposed() || cancel.cancelled()) return made;
  if (!carry_misfit(initial, collar, found.image)) {
    made.fit.answer = Answer::misfit;
    return made;
  }
  made.fit.answer = Answer::faulty;
  bool tried = false;
  for (const CutImage& cut : cut_image(initial, found.image, cancel)) {
    if (cut.fault != CutFault::none) {
      if (!tried) made.fit.answer = cut.fault == CutFault::open_there ? Answer::open_there : Answer::no_disc;
      break;
    }
    tried = true;
    Patch patch = with_own_mesh(initial, cut.patch);
    if (!is_sound(patch)) continue;
    made.fit.answer = Answer::proposed;
    made.patch = std::move(patch);
    break;
  }
  return made;
}

}  // namespace loopmend
