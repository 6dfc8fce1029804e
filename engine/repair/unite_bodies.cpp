// SPDX-License-Identifier: GPL-3.0-or-later
#include "repair/unite_bodies.h"

#include "mesh/boundary_loops.h"
#include "mesh/self_intersections.h"
#include "mesh/surface_model.h"
#include "repair/divided_faces.h"
#include "repair/exact_union.h"
#include "repair/inside_shell.h"
#include "repair/shells.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <tuple>
#include <utility>
#include <vector>

namespace loopmend {

namespace {

using ShellPair = std::pair<int, int>;

class Bodies {
 public:
  Bodies(const SurfaceModel& model, const CancelToken& cancel)
      : model_(model),
        found_(find_shells(model, find_boundary_loops(model))),
        crosses_itself_(shells_.size(), 0),
        body_(shells_.size(), -1),
        cover_(shells_.size(), -1) {
    if (!some_boxes_meet(shells_)) return;
    list_faces(model_, found_);
    find_crossings(cancel);
    find_contacts_at_common_places();
    if (cancel.cancelled()) return;
    find_nesting(model_, shells_);
    find_bodies();
    find_covers();
  }

  /// Bodies that overlap or touch, by the numbers of their shells, each pair once.
  std::set<ShellPair> pairs() const {
    std::set<ShellPair> result;
    for (std::size_t s = 0; s < shells_.size(); ++s)
      for (int other : shells_[s].crosses) add_pair(body_[s], body_[other], result);
    return result;
  }

  /// Those that touch at common vertices and edges alone.
  std::set<ShellPair> touching() const {
    std::set<ShellPair> result;
    for (const auto& [a, b] : contacts_) add_pair(body_[a], body_[b], result);
    return result;
  }

  /// Bodies that lie within another one, with the largest of those around them.
  std::vector<ShellPair> covered() const {
    std::vector<ShellPair> result;
    for (std::size_t s = 0; s < cover_.size(); ++s)
      if (cover_[s] >= 0) result.emplace_back(static_cast<int>(s), cover_[s]);
    return result;
  }

  /// Soup triangles of a body with its cavities.
  std::vector<int> faces_of(int body) const {
    std::vector<int> faces;
    for (std::size_t s = 0; s < shells_.size(); ++s)
      if (body_[s] == body) faces.insert(faces.end(), shells_[s].faces.begin(), shells_[s].faces.end());
    std::sort(faces.begin(), faces.end());
    return faces;
  }

  void count_left(UnionCounts& counts) const {
    std::set<int> left;
    for (int s = 0; s < static_cast<int>(shells_.size()); ++s) {
      const Shell& shell = shells_[s];
      int winding = 0;
      for (int outer : shell.around) winding += shells_[outer].volume > 0 ? 1 : -1;
      const bool is_within = winding > 0 && shell.is_certain() && shell.volume > 0;
      if (!is_sound_body(body_[s])) {
        if (is_within || !shell.crosses.empty()) left.insert(s);
      } else if (is_within && cover_[s] < 0) {
        for (int outer : shell.around)
          if (!is_sound_body(body_[outer]) && shells_[outer].is_nearly_closed() && shells_[outer].volume > 0)
            left.insert(outer);
      }
    }
    for (int s : left) ++(shells_[s].is_open ? counts.open_pieces : counts.crossing);
  }

 private:
  void add_pair(int a, int b, std::set<ShellPair>& pairs) const {
    if (a != b && is_sound_body(a) && is_sound_body(b) && cover_[a] < 0 && cover_[b] < 0)
      pairs.insert(std::minmax(a, b));
  }

  void find_crossings(const CancelToken& cancel) {
    const Triangles& triangles = model_.soup.triangles;
    std::vector<int> shell_of(triangles.size(), -1);
    for (std::size_t s = 0; s < shells_.size(); ++s)
      for (int f : shells_[s].faces) shell_of[f] = static_cast<int>(s);
    for (const auto& [f, g] :
         self_intersections(model_.soup.points, triangles, static_cast<int>(triangles.size()), cancel)) {
      const int a = shell_of[f], b = shell_of[g];
      if (a < 0 || b < 0) continue;
      if (a == b)
        crosses_itself_[a] = 1;
      else
        set_crossing(a, b);
    }
  }

  void set_crossing(int a, int b) {
    shells_[a].crosses.insert(b);
    shells_[b].crosses.insert(a);
  }

