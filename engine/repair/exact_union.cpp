// SPDX-License-Identifier: GPL-3.0-or-later
#include "repair/exact_union.h"

#define CGAL_NO_DEPRECATION_WARNINGS 1
#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/corefinement.h>
#include <CGAL/Side_of_triangle_mesh.h>
#include <CGAL/Surface_mesh.h>

#include <algorithm>
#include <array>
#include <exception>
#include <functional>
#include <map>
#include <memory>
#include <new>
#include <queue>
#include <set>
#include <tuple>
#include <unordered_map>

namespace loopmend {

namespace {

namespace PMP = CGAL::Polygon_mesh_processing;
using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Vertex = Mesh::Vertex_index;
using Face = Mesh::Face_index;

/// A mesh whose faces know the soup triangles that they are parts of, and whose vertices know their soup points; −1: new.
struct Body {
  Mesh mesh;
  Mesh::Property_map<Face, int> face;
  Mesh::Property_map<Vertex, int> point;

  /// A copied mesh has the maps, which add_property_map then returns.
  explicit Body(const Mesh& copied = {})
      : mesh(copied),
        face(mesh.add_property_map<Face, int>("f:soup", -1).first),
        point(mesh.add_property_map<Vertex, int>("v:soup", -1).first) {}
  Body(const Body& other) : Body(other.mesh) {}
  Body& operator=(const Body&) = delete;
};

/// What a union is made of, in one place: CGAL orders the two by their addresses, and nothing must depend on chance.
struct Operands {
  Body a, b, united;

  Operands(const Body& first, const Body& second) : a(first), b(second) {}
};

struct Cancelled : std::exception {};

/// Labels new faces and copies of vertices with those of the soup, and ends CGAL's work when cancelled.
class Origins : public PMP::Corefinement::Default_visitor<Mesh> {
 public:
  Origins(Operands& operands, const CancelToken& cancel) : operands_(&operands), cancel_(&cancel) {}
  void progress_filtering_intersections(double) const { stop_if_cancelled(); }
  void edge_face_intersections_step() const { stop_if_cancelled(); }
  void intersection_of_coplanar_faces_step() const { stop_if_cancelled(); }
  void triangulating_faces_step() const { stop_if_cancelled(); }
  void build_output_step() const { stop_if_cancelled(); }
  void before_subface_creations(Face face, Mesh& mesh) { divided_ = body(mesh).face[face]; }
  void after_subface_created(Face face, Mesh& mesh) { body(mesh).face[face] = divided_; }
  void after_face_copy(Face from, const Mesh& source, Face to, Mesh& target) {
    body(target).face[to] = body(source).face[from];
  }
  void after_vertex_copy(Vertex from, const Mesh& source, Vertex to, Mesh& target) {
    body(target).point[to] = body(source).point[from];
  }

 private:
  Body& body(const Mesh& mesh) {
    if (&mesh == &operands_->a.mesh) return operands_->a;
    return &mesh == &operands_->b.mesh ? operands_->b : operands_->united;
  }

  void stop_if_cancelled() const {
    if (cancel_->cancelled()) throw Cancelled();
  }

  Operands* operands_;
  const CancelToken* cancel_;
  int divided_ = -1;
};

class Uniting {
 public:
  Uniting(const SurfaceModel& model, const std::map<int, std::vector<int>>& faces) : model_(model), faces_(faces) {
    for (const auto& [body, own] : faces) root_[body] = body;
  }

