// SPDX-License-Identifier: GPL-3.0-or-later
#include "repair/unite_bodies.h"

#include "mesh/pieces.h"
#include "mesh/self_intersections.h"
#include "mesh/surface_model.h"
#include "repair/divided_faces.h"
#include "repair/exact_union.h"
#include "repair/inside_shell.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <optional>
#include <set>
#include <tuple>
#include <utility>
#include <vector>

namespace loopmend {

namespace {

/// A connected part of the surface.
struct BodyShell {
  std::vector<int> faces;  ///< of the view
  Eigen::AlignedBox3d box;
  double volume = 0;  ///< below 0: of a cavity
  bool is_open = false, crosses_itself = false, crosses_others = false;
  std::vector<int> around;  ///< shells that it lies in
  int body = -1;            ///< the outward shell that it is, or that it is a cavity of; −1: neither

  bool is_sound() const { return !is_open && !crosses_itself; }
  bool is_body() const { return is_sound() && volume > 0; }
};

using ShellPair = std::pair<int, int>;

class Bodies {
 public:
  Bodies(const SurfaceModel& model, const CancelToken& cancel) : model_(model) {
    find_shells();
    find_crossings(cancel);
    find_overlaps_at_common_places();
    if (cancel.cancelled()) return;
    find_nesting();
    find_bodies();
  }

  /// Bodies to be united, by the numbers of their shells, each once.
  std::set<ShellPair> pairs() const {
    std::set<ShellPair> result;
    const auto add = [&](int a, int b) {
      if (a != b && is_sound_body(a) && is_sound_body(b)) result.insert(std::minmax(a, b));
    };
    for (const auto& [a, b] : crossings_) add(shells_[a].body, shells_[b].body);
    for (std::size_t s = 0; s < shells_.size(); ++s) {
      const BodyShell& shell = shells_[s];
      int winding = 0;
      for (int outer : shell.around) winding += shells_[outer].volume > 0 ? 1 : -1;
      if (shell.is_body() && winding > 0) add(innermost(shell, Among::bodies), static_cast<int>(s));
    }
    return result;
  }

  /// View faces of a body with its cavities.
  std::vector<int> faces_of(int body) const {
    std::vector<int> faces;
    for (const BodyShell& shell : shells_)
      if (shell.body == body) faces.insert(faces.end(), shell.faces.begin(), shell.faces.end());
    std::sort(faces.begin(), faces.end());
    return faces;
  }

  void count_left(UnionCounts& counts) const {
    for (const BodyShell& shell : shells_) {
      if (!shell.crosses_others) continue;
      if (shell.is_open)
        ++counts.open_pieces;
      else if (!is_sound_body(shell.body))
        ++counts.crossing;
    }
  }

 private:
  void find_shells() {
    const std::vector<int> lowest = pieces_of(model_.mesh);
    std::map<int, int> number;
    shell_of_.assign(model_.soup.triangles.size(), -1);
    for (std::size_t f = 0; f < lowest.size(); ++f) {
      const auto [entry, is_new] = number.try_emplace(lowest[f], static_cast<int>(shells_.size()));
      if (is_new) shells_.emplace_back();
      BodyShell& shell = shells_[entry->second];
      shell.faces.push_back(static_cast<int>(f));
      shell_of_[model_.soup_face[f]] = entry->second;
      for (const Vec3& p : corners(static_cast<int>(f))) shell.box.extend(p);
    }
    for (const auto h : model_.mesh.halfedges())
      if (model_.mesh.is_boundary(h)) {
        const int face = model_.mesh.face_handle(model_.mesh.opposite_halfedge_handle(h)).idx();
        shells_[shell_of_[model_.soup_face[face]]].is_open = true;
      }
    for (BodyShell& shell : shells_)
      for (int f : shell.faces) {
        const auto [a, b, c] = corners(f);
        const Vec3 origin = shell.box.center();  // so that far from the origin no digits are lost
        shell.volume += (a - origin).dot((b - origin).cross(c - origin)) / 6;
      }
  }

