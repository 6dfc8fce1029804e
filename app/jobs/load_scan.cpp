#include "jobs/load_scan.h"

#include "samples/sample_scan.h"

#include <QCoreApplication>

namespace loopmend {
namespace {

QString tr(const char* text) { return QCoreApplication::translate("loopmend", text); }

ImportedMesh read(const QString& path) {
  if (!path.isEmpty()) return read_mesh(path.toStdString());
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

}  // namespace

void load_scan(const QString& path, const LoadStages& stages, const CancelToken& cancel) {
  stages.stage(tr("Reading the file"));
  ImportedMesh imported = read(path);
  if (cancel.cancelled()) return;

  OpenedScan scan;
  scan.path = path.isEmpty() ? tr("Sample") : path;
  scan.import = imported.report;
  scan.origin = scene_origin(imported.soup);
  scan.shape = std::make_shared<SurfaceShape>(shape_of(imported.soup, scan.origin));
  stages.picture(scan.shape);
  if (cancel.cancelled()) return;

  stages.stage(tr("Looking for holes"));
  scan.model = std::make_shared<SurfaceModel>(make_surface_model(std::move(imported.soup)));
  if (cancel.cancelled()) return;
  scan.loops = find_boundary_loops(*scan.model);
  if (cancel.cancelled()) return;
  if (!view_is_file(*scan.model))
    scan.shape = std::make_shared<SurfaceShape>(shape_of(scan.model->mesh, CurvatureField{}, scan.origin));
  if (cancel.cancelled()) return;
  const auto model = scan.model;
  const Vec3 origin = scan.origin;
  stages.opened(std::move(scan));

  stages.stage(tr("Computing curvature"));
  const CurvatureField field = curvature_field(model->mesh);
  if (cancel.cancelled()) return;
  stages.colored(std::make_shared<SurfaceShape>(shape_of(model->mesh, field, origin)));
}

}  // namespace loopmend