  ExactUnions run(const std::set<BodyPair>& pairs, const CancelToken& cancel) {
    for (const auto& [a, b] : pairs) {
      beside_[a].insert(b);
      beside_[b].insert(a);
      offer(a, b);
    }
    while (!next_.empty()) {
      if (cancel.cancelled()) return {};
      const auto [size, a, b] = next_.top();
      next_.pop();
      if (!beside_[a].contains(b) || size != size_of(a) + size_of(b)) continue;  // they are others by now
      switch (unite(a, b, cancel)) {
        case Outcome::united: replace_both(a, b); break;
        case Outcome::only_touching: result_.only_touching.insert({a, b}); break;
        case Outcome::refused: result_.refused.insert({a, b}); break;
      }
    }
    if (cancel.cancelled()) return {};
    std::map<int, std::vector<int>> members;
    for (const auto& [body, root] : root_) members[root].push_back(body);
    for (const auto& [root, all] : members)
      if (all.size() > 1) result_.made.push_back(result_of(*bodies_.at(root), all));
    return std::move(result_);
  }

 private:
  void offer(int a, int b) { next_.emplace(size_of(a) + size_of(b), std::min(a, b), std::max(a, b)); }

  /// `a` is the union of both: its neighbors are tried again.
  void replace_both(int a, int b) {
    for (auto& [body, root] : root_)
      if (root == b) root = a;
    for (std::set<BodyPair>* failed : {&result_.only_touching, &result_.refused})
      std::erase_if(*failed, [a, b](const BodyPair& pair) {
        return pair.first == a || pair.second == a || pair.first == b || pair.second == b;
      });
    for (int other : beside_[b]) {
      beside_[other].erase(b);
      if (other == a) continue;
      beside_[other].insert(a);
      beside_[a].insert(other);
    }
    beside_[b].clear();
    for (int other : beside_[a]) offer(a, other);
  }

  std::size_t size_of(int body) const {
    const auto made = bodies_.find(body);
    return made != bodies_.end() ? made->second->mesh.number_of_faces() : faces_.at(body).size();
  }

  std::unique_ptr<Body> make(int body) const {
    auto made = std::make_unique<Body>();
    std::unordered_map<int, Vertex> vertex_of;
    for (int f : faces_.at(body)) {
      std::array<Vertex, 3> corners;
      std::size_t k = 0;
      const auto of_view = std::lower_bound(model_.soup_face.begin(), model_.soup_face.end(), f);
      const auto face = static_cast<unsigned>(of_view - model_.soup_face.begin());
      for (const auto v : model_.mesh.fv_range(model_.mesh.face_handle(face))) {
        const auto [entry, is_new] = vertex_of.try_emplace(v.idx());
        if (is_new) {
          const int point = model_.soup_vertex[v.idx()];
          const Vec3& p = model_.soup.points[point];
          entry->second = made->mesh.add_vertex(Kernel::Point_3(p.x(), p.y(), p.z()));
          made->point[entry->second] = point;
        }
        corners[k++] = entry->second;
      }
      made->face[made->mesh.add_face(corners[0], corners[1], corners[2])] = f;
    }
    return made;
  }

  /// Whether some face of `a` lies within `b` or on it. Both are corefined, so that a middle stands for its face.
  static bool reaches(const Mesh& a, const Mesh& b) {
    const CGAL::Side_of_triangle_mesh<Mesh, Kernel> side(b);
    const auto faces = a.faces();
    return std::any_of(faces.begin(), faces.end(), [&](Face f) {
      std::array<Kernel::Point_3, 3> corners;
      std::size_t k = 0;
      for (const Vertex v : CGAL::vertices_around_face(a.halfedge(f), a)) corners.at(k++) = a.point(v);
      return side(CGAL::centroid(corners[0], corners[1], corners[2])) != CGAL::ON_UNBOUNDED_SIDE;
    });
  }

