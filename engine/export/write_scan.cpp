// SPDX-License-Identifier: GPL-3.0-or-later
#include "export/write_scan.h"

#include "core/error.h"
#include "core/path_text.h"
#include "export/mark_new_faces.h"
#include "export/table_of_pictures.h"
#include "io/file_content.h"
#include "io/gzip.h"
#include "io/material_library.h"
#include "io/painted_material.h"
#include "io/picture_file.h"
#include "io/text_cursor.h"
#include "io/texture_files.h"
#include "mesh/scan_attributes.h"
#include "mesh/select_triangles.h"
#include "pipeline/continue_attributes.h"

#include <algorithm>
#include <fstream>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <sstream>
#include <string_view>
#include <system_error>
#include <utility>

namespace loopmend {

namespace {

namespace fs = std::filesystem;

fs::path folder_of(const fs::path& path) { return path.has_parent_path() ? path.parent_path() : fs::path("."); }

/// As they are, also of a compressed file; nothing where it cannot be read.
std::optional<std::string> bytes_of(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream bytes;
  if (!file || (file.peek() != std::ifstream::traits_type::eof() && !(bytes << file.rdbuf()))) return {};
  return bytes.str();
}

/// The files beside a scan and those beside its output.
class SideFiles {
 public:
  SideFiles(OutputTransaction& outputs, const fs::path& path, const fs::path& scan, MaterialFiles materials,
            WrittenScan& written)
      : outputs_(outputs),
        path_(path),
        from_(folder_of(scan)),
        to_(folder_of(path)),
        materials_(materials),
        written_(written) {
    std::error_code ignored;
    is_elsewhere_ = !scan.empty() && !fs::equivalent(from_, to_, ignored);
  }

  const fs::path& scan_folder() const { return from_; }

  /// As the output shall name a file that the scan names; copied, if so asked. @param folder  of the scan's, from which the
  /// name is given
  std::string named(const std::string& name, const fs::path& folder = {}) {
    if (!is_elsewhere_) return name;
    if (materials_ == MaterialFiles::copy) {
      copy(folder / path_of_text(name));
      return name;
    }
    std::error_code ignored;
    const fs::path there = fs::relative(from_ / folder / path_of_text(name), to_, ignored);
    return there.empty() ? name : generic_path_text(there);
  }

  /// A picture of the scan's texture; null: it cannot be used, which is said.
  const Picture* picture(const TextureFiles& files, const fs::path& path) {
    const auto [entry, is_new] = pictures_.try_emplace(path_text(path));
    if (is_new) {
      try {
        entry->second = files.read(path);
      } catch (const ReadError& error) {
        written_.remarks.push_back(say("A picture of the scan's texture cannot be used: %1", error.message()));
      }
    }
    return entry->second.empty() ? nullptr : &entry->second;
  }

  /// "NAME_patch" after the output, or with a number where a file of the scan or a foreign one has that name.
  std::string name_for_patches(const std::set<std::string>& taken) const {
    const std::string stem = path_text(without_gzip_name(path_).stem()) + "_patch";
    std::set<std::string> taken_files;
    std::error_code error;
    for (const std::string& name : taken)  // where they are, and where they may be copied
      for (const fs::path& folder : {from_, to_})
        taken_files.insert(path_text(fs::weakly_canonical(folder / path_of_text(name), error)));
    const std::set<std::string> replaced = files_named_by_output();
    const auto is_free = [&](const std::string& name) {
      bool is_ours = false, is_there = false;
      for (const std::string& file : {name + ".png", name + ".mtl"}) {
        if (taken_files.contains(path_text(fs::weakly_canonical(to_ / path_of_text(file), error)))) return false;
        is_ours = is_ours || replaced.contains(file);
        is_there = is_there || fs::exists(to_ / path_of_text(file), error);
      }
      return is_ours || !is_there;
    };
    std::string name = stem;
    for (int k = 2; !is_free(name); ++k) name = stem + "_" + std::to_string(k);
    return name;
  }

  void add(const std::string& name, const std::function<void(std::ostream&)>& write) {
    outputs_.add(to_ / path_of_text(name), write);
    written_.beside.push_back(to_ / path_of_text(name));
  }

  void remark(const Message& remark) { written_.remarks.push_back(remark); }

