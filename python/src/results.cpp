// SPDX-License-Identifier: GPL-3.0-or-later
#include "results.h"

#include "arrays.h"
#include "carried.h"

#include <pybind11/stl.h>

namespace loopmend {

namespace {

namespace py = pybind11;
using namespace py::literals;

py::dict seam_figures(const SeamReport& seam) {
  return py::dict("g1_rms_deg"_a = seam.g1_rms_deg, "g1_max_deg"_a = seam.g1_max_deg, "h_jump_rms"_a = seam.h_jump_rms,
                  "h_jump_max"_a = seam.h_jump_max, "h_jump_rms_times_diameter"_a = seam.h_jump_rms_times_diameter);
}

py::list seams_of(const std::vector<SeamReport>& seams) {
  py::list list;
  for (const SeamReport& seam : seams) list.append(seam_figures(seam));
  return list;
}

py::dict verdict_figures(const Verdict& verdict) {
  py::list findings;
  for (const Notice& finding : verdict.findings)
    findings.append(py::dict("code"_a = to_string(finding.code), "arguments"_a = finding.arguments,
                             "text"_a = message_of(finding).english()));
  return py::dict("grade"_a = to_string(verdict.grade), "sentence"_a = verdict.message().english(),
                  "findings"_a = findings, "crease_deg"_a = verdict.crease_deg, "height"_a = verdict.height,
                  "folds"_a = verdict.folds);
}

py::object deviation_figures(const ExpectedDeviation& deviation) {
  if (!deviation.is_known()) return py::none();
  return py::dict("half"_a = deviation.half, "likely"_a = deviation.likely, "most"_a = deviation.most);
}

py::object mirror_figures(const MirrorFit& fit) {
  if (fit.answer == MirrorFit::Answer::not_asked) return py::none();
  const auto vector = [](const Vec3& v) { return py::make_tuple(v.x(), v.y(), v.z()); };
  return py::dict("answer"_a = to_string(fit.answer), "is_taken"_a = fit.is_proposed(), "misfit"_a = fit.misfit,
                  "difference"_a = fit.difference, "text"_a = message_of(notice_on(fit)).english(),
                  "plane_point"_a = vector(fit.plane.point), "plane_normal"_a = vector(fit.plane.normal),
                  "plane_misfit"_a = fit.plane.misfit);
}

py::dict hole_figures(const HoleResult& hole, NewPart part) {
  py::dict figures = loop_figures(hole.loop);
  figures["status"] = to_string(hole.status);
  figures["is_filled"] = is_filled(hole.status);
  figures["message"] = hole.message.english();
  figures["method"] = hole.method();
  figures["reason"] = hole.reason().english();
  figures["verdict"] = is_filled(hole.status) ? py::object(verdict_figures(hole.verdict())) : py::none();
  figures["expected_deviation"] = deviation_figures(hole.deviation());
  figures["mirror"] = mirror_figures(hole.mirror);
  figures["steps"] = hole.steps();
  figures["energy_before"] = hole.outcome().energy.initial;
  figures["energy_after"] = hole.outcome().energy.final;
  figures["seam_before"] = is_filled(hole.status) ? py::object(seam_figures(hole.seam_before())) : py::none();
  figures["seam_after"] = is_filled(hole.status) ? py::object(seam_figures(hole.seam_after())) : py::none();
  figures["seconds"] = hole.seconds;
  figures["new_vertices"] = array_of<int>(std::move(part.vertices));
  figures["new_faces"] = array_of<int>(std::move(part.faces));
  return figures;
}

py::list faces_of(const std::vector<BadBoundaryFace>& faces) {
  py::list list;
  for (const BadBoundaryFace& bad : faces)
    list.append(py::dict("face"_a = bad.face, "fault"_a = to_string(bad.fault), "ring"_a = bad.ring));
  return list;
}

py::dict union_figures(const UnionCounts& united) {
  return py::dict("bodies"_a = united.bodies, "made"_a = united.made, "removed_faces"_a = united.removed_faces,
                  "new_faces"_a = united.new_faces, "open_pieces"_a = united.open_pieces,
                  "crossing_bodies"_a = united.crossing, "touching_pairs"_a = united.touching,
                  "refused_pairs"_a = united.refused, "crossing_parts"_a = united.crossing_parts);
}

/// Only what was done: {"joined_tiles": {...}, "stitched": {...}, "repaired": {...}, "joined_again": N}.
py::dict preparation(const FilledScan& done) {
  py::dict counts;
  if (done.prepared.tiles.removed_faces > 0)
    counts["joined_tiles"] = py::dict(
        "removed_faces"_a = done.prepared.tiles.removed_faces, "removed_parts"_a = done.prepared.tiles.removed_parts,
        "strips"_a = done.prepared.tiles.bridges, "open_gaps"_a = done.prepared.tiles.open_gaps);
  if (done.prepared.stitched)
    counts["stitched"] = py::dict("joined_vertices"_a = done.prepared.stitched->joined_vertices,
                                  "split_faces"_a = done.prepared.stitched->split_faces,
                                  "removed_faces"_a = done.prepared.stitched->removed_faces);
  if (done.prepared.repaired) {
    const RepairCounts& repaired = *done.prepared.repaired;
    counts["repaired"] =
        py::dict("separated_edges"_a = repaired.separated_edges, "separated_vertices"_a = repaired.separated_vertices,
                 "turned_faces"_a = repaired.turned_faces, "turned_shells"_a = repaired.turned_shells,
                 "degenerate_faces"_a = repaired.degenerate_faces, "duplicate_faces"_a = repaired.duplicate_faces,
                 "intersecting_faces"_a = repaired.intersecting_faces, "cut_handles"_a = repaired.cut_handles,
                 "handle_faces"_a = repaired.handle_faces, "removed_pieces"_a = repaired.removed_pieces,
                 "removed_faces"_a = repaired.removed_faces, "overlapping_bodies"_a = repaired.overlapping_bodies,
                 "union"_a = union_figures(repaired.united));
  }
  if (const auto& cut = done.prepared.cut)
    counts["plane_cut"] =
        py::dict("removed_faces"_a = cut->removed_faces, "divided_faces"_a = cut->divided_faces,
                 "closed_curves"_a = cut->closed, "open_curves"_a = cut->left_open, "new_faces"_a = cut->new_faces);
  if (done.prepared.base_loop > 0) counts["base_loop"] = done.prepared.base_loop;
  if (done.prepared.no_data_faces) counts["no_data_faces"] = *done.prepared.no_data_faces;
  if (done.prepared.joined_again > 0) counts["joined_again"] = done.prepared.joined_again;
  return counts;
}

}  // namespace

py::dict loop_figures(const BoundaryLoop& loop) {
  return py::dict("number"_a = loop.number, "kind"_a = to_string(loop.kind), "edges"_a = loop.edges(),
                  "perimeter"_a = loop.perimeter, "diameter"_a = loop.diameter, "planarity"_a = loop.planarity,
                  "area"_a = loop.area, "center"_a = py::make_tuple(loop.center[0], loop.center[1], loop.center[2]));
}

py::dict patch_figures(const PatchResult& result) {
  return py::dict("status"_a = to_string(result.status), "message"_a = result.message.english(),
                  "method"_a = method_name(result), "reason"_a = result.reason.english(), "steps"_a = result.steps,
                  "energy_before"_a = result.energy.initial, "energy_after"_a = result.energy.final,
                  "folds"_a = result.validity.folds, "self_intersections"_a = result.validity.intersections,
                  "min_angle_deg"_a = result.validity.min_angle_deg, "seams_before"_a = seams_of(result.seams_before),
                  "seams_after"_a = seams_of(result.seams));
}

py::dict check_figures(const Watertightness& surface) {
  return py::dict("ready_to_print"_a = surface.printable(), "against_it"_a = py::tuple(py::cast(faults(surface))),
                  "pieces"_a = surface.pieces, "open_boundaries"_a = surface.open_boundaries,
                  "open_edges"_a = surface.open_edges, "touching_edges"_a = surface.touching_edges,
                  "non_manifold_edges"_a = surface.non_manifold_edges, "reversed_edges"_a = surface.reversed_edges,
                  "intersecting_pairs"_a = surface.intersections,
                  "volume"_a = surface.encloses() ? py::object(py::float_(surface.volume)) : py::none());
}

py::dict fill_result(FilledScan done) {
  py::list holes;
  for (std::size_t k = 0; k < done.holes.size(); ++k)
    holes.append(hole_figures(done.holes[k], std::move(done.parts[k])));
  py::dict result("holes"_a = holes, "given_vertices"_a = done.given_vertices, "given_faces"_a = done.given_faces,
                  "turned_faces"_a = done.turned_faces, "stopped"_a = done.stopped, "prepared"_a = preparation(done),
                  "trimmed_faces"_a = faces_of(done.trimmed),
                  "expected_deviation"_a = array_of<double>(expected_deviations(done.holes)));
  result["carried"] = carried_by(done.soup);
  result["vertices"] = points_array(std::move(done.soup.points));
  result["faces"] = triangles_array(std::move(done.soup.triangles));
  result["colors"] = colors_array(std::move(done.soup.colors));
  return result;
}

}  // namespace loopmend
