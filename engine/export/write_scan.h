// SPDX-License-Identifier: GPL-3.0-or-later
// A scan and its patches into a file, with what the scan carries.
#pragma once

#include "core/cancel.h"
#include "core/message.h"
#include "io/atomic_file.h"
#include "io/write_mesh.h"
#include "mesh/triangle_soup.h"
#include "texture/paint_patches.h"

#include <cstddef>
#include <filesystem>
#include <functional>
#include <optional>
#include <vector>

namespace loopmend {

/// What becomes of the material files of OBJ and their pictures where the output is in another folder.
enum class MaterialFiles {
  copy,      ///< beside the output
  reference  ///< named where they are
};

/// Whether triangles that the scan did not have are labelled (export/mark_new_faces.h).
enum class NewFaces { like_others, labelled };

struct WriteScanOptions {
  std::filesystem::path
      input;  ///< the scan's own file: material files are looked for in its folder; empty: there is none
  Encoding encoding = Encoding::binary;
  std::optional<TextureFill> texture = TextureFill::grain;  ///< nothing: patches are not painted
  MaterialFiles materials = MaterialFiles::copy;
  NewFaces new_faces = NewFaces::like_others;
  /// Of each new point, in their order, mesh units: written where the format has room for it. Empty: not written.
  std::vector<double> expected_deviation{};
  /// For each triangle whether it is written; those of all patches, or of none. Empty: all are written.
  std::vector<char> written{};
  /// Gets the share of the patches that a picture is painted for, 0..1, from time to time; may be empty.
  std::function<void(double)> on_painted{};
};

/// What was written beside the mesh, or could not be.
struct WrittenScan {
  std::vector<std::filesystem::path> beside;  ///< pictures and material files
  std::size_t painted = 0;                    ///< triangles of patches that a picture was painted for
  std::vector<Message> remarks;               ///< sentences: what is missing
};

/// Makes the soup what is to be written. Makes its new rows (continue_attributes), paints its patches where the scan has a
/// texture and the output is of the same format (OBJ with materials, PLY with corner texture coordinates, glTF with
/// pictures) or glTF, into which the pictures of PLY and OBJ go, and adds all files to the transaction.
/// @throws WriteError, InvalidArgument as write_mesh; WriteError where a material file would replace another one.
WrittenScan write_scan(OutputTransaction& outputs, const std::filesystem::path& path, TriangleSoup& soup,
                       const WriteScanOptions& options, const CancelToken& cancel = {});

/// The same with a transaction of its own: all files appear together.
WrittenScan write_scan(const std::filesystem::path& path, TriangleSoup& soup, const WriteScanOptions& options = {});

}  // namespace loopmend
