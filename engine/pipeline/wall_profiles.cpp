// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/wall_profiles.h"

#include "core/quantile.h"

#include <Eigen/Dense>

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <utility>

namespace loopmend {

namespace {

constexpr double reach_of_fit = 0.3;  ///< in loop radii; at least so many boundary edges, up to the radius:
constexpr double edges_of_fit = 4;
constexpr int fewest_samples = 8;
/// In reaches. Chosen on cylinders with windows (0.9 and more) and an outer rim of an oral scan (0.65).
constexpr double long_edge = 0.8;
/// A dome is missing where one quadric goes on behind the loop: of 21 balls, ellipsoids and parts of them, with noise of up to 0.4 %
/// of their radius, it is off by 0 to 0.0025 diameters, of eleven standing figures and wavy bases that bend like a ball at their
/// base alone by 0.006 to 0.046; beyond 1.2 noises of up to 1 %, 120 balls and eggs by 0.0035, five figures by 0.009 and more.
constexpr double off_quadric = 0.005, noises_off_quadric = 1.2;
/// In diameters: a surface so near to a quadric lies on it. Ellipsoids and eggs have 0 to 0.0005.
constexpr double on_quadric = 0.001, lowest_dome = 0.1;
/// A loop so many times as long as wide is seen as if it were round: else its two ends are no more than a torn share. The ends
/// of a slot along a tube, whose wall does not lean there, are below a tenth of its length from nine widths on.
constexpr double long_loop = 3;

double reach_of(const BoundaryLoop& loop, const LoopFacing& facing) {
  const double edges = edges_of_fit * loop.perimeter / loop.edges();
  return std::max(reach_of_fit * facing.radius, std::min(edges, facing.radius));
}

}  // namespace

void NormalsOfWall::add(const std::vector<Vec3>& centers, const std::vector<Vec3>& normals) {
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

Vec3 NormalsOfWall::rulings() const {
  if (!(weight_ > 0)) return Vec3::Zero();
  const Vec3 mean = sum_ / weight_;
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(squares_ / weight_ - mean * mean.transpose());
  return axes.eigenvectors().col(0);
}

double NormalsOfWall::taper() const {
  const Vec3 direction = rulings();
  return weight_ > 0 ? std::sqrt(std::max(0.0, direction.dot(squares_ * direction) / weight_)) : 0;
}

double NormalsOfWall::turning() const {
  const Vec3 direction = rulings();
  const double spread = direction.dot(spread_ * direction);
  return spread > 0 ? std::abs(direction.dot(turning_ * direction)) / spread : 0;
}

Profiles::Profiles(const SurfaceModel& model, const BoundaryLoop& loop, const LoopFacing& facing)
    : mesh_(model.mesh),
      loop_(loop),
      facing_(facing),
      axis_(facing.onward.dot(facing.axis) < 0 ? Vec3(-facing.axis) : facing.axis),
      reach_(reach_of(loop, facing)) {
  for (std::size_t k = 0; k < loop.vertices.size(); ++k) has_long_edges_ = has_long_edges_ || is_long(k);
  find_longest_direction();
}

Profile Profiles::at(std::size_t k) const {
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

double Profiles::weight_at(std::size_t k) const {
  const std::size_t before = (k + loop_.vertices.size() - 1) % loop_.vertices.size();
  const auto weight = [&](std::size_t edge) {
    const double lengths = has_long_edges_ ? length(edge) / mean_edge() : 1;
    return has_long_edges_ && is_long(edge) ? 0 : lengths * seen_round(edge);
  };
  return (weight(k) + weight(before)) / 2;
}

double Profiles::least_along(Vec3 direction) const {
  if (direction.dot(facing_.onward) < 0) direction = -direction;
  std::vector<Weighted> cosines;
  for (std::size_t k = 0; k < loop_.vertices.size(); ++k)
    cosines.push_back({facing_.edge_conormals[k].dot(direction), length(k)});
  return quantile(std::move(cosines), torn_share);
}

std::vector<double> Profiles::heights() const {
  std::vector<double> result;
  for (const int v : loop_.vertices) result.push_back(axis_.dot(mesh_.point(TriMesh::VertexHandle(v))));
  return result;
}

bool Profiles::flares_at(std::size_t k) const {
  return facing_.conormals[k].dot(facing_.center - mesh_.point(TriMesh::VertexHandle(loop_.vertices[k]))) < 0;
}

void Profiles::add_faces_behind(std::size_t k, NormalsOfWall& wall) const {
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

std::optional<SideSurface> Profiles::quadric() const {
  constexpr std::size_t places = 8;  // along the loop
  std::set<int> near;
  for (std::size_t k = 0; k < places; ++k) {
    const int v = loop_.vertices[k * loop_.vertices.size() / places];
    const std::vector<int> around = within(reach_of_quadric * facing_.radius, v, mesh_.point(TriMesh::VertexHandle(v)));
    near.insert(around.begin(), around.end());
  }
  Points points;
  for (const int v : near) {
    const Vec3& p = mesh_.point(TriMesh::VertexHandle(v));
    if (std::abs(axis_.dot(p - facing_.center)) <= facing_.radius) points.push_back(p);
  }
  return SideSurface::fit(points, axis_, 2 * facing_.radius);
}

bool Profiles::is_near(const SideSurface& surface, double noise) const {
  return surface.rms() <= std::hypot(2 * off_quadric * facing_.radius, noises_off_quadric * noise);
}

bool Profiles::is_closed_by(const SideSurface& surface, double noise, double highest) const {
  const double diameter = 2 * facing_.radius;
  return surface.rms() <= std::hypot(on_quadric * diameter, noises_off_quadric * noise) &&
         surface.kind() == SideSurface::Kind::quadric &&
         surface.changes_sides(facing_.center + lowest_dome * diameter * axis_,
                               facing_.center + highest * diameter * axis_);
}

void Profiles::find_longest_direction() {
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

double Profiles::seen_round(std::size_t k) const {
  constexpr std::size_t beside = 4;
  if (shrunk_ == 1) return 1;
  const std::size_t n = loop_.vertices.size();
  const auto point = [&](std::size_t i) { return mesh_.point(TriMesh::VertexHandle(loop_.vertices[i % n])); };
  const Vec3 chord = (point(k + 1 + beside) - point(k + n - beside)).normalized();
  return (chord - (1 - shrunk_) * longest_.dot(chord) * longest_).norm();
}

double Profiles::length(std::size_t k) const {
  const auto point = [&](std::size_t i) { return mesh_.point(TriMesh::VertexHandle(loop_.vertices[i])); };
  return (point((k + 1) % loop_.vertices.size()) - point(k)).norm();
}

std::vector<int> Profiles::within(double reach, int v, const Vec3& p) const {
  std::vector<int> queue{v};
  std::set<int> seen{v};
  for (std::size_t q = 0; q < queue.size(); ++q)
    for (const auto w : mesh_.vv_range(TriMesh::VertexHandle(queue[q])))
      if ((mesh_.point(w) - p).norm() <= reach && seen.insert(w.idx()).second) queue.push_back(w.idx());
  return queue;
}

std::vector<Vec3> Profiles::behind(int v, const Vec3& p, const Vec3& inward, const Eigen::Vector2d& onward) const {
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

void Profiles::fit(const std::vector<Vec3>& samples, const Eigen::Vector2d& straight, Profile& profile) const {
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

bool Profiles::is_long(std::size_t k) const { return length(k) > long_edge * reach_; }

}  // namespace loopmend
