// SPDX-License-Identifier: GPL-3.0-or-later
#include "split/continue_relief.h"

#include "core/random.h"
#include "solvers/linear_solver.h"
#include "split/split_surface.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numeric>
#include <utility>
#include <vector>

namespace loopmend {

namespace {

/// ℓ of the filters (1 − ℓ²Δ)⁻¹ between the bands, and of the last one, which takes the curvature of the shape away, in boundary
/// edges: waves of about 2πℓ.
constexpr std::array<double, 4> cutoffs{0.5, 1, 2, 4};
constexpr int adjustments = 2;         ///< of the strength of the random waves
constexpr double outlier = 3;          ///< standard deviations: heights beyond, such as those of creases, count as much
constexpr int last_measured = 4;       ///< ring of the neighborhood; others feel its border
constexpr int away_from_the_seam = 2;  ///< edges from where on the patch is measured
constexpr std::size_t fewest_measured = 20;  ///< vertices of the patch; where there are fewer, all of it is measured
constexpr double least_relief = 0.01;        ///< rms in boundary edges: less is none

using Bands = std::array<Eigen::MatrixXd, 3>;

/// Parts heights above a surface into bands of wavelengths. It reads their Laplacian C f, which the surface itself has as well:
/// f − (1 − ℓ²Δ)⁻¹ f = ℓ² (M + ℓ²C)⁻¹ C f.
class BandFilter {
 public:
  BandFilter(const SplitGeometry& geometry, const Topology& topology, double edge, const CancelToken& cancel)
      : geometry_(geometry) {
    for (std::size_t b = 0; b < cutoffs.size(); ++b) {
      length_[b] = cutoffs[b] * edge;
      solvers_[b] = make_spd_solver();
      valid_ = valid_ &&
               solvers_[b]->factorize(
                   length_[b] * length_[b] * geometry.stiffness + SparseMatrix(geometry.mass.asDiagonal()), cancel);
    }
    inner_ = Eigen::VectorXd::Ones(geometry.mass.size());
    for (int v = 0; v < inner_.size(); ++v)
      if (topology.is_boundary(v)) inner_[v] = 0;
  }

  bool is_valid() const { return valid_; }

  /// @param f  #V by any number of columns
  Bands of_heights(const Eigen::MatrixXd& f) const { return without_shape(parts(geometry_.stiffness * f)); }

  /// Of the surface itself along its normals, #V by 1.
  Bands of_surface(const Points& points) const {
    Eigen::MatrixXd x(static_cast<Eigen::Index>(points.size()), 3), n(x.rows(), 3);
    for (Eigen::Index i = 0; i < x.rows(); ++i) {
      x.row(i) = points[i];
      n.row(i) = geometry_.normals[i];
    }
    return without_shape(parts((geometry_.stiffness * x).cwiseProduct(n).rowwise().sum()));
  }

  /// Of f the waves of one band; the filters are taken twice, which makes them sharper.
  Eigen::VectorXd waves_of(int band, const Eigen::VectorXd& f) const {
    return (band > 0 ? twice(band - 1, f) : f) - twice(band, f);
  }

 private:
  /// Zero where that cannot be solved: the factors are sound, so that only what is not finite leads there.
  Eigen::MatrixXd solve(int filter, const Eigen::MatrixXd& b) const {
    Eigen::MatrixXd x;
    if (!solvers_[filter]->solve(b, x)) return Eigen::MatrixXd::Zero(b.rows(), b.cols());
    return x;
  }

  Eigen::VectorXd twice(int filter, Eigen::VectorXd f) const {
    for (int times = 0; times < 2; ++times) f = solve(filter, geometry_.mass.cwiseProduct(f)).col(0);
    return f;
  }

  Bands parts(const Eigen::MatrixXd& laplacian) const {
    Bands result;
    const Eigen::MatrixXd Cf = inner_.asDiagonal() * laplacian;
    Eigen::MatrixXd finer = Eigen::MatrixXd::Zero(Cf.rows(), Cf.cols());
    for (int b = 0; b < 3; ++b) {
      Eigen::MatrixXd next = length_[b] * length_[b] * solve(b, Cf);
      result[b] = next - finer;
      finer = std::move(next);
    }
    return result;
  }

  Bands without_shape(Bands bands) const {
    for (Eigen::MatrixXd& band : bands) band -= solve(3, geometry_.mass.asDiagonal() * band);
    return bands;
  }

