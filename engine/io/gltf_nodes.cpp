// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/gltf_nodes.h"

#include "io/text_cursor.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>

namespace loopmend {

namespace {

using Json = GltfDocument::Json;

class NodeWalk {
 public:
  explicit NodeWalk(const GltfDocument& document)
      : document_(document),
        nodes_(document.list("nodes")),
        seen_(nodes_.size(), 0) {}

  std::vector<GltfInstance> result() {
    if (nodes_.empty()) {
      for (std::size_t mesh = 0; mesh < document_.list("meshes").size(); ++mesh)
        add_mesh(mesh, Eigen::Matrix4d::Identity(), "");
      return std::move(instances_);
    }
    std::vector<std::size_t> roots = scene_roots();
    std::reverse(roots.begin(), roots.end());
    for (const std::size_t root : roots) open_.push_back({root, Eigen::Matrix4d::Identity()});
    while (!open_.empty()) {
      const Open next = open_.back();
      open_.pop_back();
      visit(next);
    }
    return std::move(instances_);
  }

 private:
  struct Open {
    std::size_t node;
    Eigen::Matrix4d parent;
  };

  std::vector<std::size_t> indices(const Json& object, const char* name, const Message& place) const {
    std::vector<std::size_t> result;
    for (const Json& value : document_.list(object, name, place)) {
      const double number = document_.number(value, place);
      if (!(number >= 0) || number >= static_cast<double>(nodes_.size()))
        document_.errors().fail(say("names a node that is not there, %1", value.dump()), place);
      result.push_back(static_cast<std::size_t>(number));
    }
    return result;
  }

  std::vector<std::size_t> scene_roots() const {
    if (const Json& scenes = document_.list("scenes"); !scenes.empty()) {
      const std::size_t scene = document_.whole(document_.root(), "scene", say("the file")).value_or(0);
      return indices(document_.element("scenes", scene, say("the file")), "nodes", say("scene %1", scene));
    }
    std::vector<char> is_child(nodes_.size(), 0);
    for (std::size_t k = 0; k < nodes_.size(); ++k)
      for (const std::size_t child : indices(nodes_[k], "children", place_of(k))) is_child[child] = 1;
    std::vector<std::size_t> roots;
    for (std::size_t k = 0; k < nodes_.size(); ++k)
      if (!is_child[k]) roots.push_back(k);
    if (roots.empty()) document_.errors().fail(say("the nodes go round in circles"), say("nodes"));
    return roots;
  }

  static Message place_of(std::size_t node) { return say("node %1", node); }

  void visit(const Open& open) {
    const Message place = place_of(open.node);
    if (seen_[open.node]++) document_.errors().fail(say("is reached twice: the nodes of glTF are a tree"), place);
    const Json& node = document_.element("nodes", open.node, place);
    const Eigen::Matrix4d own = matrix(node, place);
    const bool is_placed = !own.isIdentity(0);
    const Eigen::Matrix4d here = is_placed ? Eigen::Matrix4d(open.parent * own) : open.parent;
    if (const auto mesh = document_.whole(node, "mesh", place))
      // The node of a skinned mesh does not move it; its joints do, which at rest leave it where it is.
      add_mesh(*mesh, node.contains("skin") ? Eigen::Matrix4d(Eigen::Matrix4d::Identity()) : here,
               GltfDocument::text(node, "name"));
    const std::vector<std::size_t> children = indices(node, "children", place);
    for (auto child = children.rbegin(); child != children.rend(); ++child) open_.push_back({*child, here});
  }

  void add_mesh(std::size_t mesh, const Eigen::Matrix4d& place, std::string name) {
    if (name.empty()) name = GltfDocument::text(document_.element("meshes", mesh, say("nodes")), "name");
    instances_.push_back({mesh, place, std::move(name)});
  }

  /// @returns whether there are so many numbers of that name
  template <std::size_t Size>
  bool read(const Json& node, const char* name, const Message& place, std::array<double, Size>& numbers) const {
    const Json& list = document_.list(node, name, place);
    if (list.empty()) return false;
    if (list.size() != Size) document_.errors().fail(say("%1 has %2 numbers", in_quotes(name), list.size()), place);
    for (std::size_t k = 0; k < Size; ++k) numbers[k] = document_.number(list[k], place);
    return true;
  }

  Eigen::Matrix4d matrix(const Json& node, const Message& place) const {
    Eigen::Matrix4d result = Eigen::Matrix4d::Identity();
    if (std::array<double, 16> all{}; read(node, "matrix", place, all)) {
      result = Eigen::Map<const Eigen::Matrix4d>(all.data());
      return result;
    }
    std::array<double, 3> translation{0, 0, 0}, scale{1, 1, 1};
    std::array<double, 4> rotation{0, 0, 0, 1};
    read(node, "translation", place, translation);
    read(node, "scale", place, scale);
    if (read(node, "rotation", place, rotation)) {
      Eigen::Quaterniond turn(rotation[3], rotation[0], rotation[1], rotation[2]);
      if (!(turn.norm() > 0)) document_.errors().fail(say("\"rotation\" is none"), place);
      const bool is_unit = turn.coeffs() == Eigen::Vector4d(0, 0, 0, 1);
      if (!is_unit) result.topLeftCorner<3, 3>() = turn.normalized().toRotationMatrix();
    }
    result.topLeftCorner<3, 3>() *= Eigen::Vector3d(scale[0], scale[1], scale[2]).asDiagonal();
    result.topRightCorner<3, 1>() = Eigen::Vector3d(translation[0], translation[1], translation[2]);
    return result;
  }

  const GltfDocument& document_;
  const Json& nodes_;
  std::vector<char> seen_;
  std::vector<Open> open_;
  std::vector<GltfInstance> instances_;
};

}  // namespace

std::vector<GltfInstance> gltf_instances(const GltfDocument& document) { return NodeWalk(document).result(); }

}  // namespace loopmend
