// SPDX-License-Identifier: GPL-3.0-or-later
#include "outputs.h"

#include "commands.h"
#include "core/path_text.h"
#include "io/text_cursor.h"

#include <iostream>
#include <utility>

namespace loopmend {

namespace {

/// Indented for people; where there are more loops than anybody reads, with one line for each.
void write_report(std::ostream& out, const nlohmann::ordered_json& report) {
  const auto text = [](const nlohmann::ordered_json& value, int indent) {
    return value.dump(indent, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
  };
  if (!report.contains("loops") || report["loops"].size() <= most_loops_in_report) {
    out << text(report, 2) << "\n";
    return;
  }
  const char* between = "{\n";
  for (const auto& [name, value] : report.items()) {
    out << std::exchange(between, ",\n") << "  \"" << name << "\": ";
    if (name != "loops") {
      out << text(value, -1);
      continue;
    }
    const char* before = "[\n";
    for (const auto& loop : value) out << std::exchange(before, ",\n") << "    " << text(loop, -1);
    out << "\n  ]";
  }
  out << "\n}\n";
}

bool is_gltf(const std::filesystem::path& path) {
  const std::string extension = path_text(path.extension());
  return equals_ignoring_case(extension, ".glb") || equals_ignoring_case(extension, ".gltf");
}
bool is_stl(const std::filesystem::path& path) { return equals_ignoring_case(path_text(path.extension()), ".stl"); }

/// @param what  "a picture". @param wanted  ".png". @throws WriteError unless the name ends in it.
void require_extension(const std::filesystem::path& path, const std::string& what, const char* wanted) {
  const std::string extension = path_text(path.extension());
  if (equals_ignoring_case(extension, wanted)) return;
  throw WriteError(
      path,
      extension.empty() ? say("the name has no extension") : say("%1 cannot be written as \"%2\"", what, extension),
      say("Choose a name that ends in %1.", wanted));
}

}  // namespace

CommandFiles& CommandFiles::reads(const std::string& name, const std::filesystem::path& path) {
  if (!path.empty()) inputs_.push_back({name, path, NamedFile::Kind::mesh});
  return *this;
}

CommandFiles& CommandFiles::writes(NamedFile::Kind kind, const std::string& name, const std::filesystem::path& path) {
  outputs_.push_back({name, path, kind});
  return *this;
}

CommandFiles& CommandFiles::writes_report(const std::string& name, const std::string& target) {
  return target.empty() || target == "-" ? *this : writes(NamedFile::Kind::other, name, path_of_text(target));
}

void CommandFiles::check_identity() const {
  for (std::size_t k = 0; k < outputs_.size(); ++k) {
    const NamedFile& output = outputs_[k];
    for (const NamedFile& input : inputs_)
      if (same_file(input.path, output.path))
        throw UsageError(output.name + " " + path_text(output.path) + " would overwrite " + input.name + " " +
                         path_text(input.path) + ": choose another name");
    for (std::size_t l = 0; l < k; ++l)
      if (same_file(outputs_[l].path, output.path))
        throw UsageError(output.name + " " + path_text(output.path) + " would overwrite " + outputs_[l].name + " " +
                         path_text(outputs_[l].path) + ": choose another name");
  }
}

void CommandFiles::check() const {
  check_identity();
  for (const NamedFile& output : outputs_) {
    if (const std::size_t names = other_names(output.path); names > 0)
      std::fprintf(stderr, "loopmend: %s has %s; %s the old file.\n", path_text(output.path).c_str(),
                   counted(names, "other name (hard link)", "other names (hard links)").c_str(),
                   names == 1 ? "that keeps" : "those keep");
    if (output.kind == NamedFile::Kind::picture) require_extension(output.path, "a picture", ".png");
    if (output.kind == NamedFile::Kind::film) require_extension(output.path, "a film", ".gif");
    if (output.kind == NamedFile::Kind::mesh)
      check_mesh_writable(output.path);
    else
      check_writable(output.path);
  }
}

void commit_with_report(OutputTransaction& outputs, const std::string& target, const nlohmann::ordered_json& report) {
  if (!target.empty() && target != "-")
    outputs.add(path_of_text(target), [&](std::ostream& out) { write_report(out, report); });
  outputs.commit();
  if (target != "-") return;
  write_report(std::cout, report);
  std::cout << std::flush;
}

void add_text(OutputTransaction& outputs, const std::filesystem::path& path, const std::string& text) {
  outputs.add(path, [&](std::ostream& out) { out << text; });
}

std::string what_was_written() {
  std::vector<std::string> names;
  while (const char* name = file_in_place(names.size())) names.emplace_back(name);
  if (names.empty()) return "Nothing was written.";
  std::string text = names.front();
  for (std::size_t k = 1; k < names.size(); ++k) text += (k + 1 < names.size() ? ", " : " and ") + names[k];
  return text + (names.size() == 1 ? " was written." : " were written.");
}

OutputLosses losses_of(const std::filesystem::path& output, const TriangleSoup& soup, Encoding encoding,
                       const std::vector<NotKept>& not_read, std::size_t exterior) {
  OutputLosses losses{not_read, 0, 0};
  for (const NotKept& entry : not_kept_by_format(output, soup, encoding)) losses.not_kept.push_back(entry);
  losses.largest_rounding = largest_rounding(output, soup, encoding);
  losses.largest_exterior_rounding = largest_rounding(output, soup, encoding, exterior);
  return losses;
}

nlohmann::ordered_json not_kept_json(const std::vector<NotKept>& list) {
  nlohmann::ordered_json json = nlohmann::ordered_json::array();
  for (const NotKept& entry : list) json.push_back({{"what", entry.what.english()}, {"count", entry.count}});
  return json;
}

nlohmann::ordered_json losses_json(const OutputLosses& losses) {
  return {{"not_kept", not_kept_json(losses.not_kept)}, {"largest_rounding", losses.largest_rounding}};
}

void print_losses(std::FILE* out, const std::filesystem::path& output, const OutputLosses& losses) {
  if (!losses.not_kept.empty())
    std::fprintf(out, "Not in %s: %s.\n", path_text(output).c_str(), to_string(losses.not_kept).c_str());
  if (losses.largest_rounding > 0 && is_stl(output))
    std::fprintf(
        out,
        "Binary STL holds single precision: vertices were moved by up to %.3g (mesh units), those of the scan by "
        "up to %.3g. Other formats and --ascii keep every digit.\n",
        losses.largest_rounding, losses.largest_exterior_rounding);
  if (losses.largest_exterior_rounding > 0 && is_gltf(output))
    std::fprintf(out, "glTF holds single precision: vertices of the scan were moved by up to %.3g (mesh units).\n",
                 losses.largest_exterior_rounding);
}

void print_import_losses(std::FILE* out, const ImportReport& import) {
  if (!import.oddities.empty()) std::fprintf(out, "Read in spite of: %s.\n", to_string(import.oddities).c_str());
  if (import.missing_colors > 0)
    std::fprintf(out, "%zu vertices have no colour in a file with colours: they became white.\n",
                 import.missing_colors);
}

void print_coincident(std::FILE* out, const ImportReport& import, const std::vector<BoundaryLoop>& loops) {
  int edges = 0;
  // Where the view was cut, one edge of the file has become two: those cannot be welded.
  for (const BoundaryLoop& loop : loops) edges += loop.kind == LoopKind::cut ? 0 : loop.coincident;
  if (edges == 0 || import.coincident_vertices == 0) return;
  std::fprintf(out,
               "%s exactly on another one, and %s on an earlier one: the mesh is split there, "
               "as along the seams of a texture. fill --stitch joins them.\n",
               counted(static_cast<std::size_t>(edges), "boundary edge lies", "boundary edges lie").c_str(),
               counted(import.coincident_vertices, "vertex", "vertices").c_str());
}

void print_no_data(std::FILE* out, const NoDataVertices& found) {
  if (found.vertices.empty()) return;
  std::fprintf(out, "%s at %g, a mark for missing data: fill --cut-no-data removes the faces there.\n",
               counted(found.vertices.size(), "vertex lies", "vertices lie").c_str(), found.value);
}

void print_inverted(std::FILE* out, const InvertedShells& inverted, const char* begin) {
  if (inverted.closed > 0)
    std::fprintf(out, "%s%s.\n", begin,
                 counted(inverted.closed, "body or cavity is inside out; fill --repair turns it",
                         "bodies or cavities are inside out; fill --repair turns them")
                     .c_str());
  if (inverted.open > 0)
    std::fprintf(out, "%s%s inward, as a room scanned from within does; fill --turn-around turns all faces.\n", begin,
                 counted(inverted.open, "open body looks", "open bodies look").c_str());
}

void print_tiles(std::FILE* out, const TileOutlines& outlines, const char* begin) {
  if (outlines.abutting > 0)
    std::fprintf(out, "%s%s beside others: tiles that abut; fill --stitch joins them.\n", begin,
                 counted(outlines.abutting, "outline of a sheet runs", "outlines of sheets run").c_str());
  if (outlines.overlapping.count > 0)
    std::fprintf(
        out,
        "%s%s over another part of the surface: tiles that overlap, or layers; if tiles, fill --stitch %.2g cuts "
        "the smaller ones back and joins them.\n",
        begin, counted(outlines.overlapping.count, "boundary runs", "boundaries run").c_str(),
        outlines.overlapping.distance);
}

std::string counted(std::size_t count, const char* one, const char* many) {
  return std::to_string(count) + " " + (count == 1 ? one : many);
}

}  // namespace loopmend
