// SPDX-License-Identifier: GPL-3.0-or-later
#include <loopmend/evolution/fill_loops.h>
#include <loopmend/io/read_mesh.h>
#include <loopmend/io/write_mesh.h>

int main(int, char** argv) {
  using namespace loopmend;
  SurfaceModel model = make_surface_model(read_mesh(argv[1]).soup);
  std::vector<BoundaryLoop> holes = find_boundary_loops(model);
  std::erase_if(holes, [](const BoundaryLoop& loop) { return loop.kind != LoopKind::hole; });
  fill_loops(model, holes, {}, {}, {});
  write_mesh(argv[2], model.soup);
}
