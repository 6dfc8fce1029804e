// SPDX-License-Identifier: GPL-3.0-or-later
// The programs that people use instead, run on the same holes. CGAL stays in its own .cpp file.
#pragma once

#include "filling_result.h"

#include <vector>

namespace loopmend::bench {

enum class Peer {
  cgal_c1,  ///< CGAL triangulate_refine_and_fair_hole, default: continuity 1
  cgal_c2,  ///< the same with fairing_continuity(2)
  // On CGAL's refined patch these two would give CGAL's own results to all digits: its fairing is the same equation.
  harmonic_2,  ///< biharmonic fairing, k = 2, of our own remeshed initial patch, as by libigl's harmonic()
  harmonic_3,  ///< triharmonic, k = 3, likewise
};

inline constexpr Peer all_peers[] = {Peer::cgal_c1, Peer::cgal_c2, Peer::harmonic_2, Peer::harmonic_3};

const char* to_string(Peer peer);

/// Fills the problem's loops one after another. Never throws for a hole that the peer cannot fill: the status says so.
Filling fill_by_peer(const HoleProblem& problem, Peer peer);

/// All loops of a mesh by CGAL's triangulate_refine_and_fair_hole.
/// @returns new points, triangles over the mesh's and the new points; empty on failure.
Filling fill_by_cgal(const Points& points, const Triangles& triangles, const std::vector<std::vector<int>>& loops,
                     unsigned continuity);

/// CGAL's fairing of the first `free` points, the others fixed. @returns seconds of that call alone, −1 on failure.
double seconds_of_cgal_fairing(const Points& points, const Triangles& triangles, int free, unsigned continuity);

/// Moves the filling's own points to the solution of the k-harmonic equation Δᵏx = 0, k = 2 or 3 (cotan weights, Voronoi
/// masses), with everything else fixed. @returns false if the system could not be solved.
bool make_harmonic(const Points& points, const Triangles& triangles, Filling& filling, int k);

}  // namespace loopmend::bench