  const SplitGeometry& geometry_;
  Eigen::VectorXd inner_;  ///< 0 at the border
  std::array<double, cutoffs.size()> length_;
  std::array<std::unique_ptr<SpdSolver>, cutoffs.size()> solvers_;
  bool valid_ = true;
};

Eigen::VectorXd random_normal(Eigen::Index size, Random& random) {
  Eigen::VectorXd result(size);
  for (double& x : result) x = random.bell();
  return result;
}

/// a ≥ 0 that brings T a near to v, each row in units of its scale: by coordinate descent.
Eigen::Vector3d nonnegative_solution(const Eigen::Matrix3d& T, const Eigen::Vector3d& v, const Eigen::Vector3d& scale) {
  const Eigen::Vector3d weight = scale.unaryExpr([](double s) { return s > 0 ? 1 / s : 0; });
  const Eigen::Matrix3d A = weight.asDiagonal() * T;
  const Eigen::Vector3d b = weight.cwiseProduct(v);
  Eigen::Vector3d a = Eigen::Vector3d::Zero();
  for (int round = 0; round < 500; ++round)
    for (int c = 0; c < 3; ++c)
      if (const double norm = A.col(c).squaredNorm(); norm > 0) {
        const double gain = A.col(c).dot(b - A * a) / norm;
        a[c] = std::max(0.0, a[c] + gain);
      }
  return a;
}

/// Over the chosen vertices.
double mean_square(const Eigen::VectorXd& f, const Eigen::VectorXd& mass) {
  return mass.size() > 0 ? f.cwiseAbs2().dot(mass) / mass.sum() : 0;
}

/// The same, with what stands out cut off.
double robust_mean_square(const Eigen::VectorXd& f, const Eigen::VectorXd& mass) {
  if (f.size() == 0) return 0;
  std::vector<double> size(static_cast<std::size_t>(f.size()));
  for (std::size_t i = 0; i < size.size(); ++i) size[i] = std::abs(f[static_cast<Eigen::Index>(i)]);
  std::nth_element(size.begin(), size.begin() + static_cast<std::ptrdiff_t>(size.size() / 2), size.end());
  const double limit = outlier * 1.4826 * size[size.size() / 2];
  return mean_square(f.cwiseMax(-limit).cwiseMin(limit), mass);
}

/// Where relief is measured.
struct MeasuredPlaces {
  std::vector<int> neighborhood, patch;
};

MeasuredPlaces measured_places(const Patch& patch, const Topology& topology) {
  MeasuredPlaces places;
  std::vector<char> near(patch.vertex_count(), 0);
  for (int v = patch.free_count; v < patch.vertex_count(); ++v) near[v] = 1;
  for (int ring = 1; ring < away_from_the_seam; ++ring) {
    const std::vector<char> before = near;
    for (int v = 0; v < patch.free_count; ++v)
      for (int w : topology.neighbors(v)) near[v] = near[v] || before[w];
  }
  for (int v = 0; v < patch.vertex_count(); ++v) {
    if (patch.ring[v] >= 1 && patch.ring[v] <= last_measured) places.neighborhood.push_back(v);
    if (!near[v]) places.patch.push_back(v);
  }
  if (places.patch.size() < fewest_measured) {
    places.patch.resize(patch.free_count);
    std::iota(places.patch.begin(), places.patch.end(), 0);
  }
  return places;
}

/// Random waves, band by band, that are 0 on the neighborhood and pass into it without a step or a kink.
class RandomWaves {
 public:
  /// @param U  lower triangle, of the relief's energy ∫((Δ − κ²) f)²
  RandomWaves(const BandFilter& filter, const Eigen::VectorXd& mass, SparseMatrix U, int free,
              const CancelToken& cancel)
      : filter_(filter),
        mass_(mass),
        U_(std::move(U)),
        free_(free) {
    valid_ = solver_->factorize(U_.topLeftCorner(free, free), cancel);
  }

  bool is_valid() const { return valid_; }

  /// #V. Empty where that cannot be solved.
  Eigen::VectorXd draw(int band, Random& random) const {
    const Eigen::VectorXd scale = mass_.cwiseSqrt().cwiseInverse();  // white noise: the same variance for any area
    Eigen::VectorXd waves = filter_.waves_of(band, scale.cwiseProduct(random_normal(mass_.size(), random)));
    // What the energy continues from the neighborhood, if this were the relief there, goes.
    Eigen::VectorXd outside = waves;
    outside.head(free_).setZero();
    const Eigen::VectorXd pull = U_.selfadjointView<Eigen::Lower>() * outside;
    Eigen::MatrixXd continued;
    if (!solver_->solve(-pull.head(free_), continued)) return {};
    waves.head(free_) -= continued.col(0);
    waves.tail(waves.size() - free_).setZero();
    return waves;
  }

