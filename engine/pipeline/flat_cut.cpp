// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/flat_cut.h"

#include "core/quantile.h"
#include "pipeline/wall_profiles.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

namespace loopmend {

namespace {

constexpr int fewest_edges = 4, fewest_round_a_tube = 8;
constexpr double exact_planarity = 0.003;
constexpr double most_planarity = 0.1;  ///< above, the loop's plane says nothing about the wall, but its rulings may:
constexpr double most_planarity_of_a_tube = 0.35, along_rulings = 0.65, most_taper = 0.25;
constexpr double share_of_a_saddle = 0.8, slope_of_a_saddle = 5.66;  ///< of cos 2φ on a cylinder, in planarities: 4 √2
constexpr double steep = 0.5;         ///< sine of the angle between surface and plane, median along the loop
constexpr double still_steep = 0.35;  ///< the same, for all but the share of the loop that may be torn:
/// A loop that is less plane than this may as well be a hole in a steep hill. Chosen on scanned and torn bases of planarity above 0.003
/// (0.91 to 1, but for 0.61 at 0.0032) and holes on top of a bump (0.42 to 0.68).
constexpr double plane_cut = 0.005, steep_if_not_plane = 0.75;
constexpr double upright = 0.9;
/// A prism, as of a machined part, ends there however it turns; the faces next to the equator of a ball lean by half of their angle.
constexpr double exact_plane = 1e-5, exactly_upright = 1 - 1e-8;
/// Teeth of a loop at which an upright wall ends: heights in boundary edges, edges from one turn to the next.
constexpr double lowest_tooth = 0.75, highest_tooth = 4, least_rise = 0.1, tooth_in_noises = 3;
constexpr std::size_t fewest_round_teeth = 24, fewest_teeth = 8, most_edges_of_a_tooth = 6;
constexpr double away_from_corners = 0.25;  ///< quantile: of the fits to a coarse box more than half hold an edge of it
constexpr std::size_t edges_beside = 4;     ///< over which the direction of the wall is taken where there are teeth
/// The same for the faces at all but the torn share of the loop. Of 161 holes of planarity 0.003 to 0.1 cut into natural models the
/// most upright has 0.76; tubes, bottles and stars with noise have 0.86 to 0.97.
constexpr double upright_all_along = 0.85;
constexpr double least_steep_edge = 0.15;
/// Profile curvatures in that of a ball that meets the plane at this angle. A dome: their median is about 1 and most agree.
/// Straighter walls end, sharper ones are rounded edges, and scattered ones tell no dome. Chosen on six bases of scanned statues
/// and on tubes and balls with noise up to 1 % of their size.
constexpr double least_of_a_dome = 0.6, most_of_a_dome = 1.4;
/// A dome beyond doubt: most profiles agree, few are straight, and the faces turn so, too. Of 36 bases of scans none does. Chosen on two
/// blobs with low bumps and a metaball.
constexpr double clear_share = 0.8, clear_quarter = 0.4;
constexpr double least_that_agrees = 0.25, most_that_agrees = 2, agreeing_share = 0.6;
constexpr double most_of_a_straight_wall = 0.3;  ///< half of the least of a dome
/// In diameters: a surface on a quadric goes on with it where that closes so far over the loop. Chosen on ellipsoids and eggs (0.14
/// to 0.39) and a barrel (0.53), which ends. Where it closes farther, up to the second, both may be.
constexpr double highest_dome = 0.45, most_of_a_high_dome = 1;
/// Bend of a wall that may lie on one, in that of a ball: 0.06 to 0.3 on 28 ellipsoids without a tip.
constexpr double least_bend = 0.05;
constexpr std::size_t most_fits = 200;

/// @param shares  curvature of each profile in that of a ball.
bool is_dome(const std::vector<double>& shares, double least_share) {
  if (shares.empty()) return false;
  const double usual = median(shares);
  if (usual < least_of_a_dome || usual > most_of_a_dome) return false;
  const auto agreeing = std::count_if(
      shares.begin(), shares.end(), [](double share) { return share > least_that_agrees && share < most_that_agrees; });
  return static_cast<double>(agreeing) >= least_share * static_cast<double>(shares.size());
}

/// The wall has turned into the loop's plane by a rounded edge, as under a statue.
bool rounds_into_plane(double steepness, const std::vector<double>& shares) {
  return !shares.empty() && steepness > least_steep_edge && steepness < steep &&
         quantile(shares, 0.25) > most_of_a_dome;
}

/// What the surface does along a loop.
struct Wall {
  /// Sine of the angle to the loop's plane, of fits and of the faces at the loop. A window in a wall may have few edges
  /// at the wall and many at the lids.
  std::vector<Weighted> steepness, of_faces;
  std::vector<double> curvatures, noise;  ///< of fits, where there are enough vertices
  double flaring = 0, places = 0;         ///< weights where it leaves the loop away from its center, and of all
  double turning = 0;                     ///< NormalsOfWall::turning()
  double along_rulings = 0;  ///< of a tube; 0 for other walls: Profiles::least_along() of NormalsOfWall::rulings()

