// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/flat_cut.h"

#include "core/quantile.h"
#include "edges/side_surface.h"
#include "mesh/loop_facing.h"

#include <Eigen/Dense>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <set>
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
constexpr double torn_share = 0.1;
/// A loop that is less plane than this may as well be a hole in a steep hill. Chosen on scanned and torn bases of planarity above 0.003
/// (0.91 to 1, but for 0.61 at 0.0032) and holes on top of a bump (0.42 to 0.68).
constexpr double plane_cut = 0.005, steep_if_not_plane = 0.75;
constexpr double upright = 0.9;
/// Teeth of a loop at which an upright wall ends: heights in boundary edges, edges from one turn to the next.
constexpr double lowest_tooth = 0.75, highest_tooth = 4, least_rise = 0.1, tooth_in_noises = 3;
constexpr std::size_t fewest_round_teeth = 24, fewest_teeth = 8, most_edges_of_a_tooth = 6;
constexpr std::size_t edges_beside = 4;  ///< over which the direction of the wall is taken where there are teeth
/// The same for the faces at all but the torn share of the loop. Of 161 holes of planarity 0.003 to 0.1 cut into natural models the
/// most upright has 0.76; tubes, bottles and stars with noise have 0.86 to 0.97.
constexpr double upright_all_along = 0.85;
constexpr double least_steep_edge = 0.15;
/// Profile curvatures in that of a ball that meets the plane at this angle. A dome: their median is about 1 and most agree.
/// Straighter walls end, sharper ones are rounded edges, and scattered ones tell no dome. Chosen on six bases of scanned statues
/// and on tubes and balls with noise up to 1 % of their size.
constexpr double least_of_a_dome = 0.6, most_of_a_dome = 1.4;
constexpr double least_that_agrees = 0.25, most_that_agrees = 2, agreeing_share = 0.6;
constexpr double most_of_a_straight_wall = 0.3;  ///< half of the least of a dome
constexpr double reach_of_fit = 0.3;             ///< in loop radii; at least so many boundary edges, up to the radius:
constexpr double edges_of_fit = 4;
constexpr int fewest_samples = 8;
/// In reaches. Chosen on cylinders with windows (0.9 and more) and an outer rim of an oral scan (0.65).
constexpr double long_edge = 0.8;
/// A dome is missing where one quadric goes on behind the loop: of 21 balls, ellipsoids and parts of them, with noise of up to 0.4 %
/// of their radius, it is off by 0 to 0.0025 diameters, of eleven standing figures and wavy bases that bend like a ball at their
/// base alone by 0.006 to 0.046; beyond 1.2 noises of up to 1 %, 120 balls and eggs by 0.0035, five figures by 0.009 and more.
constexpr double reach_of_quadric = 1.5, off_quadric = 0.005, noises_off_quadric = 1.2;
/// In diameters: a surface so near to a quadric goes on with it where that closes so far over the loop. Chosen on ellipsoids and eggs
/// (0 to 0.0005; 0.14 to 0.39) and a barrel (0.53), which ends.
constexpr double on_quadric = 0.001, lowest_dome = 0.1, highest_dome = 0.45;
constexpr std::size_t most_fits = 200;
/// A loop so many times as long as wide is seen as if it were round: else its two ends are no more than a torn share. The ends
/// of a slot along a tube, whose wall does not lean there, are below a tenth of its length from nine widths on.
constexpr double long_loop = 3;

double reach_of(const BoundaryLoop& loop, const LoopFacing& facing) {
  const double edges = edges_of_fit * loop.perimeter / loop.edges();
  return std::max(reach_of_fit * facing.radius, std::min(edges, facing.radius));
}

/// The profile of the surface at one loop vertex, in the plane of the loop's axis and the direction to its center.
struct Profile {
  double steepness = 0;             ///< sine of the angle between surface and loop plane; positive along the axis
  std::optional<double> curvature;  ///< 1/length, positive where the profile turns from the axis to the center
  double noise = 0;                 ///< rms of the points behind from the fit, mesh units
};

