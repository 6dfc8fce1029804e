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

/// Two digits, or all before the point: "0.42", "12", "964".
std::string two_digits(double value) {
  if (std::abs(value) >= 100) return rounded(value);
  char text[32];
  std::snprintf(text, sizeof text, "%.2g", value);
  return text;
}

std::string counted(double count, const char* one, const char* many) {
  return rounded(count) + " " + (std::lround(count) == 1 ? one : many);
}

}  // namespace

const char* to_string(NoticeCode code) {
  switch (code) {
    case NoticeCode::crosses_surface: return "crosses_surface";
    case NoticeCode::nonmanifold_edges: return "nonmanifold_edges";
    case NoticeCode::folded_edges: return "folded_edges";
    case NoticeCode::torn_seam: return "torn_seam";
    case NoticeCode::dome_over_flat_loop: return "dome_over_flat_loop";
    case NoticeCode::bubble: return "bubble";
    case NoticeCode::curvature_torn: return "curvature_torn";
    case NoticeCode::initial_patch_kept: return "initial_patch_kept";
    case NoticeCode::crease: return "crease";
    case NoticeCode::high_over_loop: return "high_over_loop";
    case NoticeCode::likely_far: return "likely_far";
    case NoticeCode::mirror_image: return "mirror_image";
    case NoticeCode::mirror_misfit: return "mirror_misfit";
    case NoticeCode::mirror_no_symmetry: return "mirror_no_symmetry";
    case NoticeCode::mirror_open: return "mirror_open";
    case NoticeCode::mirror_faulty: return "mirror_faulty";
  }
  return "";
}

std::string english(const Notice& notice) {
  const auto number = [&](std::size_t k) { return argument(notice, k); };
  switch (notice.code) {
    case NoticeCode::crosses_surface:
      return "crosses the surface or itself in " + counted(number(0), "place", "places");
    case NoticeCode::nonmanifold_edges: return counted(number(0), "edge has", "edges have") + " more than two faces";
    case NoticeCode::folded_edges: return counted(number(0), "edge is", "edges are") + " folded by more than 150°";
    case NoticeCode::torn_seam:
      return "a crease of " + rounded(number(0)) + "° along " + counted(number(1), "edge", "edges") +
             " of the seam, where the initial patch had " + rounded(number(2)) + "°";
    case NoticeCode::dome_over_flat_loop: return "a dome " + two_digits(number(0)) + " diameters high over a flat loop";
    case NoticeCode::bubble:
      return "a bubble of " + two_digits(number(0)) + " times the area of the initial patch" +
             (number(1) > 0.05 ? ", reaching " + two_digits(number(1)) + " diameters beyond it" : "");
    case NoticeCode::curvature_torn:
      return "mean curvature jumps at the seam by " + two_digits(number(0)) + " / diameter, before the flow by " +
             two_digits(number(1));
    case NoticeCode::initial_patch_kept: return "no flow or fairing gave a sound patch: the initial patch was kept";
    case NoticeCode::crease:
      return "a crease of " + rounded(number(0)) + "° along " + counted(number(1), "edge", "edges") + " of the seam";
    case NoticeCode::high_over_loop:
      return "rises " + two_digits(number(0)) + " diameters over its loop; a ball through the seam would rise " +
             two_digits(number(1));
    case NoticeCode::likely_far:
      return "what was there may lie " + two_digits(number(0)) + " diameters away: the shape is a guess";
    case NoticeCode::mirror_image:
      return "copied from the mirror image, from which the surface around is " + two_digits(number(0)) +
             " diameters away";
    case NoticeCode::mirror_misfit:
      return "not copied from the mirror image, from which the surface around is " + two_digits(number(0)) +
             " diameters away; from a quadric it is " + two_digits(number(1));
    case NoticeCode::mirror_no_symmetry:
      return "not copied from the mirror image, since the scan is not symmetric: its best image is " +
             two_digits(number(0)) + " of its extent away";
    case NoticeCode::mirror_open: return "not copied from the mirror image, which has no surface there";
    case NoticeCode::mirror_faulty:
      return "not copied from the mirror image, which folds there, cuts the surface or does not close the hole";
  }
  return "";
}

}  // namespace loopmend
