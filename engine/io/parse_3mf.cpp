// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/package_model.h"
#include "io/parse_errors.h"
#include "io/polygon_soup.h"
#include "io/text_cursor.h"
#include "mesh/material_table.h"

#include <Eigen/Geometry>
#include <Eigen/LU>

#include <algorithm>
#include <array>
#include <limits>
#include <memory>
#include <set>
#include <string>
#include <utility>

namespace loopmend {

namespace {

/// Puts the objects of a package in place.
class PackageReader {
 public:
  explicit PackageReader(const FileContent& file) : file_(file), errors_(file), archive_(file) {}

  PolygonSoup read() {
    const std::string root = root_model(file_, archive_);
    const PackageModel& model = part(part_key(root));
    std::vector<PackageReference> items = model.items;
    if (items.empty()) {
      count_not_kept(soup_.oddities, say("no build: every object is taken"));
      for (const auto& [id, object] : model.objects)
        if (!object.triangles.empty()) items.push_back({part_key(root), id, Eigen::Matrix4d::Identity()});
    }
    for (const PackageReference& item : items) add(item, Eigen::Matrix4d::Identity(), 0);
    finish(model);
    return std::move(soup_);
  }

 private:
  static constexpr int most_depth = 64;
  static constexpr std::size_t most_references = 1'000'000;

  const PackageModel& part(const std::string& key) {
    const auto known = parts_.find(key);
    if (known != parts_.end()) return known->second;
    PackageModel model = read_package_model(file_, archive_, key);
    if (!parts_.empty() && model.unit != parts_.begin()->second.unit)
      errors_.fail(say("its parts have different units, %1 and %2", model.unit, parts_.begin()->second.unit),
                   verbatim(key), say("Export it again."));
    for (const NotKept& aside : model.not_kept) count_not_kept(soup_.not_kept, aside.what, aside.count);
    for (const auto& [id, object] : model.objects) stored_ += object.triangles.size();
    first_material_[key] = {};
    for (const auto& [id, materials] : model.materials) {
      first_material_[key][id] = static_cast<int>(table_.materials.size());
      for (const PackageMaterial& material : materials) {
        const std::string name =
            material.name.empty() ? "material_" + std::to_string(table_.materials.size()) : material.name;
        table_.materials.push_back({name, material.color, -1, {}});
      }
    }
    return parts_.emplace(key, std::move(model)).first->second;
  }

  void add(const PackageReference& reference, const Eigen::Matrix4d& parent, int depth) {
    const Message place = say("object %1 of %2", reference.object, reference.part);
    if (depth > most_depth) errors_.fail(say("objects are made of one another more than %1 deep", most_depth), place);
    if (++references_ > most_references)
      errors_.fail(say("more than %1 objects", most_references), place, say("Export it with fewer copies."));
    const PackageModel& model = part(reference.part);
    const auto found = model.objects.find(reference.object);
    if (found == model.objects.end()) errors_.fail(say("names an object that is not there"), place);
    const bool is_placed = !reference.place.isIdentity(0);
    moved_ += is_placed;
    const Eigen::Matrix4d here = is_placed ? Eigen::Matrix4d(parent * reference.place) : parent;
    const PackageObject& object = found->second;
    if (!object.triangles.empty()) add_mesh(model, reference, object, here, place);
    for (const PackageReference& component : object.components) add(component, here, depth + 1);
  }

  void add_mesh(const PackageModel& model, const PackageReference& reference, const PackageObject& object,
                const Eigen::Matrix4d& here, const Message& place) {
    constexpr std::size_t always = 2'000'000, copies = 64;
    if (soup_.polygon_count() + object.triangles.size() > std::max(always, copies * stored_))
      errors_.fail(say("the same triangles are there again and again, in all more than %1", soup_.polygon_count()),
                   place, say("Export it with fewer copies."));
    const bool is_placed = !here.isIdentity(0);
    const std::size_t first = soup_.points.size();
    if (first + object.points.size() > static_cast<std::size_t>(std::numeric_limits<int>::max()))
      errors_.fail(say("more than 2147483647 vertices"), {});
    for (const Vec3& given : object.points) {
      const Vec3 point = is_placed ? Vec3((here * given.homogeneous()).head<3>()) : given;
      if (!point.allFinite()) errors_.not_finite(soup_.points.size() - first, place);
      soup_.points.push_back(point);
    }
    const bool is_mirrored = here.topLeftCorner<3, 3>().determinant() < 0;
    for (const PackageTriangle& triangle : object.triangles) {
      const bool own = triangle.group >= 0 || triangle.members[0] >= 0;
      const int group = triangle.group >= 0 ? triangle.group : object.group;
      std::array<int, 3> members = triangle.members;
      if (!own || members[0] < 0) members.fill(object.member);
      std::array<std::size_t, 3> order = {0, 1, 2};
      if (is_mirrored) std::swap(order[1], order[2]);
      for (const std::size_t k : order) soup_.corners.push_back(static_cast<int>(first) + triangle.vertices[k]);
      soup_.close_polygon();
      add_color(model, reference.part, group, {members[order[0]], members[order[1]], members[order[2]]}, place);
    }
    object_names_.push_back(object.name.empty() ? "object_" + std::to_string(reference.object) : object.name);
    object_faces_.resize(soup_.polygon_count(), static_cast<int>(object_names_.size()) - 1);
    is_named_ = is_named_ || !object.name.empty();
  }

