// SPDX-License-Identifier: GPL-3.0-or-later
#include "mirror/mirror_plane.h"

#include "core/error.h"
#include "core/quantile.h"
#include "core/random.h"
#include "core/threads.h"
#include "mesh/point_tree.h"

#include <Eigen/Dense>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace loopmend {

namespace {

constexpr int most_planes = 3;
constexpr int rough_queries = 500, fine_queries = 2500, target_samples = 12000;
constexpr double kept_share = 0.7;  ///< of the samples; holes and one-sided features have no image
/// A body of revolution with two horns fits every plane through its axis but for the horns, which kept_share leaves out.
constexpr std::array<double, 2> larger_shares = {0.85, 0.95};
constexpr int rough_steps = 25, fine_steps = 15;
/// Planes nearer to each other are one.
constexpr double same_cosine = 0.985, same_offset = 0.02;
/// Further planes count where they fit nearly as well as the best: half of the surface's parts may be symmetric in one alone.
constexpr double worse_factor = 2.5;

/// Points spread evenly over a surface, with its normals.
struct Samples {
  Points points, normals;
};

/// About `count` points, one in each stretch of the same area along the triangles.
Samples sample_surface(const SurfaceModel& model, const Vec3& origin, int count, std::uint64_t seed) {
  const Points& points = model.soup.points;
  const auto normal_of = [&](int f) -> Vec3 {
    const Triangle& t = model.soup.triangles[f];
    return (points[t[1]] - points[t[0]]).cross(points[t[2]] - points[t[0]]);
  };
  double area = 0;
  for_each_soup_triangle(model, [&](int f) { area += normal_of(f).norm(); });
  Samples samples;
  if (!(area > 0) || !std::isfinite(area)) return samples;
  Random random(seed);
  double passed = 0, next = random.uniform() * area / count;
  int stretch = 0;
  for_each_soup_triangle(model, [&](int f) {
    const Vec3 normal = normal_of(f);
    passed += normal.norm();
    for (; next < passed; next = (++stretch + random.uniform()) * area / count) {
      const Triangle& t = model.soup.triangles[f];
      const double root = std::sqrt(random.uniform()), share = random.uniform();
      samples.points.emplace_back((1 - root) * (points[t[0]] - origin) + root * (1 - share) * (points[t[1]] - origin) +
                                  root * share * (points[t[2]] - origin));
      samples.normals.push_back(normal.normalized());
    }
  });
  return samples;
}

/// n·p = d, in the frame of the samples.
struct Plane {
  Vec3 n;
  double d = 0;
  double misfit = 0;  ///< length

  Vec3 image(const Vec3& p) const { return p - 2 * (n.dot(p) - d) * n; }
};

/// One search from one start.
class PlaneSearch {
 public:
  PlaneSearch(const Samples& queries, const Samples& targets, const PointTree& tree)
      : queries_(queries),
        targets_(targets),
        tree_(tree) {}

  Plane rough(Plane plane, const CancelToken& cancel) {
    for (int k = 0; k < rough_steps && !cancel.cancelled(); ++k) {
      match(plane, Distance::of_points);
      const Vec3 before = plane.n;
      fit_points(plane);
      if (plane.n.dot(before) > 1 - 1e-10) break;
    }
    plane.misfit = limit_;
    return plane;
  }

  /// From where kept_share of the samples lead on also by larger shares, where that fits kept_share better.
  Plane fine(const Plane& start, const CancelToken& cancel) {
    Plane best = fine(start, kept_share, cancel);
    for (double share : larger_shares)
      if (const Plane other = fine(best, share, cancel); other.misfit < best.misfit) best = other;
    return best;
  }

 private:
  Plane fine(Plane plane, double share, const CancelToken& cancel) {
    for (int k = 0; k < fine_steps && !cancel.cancelled(); ++k) {
      match(plane, Distance::of_planes, share);
      if (fit_planes(plane) < 1e-9) break;
    }
    match(plane, Distance::of_planes);
    plane.misfit = limit_;
    return plane;
  }

  enum class Distance { of_points, of_planes };

