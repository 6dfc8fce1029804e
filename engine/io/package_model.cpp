// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/package_model.h"

#include "core/error.h"
#include "io/polygon_soup.h"
#include "io/text_cursor.h"
#include "io/xml_events.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace loopmend {

namespace {

std::string printable(std::string_view text) {
  std::string result(text);
  for (char& c : result)
    if (static_cast<unsigned char>(c) < ' ' || c == '\x7F') c = '_';
  return result;
}

/// "#RRGGBB" or "#RRGGBBAA".
std::optional<Color> color_of(std::string_view text) {
  if (text.empty() || text[0] != '#' || (text.size() != 7 && text.size() != 9)) return {};
  Color color{0, 0, 0, 255};
  for (std::size_t k = 1; k < text.size(); ++k) {
    constexpr std::string_view hex = "0123456789abcdef";
    const std::size_t digit = hex.find(ascii_lower(text[k]));
    if (digit == std::string_view::npos) return {};
    unsigned char& channel = color.at((k - 1) / 2);
    channel = static_cast<unsigned char>(k % 2 == 1 ? 16 * digit : channel + digit);
  }
  return color;
}

class ModelReader {
 public:
  ModelReader(const FileContent& file, const ZipArchive& archive, const std::string& part)
      : file_(file),
        archive_(archive),
        part_(part),
        xml_(file, part, handlers_) {}

  PackageModel read() {
    archive_.read(part_, [&](std::string_view piece) { xml_.feed(piece); });
    xml_.finish();
    if (!is_model_) fail(say("the part holds no model"));
    return std::move(model_);
  }

 private:
  [[noreturn]] void fail(
      const Message& problem,
      const Message& cure = say("The file is damaged or incomplete; export or copy it again.")) const {
    throw ReadError(file_.path, problem, xml_.place(), cure);
  }

  std::string_view needed(const XmlAttributes& attributes, const char* name) const {
    const std::optional<std::string_view> value = attributes.find(name);
    if (!value) fail(say("%1 is missing", in_quotes(name)));
    return *value;
  }

  double number(const XmlAttributes& attributes, const char* name) const {
    const std::string_view text = needed(attributes, name);
    const std::optional<double> value = parse_double(text);
    if (!value || !std::isfinite(*value)) fail(say("%1 stands where a coordinate should be", in_quotes(text)));
    return *value;
  }

  /// @param fallback  where there is none; needed without
  int whole(const XmlAttributes& attributes, const char* name, std::optional<int> fallback = {}) const {
    const std::optional<std::string_view> text = attributes.find(name);
    if (!text && fallback) return *fallback;
    const std::optional<std::int64_t> value = parse_integer(needed(attributes, name));
    if (!value || *value < 0 || *value > std::numeric_limits<int>::max())
      fail(say("%1 stands where \"%2\" should be", in_quotes(*text), name));
    return static_cast<int>(*value);
  }

  void begin(std::string_view element, const XmlAttributes& attributes) {
    if (element == "vertex") return add_vertex(attributes);
    if (element == "triangle") return add_triangle(attributes);
    if (element == "model") return begin_model(attributes);
    if (element == "object") return begin_object(attributes);
    if (element == "component") return add_component(attributes);
    if (element == "item") return model_.items.push_back(reference(attributes));
    if (element == "basematerials") {
      materials_ = &model_.materials[whole(attributes, "id")];
    } else if (element == "base") {
      add_material(attributes);
    } else if (element == "colorgroup") {
      colors_ = &model_.colors[whole(attributes, "id")];
    } else if (element == "color") {
      add_color(attributes);
    } else if (element == "metadata" && !object_) {
      metadata_name_ = printable(attributes.find("name").value_or(""));
      metadata_text_.clear();
    } else if (element == "texture2d" || element == "texture2dgroup") {
      count_not_kept(model_.not_kept, say("textures of 3MF"));
    } else if (element == "compositematerials" || element == "multiproperties") {
      count_not_kept(model_.not_kept, say("mixed materials"));
    } else if (element == "beamlattice") {
      count_not_kept(model_.not_kept, say("beam lattices"));
    }
  }

  void add_material(const XmlAttributes& attributes) {
    if (!materials_) fail(say("a material stands outside \"basematerials\""));
    const Color color = color_of(attributes.find("displaycolor").value_or("")).value_or(opaque_white);
    materials_->push_back({printable(attributes.find("name").value_or("")), color});
  }

  void add_color(const XmlAttributes& attributes) {
    if (!colors_) fail(say("a colour stands outside \"colorgroup\""));
    const std::string_view text = needed(attributes, "color");
    const std::optional<Color> color = color_of(text);
    if (!color) fail(say("%1 is no colour", in_quotes(text)));
    colors_->push_back(*color);
  }

  void end(std::string_view element) {
    if (element == "object") finish_object();
    if (element == "basematerials") materials_ = nullptr;
    if (element == "colorgroup") colors_ = nullptr;
    if (element == "metadata" && !metadata_name_.empty()) {
      if (metadata_name_ != "Application") model_.metadata.emplace_back(std::move(metadata_name_), metadata_text_);
      metadata_name_.clear();
    }
  }

  void text(std::string_view text) {
    if (!metadata_name_.empty()) metadata_text_ += text;
  }

