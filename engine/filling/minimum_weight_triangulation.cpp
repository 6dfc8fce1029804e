// SPDX-License-Identifier: GPL-3.0-or-later
#include "filling/minimum_weight_triangulation.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <unordered_map>

namespace loopmend {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Point = Kernel::Point_3;

/// Less is better: in the worst dihedral first.
struct Weight {
  double angle = 0;  ///< degrees between the normals, 0 to 180
  double area = 0;

  bool operator<(const Weight& other) const { return angle == other.angle ? area < other.area : angle < other.angle; }
  bool operator==(const Weight& other) const = default;
};

/// Far beyond the rounding of unit normals and areas: what differs by more need not be known exactly to be compared.
constexpr double plainly = 1e-10;

/// What is known of the best triangulation between two points.
struct Span {
  int apex = -1;  ///< third corner of the triangle at the chord; −1: there is none
  Weight weight;
  double cosine = 1;           ///< of weight.angle, up to rounding
  Vec3 normal = Vec3::Zero();  ///< of the triangle at the chord, or across where the chord is an edge of the loop
};

/// Between all pairs of points.
class AllSpans {
 public:
  explicit AllSpans(int n) : n_(n), spans_(n * n) {}
  const Span& between(int i, int k) const { return spans_[i * n_ + k]; }
  /// The same, where those of one k lie together.
  const Span& back(int k, int i) const { return spans_[k * n_ + i]; }
  void keep(int i, int k, const Span& span) { spans_[i * n_ + k] = spans_[k * n_ + i] = span; }

 private:
  int n_;
  std::vector<Span> spans_;
};

/// Between some.
class FewSpans {
 public:
  explicit FewSpans(int n) : n_(n) {}
  const Span& between(int i, int k) const {
    const auto found = spans_.find(key(i, k));
    return found == spans_.end() ? none_ : found->second;
  }
  const Span& back(int k, int i) const { return between(i, k); }
  void keep(int i, int k, const Span& span) { spans_[key(i, k)] = span; }

 private:
  std::int64_t key(int i, int k) const { return static_cast<std::int64_t>(i) * n_ + k; }

  std::int64_t n_;
  Span none_;
  std::unordered_map<std::int64_t, Span> spans_;  ///< only ever asked for one of them
};

/// The best triangulation between the points i and k, i < k, from the short to the long.
template <class Spans>
class Search {
 public:
  explicit Search(const OpenLoop& loop) : loop_(loop), n_(static_cast<int>(loop.points.size())), spans_(n_) {
    for (int i = 0; i < n_; ++i)
      across_normal_.push_back(normal(loop.points[(i + 1) % n_], loop.points[i], loop.across[i]).normalized());
    for (int i = 0; i + 1 < n_; ++i) spans_.keep(i, i + 1, {-1, {}, 1, across_normal_[i]});
  }

  /// All triangles.
  void fill() {
    for (int length = 2; length < n_; ++length)
      for (int i = 0; i + length < n_; ++i) fill(i, i + length);
  }
  /// @param allowed  by the length of the stretch, then by its ends
  void fill(const Triangles& allowed) {
    for (auto first = allowed.begin(); first != allowed.end();) {
      const int i = (*first)[0], k = (*first)[2];
      Span best;
      for (; first != allowed.end() && (*first)[0] == i && (*first)[2] == k; ++first) look(i, (*first)[1], k, best);
      spans_.keep(i, k, best);
    }
  }

  Triangles triangles() const {
    Triangles result;
    if (spans_.between(0, n_ - 1).apex < 0) return result;
    trace(0, n_ - 1, result);
    std::rotate(result.back().begin(), result.back().end() - 1, result.back().end());
    return result;
  }

 private:
  static bool filled(int i, int k, const Span& span) { return i + 1 == k || span.apex >= 0; }
  bool present(int i, int k) const { return i + 1 != k && loop_.present.count({i, k}) > 0; }

  void fill(int i, int k) {
    Span best;
    // Those of the neighbours are mostly good, and good ones spare measuring the others.
    for (int m : {spans_.between(i, k - 1).apex, spans_.between(i + 1, k).apex})
      if (m > i && m < k) look(i, m, k, best);
    for (int m = i + 1; m < k; ++m) look(i, m, k, best);
    spans_.keep(i, k, best);
  }

