// SPDX-License-Identifier: GPL-3.0-or-later
#include "repair/tiny_handles.h"

#include "mesh/pieces.h"

#include <Eigen/Geometry>
#include <boost/pending/disjoint_sets.hpp>

#include <algorithm>
#include <utility>

namespace loopmend {

namespace {

constexpr int most_edges = 8;  ///< of the shortest loop; and how far the handle reaches from one of its vertices
constexpr std::size_t most_faces_of_a_scrap = 10;
/// Of a ball, and at a vertex within it: hubs of thousands of edges would make a ball of the whole surface at each of its vertices.
constexpr std::size_t most_vertices = 4000;
constexpr unsigned most_neighbors = 64;
constexpr int rings = 2 * most_edges;     ///< of a ball: it holds each handle near its center
constexpr double most_of_a_piece = 0.04;  ///< length of the loop, in extents of the piece of surface

using Sets = boost::disjoint_sets_with_storage<>;

/// Some faces of a mesh as a surface of their own, which is parted where it touches itself.
class Part {
 public:
  /// @param number  one for each face of the mesh, −1; it is so again when the part is gone. Both must outlive this.
  Part(const TriMesh& mesh, const std::vector<int>& faces, std::vector<int>& number)
      : mesh_(mesh),
        faces_(faces),
        number_(number) {
    for (std::size_t f = 0; f < faces.size(); ++f) number_[faces[f]] = static_cast<int>(f);
    number_corners();
    collect_edges();
  }
  Part(const Part&) = delete;
  Part& operator=(const Part&) = delete;
  ~Part() {
    for (int face : faces_) number_[face] = -1;
  }

  /// The sum over its pieces, each with its holes closed.
  int genus() const {
    Sets pieces(faces_.size());
    int count = static_cast<int>(faces_.size());
    for (const Edge& e : edges_) {
      if (e.right < 0 || pieces.find_set(e.left) == pieces.find_set(e.right)) continue;
      pieces.union_set(e.left, e.right);
      --count;
    }
    const int euler = vertices() - static_cast<int>(edges_.size()) + static_cast<int>(faces_.size());
    return (2 * count - euler - holes_) / 2;
  }

  /// The shortest loop that does not part the surface, as vertices of the mesh. Empty: it has more than `most` edges.
  /// @param is_root  of a vertex of the mesh: whether loops through it are looked for
  /// @param accept  of a loop: whether it counts
  template <class IsRoot, class Accept>
  std::vector<int> shortest_loop(int most, const IsRoot& is_root, const Accept& accept) const {
    Edges around(vertex_.size());
    for (std::size_t e = 0; e < edges_.size(); ++e)
      for (int v : {edges_[e].a, edges_[e].b}) around[v].push_back(static_cast<int>(e));
    std::vector<int> best;
    for (int root = 0; root < vertices() && most >= 3; ++root) {
      if (!is_root(vertex_[root])) continue;
      std::vector<int> loop = shortest_loop_from(root, most, around);
      if (loop.empty() || !accept(loop)) continue;
      most = static_cast<int>(loop.size()) - 1;
      best = std::move(loop);
    }
    return best;
  }

 private:
  struct Edge {
    int a, b;
    int left;
    int right;  ///< −1 on the boundary
  };

  using Edges = std::vector<std::vector<int>>;  ///< by vertex

  int vertices() const { return static_cast<int>(vertex_.size()); }

  std::size_t corner(int face, TriMesh::VertexHandle v) const {
    auto h = mesh_.halfedge_handle(TriMesh::FaceHandle(faces_[face]));
    std::size_t k = 0;
    for (; mesh_.to_vertex_handle(h) != v; ++k) h = mesh_.next_halfedge_handle(h);
    return 3 * static_cast<std::size_t>(face) + k;
  }