/// How the normals of the faces behind a loop lie. Those of a cylinder, a cone or a prism lie on a plane, whatever its slope to that of
/// the loop; those of a ball turn with the height over it.
class NormalsOfWall {
 public:
  /// The faces behind one vertex of the loop. @param normals  as long as twice the areas
  void add(const std::vector<Vec3>& centers, const std::vector<Vec3>& normals) {
    double weight = 0;
    Vec3 center = Vec3::Zero(), normal = Vec3::Zero();
    for (std::size_t f = 0; f < normals.size(); ++f) {
      weight += normals[f].norm();
      center += normals[f].norm() * centers[f];
      normal += normals[f];
    }
    if (!(weight > 0)) return;
    center /= weight;
    normal /= weight;
    for (std::size_t f = 0; f < normals.size(); ++f) {
      const double area = normals[f].norm();
      if (!(area > 0)) continue;
      const Vec3 unit = normals[f] / area, from_center = centers[f] - center;
      turning_ += area * (unit - normal) * from_center.transpose();
      spread_ += area * from_center * from_center.transpose();
      weight_ += area;
      sum_ += area * unit;
      squares_ += area * unit * unit.transpose();
    }
  }

  /// Unit: in which the normals differ least, along the rulings of a cylinder or a prism; zero without faces.
  Vec3 rulings() const {
    if (!(weight_ > 0)) return Vec3::Zero();
    const Vec3 mean = sum_ / weight_;
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(squares_ / weight_ - mean * mean.transpose());
    return axes.eigenvectors().col(0);
  }
  /// The normals' component along rulings(), rms: 0 for a cylinder, the sine of the taper for a cone.
  double taper() const {
    const Vec3 direction = rulings();
    return weight_ > 0 ? std::sqrt(std::max(0.0, direction.dot(squares_ * direction) / weight_)) : 0;
  }
  /// Change of the normals' component along rulings(), over the distance in that direction, 1/length.
  double turning() const {
    const Vec3 direction = rulings();
    const double spread = direction.dot(spread_ * direction);
    return spread > 0 ? std::abs(direction.dot(turning_ * direction)) / spread : 0;
  }

 private:
  Eigen::Matrix3d turning_ = Eigen::Matrix3d::Zero(), spread_ = Eigen::Matrix3d::Zero(),
                  squares_ = Eigen::Matrix3d::Zero();
  Vec3 sum_ = Vec3::Zero();
  double weight_ = 0;
};

/// Where a loop lies, and the points of the surface behind its vertices.
class Profiles {
 public:
  Profiles(const SurfaceModel& model, const BoundaryLoop& loop, const LoopFacing& facing)
      : mesh_(model.mesh),
        loop_(loop),
        facing_(facing),
        axis_(facing.onward.dot(facing.axis) < 0 ? Vec3(-facing.axis) : facing.axis),
        reach_(reach_of(loop, facing)) {
    for (std::size_t k = 0; k < loop.vertices.size(); ++k) has_long_edges_ = has_long_edges_ || is_long(k);
    find_longest_direction();
  }

  Profile at(std::size_t k) const {
    const Vec3 p = mesh_.point(TriMesh::VertexHandle(loop_.vertices[k]));
    const Vec3 across = facing_.conormals[k];
    Profile profile{across.dot(axis_), std::nullopt};
    Vec3 inward = facing_.center - p;
    inward = (inward - axis_.dot(inward) * axis_).normalized();
    // In the loop's own plane of symmetry the conormal has no part beside these two; what it has is noise.
    const Eigen::Vector2d straight = Eigen::Vector2d(across.dot(axis_), across.dot(inward)).normalized();
    const std::vector<Vec3> samples = behind(loop_.vertices[k], p, inward, straight);
    if (static_cast<int>(samples.size()) < fewest_samples) return profile;
    fit(samples, straight, profile);
    return profile;
  }

