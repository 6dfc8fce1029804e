// SPDX-License-Identifier: GPL-3.0-or-later
#include "edges/sides.h"

#include "core/quantile.h"
#include "mesh/quality.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <numeric>
#include <set>

namespace loopmend {

namespace {

constexpr double sharp_medians = 4;
/// Median bend from which noise alone may bend single edges as a sharp one.
constexpr double noisy_deg = 4;
/// Of the median bend the filter leaves 0.03 to 0.07 where it is noise: on cubes and cylinders with standard deviations of 12 to
/// 25 % of an edge.
constexpr double most_filtered = 0.2;
constexpr double flat_deg =
    0.1;  ///< an edge that bends by less is a diagonal of a plane facet, and lies off a curved surface
constexpr int small_group = 6;  ///< faces: such a group is noise, unless its faces are large
constexpr std::size_t most_sides = 8;
constexpr double least_coverage = 0.9;  ///< share of the loop's edges that belong to sides
constexpr double drawn_loop_price = 100, drawn_edge_deg = 5;
constexpr double steep = 0.45;  ///< cosine: faces that lean farther from their side's normal are left out of its fit
constexpr double one_surface =
    1.3;                        ///< two sides are one where the common fit is no worse than so many times their own
constexpr double exact = 1e-5;  ///< diameters: below that, fits are exact

struct FaceGroups {
  Triangles triangles;
  std::vector<Vec3> normals;  ///< unit, by triangle
  std::vector<double> areas;
  std::vector<int> group;  ///< by triangle
  std::vector<Bend> bent;  ///< edges between triangles that are not in one plane
  bool is_noisy = false;
  bool any_sharp = false;  ///< edges at which groups are parted
};

double angle_deg(double cosine) { return std::acos(std::clamp(cosine, -1.0, 1.0)) * 180 / std::numbers::pi; }
double angle_deg(const Bend& bend) { return angle_deg(bend.cosine); }

/// Triangles of the neighborhood with all corners within `reach` of the loop.
Triangles triangles_near(const Patch& patch, const std::vector<int>& loop, double reach) {
  std::vector<char> is_near(patch.vertex_count(), 0);
  for (int v = patch.free_count; v < patch.vertex_count(); ++v)
    is_near[v] = std::any_of(loop.begin(), loop.end(), [&](int w) {
      return (patch.positions[v] - patch.positions[w]).squaredNorm() < reach * reach;
    });
  Triangles near;
  for (std::size_t f = patch.patch_triangles; f < patch.triangles.size(); ++f) {
    const Triangle& t = patch.triangles[f];
    if (is_near[t[0]] && is_near[t[1]] && is_near[t[2]]) near.push_back(t);
  }
  return near;
}

int root_of(std::vector<int>& parent, int f) {
  while (parent[f] != f) f = parent[f] = parent[parent[f]];
  return f;
}

/// Small groups join the neighbor to which they bend least, weighted by the length of the common edges.
void join_small_groups(const Patch& patch, const std::vector<Bend>& edges, FaceGroups& groups) {
  const double mean_area =
      std::accumulate(groups.areas.begin(), groups.areas.end(), 0.0) / static_cast<double>(groups.areas.size());
  for (int round = 0; round < 3; ++round) {
    std::map<int, std::pair<int, double>> size;  // faces, area
    for (std::size_t f = 0; f < groups.group.size(); ++f) {
      ++size[groups.group[f]].first;
      size[groups.group[f]].second += groups.areas[f];
    }
    std::map<int, std::map<int, double>> beside;
    for (const Bend& edge : edges) {
      const int a = groups.group[edge.face], b = groups.group[edge.other];
      if (a == b) continue;
      const double weight = (patch.positions[edge.low] - patch.positions[edge.high]).norm() / (5 + angle_deg(edge));
      beside[a][b] += weight;
      beside[b][a] += weight;
    }
    std::map<int, int> joins;
    for (const auto& [group, extent] : size) {
      if (extent.first >= small_group || extent.second >= small_group * mean_area || beside[group].empty()) continue;
      const auto& neighbors = beside[group];
      joins[group] = std::max_element(neighbors.begin(), neighbors.end(), [](const auto& a, const auto& b) {
                       return a.second < b.second;
                     })->first;
    }
    if (joins.empty()) break;
    for (int& g : groups.group)
      for (int hops = 0; hops < 2; ++hops)
        if (const auto found = joins.find(g); found != joins.end() && (hops == 0 || found->second < g))
          g = found->second;
  }
}

/// Normals without noise. Each becomes the weighted mean of itself and of the normals across its edges, 20 times; normals that
/// differ by more than 60° have no weight (Sun, Rosin, Martin, Langbein 2007).
std::vector<Vec3> filtered_normals(const FaceGroups& groups, const std::vector<Bend>& edges) {
  constexpr int rounds = 20;
  constexpr double least_cosine = 0.5;
  std::vector<Vec3> normals = groups.normals;
  for (int round = 0; round < rounds; ++round) {
    std::vector<Vec3> sums;
    for (std::size_t f = 0; f < normals.size(); ++f)
      sums.emplace_back(groups.areas[f] * std::pow(1 - least_cosine, 2) * normals[f]);
    for (const Bend& edge : edges) {
      const double weight = std::pow(std::max(0.0, normals[edge.face].dot(normals[edge.other]) - least_cosine), 2);
      sums[edge.face] += weight * groups.areas[edge.other] * normals[edge.other];
      sums[edge.other] += weight * groups.areas[edge.face] * normals[edge.face];
    }
    for (std::size_t f = 0; f < normals.size(); ++f)
      if (sums[f].norm() > 0) normals[f] = sums[f].normalized();
  }
  return normals;
}

FaceGroups group_faces(const Patch& patch, Triangles triangles) {
  FaceGroups groups;
  groups.triangles = std::move(triangles);
  for (const Triangle& t : groups.triangles) {
    const Vec3 &a = patch.positions[t[0]], &b = patch.positions[t[1]], &c = patch.positions[t[2]];
    groups.normals.push_back(unit_normal(a, b, c));
    groups.areas.push_back((b - a).cross(c - a).norm() / 2);
  }
  const std::vector<Bend> edges = bends(patch.positions, groups.triangles, static_cast<int>(groups.triangles.size()));
  std::vector<double> angles;
  for (const Bend& edge : edges) angles.push_back(angle_deg(edge));
  if (median(angles) > noisy_deg) {
    const std::vector<Vec3> normals = filtered_normals(groups, edges);
    std::vector<double> filtered;
    for (const Bend& edge : edges) filtered.push_back(angle_deg(normals[edge.face].dot(normals[edge.other])));
    groups.is_noisy = median(filtered) < most_filtered * median(angles);
    if (groups.is_noisy) angles = std::move(filtered);
  }
  const double limit = std::max(sharp_edge_deg, sharp_medians * median(angles));
  std::vector<int> parent(groups.triangles.size());
  std::iota(parent.begin(), parent.end(), 0);
  groups.any_sharp = std::ranges::any_of(angles, [&](double angle) { return angle > limit; });
  for (std::size_t e = 0; e < edges.size(); ++e)
    if (angles[e] <= limit) {
      const int a = root_of(parent, edges[e].face), b = root_of(parent, edges[e].other);
      parent[std::max(a, b)] = std::min(a, b);
    }
  for (int f = 0; f < static_cast<int>(parent.size()); ++f) groups.group.push_back(root_of(parent, f));
  join_small_groups(patch, edges, groups);
  for (std::size_t e = 0; e < edges.size(); ++e)
    if (angle_deg(edges[e]) > flat_deg) groups.bent.push_back(edges[e]);
  return groups;
}

/// Of each loop edge, on which hand of the drawn lines it lies: equal numbers, the same.
std::vector<int> hands_of(std::size_t edges, const std::vector<std::pair<int, int>>& drawn) {
  std::map<std::vector<bool>, int> known;
  std::vector<int> hands;
  for (int e = 0; e < static_cast<int>(edges); ++e) {
    std::vector<bool> between;
    for (const auto& [a, b] : drawn) between.push_back(e >= std::min(a, b) && e < std::max(a, b));
    hands.push_back(known.emplace(between, static_cast<int>(known.size())).first->second);
  }
  return hands;
}

/// Parts groups so that each face belongs to the hand of the loop edges that are nearest to it, counted in faces.
void part_by_hand(const std::vector<int>& loop, const std::vector<int>& hands, FaceGroups& groups) {
  std::map<std::pair<int, int>, std::vector<int>> faces_at;
  const auto each_edge = [&](int f, const auto& act) {
    const Triangle& t = groups.triangles[f];
    for (int k = 0; k < 3; ++k) act(std::minmax(t[k], t[(k + 1) % 3]));
  };
  for (int f = 0; f < static_cast<int>(groups.triangles.size()); ++f)
    each_edge(f, [&](const std::pair<int, int>& edge) { faces_at[edge].push_back(f); });
  std::vector<int> hand(groups.triangles.size(), -1), reached;
  const auto take = [&](const std::pair<int, int>& edge, int of) {
    for (int f : faces_at[edge])
      if (hand[f] < 0) {
        hand[f] = of;
        reached.push_back(f);
      }
  };
  for (std::size_t i = 0; i < loop.size(); ++i) take(std::minmax(loop[i], loop[(i + 1) % loop.size()]), hands[i]);
  for (std::size_t next = 0; next < reached.size(); ++next) {
    const int f = reached[next];
    each_edge(f, [&](const std::pair<int, int>& edge) { take(edge, hand[f]); });
  }
  std::map<std::pair<int, int>, int> first;  // faces number groups
  for (int f = 0; f < static_cast<int>(hand.size()); ++f) {
    const std::pair key(groups.group[f], hand[f]);
    groups.group[f] = first.emplace(key, f).first->second;
  }
}

struct Side {
  std::set<int> vertices;
  std::set<std::pair<int, int>> edges;
  Vec3 normal = Vec3::Zero();
  int hand = 0;  ///< of the drawn lines

