// SPDX-License-Identifier: GPL-3.0-or-later
#include "split/split_estimate.h"

#include "core/quantile.h"
#include "core/threads.h"
#include "solvers/linear_solver.h"
#include "split/block_matrix.h"
#include "split/split_surface.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <memory>
#include <mutex>
#include <numbers>
#include <tuple>
#include <utility>
#include <vector>

namespace loopmend {

namespace {

constexpr double least_noise = 1e-4;  ///< below, in boundary edges, the split form comes no closer than the flow itself
constexpr double coarsest_relief = 1.5;  ///< largest reported ℓ of the relief, in boundary edges
constexpr double free_relief = 1.0 / 8;  ///< κ of the estimate, per radius: the relief's own mean hardly counts
/// Heights of relief and noise on smooth surfaces, in edges, over (edge ‖A‖)³: at most 0.013 around holes in even and
/// uneven spheres, 0.016 in cylinders, for edges of 0.04 to 0.2 radii.
constexpr double error_of_cubics = 0.03;
constexpr double resolved = 0.25;  ///< edge ‖A‖: coarser meshes do not tell
constexpr int least_rank = 12;
constexpr int most_vertices = 1000;

double s2_of(double w, double v) { return v > 0 ? std::pow(v, 6) / (w * w) + std::pow(v, 4) : 0; }

/// The neighborhood by itself, renumbered; of large ones the vertices around some stretches of the boundary.
struct Collar {
  Points points;
  Triangles triangles;
};

/// Vertices within the patch's rings of stretches of the boundary, evenly spread, as long as there are not too many.
std::vector<char> near_some_of_the_boundary(const Patch& patch, const Topology& around) {
  std::vector<int> boundary;
  for (const auto& loop : patch.loops) boundary.insert(boundary.end(), loop.begin(), loop.end());
  const int fixed = patch.vertex_count() - patch.free_count, size = static_cast<int>(boundary.size());
  std::vector<char> chosen(patch.vertex_count(), 1);
  if (fixed <= most_vertices) return chosen;
  constexpr int stretches = 4;
  const double share = static_cast<double>(most_vertices) / fixed;
  std::vector<int> front;
  std::fill(chosen.begin(), chosen.end(), 0);
  for (int k = 0; k < size; ++k)
    if (std::fmod(static_cast<double>(k) * stretches / size, 1) < share && !std::exchange(chosen[boundary[k]], 1))
      front.push_back(boundary[k]);
  for (int ring = 0; ring < patch_rings && !front.empty(); ++ring) {
    std::vector<int> next;
    for (int v : front)
      for (int w : around.neighbors(v))
        if (patch.ring[w] == ring + 2 && !std::exchange(chosen[w], 1)) next.push_back(w);
    front = std::move(next);
  }
  return chosen;
}

Collar collar_of(const Patch& patch) {
  const Triangles all(patch.triangles.begin() + patch.patch_triangles, patch.triangles.end());
  const std::vector<char> chosen = near_some_of_the_boundary(patch, Topology(patch.vertex_count(), all));
  Collar collar;
  std::vector<int> index(patch.vertex_count(), -1);
  for (Triangle t : all) {
    if (!chosen[t[0]] || !chosen[t[1]] || !chosen[t[2]]) continue;
    for (int& v : t) {
      if (index[v] < 0) {
        index[v] = static_cast<int>(collar.points.size());
        collar.points.push_back(patch.positions[v]);
      }
      v = index[v];
    }
    collar.triangles.push_back(t);
  }
  return collar;
}

/// Half of the greatest distance across a loop, the most over the loops.
double radius_of(const Patch& patch) {
  double squared = 0;
  for (const auto& loop : patch.loops)
    for (int a : loop)
      for (int b : loop) squared = std::max(squared, (patch.positions[a] - patch.positions[b]).squaredNorm());
  return std::sqrt(squared) / 2;
}

double mean_boundary_edge(const Patch& patch) {
  double length = 0;
  std::size_t edges = 0;
  for (const auto& loop : patch.loops) {
    for (std::size_t k = 0; k < loop.size(); ++k)
      length += (patch.positions[loop[k]] - patch.positions[loop[(k + 1) % loop.size()]]).norm();
    edges += loop.size();
  }
  return edges > 0 ? length / static_cast<double>(edges) : 0;
}

/// −2 log of the restricted likelihood as a function of the two wavelengths, its scale taken out. To first order about the
/// neighborhood as it is: H = H₀ + Bφ for the smooth surface at displacement φ, and φ + z + e = 0.
class Likelihood {
 public:
  Likelihood(const SplitSurface& surface, const Points& points, double edge, double radius)
      : edge_(edge),
        freedom_(surface.rank()) {
    const SplitGeometry geometry = surface.at(points);
    mass_ = geometry.mass;
    const Eigen::VectorXd& bent = geometry.curvature.bent;
    const double curvature = std::sqrt(median(std::vector<double>(bent.begin(), bent.end())));
    if (edge * curvature < resolved) resolution_ = error_of_cubics * std::pow(edge * curvature, 3);
    stiffness_ = geometry.stiffness;
    parallel_invoke([&] { Q_ = 4 * geometry.hessian(); }, [&] { S_ = geometry.roughness(free_relief / radius); });
    gradient_ = 4 * geometry.half_gradient();
    energy_ = 4 * geometry.variation();
    const auto solver = make_spd_solver();
    valid_ = solver->factorize(S_);
    if (valid_) log_S_ = solver->log_determinant();
  }