  bool forbidden(int i, int m, int k) const {
    return present(i, m) || present(m, k) || CGAL::collinear(point(i), point(m), point(k));
  }

  /// Of equals the first, in whatever order they are looked at.
  static bool precedes(const Weight& weight, int m, const Span& best) {
    return weight < best.weight || (weight == best.weight && m < best.apex);
  }

  /// Takes the triangle i, m, k if it is better than the best so far. Most need not be measured exactly.
  void look(int i, int m, int k, Span& best) const {
    const Span &left = spans_.between(i, m), &right = spans_.back(k, m);
    if (!filled(i, m, left) || !filled(m, k, right)) return;
    const bool any = best.apex >= 0;
    Weight weight{std::max(left.weight.angle, right.weight.angle), 0};
    if (any && weight.angle > best.weight.angle) return;
    const Vec3 across = normal(loop_.points[i], loop_.points[m], loop_.points[k]);
    const double squared = across.x() * across.x() + across.y() * across.y() + across.z() * across.z();
    double cosine = std::min(across.dot(left.normal), across.dot(right.normal));
    if (i == 0 && k == n_ - 1) cosine = std::min(cosine, across.dot(across_normal_[k]));
    const double least = best.cosine - plainly;
    // Most end here, without waiting for the root.
    if (any && least > 0 && (cosine < 0 || cosine * cosine < (1 - plainly) * least * least * squared)) return;
    const double length = std::sqrt(squared);
    if (any && cosine < least * length) return;
    const bool flatter = cosine > (std::min(left.cosine, right.cosine) + plainly) * length;
    if (!flatter) weight.angle = std::max(weight.angle, worst_dihedral(i, m, k));
    if (any && weight.angle > best.weight.angle) return;
    weight.area = left.weight.area + right.weight.area + length / 2;
    if (any && !precedes(weight, m, best)) return;
    if (forbidden(i, m, k)) return;
    best.apex = m;
    best.weight = weight;
    best.cosine = std::min({left.cosine, right.cosine, cosine / length});
    best.normal = across / length;
  }

  /// Of the triangle with those that it joins, exactly as CGAL has it.
  double worst_dihedral(int i, int m, int k) const {
    const double worst = std::max(dihedral(i, m, k, beyond(i, m)), dihedral(m, k, i, beyond(m, k)));
    return i == 0 && k == n_ - 1 ? std::max(worst, dihedral(k, i, m, loop_.across[k])) : worst;
  }
  const Vec3& beyond(int i, int k) const {
    return i + 1 == k ? loop_.across[i] : loop_.points[spans_.between(i, k).apex];
  }
  double dihedral(int a, int b, int own, const Vec3& other) const {
    return 180 - std::abs(CGAL::approximate_dihedral_angle(point(a), point(b), point(own), exact(other)));
  }
  static Point exact(const Vec3& p) { return {p.x(), p.y(), p.z()}; }
  Point point(int i) const { return exact(loop_.points[i]); }
  static Vec3 normal(const Vec3& a, const Vec3& b, const Vec3& c) { return (b - a).cross(c - a); }

  void trace(int i, int k, Triangles& triangles) const {
    if (i + 1 == k) return;
    const int m = spans_.between(i, k).apex;
    trace(i, m, triangles);
    trace(m, k, triangles);
    triangles.push_back({i, m, k});
  }

  const OpenLoop& loop_;
  int n_;
  std::vector<Vec3> across_normal_;  ///< unit normals across the edges from i to i + 1
  Spans spans_;
};

}  // namespace

Triangles minimum_weight_triangulation(const OpenLoop& loop) {
  Search<AllSpans> search(loop);
  search.fill();
  return search.triangles();
}

Triangles minimum_weight_triangulation(const OpenLoop& loop, Triangles allowed) {
  const auto rank = [](const Triangle& t) { return std::array{t[2] - t[0], t[0], t[1]}; };
  std::sort(allowed.begin(), allowed.end(), [&](const Triangle& a, const Triangle& b) { return rank(a) < rank(b); });
  Search<FewSpans> search(loop);
  search.fill(allowed);
  return search.triangles();
}

}  // namespace loopmend
