// SPDX-License-Identifier: GPL-3.0-or-later
#include "operators/topology.h"

#include <algorithm>

namespace loopmend {

Topology::Topology(int vertex_count, const Triangles& triangles)
    : face_offset_(vertex_count + 1, 0),
      neighbor_offset_(vertex_count + 1, 0),
      boundary_(vertex_count, 0) {
  for (const Triangle& t : triangles)
    for (int v : t) ++face_offset_[v + 1];
  for (int v = 0; v < vertex_count; ++v) face_offset_[v + 1] += face_offset_[v];
  face_.resize(face_offset_.back());
  std::vector<int> cursor(face_offset_.begin(), face_offset_.end() - 1);
  for (std::size_t f = 0; f < triangles.size(); ++f)
    for (int v : triangles[f]) face_[cursor[v]++] = static_cast<int>(f);

  std::vector<int> ring;
  neighbor_.reserve(face_.size() + static_cast<std::size_t>(vertex_count) / 8);  // as many, and one more on boundaries
  for (int v = 0; v < vertex_count; ++v) {
    ring.clear();
    for (int f : faces(v))
      for (int u : triangles[f])
        if (u != v) ring.push_back(u);
    std::sort(ring.begin(), ring.end());
    // Inside, each neighbour is named by two triangles; at a boundary edge by one.
    boundary_[v] = ring.empty();
    for (std::size_t i = 0; i < ring.size();) {
      std::size_t j = i;
      while (j < ring.size() && ring[j] == ring[i]) ++j;
      if (j - i == 1) boundary_[v] = 1;
      neighbor_.push_back(ring[i]);
      i = j;
    }
    neighbor_offset_[v + 1] = static_cast<int>(neighbor_.size());
  }
}

std::span<const int> Topology::neighbors(int v) const {
  return {neighbor_.data() + neighbor_offset_[v], neighbor_.data() + neighbor_offset_[v + 1]};
}

std::span<const int> Topology::faces(int v) const {
  return {face_.data() + face_offset_[v], face_.data() + face_offset_[v + 1]};
}

void Topology::forget_faces() {
  std::vector<int>().swap(face_offset_);
  std::vector<int>().swap(face_);
}

void Topology::k_ring(int v, int rings, std::vector<int>& result, std::vector<char>& mark) const {
  result.clear();
  mark[v] = 1;
  std::size_t begin = 0;
  const auto add_neighbors = [&](int u) {
    for (int w : neighbors(u))
      if (!mark[w]) {
        mark[w] = 1;
        result.push_back(w);
      }
  };
  add_neighbors(v);
  for (int ring = 1; ring < rings; ++ring) {
    const std::size_t end = result.size();
    for (; begin < end; ++begin) add_neighbors(result[begin]);
  }
  mark[v] = 0;
  for (int u : result) mark[u] = 0;
}

}  // namespace loopmend