  /// The nearest target of each image, and which of them count.
  void match(const Plane& plane, Distance distance, double share = kept_share) {
    const std::size_t count = queries_.points.size();
    nearest_.resize(count);
    distance_.resize(count);
    for (std::size_t i = 0; i < count; ++i) {
      const Vec3 image = plane.image(queries_.points[i]);
      const Vec3 normal = queries_.normals[i] - 2 * plane.n.dot(queries_.normals[i]) * plane.n;
      std::pair<TreePoint, int> found;
      tree_.query(boost::geometry::index::nearest(tree_point(image), 1), &found);
      const int j = found.second;
      nearest_[i] = j;
      const Vec3 between = image - targets_.points[j];
      const bool faces_alike = normal.dot(targets_.normals[j]) > 0.5;
      distance_[i] =
          distance == Distance::of_planes && faces_alike ? std::abs(between.dot(targets_.normals[j])) : between.norm();
    }
    limit_ = quantile(distance_, share);
  }

  template <class Use>
  void for_each_match(const Use& use) const {
    for (std::size_t i = 0; i < nearest_.size(); ++i)
      if (distance_[i] <= limit_) use(queries_.points[i], targets_.points[nearest_[i]], targets_.normals[nearest_[i]]);
  }

  /// The least Σ |a − image of m|² = Σ |a − m|² + 4 (n·a − d)(n·m − d): d is the mean of n·(a + m)/2, and n the eigenvector of
  /// the largest eigenvalue of Σ (a − m)(a − m)ᵀ − 4 cov((a + m)/2).
  void fit_points(Plane& plane) const {
    Eigen::Matrix3d form = Eigen::Matrix3d::Zero(), spread = Eigen::Matrix3d::Zero();
    Vec3 mean = Vec3::Zero();
    double count = 0;
    for_each_match([&](const Vec3& a, const Vec3& m, const Vec3&) {
      mean += (a + m) / 2;
      count += 1;
    });
    mean /= count;
    for_each_match([&](const Vec3& a, const Vec3& m, const Vec3&) {
      const Vec3 middle = (a + m) / 2 - mean;
      form += (a - m) * (a - m).transpose();
      spread += middle * middle.transpose();
    });
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(form - 4 * spread);
    const Vec3 n = solver.eigenvectors().col(2);
    plane.n = n.dot(plane.n) < 0 ? Vec3(-n) : n;
    plane.d = plane.n.dot(mean);
  }

  /// One Gauss-Newton step for Σ (N·(image of a − m))². @returns how far n and d, in extents, were moved.
  double fit_planes(Plane& plane) const {
    const Vec3 u = plane.n.unitOrthogonal(), v = plane.n.cross(u);
    Eigen::Matrix3d normal_matrix = Eigen::Matrix3d::Zero();
    Vec3 right = Vec3::Zero();
    double reach = 0;
    for_each_match([&](const Vec3& a, const Vec3& m, const Vec3& N) {
      const double height = plane.n.dot(a) - plane.d, across = N.dot(plane.n);
      const Vec3 row(-2 * (u.dot(a) * across + height * N.dot(u)), -2 * (v.dot(a) * across + height * N.dot(v)),
                     2 * across);
      normal_matrix += row * row.transpose();
      right -= row * N.dot(plane.image(a) - m);
      reach = std::max(reach, a.norm());
    });
    normal_matrix.diagonal().array() += 1e-9 * normal_matrix.trace() + 1e-300;
    const Vec3 step = normal_matrix.ldlt().solve(right);
    if (!step.allFinite()) return 0;
    plane.n = (plane.n + step[0] * u + step[1] * v).normalized();
    plane.d += step[2];
    return std::abs(step[0]) + std::abs(step[1]) + std::abs(step[2]) / (reach + 1e-300);
  }