  void number_corners() {
    Sets fans(3 * faces_.size());
    for_each_halfedge([&](int face, TriMesh::HalfedgeHandle h, int other) {
      if (other < face) return;
      for (const auto v : {mesh_.from_vertex_handle(h), mesh_.to_vertex_handle(h)})
        fans.union_set(corner(face, v), corner(other, v));
    });
    of_corner_.resize(3 * faces_.size());
    std::vector<int> number(of_corner_.size(), -1);
    for_each_halfedge([&](int face, TriMesh::HalfedgeHandle h, int /*other*/) {
      const std::size_t c = corner(face, mesh_.to_vertex_handle(h));
      int& n = number[fans.find_set(c)];
      if (n < 0) {
        n = vertices();
        vertex_.push_back(mesh_.to_vertex_handle(h).idx());
      }
      of_corner_[c] = n;
    });
  }

  void collect_edges() {
    Sets boundary(vertex_.size());
    hole_.assign(vertex_.size(), -1);
    std::vector<int> on_boundary;
    for_each_halfedge([&](int face, TriMesh::HalfedgeHandle h, int other) {
      if (other > face) return;
      const int a = of_corner_[corner(face, mesh_.from_vertex_handle(h))];
      const int b = of_corner_[corner(face, mesh_.to_vertex_handle(h))];
      edges_.push_back({a, b, face, other});
      if (other >= 0) return;
      boundary.union_set(a, b);
      on_boundary.push_back(a);
    });
    std::vector<int> number(vertex_.size(), -1);
    for (int v : on_boundary) {
      int& n = number[boundary.find_set(v)];
      if (n < 0) n = holes_++;
      hole_[v] = n;
    }
  }

  /// visit(face, halfedge, face across it or −1)
  template <class Visit>
  void for_each_halfedge(const Visit& visit) const {
    for (std::size_t f = 0; f < faces_.size(); ++f)
      for (const auto h : mesh_.fh_range(TriMesh::FaceHandle(faces_[f]))) {
        const auto across = mesh_.face_handle(mesh_.opposite_halfedge_handle(h));
        visit(static_cast<int>(f), h, across.is_valid() ? number_[across.idx()] : -1);
      }
  }

  /// Shortest ways from a vertex.
  struct Tree {
    std::vector<int> depth, up;  ///< by vertex; −1: not reached
    std::vector<char> has_edge;
    std::vector<int> reached;  ///< by depth
  };

  Tree tree_from(int root, int most_depth, const Edges& around) const {
    Tree tree{std::vector<int>(vertex_.size(), -1),
              std::vector<int>(vertex_.size(), -1),
              std::vector<char>(edges_.size(), 0),
              {root}};
    tree.depth[root] = 0;
    for (std::size_t i = 0; i < tree.reached.size() && tree.depth[tree.reached[i]] < most_depth; ++i)
      for (int e : around[tree.reached[i]]) {
        const int from = tree.reached[i], v = edges_[e].a == from ? edges_[e].b : edges_[e].a;
        if (tree.depth[v] >= 0) continue;
        tree.depth[v] = tree.depth[from] + 1;
        tree.up[v] = from;
        tree.has_edge[e] = 1;
        tree.reached.push_back(v);
      }
    return tree;
  }

  /// What lies between the vertices reached has the Euler characteristic of a disk, so that every loop there can be drawn together.
  bool spans_disk(const Tree& tree, const Edges& around) const {
    const auto holds_face = [&](int f) {
      return f >= 0 &&
             std::all_of(&of_corner_[3 * f], &of_corner_[3 * f] + 3, [&](int v) { return tree.depth[v] >= 0; });
    };
    int edges = 0, sides = 0;
    for (int v : tree.reached)
      for (int e : around[v])
        if (edges_[e].a == v && tree.depth[edges_[e].b] >= 0) {
          ++edges;
          sides += holds_face(edges_[e].left) + holds_face(edges_[e].right);
        }
    return static_cast<int>(tree.reached.size()) - edges + sides / 3 == 1;
  }

