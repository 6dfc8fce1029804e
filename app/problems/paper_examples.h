// SPDX-License-Identifier: GPL-3.0-or-later
// The paper's examples (section 5) by name: the inputs of tests/reproduce and of the window's gallery.
#pragma once

#include "mesh/triangle_soup.h"

#include <string>
#include <vector>

namespace loopmend {

struct PaperExample {
  const char* id;          ///< "fig5.1a"
  const char* short_name;  ///< for a small picture
  const char* title;
  enum class Kind { holes, blend, points, region } kind;
  enum class Flows { one, all } flows;  ///< MMCVF alone, or four side by side
  std::vector<TriangleSoup> (*parts)();
};

const std::vector<PaperExample>& paper_examples();
/// Null where the gallery has none of this id.
const PaperExample* paper_example(const std::string& id);

/// The points of the bumps that the paper frees. @param soup  make_bumps().
std::vector<int> bumps_region(const TriangleSoup& soup);

}  // namespace loopmend
