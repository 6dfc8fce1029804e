// SPDX-License-Identifier: GPL-3.0-or-later
// Pictures for the patches of a scan whose colour is a picture.
#pragma once

#include "core/cancel.h"
#include "core/picture.h"
#include "mesh/scan_attributes.h"
#include "mesh/triangle_soup.h"

#include <functional>
#include <vector>

namespace loopmend {

/// How the picture goes on over a patch.
enum class TextureFill {
  smooth,  ///< colours alone
  grain    ///< with texture like that around the patch
};

struct PaintedPatches {
  Picture picture;               ///< of all patches; empty where none could be painted
  CornerValues texture;          ///< for the corners of the soup's new triangles, in their order; −1: not painted
  std::vector<char> is_painted;  ///< per new triangle
  std::size_t not_painted = 0;   ///< new triangles that touch textured ones and have no place in the picture
};

/// Each patch is flattened together with the scan around it, the scan's pictures are drawn there, and what the patch covers is
/// continued from them. Texture coordinates as in OBJ: u to the right, v upward, the pictures repeated.
/// @param soup        attributes->texture has the coordinates of its old triangles
/// @param picture_of  the picture of a face of the file; null: none
/// @param progress    gets the share that is done, 0..1, from time to time; may be empty
PaintedPatches paint_patches(const TriangleSoup& soup, const std::function<const Picture*(std::size_t)>& picture_of,
                             TextureFill fill, const CancelToken& cancel = {},
                             const std::function<void(double)>& progress = {});

}  // namespace loopmend
