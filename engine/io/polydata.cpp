// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/polydata.h"

#include "core/error.h"
#include "core/own_files.h"

#include <sstream>
#include <string>

namespace loopmend {

namespace {

std::filesystem::path program() { return own_file("loopmend-polydata"); }

/// The first line, without the line break; of a crash there is none.
Message complaint_of(const ChildRun& run) {
  if (run.exit_code > 128) return say("VTK crashes on it (signal %1)", run.exit_code - 128);
  return say("VTK: %1", run.complaint.substr(0, run.complaint.find('\n')));
}

/// The program names what it left out in remarks "comment loopmend-polydata COUNT KIND NAME".
void take_lost(PolygonSoup& soup) {
  constexpr std::string_view mark = "comment loopmend-polydata ";
  for (const std::string& remark : soup.attributes.remarks) {
    if (!remark.starts_with(mark)) continue;
    std::istringstream words(remark.substr(mark.size()));
    std::size_t count = 0;
    std::string kind, name;
    std::getline(words >> count >> kind >> std::ws, name);
    if (kind == "cells") soup.skipped_elements += count;
    count_not_kept(soup.not_kept,
                   kind == "cells"    ? say("points and lines")
                   : kind == "fields" ? say("fields")
                   : kind == "vertex" ? say("vertex properties \"%1\"", name)
                                      : say("face properties \"%1\"", name),
                   count);
  }
  std::erase_if(soup.attributes.remarks, [&](const std::string& remark) { return remark.starts_with(mark); });
}

}  // namespace

PolygonSoup parse_polydata(const FileContent& file) {
  const auto run = [&] {
    try {
      return run_child(program(), {"read"}, file.bytes);
    } catch (const Error& error) {
      throw ReadError(file.path, say("VTK's files need another program: %1", error.message()), {},
                      say("Convert the file to PLY. In Python, pass the mesh that PyVista reads."));
    }
  }();
  if (run.exit_code != 0)
    throw ReadError(file.path, complaint_of(run), {},
                    say("Loopmend reads polydata: in ParaView, extract the surface and save it as .vtp."));
  PolygonSoup soup = parse_ply({file.path, run.output});
  take_lost(soup);
  return soup;
}

void require_polydata_program(const std::filesystem::path& path) {
  try {
    program();
  } catch (const Error& error) {
    throw WriteError(path, say("VTK's files need another program: %1", error.message()), say("Save as PLY."));
  }
}

void write_polydata(Output& out, const std::filesystem::path& path, const TriangleSoup& soup, Encoding encoding) {
  require_polydata_program(path);
  std::ostringstream stream;
  Output ply(stream, nullptr);
  write_ply(ply, soup, Encoding::binary);
  ply.finish();
  const ChildRun run = run_child(
      program(), {lower_extension(path) == ".vtk" ? "legacy" : "xml", encoding == Encoding::ascii ? "text" : "binary"},
      std::move(stream).str());
  if (run.exit_code != 0) throw WriteError(path, complaint_of(run), say("Save as PLY."));
  out << run.output;
}

}  // namespace loopmend
