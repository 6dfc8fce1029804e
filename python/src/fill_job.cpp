// SPDX-License-Identifier: GPL-3.0-or-later
#include "fill_job.h"

#include "core/threads.h"
#include "mesh/select_triangles.h"

#include <algorithm>
#include <chrono>
#include <map>
#include <set>
#include <utility>

namespace loopmend {

namespace {

/// The connected part of a patch that has an edge with this loop, as it stands in the soup.
NewPart part_at(const HoleResult& hole) {
  const Patch& patch = hole.patch->patch;
  std::map<std::pair<int, int>, int> face_at;  // by half-edge
  for (int f = 0; f < patch.patch_triangles; ++f) {
    const Triangle& t = patch.triangles[f];
    for (std::size_t c = 0; c < 3; ++c) face_at[{t[c], t[(c + 1) % 3]}] = f;
  }
  const std::vector<int>& loop = patch.loops[hole.place];
  std::vector<int> front;
  for (std::size_t k = 0; k < loop.size() && front.empty(); ++k) {
    const int a = loop[k], b = loop[(k + 1) % loop.size()];
    for (const auto& edge : {std::pair(a, b), std::pair(b, a)})
      if (const auto face = face_at.find(edge); face != face_at.end()) front.push_back(face->second);
  }
  std::set<int> vertices, faces(front.begin(), front.end());
  while (!front.empty()) {
    const Triangle t = patch.triangles[front.back()];
    front.pop_back();
    for (std::size_t c = 0; c < 3; ++c) {
      if (t[c] < patch.free_count) vertices.insert(hole.first_point + t[c]);
      const auto beyond = face_at.find({t[(c + 1) % 3], t[c]});
      if (beyond != face_at.end() && faces.insert(beyond->second).second) front.push_back(beyond->second);
    }
  }
  NewPart part;
  part.vertices.assign(vertices.begin(), vertices.end());
  for (const int f : faces) part.faces.push_back(hole.first_triangle + f);
  return part;
}

/// Takes the faces of the scan away, and the vertices that no patch uses, as `fill --patches-only` does.
void keep_patches_only(FilledScan& done) {
  std::vector<char> in_patch(done.soup.triangles.size(), 1);
  std::fill_n(in_patch.begin(), done.given_faces, 0);
  TriangleSelection patches = select_triangles(done.soup, in_patch);
  const auto& number = patches.point_number;
  const auto end_of_given = number.begin() + static_cast<std::ptrdiff_t>(done.given_vertices);
  done.given_vertices =
      static_cast<std::size_t>(std::count_if(number.begin(), end_of_given, [](int v) { return v >= 0; }));
  for (NewPart& part : done.parts) {
    for (int& v : part.vertices) v = number[v];
    for (int& f : part.faces) f -= static_cast<int>(done.given_faces);
  }
  done.given_faces = 0;
  done.soup = std::move(patches.soup);
}

FilledScan filled(FillJob& job, const OnFillProgress& progress, const CancelToken& cancel) {
  const Deadline deadline(std::chrono::steady_clock::now(), job.max_seconds, cancel);
  FilledScan done;
  SoupRecord given = record_of(job.soup);
  ScanPlan plan = plan_scan(std::move(given), make_surface_model(std::move(job.soup)), job.job, cancel);
  done.holes = fill_chosen(plan, job.job, deadline, progress, cancel);
  done.stopped = cancel.cancelled();
  done.turned_faces = plan.turned_faces();
  done.prepared = std::move(plan.done);
  done.trimmed = std::move(plan.trimmed);
  done.given_vertices = plan.given.points;
  done.given_faces = plan.given.triangles;
  done.soup = std::move(plan.model.soup);
  for (const HoleResult& hole : done.holes) done.parts.push_back(hole.first_point >= 0 ? part_at(hole) : NewPart());
  if (job.content == FillJob::Content::patches) keep_patches_only(done);
  return done;
}

}  // namespace

FilledScan run_fill_job(FillJob job, const OnFillProgress& progress, const CancelToken& cancel) {
  check(job.job.fill);
  return with_thread_budget(job.job.fill.threads, [&] { return filled(job, progress, cancel); });
}

}  // namespace loopmend
