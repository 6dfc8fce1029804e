// SPDX-License-Identifier: GPL-3.0-or-later
#include "carried.h"

#include "arrays.h"

#include "core/error.h"
#include "mesh/scan_attributes.h"
#include "pipeline/continue_attributes.h"

#include <pybind11/stl.h>

#include <algorithm>
#include <string>
#include <utility>

namespace loopmend {

namespace {

namespace py = pybind11;
using namespace py::literals;
using Values = py::array_t<double, py::array::c_style | py::array::forcecast>;

constexpr const char* of_arrays = "arrays";  ///< format of what comes from no file

/// A column with the number of each row, and one for each column of `values`.
std::vector<AttributeColumn> columns_of(const Values& values, const std::vector<std::string>& names) {
  if (values.ndim() != 2 || values.shape(1) != static_cast<py::ssize_t>(names.size()))
    throw InvalidArgument(say("there must be a name for each column of the values"));
  const auto rows = values.unchecked<2>();
  std::vector<AttributeColumn> columns{AttributeColumn("row", ScalarType::int32)};
  for (py::ssize_t r = 0; r < rows.shape(0); ++r) columns.front().push(static_cast<double>(r));
  for (py::ssize_t c = 0; c < rows.shape(1); ++c) {
    AttributeColumn& column = columns.emplace_back(names[c], ScalarType::float64);
    for (py::ssize_t r = 0; r < rows.shape(0); ++r) column.push(rows(r, c));
  }
  return columns;
}

Carried carry_values(const Values& of_points, const std::vector<std::string>& point_names, const Values& of_faces,
                     const std::vector<std::string>& face_names) {
  auto attributes = std::make_shared<ScanAttributes>();
  attributes->format = of_arrays;
  attributes->points = columns_of(of_points, point_names);
  attributes->faces = columns_of(of_faces, face_names);
  attributes->point_count = static_cast<std::size_t>(of_points.shape(0));
  attributes->triangle_count = static_cast<std::size_t>(of_faces.shape(0));
  return {std::move(attributes), {}, {}};
}

/// The row of each point or triangle, for what is new that of the nearest one, and the values, which run on over what is new.
/// @param row_of  of the file; −1: new
template <class RowOf>
py::tuple values_of(const std::vector<AttributeColumn>& given, const std::vector<AttributeColumn>& continued,
                    std::size_t count, const RowOf& row_of) {
  const auto columns = static_cast<py::ssize_t>(given.size()) - 1;
  std::vector<int> rows;
  py::array_t<double> values({static_cast<py::ssize_t>(count), columns});
  auto value = values.mutable_unchecked<2>();
  std::size_t next = 0;
  for (std::size_t k = 0; k < count; ++k) {
    const int row = row_of(k);
    const std::vector<AttributeColumn>& from = row >= 0 ? given : continued;
    const std::size_t at = row >= 0 ? static_cast<std::size_t>(row) : next++;
    rows.push_back(static_cast<int>(from.front().value(at)));
    for (py::ssize_t c = 0; c < columns; ++c)
      value(static_cast<py::ssize_t>(k), c) = from[static_cast<std::size_t>(c) + 1].value(at);
  }
  return py::make_tuple(array_of<int>(std::move(rows)), values);
}

py::tuple carried_values(const py::array& vertices, const py::array& faces, const py::object& carried) {
  TriangleSoup soup = soup_of(vertices, faces, py::none());
  carry(carried, soup);
  if (!soup.attributes) throw InvalidArgument(say("nothing is carried"));
  continue_attributes(soup);
  const ScanAttributes none;
  const ScanAttributes &given = *soup.attributes, &continued = soup.continued ? *soup.continued : none;
  return py::make_tuple(
      values_of(given.points, continued.points, soup.points.size(), [&](std::size_t k) { return point_row(soup, k); }),
      values_of(given.faces, continued.faces, soup.triangles.size(),
                [&](std::size_t k) { return triangle_row(soup, k); }));
}

}  // namespace

py::object carried_by(const TriangleSoup& soup) {
  if (!soup.attributes) return py::none();
  return py::cast(Carried{soup.attributes, soup.point_rows, soup.triangle_rows});
}

bool is_of_arrays(const py::object& carried) {
  return !carried.is_none() && carried.cast<const Carried&>().attributes->format == of_arrays;
}

void carry(const py::object& carried, TriangleSoup& soup) {
  if (carried.is_none()) return;
  const auto& rows = carried.cast<const Carried&>();
  const std::size_t points = rows.point_rows.empty() ? rows.attributes->point_count : rows.point_rows.size();
  const std::size_t triangles =
      rows.triangle_rows.empty() ? rows.attributes->triangle_count : rows.triangle_rows.size();
  if (points > std::max<std::size_t>(soup.points.size(), 1) ||
      triangles > std::max<std::size_t>(soup.triangles.size(), 1))
    throw InvalidArgument(say(
        "the mesh has fewer vertices or faces than what it carries: leave `carried` out where you change the arrays"));
  soup.attributes = rows.attributes;
  soup.point_rows = rows.point_rows;
  soup.triangle_rows = rows.triangle_rows;
}

void define_carried(py::module_& m) {
  py::class_<Carried>(m, "Carried", "What a mesh carries beside its arrays. fill() and write() hand it on.");
  m.def("carry_values", &carry_values, "of_points"_a, "point_names"_a, "of_faces"_a, "face_names"_a);
  m.def("carried_values", &carried_values, "vertices"_a, "faces"_a, "carried"_a);
}

}  // namespace loopmend
