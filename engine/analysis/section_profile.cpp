// SPDX-License-Identifier: GPL-3.0-or-later
#include "analysis/section_profile.h"

#include "core/error.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

#include <cmath>
#include <map>

namespace loopmend {

namespace {

using Edge = std::pair<int, int>;

/// A point of the cut, on an edge of the mesh.
struct Crossing {
  Vec3 at = Vec3::Zero();  ///< patch frame
  std::array<int, 2> edge = {0, 0};
  double weight = 0;              ///< of the second vertex
  std::vector<std::size_t> next;  ///< neighbours along the cut, at most two
  std::vector<bool> inside;       ///< for each neighbour: does the way there lie in the patch?
};

struct Cut {
  std::vector<Crossing> crossings;
  std::map<Edge, std::size_t> at_edge;
};

struct Plane {
  Vec3 through, normal;
};

Plane plane_across(const Patch& patch, const std::vector<int>& loop, double angle) {
  Vec3 middle = Vec3::Zero();
  for (int v : loop) middle += patch.positions[v];
  middle /= static_cast<double>(loop.size());
  Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
  for (int v : loop) {
    const Vec3 d = patch.positions[v] - middle;
    spread += d * d.transpose();
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(spread);  // by rising spread: the loop's axis comes first
  const Vec3 longest = axes.eigenvectors().col(2), across = axes.eigenvectors().col(1);
  return {middle, -std::sin(angle) * longest + std::cos(angle) * across};
}

std::size_t crossing_on(Cut& cut, const Patch& patch, const std::vector<double>& height, int a, int b) {
  if (a > b) std::swap(a, b);
  const auto [entry, added] = cut.at_edge.emplace(Edge{a, b}, cut.crossings.size());
  if (added) {
    const double t = height[a] / (height[a] - height[b]);
    Crossing crossing;
    crossing.at = (1 - t) * patch.positions[a] + t * patch.positions[b];
    crossing.edge = {a, b};
    crossing.weight = t;
    cut.crossings.push_back(std::move(crossing));
  }
  return entry->second;
}

Cut cut_by(const Patch& patch, const Plane& plane) {
  std::vector<double> height(patch.positions.size());
  for (std::size_t v = 0; v < height.size(); ++v) {
    height[v] = plane.normal.dot(patch.positions[v] - plane.through);
    if (height[v] == 0) height[v] = 1e-14;  // a vertex exactly in the plane counts as above it
  }
  Cut cut;
  for (std::size_t f = 0; f < patch.triangles.size(); ++f) {
    const Triangle& t = patch.triangles[f];
    std::vector<std::size_t> ends;
    for (int k = 0; k < 3; ++k) {
      const int a = t[k], b = t[(k + 1) % 3];
      if ((height[a] > 0) != (height[b] > 0)) ends.push_back(crossing_on(cut, patch, height, a, b));
    }
    if (ends.size() != 2) continue;
    const bool inside = static_cast<int>(f) < patch.patch_triangles;
    for (int k = 0; k < 2; ++k) {
      cut.crossings[ends[k]].next.push_back(ends[1 - k]);
      cut.crossings[ends[k]].inside.push_back(inside);
    }
  }
  return cut;
}

struct Chain {
  std::vector<std::size_t> crossings;
  std::vector<bool> inside;  ///< of the way from each crossing to the following one
  double patch_length = 0;
};

Chain walk(const Cut& cut, std::size_t from, std::vector<bool>& seen) {
  Chain chain;
  std::size_t at = from;
  for (;;) {
    seen[at] = true;
    chain.crossings.push_back(at);
    const Crossing& here = cut.crossings[at];
    std::size_t k = 0;
    while (k < here.next.size() && seen[here.next[k]]) ++k;
    if (k == here.next.size()) return chain;
    chain.inside.push_back(here.inside[k]);
    if (here.inside[k]) chain.patch_length += (cut.crossings[here.next[k]].at - here.at).norm();
    at = here.next[k];
  }
}

Chain longest_through_patch(const Cut& cut) {
  std::vector<bool> seen(cut.crossings.size(), false);
  Chain best;
  const auto try_from = [&](std::size_t c) {
    Chain chain = walk(cut, c, seen);
    if (chain.patch_length > best.patch_length) best = std::move(chain);
  };
  for (std::size_t c = 0; c < cut.crossings.size(); ++c)
    if (!seen[c] && cut.crossings[c].next.size() == 1) try_from(c);
  for (std::size_t c = 0; c < cut.crossings.size(); ++c)
    if (!seen[c]) try_from(c);  // closed cuts
  return best;
}

}  // namespace

SectionProfile section_profile(const Patch& patch, int loop, double angle, std::span<const float> values) {
  if (loop < 0 || loop >= static_cast<int>(patch.loops.size()))
    throw InvalidArgument(say("the patch has no loop %1", loop));
  if (values.size() != patch.positions.size())
    throw InvalidArgument(say("a section needs one value for each vertex of the patch"));
  const Cut cut = cut_by(patch, plane_across(patch, patch.loops[loop], angle));
  const Chain chain = longest_through_patch(cut);
  SectionProfile profile;
  double arc = 0, first_inside = 0, last_inside = 0;
  bool any_inside = false;
  for (std::size_t k = 0; k < chain.crossings.size(); ++k) {
    const Crossing& here = cut.crossings[chain.crossings[k]];
    if (k > 0) arc += patch.scale * (here.at - cut.crossings[chain.crossings[k - 1]].at).norm();
    const bool inside = (k > 0 && chain.inside[k - 1]) || (k < chain.inside.size() && chain.inside[k]);
    if (inside && !std::exchange(any_inside, true)) first_inside = arc;
    if (inside) last_inside = arc;
    profile.arc.push_back(arc);
    profile.value.push_back((1 - here.weight) * values[here.edge[0]] + here.weight * values[here.edge[1]]);
    profile.side.push_back(inside ? SectionProfile::Side::patch : SectionProfile::Side::neighborhood);
    profile.path.push_back(patch.to_mesh(here.at));
    profile.edge.push_back(here.edge);
    profile.weight.push_back(here.weight);
  }
  for (double& s : profile.arc) s -= 0.5 * (first_inside + last_inside);
  return profile;
}

}  // namespace loopmend