  bool is_known() const { return 4 * curvatures.size() >= steepness.size(); }
  bool flares() const { return flaring >= (1 - torn_share) * places; }
};

Wall read_wall(const Profiles& profiles, const BoundaryLoop& loop) {
  Wall wall;
  NormalsOfWall normals;
  const std::size_t stride = 1 + loop.vertices.size() / most_fits;
  for (std::size_t k = 0; k < loop.vertices.size(); k += stride) {
    const Profile profile = profiles.at(k);
    const double weight = profiles.weight_at(k);
    wall.steepness.push_back({profile.steepness, weight});
    if (profile.curvature) {
      wall.curvatures.push_back(*profile.curvature);
      wall.noise.push_back(profile.noise);
    }
    wall.of_faces.push_back({profiles.steepness_of_face(k), weight});
    const Weighted face{profiles.steepness_after(k), profiles.weight_after(k)};
    wall.steepness.push_back(face);
    wall.of_faces.push_back(face);
    wall.places += weight;
    wall.flaring += profiles.flares_at(k) ? weight : 0;
    profiles.add_faces_behind(k, normals);
  }
  wall.turning = normals.turning();
  if (normals.taper() <= most_taper) wall.along_rulings = profiles.least_along(normals.rulings());
  return wall;
}

/// Root mean square height of a loop that goes up and down by whole edges, as where triangles below a plane were removed; 0 for
/// others. Mesh units.
double height_of_teeth(const std::vector<double>& heights, double mean_edge) {
  const std::size_t n = heights.size();
  const auto [low, high] = std::ranges::minmax(heights);
  if (n < fewest_round_teeth || high - low < lowest_tooth * mean_edge || high - low > highest_tooth * mean_edge)
    return 0;
  std::size_t turns = 0;
  double mean = 0, squares = 0;
  int direction = 0;
  for (std::size_t k = 0; k < n; ++k) {
    mean += heights[k] / static_cast<double>(n);
    const double rise = heights[(k + 1) % n] - heights[k];
    if (std::abs(rise) < least_rise * mean_edge) continue;
    const int now = rise > 0 ? 1 : -1;
    turns += now == -direction ? 1 : 0;
    direction = now;
  }
  if (turns < 2 * fewest_teeth || turns * most_edges_of_a_tooth < n) return 0;
  for (const double height : heights) squares += (height - mean) * (height - mean);
  return std::sqrt(squares / static_cast<double>(n));
}

/// The same with conormals of the loop as it would run without its teeth.
LoopFacing without_teeth(const SurfaceModel& model, const BoundaryLoop& loop, LoopFacing facing) {
  const std::size_t n = loop.vertices.size();
  const auto point = [&](std::size_t k) { return model.mesh.point(TriMesh::VertexHandle(loop.vertices[k % n])); };
  Points across;
  for (std::size_t k = 0; k < n; ++k) across.emplace_back((point(k + 1) - point(k)).norm() * facing.edge_conormals[k]);
  for (std::size_t k = 0; k < n; ++k) {
    Vec3 sum = Vec3::Zero();
    for (std::size_t i = n + k - edges_beside; i < n + k + edges_beside; ++i) sum += across[i % n];
    facing.conormals[k] = sum.norm() > 0 ? Vec3(sum.normalized()) : Vec3::Zero();
  }
  facing.edge_conormals = facing.conormals;
  return facing;
}

bool may_end(const BoundaryLoop& loop) {
  return loop.edges() >= fewest_edges && loop.diameter > 0 && loop.planarity <= most_planarity_of_a_tube;
}

/// As loop_end(), but for teeth.
LoopEnd end_of(const BoundaryLoop& loop, const LoopFacing& facing, const Profiles& profiles, const Wall& wall) {
  const bool flat = loop.planarity <= flat_planarity;
  // Corners and the loop's own roundness bend the fits of profiles, but not the angle between faces and axis.
  const double share_of_a_ball = wall.turning * facing.radius / std::max(steep, median(wall.of_faces));
  const bool straight = share_of_a_ball < most_of_a_straight_wall;
  if (straight && quantile(wall.of_faces, torn_share) >= upright_all_along)
    return flat ? LoopEnd::flat : LoopEnd::curved;
  const double of_a_saddle = share_of_a_saddle / std::hypot(1, slope_of_a_saddle * loop.planarity);
  if (straight && !flat && loop.edges() >= fewest_round_a_tube &&
      wall.along_rulings >= std::min(along_rulings, of_a_saddle))
    return LoopEnd::curved;
  if (loop.planarity > most_planarity) return LoopEnd::runs_on;
  if (straight && loop.planarity <= plane_cut && median(wall.of_faces) >= steep &&
      quantile(wall.of_faces, torn_share) >= still_steep)
    return LoopEnd::flat;
  // Without profiles the wall is known by single faces only, as of a coarse box: it has to stand upright on a flat loop.
  const bool known = wall.is_known();
  const double usual = median(wall.steepness);
  // What goes on outward, and does not turn back as the wall of a bowl, cannot close the loop.
  bool closes = known && !straight;  // by turning back
  if (closes) closes = quantile(wall.curvatures, 0.75) >= 0;
  if (wall.flares() && (straight || (known && !closes)) && loop.planarity <= exact_planarity &&
      median(wall.of_faces) > least_steep_edge)
    return LoopEnd::flat;
  if (!known && (!flat || usual < upright)) return LoopEnd::runs_on;
  std::vector<double> shares = wall.curvatures;  // of that of a ball
  for (double& share : shares) share *= facing.radius / usual;
  if (loop.planarity <= exact_planarity && rounds_into_plane(usual, shares)) return LoopEnd::flat;
  if (usual < steep || quantile(wall.steepness, torn_share) < still_steep) return LoopEnd::runs_on;
  const bool dome = is_dome(shares, agreeing_share);
  const bool turns_like_a_ball = share_of_a_ball >= least_of_a_dome && share_of_a_ball <= most_of_a_dome;
  const std::optional<SideSurface> quadric = dome || !straight ? profiles.quadric() : std::nullopt;
  if (quadric && (dome || (!known && turns_like_a_ball) ? profiles.is_near(*quadric, median(wall.noise))
                                                        : profiles.is_closed_by(*quadric, 0, highest_dome)))
    return LoopEnd::runs_on;
  const bool is_hole_in_a_hill =
      loop.kind != LoopKind::outer_rim && loop.planarity > plane_cut && usual < steep_if_not_plane;
  if (is_hole_in_a_hill) return LoopEnd::runs_on;
  // A person's cut is planer.
  const bool is_clear_dome = loop.planarity > exact_planarity && turns_like_a_ball && is_dome(shares, clear_share) &&
                             quantile(shares, 0.25) >= clear_quarter;
  if (is_clear_dome) return LoopEnd::runs_on;
  if (flat) return dome ? LoopEnd::flat_or_dome : LoopEnd::flat;
  return loop.kind == LoopKind::outer_rim ? LoopEnd::curved : LoopEnd::runs_on;
}

/// A wall that bends, and lies on a quadric that would close over the loop, may as well go on.
LoopEnd unless_on_quadric(LoopEnd end, const LoopFacing& facing, const Profiles& profiles, const Wall& wall) {
  if ((end != LoopEnd::flat && end != LoopEnd::curved) ||
      wall.turning * facing.radius < least_bend * std::max(steep, median(wall.of_faces)))
    return end;
  const std::optional<SideSurface> quadric = profiles.quadric();
  if (!quadric) return end;
  if (profiles.is_closed_by(*quadric, 0, highest_dome)) return LoopEnd::runs_on;
  const bool may_go_on =
      end == LoopEnd::flat && profiles.is_closed_by(*quadric, median(wall.noise), most_of_a_high_dome);
  return may_go_on ? LoopEnd::flat_or_dome : end;
}

}  // namespace

double reach_of_loop_end(const SurfaceModel& model, const BoundaryLoop& loop) {
  if (!may_end(loop)) return 0;
  return reach_of_quadric * loop_facing(model, loop).radius;  // the other reach is a radius at most
}

LoopEnd loop_end(const SurfaceModel& model, const BoundaryLoop& loop) {
  if (!may_end(loop)) return LoopEnd::runs_on;
  const LoopFacing facing = loop_facing(model, loop);
  if (facing.axis.isZero()) return LoopEnd::runs_on;
  const Profiles profiles(model, loop, facing);
  const Wall as_it_is = read_wall(profiles, loop);
  if (loop.planarity <= exact_plane && quantile(as_it_is.of_faces, 0) >= exactly_upright) return LoopEnd::flat;
  if (loop.is_polygon && quantile(as_it_is.of_faces, torn_share) >= least_steep_edge) return LoopEnd::flat;
  const LoopEnd end = unless_on_quadric(end_of(loop, facing, profiles, as_it_is), facing, profiles, as_it_is);
  if (end != LoopEnd::flat && end != LoopEnd::runs_on) return end;
  const double teeth = height_of_teeth(profiles.heights(), profiles.mean_edge());
  if (!(teeth > 0)) return end;
  BoundaryLoop level = loop;
  level.planarity = std::min(level.planarity, flat_planarity);
  const LoopFacing smoothed = without_teeth(model, loop, facing);
  const Profiles above(model, level, smoothed);
  const Wall wall = read_wall(above, level);
  const bool toothed =
      unless_on_quadric(end_of(level, smoothed, above, wall), smoothed, above, wall) == LoopEnd::flat &&
      quantile(wall.steepness, torn_share) >= upright_all_along &&
      (wall.noise.empty() || teeth >= tooth_in_noises * quantile(wall.noise, away_from_corners));
  return toothed ? LoopEnd::toothed : end;
}

}  // namespace loopmend
