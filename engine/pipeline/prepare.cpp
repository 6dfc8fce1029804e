// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/prepare.h"

#include "core/error.h"
#include "mesh/boundary_loops.h"
#include "mesh/rounding_cracks.h"
#include "pipeline/hand_bridge.h"
#include "pipeline/rim_groups.h"
#include "repair/base.h"
#include "repair/inverted_shells.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>
#include <string_view>
#include <utility>

namespace loopmend {

namespace {

/// @param a, b  vertices of the mesh as it was read.
TriangleSoup bridged(const SurfaceModel& model, int a, int b) {
  const int count = static_cast<int>(model.soup.points.size());
  if (a < 0 || b < 0 || a >= count || b >= count)
    throw InvalidArgument(say("bridge (%1, %2): the mesh has %3 vertices, numbered from 0", a, b, count));
  try {
    return with_bridge(model, a, b);
  } catch (const InvalidArgument& error) {
    throw InvalidArgument(say("bridge (%1, %2): %3", a, b, error.message()));
  }
}

/// What --auto repairs.
std::set<Defect> repairs_needed(const SurfaceModel& model) {
  const std::vector<BoundaryLoop> loops = find_boundary_loops(model);
  if (std::ranges::any_of(loops,
                          [](const BoundaryLoop& loop) { return loop.kind == LoopKind::cut && !loop.one_sided; }))
    return harmless_repairs;
  std::set<Defect> needed;
  if (model.repairs.duplicate_faces > 0 || find_inverted_shells(model, loops).closed > 0)
    needed = {Defect::duplicate_faces, Defect::non_manifold};
  if (has_open_fragments(model)) needed.insert(Defect::fragments);
  return needed;
}

/// Walls of thin pipes and plates are no sides of a crack, however near they are to each other.
bool has_sides_to_join(const SurfaceModel& model, const CancelToken& cancel) {
  const std::vector<BoundaryLoop> loops = find_boundary_loops(model);
  if (std::any_of(loops.begin(), loops.end(), [](const BoundaryLoop& loop) { return loop.coincident > 0; }))
    return true;
  const NearBoundaries near = near_boundaries(model);
  if (near.closing.empty()) return false;
  const std::vector<char> at_walls = are_at_walls(model, loops, find_walls(model, loops, cancel));
  for (std::size_t k = 0; k < loops.size(); ++k)
    if (!at_walls[k] && closing_edges(model, loops[k], near) > 0) return true;
  return false;
}

struct OpenEdges {
  int all = 0, cut = 0;
};

OpenEdges open_edges(const std::vector<BoundaryLoop>& loops) {
  OpenEdges open;
  for (const BoundaryLoop& loop : loops) {
    open.all += loop.edges();
    if (loop.kind == LoopKind::cut) open.cut += loop.edges();
  }
  return open;
}

struct JoinedAgain {
  TriangleSoup soup;
  std::size_t vertices = 0;
};

/// Stitches what repair has parted. Where that makes edges of more than two faces, only vertices that lie on each other at cracks are
/// joined. Empty unless the surface then has fewer open edges, and no more of them at edges of more than two faces.
std::optional<JoinedAgain> joined_again(const SurfaceModel& model, const StitchTolerance& tolerance) {
  const OpenEdges before = open_edges(find_boundary_loops(model));
  const auto gains = [&](const JoinedAgain& joined) {
    if (joined.vertices == 0) return false;
    const OpenEdges after = open_edges(find_boundary_loops(make_surface_model(joined.soup)));
    return after.all < before.all && after.cut <= before.cut;
  };
  StitchedSurface stitched = stitch_boundaries(model, tolerance);
  JoinedAgain joined{std::move(stitched.soup), stitched.joined_vertices};
  if (gains(joined)) return joined;
  joined.soup = model.soup;
  const VertexSurvey survey = survey_vertices(joined.soup.triangles, joined.soup.points.size());
  joined.vertices = join_rounding_cracks(joined.soup, survey).vertices;
  if (gains(joined)) return joined;
  return std::nullopt;
}

/// @returns how many.
std::size_t remove_faces_at(const std::vector<int>& vertices, TriangleSoup& soup) {
  std::vector<char> is_marked(soup.points.size(), 0), kept;
  for (int v : vertices) is_marked[v] = 1;
  for (const Triangle& t : soup.triangles)
    kept.push_back(std::none_of(t.begin(), t.end(), [&](int v) { return is_marked[v] != 0; }));
  soup = with_faces(soup, kept);
  return static_cast<std::size_t>(std::ranges::count(kept, 0));
}

/// @throws InvalidArgument where there is no such loop.
TriangleSoup based(const SurfaceModel& model, const PrepareOptions::Base& base, int& number) {
  const std::vector<BoundaryLoop> loops = find_boundary_loops(model);
  const std::size_t place = base.loop == 0 ? 0 : static_cast<std::size_t>(base.loop) - 1;
  if (place >= loops.size())
    throw InvalidArgument(say("--base: there is no loop %1; 'loopmend info' lists the loops", place + 1));
  number = loops[place].number;
  return with_base(model, loops[place], base.distance);
}

/// All of the text as a finite number.
std::optional<double> number_in(std::string_view text) {
  double value = 0;
  if (text.starts_with('+')) text.remove_prefix(1);
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (text.empty() || error != std::errc() || end != text.data() + text.size() || !std::isfinite(value))
    return std::nullopt;
  return value;
}

}  // namespace

StitchTolerance stitch_tolerance_of(const std::string& text) {
  constexpr double most_percent = 40;
  std::string_view word = text;
  const bool is_percent = word.ends_with('%');
  if (is_percent) word.remove_suffix(1);
  const std::optional<double> number = number_in(word);
  if (!number || *number < 0 || (is_percent && *number > most_percent))
    throw InvalidArgument(
        say("--stitch takes a length such as 0.5, or up to 40 % of the edges there such as 5%, not '%1'", text));
  if (is_percent) return {*number / 100, std::nullopt};
  return {StitchTolerance().edges, *number};
}

PrepareOptions::Base base_of(const std::string& text) {
  const std::size_t colon = text.find(':');
  const bool names_loop = colon != std::string::npos;
  const std::optional<double> loop = names_loop ? number_in(std::string_view(text).substr(0, colon)) : 0;
  const std::optional<double> distance = number_in(std::string_view(text).substr(names_loop ? colon + 1 : 0));
  const bool is_number = loop && *loop == std::floor(*loop) && *loop >= (names_loop ? 1 : 0) && *loop < 1e9;
  if (!is_number || !distance || !(*distance > 0))
    throw InvalidArgument(
        say("--base takes a length above 0 such as 5, or a loop and a length such as 2:5, not '%1'", text));
  return {static_cast<int>(*loop), *distance};
}

CutPlane cut_plane_of(const std::string& text) {
  std::vector<double> numbers;
  for (std::size_t from = 0; from <= text.size();) {
    const std::size_t to = std::min(text.find(',', from), text.size());
    numbers.push_back(number_in(std::string_view(text).substr(from, to - from)).value_or(std::nan("")));
    from = to + 1;
  }
  if (numbers.size() != 6 || std::ranges::any_of(numbers, [](double x) { return std::isnan(x); }))
    throw InvalidArgument(
        say("--cut-plane takes a point and a normal, six numbers such as 0,0,5,0,0,1, not '%1'", text));
  return make_cut_plane({numbers[0], numbers[1], numbers[2]}, {numbers[3], numbers[4], numbers[5]});
}

bool Preparation::changed_nothing() const {
  return !stitched && !repaired && !cut && sides_turned == 0 && bridges == 0 && tiles.removed_faces == 0 &&
         base_loop == 0 && no_data_faces.value_or(0) == 0;
}

Preparation prepare(SurfaceModel& model, PrepareOptions& options, const MakeModel& make_model,
                    const CancelToken& cancel, const OnRepairStep& on_step) {
  const auto begin = [&](RepairStage stage) {
    if (on_step) on_step({stage});
  };
  const bool where_needed = options.extent == PrepareOptions::Extent::where_needed;
  const auto stitches = [&] { return options.stitch == PrepareOptions::Stitch::yes; };
  Preparation done;
  done.before = model.repairs;
  const auto replace = [&](TriangleSoup soup) {
    done.turned_faces += model.repairs.reoriented_faces;
    model = make_model(std::move(soup));
  };
  if (options.sides == PrepareOptions::Sides::turned) {
    TriangleSoup soup = as_read(model);
    for (Triangle& t : soup.triangles) std::swap(t[1], t[2]);
    done.sides_turned = soup.triangles.size();
    replace(std::move(soup));
  }
  begin(RepairStage::survey);
  done.no_data = find_no_data(model.soup.points);
  if (options.no_data == PrepareOptions::NoData::cut) done.no_data_faces = 0;
  if ((done.no_data_faces || where_needed) && !done.no_data.vertices.empty()) {
    begin(RepairStage::remove_no_data);
    TriangleSoup soup = as_read(model);
    done.no_data_faces = remove_faces_at(done.no_data.vertices, soup);
    replace(std::move(soup));
  }
  if (where_needed && has_sides_to_join(model, cancel)) options.stitch = PrepareOptions::Stitch::yes;
  if (stitches()) begin(RepairStage::stitch);
  if (stitches() && options.stitch_tolerance.length.value_or(0) > 0 &&
      !zips_whole_boundaries(model, options.stitch_tolerance)) {
    done.tiles = join_tiles(model, *options.stitch_tolerance.length, replace);
    if (done.tiles.removed_faces > 0) options.stitch_tolerance = {};  // the length was that of the tiles
  }
  if (stitches()) {
    done.stitched = stitch_boundaries(model, options.stitch_tolerance);
    replace(std::move(done.stitched->soup));
    if ((where_needed || done.tiles.removed_faces > 0) && !done.stitched->any()) done.stitched.reset();
  }
  if (where_needed) {
    begin(RepairStage::survey);
    options.repair.merge(repairs_needed(model));
  }
  if (!options.repair.empty()) {
    RepairedSurface repaired = repair_surface(as_read(model), options.repair, cancel, on_step);
    done.repaired = repaired.counts;
    replace(std::move(repaired.soup));
    if (stitches() || (where_needed && has_sides_to_join(model, cancel))) {
      begin(RepairStage::stitch);
      if (std::optional<JoinedAgain> joined = joined_again(model, options.stitch_tolerance)) {
        done.joined_again = joined->vertices;
        replace(std::move(joined->soup));
      }
    }
  }
  for (const auto& [a, b] : options.bridges) {
    replace(bridged(model, a, b));
    ++done.bridges;
  }
  if (options.cut_plane) {
    CutSurface cut = cut_by_plane(model.soup, *options.cut_plane);
    done.cut = cut.counts;
    replace(std::move(cut.soup));
  }
  if (options.base) replace(based(model, *options.base, done.base_loop));
  if (!where_needed) return done;
  options.stitch = PrepareOptions::Stitch::yes;  // what it can join is joined
  options.repair.insert(harmless_repairs.begin(), harmless_repairs.end());
  options.trim_pierced = PrepareOptions::TrimPierced::yes;
  return done;
}

}  // namespace loopmend