 private:
  /// What the mesh at the output's place names that is replaced now: that was made for it.
  std::set<std::string> files_named_by_output() const {
    std::set<std::string> names;
    try {
      std::error_code error;
      if (!fs::is_regular_file(path_, error)) return names;
      const FileContent old = load_file(path_);
      TextCursor cursor(std::string_view(old.bytes).substr(0, 1 << 14));
      while (cursor.next_line()) {
        std::string_view word = cursor.next_token();
        if (word == "comment") word = cursor.next_token();
        if (word != "mtllib" && word != "TextureFile") continue;
        const std::string_view rest = cursor.rest_of_line();
        names.emplace(rest.substr(std::min(rest.find_first_not_of(' '), rest.size())));
      }
    } catch (const ReadError&) {
    }
    return names;
  }

  void copy(const fs::path& name) {
    const fs::path relative = name.lexically_normal();
    if (relative.has_root_path() || (!relative.empty() && *relative.begin() == "..")) {
      remark(say("The file %1 is outside the scan's folder and was not copied.", path_text(name)));
      return;
    }
    const fs::path source = from_ / relative, target = (to_ / relative).lexically_normal();
    std::error_code error;
    if (!copied_.insert(path_text(target)).second || !fs::is_regular_file(source, error)) return;
    const std::optional<std::string> content = bytes_of(source);
    if (!content) return remark(say("The file %1 cannot be read and was not copied.", path_text(name)));
    if (fs::exists(target, error)) {
      if (bytes_of(target) == content) return;
      throw WriteError(
          target, say("another file of this name is there already, which the scan's %1 would replace", path_text(name)),
          say("Choose another folder for the output, or --materials reference."));
    }
    if (target.has_parent_path()) outputs_.add_folder(target.parent_path());
    outputs_.add(target,
                 [&](std::ostream& out) { out.write(content->data(), static_cast<std::streamsize>(content->size())); });
    written_.beside.push_back(target);
  }

  OutputTransaction& outputs_;
  const fs::path& path_;
  fs::path from_, to_;
  MaterialFiles materials_;
  WrittenScan& written_;
  bool is_elsewhere_ = false;
  std::map<std::string, Picture> pictures_;
  std::set<std::string> copied_;
};

/// What of a format says which picture a face has.
class Texture {
 public:
  virtual ~Texture() = default;
  virtual const Picture* picture_of(std::size_t face) = 0;
  /// The files that the scan names, as the output shall name them.
  virtual void name_files(ScanAttributes& continued) = 0;
  /// A picture of patches that are like this face: its file, and the new triangles that have it.
  virtual void add_patches(const PaintedPatches& painted, std::size_t like_face, ScanAttributes& continued) = 0;
};

/// OBJ: usemtl names a material of a file that mtllib names.
class ObjTexture : public Texture {
 public:
  ObjTexture(const ScanAttributes& scan, SideFiles& files)
      : scan_(scan),
        files_(files),
        named_(scan, files.scan_folder()) {
    for (const Message& problem : named_.problems())
      files.remark(say("The scan's material file cannot be used: %1", problem));
  }

  const Picture* picture_of(std::size_t face) override {
    const auto path = named_.picture_of(face);
    return path ? files_.picture(named_, *path) : nullptr;
  }

  void name_files(ScanAttributes& continued) override {
    for (const std::string& name : scan_.material_libraries) continued.material_libraries.push_back(files_.named(name));
    std::error_code ignored;
    for (const MaterialLibrary& library : named_.libraries())  // paths of pictures are relative to the material file
      for (const std::string& picture : library.pictures)
        files_.named(picture, fs::relative(folder_of(library.path), files_.scan_folder(), ignored));
  }

  void add_patches(const PaintedPatches& painted, std::size_t like_face, ScanAttributes& continued) override {
    std::set<std::string> taken(scan_.material_libraries.begin(), scan_.material_libraries.end());
    std::error_code ignored;
    for (const MaterialLibrary& library : named_.libraries())
      for (const std::string& picture : library.pictures)
        taken.insert(
            path_text(fs::relative(folder_of(library.path), files_.scan_folder(), ignored) / path_of_text(picture)));
    const std::string name = files_.name_for_patches(taken);
    for (FaceNames& names : continued.names) {
      if (names.keyword != "usemtl") continue;
      std::string material = "loopmend_patch";
      for (int k = 2; std::find(names.names.begin(), names.names.end(), material) != names.names.end(); ++k)
        material = "loopmend_patch_" + std::to_string(k);
      const int number = static_cast<int>(names.names.size());
      names.names.push_back(material);
      for (std::size_t f = 0; f < painted.is_painted.size(); ++f)
        if (painted.is_painted[f]) names.of_face[f] = number;
      files_.add(name + ".mtl", [&](std::ostream& out) { write_material(out, material, name + ".png", like_face); });
    }
    continued.material_libraries.push_back(name + ".mtl");
    files_.add(name + ".png", [&](std::ostream& out) { write_png(out, painted.picture); });
  }