  std::array<Vec3, 3> corners(int view_face) const {
    const Triangle& t = model_.soup.triangles[model_.soup_face[view_face]];
    return {model_.soup.points[t[0]], model_.soup.points[t[1]], model_.soup.points[t[2]]};
  }

  void find_crossings(const CancelToken& cancel) {
    const auto count = static_cast<int>(model_.soup.triangles.size());
    for (const auto& [f, g] : self_intersections(model_.soup.points, model_.soup.triangles, count, cancel)) {
      const int a = shell_of_[f], b = shell_of_[g];
      if (a < 0 || b < 0) continue;
      if (a == b) {
        shells_[a].crosses_itself = true;
        continue;
      }
      shells_[a].crosses_others = shells_[b].crosses_others = true;
      crossings_.insert(std::minmax(a, b));
    }
  }

  /// Whether the inner shell, which does not cross the other, lies within it.
  bool lies_in(const BodyShell& inner, const InsideShell& outer) const {
    for (int f : inner.faces)
      for (const Vec3& p : corners(f)) {
        const InsideShell::Place place = outer.of(p);
        if (place != InsideShell::Place::on_surface) return place == InsideShell::Place::inside;
      }
    return false;
  }

  /// Where meshes fit along the curve in which bodies cross, no two faces cross; the middle of some face there lies within.
  void find_overlaps_at_common_places() {
    struct Corner {
      std::array<double, 3> place;
      int shell, face;
    };
    std::vector<Corner> found;
    if (shells_.size() < 2) return;
    for (std::size_t s = 0; s < shells_.size(); ++s)
      for (int f : shells_[s].faces)
        for (const Vec3& p : corners(f))
          if (shells_[s].is_sound()) found.push_back({{p.x(), p.y(), p.z()}, static_cast<int>(s), f});
    std::sort(found.begin(), found.end(), [](const Corner& a, const Corner& b) {
      return std::tie(a.place, a.shell, a.face) < std::tie(b.place, b.shell, b.face);
    });
    std::map<ShellPair, std::set<int>>
        faces_at;  // of the first shell of a pair, near the second, and the other way round
    for (std::size_t first = 0, last = 0; first < found.size(); first = last) {
      while (last < found.size() && found[last].place == found[first].place) ++last;
      if (found[first].shell == found[last - 1].shell) continue;
      for (std::size_t a = first; a < last; ++a)
        for (std::size_t b = first; b < last; ++b)
          if (found[a].shell != found[b].shell && !crossings_.contains(std::minmax(found[a].shell, found[b].shell)))
            faces_at[{found[a].shell, found[b].shell}].insert(found[a].face);
    }
    for (const auto& [pair, own] : faces_at) {
      const InsideShell other(corners_of(shells_[pair.second]));
      const bool overlap = std::any_of(own.begin(), own.end(), [&](int f) {
        const auto [a, b, c] = corners(f);
        return other.of((a + b + c) / 3) == InsideShell::Place::inside;
      });
      // A shell that lies within another has its middles there, too: one of them has a face outside.
      if (!overlap || shells_[pair.second].box.contains(shells_[pair.first].box)) continue;
      shells_[pair.first].crosses_others = shells_[pair.second].crosses_others = true;
      crossings_.insert(std::minmax(pair.first, pair.second));
    }
  }

  /// Three after another.
  Points corners_of(const BodyShell& shell) const {
    Points all;
    for (int f : shell.faces)
      for (const Vec3& p : corners(f)) all.push_back(p);
    return all;
  }