 private:
  const BandFilter& filter_;
  const Eigen::VectorXd& mass_;
  SparseMatrix U_;
  int free_;
  std::unique_ptr<SpdSolver> solver_ = make_spd_solver();
  bool valid_ = false;
};

/// Brings random waves to the strength at which the patch has, band by band, what the neighborhood has.
class ReliefFit {
 public:
  ReliefFit(const Patch& patch, const SplitEstimate& estimate, const CancelToken& cancel)
      : patch_(patch),
        edge_(estimate.edge),
        surface_(patch.vertex_count(), patch.triangles),
        topology_(patch.vertex_count(), patch.triangles),
        geometry_(surface_.at(patch.positions)),
        filter_(geometry_, topology_, edge_, cancel),
        waves_(filter_, geometry_.mass, geometry_.roughness(1 / estimate.radius), patch.free_count, cancel),
        at_(measured_places(patch, topology_)) {
    const Bands bands = filter_.of_surface(patch.positions);
    for (int b = 0; b < 3; ++b) {
      around_[b] = robust_mean_square(bands[b].col(0)(at_.neighborhood), geometry_.mass(at_.neighborhood));
      present_[b] = mean_square(bands[b].col(0)(at_.patch), geometry_.mass(at_.patch));
    }
  }

  bool is_valid() const { return filter_.is_valid() && waves_.is_valid(); }
  const Eigen::Vector3d& around() const { return around_; }
  const Eigen::Vector3d& present() const { return present_; }

  /// Positions of the patch's vertices; empty where that cannot be solved. present() is theirs then.
  Points draw(Random& random, const CancelToken& cancel) {
    std::array<Eigen::VectorXd, 3> drawn;
    Eigen::Matrix3d unit;  // (b, c): mean square in band b of waves c
    for (int c = 0; c < 3; ++c) {
      drawn[c] = waves_.draw(c, random);
      if (drawn[c].size() == 0) return {};
      const Bands parts = filter_.of_heights(drawn[c]);
      for (int b = 0; b < 3; ++b) unit(b, c) = mean_square(parts[b].col(0)(at_.patch), geometry_.mass(at_.patch));
    }
    Points rough = patch_.positions;
    Eigen::Vector3d aim = Eigen::Vector3d::Zero();
    for (int round = 0; round < adjustments;
         ++round) {  // the strength of a rough surface is not quite that of its heights
      if (cancel.cancelled()) return {};
      aim += around_ - present_;
      const Eigen::Vector3d strength = nonnegative_solution(unit, aim, around_);
      for (int i = 0; i < patch_.free_count; ++i) {
        double height = 0;
        for (int c = 0; c < 3; ++c) height += std::sqrt(strength[c]) * drawn[c][i];
        rough[i] = patch_.positions[i] + height * geometry_.normals[i];
      }
      const SplitGeometry geometry = surface_.at(rough);
      const BandFilter filter(geometry, topology_, edge_, cancel);
      if (!filter.is_valid()) return {};
      const Bands bands = filter.of_surface(rough);
      for (int b = 0; b < 3; ++b) present_[b] = mean_square(bands[b].col(0)(at_.patch), geometry.mass(at_.patch));
    }
    rough.resize(patch_.free_count);
    return rough;
  }

 private:
  const Patch& patch_;
  double edge_;
  SplitSurface surface_;
  Topology topology_;
  SplitGeometry geometry_;
  BandFilter filter_;
  RandomWaves waves_;
  MeasuredPlaces at_;
  Eigen::Vector3d around_, present_;  ///< mean squares, band by band
};

}  // namespace

std::optional<ContinuedRelief> continue_relief(const Patch& patch, const SplitEstimate& estimate, std::uint64_t seed,
                                               const CancelToken& cancel) {
  if (patch.free_count == 0 || !(estimate.edge > 0) || !(estimate.radius > 0)) return std::nullopt;
  ReliefFit fit(patch, estimate, cancel);
  if (!fit.is_valid() || fit.around().maxCoeff() < std::pow(least_relief * estimate.edge, 2)) return std::nullopt;
  Random random(seed);
  ContinuedRelief result;
  result.positions = fit.draw(random, cancel);
  if (result.positions.empty()) return std::nullopt;
  for (int b = 0; b < 3; ++b) {
    result.around[b] = std::sqrt(fit.around()[b]);
    result.patch[b] = std::sqrt(fit.present()[b]);
  }
  return result;
}

}  // namespace loopmend