  /// Where meshes fit along the curve in which bodies cross, no two faces cross; the middles of some faces there lie within the
  /// other one, of both.
  void find_contacts_at_common_places() {
    struct Corner {
      std::array<double, 3> place;
      int shell, face;
    };
    std::vector<Corner> found;
    const Points& points = model_.soup.points;
    const Triangles& triangles = model_.soup.triangles;
    for (std::size_t s = 0; s < shells_.size(); ++s)
      for (int f : shells_[s].faces)
        for (int v : triangles[f])
          if (is_sound(s)) found.push_back({{points[v].x(), points[v].y(), points[v].z()}, static_cast<int>(s), f});
    std::sort(found.begin(), found.end(), [](const Corner& a, const Corner& b) {
      return std::tie(a.place, a.shell, a.face) < std::tie(b.place, b.shell, b.face);
    });
    std::map<ShellPair, std::set<int>> faces_near;  // the first shell, of the second
    for (std::size_t first = 0, last = 0; first < found.size(); first = last) {
      while (last < found.size() && found[last].place == found[first].place) ++last;
      if (found[first].shell == found[last - 1].shell) continue;
      for (std::size_t a = first; a < last; ++a)
        for (std::size_t b = first; b < last; ++b)
          if (found[a].shell != found[b].shell && !shells_[found[a].shell].crosses.contains(found[b].shell))
            faces_near[{found[a].shell, found[b].shell}].insert(found[b].face);
    }
    std::optional<InsideShell> inside;
    int last = -1;
    std::set<ShellPair> reaching;  // the first shell has faces within it, of the second
    for (const auto& [pair, near] : faces_near) {
      if (std::exchange(last, pair.first) != pair.first) inside.emplace(corners_of(model_, shells_[pair.first]));
      if (std::any_of(near.begin(), near.end(), [&](int f) {
            const Triangle& t = triangles[f];
            return inside->of((points[t[0]] + points[t[1]] + points[t[2]]) / 3) == InsideShell::Place::inside;
          }))
        reaching.insert(pair);
    }
    for (const auto& [pair, near] : faces_near) {
      const bool reaches = reaching.contains(pair), is_reached = reaching.contains({pair.second, pair.first});
      if (reaches && is_reached) set_crossing(pair.first, pair.second);
      if (!reaches && !is_reached) contacts_.insert(pair);
    }
  }

  void find_bodies() {
    for (std::size_t s = 0; s < shells_.size(); ++s) {
      if (!is_sound(s)) continue;
      const std::vector<int>& around = shells_[s].around;
      if (shells_[s].volume > 0) {
        body_[s] = static_cast<int>(s);
      } else if (!around.empty()) {
        const int host = *std::min_element(around.begin(), around.end(), [&](int a, int b) {
          return std::abs(shells_[a].volume) < std::abs(shells_[b].volume);
        });
        if (is_sound(host) && shells_[host].volume > 0) body_[s] = host;
      }
    }
    for (std::size_t s = 0; s < shells_.size(); ++s)  // two cavities of one body
      for (int other : shells_[s].crosses)
        if (body_[s] >= 0 && body_[s] == body_[other]) unsound_.insert(body_[s]);
  }

  /// A body lies within another one where that is around it, and none of the other's cavities is, or crosses it.
  void find_covers() {
    for (std::size_t s = 0; s < shells_.size(); ++s) {
      if (body_[s] != static_cast<int>(s) || !is_sound_body(body_[s])) continue;
      std::set<int> hollow;  // bodies that have such cavities
      const auto add_cavity = [&](int k) {
        if (body_[k] != k) hollow.insert(body_[k]);
      };
      std::for_each(shells_[s].around.begin(), shells_[s].around.end(), add_cavity);
      std::for_each(shells_[s].crosses.begin(), shells_[s].crosses.end(), add_cavity);
      int& cover = cover_[s];
      for (int outer : shells_[s].around)
        if (body_[outer] == outer && is_sound_body(outer) && !hollow.contains(outer) &&
            (cover < 0 || shells_[outer].volume > shells_[cover].volume))
          cover = outer;
    }
  }

  bool is_sound(std::size_t s) const { return !shells_[s].is_open && !crosses_itself_[s] && shells_[s].is_certain(); }
  bool is_sound_body(int body) const { return body >= 0 && !unsound_.contains(body); }

  const SurfaceModel& model_;
  Shells found_;
  std::vector<Shell>& shells_ = found_.all;
  std::vector<char> crosses_itself_;
  std::set<ShellPair> contacts_;  ///< shells that touch at common vertices and edges alone
  std::vector<int> body_;   ///< of each shell the outward one that it is, or that it is a cavity of; −1: neither
  std::set<int> unsound_;   ///< bodies whose cavities cross
  std::vector<int> cover_;  ///< of each body the largest that it lies within; −1: none
};

/// Makes the soup of what stays and of the unions.
class UnitedSoup {
 public:
  explicit UnitedSoup(const TriangleSoup& soup)
      : soup_(soup),
        parts_(soup.triangles.size()),
        is_united_(parts_.size(), 0) {
    made_.points = soup.points;
  }

