// SPDX-License-Identifier: GPL-3.0-or-later
#include <loopmend/export/write_scan.h>
#include <loopmend/io/read_mesh.h>
#include <loopmend/pipeline/fill_holes.h>

int main(int, char** argv) {
  using namespace loopmend;
  SurfaceModel model = make_surface_model(read_mesh(argv[1]).soup);
  fill_all_holes(model);
  write_scan(argv[2], model.soup);
}
