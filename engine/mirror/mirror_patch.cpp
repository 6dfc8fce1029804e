// SPDX-License-Identifier: GPL-3.0-or-later
#include "mirror/mirror_patch.h"

#include "mirror/carry_misfit.h"
#include "mirror/cut_image.h"
#include "mirror/symmetric_patch.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace loopmend {

namespace {

/// Largest misfit, diameters (docs/math/mirror_image.md, "The test").
constexpr double most_misfit = 0.02;
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
  best.fit.misfit = std::numeric_limits<double>::quiet_NaN();
  if (!planes.empty()) best.fit.plane = planes.front();
  for (const MirrorPlane& plane : planes) {
    if (plane.misfit > most_plane_misfit && planes.front().misfit <= most_plane_misfit) break;
    MirrorImage image = mirror_image(model, index, patch, collar, plane, MirrorOf::surface, cancel);
    if (image.triangles.empty() || (!best.image.triangles.empty() && best.fit.misfit <= image.misfit)) continue;
    best.fit.plane = plane;
    best.fit.misfit = image.misfit;
    best.fit.answer = MirrorFit::Answer::misfit;
    if (plane.misfit > most_plane_misfit)
      best.fit.answer = MirrorFit::Answer::no_symmetry;
    else if (image.misfit < most_misfit)
      best.fit.answer = MirrorFit::Answer::proposed;
    best.image = std::move(image);
  }
  return best;
}

/// How well the image of the surface, with its hole closed, fits in the first plane of symmetry that the hole lies
/// across; of an image with nothing to compare, `open_there`.
std::optional<MirrorFit> fit_across(const SurfaceModel& model, const TriangleIndex& index, const Patch& patch,
                                    const Collar& collar, const std::vector<MirrorPlane>& planes,
                                    const CancelToken& cancel) {
  const auto plane = std::find_if(planes.begin(), planes.end(), [&](const MirrorPlane& candidate) {
    return candidate.misfit <= most_plane_misfit && lies_across(patch, candidate);
  });
  if (plane == planes.end()) return std::nullopt;
  const MirrorImage image = mirror_image(model, index, patch, collar, *plane, MirrorOf::closed_surface, cancel);
  MirrorFit fit{MirrorFit::Answer::open_there, *plane, image.misfit};
  if (!image.triangles.empty())
    fit.answer = image.misfit < most_misfit ? MirrorFit::Answer::across : MirrorFit::Answer::misfit;
  return fit;
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

/// Offers the image, cut and joined to the loop, with wider and wider strips. @returns `proposed` where one was taken.
MirrorFit::Answer first_taken(const Patch& initial, MirrorImage& image, const Take& take, const CancelToken& cancel) {
  using Answer = MirrorFit::Answer;
  if (!carry_misfit(initial, cancel, image)) return Answer::misfit;
  bool offered = false;
  for (const CutImage& cut : cut_image(initial, image, cancel)) {
    if (cut.fault != CutFault::none) {
      if (offered) break;
      return cut.fault == CutFault::open_there ? Answer::open_there : Answer::no_disc;
    }
    offered = true;
    if (take(with_own_mesh(initial, cut.patch))) return Answer::proposed;
  }
  return Answer::faulty;
}

}  // namespace

const char* to_string(MirrorFit::Answer answer) {
  switch (answer) {
    case MirrorFit::Answer::not_asked: return "not_asked";
    case MirrorFit::Answer::proposed: return "proposed";
    case MirrorFit::Answer::misfit: return "misfit";
    case MirrorFit::Answer::no_gain: return "no_gain";
    case MirrorFit::Answer::no_symmetry: return "no_symmetry";
    case MirrorFit::Answer::across: return "across";
    case MirrorFit::Answer::symmetric: return "symmetric";
    case MirrorFit::Answer::open_there: return "open_there";
    case MirrorFit::Answer::no_disc: return "no_disc";
    case MirrorFit::Answer::faulty: return "faulty";
    case MirrorFit::Answer::several_loops: return "several_loops";
  }
  return "";
}

Notice notice_on(const MirrorFit& fit) {
  switch (fit.answer) {
    case MirrorFit::Answer::proposed: return {NoticeCode::mirror_image, {fit.misfit}};
    case MirrorFit::Answer::misfit: return {NoticeCode::mirror_misfit, {fit.misfit}};
    case MirrorFit::Answer::no_gain: return {NoticeCode::mirror_no_gain, {fit.misfit, fit.difference}};
    case MirrorFit::Answer::no_symmetry: return {NoticeCode::mirror_no_symmetry, {fit.plane.misfit}};
    case MirrorFit::Answer::across: return {NoticeCode::mirror_across, {fit.misfit}};
    case MirrorFit::Answer::symmetric: return {NoticeCode::mirror_symmetric, {fit.misfit}};
    case MirrorFit::Answer::not_asked:
    case MirrorFit::Answer::open_there: return {NoticeCode::mirror_open, {}};
    case MirrorFit::Answer::no_disc:
    case MirrorFit::Answer::faulty:
    case MirrorFit::Answer::several_loops: return {NoticeCode::mirror_faulty, {}};
  }
  return {};
}

MirrorFit mirror_patch(const SurfaceModel& model, const TriangleIndex& index, const Patch& initial,
                       const std::vector<MirrorPlane>& planes, const Take& take, const CancelToken& cancel) {
  using Answer = MirrorFit::Answer;
  MirrorFit none;
  if (planes.empty()) return none;
  if (initial.loops.size() != 1) {
    none.answer = Answer::several_loops;
    return none;
  }
  const Collar collar = collar_of(initial);
  FittedImage found = best_image(model, index, initial, collar, planes, cancel);
  if (found.fit.is_proposed()) found.fit.answer = first_taken(initial, found.image, take, cancel);
  if (found.fit.answer != Answer::open_there && found.fit.answer != Answer::misfit) return found.fit;
  return fit_across(model, index, initial, collar, planes, cancel).value_or(found.fit);
}

}  // namespace loopmend