  /// Only parts of these that a union brings stay.
  void take(const std::vector<int>& soup_faces) {
    for (int f : soup_faces) is_united_[f] = 1;
  }

  void add(const ExactUnion& united) {
    const int first = static_cast<int>(made_.points.size());
    made_.points.insert(made_.points.end(), united.points.begin(), united.points.end());
    divided_.beneath.resize(divided_.beneath.size() + united.points.size(), -1);
    for (const FaceOfUnion& part : united.faces) {
      Triangle t{};
      for (std::size_t k = 0; k < 3; ++k) {
        const int corner = part.corners[k];
        t[k] = corner >= 0 ? corner : first - 1 - corner;
        if (corner < 0) divided_.beneath[static_cast<std::size_t>(t[k]) - soup_.points.size()] = part.face;
      }
      parts_[part.face].push_back(t);
    }
  }

  TriangleSoup result(UnionCounts& counts) {
    Triangles parts;
    for (std::size_t f = 0; f < parts_.size(); ++f) {
      if (!is_united_[f]) {
        keep(f, soup_.triangles[f]);
      } else if (const auto whole = as_whole(f)) {
        keep(f, *whole);
      } else {
        ++counts.removed_faces;
        parts.insert(parts.end(), parts_[f].begin(), parts_[f].end());
        divided_.part_of.insert(divided_.part_of.end(), parts_[f].size(), static_cast<int>(f));
      }
    }
    counts.new_faces = parts.size();
    made_.triangles.insert(made_.triangles.end(), parts.begin(), parts.end());
    copy_divided_rows(soup_, divided_, made_);
    return std::move(made_);
  }

 private:
  void keep(std::size_t face, const Triangle& triangle) {
    made_.triangles.push_back(triangle);
    divided_.kept.push_back(static_cast<int>(face));
  }

  /// The face from its first corner on, where it was not divided. A corner may be a vertex of another body in the same place.
  std::optional<Triangle> as_whole(std::size_t face) const {
    if (parts_[face].size() != 1) return {};
    Triangle part = parts_[face].front();
    for (int turn = 0; turn < 3; ++turn) {
      const auto same = [&](int v, int w) { return made_.points[v] == soup_.points[w]; };
      if (std::equal(part.begin(), part.end(), soup_.triangles[face].begin(), same)) return part;
      std::rotate(part.begin(), part.begin() + 1, part.end());
    }
    return {};
  }

  const TriangleSoup& soup_;
  TriangleSoup made_;
  std::vector<Triangles> parts_;  ///< that are left of each face of the unions
  std::vector<char> is_united_;
  DividedFaces divided_;
};

}  // namespace

UnitedSurface unite_bodies(const TriangleSoup& soup, const CancelToken& cancel) {
  UnitedSurface result{soup, {}};
  UnionCounts& counts = result.counts;
  const SurfaceModel model = make_surface_model(soup);
  const Bodies bodies(model, cancel);
  if (cancel.cancelled()) return result;
  bodies.count_left(counts);
  const std::set<ShellPair> pairs = bodies.pairs();
  std::map<int, std::vector<int>> faces;
  for (const auto& [a, b] : pairs)
    for (int body : {a, b})
      if (!faces.contains(body)) faces[body] = bodies.faces_of(body);
  const ExactUnions unions = unite_exactly(model, faces, pairs, cancel);
  if (cancel.cancelled()) return {soup, {}};
  UnitedSoup united(model.soup);
  std::map<int, int> one_with;  // of each body that is united with others one of these
  for (const ExactUnion& one : unions.made) {
    for (int body : one.bodies) {
      one_with[body] = one.bodies.front();
      united.take(faces[body]);
    }
    united.add(one);
  }
  for (const auto& [body, cover] : bodies.covered()) {
    united.take(bodies.faces_of(body));
    one_with.try_emplace(cover, cover);
    one_with[body] = one_with[cover];
  }
  const auto root = [&](int body) { return one_with.contains(body) ? one_with[body] : body; };
  std::set<ShellPair> touching = unions.only_touching;
  for (const auto& [a, b] : bodies.touching())
    if (root(a) != root(b)) touching.insert(std::minmax(root(a), root(b)));
  std::set<int> made;
  for (const auto& [body, one] : one_with) made.insert(one);
  counts.touching = touching.size();
  counts.refused = unions.refused.size();
  counts.bodies = one_with.size();
  counts.made = made.size();
  if (made.empty()) return result;
  result.soup = united.result(counts);
  Triangles parts_first = result.soup.triangles;
  const auto parts = static_cast<int>(counts.new_faces);
  std::rotate(parts_first.begin(), parts_first.end() - parts, parts_first.end());
  counts.crossing_parts = self_intersections(result.soup.points, parts_first, parts, cancel).size();
  if (cancel.cancelled()) return {soup, {}};
  return result;
}

}  // namespace loopmend
