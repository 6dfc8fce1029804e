// SPDX-License-Identifier: GPL-3.0-or-later
#include "operators/operator_set.h"

#include "core/threads.h"
#include "known_surfaces.h"
#include "samples/analytic_surfaces.h"
#include "surfaces/roughen.h"

#include <gtest/gtest.h>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <functional>
#include <tuple>
#include <vector>

namespace loopmend {
namespace {

struct Analytic {
  double H, K;
  Vec3 normal;
};

struct Errors {
  double H = 0, K = 0, laplacian = 0, gradient = 0, diamond = 0;
};

/// f = x + 2y² on a surface: analytic operators through the ambient derivatives and the shape operator.
double function_value(const Vec3& p) { return p.x() + 2 * p.y() * p.y(); }

struct Surface {
  std::function<Analytic(const Vec3&)> at;
  std::function<Eigen::Matrix3d(const Vec3&)> shape;  ///< S as a map of 3-space that is 0 on the normal
};

/// Rms errors over vertices that are at least two rings from a boundary.
Errors errors_on(const TriangleSoup& soup, const Surface& surface, Stencil stencil) {
  const int n = static_cast<int>(soup.points.size());
  const Topology topology(n, soup.triangles);
  const OperatorSet ops = compute_operators(soup.points, soup.triangles, topology, stencil, std::vector<char>(n, 1));
  Eigen::VectorXd f(n);
  for (int i = 0; i < n; ++i) f[i] = function_value(soup.points[i]);
  Errors sum;
  int count = 0;
  std::vector<int> ring;
  std::vector<char> mark(n, 0);
  for (int i = 0; i < n; ++i) {
    topology.k_ring(i, 2, ring, mark);
    bool inner = !topology.is_boundary(i);
    for (int j : ring) inner = inner && !topology.is_boundary(j);
    if (!inner) continue;
    EXPECT_TRUE(ops.valid[i]);
    const Vec3& p = soup.points[i];
    const Analytic exact = surface.at(p);
    const Eigen::Matrix3d tangent = Eigen::Matrix3d::Identity() - exact.normal * exact.normal.transpose();
    const Vec3 ambient(1, 4 * p.y(), 0);
    const Vec3 gradient = tangent * ambient;
    const Vec3 diamond = 2 * exact.H * gradient - surface.shape(p) * gradient;
    // Δf = trace of the tangential Hessian + 2H ∂f/∂n
    const double laplacian = 4 * tangent(1, 1) + 2 * exact.H * exact.normal.dot(ambient);
    sum.H += std::pow(ops.H[i] - exact.H, 2);
    sum.K += std::pow(ops.K[i] - exact.K, 2);
    sum.laplacian += std::pow(ops.apply_laplacian(i, f) - laplacian, 2);
    sum.gradient += (ops.apply_gradient(i, f) - gradient).squaredNorm();
    sum.diamond += (ops.apply_diamond(i, f) - diamond).squaredNorm();
    ++count;
  }
  for (double* value : {&sum.H, &sum.K, &sum.laplacian, &sum.gradient, &sum.diamond})
    *value = std::sqrt(*value / count);
  return sum;
}

Surface sphere() {
  return {[](const Vec3& p) {
            return Analytic{-1, 1, p.normalized()};
          },
          [](const Vec3& p) -> Eigen::Matrix3d {
            const Vec3 n = p.normalized();
            return -(Eigen::Matrix3d::Identity() - n * n.transpose());
          }};
}

/// Torus of radii 2 and 0.7.
Surface torus() {
  const auto frame = [](const Vec3& p) {
    const Vec3 axis(p.x() / std::hypot(p.x(), p.y()), p.y() / std::hypot(p.x(), p.y()), 0);
    const Vec3 n = (p - 2 * axis).normalized();
    return std::tuple(n, Vec3(-axis.y(), axis.x(), 0), n.dot(axis) / (2 + 0.7 * n.dot(axis)));
  };
  return {[=](const Vec3& p) {
            const auto [n, along, around] = frame(p);
            return Analytic{-(1 / 0.7 + around) / 2, around / 0.7, n};
          },
          [=](const Vec3& p) -> Eigen::Matrix3d {
            const auto [n, along, around] = frame(p);
            const Vec3 across = n.cross(along);
            return -(around * along * along.transpose() + 1 / 0.7 * across * across.transpose());
          }};
}

Surface cylinder() {
  return {[](const Vec3& p) {
            return Analytic{-0.5, 0, Vec3(p.x(), p.y(), 0).normalized()};
          },
          [](const Vec3& p) -> Eigen::Matrix3d {
            const Vec3 along = Vec3(-p.y(), p.x(), 0).normalized();
            return -along * along.transpose();
          }};
}

Surface catenoid() {
  const auto normal = [](const Vec3& p) {
    const double radius = std::hypot(p.x(), p.y());
    return Vec3(p.x() / radius, p.y() / radius, -std::sinh(p.z())).normalized();
  };
  const auto curvature = [](const Vec3& p) { return 1 / std::pow(std::cosh(p.z()), 2); };
  return {[=](const Vec3& p) {
            return Analytic{0, -std::pow(curvature(p), 2), normal(p)};
          },
          [=](const Vec3& p) -> Eigen::Matrix3d {
            const Vec3 n = normal(p), along = Vec3(-p.y(), p.x(), 0).normalized(), across = n.cross(along);
            return curvature(p) * (across * across.transpose() - along * along.transpose());
          }};
}

double order(double coarse, double fine) { return std::log2(coarse / fine); }

/// Halving the edge length must at least divide each error by 2^least.
void expect_order(const Errors& coarse, const Errors& fine, double least, const char* what) {
  EXPECT_GT(order(coarse.H, fine.H), least) << what << " H " << coarse.H << " " << fine.H;
  EXPECT_GT(order(coarse.K, fine.K), least) << what << " K " << coarse.K << " " << fine.K;
  EXPECT_GT(order(coarse.laplacian, fine.laplacian), least)
      << what << " Δ " << coarse.laplacian << " " << fine.laplacian;
  EXPECT_GT(order(coarse.gradient, fine.gradient), least) << what << " ∇ " << coarse.gradient << " " << fine.gradient;
  EXPECT_GT(order(coarse.diamond, fine.diamond), least) << what << " ◇ " << coarse.diamond << " " << fine.diamond;
}

class OperatorConvergence : public testing::TestWithParam<Stencil> {};
INSTANTIATE_TEST_SUITE_P(Stencils, OperatorConvergence, testing::Values(Stencil::two_ring, Stencil::two_ring_cubic));

TEST_P(OperatorConvergence, SecondOrderOnRegularTorus) {
  expect_order(errors_on(make_torus(2, 0.7, 60, 21), torus(), GetParam()),
               errors_on(make_torus(2, 0.7, 120, 42), torus(), GetParam()), 1.6, "torus");
}

TEST_P(OperatorConvergence, SecondOrderOnRegularCylinder) {
  expect_order(errors_on(make_cylinder(2, 30), cylinder(), GetParam()),
               errors_on(make_cylinder(2, 60), cylinder(), GetParam()), 1.7, "cylinder");
}

TEST_P(OperatorConvergence, FirstOrderOnIrregularSphere) {
  const auto mesh = [](int level) {
    return roughen(make_icosphere(level), 0.2, 0.25, 7, [](const Vec3& p) { return Vec3(p.normalized()); });
  };
  expect_order(errors_on(mesh(4), sphere(), GetParam()), errors_on(mesh(5), sphere(), GetParam()), 0.75, "sphere");
}

TEST_P(OperatorConvergence, FirstOrderOnIrregularCatenoid) {
  const auto on_catenoid = [](const Vec3& p) {
    const double radius = std::hypot(p.x(), p.y());
    return Vec3(p.x() / radius * std::cosh(p.z()), p.y() / radius * std::cosh(p.z()), p.z());
  };
  const auto mesh = [&](int around) {
    return roughen(make_revolution([](double z) { return std::cosh(z); }, -1, 1, around, around / 3), 0.15, 0.2, 3,
                   on_catenoid);
  };
  const Errors coarse = errors_on(mesh(48), catenoid(), GetParam()), fine = errors_on(mesh(96), catenoid(), GetParam());
  EXPECT_GT(order(coarse.H, fine.H), 0.7) << coarse.H << " " << fine.H;
  EXPECT_GT(order(coarse.K, fine.K), 0.7) << coarse.K << " " << fine.K;
  EXPECT_LT(fine.H, 0.02);
}

/// Gradient and Hessian of a function that is 0 on a surface and grows outwards.
struct Level {
  Vec3 gradient;
  Eigen::Matrix3d hessian;
};

/// S = −P F″ P / ‖∇F‖ with P the projection onto the tangent plane.
Surface level_surface(const std::function<Level(const Vec3&)>& level) {
  const auto shape = [=](const Vec3& p) -> Eigen::Matrix3d {
    const Level F = level(p);
    const Vec3 n = F.gradient.normalized();
    const Eigen::Matrix3d P = Eigen::Matrix3d::Identity() - n * n.transpose();
    return -P * F.hessian * P / F.gradient.norm();
  };
  const auto at = [=](const Vec3& p) {
    const Eigen::Matrix3d S = shape(p);
    return Analytic{S.trace() / 2, (S.trace() * S.trace() - (S * S).trace()) / 2, level(p).gradient.normalized()};
  };
  return {at, shape};
}

/// F = ρ − r(z) about the z axis; `profile` gives r′ and r″ at a point.
Surface revolved(const std::function<Eigen::Vector2d(const Vec3&)>& profile) {
  return level_surface([=](const Vec3& p) {
    const double radius = std::hypot(p.x(), p.y());
    const Vec3 out(p.x() / radius, p.y() / radius, 0), along(-out.y(), out.x(), 0);
    const Eigen::Vector2d r = profile(p);
    Level F{out - r[0] * Vec3::UnitZ(), along * along.transpose() / radius};
    F.hessian(2, 2) = -r[1];
    return F;
  });
}

struct Case {
  const char* name;
  std::function<bench::KnownSurface(int)> mesh;  ///< for 1, and with half the edge length for 2
  Surface exact;
};

std::vector<Case> all_surfaces() {
  constexpr double minor = 0.4, bulge = 0.4;
  const auto sphere = level_surface([](const Vec3& p) { return Level{p, Eigen::Matrix3d::Identity()}; });
  const auto torus = level_surface([](const Vec3& p) {
    const double radius = std::hypot(p.x(), p.y());
    const Vec3 out(p.x() / radius, p.y() / radius, 0), along(-out.y(), out.x(), 0);
    Level F{(radius - 1) * out + p.z() * Vec3::UnitZ(), out * out.transpose()};
    F.hessian += (1 - 1 / radius) * along * along.transpose() + Vec3::UnitZ() * Vec3::UnitZ().transpose();
    return F;
  });
  // First integral r / w − r² / 2 = (1 − bulge²) / 2 with w = √(1 + r′²); between neck and bulge r′ > 0.
  const auto unduloid = revolved([](const Vec3& p) {
    const double r = std::hypot(p.x(), p.y()), w = r / ((1 - bulge * bulge) / 2 + r * r / 2);
    return Eigen::Vector2d(std::sqrt(std::max(0.0, w * w - 1)), w * w / r - w * w * w);
  });
  const auto graph = level_surface([](const Vec3& p) {
    const double sx = std::sin(2 * p.x()), cx = std::cos(2 * p.x());
    const double sy = std::sin(1.5 * p.y()), cy = std::cos(1.5 * p.y());
    Level F{Vec3(-0.6 * cx * cy - 0.2 * p.x(), 0.45 * sx * sy, 1), Eigen::Matrix3d::Zero()};
    F.hessian(0, 0) = 1.2 * sx * cy - 0.2;
    F.hessian(0, 1) = F.hessian(1, 0) = 0.9 * cx * sy;
    F.hessian(1, 1) = 0.675 * sx * cy;
    return F;
  });
  return {{"sphere", [](int k) { return bench::known_sphere(12 * k); }, sphere},
          {"cylinder", [](int k) { return bench::known_cylinder(2, 48 * k); },
           revolved([](const Vec3&) { return Eigen::Vector2d(0, 0); })},
          {"torus", [](int k) { return bench::known_torus(minor, 80 * k); }, torus},
          {"catenoid", [](int k) { return bench::known_catenoid(1.2, 48 * k); },
           revolved([](const Vec3& p) { return Eigen::Vector2d(std::sinh(p.z()), std::cosh(p.z())); })},
          {"unduloid", [](int k) { return bench::known_unduloid(bulge, 1.4, 48 * k); }, unduloid},
          {"graph", [](int k) { return bench::known_graph(24 * k); }, graph}};
}

class Convergence : public testing::TestWithParam<std::tuple<int, bench::MeshKind>> {};
INSTANTIATE_TEST_SUITE_P(SurfacesAndMeshes, Convergence,
                         testing::Combine(testing::Range(0, 6),
                                          testing::Values(bench::MeshKind::regular, bench::MeshKind::jittered,
                                                          bench::MeshKind::irregular)));

TEST_P(Convergence, OfTwoRingFits) {
  const Case surface = all_surfaces()[std::get<0>(GetParam())];
  const bench::MeshKind kind = std::get<1>(GetParam());
  const auto errors = [&](int k) {
    return errors_on(bench::with_mesh(surface.mesh(k), kind, 5).mesh, surface.exact, Stencil::two_ring);
  };
  const double least = kind == bench::MeshKind::regular ? 1.6 : 0.8;  // an icosphere is nearly regular
  expect_order(errors(1), errors(2), least, surface.name);
}

/// Cubic fits win an order for H and Δ, the two that the energy stands on.
TEST(CubicFits, SecondOrderOnIrregularMeshesToo) {
  const auto project = [](const Vec3& p) {
    const double radius = std::hypot(p.x(), p.y());
    const Vec3 center(2 * p.x() / radius, 2 * p.y() / radius, 0);
    return Vec3(center + 0.7 * (p - center).normalized());
  };
  const auto mesh = [&](int around) {
    return roughen(make_torus(2, 0.7, around, around * 7 / 20), 0.2, 0.25, 7, project);
  };
  const Errors coarse = errors_on(mesh(80), torus(), Stencil::two_ring_cubic);
  const Errors fine = errors_on(mesh(160), torus(), Stencil::two_ring_cubic);
  EXPECT_GT(order(coarse.H, fine.H), 1.7) << coarse.H << " " << fine.H;
  EXPECT_GT(order(coarse.K, fine.K), 1.7) << coarse.K << " " << fine.K;
  EXPECT_GT(order(coarse.laplacian, fine.laplacian), 1.7) << coarse.laplacian << " " << fine.laplacian;
  EXPECT_LT(fine.H, 0.25 * errors_on(mesh(160), torus(), Stencil::two_ring).H);
}

TEST(Operators, InvariantUnderRotationTranslationScaling) {
  // Paper, Theorem 3.2.
  const TriangleSoup soup = roughen(make_torus(2, 0.7, 40, 14), 0.15, 0.2, 5, [](const Vec3& p) {
    const Vec3 axis(2 * p.x() / std::hypot(p.x(), p.y()), 2 * p.y() / std::hypot(p.x(), p.y()), 0);
    return Vec3(axis + 0.7 * (p - axis).normalized());
  });
  const Eigen::Matrix3d R = Eigen::AngleAxisd(1.1, Vec3(1, -2, 0.5).normalized()).toRotationMatrix();
  constexpr double scale = 137;
  Points moved;
  for (const Vec3& p : soup.points) moved.push_back(scale * (R * p) + Vec3(5, -3, 40));
  const int n = static_cast<int>(soup.points.size());
  const Topology topology(n, soup.triangles);
  const std::vector<char> all(n, 1);
  const OperatorSet a = compute_operators(soup.points, soup.triangles, topology, Stencil::two_ring, all);
  const OperatorSet b = compute_operators(moved, soup.triangles, topology, Stencil::two_ring, all);
  Eigen::VectorXd f(n);
  for (int i = 0; i < n; ++i) f[i] = function_value(soup.points[i]);
  for (int i = 0; i < n; ++i) {
    ASSERT_NEAR(b.H[i] * scale, a.H[i], 1e-8);
    ASSERT_NEAR(b.K[i] * scale * scale, a.K[i], 1e-7);
    ASSERT_NEAR(b.apply_laplacian(i, f) * scale * scale, a.apply_laplacian(i, f), 1e-6);
    ASSERT_LT((b.apply_diamond(i, f) * scale * scale - R * a.apply_diamond(i, f)).norm(), 1e-7);
  }
}

TEST(Operators, WeightsAnnihilateConstants) {
  const TriangleSoup soup = make_icosphere(3);
  const int n = static_cast<int>(soup.points.size());
  const OperatorSet ops = compute_operators(soup.points, soup.triangles, Topology(n, soup.triangles), Stencil::two_ring,
                                            std::vector<char>(n, 1));
  const Eigen::VectorXd one = Eigen::VectorXd::Ones(n);
  for (int i = 0; i < n; ++i) {
    EXPECT_NEAR(ops.apply_laplacian(i, one), 0, 1e-9);
    EXPECT_LT(ops.apply_gradient(i, one).norm(), 1e-10);
  }
}

void expect_same_curvatures(const OperatorSet& a, const OperatorSet& b) {
  EXPECT_TRUE(a.H == b.H);
  EXPECT_TRUE(a.K == b.K);
  EXPECT_EQ(a.normal, b.normal);
  EXPECT_EQ(a.valid, b.valid);
  EXPECT_EQ(a.second_form, b.second_form);
}

TEST(Operators, CurvaturesAloneAreTheSameToTheBit) {
  const TriangleSoup soup = roughen(make_icosphere(3), 0.2, 0.25, 3, [](const Vec3& p) { return p.normalized(); });
  const int n = static_cast<int>(soup.points.size());
  const Topology topology(n, soup.triangles);
  std::vector<char> wanted(n, 1);
  for (int i = 0; i < n; i += 7) wanted[i] = 0;
  for (Stencil stencil : {Stencil::two_ring, Stencil::two_ring_cubic}) {
    const OperatorSet all = compute_operators(soup.points, soup.triangles, topology, stencil, wanted);
    const OperatorSet some = compute_curvatures(soup.points, soup.triangles, topology, stencil, wanted);
    expect_same_curvatures(all, some);
    EXPECT_TRUE(some.offset.empty() && some.laplacian.empty());
    EXPECT_GT(all.H.cwiseAbs().maxCoeff(), 0.5);
  }
}

TEST(Operators, KnownFitsAreTakenWhereNothingMovedAndAreTheSameToTheBit) {
  const TriangleSoup soup = roughen(make_icosphere(3), 0.2, 0.25, 3, [](const Vec3& p) { return p.normalized(); });
  const int n = static_cast<int>(soup.points.size());
  constexpr int moved = 5;
  Points after = soup.points;
  for (int i = 0; i < moved; ++i) after[i] *= 1.01;
  const Topology topology(n, soup.triangles);
  std::vector<char> wanted(n, 1);
  for (int i = 0; i < n; i += 7) wanted[i] = 0;
  for (Stencil stencil : {Stencil::two_ring, Stencil::two_ring_cubic}) {
    OperatorSet before = compute_operators(soup.points, soup.triangles, topology, stencil, wanted);
    const KnownFits known{&before, moved};
    const OperatorSet anew = compute_operators(after, soup.triangles, topology, stencil, wanted);
    const OperatorSet taken = compute_operators(after, soup.triangles, topology, stencil, wanted, known);
    expect_same_curvatures(anew, taken);
    EXPECT_EQ(anew.index, taken.index);
    EXPECT_EQ(anew.laplacian, taken.laplacian);
    EXPECT_EQ(anew.gradient, taken.gradient);
    EXPECT_EQ(anew.gauss, taken.gauss);
    expect_same_curvatures(anew, compute_curvatures(after, soup.triangles, topology, stencil, wanted, known));
    // Which of them were taken shows where they are wrong.
    before.H.setConstant(123);
    const OperatorSet marked = compute_operators(after, soup.triangles, topology, stencil, wanted, known);
    for (int i = 0; i < n; ++i) {
      const auto begin = anew.index.begin() + anew.offset[i], end = anew.index.begin() + anew.offset[i + 1];
      const bool reaches_moved = std::any_of(begin, end, [](int j) { return j < moved; });
      EXPECT_EQ(marked.H[i] == 123, wanted[i] != 0 && !reaches_moved) << i;
    }
  }
}

TEST(Operators, AreTheSameToTheBitForAnyNumberOfThreads) {
  const TriangleSoup soup = make_icosphere(3);
  const int n = static_cast<int>(soup.points.size());
  const auto operators = [&](int threads) {
    return with_thread_budget(threads, [&] {
      return compute_operators(soup.points, soup.triangles, Topology(n, soup.triangles), Stencil::two_ring,
                               std::vector<char>(n, 1));
    });
  };
  const OperatorSet one = operators(1), two = operators(2);
  expect_same_curvatures(one, two);
  EXPECT_EQ(one.offset, two.offset);
  EXPECT_EQ(one.index, two.index);
  EXPECT_EQ(one.laplacian, two.laplacian);
  EXPECT_EQ(one.gradient, two.gradient);
}

TEST(CotanStiffness, DirichletEnergyOfALinearFunctionIsExact) {
  const TriangleSoup soup = make_graph([](double, double) { return 0.0; }, 1, 7);
  std::vector<int> faces;
  for (std::size_t f = 0; f < soup.triangles.size(); ++f) faces.push_back(static_cast<int>(f));
  const SparseMatrix C = cotan_stiffness(soup.points, soup.triangles, faces);
  Eigen::VectorXd x(static_cast<Eigen::Index>(soup.points.size()));
  for (std::size_t i = 0; i < soup.points.size(); ++i)
    x[static_cast<Eigen::Index>(i)] = 3 * soup.points[i].x() - 2 * soup.points[i].y();
  EXPECT_NEAR(x.dot(C * x), (9 + 4) * 4.0, 1e-10);
  EXPECT_NEAR(barycentric_areas(soup.points, soup.triangles).sum(), 4, 1e-12);
}

TEST(Topology, RingsOfAnIcosahedronGrid) {
  const TriangleSoup soup = make_icosphere(3);
  const Topology topology(static_cast<int>(soup.points.size()), soup.triangles);
  std::vector<char> mark(soup.points.size(), 0);
  std::vector<int> ring;
  topology.k_ring(0, 2, ring, mark);
  EXPECT_EQ(topology.valence(0), 5);
  EXPECT_EQ(ring.size(), 15u);  // five neighbours, ten behind them
  EXPECT_FALSE(topology.is_boundary(0));
  EXPECT_EQ(std::count(mark.begin(), mark.end(), 0), static_cast<long>(mark.size()));
}

}  // namespace
}  // namespace loopmend