  /// Of the loops of one edge outside a tree of shortest ways and the ways from its ends to the root, the long ones join the faces
  /// on their sides first. Loops whose sides are joined by then do not part the surface.
  std::vector<int> shortest_loop_from(int root, int most, const Edges& around) const {
    if (spans_disk(tree_from(root, most / 2, around), around)) return {};
    const Tree tree = tree_from(root, vertices(), around);
    Sets joined(faces_.size() + static_cast<std::size_t>(holes_));
    const auto join = [&](const Edge& e) {
      const int right = e.right >= 0 ? e.right : static_cast<int>(faces_.size()) + hole_[e.a];
      if (joined.find_set(e.left) == joined.find_set(right)) return false;
      joined.union_set(e.left, right);
      return true;
    };
    std::vector<std::pair<int, int>> by_length;  // and edge
    for (std::size_t e = 0; e < edges_.size(); ++e) {
      if (tree.has_edge[e]) continue;
      const int a = tree.depth[edges_[e].a], b = tree.depth[edges_[e].b];
      if (a >= 0 && a + b < most)
        by_length.emplace_back(a + b + 1, static_cast<int>(e));
      else
        join(edges_[e]);
    }
    std::sort(by_length.rbegin(), by_length.rend());
    std::pair<int, int> shortest{most + 1, -1};
    for (const auto& entry : by_length)
      if (!join(edges_[entry.second])) shortest = std::min(shortest, entry);
    if (shortest.second < 0) return {};
    std::vector<int> loop, back;
    int a = edges_[shortest.second].a, b = edges_[shortest.second].b;
    while (a != b)
      if (tree.depth[a] > tree.depth[b]) {
        loop.push_back(vertex_[a]);
        a = tree.up[a];
      } else {
        back.push_back(vertex_[b]);
        b = tree.up[b];
      }
    loop.push_back(vertex_[a]);
    loop.insert(loop.end(), back.rbegin(), back.rend());
    return loop;
  }

  const TriMesh& mesh_;
  const std::vector<int>& faces_;
  std::vector<int>& number_;    ///< in faces_, by face of the mesh
  std::vector<int> of_corner_;  ///< three for each face: its vertex here
  std::vector<int> vertex_;     ///< of the mesh
  std::vector<Edge> edges_;
  std::vector<int> hole_;  ///< on which each vertex lies; −1: none
  int holes_ = 0;
};

/// The faces all of whose vertices are so few edges from a center, over faces that are not `gone`; fewer where that would be very
/// many.
class Balls {
 public:
  Balls(const TriMesh& mesh, const std::vector<char>& gone)
      : mesh_(mesh),
        gone_(gone),
        distance_(mesh.n_vertices(), -1) {}

  std::vector<int> around(TriMesh::VertexHandle center, int reach) {
    grow(center, reach);
    std::vector<int> faces;
    for (const auto v : vertices_)
      for (const auto face : mesh_.vf_range(v))
        if (!gone_[face.idx()] && is_first_of(v, face)) faces.push_back(face.idx());
    return faces;
  }

  /// Of a vertex in the last ball, in edges from its center.
  int distance(int vertex) const { return distance_[vertex]; }

  /// visit(vertex, edges from the center) for the last ball, which is forgotten then.
  template <class Visit>
  void leave(const Visit& visit) {
    for (const auto v : vertices_) {
      visit(v, distance(v.idx()));
      distance_[v.idx()] = -1;
    }
  }

 private:
  void grow(TriMesh::VertexHandle center, int reach) {
    vertices_.assign(1, center);
    distance_[center.idx()] = 0;
    for (std::size_t i = 0; i < vertices_.size() && distance(vertices_[i].idx()) < reach; ++i) {
      if (vertices_.size() > most_vertices) break;
      if (mesh_.valence(vertices_[i]) > most_neighbors) continue;
      for (const auto h : mesh_.voh_range(vertices_[i])) {
        const auto v = mesh_.to_vertex_handle(h);
        if (distance_[v.idx()] >= 0 || (is_gone(h) && is_gone(mesh_.opposite_halfedge_handle(h)))) continue;
        distance_[v.idx()] = distance(vertices_[i].idx()) + 1;
        vertices_.push_back(v);
      }
    }
  }

  /// Whether the face lies in the ball, and the vertex is its lowest.
  bool is_first_of(TriMesh::VertexHandle v, TriMesh::FaceHandle face) const {
    for (const auto w : mesh_.fv_range(face))
      if (distance_[w.idx()] < 0 || w.idx() < v.idx()) return false;
    return true;
  }