  enum class Outcome { united, only_touching, refused };
  /// The union takes the place of `a`; nothing changes where there is none, or when cancelled.
  Outcome unite(int a, int b, const CancelToken& cancel) {
    for (int body : {a, b})
      if (!bodies_.contains(body)) bodies_[body] = make(body);
    const auto operands = std::make_unique<Operands>(*bodies_[a], *bodies_[b]);
    const Mesh &one = operands->a.mesh, &other = operands->b.mesh;
    Body& united = operands->united;
    try {
      if (!PMP::corefine_and_compute_union(
              operands->a.mesh, operands->b.mesh, united.mesh,
              CGAL::parameters::visitor(Origins(*operands, cancel)).throw_on_self_intersection(true)))
        return reaches(one, other) || reaches(other, one) ? Outcome::refused : Outcome::only_touching;
    } catch (const std::bad_alloc&) {
      throw;
    } catch (const std::exception&) {  // CGAL's, or of a cancel: of bodies that touch themselves, of faces without area
      return Outcome::refused;
    }
    united.mesh.collect_garbage();
    // A union is made of faces of both: where all are there, none lay within the other or on it.
    if (united.mesh.number_of_faces() == one.number_of_faces() + other.number_of_faces()) return Outcome::only_touching;
    bodies_[a] = std::make_unique<Body>(united);
    bodies_.erase(b);
    return Outcome::united;
  }

  /// The corners of faces, each from its least place on, by their places: CGAL's own order depends on chance.
  static std::vector<std::array<Vertex, 3>> in_order(const Body& body, const std::vector<Face>& faces) {
    const auto precedes = [&](Vertex v, Vertex w) { return body.mesh.point(v) < body.mesh.point(w); };
    std::vector<std::array<Vertex, 3>> result;
    for (const Face f : faces) {
      std::array<Vertex, 3>& corners = result.emplace_back();
      std::size_t k = 0;
      for (const Vertex v : CGAL::vertices_around_face(body.mesh.halfedge(f), body.mesh)) corners.at(k++) = v;
      std::rotate(corners.begin(), std::min_element(corners.begin(), corners.end(), precedes), corners.end());
    }
    std::sort(result.begin(), result.end(), [&](const auto& a, const auto& b) {
      return std::lexicographical_compare(a.begin(), a.end(), b.begin(), b.end(), precedes);
    });
    return result;
  }

  ExactUnion result_of(const Body& body, const std::vector<int>& members) const {
    ExactUnion result{members, {}, {}};
    std::map<int, std::vector<Face>> by_face;
    for (const Face f : body.mesh.faces()) by_face[body.face[f]].push_back(f);
    std::map<Vertex, int> number;
    const auto corner = [&](Vertex v) {
      if (body.point[v] >= 0) return body.point[v];
      const auto [entry, is_new] = number.try_emplace(v, -1 - static_cast<int>(result.points.size()));
      if (is_new) {
        const auto& exact = CGAL::exact(body.mesh.point(v));
        result.points.emplace_back(CGAL::to_double(exact.x()), CGAL::to_double(exact.y()), CGAL::to_double(exact.z()));
      }
      return entry->second;
    };
    for (const auto& [face, parts] : by_face)
      for (const std::array<Vertex, 3>& part : in_order(body, parts)) {
        FaceOfUnion& made = result.faces.emplace_back(FaceOfUnion{face, {}});
        std::transform(part.begin(), part.end(), made.corners.begin(), corner);
      }
    return result;
  }

  const SurfaceModel& model_;
  const std::map<int, std::vector<int>>& faces_;
  std::map<int, int> root_;  ///< of each body the least that it is one with
  std::map<int, std::unique_ptr<Body>> bodies_;
  std::map<int, std::set<int>> beside_;  ///< of each root those that it may be united with
  ExactUnions result_;
  using Candidate = std::tuple<std::size_t, int, int>;  ///< faces of both, and the two roots
  std::priority_queue<Candidate, std::vector<Candidate>, std::greater<>> next_;
};

}  // namespace

ExactUnions unite_exactly(const SurfaceModel& model, const std::map<int, std::vector<int>>& bodies,
                          const std::set<BodyPair>& pairs, const CancelToken& cancel) {
  return Uniting(model, bodies).run(pairs, cancel);
}

}  // namespace loopmend