  /// Weights of a vertex and of the edge to the next one: 1 and 0. Where a loop has edges so long that their ends say
  /// little of them, lengths in mean edges. Of a long loop, times the share of the edges that stays where it is seen round.
  double weight_at(std::size_t k) const {
    const std::size_t before = (k + loop_.vertices.size() - 1) % loop_.vertices.size();
    const auto weight = [&](std::size_t edge) {
      const double lengths = has_long_edges_ ? length(edge) / mean_edge() : 1;
      return has_long_edges_ && is_long(edge) ? 0 : lengths * seen_round(edge);
    };
    return (weight(k) + weight(before)) / 2;
  }
  double weight_after(std::size_t k) const { return is_long(k) ? length(k) / mean_edge() * seen_round(k) : 0; }
  double steepness_after(std::size_t k) const { return facing_.edge_conormals[k].dot(axis_); }
  double steepness_of_face(std::size_t k) const { return facing_.conormals[k].dot(axis_); }
  /// Least cosine between a direction, to the side to which the surface runs on, and how the faces leave the loop, along all but
  /// the share of its length that may be torn.
  double least_along(Vec3 direction) const {
    if (direction.dot(facing_.onward) < 0) direction = -direction;
    std::vector<Weighted> cosines;
    for (std::size_t k = 0; k < loop_.vertices.size(); ++k)
      cosines.push_back({facing_.edge_conormals[k].dot(direction), length(k)});
    return quantile(std::move(cosines), torn_share);
  }
  /// Of the loop's vertices along the axis, mesh units.
  std::vector<double> heights() const {
    std::vector<double> result;
    for (const int v : loop_.vertices) result.push_back(axis_.dot(mesh_.point(TriMesh::VertexHandle(v))));
    return result;
  }
  double mean_edge() const { return loop_.perimeter / loop_.edges(); }
  /// Whether the surface leaves the loop away from its center, as the wall of a bell.
  bool flares_at(std::size_t k) const {
    return facing_.conormals[k].dot(facing_.center - mesh_.point(TriMesh::VertexHandle(loop_.vertices[k]))) < 0;
  }

  /// Adds the faces behind one loop vertex, up to half the reach, since a low wall may end beyond.
  void add_faces_behind(std::size_t k, NormalsOfWall& wall) const {
    const Vec3 p = mesh_.point(TriMesh::VertexHandle(loop_.vertices[k]));
    std::set<int> faces;
    for (const int v : within(reach_ / 2, loop_.vertices[k], p))
      for (const auto f : mesh_.vf_range(TriMesh::VertexHandle(v))) faces.insert(f.idx());
    std::vector<Vec3> centers, normals;
    for (const int f : faces) {
      std::array<Vec3, 3> corner;
      std::size_t c = 0;
      for (const auto v : mesh_.fv_range(TriMesh::FaceHandle(f))) corner[c++] = mesh_.point(v);
      centers.emplace_back((corner[0] + corner[1] + corner[2]) / 3 - p);
      normals.emplace_back((corner[1] - corner[0]).cross(corner[2] - corner[0]));
    }
    wall.add(centers, normals);
  }

  /// One quadric, as a ball or an ellipsoid, through the surface near the loop, up to a radius behind its plane.
  std::optional<SideSurface> quadric() const {
    constexpr std::size_t places = 8;  // along the loop
    std::set<int> near;
    for (std::size_t k = 0; k < places; ++k) {
      const int v = loop_.vertices[k * loop_.vertices.size() / places];
      const std::vector<int> around =
          within(reach_of_quadric * facing_.radius, v, mesh_.point(TriMesh::VertexHandle(v)));
      near.insert(around.begin(), around.end());
    }
    Points points;
    for (const int v : near) {
      const Vec3& p = mesh_.point(TriMesh::VertexHandle(v));
      if (std::abs(axis_.dot(p - facing_.center)) <= facing_.radius) points.push_back(p);
    }
    return SideSurface::fit(points, axis_, 2 * facing_.radius);
  }

