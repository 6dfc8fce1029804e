// SPDX-License-Identifier: GPL-3.0-or-later
#include "fill_job.h"

#include "cli/loop_selection.h"
#include "core/threads.h"
#include "pipeline/hand_bridge.h"
#include "pipeline/paste.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <set>
#include <stdexcept>

namespace loopmend {

namespace {

struct Preparation {
  TriangleSoup given;  ///< what the output is compared with
  SurfaceModel model;
};

Preparation prepared(FillJob& job, FilledScan& done) {
  Preparation scan{std::move(job.soup), {}};
  scan.model = make_surface_model(scan.given);
  const auto replace = [&](TriangleSoup soup) {
    done.turned_faces += scan.model.repairs.reoriented_faces;
    scan.given = std::move(soup);
    scan.model = make_surface_model(scan.given);
  };
  if (job.command.stitch == FillCommand::Stitch::yes) {
    done.stitched = stitch_boundaries(scan.model);
    replace(std::move(done.stitched->soup));
  }
  if (job.command.repair == FillCommand::Repair::yes) {
    RepairedSurface repaired = repair_surface(scan.given);
    done.repaired = repaired.counts;
    replace(std::move(repaired.soup));
  }
  const auto count = static_cast<int>(scan.given.points.size());
  for (const auto& [a, b] : job.bridges) {
    if (a < 0 || b < 0 || a >= count || b >= count)
      throw InvalidArgument("bridge (" + std::to_string(a) + ", " + std::to_string(b) + "): the mesh has " +
                            std::to_string(count) + " vertices, numbered from 0");
    replace(with_bridge(scan.model, a, b));
  }
  return scan;
}

std::vector<BoundaryLoop> chosen_of(const std::vector<BoundaryLoop>& loops, const std::vector<LoopChoice>& choices) {
  std::vector<BoundaryLoop> chosen;
  for (std::size_t k = 0; k < loops.size(); ++k)
    if (choices[k].fill) chosen.push_back(loops[k]);
  return chosen;
}

bool names_loops(const FillCommand& command) { return command.loops != "all" || command.at_vertices; }

/// Choices among the loops of a trimmed scan: what grew out of those chosen before.
std::vector<LoopChoice> choices_after_trim(const std::vector<BoundaryLoop>& loops,
                                           const std::vector<BoundaryLoop>& grown, const FillCommand& command) {
  std::vector<LoopChoice> choices(loops.size());
  for (std::size_t k = 0; k < loops.size(); ++k) {
    const bool can_be_filled = loops[k].kind == LoopKind::hole || loops[k].kind == LoopKind::outer_rim;
    choices[k].fill = can_be_filled && std::any_of(grown.begin(), grown.end(), [&](const BoundaryLoop& loop) {
                        return loop.number == loops[k].number;
                      });
    if (choices[k].fill) continue;
    if (!names_loops(command)) choices[k] = choose_unnamed(loops[k], command);
    if (std::exchange(choices[k].fill, false) || names_loops(command)) choices[k].why_not = "not selected";
  }
  return choices;
}

void trim(Preparation& scan, std::vector<BoundaryLoop>& loops, std::vector<LoopChoice>& choices,
          const FillCommand& command, FilledScan& done) {
  TrimmedModel trimmed = trim_rim(scan.model, chosen_of(loops, choices), command.trim_rounds);
  done.trimmed = std::move(trimmed.removed);
  if (done.trimmed.empty()) return;
  std::vector<char> gone(scan.given.triangles.size(), 0);
  for (const BadRimFace& bad : done.trimmed) gone[static_cast<std::size_t>(bad.face)] = 1;
  Triangles left;
  for (std::size_t f = 0; f < gone.size(); ++f)
    if (!gone[f]) left.push_back(scan.given.triangles[f]);
  scan.given.triangles = std::move(left);
  std::size_t turned = 0;
  for (std::size_t f = 0; f < scan.given.triangles.size(); ++f)
    turned += trimmed.model.soup.triangles[f] != scan.given.triangles[f];
  trimmed.model.repairs.reoriented_faces = turned;
  scan.model = std::move(trimmed.model);
  loops = find_boundary_loops(scan.model);
  choices = choices_after_trim(loops, trimmed.loops, command);
}

/// Those of the chosen loops, and for the others one that says why they were left.
std::vector<HoleResult> with_those_left(std::vector<HoleResult> filled, const std::vector<BoundaryLoop>& loops,
                                        const std::vector<LoopChoice>& choices) {
  std::map<int, HoleResult> by_number;
  for (HoleResult& result : filled) by_number[result.loop.number] = std::move(result);
  std::vector<HoleResult> results;
  for (std::size_t k = 0; k < loops.size(); ++k) {
    const auto done = by_number.find(loops[k].number);
    results.push_back(done != by_number.end() ? std::move(done->second)
                                              : open_hole(loops[k], PatchStatus::skipped, choices[k].why_not));
  }
  return results;
}

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

FilledScan filled(FillJob& job, const OnFillProgress& progress, const CancelToken& cancel) {
  FilledScan done;
  Preparation scan = prepared(job, done);
  std::vector<BoundaryLoop> loops = find_boundary_loops(scan.model);
  std::vector<LoopChoice> choices = choose_loops(scan.model, loops, job.command);
  if (job.command.trim_rounds > 0) trim(scan, loops, choices, job.command, done);
  const std::vector<BoundaryLoop> chosen = chosen_of(loops, choices);
  std::vector<HoleResult> results;
  if (!chosen.empty()) results = fill_holes(scan.model, chosen, job.command.fill, progress, cancel);
  if (cancel.cancelled()) return done;
  done.holes = with_those_left(std::move(results), loops, choices);
  check_exterior(scan.given, scan.model.soup, scan.model.repairs.reoriented_faces);
  done.turned_faces += scan.model.repairs.reoriented_faces;
  done.given_vertices = scan.given.points.size();
  done.given_faces = scan.given.triangles.size();
  done.soup = std::move(scan.model.soup);
  locate_parts(done);
  return done;
}

}  // namespace

FilledScan run_fill_job(FillJob job, const OnFillProgress& progress, const CancelToken& cancel) {
  check(job.command.fill);
  return with_thread_budget(job.command.fill.threads, [&] { return filled(job, progress, cancel); });
}

}  // namespace loopmend
