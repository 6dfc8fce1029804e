// SPDX-License-Identifier: GPL-3.0-or-later
#include "opened_parts.h"

#include "io/write_mesh.h"

#include <utility>

namespace loopmend {

OpenedParts open_parts(const std::vector<std::filesystem::path>& paths) {
  OpenedParts parts;
  std::vector<TriangleSoup> soups;
  for (const std::filesystem::path& path : paths) {
    OpenedModel opened = open_model(path);
    parts.paths.push_back(path);
    parts.imports.push_back(opened.import);
    if (paths.size() > 1)
      for (const NotKept& entry : carried_attributes(opened.model.soup))
        count_not_kept(parts.imports.back().not_kept, entry.what, entry.count);
    parts.repairs.push_back(opened.model.repairs);
    soups.push_back(std::move(opened.model.soup));
  }
  parts.joined = join_parts(soups);
  return parts;
}

}  // namespace loopmend
