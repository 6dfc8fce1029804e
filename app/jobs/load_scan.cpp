// SPDX-License-Identifier: GPL-3.0-or-later
#include "jobs/load_scan.h"

#include "core/threads.h"
#include "document/file_path.h"
#include "samples/sample_scan.h"

#include <QCoreApplication>
#include <QFileInfo>

namespace loopmend {
namespace {

QString tr(const char* text) { return QCoreApplication::translate("loopmend", text); }

ImportedMesh read(const QString& path) {
  if (!path.isEmpty()) return read_mesh(file_path(path));
  ImportedMesh sample{make_sample_scan(), {}};
  sample.report.vertices = sample.soup.points.size();
  sample.report.faces = sample.report.triangles = sample.soup.triangles.size();
  return sample;
}

/// Whether the view has the file's vertices and triangles, so that one picture serves for both.
bool view_is_file(const SurfaceModel& model) {
  const auto counts_up = [](const std::vector<int>& numbers) {
    for (std::size_t i = 0; i < numbers.size(); ++i)
      if (numbers[i] != static_cast<int>(i)) return false;
    return true;
  };
  return model.soup_vertex.size() == model.soup.points.size() &&
         model.soup_face.size() == model.soup.triangles.size() && model.repairs.reoriented_faces == 0 &&
         counts_up(model.soup_vertex) && counts_up(model.soup_face);
}

/// What is drawn until the boundaries are found: a small scan as it is, which becomes its shape; of a large one the reduced version
/// alone, since the whole would take memory, and the graphics a processor, that the search for boundaries needs.
SurfaceShapePtr first_picture(const TriangleSoup& soup, OpenedScan& scan) {
  auto whole = std::make_shared<SurfaceShape>(shape_of(soup, scan.origin));
  if (auto reduced = reduced_shape(*whole)) return reduced;
  return scan.shape = whole;
}

template <class... T>
void tell(const std::function<void(T...)>& to, const std::type_identity_t<T>&... what) {
  if (to) to(what...);
}

/// The colours that the scan has of its own, and what is drawn by them.
void add_colors(OpenedScan& scan, const CancelToken& cancel) {
  ScanColors colors = scan_colors(*scan.model, cancel);
  scan.color_problems = std::move(colors.problems);
  if (colors.at_vertices.empty()) return;
  SurfaceShape shape = *scan.shape;
  scan.colored = colored_parts(colors, shape);
  scan.shape = std::make_shared<SurfaceShape>(with_reduced(std::move(shape)));
  scan.colors = std::make_shared<const std::vector<Color>>(std::move(colors.at_vertices));
}

}  // namespace

OpenedScanPtr load_scan(const QString& path, std::optional<Vec3> origin, const LoadStages& stages,
                        const CancelToken& cancel) {
  tell(stages.stage, tr("Reading the file"), 0);
  ImportedMesh imported = read(path);
  if (cancel.cancelled()) return nullptr;

  auto scan = std::make_shared<OpenedScan>();
  scan->path = path;
  scan->from = path.isEmpty() ? ScanOrigin::sample : ScanOrigin::file;
  scan->name = path.isEmpty() ? tr("Sample") : QFileInfo(path).fileName();
  scan->import = imported.report;
  scan->origin = origin.value_or(scene_origin(imported.soup));
  if (stages.picture) stages.picture(first_picture(imported.soup, *scan));
  if (cancel.cancelled()) return nullptr;

  constexpr double share_of_reading = 0.25;  // of 12 s for 14 million triangles
  tell(stages.stage, tr("Looking for holes"), share_of_reading);
  scan->fingerprint = fingerprint_of(imported.soup);
  scan->model = make_shared_surface_model(std::move(imported.soup), std::move(imported.survey));
  if (cancel.cancelled()) return nullptr;
  parallel_invoke(
      [&scan] {
        scan->loops = find_boundary_loops(*scan->model);
        scan->pieces = scan_pieces(scan->model->mesh);
      },
      [&scan] {
        if (!scan->shape || !view_is_file(*scan->model))
          scan->shape = std::make_shared<SurfaceShape>(with_reduced(shape_of(scan->model->mesh, scan->origin)));
      });
  if (cancel.cancelled()) return nullptr;
  add_colors(*scan, cancel);
  if (cancel.cancelled()) return nullptr;
  tell(stages.opened, scan);
  return scan;
}

OpenedScanPtr made_scan(TriangleSoup surface, const QString& name, const Vec3& origin) {
  auto scan = std::make_shared<OpenedScan>();
  scan->name = name;
  scan->from = ScanOrigin::made;
  scan->import.vertices = surface.points.size();
  scan->import.faces = scan->import.triangles = surface.triangles.size();
  scan->import.has_colors = !surface.colors.empty();
  scan->origin = origin;
  scan->fingerprint = fingerprint_of(surface);
  scan->model = make_shared_surface_model(std::move(surface));
  scan->loops = find_boundary_loops(*scan->model);
  scan->pieces = scan_pieces(scan->model->mesh);
  scan->shape = std::make_shared<SurfaceShape>(
      with_reduced(with_curvature(shape_of(scan->model->mesh, origin), curvature_field(scan->model->mesh))));
  add_colors(*scan, {});
  return scan;
}

SurfaceShapePtr colored_shape(const OpenedScan& scan, const CancelToken& cancel) {
  CurvatureField field = curvature_field(scan.model->mesh);
  if (cancel.cancelled()) return nullptr;
  return std::make_shared<SurfaceShape>(with_reduced(with_curvature(*scan.shape, std::move(field))));
}

}  // namespace loopmend
