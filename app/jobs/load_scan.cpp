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

}  // namespace

void load_scan(const QString& path, const LoadStages& stages, const CancelToken& cancel) {
  stages.stage(tr("Reading the file"));
  ImportedMesh imported = read(path);
  if (cancel.cancelled()) return;

  OpenedScan scan;
  scan.path = path.isEmpty() ? tr("Sample") : path;
  scan.import = imported.report;
  scan.origin = scene_origin(imported.soup);
  stages.picture(std::make_shared<SurfaceShape>(shape_of(imported.soup, scan.origin)));
  if (cancel.cancelled()) return;

  stages.stage(tr("Looking for holes"));
  scan.model = std::make_shared<SurfaceModel>(make_surface_model(std::move(imported.soup)));
  if (cancel.cancelled()) return;
  scan.loops = find_boundary_loops(*scan.model);
  if (cancel.cancelled()) return;
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
