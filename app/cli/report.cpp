// SPDX-License-Identifier: GPL-3.0-or-later
#include "report.h"

#include "core/path_text.h"
#include "outputs.h"

#include <cmath>
#include <numbers>

namespace loopmend {

using Json = nlohmann::ordered_json;

namespace {

/// JSON knows no NaN: null.
Json json_number(double value) { return std::isfinite(value) ? Json(value) : Json(nullptr); }

}  // namespace

Json seam_json(const SeamReport& seam) {
  return {{"g1_rms_deg", json_number(seam.g1_rms_deg)},
          {"g1_max_deg", json_number(seam.g1_max_deg)},
          {"h_jump_rms", json_number(seam.h_jump_rms)},
          {"h_jump_max", json_number(seam.h_jump_max)},
          {"h_jump_rms_times_diameter", json_number(seam.h_jump_rms_times_diameter)}};
}

Json input_json(const std::filesystem::path& path, const ImportReport& import, const ModelRepairs& repairs) {
  return {{"path", path_text(path)},
          {"vertices", import.vertices},
          {"faces", import.faces},
          {"import",
           {{"format", import.format},
            {"triangles", import.triangles},
            {"polygons_triangulated", import.polygons_triangulated},
            {"vertices_welded", import.vertices_welded},
            {"vertices_joined", import.vertices_joined},
            {"near_vertices_joined", import.near_vertices_joined},
            {"largest_join", import.largest_join},
            {"unreferenced_vertices", import.unreferenced_vertices},
            {"coincident_vertices", import.coincident_vertices},
            {"degenerate_faces", import.degenerate_faces},
            {"duplicate_faces", import.duplicate_faces},
            {"non_manifold_edges", repairs.non_manifold_edges},
            {"non_manifold_vertices", repairs.non_manifold_vertices},
            {"reoriented_faces", repairs.reoriented_faces},
            {"has_colors", import.has_colors},
            {"missing_colors", import.missing_colors},
            {"skipped_elements", import.skipped_elements},
            {"not_kept", not_kept_json(import.not_kept)},
            {"oddities", not_kept_json(import.oddities)}}}};
}

Json loop_json(const BoundaryLoop& loop) {
  return {{"number", loop.number},
          {"edges", loop.edges()},
          {"perimeter", loop.perimeter},
          {"diameter", loop.diameter},
          {"planarity", loop.planarity},
          {"area", loop.area},
          {"turning", loop.turning},
          {"extent", loop.extent},
          {"depth", json_number(loop.depth > 0 ? loop.depth : std::nan(""))},
          {"onward", loop.onward},
          {"coincident_edges", loop.coincident},
          {"kind", to_string(loop.kind)}};
}

namespace {

/// Null where the neighborhood was not looked at.
Json boundary_json(const HoleResult& result) {
  if (result.outcome().neighborhood.empty()) return nullptr;
  const BoundarySummary boundary = result.neighborhood();
  return {{"kind", to_string(boundary.split.kind())},
          {"relief", json_number(boundary.relief)},
          {"relief_per_edge", json_number(boundary.relief_per_edge)},
          {"noise", json_number(boundary.noise)},
          {"noise_per_edge", json_number(boundary.noise_per_edge)},
          {"relief_wavelength", json_number(2 * std::numbers::pi * boundary.split.relief)},
          {"noise_wavelength", json_number(2 * std::numbers::pi * boundary.split.noise)},
          {"normal_sigma_deg", json_number(boundary.normal_sigma_deg)},
          {"h_rms", json_number(boundary.H)},
          {"h_sigma", json_number(boundary.H_sigma)},
          {"gradient_h_rms", json_number(boundary.gradient)},
          {"gradient_h_sigma", json_number(boundary.gradient_sigma)},
          {"fitted_vertices", boundary.fitted}};
}

Json verdict_json(const Verdict& verdict) {
  Json findings = Json::array();
  for (const Notice& finding : verdict.findings)
    findings.push_back(
        {{"code", to_string(finding.code)}, {"arguments", finding.arguments}, {"text", message_of(finding).english()}});
  return {{"grade", to_string(verdict.grade)},
          {"sentence", verdict.message().english()},
          {"findings", findings},
          {"crease_deg", verdict.crease_deg ? json_number(*verdict.crease_deg) : Json(nullptr)},
          {"height", json_number(verdict.height)},
          {"folds", verdict.folds}};
}

/// Null without an estimate.
Json deviation_json(const ExpectedDeviation& deviation) {
  if (!deviation.is_known()) return nullptr;
  return {{"half", deviation.half}, {"likely", deviation.likely}, {"most", deviation.most}};
}

Json vector_json(const Vec3& v) { return Json::array({v.x(), v.y(), v.z()}); }

/// Null where no mirror image was asked for.
Json mirror_json(const MirrorFit& fit) {
  if (fit.answer == MirrorFit::Answer::not_asked) return nullptr;
  return {{"answer", to_string(fit.answer)},
          {"misfit", json_number(fit.misfit)},
          {"difference", json_number(fit.difference)},
          {"text", message_of(notice_on(fit)).english()},
          {"plane",
           {{"point", vector_json(fit.plane.point)},
            {"normal", vector_json(fit.plane.normal)},
            {"misfit", json_number(fit.plane.misfit)}}}};
}

/// Share of the energy that a step took away; null where it is not known before the step.
Json decrease_json(double before, double after) { return before > 0 ? json_number((before - after) / before) : Json(); }

/// J of the split and its last relative decrease; null where the patch was not made by a descent of J.
Json split_energy_json(const std::vector<StepRecord>& history) {
  if (history.empty() || !(history.back().split.total() > 0)) return nullptr;
  const double last = history.back().split.total();
  const double before = history.size() > 1 ? history[history.size() - 2].split.total() : 0;
  return {{"J", json_number(last)}, {"last_decrease", decrease_json(before, last)}};
}

/// The last decrease is that of the flow's own steps: fairings and the split lower something else.
Json energy_json(const PatchResult& result) {
  const std::vector<StepRecord>& history = result.history;
  const auto of_flow = [](const StepRecord& step) { return step.sigma > 0 && !(step.split.total() > 0); };
  const bool known = history.size() > 1 && of_flow(history.back()) && of_flow(history[history.size() - 2]);
  return {{"initial", json_number(result.energy.initial)},
          {"final", json_number(result.energy.final)},
          {"last_decrease", known ? decrease_json(history[history.size() - 2].energy, history.back().energy) : Json()}};
}

}  // namespace

Json loop_json(const HoleResult& result) {
  const PatchResult& patch = result.outcome();
  Json json = loop_json(result.loop);
  json["status"] = to_string(result.status);
  json["message"] = result.message.english();
  json["message_code"] = result.message.code;
  json["method"] = result.method();
  json["reason"] = result.reason().english();
  json["reason_code"] = result.reason().code;
  json["attempts"] = patch.attempts;
  json["made_by"] = patch.made_by;
  if (is_filled(result.status)) {
    const Proportion proportion = result.proportion();
    json["verdict"] = verdict_json(result.verdict());
    json["expected_deviation"] = deviation_json(result.deviation());
    json["proportion"] = {{"area", json_number(proportion.area)},
                          {"depth", json_number(proportion.depth)},
                          {"energy", json_number(proportion.energy)}};
  }
  json["mirror"] = mirror_json(result.mirror);
  json["free_vertices"] = result.free_vertices;
  json["steps"] = patch.steps;
  json["bending"] = patch.bending;
  json["neighborhood"] = boundary_json(result);
  json["seconds"] = {{"initial_patch", patch.seconds.initial_patch},
                     {"survey", patch.seconds.survey},
                     {"choice", patch.seconds.choice},
                     {"assemble", patch.seconds.assemble},
                     {"solve", patch.seconds.solve},
                     {"checks", patch.seconds.checks},
                     {"rejected", patch.seconds.rejected},
                     {"expected_deviation", patch.seconds.deviation},
                     {"other", patch.seconds.other()},
                     {"total", result.seconds}};
  json["energy"] = energy_json(patch);
  json["split_energy"] = split_energy_json(patch.history);
  json["seam_before"] = seam_json(result.seam_before());
  json["seam_after"] = seam_json(result.seam_after());
  return json;
}

Json brief_loop_json(const HoleResult& result) {
  return {{"number", result.loop.number},
          {"edges", result.loop.edges()},
          {"perimeter", result.loop.perimeter},
          {"kind", to_string(result.loop.kind)},
          {"status", to_string(result.status)},
          {"message", result.message.english()},
          {"message_code", result.message.code},
          {"method", result.method()},
          {"grade", is_filled(result.status) ? Json(to_string(result.verdict().grade)) : Json()},
          {"expected_deviation", deviation_json(result.deviation())},
          {"free_vertices", result.free_vertices},
          {"seam_after", seam_json(result.seam_after())}};
}

Json patch_json(const PatchResult& result) {
  return {{"status", to_string(result.status)},
          {"message", result.message.english()},
          {"message_code", result.message.code},
          {"method", method_name(result)},
          {"reason", result.reason.english()},
          {"reason_code", result.reason.code},
          {"free_vertices", result.patch.free_count},
          {"steps", result.steps},
          {"bending", result.bending},
          {"energy", energy_json(result)},
          {"seconds", {{"assemble", result.seconds.assemble}, {"solve", result.seconds.solve}}},
          {"folds", result.validity.folds},
          {"self_intersections", result.validity.intersections},
          {"min_angle_deg", result.validity.min_angle_deg}};
}

void print_reason(std::FILE* out, const Message& reason) {
  if (!reason.empty()) std::fprintf(out, "Not the flow itself: %s.\n", reason.english().c_str());
}

}  // namespace loopmend