  /// In boundary edges: the cubics leave fourth derivatives over, which are of the order of the third power of the curvature.
  double resolution() const { return resolution_; }
  bool is_valid() const { return valid_ && std::isfinite(energy_); }

  /// @param w, v  in boundary edges; v = 0: no noise. @returns infinity where it is unknown.
  double operator()(double w, double v, SpdSolver& solver) const { return at(w, v, solver).value; }

  struct Heights {
    double relief = 0, noise = 0;  ///< rms
  };
  /// Infinite where the split cannot be made: nothing then says that the neighborhood is smooth.
  Heights heights(double w, double v, SpdSolver& solver) const {
    const Split split = at(w, v, solver);
    if (split.value == unknown) return {unknown, 0};
    const auto rms = [&](const Eigen::VectorXd& f) {
      return f.size() > 0 ? std::sqrt(f.cwiseAbs2().dot(mass_) / mass_.sum()) : 0;
    };
    return {rms(fine_part(split.r)), rms(split.e)};
  }

 private:
  static constexpr double unknown = std::numeric_limits<double>::infinity();
  static constexpr double rounding =
      std::numeric_limits<double>::epsilon() * std::numeric_limits<double>::epsilon();  ///< squared angle

  /// What (1 − ℓ²Δ)⁻¹ takes away: the relief's waves of less than about ten edges. Longer ones may as well be shape.
  Eigen::VectorXd fine_part(const Eigen::VectorXd& r) const {
    const double length = coarsest_relief * edge_;
    const SparseMatrix A = length * length * stiffness_ + SparseMatrix(mass_.asDiagonal());
    const auto solver = make_spd_solver();
    Eigen::MatrixXd smooth;
    if (!solver->factorize(A) || !solver->solve(mass_.cwiseProduct(r), smooth)) return r;
    return r - smooth.col(0);
  }

  struct Split {
    double value = unknown;
    Eigen::VectorXd r, e;
  };

  Split at(double w, double v, SpdSolver& solver) const {
    const double lambda = w * w * edge_ * edge_;
    return v > 0 ? with_noise(lambda, s2_of(w * edge_, v * edge_), solver) : without_noise(lambda, solver);
  }

