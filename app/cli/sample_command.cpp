// SPDX-License-Identifier: GPL-3.0-or-later
#include "commands.h"
#include "core/path_text.h"
#include "exit_codes.h"

#include "outputs.h"

#include "samples/sample_scan.h"

#include <cstdio>

namespace loopmend {

int run_sample(const std::filesystem::path& output) {
  CommandFiles().writes(NamedFile::Kind::mesh, "-o", output).check();
  const TriangleSoup soup = make_sample_scan();
  OutputTransaction outputs;
  write_mesh(outputs, output, soup);
  outputs.commit();
  std::printf("%s: the embedded sample, %zu vertices, %zu triangles\n", path_text(output).c_str(), soup.points.size(),
              soup.triangles.size());
  return exit_done;
}

}  // namespace loopmend
