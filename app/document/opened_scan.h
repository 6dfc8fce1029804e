// SPDX-License-Identifier: GPL-3.0-or-later
// A scan as the worker prepared it.
#pragma once

#include "document/packed_session.h"
#include "io/read_mesh.h"
#include "mesh/boundary_loops.h"
#include "mesh/surface_model.h"
#include "scene/surface_shape.h"

#include <QString>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace loopmend {

/// The pieces of a scan that do not hang together, the largest first.
struct ScanPieces {
  struct Piece {
    std::size_t triangles = 0;
    double diameter = 0;   ///< of its box, mesh units
    int first_vertex = 0;  ///< its lowest, of the view
  };
  std::vector<Piece> list;     ///< by falling number of triangles, then by lowest vertex
  std::vector<int> of_vertex;  ///< #V of the view: index into `list`; empty where there is but one

  /// @param vertex  of the view
  int piece_of(int vertex) const { return of_vertex.empty() ? 0 : of_vertex[vertex]; }
};

/// Pieces that have a vertex in common are one, as in mesh/pieces.h.
ScanPieces scan_pieces(const TriMesh& mesh);

enum class ScanOrigin {
  file,
  sample,  ///< the embedded one
  made,    ///< by the window: a region re-evolved, points interpolated, loops blended; in no file yet
};

/// Never changes once it is open; only `shape` comes again, with curvature.
struct OpenedScan {
  QString path;  ///< empty where it is not from a file
  ScanOrigin from = ScanOrigin::file;
  QString name;  ///< as shown
  QString
      repaired_from;  ///< the file whose scan this one is, trimmed, stitched, repaired or bridged; empty where there is none
  KeptFilePtr kept;  ///< where it came out of a session that holds it; `path` may then be of a file that is gone
  ImportReport import;
  std::shared_ptr<const SurfaceModel> model;
  Points laid;  ///< of bridges and the like: see document/laid_points.h; sessions do not keep them
  std::vector<BoundaryLoop> loops;
  ScanPieces pieces;
  Vec3 origin = Vec3::Zero();  ///< of `shape`
  SurfaceShapePtr shape;
  std::vector<SurfaceShapePtr> colored;              ///< the parts that it is drawn by in its own colours
  std::shared_ptr<const std::vector<Color>> colors;  ///< per vertex of the view; null: it has none
  std::vector<Message> color_problems;               ///< sentences
  std::uint64_t fingerprint = 0;  ///< of points and triangles: shows whether a file is still the same
};

std::uint64_t fingerprint_of(const TriangleSoup& soup);

}  // namespace loopmend
