// SPDX-License-Identifier: GPL-3.0-or-later
#include "mirror/carry_misfit.h"

#include "core/threads.h"

#include <Eigen/Dense>

#include <cmath>

namespace loopmend {

namespace {

constexpr std::size_t most_sites = 500;
constexpr double least_smoothing = 1e-8, most_smoothing = 10, smoothing_step = 4;

/// Every so many, so that at most `most` are left.
void thin(std::vector<std::size_t>& all, std::size_t most) {
  const std::size_t step = (all.size() + most - 1) / std::max<std::size_t>(most, 1);
  if (step <= 1) return;
  std::vector<std::size_t> left;
  for (std::size_t k = 0; k < all.size(); k += step) left.push_back(all[k]);
  all = std::move(left);
}

/// Places in the collar of the vertices that count.
std::vector<std::size_t> chosen_sites(const Patch& patch, const Collar& collar) {
  std::vector<std::size_t> on_loop, beyond;
  for (std::size_t i = 0; i < collar.vertices.size(); ++i)
    (patch.ring[collar.vertices[i]] == 1 ? on_loop : beyond).push_back(i);
  thin(on_loop, most_sites / 2);
  thin(beyond, most_sites - on_loop.size());
  on_loop.insert(on_loop.end(), beyond.begin(), beyond.end());
  return on_loop;
}

/// The rms of that part of the misfit which is independent at each vertex: half of the mean square of its difference
/// along an edge.
double noise_of(const Patch& patch, const MirrorImage& image) {
  std::vector<int> place(patch.vertex_count(), -1);
  for (std::size_t i = 0; i < image.collar.vertices.size(); ++i) place[image.collar.vertices[i]] = static_cast<int>(i);
  const auto misfit = [&](int v) -> Vec3 { return patch.positions[v] - image.nearest[place[v]]; };
  double squares = 0;
  int edges = 0;
  for (std::size_t f = patch.patch_triangles; f < patch.triangles.size(); ++f)
    for (int k = 0; k < 3; ++k) {
      const int a = patch.triangles[f][k], b = patch.triangles[f][(k + 1) % 3];
      if (place[a] < 0 || place[b] < 0) continue;
      squares += (misfit(a) - misfit(b)).squaredNorm();
      ++edges;
    }
  return edges > 0 ? std::sqrt(squares / (2 * edges)) : 0;
}

}  // namespace

bool carry_misfit(const Patch& patch, const CancelToken& cancel, MirrorImage& image) {
  const Collar& collar = image.collar;
  const std::vector<std::size_t> sites = chosen_sites(patch, collar);
  const auto count = static_cast<Eigen::Index>(sites.size());
  Points places;
  Vec3 center = Vec3::Zero();
  for (std::size_t i : sites) {
    places.push_back(patch.positions[collar.vertices[i]]);
    center += places.back() / static_cast<double>(count);
  }
  const auto scaled = [&](const Vec3& p) -> Vec3 { return (p - center) / collar.diameter; };
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(count + 4, count + 4), right = Eigen::MatrixXd::Zero(count + 4, 3);
  for (Eigen::Index i = 0; i < count; ++i) {
    for (Eigen::Index j = 0; j < i; ++j)
      matrix(i, j) = matrix(j, i) = -(places[i] - places[j]).norm() / collar.diameter;
    matrix.block<1, 4>(i, count) << 1, scaled(places[i]).transpose();
    matrix.block<4, 1>(count, i) = matrix.block<1, 4>(i, count).transpose();
    right.row(i) = (places[i] - image.nearest[sites[i]]).transpose();
  }
  // A plane collar leaves the slope across it open.
  matrix.diagonal().tail<3>().array() -= least_smoothing;
  // As smooth as leaves no more of the misfit behind than noise: what noise would carry to the top of a bump is many
  // times the noise.
  const double noise = noise_of(patch, image);
  Eigen::MatrixXd weights;
  for (double smoothing = least_smoothing; smoothing < most_smoothing; smoothing *= smoothing_step) {
    if (cancel.cancelled()) return false;
    matrix.diagonal().head(count).setConstant(smoothing);
    const Eigen::MatrixXd smoother = matrix.partialPivLu().solve(right);
    if (!smoother.allFinite()) break;
    const double left_behind = smoothing * smoother.topRows(count).norm() / std::sqrt(static_cast<double>(count));
    if (smoothing > least_smoothing && left_behind > noise) break;
    weights = smoother;
  }
  if (weights.size() == 0) return false;
  parallel_for(0, static_cast<int>(image.points.size()), 64, [&](int k) {
    Vec3& p = image.points[k];
    const Vec3 q = scaled(p);
    Vec3 move = weights.row(count).transpose();
    for (int c = 0; c < 3; ++c) move += q[c] * weights.row(count + 1 + c).transpose();
    for (Eigen::Index i = 0; i < count; ++i)
      move -= (p - places[i]).norm() / collar.diameter * weights.row(i).transpose();
    p += move;
  });
  return true;
}

}  // namespace loopmend
