// SPDX-License-Identifier: GPL-3.0-or-later
// What a mesh carries beside its arrays: the attributes of its file, or values that Python hands over. Opaque to Python.
#pragma once

#include "mesh/triangle_soup.h"

#include <pybind11/pybind11.h>

#include <memory>
#include <vector>

namespace loopmend {

/// The rows of a soup (mesh/triangle_soup.h) without its points and triangles.
struct Carried {
  std::shared_ptr<const ScanAttributes> attributes;
  std::vector<int> point_rows, triangle_rows;
};

/// None where the soup has no attributes.
pybind11::object carried_by(const TriangleSoup& soup);

/// Whether it comes from arrays of a foreign mesh, not from a file.
bool is_of_arrays(const pybind11::object& carried);

/// @param carried  None, or what carried_by() gave. @throws InvalidArgument where the soup has fewer points or triangles than it.
void carry(const pybind11::object& carried, TriangleSoup& soup);

/// The class Carried, and the functions carry_values and carried_values.
void define_carried(pybind11::module_& m);

}  // namespace loopmend