  const Samples& queries_;
  const Samples& targets_;
  const PointTree& tree_;
  std::vector<int> nearest_;
  std::vector<double> distance_;
  double limit_ = 0;
};

/// The principal axes, and the bisectors of each two.
std::array<Vec3, 9> start_normals(const Points& points) {
  Eigen::Matrix3d spread = Eigen::Matrix3d::Zero();
  for (const Vec3& p : points) spread += p * p.transpose();
  const Eigen::Matrix3d axes = Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(spread).eigenvectors();
  std::array<Vec3, 9> normals;
  for (int k = 0; k < 3; ++k) {
    const Vec3 a = axes.col((k + 1) % 3), b = axes.col((k + 2) % 3);
    normals[k] = axes.col(k);
    normals[3 + 2 * k] = (a + b).normalized();
    normals[4 + 2 * k] = (a - b).normalized();
  }
  return normals;
}

Samples every(const Samples& all, std::size_t step) {
  Samples some;
  for (std::size_t i = 0; i < all.points.size(); i += step) {
    some.points.push_back(all.points[i]);
    some.normals.push_back(all.normals[i]);
  }
  return some;
}

/// Those that fit nearly as well as the best, the best first.
std::vector<Plane> best_different(std::vector<Plane> found, double extent) {
  std::stable_sort(found.begin(), found.end(), [](const Plane& a, const Plane& b) { return a.misfit < b.misfit; });
  std::vector<Plane> different;
  for (const Plane& plane : found) {
    const bool known = std::any_of(different.begin(), different.end(), [&](const Plane& other) {
      const double cosine = plane.n.dot(other.n);
      return std::abs(cosine) > same_cosine &&
             std::abs(plane.d - (cosine < 0 ? -other.d : other.d)) < same_offset * extent;
    });
    if (!known && std::isfinite(plane.misfit) && plane.misfit <= worse_factor * found.front().misfit + 1e-3 * extent)
      different.push_back(plane);
  }
  return different;
}

}  // namespace

MirrorPlane make_mirror_plane(const Vec3& point, const Vec3& normal) {
  if (!point.allFinite() || !normal.allFinite() || !(normal.norm() > 0) || !std::isfinite(normal.norm()))
    throw InvalidArgument(say("a mirror plane needs a point and a normal that is not 0, in finite numbers"));
  // One that is unit to rounding keeps its bits: what is printed in full and read again is the same plane.
  const bool is_unit = std::abs(normal.squaredNorm() - 1) < 4 * std::numeric_limits<double>::epsilon();
  return {point, is_unit ? normal : normal.normalized(), 0};
}

std::vector<MirrorPlane> find_mirror_planes(const SurfaceModel& model, const CancelToken& cancel) {
  Samples queries = sample_surface(model, Vec3::Zero(), fine_queries, 1);
  if (queries.points.empty()) return {};
  Vec3 center = Vec3::Zero();
  for (const Vec3& p : queries.points) center += p / static_cast<double>(queries.points.size());
  queries = sample_surface(model, center, fine_queries, 1);
  const Samples targets = sample_surface(model, center, target_samples, 2);
  std::vector<std::pair<TreePoint, int>> numbered;
  Eigen::AlignedBox3d box;
  for (std::size_t i = 0; i < targets.points.size(); ++i) {
    numbered.emplace_back(tree_point(targets.points[i]), static_cast<int>(i));
    box.extend(targets.points[i]);
  }
  const double extent = box.diagonal().norm();
  if (!(extent > 0) || !std::isfinite(extent)) return {};
  const PointTree tree(numbered.begin(), numbered.end());
  const Samples few = every(queries, fine_queries / rough_queries);
  const std::array<Vec3, 9> normals = start_normals(queries.points);
  std::vector<Plane> found(normals.size());
  parallel_for(0, static_cast<int>(found.size()), 1, [&](int k) {
    found[k] = PlaneSearch(few, targets, tree).rough({normals[k], 0, 0}, cancel);
  });
  found = best_different(std::move(found), extent);
  parallel_for(0, static_cast<int>(found.size()), 1,
               [&](int k) { found[k] = PlaneSearch(queries, targets, tree).fine(found[k], cancel); });
  if (cancel.cancelled()) return {};
  found = best_different(std::move(found), extent);
  std::vector<MirrorPlane> planes;
  for (const Plane& plane : found)
    if (planes.size() < most_planes) planes.push_back({center + plane.d * plane.n, plane.n, plane.misfit / extent});
  return planes;
}

}  // namespace loopmend
