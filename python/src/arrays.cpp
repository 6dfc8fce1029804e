// SPDX-License-Identifier: GPL-3.0-or-later
#include "arrays.h"

#include "core/error.h"

#include <cstdint>
#include <string>

namespace loopmend {

namespace {

namespace py = pybind11;

std::string shape_of(const py::array& array) { return py::str(array.attr("shape")).cast<std::string>(); }

void check_shape(const py::array& array, const char* name, py::ssize_t columns) {
  if (array.ndim() == 2 && array.shape(1) == columns) return;
  throw InvalidArgument(say("%1 must have the shape (n, %2), not %3", std::string(name), columns, shape_of(array)));
}

void check_kind(const py::array& array, const char* name, const std::string& kinds, const char* what) {
  if (kinds.find(array.dtype().kind()) == std::string::npos)
    throw InvalidArgument(
        say("%1 must be %2, not %3", std::string(name), what, py::str(array.dtype()).cast<std::string>()));
}

Points points_of(const py::array& vertices) {
  check_shape(vertices, "vertices", 3);
  check_kind(vertices, "vertices", "fiu", "real numbers");
  const py::array_t<double, py::array::forcecast> numbers(vertices);
  const auto rows = numbers.unchecked<2>();
  Points points(static_cast<std::size_t>(rows.shape(0)));
  for (py::ssize_t i = 0; i < rows.shape(0); ++i) {
    const Vec3 point(rows(i, 0), rows(i, 1), rows(i, 2));
    if (!point.allFinite())
      throw InvalidArgument(
          say("vertex %1 has a coordinate that is no finite number. Remove it and its faces first.", i));
    points[i] = point;
  }
  return points;
}

template <class Number>
Triangles triangles_from(const py::array_t<Number, py::array::forcecast>& faces, std::size_t vertices) {
  const auto rows = faces.template unchecked<2>();
  Triangles triangles(static_cast<std::size_t>(rows.shape(0)));
  for (py::ssize_t f = 0; f < rows.shape(0); ++f)
    for (py::ssize_t c = 0; c < 3; ++c) {
      const Number v = rows(f, c);
      if (v < 0 || static_cast<std::uint64_t>(v) >= vertices)
        throw InvalidArgument(
            say("face %1 names vertex %2, but the mesh has %3 vertices, numbered from 0", f, v, vertices));
      triangles[f][c] = static_cast<int>(v);
    }
  return triangles;
}

Triangles triangles_of(const py::array& faces, std::size_t vertices) {
  check_shape(faces, "faces", 3);
  check_kind(faces, "faces", "iu", "whole numbers");
  if (faces.dtype().kind() == 'u' && faces.itemsize() == 8) return triangles_from<std::uint64_t>(faces, vertices);
  if (faces.itemsize() == 4 && faces.dtype().kind() == 'i') return triangles_from<std::int32_t>(faces, vertices);
  return triangles_from<std::int64_t>(faces, vertices);
}

std::vector<Color> colors_of(const py::object& given, std::size_t vertices) {
  if (given.is_none()) return {};
  const py::array colors = py::array::ensure(given);
  if (!colors) throw InvalidArgument(say("colors must be an array of the shape (n, 4)"));
  check_shape(colors, "colors", 4);
  if (!py::isinstance<py::array_t<std::uint8_t>>(colors))
    throw InvalidArgument(
        say("colors must be of uint8, 0 to 255, not %1", py::str(colors.dtype()).cast<std::string>()));
  const auto rows = py::array_t<std::uint8_t>(colors).unchecked<2>();
  if (static_cast<std::size_t>(rows.shape(0)) != vertices)
    throw InvalidArgument(say("colors must have one row for each of the %1 vertices, not %2", vertices, rows.shape(0)));
  std::vector<Color> result(vertices);
  for (std::size_t i = 0; i < vertices; ++i)
    for (std::size_t c = 0; c < 4; ++c) result[i][c] = rows(static_cast<py::ssize_t>(i), static_cast<py::ssize_t>(c));
  return result;
}

}  // namespace

TriangleSoup soup_of(const py::array& vertices, const py::array& faces, const py::object& colors) {
  TriangleSoup soup;
  soup.points = points_of(vertices);
  soup.triangles = triangles_of(faces, soup.points.size());
  soup.colors = colors_of(colors, soup.points.size());
  return soup;
}

py::object colors_array(std::vector<Color> colors) {
  if (colors.empty()) return py::none();
  return array_of<unsigned char>(std::move(colors));
}

}  // namespace loopmend