  /// @param noise  of the vertices, rms, mesh units
  bool is_near(const SideSurface& surface, double noise) const {
    return surface.rms() <= std::hypot(2 * off_quadric * facing_.radius, noises_off_quadric * noise);
  }
  bool is_closed_by(const SideSurface& surface) const {
    const double diameter = 2 * facing_.radius;
    return surface.rms() <= on_quadric * diameter && surface.kind() == SideSurface::Kind::quadric &&
           surface.changes_sides(facing_.center + lowest_dome * diameter * axis_,
                                 facing_.center + highest_dome * diameter * axis_);
  }

 private:
  void find_longest_direction() {
    Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
    for (const int v : loop_.vertices) {
      const Vec3 d = mesh_.point(TriMesh::VertexHandle(v)) - facing_.center;
      spread += d * d.transpose();
    }
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(spread);
    const Vec3 along = axes.eigenvectors().col(2), across = axes.eigenvectors().col(1);
    double length = 0, width = 0;
    for (const int v : loop_.vertices) {
      const Vec3 d = mesh_.point(TriMesh::VertexHandle(v)) - facing_.center;
      length = std::max(length, std::abs(along.dot(d)));
      width = std::max(width, std::abs(across.dot(d)));
    }
    constexpr int fewest_seen_round = 20;
    if (length < long_loop * width || loop_.edges() < fewest_seen_round) return;
    longest_ = along;
    shrunk_ = width / length;
  }
  /// The share of the boundary around an edge that stays where a long loop is shrunk to its width; 1 for other loops. A single
  /// edge of a ragged side may run across.
  double seen_round(std::size_t k) const {
    constexpr std::size_t beside = 4;
    if (shrunk_ == 1) return 1;
    const std::size_t n = loop_.vertices.size();
    const auto point = [&](std::size_t i) { return mesh_.point(TriMesh::VertexHandle(loop_.vertices[i % n])); };
    const Vec3 chord = (point(k + 1 + beside) - point(k + n - beside)).normalized();
    return (chord - (1 - shrunk_) * longest_.dot(chord) * longest_).norm();
  }

  /// Of the boundary edge to the next vertex, mesh units.
  double length(std::size_t k) const {
    const auto point = [&](std::size_t i) { return mesh_.point(TriMesh::VertexHandle(loop_.vertices[i])); };
    return (point((k + 1) % loop_.vertices.size()) - point(k)).norm();
  }
  bool is_long(std::size_t k) const { return length(k) > long_edge * reach_; }

  /// Vertices that are joined to this one within a distance of p, itself among them.
  std::vector<int> within(double reach, int v, const Vec3& p) const {
    std::vector<int> queue{v};
    std::set<int> seen{v};
    for (std::size_t q = 0; q < queue.size(); ++q)
      for (const auto w : mesh_.vv_range(TriMesh::VertexHandle(queue[q])))
        if ((mesh_.point(w) - p).norm() <= reach && seen.insert(w.idx()).second) queue.push_back(w.idx());
    return queue;
  }

  /// Points within reach, and within 45 degrees of straight back, as (axis, inward, aside) from p in units of the reach.
  std::vector<Vec3> behind(int v, const Vec3& p, const Vec3& inward, const Eigen::Vector2d& onward) const {
    const Vec3 aside = axis_.cross(inward);
    std::vector<Vec3> samples;
    for (const int w : within(reach_, v, p)) {
      const Vec3 d = mesh_.point(TriMesh::VertexHandle(w)) - p;
      const Vec3 sample(d.dot(axis_), d.dot(inward), d.dot(aside));
      const double back = -sample.head<2>().dot(onward);
      if (back > 0 && std::hypot(sample.z(), sample.x() * onward.y() - sample.y() * onward.x()) <= back)
        samples.push_back(sample / reach_);
    }
    return samples;
  }

