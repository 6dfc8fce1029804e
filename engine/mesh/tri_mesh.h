// SPDX-License-Identifier: GPL-3.0-or-later
// TriMesh: OpenMesh's halfedge triangle mesh with double coordinates held as Eigen vectors.
#pragma once

#include "core/types.h"

#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>
// After a core header, as OpenMesh wants it.
#include <OpenMesh/Core/Geometry/EigenVectorT.hh>

namespace loopmend {

struct TriMeshTraits : OpenMesh::DefaultTraits {
  using Point = Eigen::Vector3d;
  using Normal = Eigen::Vector3d;
  // Status only where something is deleted (request_vertex_status() and so on): it would take 12 bytes a face.
  VertexAttributes(OpenMesh::Attributes::None);
  EdgeAttributes(OpenMesh::Attributes::None);
  FaceAttributes(OpenMesh::Attributes::None);
  HalfedgeAttributes(OpenMesh::Attributes::PrevHalfedge);
};

/// `mesh.add_vertex(mesh.point(v))` is a dangling reference in OpenMesh: copy the point first.
using TriMesh = OpenMesh::TriMesh_ArrayKernelT<TriMeshTraits>;

}  // namespace loopmend
