// SPDX-License-Identifier: GPL-3.0-or-later
// Meshes as NumPy arrays. Into the engine they are copied once, with every number checked; out of it they are handed over.
#pragma once

#include "mesh/triangle_soup.h"

#include <pybind11/numpy.h>

#include <memory>
#include <vector>

namespace loopmend {

/// @param vertices  (n, 3), real numbers of any kind. @param faces  (m, 3), whole numbers of any kind, from 0.
/// @param colors  None, or (n, 4) of uint8: red, green, blue, alpha.
/// @throws InvalidArgument for another shape or kind, a coordinate that is not finite, a face without such a vertex.
TriangleSoup soup_of(const pybind11::array& vertices, const pybind11::array& faces, const pybind11::object& colors);

/// An array that keeps the numbers alive and reads them where they are. @param columns  T in each row.
template <class T, class Row>
pybind11::array_t<T> array_of(std::vector<Row> rows) {
  constexpr auto columns = static_cast<pybind11::ssize_t>(sizeof(Row) / sizeof(T));
  static_assert(sizeof(Row) == columns * sizeof(T));
  auto owner = std::make_unique<std::vector<Row>>(std::move(rows));
  const auto count = static_cast<pybind11::ssize_t>(owner->size());
  const auto* first = reinterpret_cast<const T*>(owner->data());
  std::vector<pybind11::ssize_t> shape{count};
  if constexpr (columns > 1) shape.push_back(columns);
  const pybind11::capsule keeper(owner.get(), [](void* kept) { delete static_cast<std::vector<Row>*>(kept); });
  owner.release();
  return pybind11::array_t<T>(shape, first, keeper);
}

inline pybind11::array_t<double> points_array(Points points) { return array_of<double>(std::move(points)); }
inline pybind11::array_t<int> triangles_array(Triangles triangles) { return array_of<int>(std::move(triangles)); }
/// None where there are none.
pybind11::object colors_array(std::vector<Color> colors);

}  // namespace loopmend
