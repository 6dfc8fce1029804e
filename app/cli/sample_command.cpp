#include "commands.h"
#include "exit_codes.h"

#include "samples/sample_scan.h"

#include <cstdio>

namespace loopmend {

int run_sample(const std::filesystem::path& output) {
  const TriangleSoup soup = make_sample_scan();
  write_mesh(output, soup);
  std::printf("%s: the embedded sample, %zu vertices, %zu triangles\n", output.c_str(), soup.points.size(),
              soup.triangles.size());
  return exit_done;
}

}  // namespace loopmend
