// SPDX-License-Identifier: GPL-3.0-or-later
#include "repair/inverted_shells.h"

#include "repair/shells.h"

#include <algorithm>
#include <numeric>
#include <optional>
#include <ranges>

namespace loopmend {

namespace {

/// The space directly within a shell, once those that are inside out are turned.
enum class Within { solid, cavity };

/// The shell that another one is directly in; -1: it is in none; nothing where it is in several that cross.
std::optional<int> shell_around(const std::vector<Shell>& shells, std::size_t s) {
  int innermost = -1, equals = 0;
  for (int a : shells[s].around) {
    const std::size_t depth = shells[a].around.size(), best = innermost < 0 ? 0 : shells[innermost].around.size();
    if (innermost >= 0 && depth < best) continue;
    equals = innermost >= 0 && depth == best ? equals + 1 : 1;
    innermost = a;
  }
  return equals > 1 ? std::nullopt : std::optional(innermost);
}

/// For each shell whether it is inside out.
std::vector<char> inverted(const std::vector<Shell>& shells) {
  std::vector<int> outer_first(shells.size());
  std::iota(outer_first.begin(), outer_first.end(), 0);
  std::ranges::stable_sort(outer_first, {}, [&](int s) { return shells[s].around.size(); });
  std::vector<char> result(shells.size(), 0);
  std::vector<Within> within(shells.size());
  for (int s : outer_first) {
    const std::optional<int> around = shell_around(shells, s);
    const bool looks_inward = shells[s].volume < 0;
    const int outer = around.value_or(-1);
    if (!around) {
      within[s] = looks_inward ? Within::cavity : Within::solid;
    } else if (outer < 0 || within[outer] == Within::cavity) {
      result[s] = looks_inward;
      within[s] = Within::solid;
    } else {  // in the material of another body: a cavity in it, or where that body is as it should be, a part of it
      result[s] = result[outer] && !looks_inward;
      within[s] = looks_inward || result[s] ? Within::cavity : Within::solid;
    }
  }
  return result;
}

/// A body with openings that lies in no other is not closed if it is the only one: it may be a room that was scanned from within.
void open_a_lone_room(std::vector<Shell>& shells) {
  const auto is_outer = [](const Shell& shell) { return shell.around.empty(); };
  if (std::ranges::count_if(shells, is_outer) != 1) return;
  Shell& only = *std::ranges::find_if(shells, is_outer);
  only.may_be_a_room = only.has_opening;
}

/// What lies in an open one that is inside out stays as it is with that.
void leave_what_lies_in_open_ones(const std::vector<Shell>& shells, std::vector<char>& result) {
  const std::vector<char> alone = result;
  for (std::size_t s = 0; s < shells.size(); ++s)
    if (std::any_of(shells[s].around.begin(), shells[s].around.end(),
                    [&](int outer) { return alone[outer] && !shells[outer].is_nearly_closed(); }))
      result[s] = 0;
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

/// Shells whose outer side is known, with the data that judging them needs.
struct KnownShells {
  std::vector<Shell> all;
  std::vector<Eigen::AlignedBox3d> of_others;  ///< that may be bodies or not

  /// Those that may be cavities or inner walls of others are taken as they are, and so are cavities that look outward in them.
  void leave_what_is_not_known(std::vector<char>& inside_out) const {
    for (std::size_t s = 0; s < all.size(); ++s) {
      const bool may_be_a_cavity = std::any_of(
          of_others.begin(), of_others.end(), [&](const Eigen::AlignedBox3d& box) { return box.contains(all[s].box); });
      if (may_be_a_cavity || (!all[s].is_nearly_closed() && may_be_an_inner_wall(all, all[s]))) inside_out[s] = 0;
    }
    for (std::size_t s = 0; s < all.size(); ++s)
      if (all[s].volume > 0 && inside_out[s]) inside_out[s] = inside_out[shell_around(all, s).value()];
  }
};

/// Empty where no shell looks inward.
KnownShells known_shells(const SurfaceModel& model, const std::vector<BoundaryLoop>& loops) {
  KnownShells known;
  Shells found = find_shells(model, loops);
  const auto may_be_inverted = [](const Shell& shell) { return shell.is_certain() && shell.volume < 0; };
  if (std::none_of(found.all.begin(), found.all.end(), may_be_inverted)) return known;
  for (const Shell& shell : found.all)
    if (!shell.is_certain()) known.of_others.push_back(shell.box);
  list_faces(model, found);
  known.all = std::move(found.all);
  std::erase_if(known.all, [](const Shell& shell) { return !shell.is_certain(); });
  find_nesting(model, known.all);
  open_a_lone_room(known.all);
  return known;
}

}  // namespace

InvertedShells find_inverted_shells(const SurfaceModel& model, const std::vector<BoundaryLoop>& loops) {
  InvertedShells result;
  const KnownShells known = known_shells(model, loops);
  std::vector<char> inside_out = inverted(known.all);
  leave_what_lies_in_open_ones(known.all, inside_out);
  known.leave_what_is_not_known(inside_out);
  for (std::size_t s = 0; s < known.all.size(); ++s) {
    const Shell& shell = known.all[s];
    if (!inside_out[s]) continue;
    ++(shell.is_nearly_closed() ? result.closed : result.open);
    if (!shell.is_nearly_closed()) continue;
    result.faces.resize(model.soup.triangles.size(), 0);
    result.face_count += shell.faces.size();
    for (int f : shell.faces) result.faces[f] = 1;
  }
  return result;
}

std::vector<char> faces_inside_out(const SurfaceModel& model, const std::vector<BoundaryLoop>& loops) {
  const KnownShells known = known_shells(model, loops);
  std::vector<char> inside_out = inverted(known.all), faces;
  known.leave_what_is_not_known(inside_out);
  for (std::size_t s = 0; s < known.all.size(); ++s) {
    if (!inside_out[s]) continue;
    faces.resize(model.soup.triangles.size(), 0);
    for (int f : known.all[s].faces) faces[f] = 1;
  }
  return faces;
}

}  // namespace loopmend
