// SPDX-License-Identifier: GPL-3.0-or-later
// How the surface behind a loop runs towards it: what loop_end() reads.
#pragma once

#include "edges/side_surface.h"
#include "mesh/loop_facing.h"

#include <optional>
#include <vector>

namespace loopmend {

inline constexpr double torn_share = 0.1;        ///< of a loop's length
inline constexpr double reach_of_quadric = 1.5;  ///< of Profiles::quadric(), in loop radii

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
  void add(const std::vector<Vec3>& centers, const std::vector<Vec3>& normals);

  /// Unit: in which the normals differ least, along the rulings of a cylinder or a prism; zero without faces.
  Vec3 rulings() const;
  /// The normals' component along rulings(), rms: 0 for a cylinder, the sine of the taper for a cone.
  double taper() const;
  /// Change of the normals' component along rulings(), over the distance in that direction, 1/length.
  double turning() const;

 private:
  Eigen::Matrix3d turning_ = Eigen::Matrix3d::Zero(), spread_ = Eigen::Matrix3d::Zero(),
                  squares_ = Eigen::Matrix3d::Zero();
  Vec3 sum_ = Vec3::Zero();
  double weight_ = 0;
};

/// Where a loop lies, and the points of the surface behind its vertices.
class Profiles {
 public:
  Profiles(const SurfaceModel& model, const BoundaryLoop& loop, const LoopFacing& facing);

  Profile at(std::size_t k) const;

  /// Weights of a vertex and of the edge to the next one: 1 and 0. Where a loop has edges so long that their ends say
  /// little of them, lengths in mean edges. Of a long loop, times the share of the edges that stays where it is seen round.
  double weight_at(std::size_t k) const;
  double weight_after(std::size_t k) const { return is_long(k) ? length(k) / mean_edge() * seen_round(k) : 0; }
  double steepness_after(std::size_t k) const { return facing_.edge_conormals[k].dot(axis_); }
  double steepness_of_face(std::size_t k) const { return facing_.conormals[k].dot(axis_); }
  /// Least cosine between a direction, to the side to which the surface runs on, and how the faces leave the loop, along all but
  /// the share of its length that may be torn.
  double least_along(Vec3 direction) const;
  /// Of the loop's vertices along the axis, mesh units.
  std::vector<double> heights() const;
  double mean_edge() const { return loop_.perimeter / loop_.edges(); }
  /// Whether the surface leaves the loop away from its center, as the wall of a bell.
  bool flares_at(std::size_t k) const;

  /// Adds the faces behind one loop vertex, up to half the reach, since a low wall may end beyond.
  void add_faces_behind(std::size_t k, NormalsOfWall& wall) const;

  /// One quadric, as a ball or an ellipsoid, through the surface near the loop, up to a radius behind its plane.
  std::optional<SideSurface> quadric() const;

  /// @param noise  of the vertices, rms, mesh units
  bool is_near(const SideSurface& surface, double noise) const;
  /// @param highest  dome, in diameters
  bool is_closed_by(const SideSurface& surface, double noise, double highest) const;

 private:
  void find_longest_direction();
  /// The share of the boundary around an edge that stays where a long loop is shrunk to its width; 1 for other loops. A single
  /// edge of a ragged side may run across.
  double seen_round(std::size_t k) const;

  /// Of the boundary edge to the next vertex, mesh units.
  double length(std::size_t k) const;
  bool is_long(std::size_t k) const;

  /// Vertices that are joined to this one within a distance of p, itself among them.
  std::vector<int> within(double reach, int v, const Vec3& p) const;

  /// Points within reach, and within 45 degrees of straight back, as (axis, inward, aside) from p in units of the reach.
  std::vector<Vec3> behind(int v, const Vec3& p, const Vec3& inward, const Eigen::Vector2d& onward) const;

  /// A quadratic height field over the mean direction of the samples. Its constant term is free, since p has noise of its own,
  /// and so is what the loop's own curvature adds beside the profile.
  void fit(const std::vector<Vec3>& samples, const Eigen::Vector2d& straight, Profile& profile) const;

  const TriMesh& mesh_;
  const BoundaryLoop& loop_;
  const LoopFacing& facing_;
  Vec3 axis_;  ///< to the side to which the surface runs on
  double reach_;
  bool has_long_edges_ = false;
  Vec3 longest_ = Vec3::Zero();  ///< unit: direction in which a long loop is longest
  double shrunk_ = 1;            ///< its width over its length; 1 for other loops
};

}  // namespace loopmend