 private:
  /// With the statements of the material around, but for its pictures.
  void write_material(std::ostream& out, const std::string& material, const std::string& picture,
                      std::size_t like_face) const {
    out << "# Loopmend\nnewmtl " << material << '\n';
    if (const std::string* like = named_.material_of(like_face))
      for (const MaterialLibrary& library : named_.libraries()) {
        const auto lines = library.statements.find(*like);
        if (lines == library.statements.end()) continue;
        for (const std::string& line : lines->second) out << line << '\n';
        break;
      }
    out << "map_Kd " << picture << '\n';
  }

  const ScanAttributes& scan_;
  SideFiles& files_;
  TextureFiles named_;
};

/// PLY as MeshLab has it: "comment TextureFile NAME", and the face property texnumber where there are several.
class PlyTexture : public Texture {
 public:
  PlyTexture(const ScanAttributes& scan, SideFiles& files)
      : scan_(scan),
        files_(files),
        named_(scan, files.scan_folder()) {}

  const Picture* picture_of(std::size_t face) override {
    const auto path = named_.picture_of(face);
    return path ? files_.picture(named_, *path) : nullptr;
  }

  void name_files(ScanAttributes& continued) override {
    for (const std::string& remark : scan_.remarks) {
      const std::string name = TextureFiles::name_in(remark);
      continued.remarks.push_back(name.empty() ? remark : keyword + files_.named(name));
    }
  }

  void add_patches(const PaintedPatches& painted, std::size_t, ScanAttributes& continued) override {
    const std::vector<std::string>& names = named_.ply_pictures();
    const AttributeColumn* numbers = named_.picture_numbers();
    const std::string name = files_.name_for_patches({names.begin(), names.end()}) + ".png";
    continued.remarks.push_back(keyword + name);
    files_.add(name, [&](std::ostream& out) { write_png(out, painted.picture); });
    AttributeColumn column("texnumber", numbers ? numbers->type() : ScalarType::int32);
    for (const char is_painted : painted.is_painted) column.push(is_painted ? static_cast<double>(names.size()) : 0);
    if (numbers)
      continued.faces[numbers - scan_.faces.data()] = std::move(column);
    else
      continued.faces.push_back(std::move(column));
  }

 private:
  inline static const std::string keyword = "comment TextureFile ";

  const ScanAttributes& scan_;
  SideFiles& files_;
  TextureFiles named_;
};

/// glTF: materials and pictures are in the file itself.
class GltfTexture : public Texture {
 public:
  GltfTexture(const ScanAttributes& scan, SideFiles& files)
      : scan_(scan),
        files_(files),
        named_(scan, files.scan_folder()) {
    for (const Message& problem : named_.problems()) files.remark(problem);
  }

  const Picture* picture_of(std::size_t face) override {
    const auto path = named_.picture_of(face);
    return path ? files_.picture(named_, *path) : nullptr;
  }

  /// Pictures beside the scan go into the output; one that is not there cannot.
  void name_files(ScanAttributes&) override {
    std::error_code ignored;
    for (const ScanPicture& picture : scan_.materials->pictures)
      if (!picture.path.empty() && !fs::is_regular_file(picture.path, ignored))
        files_.remark(say("The picture %1 is not there, and not in the output.", path_text(picture.path)));
  }

  void add_patches(const PaintedPatches& painted, std::size_t like_face, ScanAttributes& continued) override {
    auto table = std::make_shared<MaterialTable>(*scan_.materials);
    std::ostringstream png;
    write_png(png, painted.picture);
    for (FaceNames& names : continued.names) {
      if (names.keyword != "usemtl") continue;
      std::string material = "loopmend_patch";
      for (int k = 2; std::find(names.names.begin(), names.names.end(), material) != names.names.end(); ++k)
        material = "loopmend_patch_" + std::to_string(k);
      const int number =
          add_painted_material(*table, material, named_.material_number_of(like_face), std::move(png).str());
      names.names.push_back(material);
      for (std::size_t f = 0; f < painted.is_painted.size(); ++f)
        if (painted.is_painted[f]) names.of_face[f] = number;
    }
    continued.materials = std::move(table);
  }