  bool is_gone(TriMesh::HalfedgeHandle h) const {
    const auto face = mesh_.face_handle(h);
    return !face.is_valid() || gone_[face.idx()];
  }

  const TriMesh& mesh_;
  const std::vector<char>& gone_;
  std::vector<int> distance_;  ///< −1: not in the ball
  std::vector<TriMesh::VertexHandle> vertices_;
};

/// Marks all faces at the vertices, and what hangs on nothing else. @returns whether any was not gone before.
bool remove_around(const TriMesh& mesh, const std::vector<int>& vertices, std::vector<char>& gone) {
  std::vector<TriMesh::FaceHandle> removed;
  for (int v : vertices)
    for (const auto face : mesh.vf_range(TriMesh::VertexHandle(v)))
      if (!std::exchange(gone[face.idx()], 1)) removed.push_back(face);
  for (const auto face : removed)
    for (const auto beside : mesh.ff_range(face)) {
      std::vector<TriMesh::FaceHandle> scrap;
      const auto reach = [&](TriMesh::FaceHandle f) {
        if (!gone[f.idx()] && std::find(scrap.begin(), scrap.end(), f) == scrap.end()) scrap.push_back(f);
      };
      reach(beside);
      for (std::size_t k = 0; k < scrap.size() && scrap.size() <= most_faces_of_a_scrap; ++k)
        for (const auto f : mesh.ff_range(scrap[k])) reach(f);
      if (scrap.size() > most_faces_of_a_scrap) continue;
      for (const auto f : scrap) gone[f.idx()] = 1;
    }
  return !removed.empty();
}

double length_of(const TriMesh& mesh, const std::vector<int>& loop) {
  double result = 0;
  for (std::size_t i = 0; i < loop.size(); ++i)
    result +=
        (mesh.point(TriMesh::VertexHandle(loop[i])) - mesh.point(TriMesh::VertexHandle(loop[(i + 1) % loop.size()])))
            .norm();
  return result;
}

}  // namespace

TinyHandles find_tiny_handles(const TriMesh& mesh, const CancelToken& cancel) {
  TinyHandles result;
  std::vector<int> number(mesh.n_faces(), -1), all(mesh.n_faces());
  for (std::size_t f = 0; f < all.size(); ++f) all[f] = static_cast<int>(f);
  if (Part(mesh, all, number).genus() == 0) return result;
  const std::vector<int> piece = pieces_of(mesh);
  std::vector<Eigen::AlignedBox3d> box(piece.size());
  for (const auto face : mesh.faces())
    for (const auto v : mesh.fv_range(face)) box[piece[face.idx()]].extend(mesh.point(v));

  std::vector<char> gone(mesh.n_faces(), 0), seen(mesh.n_vertices(), 0);
  Balls balls(mesh, gone);
  for (const auto center : mesh.vertices()) {
    if (seen[center.idx()]) continue;
    if (cancel.cancelled()) break;
    for (bool more = true; std::exchange(more, false);) {
      const std::vector<int> faces = balls.around(center, rings);
      std::vector<int> loop;
      if (const Part ball(mesh, faces, number); ball.genus() > 0) {
        const double longest = most_of_a_piece * box[piece[faces.front()]].diagonal().norm();
        const auto is_short = [&](const std::vector<int>& l) { return length_of(mesh, l) <= longest; };
        loop = ball.shortest_loop(
            most_edges, [&](int v) { return balls.distance(v) <= most_edges && !cancel.cancelled(); }, is_short);
        if (!loop.empty())
          loop = ball.shortest_loop(
              static_cast<int>(loop.size()), [](int /*v*/) { return true; }, is_short);
      }
      balls.leave([&](TriMesh::VertexHandle v, int distance) { seen[v.idx()] |= distance <= most_edges; });
      if (loop.empty()) continue;
      ++result.count;
      more = remove_around(mesh, loop, gone);
    }
  }
  for (std::size_t f = 0; f < gone.size(); ++f)
    if (gone[f]) result.faces.push_back(static_cast<int>(f));
  return result;
}

}  // namespace loopmend