  /// A quadratic height field over the mean direction of the samples. Its constant term is free, since p has noise of its own,
  /// and so is what the loop's own curvature adds beside the profile.
  void fit(const std::vector<Vec3>& samples, const Eigen::Vector2d& straight, Profile& profile) const {
    Eigen::Vector2d mean = Eigen::Vector2d::Zero();
    for (const Vec3& s : samples) mean += s.head<2>();
    const Eigen::Vector2d onward = mean.norm() > 0 ? Eigen::Vector2d(-mean.normalized()) : straight;
    const Eigen::Vector2d normal(-onward.y(), onward.x());  // turned from the axis towards the center
    Eigen::MatrixXd rows(samples.size(), 6);
    Eigen::VectorXd heights(samples.size());
    for (std::size_t i = 0; i < samples.size(); ++i) {
      const double t = samples[i].head<2>().dot(onward), a = samples[i].z();
      rows.row(static_cast<Eigen::Index>(i)) << 1, t, t * t, a, a * a, a * t;
      heights[static_cast<Eigen::Index>(i)] = samples[i].head<2>().dot(normal);
    }
    const Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(rows);
    if (qr.rank() < 6) return;
    const Eigen::VectorXd c = qr.solve(heights);
    const double stretch = 1 + c[1] * c[1];
    profile.steepness = (onward + c[1] * normal).x() / std::sqrt(stretch);
    profile.curvature = 2 * c[2] / (stretch * std::sqrt(stretch)) / reach_;
    const auto freedom = static_cast<double>(samples.size() - 6);
    profile.noise = reach_ * std::sqrt((rows * c - heights).squaredNorm() / freedom);
  }

  const TriMesh& mesh_;
  const BoundaryLoop& loop_;
  const LoopFacing& facing_;
  Vec3 axis_;  ///< to the side to which the surface runs on
  double reach_;
  bool has_long_edges_ = false;
  Vec3 longest_ = Vec3::Zero();  ///< unit: direction in which a long loop is longest
  double shrunk_ = 1;            ///< its width over its length; 1 for other loops
};

/// @param shares  curvature of each profile in that of a ball.
bool is_dome(const std::vector<double>& shares) {
  if (shares.empty()) return false;
  const double usual = median(shares);
  if (usual < least_of_a_dome || usual > most_of_a_dome) return false;
  const auto agreeing = std::count_if(
      shares.begin(), shares.end(), [](double share) { return share > least_that_agrees && share < most_that_agrees; });
  return static_cast<double>(agreeing) >= agreeing_share * static_cast<double>(shares.size());
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
  const bool dome = is_dome(shares);
  const bool turns_like_a_ball = share_of_a_ball >= least_of_a_dome && share_of_a_ball <= most_of_a_dome;
  const std::optional<SideSurface> quadric = dome || !straight ? profiles.quadric() : std::nullopt;
  if (quadric && (dome || (!known && turns_like_a_ball) ? profiles.is_near(*quadric, median(wall.noise))
                                                        : profiles.is_closed_by(*quadric)))
    return LoopEnd::runs_on;
  const bool is_hole_in_a_hill =
      loop.kind != LoopKind::outer_rim && loop.planarity > plane_cut && usual < steep_if_not_plane;
  if (is_hole_in_a_hill) return LoopEnd::runs_on;
  if (flat) return dome ? LoopEnd::flat_or_dome : LoopEnd::flat;
  return loop.kind == LoopKind::outer_rim ? LoopEnd::curved : LoopEnd::runs_on;
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
  const LoopEnd end = end_of(loop, facing, profiles, read_wall(profiles, loop));
  if (end != LoopEnd::flat && end != LoopEnd::runs_on) return end;
  const double teeth = height_of_teeth(profiles.heights(), profiles.mean_edge());
  if (!(teeth > 0)) return end;
  BoundaryLoop level = loop;
  level.planarity = std::min(level.planarity, flat_planarity);
  const LoopFacing smoothed = without_teeth(model, loop, facing);
  const Profiles above(model, level, smoothed);
  const Wall wall = read_wall(above, level);
  const bool toothed = end_of(level, smoothed, above, wall) == LoopEnd::flat &&
                       quantile(wall.steepness, torn_share) >= upright_all_along &&
                       (wall.noise.empty() || teeth >= tooth_in_noises * median(wall.noise));
  return toothed ? LoopEnd::toothed : end;
}

}  // namespace loopmend