 private:
  const ScanAttributes& scan_;
  SideFiles& files_;
  TextureFiles named_;
};

bool is_gltf_name(const fs::path& path) {
  const std::string extension = path_text(without_gzip_name(path).extension());
  return equals_ignoring_case(extension, ".glb") || equals_ignoring_case(extension, ".gltf");
}

/// Of a scan of the same format as the output; null: it has none.
std::unique_ptr<Texture> texture_of(const fs::path& path, const ScanAttributes& scan, SideFiles& files) {
  const auto is_written_as = [&](const char* format, const char* extension) {
    return scan.format == format && equals_ignoring_case(path_text(without_gzip_name(path).extension()), extension);
  };
  if (is_written_as("OBJ", ".obj") && !scan.material_libraries.empty())
    return std::make_unique<ObjTexture>(scan, files);
  if (scan.format == "glTF" && is_gltf_name(path) && scan.materials && !scan.materials->pictures.empty())
    return std::make_unique<GltfTexture>(scan, files);
  const auto names_picture = [](const std::string& remark) { return !TextureFiles::name_in(remark).empty(); };
  if (is_written_as("PLY", ".ply") && (scan.texture.count() > 0 || std::ranges::any_of(scan.remarks, names_picture)))
    return std::make_unique<PlyTexture>(scan, files);
  return nullptr;
}

void write_texture(Texture& texture, TriangleSoup& soup, const WriteScanOptions& options, WrittenScan& written,
                   const CancelToken& cancel) {
  auto continued = std::make_shared<ScanAttributes>(soup.continued ? *soup.continued : ScanAttributes{});
  texture.name_files(*continued);
  if (options.texture && soup.attributes->texture.count() > 0) {
    std::size_t like_face = 0;
    PaintedPatches painted = paint_patches(
        soup,
        [&](std::size_t face) {
          const Picture* picture = texture.picture_of(face);
          if (picture) like_face = face;
          return picture;
        },
        *options.texture, cancel, options.on_painted);
    if (painted.not_painted > 0)
      written.remarks.push_back(say(
          "%1 new triangles have no texture: their patch cannot be laid out in a plane, or the picture would be too "
          "large.",
          painted.not_painted));
    if (!painted.picture.empty()) {
      written.painted = static_cast<std::size_t>(std::count(painted.is_painted.begin(), painted.is_painted.end(), 1));
      texture.add_patches(painted, like_face, *continued);
      continued->texture = std::move(painted.texture);
    }
  }
  soup.continued = std::move(continued);
}

}  // namespace

WrittenScan write_scan(OutputTransaction& outputs, const std::filesystem::path& path, TriangleSoup& soup,
                       const WriteScanOptions& options, const CancelToken& cancel) {
  WrittenScan written;
  if (soup.attributes && is_gltf_name(path))
    if (auto with_table = with_table_of_pictures(*soup.attributes, written.remarks))
      soup.attributes = std::move(with_table);
  continue_attributes(soup);
  if (soup.attributes) {
    SideFiles files(outputs, path, soup.attributes->file, options.materials, written);
    if (const auto texture = texture_of(path, *soup.attributes, files))
      write_texture(*texture, soup, options, written, cancel);
  }
  if (options.new_faces == NewFaces::labelled && !mark_new_faces(path, soup))
    written.remarks.push_back(say("STL and OFF have no label for new triangles: they are not told from others."));
  if (!options.expected_deviation.empty() && !label_expected_deviation(path, soup, options.expected_deviation))
    written.remarks.push_back(
        say("Only PLY and polydata have room for the expected deviation of each vertex: it is not in the output."));
  // The rows of what is new stay valid: all of it comes along, in its order, or none.
  if (!options.written.empty()) soup = select_triangles(soup, options.written).soup;
  write_mesh(outputs, path, soup, options.encoding);
  return written;
}

WrittenScan write_scan(const std::filesystem::path& path, TriangleSoup& soup, const WriteScanOptions& options) {
  OutputTransaction outputs;
  WrittenScan written = write_scan(outputs, path, soup, options);
  outputs.commit();
  return written;
}

}  // namespace loopmend
