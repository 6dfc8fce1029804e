// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/notice.h"

#include <cmath>
#include <cstdio>

namespace loopmend {

namespace {

double argument(const Notice& notice, std::size_t k) {
  return k < notice.arguments.size() ? notice.arguments[k] : std::nan("");
}

std::string rounded(double value) { return std::to_string(std::lround(value)); }

/// Two digits, or all before the point: "0.42", "12", "964"; "0" below 1e-4, and "1.1e+13" from a million on.
std::string two_digits(double value) {
  if (std::abs(value) < 1e-4) return "0";
  if (std::abs(value) >= 100 && std::abs(value) < 1e6) return rounded(value);
  char text[32];
  std::snprintf(text, sizeof text, "%.2g", value);
  return text;
}

}  // namespace

const char* to_string(NoticeCode code) {
  switch (code) {
    case NoticeCode::crosses_surface: return "crosses_surface";
    case NoticeCode::nonmanifold_edges: return "nonmanifold_edges";
    case NoticeCode::folded_edges: return "folded_edges";
    case NoticeCode::torn_seam: return "torn_seam";
    case NoticeCode::dome_over_flat_loop: return "dome_over_flat_loop";
    case NoticeCode::flat_or_dome: return "flat_or_dome";
    case NoticeCode::bubble: return "bubble";
    case NoticeCode::curvature_torn: return "curvature_torn";
    case NoticeCode::initial_patch_kept: return "initial_patch_kept";
    case NoticeCode::edges_rounded: return "edges_rounded";
    case NoticeCode::wall_ends: return "wall_ends";
    case NoticeCode::crease: return "crease";
    case NoticeCode::bent_inside: return "bent_inside";
    case NoticeCode::seam_worse: return "seam_worse";
    case NoticeCode::high_over_loop: return "high_over_loop";
    case NoticeCode::likely_far: return "likely_far";
    case NoticeCode::mirror_image: return "mirror_image";
    case NoticeCode::mirror_misfit: return "mirror_misfit";
    case NoticeCode::mirror_no_gain: return "mirror_no_gain";
    case NoticeCode::mirror_no_symmetry: return "mirror_no_symmetry";
    case NoticeCode::mirror_across: return "mirror_across";
    case NoticeCode::mirror_symmetric: return "mirror_symmetric";
    case NoticeCode::mirror_open: return "mirror_open";
    case NoticeCode::mirror_faulty: return "mirror_faulty";
  }
  return "";
}

namespace {

Message sentence(const Notice& notice) {
  const auto number = [&](std::size_t k) { return argument(notice, k); };
  const bool one = std::lround(number(0)) == 1;
  const std::string whole = rounded(number(0)), digits = two_digits(number(0)), more = two_digits(number(1));
  switch (notice.code) {
    case NoticeCode::crosses_surface:
      return one ? say("crosses the surface or itself in 1 place")
                 : say("crosses the surface or itself in %1 places", whole);
    case NoticeCode::nonmanifold_edges:
      return one ? say("1 edge has more than two faces") : say("%1 edges have more than two faces", whole);
    case NoticeCode::folded_edges:
      return one ? say("1 edge is folded by more than 150°") : say("%1 edges are folded by more than 150°", whole);
    case NoticeCode::torn_seam:
      return say("a crease of %1° along %2 edges of the seam, where the initial patch had %3°", whole,
                 rounded(number(1)), rounded(number(2)));
    case NoticeCode::dome_over_flat_loop: return say("a dome %1 diameters high over a flat loop", digits);
    case NoticeCode::flat_or_dome: return say("closed flat, where the surface bends as if it went on as a dome");
    case NoticeCode::bubble:
      return number(1) > 0.05
                 ? say("a bubble of %1 times the area of the initial patch, reaching %2 diameters beyond it", digits,
                       more)
                 : say("a bubble of %1 times the area of the initial patch", digits);
    case NoticeCode::curvature_torn:
      return say("mean curvature jumps at the seam by %1 / diameter, before the flow by %2", digits, more);
    case NoticeCode::initial_patch_kept:
      return say("no flow or fairing gave a sound patch: the initial patch was kept");
    case NoticeCode::edges_rounded: return say("sharp edges of the scan end here, and the patch rounds them");
    case NoticeCode::wall_ends:
      return say("a wall ends here and at another loop, and a ring between them is more likely than this patch");
    case NoticeCode::crease:
      return std::lround(number(1)) == 1 ? say("a crease of %1° along 1 edge of the seam", whole)
                                         : say("a crease of %1° along %2 edges of the seam", whole, rounded(number(1)));
    case NoticeCode::bent_inside: return say("edges inside the patch bend by %1° along %2 diameters", whole, more);
    case NoticeCode::seam_worse:
      return say("the seam bends by %1° (rms), in the initial patch by %2°", whole, rounded(number(1)));
    case NoticeCode::high_over_loop:
      return say("rises %1 diameters over its loop; a ball through the seam would rise %2", digits, more);
    case NoticeCode::likely_far: return say("what was there may lie %1 diameters away: the shape is a guess", digits);
    case NoticeCode::mirror_image:
      return say("copied from the mirror image, from which the surface around is %1 diameters away", digits);
    case NoticeCode::mirror_misfit:
      return say("not copied from the mirror image, from which the surface around is %1 diameters away: more than 0.02",
                 digits);
    case NoticeCode::mirror_no_gain:
      return say(
          "not copied from the mirror image: the surface around is %1 diameters away from it, and the patch hardly "
          "more, "
          "%2",
          digits, more);
    case NoticeCode::mirror_no_symmetry:
      return say(
          "not copied from the mirror image, since the scan is not symmetric: its best image is %1 of its extent away",
          digits);
    case NoticeCode::mirror_across:
      return say(
          "not made symmetric, though the hole lies across the plane of symmetry: the surface around is %1 diameters "
          "from "
          "its image",
          digits);
    case NoticeCode::mirror_symmetric:
      return say(
          "made symmetric, since the hole lies across the plane of symmetry; the surface around is %1 diameters from "
          "its "
          "image",
          digits);
    case NoticeCode::mirror_open: return say("not copied from the mirror image, which has no surface there");
    case NoticeCode::mirror_faulty:
      return say("not copied from the mirror image, which folds there, cuts the surface or does not close the hole");
  }
  return {};
}

}  // namespace

Message message_of(const Notice& notice) { return sentence(notice).with_code(to_string(notice.code)); }

}  // namespace loopmend
