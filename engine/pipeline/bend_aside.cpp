// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/bend_aside.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <set>
#include <unordered_map>
#include <unordered_set>

namespace loopmend {
namespace {

constexpr int most_rounds = 6;
constexpr std::size_t most_fragment_faces = 4000;
constexpr double largest_fragment = 0.15;  ///< of the patch's extent
/// How far the patch stays away from a fragment, in mean edges of the triangles that cut it.
constexpr double clearance = 0.5;

struct Fragment {
  Points points;
  std::set<int> cut_by;  ///< triangles of the patch
};

class Bender {
 public:
  Bender(const ScanIndex& scan, Patch& patch) : scan_(scan), patch_(patch) {
    Eigen::AlignedBox3d box;
    for (const Vec3& p : patch.positions) box.extend(patch.to_mesh(p));
    extent_ = box.diagonal().norm();
    for (int v : patch.view_vertex)
      if (v >= 0) around_.insert(scan.model.soup_vertex[v]);
  }

  /// @returns nothing where it cuts anything else
  std::optional<std::vector<Fragment>> fragments_in_the_way() const {
    std::vector<Fragment> fragments;
    std::unordered_map<int, std::size_t> fragment_of_face;
    for (const auto& [own, face] : cuts_of(scan_, patch_)) {
      if (face < 0) return std::nullopt;
      if (!fragment_of_face.contains(face)) {
        const std::vector<int> faces = small_piece(face);
        if (faces.empty()) return std::nullopt;
        Fragment fragment;
        for (int f : faces) {
          fragment_of_face[f] = fragments.size();
          for (int v : soup().triangles[f]) fragment.points.push_back(soup().points[v]);
        }
        fragments.push_back(std::move(fragment));
      }
      fragments[fragment_of_face.at(face)].cut_by.insert(own);
    }
    return fragments;
  }

  void bend_around(const Fragment& fragment, double more) {
    Vec3 normal = Vec3::Zero(), middle = Vec3::Zero(), origin = Vec3::Zero();
    double edges = 0;
    for (int t : fragment.cut_by) {
      const Triangle& tri = patch_.triangles[t];
      const Vec3 a = at(tri[0]), b = at(tri[1]), c = at(tri[2]);
      normal += (b - a).cross(c - a);
      origin += (a + b + c) / 3;
      edges += ((b - a).norm() + (c - b).norm() + (a - c).norm()) / 3;
    }
    const auto count = static_cast<double>(fragment.cut_by.size());
    origin /= count;
    normal.normalize();
    for (const Vec3& p : fragment.points) middle += p / static_cast<double>(fragment.points.size());
    double low = 0, high = 0, radius = 0;
    for (const Vec3& p : fragment.points) {
      const double height = (p - origin).dot(normal);
      low = std::min(low, height);
      high = std::max(high, height);
      radius = std::max(radius, tangential(p - middle, normal));
    }
    const double margin = clearance * more * edges / count;
    const double way = high <= -low ? high + margin : low - margin;
    const double inner = radius + edges / count, outer = inner + 2.5 * std::abs(way) + edges / count;
    for (int i = 0; i < patch_.free_count; ++i) {
      const Vec3 from_middle = at(i) - middle;
      const double distance = tangential(from_middle, normal);
      if (distance >= outer || std::abs(from_middle.dot(normal)) > outer + std::abs(way)) continue;
      const double s = std::clamp((outer - distance) / (outer - inner), 0.0, 1.0);
      const double weight = s * s * (3 - 2 * s);
      patch_.positions[i] = patch_.to_frame(at(i) + weight * way * normal);
    }
  }

 private:
  static double tangential(const Vec3& way, const Vec3& normal) { return (way - way.dot(normal) * normal).norm(); }
  Vec3 at(int i) const { return patch_.to_mesh(patch_.positions[i]); }
  const TriangleSoup& soup() const { return scan_.model.soup; }

  /// All faces that hang together with this one by vertices; empty where they are no fragment.
  std::vector<int> small_piece(int face) const {
    std::vector<int> piece{face};
    std::set<int> seen{face};
    Eigen::AlignedBox3d box;
    for (std::size_t k = 0; k < piece.size(); ++k) {
      const Triangle& t = soup().triangles[piece[k]];
      Eigen::AlignedBox3d here;
      for (int v : t) {
        if (around_.contains(v)) return {};
        here.extend(soup().points[v]);
      }
      box.extend(here);
      if (piece.size() > most_fragment_faces || box.diagonal().norm() > largest_fragment * extent_) return {};
      for (int next : scan_.index.near_box(here.min(), here.max())) {
        const Triangle& n = soup().triangles[next];
        if (std::find_first_of(n.begin(), n.end(), t.begin(), t.end()) != n.end() && seen.insert(next).second)
          piece.push_back(next);
      }
    }
    return piece;
  }

  const ScanIndex& scan_;
  Patch& patch_;
  std::unordered_set<int> around_;  ///< soup vertices of the patch's neighborhood
  double extent_ = 0;
};

}  // namespace

std::optional<BentPatch> bent_aside(const ScanIndex& scan, const Patch& patch, const Validity& validity,
                                    const CancelToken& cancel) {
  BentPatch bent{patch, {}, 0};
  Bender bender(scan, bent.patch);
  for (int round = 0; round < most_rounds && !cancel.cancelled(); ++round) {
    const auto fragments = bender.fragments_in_the_way();
    if (!fragments) return std::nullopt;
    if (fragments->empty()) {
      bent.validity = validate(scan, bent.patch);
      if (bent.validity.intersections > 0 || bent.validity.folds > validity.folds) return std::nullopt;
      return bent;
    }
    bent.fragments = std::max(bent.fragments, static_cast<int>(fragments->size()));
    for (const Fragment& fragment : *fragments) bender.bend_around(fragment, 1 + round);
  }
  return std::nullopt;
}

Message bent_message() {
  return joined(say("bent past loose fragments of surface in the hole"), "; ", say("--repair removes such fragments"))
      .with_code("bent");
}

}  // namespace loopmend
