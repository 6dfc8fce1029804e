// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/gltf_materials.h"

#include "core/error.h"
#include "core/path_text.h"
#include "io/color_spaces.h"
#include "io/file_content.h"
#include "io/painted_material.h"
#include "io/polygon_soup.h"

#include <functional>
#include <set>
#include <utility>

namespace loopmend {

namespace {

using Json = nlohmann::json;

bool is_texture_reference(const Json& value) { return value.is_object() && value.contains("index"); }

/// Files have one set of texture coordinates when they are written. The text is nested 64 deep at most.
std::size_t remove_references(Json& part, const std::function<bool(const Json&)>& is_unwanted) {
  std::size_t count = 0;
  if (!part.is_structured()) return 0;
  for (auto member = part.begin(); member != part.end();) {
    if (part.is_object() && is_texture_reference(*member) && is_unwanted(*member)) {
      member = part.erase(member);
      ++count;
      continue;
    }
    count += remove_references(*member, is_unwanted);
    ++member;
  }
  return count;
}

const Json* transform_of(const Json& reference) {
  const Json* extensions = GltfDocument::find(reference, "extensions");
  return extensions ? GltfDocument::find(*extensions, "KHR_texture_transform") : nullptr;
}

bool is_of_other_coordinates(const Json& reference) {
  const auto is_other = [](const Json* set) { return set && !(set->is_number() && set->get<double>() == 0); };
  const Json* transform = transform_of(reference);
  return is_other(GltfDocument::find(reference, "texCoord")) ||
         (transform && is_other(GltfDocument::find(*transform, "texCoord")));
}

ScanPicture read_picture_entry(GltfDocument& document, const Json& image, const Message& place) {
  ScanPicture picture;
  if (!image.is_object()) document.errors().fail(say("a picture is no object"), place);
  picture.name = GltfDocument::text(image, "name");
  picture.kind = GltfDocument::text(image, "mimeType");
  if (const std::optional<std::size_t> view = document.whole(image, "bufferView", place)) {
    picture.bytes = document.view(*view, place);
  } else if (const Json* uri = GltfDocument::find(image, "uri"); uri && uri->is_string()) {
    const auto& name = uri->get_ref<const std::string&>();
    if (GltfDocument::is_data(name))
      picture.bytes = document.data_of(name, place, picture.kind.empty() ? &picture.kind : nullptr);
    else
      picture.problem = document.find_beside(name, picture.path);
    if (picture.name.empty() && !picture.path.empty()) picture.name = path_text(picture.path.filename());
  }
  if (picture.bytes.empty() && picture.path.empty() && picture.problem.empty())
    picture.problem = say("there are no data");
  if (!picture.problem.empty()) picture.problem = say("The %1 of the scan cannot be used: %2.", place, picture.problem);
  return picture;
}

std::optional<Color> base_color(const GltfDocument& document, const Json& pbr, const Message& place) {
  const Json& factor = document.list(pbr, "baseColorFactor", place);
  if (factor.size() != 4) return {};
  Color color{};
  for (std::size_t k = 0; k < 4; ++k) {
    const double value = document.number(factor[k], place);
    color.at(k) = color_channel(k < 3 ? srgb_from_linear(value) : value, 1);
  }
  return color;
}

/// The picture of a material's colour; −1: none that can be shown as it is.
int base_picture(const GltfDocument& document, const Json& pbr, std::size_t pictures, const Message& place) {
  const Json* reference = GltfDocument::find(pbr, "baseColorTexture");
  if (!reference || transform_of(*reference)) return -1;
  const std::optional<std::size_t> texture = document.whole(*reference, "index", place);
  if (!texture) return -1;
  const std::optional<std::size_t> source =
      document.whole(document.element("textures", *texture, place), "source", place);
  return source && *source < pictures ? static_cast<int>(*source) : -1;
}

/// Numbers of pictures under "source", here and in extensions; those that are left out go.
void renumber_sources(Json& texture, const std::vector<int>& image_of) {
  if (!texture.is_object()) return;
  if (const auto source = texture.find("source"); source != texture.end()) {
    const bool known = source->is_number_unsigned() && source->get<std::uint64_t>() < image_of.size();
    const int image = known ? image_of[source->get<std::size_t>()] : -1;
    if (image < 0)
      texture.erase(source);
    else
      *source = image;
  }
  if (const auto extensions = texture.find("extensions"); extensions != texture.end() && extensions->is_object())
    for (Json& extension : *extensions) renumber_sources(extension, image_of);
}

void collect_extensions(const Json& part, std::set<std::string>& names) {
  if (!part.is_structured()) return;
  if (const Json* extensions = GltfDocument::find(part, "extensions"); extensions && extensions->is_object())
    for (const auto& [name, value] : extensions->items()) names.insert(name);
  for (const Json& value : part) collect_extensions(value, names);
}

std::string kind_of(const ScanPicture& picture) {
  const std::string_view bytes = picture.bytes;
  if (bytes.substr(0, 4) == "\x89PNG") return "image/png";
  if (bytes.substr(0, 2) == "\xFF\xD8") return "image/jpeg";
  return picture.kind.empty() ? "image/png" : picture.kind;
}

/// Materials of other formats have no text.
Json material_json(const ScanMaterial& material, const std::vector<int>& image_of, Json& textures) {
  Json json = material.source.empty() ? Json::object() : Json::parse(material.source);
  if (material.source.empty() && !material.name.empty()) json["name"] = material.name;
  const int image = material.picture >= 0 ? image_of.at(static_cast<std::size_t>(material.picture)) : -1;
  if (!material.source.empty() && image < 0) return json;
  Json& pbr = json["pbrMetallicRoughness"];
  if (material.source.empty()) {
    pbr["metallicFactor"] = 0;
    if (material.color && image < 0) {
      Json& factor = pbr["baseColorFactor"] = Json::array();
      for (std::size_t k = 0; k < 4; ++k) {
        const double value = material.color->at(k) / 255.0;
        factor.push_back(k < 3 ? linear_from_srgb(value) : value);
      }
      if (material.color->at(3) < 255) json["alphaMode"] = "BLEND";
    }
  }
  if (image >= 0 && !pbr.contains("baseColorTexture")) {
    pbr["baseColorTexture"] = {{"index", textures.size()}};
    textures.push_back({{"source", image}});
  }
  return json;
}

}  // namespace

std::shared_ptr<const MaterialTable> read_gltf_materials(GltfDocument& document, std::vector<NotKept>& not_kept) {
  const Json& materials = document.list("materials");
  const Json* asset = GltfDocument::find(document.root(), "asset");
  const std::string copyright = asset ? GltfDocument::text(*asset, "copyright") : "";
  if (materials.empty() && copyright.empty()) return nullptr;
  auto table = std::make_shared<MaterialTable>();
  Json source = Json::object();
  if (!copyright.empty()) source["copyright"] = copyright;
  if (!materials.empty()) {
    for (const char* name : {"textures", "samplers"})
      if (const Json& list = document.list(name); !list.empty()) source[name] = list;
    Json& required = source["extensionsRequired"] = Json::array();
    for (const Json& name : document.list("extensionsRequired"))
      if (name.is_string() && name != "KHR_mesh_quantization") required.push_back(name);
    const Json& images = document.list("images");
    for (std::size_t k = 0; k < images.size(); ++k)
      table->pictures.push_back(read_picture_entry(document, images[k], say("picture %1", k)));
  }
  std::size_t others = 0;
  for (std::size_t k = 0; k < materials.size(); ++k) {
    const Message place = say("material %1", k);
    Json material = document.element("materials", k, say("materials"));
    others += remove_references(material, is_of_other_coordinates);
    ScanMaterial& mine = table->materials.emplace_back();
    mine.name = GltfDocument::text(material, "name");
    if (mine.name.empty()) mine.name = "material_" + std::to_string(k);
    if (const Json* pbr = GltfDocument::find(material, "pbrMetallicRoughness")) {
      if (!pbr->is_object()) document.errors().fail(say("\"pbrMetallicRoughness\" is no object"), place);
      mine.color = base_color(document, *pbr, place);
      mine.picture = base_picture(document, *pbr, table->pictures.size(), place);
    }
    mine.source = material.dump();
  }
  count_not_kept(not_kept, say("pictures of materials at further texture coordinates"), others);
  table->source = source.dump();
  return table;
}

GltfMaterials write_gltf_materials(const MaterialTable& table) {
  GltfMaterials result;
  const Json source = table.source.empty() ? Json::object() : Json::parse(table.source);
  result.copyright = GltfDocument::text(source, "copyright");
  std::vector<int> image_of;
  for (const ScanPicture& picture : table.pictures) {
    ScanPicture image = picture;
    if (image.bytes.empty() && !image.path.empty()) {
      try {
        image.bytes = load_bytes(image.path).bytes;
      } catch (const ReadError&) {
        // Said by whoever shows or paints it.
      }
    }
    image_of.push_back(image.bytes.empty() ? -1 : static_cast<int>(result.images.size()));
    if (image.bytes.empty()) continue;
    image.kind = kind_of(image);
    result.images.push_back(std::move(image));
  }
  Json textures = source.value("textures", Json::array());
  for (Json& texture : textures) renumber_sources(texture, image_of);
  Json materials = Json::array();
  for (const ScanMaterial& material : table.materials) materials.push_back(material_json(material, image_of, textures));
  std::set<std::string> extensions;
  collect_extensions(materials, extensions);
  collect_extensions(textures, extensions);
  const Json required = source.value("extensionsRequired", Json::array());
  for (const Json& name : required) extensions.insert(name.get<std::string>());
  result.members = Json::object();
  if (!materials.empty()) result.members["materials"] = std::move(materials);
  if (!textures.empty()) result.members["textures"] = std::move(textures);
  if (source.contains("samplers")) result.members["samplers"] = source["samplers"];
  if (!extensions.empty()) result.members["extensionsUsed"] = extensions;
  if (!required.empty()) result.members["extensionsRequired"] = required;
  return result;
}

int GltfMaterials::without_pictures(int material) {
  const auto known = plain_.find(material);
  if (known != plain_.end()) return known->second;
  Json& materials = members["materials"];
  Json plain = materials.at(static_cast<std::size_t>(material));
  const bool glows = plain.contains("emissiveTexture");
  int& number = plain_[material] = material;
  if (remove_references(plain, [](const Json&) { return true; }) == 0) return number;
  if (glows) plain.erase("emissiveFactor");  // else all of it would glow
  plain["name"] = plain.value("name", "material_" + std::to_string(material)) + "_without_picture";
  number = static_cast<int>(materials.size());
  materials.push_back(std::move(plain));
  return number;
}

int add_painted_material(MaterialTable& table, const std::string& name, int like, std::string png) {
  ScanMaterial made;
  if (like >= 0) made = table.materials.at(static_cast<std::size_t>(like));
  made.name = name;
  made.picture = static_cast<int>(table.pictures.size());
  if (!made.source.empty()) {
    Json source = Json::parse(made.source);
    remove_references(source, [](const Json&) { return true; });
    source["name"] = name;
    made.source = source.dump();
  }
  ScanPicture picture;
  picture.name = name;
  picture.kind = "image/png";
  picture.bytes = std::move(png);
  table.pictures.push_back(std::move(picture));
  table.materials.push_back(std::move(made));
  return static_cast<int>(table.materials.size()) - 1;
}

}  // namespace loopmend
