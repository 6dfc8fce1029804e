// SPDX-License-Identifier: GPL-3.0-or-later
// The colours that a scan brings along, as they are drawn.
#pragma once

#include "core/cancel.h"
#include "core/message.h"
#include "core/picture.h"
#include "mesh/patch.h"
#include "mesh/surface_model.h"

#include <memory>
#include <vector>

namespace loopmend {

/// A part of the scan that has one picture, or colours at its own vertices: where texture coordinates or colours change
/// across an edge, a vertex of the view is several of these.
struct ColoredPart {
  std::shared_ptr<const Picture> picture;  ///< null: `colors`
  std::vector<int> view_vertex;            ///< per vertex of the part
  std::vector<float> texture;              ///< two per vertex: u to the right, v upward; repeated beyond 0..1
  std::vector<Color> colors;               ///< per vertex
  Triangles triangles;                     ///< of the part's vertices, oriented as in the view
};

struct ScanColors {
  std::vector<Color> at_vertices;  ///< per vertex of the view; empty: the scan has no colours
  std::vector<ColoredPart> parts;  ///< all faces of the view; empty where colours at the vertices say it all
  std::vector<Message> problems;   ///< sentences: pictures and material files that cannot be used
};

/// Of each face, the first that it has: a picture, colours of its vertices, a colour of its own, the colour of its material.
/// Faces without any are light grey where others have one. Pictures are looked for in the folder of the scan's file.
ScanColors scan_colors(const SurfaceModel& model, const CancelToken& cancel = {});

/// Colours of the patch's vertices: those of the scan where they are its own, continued harmonically over the free ones.
/// @param of_view  ScanColors::at_vertices
std::vector<Color> patch_colors(const Patch& patch, const std::vector<Color>& of_view);

}  // namespace loopmend