  void add_color(const PackageModel& model, const std::string& part, int group, const std::array<int, 3>& members,
                 const Message& place) {
    int material = -1;
    const auto require = [&](std::size_t size) {
      for (const int member : members)
        if (member < 0 || static_cast<std::size_t>(member) >= size)
          errors_.fail(say("names member %1 of property group %2, which has %3", member, group, size), place);
    };
    if (const auto materials = model.materials.find(group); materials != model.materials.end()) {
      require(materials->second.size());
      material = first_material_[part][group] + members[0];
    } else if (const auto colors = model.colors.find(group); colors != model.colors.end()) {
      require(colors->second.size());
      face_colors_.resize(soup_.polygon_count() - 1, {opaque_white, opaque_white, opaque_white});
      auto& mine = face_colors_.emplace_back();
      for (std::size_t k = 0; k < 3; ++k) mine[k] = colors->second[members[k]];
      differ_ = differ_ || mine[0] != mine[1] || mine[1] != mine[2];
    } else if (group >= 0) {
      ++unknown_groups_;
    }
    materials_.push_back(material);
  }

  void finish(const PackageModel& root) {
    ScanAttributes& scan = soup_.attributes;
    scan.unit = root.unit;
    if (is_named_ || object_names_.size() > 1)
      scan.names.push_back({"o", std::move(object_names_), std::move(object_faces_)});
    finish_colors();
    if (!table_.materials.empty()) {
      FaceNames& names = scan.names.emplace_back();
      names.keyword = "usemtl";
      for (const ScanMaterial& material : table_.materials) names.names.push_back(material.name);
      names.of_face = std::move(materials_);
    }
    table_.metadata = root.metadata;
    if (!table_.materials.empty() || !table_.metadata.empty())
      scan.materials = std::make_shared<MaterialTable>(std::move(table_));
    count_not_kept(soup_.not_kept, say("transforms of objects, which are applied"), moved_);
    count_not_kept(soup_.not_kept, say("faces with properties of other kinds"), unknown_groups_);
    std::set<std::string> known = {"_rels/.rels", "[content_types].xml"};
    for (const auto& [key, model] : parts_) known.insert(key);
    std::size_t others = 0;
    for (const std::string& name : archive_.names()) {
      const std::string key = part_key(name);
      const bool is_plumbing = key.empty() || key.back() == '/' || key.find("_rels/") != std::string::npos;
      others += !is_plumbing && !known.contains(key);
    }
    count_not_kept(soup_.not_kept, say("further parts of the archive"), others);
  }

  /// Of faces where each has one, else of vertices: of several at one vertex the first counts.
  void finish_colors() {
    if (face_colors_.empty()) return;
    face_colors_.resize(soup_.polygon_count(), {opaque_white, opaque_white, opaque_white});
    if (!differ_) {
      constexpr std::array<const char*, 4> names = {"red", "green", "blue", "alpha"};
      for (std::size_t c = 0; c < 4; ++c) {
        AttributeColumn& column = soup_.attributes.faces.emplace_back(names[c], ScalarType::uint8);
        for (const auto& colors : face_colors_) column.push(colors[0].at(c));
      }
      return;
    }
    soup_.colors.assign(soup_.points.size(), opaque_white);
    std::vector<char> has(soup_.points.size(), 0);
    std::size_t apart = 0;
    for (std::size_t c = 0; c < soup_.corners.size(); ++c) {
      const auto v = static_cast<std::size_t>(soup_.corners[c]);
      const Color& color = face_colors_[c / 3][c % 3];
      if (!std::exchange(has[v], 1))
        soup_.colors[v] = color;
      else
        apart += soup_.colors[v] != color;
    }
    soup_.missing_colors = static_cast<std::size_t>(std::count(has.begin(), has.end(), 0));
    count_not_kept(soup_.not_kept, say("further colours at one vertex"), apart);
  }

  const FileContent& file_;
  ParseErrors errors_;
  ZipArchive archive_;
  PolygonSoup soup_;
  std::map<std::string, PackageModel> parts_;
  std::map<std::string, std::map<int, int>> first_material_;  // part → group → place in the table
  MaterialTable table_;
  std::vector<int> materials_, object_faces_;  // per face
  std::vector<std::string> object_names_;
  std::vector<std::array<Color, 3>> face_colors_;
  std::size_t stored_ = 0, references_ = 0, moved_ = 0, unknown_groups_ = 0;
  bool differ_ = false, is_named_ = false;
};

}  // namespace

PolygonSoup parse_3mf(const FileContent& file) { return PackageReader(file).read(); }

}  // namespace loopmend
