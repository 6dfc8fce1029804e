// SPDX-License-Identifier: GPL-3.0-or-later
// How stiffness, areas and normals of a triangle mesh change with its points.
#pragma once

#include "operators/operator_set.h"

#include <functional>

namespace loopmend {

/// Adds the derivative with respect to the points of Σ w_ij f(i, j), w_ij the clamped weight of an edge as in
/// clamped_cotan_stiffness(); f is kept. An edge at a limit of the clamp has none.
/// @param stiffness  over the same triangles. @param f  symmetric. @param derivative  #V.
void add_stiffness_derivative(const Points& points, const Triangles& triangles, const std::vector<int>& faces,
                              const SparseMatrix& stiffness, CotanClamp clamp, const std::function<double(int, int)>& f,
                              Points& derivative);

/// Adds that of Σ M_i f_i, M the barycentric_areas(). Areas at their least value have none.
void add_area_derivative(const Points& points, const Triangles& triangles, const Eigen::VectorXd& areas,
                         const Eigen::VectorXd& f, Points& derivative);

/// Adds that of Σ ⟨n_i, f_i⟩, n the angle_weighted_normals().
void add_normal_derivative(const Points& points, const Triangles& triangles, const Points& f, Points& derivative);

}  // namespace loopmend