  Split without_noise(double lambda, SpdSolver& solver) const {
    const SparseMatrix A = lambda * Q_ + S_;
    Eigen::MatrixXd phi;
    if (!solver.factorize(A) || !solver.solve(-lambda * gradient_, phi)) return {};
    const Eigen::VectorXd r = -phi.col(0);
    const double J = smooth_part(lambda, phi.col(0)) + form(S_, r);
    return {criterion(J, lambda, solver.log_determinant() - log_S_), r, {}};
  }

  Split with_noise(double lambda, double s2, SpdSolver& solver) const {
    const Eigen::Index n = mass_.size();
    const Eigen::VectorXd precision = mass_ / s2;
    const SparseMatrix W(precision.asDiagonal());
    const SparseMatrix A = lower_blocks(lambda * Q_ + W, W, S_ + W);
    Eigen::VectorXd b = Eigen::VectorXd::Zero(2 * n);
    b.head(n) = -lambda * gradient_;
    Eigen::MatrixXd solution;
    if (!solver.factorize(A) || !solver.solve(b, solution)) return {};
    const Eigen::VectorXd phi = solution.col(0).head(n), r = solution.col(0).tail(n), e = -phi - r;
    const double J = smooth_part(lambda, phi) + form(S_, r) + e.dot(precision.cwiseProduct(e));
    return {criterion(J, lambda, solver.log_determinant() - log_S_ - precision.array().log().sum()), r, e};
  }

  static double form(const SparseMatrix& lower, const Eigen::VectorXd& x) {
    return x.dot(lower.selfadjointView<Eigen::Lower>() * x);
  }
  double smooth_part(double lambda, const Eigen::VectorXd& phi) const {
    return lambda * (energy_ + 2 * gradient_.dot(phi) + form(Q_, phi));
  }
  double criterion(double J, double lambda, double log_determinants) const {
    const double residual = std::max(J / freedom_, rounding);  // a plane of whole numbers leaves none at all
    const double value = freedom_ * std::log(residual) + log_determinants - freedom_ * std::log(lambda);
    return std::isfinite(value) ? value : unknown;
  }

  SparseMatrix Q_, S_, stiffness_;
  Eigen::VectorXd gradient_, mass_;
  double edge_, freedom_, energy_ = 0, log_S_ = 0, resolution_ = 0;
  bool valid_ = false;
};

/// Solvers for matrices of one pattern, which is analyzed once for each that works at the same time.
class Solvers {
 public:
  struct GiveBack {
    Solvers* to;
    void operator()(SpdSolver* solver) const {
      const std::lock_guard lock(to->mutex_);
      to->idle_.push_back(solver);
    }
  };
  using Lent = std::unique_ptr<SpdSolver, GiveBack>;

  /// One that is idle, or a new one.
  Lent one() {
    const std::lock_guard lock(mutex_);
    if (idle_.empty()) {
      idle_.reserve(all_.size() + 1);  // giving back must not fail
      all_.push_back(make_spd_solver());
      idle_.push_back(all_.back().get());
    }
    Lent lent(idle_.back(), {this});
    idle_.pop_back();
    return lent;
  }

 private:
  std::mutex mutex_;
  std::vector<std::unique_ptr<SpdSolver>> all_;
  std::vector<SpdSolver*> idle_;
};

/// The least of a function of two wavelengths: a coarse table, then halves and doubles of the best.
class Search {
 public:
  Search(const Likelihood& likelihood, const CancelToken& cancel) : likelihood_(likelihood), cancel_(cancel) {}

