// SPDX-License-Identifier: GPL-3.0-or-later
// Internal: which meshes the scene of a glTF file shows, and where.
#pragma once

#include "io/gltf_document.h"

#include <Eigen/Core>

#include <cstddef>
#include <string>
#include <vector>

namespace loopmend {

struct GltfInstance {
  std::size_t mesh = 0;
  Eigen::Matrix4d place = Eigen::Matrix4d::Identity();
  std::string name;  ///< of the node, else of the mesh; may be empty
};

/// The meshes of the scene that is to be shown, else of the first one, else of all nodes, else all meshes; node by node,
/// parents first. @throws ReadError where nodes go round in circles or are not there
std::vector<GltfInstance> gltf_instances(const GltfDocument& document);

}  // namespace loopmend
