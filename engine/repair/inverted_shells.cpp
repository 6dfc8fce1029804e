// SPDX-License-Identifier: GPL-3.0-or-later
#include "repair/inverted_shells.h"

#include "repair/shells.h"

#include <algorithm>

namespace loopmend {

namespace {

/// For each shell whether it is inside out. What lies in an open one that is, stays as it is with that.
std::vector<char> inverted(const std::vector<Shell>& shells) {
  std::vector<char> result(shells.size(), 0);
  const auto is_body = [&](std::size_t s) { return shells[s].around.size() % 2 == 0; };
  for (std::size_t s = 0; s < shells.size(); ++s) result[s] = is_body(s) && shells[s].volume < 0;
  for (std::size_t s = 0; s < shells.size(); ++s) {
    if (is_body(s)) continue;
    const std::vector<int>& around = shells[s].around;
    const int body = *std::max_element(around.begin(), around.end(),
                                       [&](int a, int b) { return shells[a].around.size() < shells[b].around.size(); });
    result[s] = result[body] && shells[s].volume > 0;
  }
  const std::vector<char> alone = result;
  for (std::size_t s = 0; s < shells.size(); ++s)
    if (std::any_of(shells[s].around.begin(), shells[s].around.end(),
                    [&](int outer) { return alone[outer] && !shells[outer].is_nearly_closed(); }))
      result[s] = 0;
  return result;
}

/// Whether an open shell may be the inner wall of another one that is as open, as of a hollow print.
bool may_be_an_inner_wall(const std::vector<Shell>& shells, const Shell& shell) {
  constexpr double wider = 0.05;  // in diagonals of the outer one: both end at the same height
  return std::any_of(shells.begin(), shells.end(), [&](const Shell& outer) {
    if (&outer == &shell || !(outer.volume > -shell.volume)) return false;
    const Vec3 margin = Vec3::Constant(wider * outer.box.diagonal().norm());
    return Eigen::AlignedBox3d(outer.box.min() - margin, outer.box.max() + margin).contains(shell.box);
  });
}

}  // namespace

InvertedShells find_inverted_shells(const SurfaceModel& model, const std::vector<BoundaryLoop>& loops) {
  InvertedShells result;
  Shells found = find_shells(model, loops);
  std::vector<Shell>& shells = found.all;
  const auto may_be_inverted = [](const Shell& shell) { return shell.is_certain() && shell.volume < 0; };
  if (std::none_of(shells.begin(), shells.end(), may_be_inverted)) return result;
  std::vector<Eigen::AlignedBox3d> of_others;  // that may be bodies or not
  for (const Shell& shell : shells)
    if (!shell.is_certain()) of_others.push_back(shell.box);
  list_faces(model, found);
  std::erase_if(shells, [](const Shell& shell) { return !shell.is_certain(); });
  find_nesting(model, shells);
  const std::vector<char> is_inverted = inverted(shells);
  for (std::size_t s = 0; s < shells.size(); ++s) {
    const bool may_be_a_cavity = std::any_of(of_others.begin(), of_others.end(), [&](const Eigen::AlignedBox3d& box) {
      return box.contains(shells[s].box);
    });
    if (!is_inverted[s] || may_be_a_cavity) continue;
    if (!shells[s].is_nearly_closed() && may_be_an_inner_wall(shells, shells[s])) continue;
    ++(shells[s].is_nearly_closed() ? result.closed : result.open);
    if (!shells[s].is_nearly_closed()) continue;
    result.faces.resize(model.soup.triangles.size(), 0);
    result.face_count += shells[s].faces.size();
    for (int f : shells[s].faces) result.faces[f] = 1;
  }
  return result;
}

}  // namespace loopmend
