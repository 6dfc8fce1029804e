// SPDX-License-Identifier: GPL-3.0-or-later
#include "jobs/export_scene.h"

#include "core/error.h"
#include "mesh/scan_attributes.h"
#include "pipeline/paste.h"

#include <algorithm>
#include <limits>

namespace loopmend {
namespace {

void leave_open(const OpenPatch& patch, ExportResult& result) {
  result.left_open.insert(patch.loops.begin(), patch.loops.end());
}

bool is_left_out(const OpenPatch& patch) {
  return patch.state->status == PatchStatus::invalid && patch.acceptance != Acceptance::accepted;
}

/// @param deviations  takes up the likely error of each vertex that comes to those of the scan, NaN where it is not known.
TriangleSoup pasted(const ExportTask::Part& part, ExportResult& result, std::vector<double>& deviations) {
  SurfaceModel model = *part.model;
  std::vector<const OpenPatch*> wanted;
  std::vector<const Patch*> patches;
  for (const OpenPatch& patch : part.patches) {
    if (is_left_out(patch)) {
      leave_open(patch, result);
      continue;
    }
    wanted.push_back(&patch);
    patches.push_back(&patch.state->patch);
  }
  const std::vector<PastedPatch> outcomes = paste_patches(model, patches);
  const std::size_t scan = part.model->soup.points.size();
  deviations.assign(model.soup.points.size() - scan, std::numeric_limits<double>::quiet_NaN());
  for (std::size_t k = 0; k < outcomes.size(); ++k) {
    const std::vector<double>& own = wanted[k]->state->deviation.vertices;
    if (!outcomes[k].fault.empty())
      leave_open(*wanted[k], result);
    else if (outcomes[k].first_point >= 0)
      std::copy(own.begin(), own.end(),
                deviations.begin() + (outcomes[k].first_point - static_cast<std::ptrdiff_t>(scan)));
  }
  return model.soup;
}

void set_unit(TriangleSoup& soup, const std::string& unit) {
  auto attributes =
      soup.attributes ? std::make_shared<ScanAttributes>(*soup.attributes) : std::make_shared<ScanAttributes>();
  attributes->unit = unit;
  soup.attributes = std::move(attributes);
}

/// The patch's own vertices and triangles, sewn to the points of the scan.
void sew_on(TriangleSoup& soup, const SurfaceModel& model, const Patch& patch) {
  const auto first = static_cast<int>(soup.points.size());
  const auto point = [&](int v) {
    if (v < patch.free_count) return first + v;
    return model.soup_vertex[patch.view_vertex[v]];
  };
  for (int v = 0; v < patch.free_count; ++v) soup.points.push_back(patch.to_mesh(patch.positions[v]));
  for (int f = 0; f < patch.patch_triangles; ++f) {
    const Triangle& t = patch.triangles[f];
    soup.triangles.push_back({point(t[0]), point(t[1]), point(t[2])});
  }
}

}  // namespace

TriangleSoup plain_surface(const ExportTask& task) {
  std::vector<TriangleSoup> soups;
  for (const ExportTask::Part& part : task.parts) {
    TriangleSoup& soup = soups.emplace_back();
    soup.points = part.model->soup.points;
    soup.triangles = part.model->soup.triangles;
    for (const OpenPatch& patch : part.patches)
      if (!is_left_out(patch)) sew_on(soup, *part.model, patch.state->patch);
  }
  return joined(std::move(soups));
}

ExportTask export_task(const Document& document, const std::filesystem::path& path, const ExportChoice& choice) {
  ExportTask task;
  task.path = path;
  task.choice = choice;
  if (!document.chosen_units().empty()) task.unit = document.unit();
  for (int index : document.scans()) {
    ExportTask::Part part{document.scan(index)->model, {}};
    for (const NotKept& entry : document.scan(index)->import.not_kept)
      count_not_kept(task.not_read, entry.what, entry.count);
    for (const OpenPatch& patch : document.patches())
      if (patch.scan == index) part.patches.push_back(patch);
    task.parts.push_back(std::move(part));
  }
  return task;
}

ExportResult export_scene(const ExportTask& task, const CancelToken& cancel,
                          const std::function<void(double)>& painted) {
  const bool is_labelled =
      task.choice.new_faces == NewFaces::labelled || task.choice.deviations == ExportChoice::Deviations::written;
  if (is_labelled && task.parts.size() > 1)
    throw InvalidArgument(say("Labels need a file of one scan: export the scans one by one."));
  ExportResult result;
  std::vector<TriangleSoup> soups;
  WriteScanOptions options;
  options.new_faces = task.choice.new_faces;
  options.on_painted = painted;
  for (const ExportTask::Part& part : task.parts) {
    if (cancel.cancelled()) return result;
    std::vector<double> deviations;
    soups.push_back(pasted(part, result, deviations));
    if (task.choice.deviations == ExportChoice::Deviations::written) options.expected_deviation = std::move(deviations);
    if (task.choice.content == ExportChoice::Content::scene) continue;
    options.written.resize(options.written.size() + part.model->soup.triangles.size(), 0);
    const std::size_t added = soups.back().triangles.size() - part.model->soup.triangles.size();
    options.written.resize(options.written.size() + added, 1);
  }
  result.not_kept = task.not_read;
  if (soups.size() > 1)
    for (const TriangleSoup& soup : soups)
      for (const NotKept& entry : carried_attributes(soup)) count_not_kept(result.not_kept, entry.what, entry.count);
  TriangleSoup all = joined(std::move(soups));
  if (!task.unit.empty()) set_unit(all, task.unit);
  if (cancel.cancelled()) return result;
  OutputTransaction outputs;
  result.remarks = write_scan(outputs, task.path, all, options, cancel).remarks;
  if (cancel.cancelled()) return result;
  outputs.commit();
  result.triangles = all.triangles.size();
  for (const NotKept& entry : not_kept_by_format(task.path, all))
    count_not_kept(result.not_kept, entry.what, entry.count);
  result.largest_rounding = largest_rounding(task.path, all, Encoding::binary);
  return result;
}

}  // namespace loopmend