  void find_nesting() {
    for (std::size_t outer = 0; outer < shells_.size(); ++outer) {
      if (!shells_[outer].is_sound()) continue;
      std::optional<InsideShell> inside;
      for (std::size_t inner = 0; inner < shells_.size(); ++inner) {
        if (inner == outer || !shells_[inner].is_sound() || !shells_[outer].box.contains(shells_[inner].box)) continue;
        const ShellPair pair = std::minmax(static_cast<int>(inner), static_cast<int>(outer));
        if (crossings_.contains(pair)) continue;
        if (!inside) inside.emplace(corners_of(shells_[outer]));
        if (lies_in(shells_[inner], *inside)) shells_[inner].around.push_back(static_cast<int>(outer));
      }
    }
  }

  enum class Among { all, bodies };
  /// Of the shells around a shell the one that encloses the least; −1: none.
  int innermost(const BodyShell& shell, Among among) const {
    int best = -1;
    for (int outer : shell.around) {
      if (among == Among::bodies && !shells_[outer].is_body()) continue;
      if (best < 0 || std::abs(shells_[outer].volume) < std::abs(shells_[best].volume)) best = outer;
    }
    return best;
  }

  void find_bodies() {
    for (std::size_t s = 0; s < shells_.size(); ++s) {
      BodyShell& shell = shells_[s];
      if (shell.is_body()) shell.body = static_cast<int>(s);
      if (!shell.is_sound() || shell.is_body()) continue;
      const int host = innermost(shell, Among::all);
      if (host >= 0 && shells_[host].is_body()) shell.body = host;
    }
    for (const auto& [a, b] : crossings_)  // two cavities of one body
      if (shells_[a].body >= 0 && shells_[a].body == shells_[b].body) unsound_.insert(shells_[a].body);
  }

  bool is_sound_body(int body) const { return body >= 0 && !unsound_.contains(body); }

  const SurfaceModel& model_;
  std::vector<BodyShell> shells_;
  std::vector<int> shell_of_;      ///< of each soup triangle; −1: no part of the surface
  std::set<ShellPair> crossings_;  ///< shells that cross or touch each other
  std::set<int> unsound_;          ///< bodies whose cavities cross
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

  /// @param soup_faces  of the bodies
  void take(const std::vector<int>& soup_faces, const ExactUnion& united) {
    for (int f : soup_faces) is_united_[f] = 1;
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
  const SurfaceModel model = make_surface_model(soup);
  const Bodies bodies(model, cancel);
  if (cancel.cancelled()) return result;
  bodies.count_left(result.counts);
  std::map<int, int> number;  // of those that are to be united
  std::vector<std::vector<int>> faces;
  std::vector<ShellPair> pairs;
  const auto number_of = [&](int body) {
    const auto [entry, is_new] = number.try_emplace(body, static_cast<int>(faces.size()));
    if (is_new) faces.push_back(bodies.faces_of(body));
    return entry->second;
  };
  for (const auto& [a, b] : bodies.pairs()) {
    const int first = number_of(a), second = number_of(b);
    pairs.emplace_back(first, second);
  }
  const ExactUnions unions = unite_exactly(model, faces, pairs, cancel);
  if (cancel.cancelled()) return {soup, {}};
  result.counts.touching = unions.only_touching.size();
  result.counts.refused = unions.refused.size();
  result.counts.made = unions.made.size();
  if (unions.made.empty()) return result;
  UnitedSoup united(model.soup);
  for (const ExactUnion& one : unions.made) {
    result.counts.bodies += one.bodies.size();
    std::vector<int> soup_faces;
    for (int body : one.bodies)
      for (int f : faces[body]) soup_faces.push_back(model.soup_face[f]);
    united.take(soup_faces, one);
  }
  result.soup = united.result(result.counts);
  Triangles parts_first = result.soup.triangles;
  const auto parts = static_cast<int>(result.counts.new_faces);
  std::rotate(parts_first.begin(), parts_first.end() - parts, parts_first.end());
  result.counts.crossing_parts = self_intersections(result.soup.points, parts_first, parts, cancel).size();
  if (cancel.cancelled()) return {soup, {}};
  return result;
}

}  // namespace loopmend