  void begin_model(const XmlAttributes& attributes) {
    is_model_ = true;
    constexpr std::array<std::string_view, 6> units = {"micron", "millimeter", "centimeter", "inch", "foot", "meter"};
    const std::string_view unit = attributes.find("unit").value_or("millimeter");
    if (std::find(units.begin(), units.end(), unit) == units.end()) fail(say("%1 is no unit of 3MF", in_quotes(unit)));
    model_.unit = unit;
    const std::string required(attributes.find("requiredextensions").value_or(""));
    TextCursor cursor(required);
    for (std::string_view prefix = cursor.next_token_across_lines(); !prefix.empty();
         prefix = cursor.next_token_across_lines()) {
      const std::string_view name = attributes.find_whole("xmlns:" + std::string(prefix)).value_or(prefix);
      const bool known = name.find("/production/") != std::string_view::npos ||
                         name.find("/material/") != std::string_view::npos ||
                         name.find("/trianglesets/") != std::string_view::npos;
      if (!known)
        fail(say("needs the extension %1, which Loopmend does not know", in_quotes(name)), say("Export it without."));
    }
  }

  void begin_object(const XmlAttributes& attributes) {
    const int id = whole(attributes, "id");
    const auto [entry, is_new] = model_.objects.try_emplace(id);
    if (!is_new) fail(say("there are two objects %1", id));
    object_ = &entry->second;
    object_->name = printable(attributes.find("name").value_or(""));
    object_->group = whole(attributes, "pid", -1);
    object_->member = whole(attributes, "pindex", -1);
  }

  PackageObject& object() {
    if (!object_) fail(say("a vertex, triangle or component stands outside an object"));
    return *object_;
  }

  void add_vertex(const XmlAttributes& attributes) {
    object().points.emplace_back(number(attributes, "x"), number(attributes, "y"), number(attributes, "z"));
  }

  void add_triangle(const XmlAttributes& attributes) {
    PackageTriangle triangle;
    triangle.vertices = {whole(attributes, "v1"), whole(attributes, "v2"), whole(attributes, "v3")};
    triangle.group = whole(attributes, "pid", -1);
    const int first = whole(attributes, "p1", -1);
    triangle.members = {first, whole(attributes, "p2", first), whole(attributes, "p3", first)};
    object().triangles.push_back(triangle);
  }

  PackageReference reference(const XmlAttributes& attributes) const {
    PackageReference result;
    result.part = part_key(attributes.find("path").value_or(part_));
    result.object = whole(attributes, "objectid");
    const std::string text(attributes.find("transform").value_or(""));
    TextCursor cursor(text);
    std::array<double, 12> numbers{};
    std::size_t count = 0;
    for (std::string_view token = cursor.next_token_across_lines(); !token.empty();
         token = cursor.next_token_across_lines()) {
      const std::optional<double> value = parse_double(token);
      if (!value || !std::isfinite(*value))
        fail(say("%1 stands where a number of a transform should be", in_quotes(token)));
      if (count < numbers.size()) numbers[count] = *value;
      ++count;
    }
    if (count != 0 && count != numbers.size()) fail(say("a transform has %1 numbers, not 12", count));
    for (int k = 0; count != 0 && k < 12; ++k) result.place(k % 3, k / 3) = numbers[k];
    return result;
  }

  void add_component(const XmlAttributes& attributes) { object().components.push_back(reference(attributes)); }

  void finish_object() {
    if (!object_) return;
    const int count = static_cast<int>(object_->points.size());
    for (std::size_t f = 0; f < object_->triangles.size(); ++f)
      for (const int v : object_->triangles[f].vertices)
        if (v >= count) fail(say("face %1 names vertex %2, but there are %3, from 0 on", f, v, count));
    object_ = nullptr;
  }

  const FileContent& file_;
  const ZipArchive& archive_;
  std::string part_;
  XmlHandlers handlers_{[this](std::string_view e, const XmlAttributes& a) { begin(e, a); },
                        [this](std::string_view e) { end(e); }, [this](std::string_view t) { text(t); }};
  XmlReader xml_;
  PackageModel model_;
  PackageObject* object_ = nullptr;
  std::vector<PackageMaterial>* materials_ = nullptr;
  std::vector<Color>* colors_ = nullptr;
  std::string metadata_name_, metadata_text_;
  bool is_model_ = false;
};

}  // namespace

std::string part_key(std::string_view name) {
  std::string key(name.substr(0, 1) == "/" ? name.substr(1) : name);
  for (char& c : key) c = ascii_lower(c);
  return key;
}

PackageModel read_package_model(const FileContent& file, const ZipArchive& archive, const std::string& part) {
  return ModelReader(file, archive, part).read();
}

std::string root_model(const FileContent& file, const ZipArchive& archive) {
  constexpr const char* relations = "_rels/.rels";
  std::string root;
  if (archive.has(relations)) {
    const XmlHandlers handlers{[&](std::string_view element, const XmlAttributes& attributes) {
                                 const std::string_view type = attributes.find("Type").value_or("");
                                 constexpr std::string_view model = "/3dmodel";
                                 if (element == "Relationship" && root.empty() && type.size() >= model.size() &&
                                     type.substr(type.size() - model.size()) == model)
                                   root = attributes.find("Target").value_or("");
                               },
                               [](std::string_view) {},
                               {}};
    XmlReader xml(file, relations, handlers);
    archive.read(relations, [&](std::string_view piece) { xml.feed(piece); });
    xml.finish();
  }
  if (root.empty() && archive.has("3D/3dmodel.model")) root = "3D/3dmodel.model";
  if (!root.empty()) return root;
  throw ReadError(file.path, say("this is a ZIP archive without a 3MF model, not a mesh file"), say("byte 0"),
                  say("Unpack it, and open what is in it."));
}

}  // namespace loopmend
