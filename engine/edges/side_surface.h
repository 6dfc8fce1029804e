// SPDX-License-Identifier: GPL-3.0-or-later
// The smooth surface on one side of a sharp edge, continued beyond its faces (docs/math/sharp_edges.md, "Sides").
#pragma once

#include "core/types.h"

#include <Eigen/Core>

#include <optional>
#include <span>

namespace loopmend {

/// A plane, a quadratic or cubic height field over the side's own plane, or a quadric: the least-squares fit with the least
/// ln(rms) + penalty, where quadratics pay 0.35, cubics and quadrics 1.
class SideSurface {
 public:
  enum class Kind { plane, quadratic, cubic, quadric };
  enum class Kinds { all, height_fields };

  /// @param normal  unit, of the side. @param unit  length that the fit is made in: about the extent of the hole
  /// @param between  middles of edges: they decide where several surfaces go through the points, as through the vertices
  /// of a wall of one row
  /// @returns nothing for fewer than three points, or where all lie on one line.
  static std::optional<SideSurface> fit(const Points& points, const Vec3& normal, double unit, Kinds kinds = Kinds::all,
                                        const Points& between = {});

  Kind kind() const { return kind_; }
  double rms() const { return rms_; }  ///< distance of the points, degrees of freedom taken off
  /// A point of the surface near p: the foot of the perpendicular on a height field; on a quadric where descent along its gradient
  /// ends.
  Vec3 foot(const Vec3& p) const;
  /// Whether these points lie on different sides of it.
  bool changes_sides(const Vec3& p, const Vec3& q) const;
  /// In the side's own axes: x and y along its plane, z across.
  Vec3 in_plane(const Vec3& p) const { return local(p); }
  /// Unit normal at a point of the surface, on the outside where that is known.
  Vec3 normal_at(const Vec3& on_surface) const;
  /// Not of a quadric whose points go round it.
  bool has_outside() const { return has_outside_; }

 private:
  using Coefficients = Eigen::Matrix<double, 10, 1>;

  Vec3 local(const Vec3& p) const { return axes_.transpose() * (p - origin_) / unit_; }
  Vec3 foot_on_height_field(const Vec3& q) const;
  Vec3 foot_on_quadric(const Vec3& q) const;
  void try_height_field(const Points& local, const Points& between, Kind kind, double& best);
  void try_quadric(const Points& local, const Points& between, double& best);

  Vec3 origin_ = Vec3::Zero();
  Eigen::Matrix3d axes_ = Eigen::Matrix3d::Identity();  ///< columns; the third is the normal
  double unit_ = 1, rms_ = 0;
  Kind kind_ = Kind::plane;
  bool has_outside_ = true;
  Coefficients c_ = Coefficients::Zero();
};

/// A point near p that lies on all surfaces: Newton's method for the least displacement. Where they do not meet within `reach` of
/// p, the mean of the feet of p.
Vec3 common_point(std::span<const SideSurface* const> surfaces, const Vec3& p, double reach);

/// The largest distance of p from one of them.
double distance(std::span<const SideSurface* const> surfaces, const Vec3& p);

}  // namespace loopmend
