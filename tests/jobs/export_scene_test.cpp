// SPDX-License-Identifier: GPL-3.0-or-later
#include "jobs/export_scene.h"

#include "core/error.h"
#include "samples/analytic_surfaces.h"

#include <gtest/gtest.h>

#include <filesystem>

namespace loopmend {
namespace {

/// One file cannot keep the rows of several scans apart from new ones: their labels would be wrong.
TEST(ExportScene, OneScanAloneIsLabelled) {
  ExportTask task;
  task.path = std::filesystem::temp_directory_path() / "loopmend_export_scene_test.ply";
  const auto scan = std::make_shared<const SurfaceModel>(make_surface_model(make_icosphere(1)));
  task.parts = {{scan, {}}, {scan, {}}};
  EXPECT_EQ(export_scene(task, {}).triangles, 2 * scan->soup.triangles.size());
  std::filesystem::remove(task.path);
  for (const ExportChoice& choice : {ExportChoice{{}, NewFaces::labelled, {}},
                                     ExportChoice{{}, NewFaces::like_others, ExportChoice::Deviations::written}}) {
    task.choice = choice;
    EXPECT_THROW(export_scene(task, {}), InvalidArgument);
    EXPECT_FALSE(std::filesystem::exists(task.path));
  }
}

}  // namespace
}  // namespace loopmend
