// SPDX-License-Identifier: GPL-3.0-or-later
// Internal: what a model part of a 3MF package says, before its objects are put in place.
#pragma once

#include "core/types.h"
#include "io/file_content.h"
#include "io/not_kept.h"
#include "io/zip_archive.h"

#include <Eigen/Core>

#include <array>
#include <map>
#include <string>
#include <utility>
#include <vector>

namespace loopmend {

struct PackageTriangle {
  Triangle vertices{};
  int group = -1;                          ///< id of the materials or colours; −1: those of the object
  std::array<int, 3> members{-1, -1, -1};  ///< of the group, per corner
};

/// Another object, or the same, at a place.
struct PackageReference {
  std::string part;  ///< its name, as part_key() makes it
  int object = 0;
  Eigen::Matrix4d place = Eigen::Matrix4d::Identity();
};

struct PackageObject {
  std::string name;
  int group = -1, member = -1;
  Points points;
  std::vector<PackageTriangle> triangles;
  std::vector<PackageReference> components;
};

struct PackageMaterial {
  std::string name;
  Color color{};
};

struct PackageModel {
  std::string unit = "millimeter";
  std::map<int, PackageObject> objects;
  std::map<int, std::vector<PackageMaterial>> materials;  ///< basematerials
  std::map<int, std::vector<Color>> colors;               ///< colorgroup
  std::vector<PackageReference> items;
  std::vector<std::pair<std::string, std::string>> metadata;
  std::vector<NotKept> not_kept;
};

/// Names of parts are compared without regard to case and to the slash before them.
std::string part_key(std::string_view name);

/// @param part  its name in the archive. @throws ReadError for bad XML, numbers that are none, vertices that are not there,
/// extensions that must be known and are not
PackageModel read_package_model(const FileContent& file, const ZipArchive& archive, const std::string& part);

/// The name of the part that a reader begins with. @throws ReadError where the archive is no 3MF
std::string root_model(const FileContent& file, const ZipArchive& archive);

}  // namespace loopmend
