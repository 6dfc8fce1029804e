// SPDX-License-Identifier: GPL-3.0-or-later
#include "fill_job.h"

#include "core/threads.h"
#include "mesh/select_triangles.h"

#include <algorithm>
#include <chrono>
#include <map>
#include <numeric>
#include <set>
#include <stdexcept>

namespace loopmend {

namespace {

/// A patch in the soup: it was pasted as it is, its own vertices and faces in their order.
struct PastedPatch {
  const Patch* patch = nullptr;
  int first_vertex = 0, first_face = 0;
  std::vector<int> piece;                               ///< per own face: the piece of the patch that it belongs to
  std::map<std::pair<int, int>, int> face_at_halfedge;  ///< over patch vertices
};

PastedPatch pasted_patch(const Patch& patch, int first_vertex, int first_face) {
  PastedPatch pasted{&patch, first_vertex, first_face, {}, {}};
  for (int f = 0; f < patch.patch_triangles; ++f) {
    const Triangle& t = patch.triangles[static_cast<std::size_t>(f)];
    for (std::size_t c = 0; c < 3; ++c) pasted.face_at_halfedge[{t[c], t[(c + 1) % 3]}] = f;
  }
  pasted.piece.assign(static_cast<std::size_t>(patch.patch_triangles), -1);
  int pieces = 0;
  for (int start = 0; start < patch.patch_triangles; ++start) {
    if (pasted.piece[static_cast<std::size_t>(start)] >= 0) continue;
    std::vector<int> front{start};
    pasted.piece[static_cast<std::size_t>(start)] = pieces;
    while (!front.empty()) {
      const Triangle t = patch.triangles[static_cast<std::size_t>(front.back())];
      front.pop_back();
      for (std::size_t c = 0; c < 3; ++c) {
        const auto beyond = pasted.face_at_halfedge.find({t[(c + 1) % 3], t[c]});
        if (beyond == pasted.face_at_halfedge.end()) continue;
        int& piece = pasted.piece[static_cast<std::size_t>(beyond->second)];
        if (piece >= 0) continue;
        piece = pieces;
        front.push_back(beyond->second);
      }
    }
    ++pieces;
  }
  return pasted;
}

/// The piece of the patch that has an edge with this loop.
NewPart part_at(const PastedPatch& pasted, int place) {
  const std::vector<int>& loop = pasted.patch->loops[static_cast<std::size_t>(place)];
  int piece = -1;
  for (std::size_t k = 0; k < loop.size() && piece < 0; ++k) {
    const int a = loop[k], b = loop[(k + 1) % loop.size()];
    for (const auto& edge : {std::pair(a, b), std::pair(b, a)})
      if (const auto face = pasted.face_at_halfedge.find(edge); face != pasted.face_at_halfedge.end())
        piece = pasted.piece[static_cast<std::size_t>(face->second)];
  }
  NewPart part;
  std::set<int> vertices;
  for (int f = 0; f < pasted.patch->patch_triangles; ++f) {
    if (pasted.piece[static_cast<std::size_t>(f)] != piece) continue;
    part.faces.push_back(pasted.first_face + f);
    for (const int v : pasted.patch->triangles[static_cast<std::size_t>(f)])
      if (v < pasted.patch->free_count) vertices.insert(pasted.first_vertex + v);
  }
  part.vertices.assign(vertices.begin(), vertices.end());
  return part;
}

/// Patches stand in the soup in the order of their smallest loop numbers (pipeline/paste.h).
void locate_parts(FilledScan& done) {
  std::map<int, const PatchResult*> in_order;
  for (const HoleResult& hole : done.holes)
    if (is_filled(hole.status) && hole.patch) {
      const std::vector<int>& numbers = hole.patch->patch.loop_numbers;
      in_order[*std::min_element(numbers.begin(), numbers.end())] = hole.patch.get();
    }
  std::map<const PatchResult*, PastedPatch> pasted;
  auto vertex = static_cast<int>(done.given_vertices), face = static_cast<int>(done.given_faces);
  for (const auto& [number, result] : in_order) {
    pasted[result] = pasted_patch(result->patch, vertex, face);
    vertex += result->patch.free_count;
    face += result->patch.patch_triangles;
  }
  if (vertex != static_cast<int>(done.soup.points.size()) || face != static_cast<int>(done.soup.triangles.size()))
    throw std::logic_error("the patches are not where they should be in the filled mesh: nothing is handed on");
  for (const HoleResult& hole : done.holes)
    done.parts.push_back(is_filled(hole.status) && hole.patch ? part_at(pasted.at(hole.patch.get()), hole.place)
                                                              : NewPart());
}

/// Takes the faces of the scan away, and the vertices that no patch uses, as `fill --patches-only` does.
void keep_patches_only(FilledScan& done) {
  std::vector<char> in_patch(done.soup.triangles.size(), 1);
  std::fill_n(in_patch.begin(), done.given_faces, 0);
  TriangleSelection patches = select_triangles(done.soup, in_patch);
  const auto& number = patches.point_number;
  const auto end_of_given = number.begin() + static_cast<std::ptrdiff_t>(done.given_vertices);
  done.given_vertices = static_cast<std::size_t>(std::count_if(number.begin(), end_of_given, [](int v) { return v >= 0; }));
  for (NewPart& part : done.parts) {
    for (int& v : part.vertices) v = number[static_cast<std::size_t>(v)];
    for (int& f : part.faces) f -= static_cast<int>(done.given_faces);
  }
  done.given_faces = 0;
  done.soup = std::move(patches.soup);
}

FilledScan filled(FillJob& job, const OnFillProgress& progress, const CancelToken& cancel) {
  const Deadline deadline(std::chrono::steady_clock::now(), job.command.max_seconds, cancel);
  FilledScan done;
  SoupRecord as_read = record_of(job.soup);
  SurfaceModel model = make_surface_model(std::move(job.soup));
  PreparedScan scan = prepare_scan(std::move(as_read), std::move(model), job.command, cancel);
  done.holes = fill_chosen(scan, job.command, deadline, progress, cancel);
  done.stopped = cancel.cancelled();
  done.turned_faces = scan.turned_faces();
  done.prepared = std::move(scan.done);
  done.trimmed = std::move(scan.trimmed);
  done.given_vertices = scan.given.points;
  done.given_faces = scan.given.triangles;
  done.soup = std::move(scan.model.soup);
  locate_parts(done);
  if (job.command.content == FillCommand::Content::patches) keep_patches_only(done);
  return done;
}

}  // namespace

FilledScan run_fill_job(FillJob job, const OnFillProgress& progress, const CancelToken& cancel) {
  check(job.command.fill);
  return with_thread_budget(job.command.fill.threads, [&] { return filled(job, progress, cancel); });
}

}  // namespace loopmend