  std::pair<double, double> best() {
    std::vector<Place> row;
    for (double w : {0.01, 0.1, 0.4, 1.6, 6.4, 25.0}) row.emplace_back(w, 0);
    ask(row);
    row = {{0.01, 0.5}, {0.4, 0.5}, {6.4, 0.5}};
    double less_noise = 0;
    while (!row.empty()) {  // more noise where the noise before it made the likelihood greater
      ask(row);
      std::erase_if(row, [&](const Place& place) {
        return place.second >= most_noise || known_[place] >= known_[{place.first, less_noise}];
      });
      if (!row.empty()) less_noise = row.front().second;
      for (Place& place : row) place.second *= 2;
    }
    for (int round = 0; round < most_rounds; ++round) {
      const auto [w, v] = least();
      std::vector<Place> places{{2 * w, v}, {w / 2, v}};
      if (v > 0) places.insert(places.end(), {{w, v * std::numbers::sqrt2}, {w, v / std::numbers::sqrt2}});
      ask(places);
      if (least() == Place(w, v)) break;
    }
    return least();
  }

  Likelihood::Heights heights(double w, double v) { return likelihood_.heights(w, v, *solvers_[v > 0].one()); }

 private:
  using Place = std::pair<double, double>;
  static constexpr int most_rounds = 4;
  static constexpr double most_noise = 4;  ///< of the table

  /// Side by side; those without noise have one pattern, those with noise another.
  void ask(const std::vector<Place>& places) {
    std::vector<Place> of_kind[2];
    for (const Place& place : places)
      if (!known_.contains(place)) of_kind[place.second > 0].push_back(place);
    for (int kind : {0, 1}) {
      const std::vector<Place>& asked = of_kind[kind];
      std::vector<double> values(asked.size(), std::numeric_limits<double>::infinity());
      parallel_for(0, static_cast<int>(asked.size()), 1, [&](int k) {
        if (!cancel_.cancelled()) values[k] = likelihood_(asked[k].first, asked[k].second, *solvers_[kind].one());
      });
      for (std::size_t k = 0; k < asked.size(); ++k) known_[asked[k]] = values[k];
    }
  }

  Place least() const {
    return std::min_element(known_.begin(), known_.end(),
                            [](const auto& a, const auto& b) { return a.second < b.second; })
        ->first;
  }

  const Likelihood& likelihood_;
  const CancelToken& cancel_;
  std::map<Place, double> known_;
  Solvers solvers_[2];  ///< without noise, with noise
};

}  // namespace

double SplitEstimate::noise_variance() const { return s2_of(relief * edge, noise * edge); }

const char* to_string(NeighborhoodKind neighborhood) {
  switch (neighborhood) {
    case NeighborhoodKind::smooth: return "smooth";
    case NeighborhoodKind::noisy: return "noisy";
    case NeighborhoodKind::rough: return "rough";
  }
  return "";
}

NeighborhoodKind SplitEstimate::kind() const {
  if (is_exact()) return NeighborhoodKind::smooth;
  return noise_height > relief_height ? NeighborhoodKind::noisy : NeighborhoodKind::rough;
}

bool SplitEstimate::is_exact(double relief_limit) const {
  const double limit = std::max(relief_limit, resolution);
  return relief_height <= limit * edge && noise_height <= std::max(limit, least_noise) * edge;
}

SplitEstimate estimate_split(const Patch& patch, const CancelToken& cancel) {
  SplitEstimate estimate;
  estimate.edge = mean_boundary_edge(patch);
  estimate.radius = radius_of(patch);
  if (!(estimate.edge > 0) || !(estimate.radius > 0)) return estimate;
  Collar collar = collar_of(patch);
  const SplitSurface surface(static_cast<int>(collar.points.size()), std::move(collar.triangles));
  if (surface.rank() < least_rank) return estimate;
  const Likelihood likelihood(surface, collar.points, estimate.edge, estimate.radius);
  if (!likelihood.is_valid()) {
    estimate.relief_height = std::numeric_limits<double>::infinity();  // nothing says that it is smooth
    return estimate;
  }
  estimate.resolution = likelihood.resolution();
  Search search(likelihood, cancel);
  std::tie(estimate.relief, estimate.noise) = search.best();
  const Likelihood::Heights heights = search.heights(estimate.relief, estimate.noise);
  estimate.relief_height = heights.relief;
  estimate.noise_height = heights.noise;
  return estimate;
}

}  // namespace loopmend
