// SPDX-License-Identifier: GPL-3.0-or-later
// All scans of the document with their patches as one mesh file, off the window's thread.
#pragma once

#include "document/document.h"
#include "export/write_scan.h"
#include "io/not_kept.h"

#include <filesystem>
#include <functional>
#include <set>
#include <string>
#include <vector>

namespace loopmend {

/// What a person chooses beside the name of the file.
struct ExportChoice {
  enum class Content { scene, patches } content = Content::scene;
  NewFaces new_faces = NewFaces::like_others;
  enum class Deviations { left_out, written } deviations = Deviations::left_out;  ///< likely error of new vertices
};

struct ExportTask {
  struct Part {
    std::shared_ptr<const SurfaceModel> model;
    std::vector<OpenPatch> patches;
  };
  std::vector<Part> parts;
  std::vector<NotKept> not_read;  ///< what reading left out already
  std::string unit;               ///< as chosen by a person for all scans; empty: as the files have it
  std::filesystem::path path;
  ExportChoice choice;
};

struct ExportResult {
  std::size_t triangles = 0;
  std::vector<NotKept> not_kept;
  double largest_rounding = 0;   ///< mesh units
  std::vector<Message> remarks;  ///< of what is beside the mesh: sentences
  std::set<int> left_open;       ///< loops of the document whose patches intersect the surface or one another
};

/// The scene as it is. Patches that are `invalid` come along only where a person has accepted them; one that intersects
/// another patch is left out in any case.
ExportTask export_task(const Document& document, const std::filesystem::path& path, const ExportChoice& choice = {});

/// The scans with these patches, as they would be written, without their attributes. Patches are not tested against each
/// other.
TriangleSoup plain_surface(const ExportTask& task);

/// @throws WriteError; InvalidArgument for labels on several scans: one file cannot keep the rows of several scans apart from new ones.
/// @returns without a file when cancelled.
/// @param painted  gets the share of the patches that a picture is painted for, 0..1; may be empty
ExportResult export_scene(const ExportTask& task, const CancelToken& cancel,
                          const std::function<void(double)>& painted = {});

}  // namespace loopmend
