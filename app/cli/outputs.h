// SPDX-License-Identifier: GPL-3.0-or-later
// The files of a command: none overwrites another, all appear together, and what is said about them is so.
#pragma once

#include "io/atomic_file.h"
#include "io/not_kept.h"
#include "io/read_mesh.h"
#include "io/write_mesh.h"
#include "mesh/boundary_loops.h"
#include "mesh/no_data.h"
#include "pipeline/tile_outlines.h"
#include "repair/inverted_shells.h"

#include <nlohmann/json.hpp>

#include <cstdio>
#include <filesystem>
#include <string>
#include <vector>

namespace loopmend {

/// A file that a command reads or writes, and how the person named it.
struct NamedFile {
  enum class Kind { mesh, picture, film, other };
  std::string name;  ///< "the input", "--report"
  std::filesystem::path path;
  Kind kind = Kind::other;
};

/// Everything that a command reads and writes. Empty paths, and "-" for a report, mean none.
class CommandFiles {
 public:
  CommandFiles& reads(const std::string& name, const std::filesystem::path& path);
  CommandFiles& writes(NamedFile::Kind kind, const std::string& name, const std::filesystem::path& path);
  CommandFiles& writes_report(const std::string& name, const std::string& target);

  /// Before long work: no output may be an input or another output, under whatever name; each must be writable and have
  /// the extension of a mesh or a picture where it is one.
  /// @throws UsageError, WriteError
  void check() const;
  /// The first half alone, for outputs in a folder that is not there yet. @throws UsageError
  void check_identity() const;

 private:
  std::vector<NamedFile> inputs_, outputs_;
};

/// The report joins the other files, and all appear together. A report for standard output, "-", comes after that: whoever
/// reads it may count on the files. @param target  empty: no report. @throws WriteError
void commit_with_report(OutputTransaction& outputs, const std::string& target, const nlohmann::ordered_json& report);

/// Adds one file of text. @throws WriteError
void add_text(OutputTransaction& outputs, const std::filesystem::path& path, const std::string& text);

/// "Nothing was written.", or the files that this process has put in place: "a.ply and b.json were written.".
std::string what_was_written();

/// What of the input is not in the mesh that was written.
struct OutputLosses {
  std::vector<NotKept> not_kept;
  double largest_rounding = 0;           ///< of all vertices, mesh units
  double largest_exterior_rounding = 0;  ///< of the input's vertices
};

/// @param exterior  how many of the soup's points, the first ones, are the input's.
OutputLosses losses_of(const std::filesystem::path& output, const TriangleSoup& soup, Encoding encoding,
                       const std::vector<NotKept>& not_read, std::size_t exterior);

/// {"not_kept": [{"what", "count"}], "largest_rounding"}
nlohmann::ordered_json losses_json(const OutputLosses& losses);
nlohmann::ordered_json not_kept_json(const std::vector<NotKept>& list);

/// A line for each kind of loss; nothing where there is none.
void print_losses(std::FILE* out, const std::filesystem::path& output, const OutputLosses& losses);

/// What reading alone has changed and a person would miss: colours that were not there, and what was odd in the file.
void print_import_losses(std::FILE* out, const ImportReport& import);

/// Where boundaries lie on each other: how many edges, and what joins them.
void print_coincident(std::FILE* out, const ImportReport& import, const std::vector<BoundaryLoop>& loops);

/// How many vertices mark missing data, and what removes them; nothing where there are none.
void print_no_data(std::FILE* out, const NoDataVertices& found);

/// Bodies that are inside out, and what turns them; nothing where there are none. @param begin  of each line
void print_inverted(std::FILE* out, const InvertedShells& inverted, const char* begin);

/// Outlines of sheets that abut or overlap, and the next thing to do; nothing where there are none.
void print_tiles(std::FILE* out, const TileOutlines& outlines, const char* begin);

/// "1 face", "2 faces".
std::string counted(std::size_t count, const char* one, const char* many);

}  // namespace loopmend