  /// Those triangles for which `is_in` is 1, and the edges at which they bend.
  void add(const FaceGroups& groups, const std::vector<char>& is_in) {
    for (std::size_t f = 0; f < is_in.size(); ++f)
      if (is_in[f]) vertices.insert(groups.triangles[f].begin(), groups.triangles[f].end());
    for (const Bend& edge : groups.bent)
      if (is_in[edge.face] && is_in[edge.other]) edges.emplace(edge.low, edge.high);
  }
};

Points positions_of(const Patch& patch, const std::set<int>& vertices) {
  Points points;
  for (int v : vertices) points.push_back(patch.positions[v]);
  return points;
}

Points middles_of(const Patch& patch, const std::set<std::pair<int, int>>& edges) {
  Points middles;
  for (const auto& [a, b] : edges) middles.push_back((patch.positions[a] + patch.positions[b]) / 2);
  return middles;
}

std::optional<SideSurface> surface_of(const Patch& patch, const Side& side, double diameter,
                                      SideSurface::Kinds kinds = SideSurface::Kinds::all) {
  return SideSurface::fit(positions_of(patch, side.vertices), side.normal, diameter, kinds,
                          middles_of(patch, side.edges));
}

Side both_of(const Side& a, const Side& b) {
  Side both = a;
  both.vertices.insert(b.vertices.begin(), b.vertices.end());
  both.edges.insert(b.edges.begin(), b.edges.end());
  both.normal = (a.normal + b.normal).normalized();
  return both;
}

/// The vertices of a group, without faces that lean far from it, and its normal near the loop.
Side side_of(const Patch& patch, const FaceGroups& groups, int group) {
  constexpr int near_rings = 4;
  Side side;
  for (const bool near : {true, false}) {
    for (std::size_t f = 0; f < groups.triangles.size(); ++f) {
      const Triangle& t = groups.triangles[f];
      const int ring = std::max({patch.ring[t[0]], patch.ring[t[1]], patch.ring[t[2]]});
      if (groups.group[f] == group && (!near || ring <= near_rings)) side.normal += groups.areas[f] * groups.normals[f];
    }
    if (side.normal.norm() > 0) break;
  }
  side.normal.normalize();
  std::vector<char> is_in;
  for (std::size_t f = 0; f < groups.triangles.size(); ++f)
    is_in.push_back(groups.group[f] == group && groups.normals[f].dot(side.normal) > steep);
  side.add(groups, is_in);
  return side;
}

/// A surface over the sides on both hands of a drawn line, as a quadric can be over a rounded edge, is none of a side.
void keep_apart(const Patch& patch, double diameter, const std::vector<Side>& sides,
                std::vector<SideSurface>& surfaces) {
  std::set<std::size_t> parted;
  for (std::size_t i = 0; i < sides.size(); ++i)
    for (std::size_t j = i + 1; j < sides.size(); ++j) {
      if (sides[i].hand == sides[j].hand) continue;
      const auto surface = surface_of(patch, both_of(sides[i], sides[j]), diameter);
      if (surface && surface->rms() <= one_surface * std::max(surfaces[i].rms(), surfaces[j].rms()) + exact * diameter)
        parted.insert({i, j});
    }
  for (std::size_t i : parted)
    if (const auto surface = surface_of(patch, sides[i], diameter, SideSurface::Kinds::height_fields))
      surfaces[i] = *surface;
}

/// Joins sides whose faces lie on one surface, as those of a plane that the hole cuts in two, and those that `are_one`.
void join_sides(const Patch& patch, double diameter, const auto& are_one, std::vector<Side>& sides,
                std::vector<SideSurface>& surfaces, std::vector<int>& side_of_group) {
  for (std::size_t i = 0; i < sides.size(); ++i)
    for (std::size_t j = i + 1; j < sides.size(); ++j) {
      const bool asked_for = are_one(static_cast<int>(i), static_cast<int>(j));
      if (!asked_for && (sides[i].hand != sides[j].hand || sides[i].normal.dot(sides[j].normal) < steep)) continue;
      const Side both = both_of(sides[i], sides[j]);
      // Two planes are a quadric, too.
      const bool are_planes =
          surfaces[i].kind() == SideSurface::Kind::plane && surfaces[j].kind() == SideSurface::Kind::plane;
      const auto surface =
          surface_of(patch, both, diameter, are_planes ? SideSurface::Kinds::height_fields : SideSurface::Kinds::all);
      if (!surface) continue;
      const double most = one_surface * std::max(surfaces[i].rms(), surfaces[j].rms()) + exact * diameter;
      if (!asked_for && surface->rms() > most) continue;
      sides[i] = both;
      surfaces[i] = *surface;
      sides.erase(sides.begin() + static_cast<long>(j));
      surfaces.erase(surfaces.begin() + static_cast<long>(j));
      for (int& s : side_of_group)
        s = s == static_cast<int>(j) ? static_cast<int>(i) : s > static_cast<int>(j) ? s - 1 : s;
      j = i;  // what the joined side takes in is asked again
    }
}

/// Rms distance of all vertices near the hole from one surface. Where it goes through all of them, as two planes do
/// through a wall of one row and its lids: that of the middles of edges.
std::optional<double> rms_of_one_surface(const Patch& patch, const FaceGroups& groups, const Vec3& normal,
                                         double diameter) {
  Side all;
  all.normal = normal;
  all.add(groups, std::vector<char>(groups.triangles.size(), 1));
  const auto one = surface_of(patch, all, diameter);
  if (!one) return std::nullopt;
  if (one->rms() > exact * diameter || all.edges.empty()) return one->rms();
  double sum = 0;
  for (const Vec3& p : middles_of(patch, all.edges)) sum += (one->foot(p) - p).squaredNorm();
  return std::sqrt(sum / static_cast<double>(all.edges.size()));
}

/// A group of a few faces beside a sharp edge was joined to a neighbor whose surface it is not on. Where the surface of another side goes
/// through the loop edge, and along the face across it, the edge is of that side.
void correct_edges(const Patch& patch, const std::vector<int>& loop, const Points& normals_outside, double diameter,
                   Sides& sides) {
  constexpr double off = 0.02;  // diameters
  for (std::size_t i = 0; i < loop.size(); ++i) {
    int& own = sides.of_edge[i];
    if (own < 0) continue;
    const Vec3 &a = patch.positions[loop[i]], &b = patch.positions[loop[(i + 1) % loop.size()]];
    const auto distance = [&](int s) {
      const SideSurface& surface = sides.surfaces[s];
      return std::max((surface.foot(a) - a).norm(), (surface.foot(b) - b).norm());
    };
    const double least = off * diameter;
    if (distance(own) <= std::max(least, 5 * sides.surfaces[own].rms())) continue;
    for (int other = 0; other < static_cast<int>(sides.surfaces.size()); ++other)
      if (other != own && distance(other) < std::max(least / 4, 2 * sides.surfaces[other].rms()) &&
          std::abs(sides.surfaces[other].normal_at(a).dot(normals_outside[i])) > steep) {
        own = other;
        break;
      }
  }
}

}  // namespace

std::optional<Sides> find_sides(const Patch& patch, std::size_t l, double reach, const SideEdits& edits) {
  const std::vector<int>& loop = patch.loops[l];
  const double diameter = loop_diameter(patch, l);
  Triangles near = triangles_near(patch, loop, reach * diameter);
  if (!(diameter > 0) || near.size() < 3) return std::nullopt;
  FaceGroups groups = group_faces(patch, std::move(near));
  if (!groups.any_sharp && edits.drawn.empty()) return std::nullopt;  // other holes may part what is smooth
  const std::vector<int> hands = hands_of(loop.size(), edits.drawn);
  if (!edits.drawn.empty()) part_by_hand(loop, hands, groups);

  Sides result;
  result.groups = static_cast<int>(std::set<int>(groups.group.begin(), groups.group.end()).size());
  if (result.groups < 2) return std::nullopt;
  std::map<std::pair<int, int>, int> face_at;  // of directed edges
  for (int f = 0; f < static_cast<int>(groups.triangles.size()); ++f)
    for (int k = 0; k < 3; ++k) face_at[{groups.triangles[f][k], groups.triangles[f][(k + 1) % 3]}] = f;
  std::vector<int> numbers, hand_of_number;  // groups at the loop
  Points normals_outside;
  int covered = 0;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const int a = loop[i], b = loop[(i + 1) % loop.size()];
    auto found = face_at.find({b, a});
    if (found == face_at.end()) found = face_at.find({a, b});
    result.of_edge.push_back(-1);
    normals_outside.emplace_back(Vec3::Zero());
    if (found == face_at.end()) continue;
    normals_outside.back() = groups.normals[found->second];
    const int group = groups.group[found->second];
    const auto number = std::find(numbers.begin(), numbers.end(), group);
    result.of_edge.back() = static_cast<int>(number - numbers.begin());
    if (number == numbers.end()) {
      numbers.push_back(group);
      hand_of_number.push_back(hands[i]);
    }
    ++covered;
  }
  if (numbers.empty() || numbers.size() > most_sides || covered < least_coverage * static_cast<double>(loop.size()))
    return std::nullopt;
  if (!edits.drawn.empty()) {  // it begins and ends where a person says, and may be faint
    result.loop_price = drawn_loop_price;
    result.seam_deg = drawn_edge_deg;
  }
  std::vector<Side> sides;
  std::vector<int> side_of_number(numbers.size());
  std::iota(side_of_number.begin(), side_of_number.end(), 0);
  for (std::size_t k = 0; k < numbers.size(); ++k) {
    sides.push_back(side_of(patch, groups, numbers[k]));
    sides.back().hand = hand_of_number[k];
    const auto surface = surface_of(patch, sides.back(), diameter);
    if (!surface) return std::nullopt;
    result.surfaces.push_back(*surface);
  }
  const auto are_one = [&](int s, int t) {
    return std::any_of(edits.joined.begin(), edits.joined.end(), [&](const std::pair<int, int>& edges) {
      const int a = result.of_edge[edges.first], b = result.of_edge[edges.second];
      return a >= 0 && b >= 0 && std::minmax(side_of_number[a], side_of_number[b]) == std::minmax(s, t);
    });
  };
  keep_apart(patch, diameter, sides, result.surfaces);
  join_sides(patch, diameter, are_one, sides, result.surfaces, side_of_number);
  for (int& s : result.of_edge)
    if (s >= 0) s = side_of_number[s];
  if (edits.drawn.empty()) correct_edges(patch, loop, normals_outside, diameter, result);

  double sum = 0, count = 0;
  Vec3 normal = Vec3::Zero();
  for (std::size_t s = 0; s < sides.size(); ++s) {
    const auto n = static_cast<double>(sides[s].vertices.size());
    sum += result.surfaces[s].rms() * result.surfaces[s].rms() * n;
    count += n;
    normal += n * sides[s].normal;
  }
  result.rms = std::sqrt(sum / count);
  result.are_noisy = groups.is_noisy;
  const std::optional<double> rms_of_one = rms_of_one_surface(patch, groups, normal.normalized(), diameter);
  if (!rms_of_one) return std::nullopt;
  result.rms_of_one = *rms_of_one;
  return result;
}

}  // namespace loopmend
