// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/choose_loops.h"

#include "core/error.h"

#include <algorithm>
#include <charconv>
#include <sstream>
#include <string_view>
#include <utility>

namespace loopmend {

namespace {

Message count_of_loops(const std::vector<BoundaryLoop>& loops) {
  if (loops.empty()) return say("the surface is closed: it has no boundary loops");
  if (loops.size() == 1) return say("the mesh has one loop, number 1");
  return say("the mesh has %1 loops, numbers 1 to %1", loops.size());
}

/// Between commas; blanks around them are allowed. @throws InvalidArgument where there is nothing.
std::vector<std::string> items_of(const std::string& text, const std::string& option) {
  std::vector<std::string> items;
  std::istringstream list(text);
  for (std::string item; std::getline(list, item, ',');) {
    const auto first = item.find_first_not_of(" \t");
    items.push_back(first == std::string::npos ? "" : item.substr(first, item.find_last_not_of(" \t") - first + 1));
  }
  if (items.empty()) throw InvalidArgument(say("%1 names nothing. It takes whole numbers such as 1,3", option));
  return items;
}

/// @param text  of the whole list
int number_of(std::string_view item, const std::string& text, const std::string& option) {
  int value = 0;
  const auto [end, error] = std::from_chars(item.data(), item.data() + item.size(), value);
  if (item.empty() || error != std::errc() || end != item.data() + item.size())
    throw InvalidArgument(say("%1 takes whole numbers such as 1,3, not '%2'", option, text));
  return value;
}

SeamContinuity continuity_of(const std::string& word) {
  if (word == "flat") return SeamContinuity::position;
  if (word == "tangent") return SeamContinuity::tangent;
  if (word == "smooth") return SeamContinuity::curvature;
  throw InvalidArgument(
      say("--loops takes flat, tangent or smooth behind a number or all, as in 3:flat, not '%1'", word));
}

/// Loops through a vertex of the input. @throws InvalidArgument when there is none.
void add_loops_at(const SurfaceModel& model, const std::vector<BoundaryLoop>& loops, int vertex,
                  std::map<std::size_t, std::optional<SeamContinuity>>& named) {
  if (vertex < 0 || vertex >= static_cast<int>(model.soup.points.size()))
    throw InvalidArgument(
        say("there is no vertex %1: the mesh has %2, numbered from 0", vertex, model.soup.points.size()));
  bool found = false;
  for (std::size_t k = 0; k < loops.size(); ++k)
    for (int v : loops[k].vertices)
      if (model.soup_vertex[v] == vertex) {
        named.try_emplace(k);
        found = true;
      }
  if (found) return;
  bool used = false;
  for_each_soup_triangle(model, [&](int f) {
    const Triangle& t = model.soup.triangles[f];
    used = used || std::find(t.begin(), t.end(), vertex) != t.end();
  });
  throw InvalidArgument(used ? say("vertex %1 lies on no boundary loop", vertex)
                             : say("vertex %1 belongs to no face", vertex));
}

/// Indices into `loops` that are named, each with the continuity that is named for it; empty when none is.
std::map<std::size_t, std::optional<SeamContinuity>> named_loops(const SurfaceModel& model,
                                                                 const std::vector<BoundaryLoop>& loops,
                                                                 const LoopSelection& selection) {
  std::map<std::size_t, std::optional<SeamContinuity>> named;
  for (const auto& [number, continuity] : selection.numbers) {
    if (number < 1 || number > static_cast<int>(loops.size()))
      throw InvalidArgument(say("there is no loop %1: %2. 'loopmend info' lists them", number, count_of_loops(loops)));
    named[number - 1] = continuity;
  }
  for (const int vertex : selection.at_vertices) add_loops_at(model, loops, vertex, named);
  return named;
}

/// Why a loop that is not named cannot be filled; empty where it can.
Message why_no_hole(const BoundaryLoop& loop, LoopSelection::OuterRim outer_rim) {
  if (loop.one_sided)
    return say("no hole: the surface is one-sided there, as a Möbius strip, so that no patch has an outer side: remove "
               "the faces that twist it in another program")
        .with_code("one_sided");
  if (loop.kind == LoopKind::cut) return say("no hole: runs where the surface had to be cut").with_code("cut");
  if (loop.kind == LoopKind::crack && loop.coincident < loop.edges())
    return say("crack: a face at the same place covers it already").with_code("covered");
  if (loop.kind == LoopKind::crack)
    return say("crack: nothing is missing, its sides are only not joined").with_code("crack");
  if (loop.kind == LoopKind::outer_rim && outer_rim == LoopSelection::OuterRim::leave && loop.coincident > 0)
    return say("boundary that coincides with another along %1 edges: the mesh is split there", loop.coincident)
        .with_code("split_mesh");
  return {};
}

/// What may help where why_no_hole() has a reason.
LoopChoice::Cure cure_of(const BoundaryLoop& loop) {
  if (loop.one_sided) return LoopChoice::Cure::none;
  if (loop.kind == LoopKind::cut) return LoopChoice::Cure::repair;
  const bool covered = loop.kind == LoopKind::crack && loop.coincident < loop.edges();
  return covered ? LoopChoice::Cure::none : LoopChoice::Cure::stitch;
}

/// Why a loop is left that could be filled; empty where it is not left.
Message reason_to_leave(const BoundaryLoop& loop, const LoopSelection& selection, bool named) {
  if (!named && loop.kind == LoopKind::outer_rim && selection.outer_rim == LoopSelection::OuterRim::leave)
    return with_cure(say("outline of an open sheet (%1): left open", why_outer_rim(loop)),
                     say("--include-outer-rim fills it"))
        .with_code("outer_rim");
  if (selection.max_edges && loop.edges() > *selection.max_edges)
    return say("has more than %1 edges (--max-edges)", *selection.max_edges).with_code("too_many_edges");
  if (selection.max_diameter && loop.diameter > *selection.max_diameter)
    return say("is wider than --max-diameter").with_code("too_wide");
  return {};
}

/// The first so many of the loops, which begin with the largest, that are holes or outer rims are left.
void leave_largest(const std::vector<BoundaryLoop>& loops, int count, std::vector<LoopChoice>& choices) {
  for (std::size_t k = 0; k < loops.size() && count > 0; ++k) {
    if (loops[k].kind != LoopKind::hole && loops[k].kind != LoopKind::outer_rim) continue;
    --count;
    if (!std::exchange(choices[k].fill, false)) continue;
    choices[k].why_not = say("is one of the largest loops (--all-but-largest)").with_code("one_of_the_largest");
  }
}

}  // namespace

void take_loops(const std::string& text, LoopSelection& selection) {
  selection.numbers.clear();
  selection.continuity.reset();
  if (text == "all") return;
  if (text.starts_with("all:")) {
    selection.continuity = continuity_of(text.substr(4));
    return;
  }
  for (const std::string& item : items_of(text, "--loops")) {
    const std::size_t colon = item.find(':');
    std::optional<SeamContinuity>& shape =
        selection.numbers[number_of(std::string_view(item).substr(0, colon), text, "--loops")];
    if (colon != std::string::npos) shape = continuity_of(item.substr(colon + 1));
  }
}

std::vector<int> vertex_numbers_of(const std::string& text) {
  std::vector<int> vertices;
  for (const std::string& item : items_of(text, "--at-vertex"))
    vertices.push_back(number_of(item, text, "--at-vertex"));
  return vertices;
}

Message with_cure(Message what, Message cure) {
  std::string code = what.code;
  return say("%1 (%2)", std::move(what), std::move(cure)).with_code(code);
}

Message not_selected() { return say("not selected").with_code("not_selected"); }

LoopChoice choose_unnamed(const BoundaryLoop& loop, const LoopSelection& selection) {
  LoopChoice choice;
  choice.why_not = why_no_hole(loop, selection.outer_rim);
  if (!choice.why_not.empty()) {
    choice.left = LoopChoice::Left::no_hole;
    choice.cure = cure_of(loop);
  }
  if (choice.why_not.empty()) choice.why_not = reason_to_leave(loop, selection, false);
  choice.fill = choice.why_not.empty();
  choice.is_outer_rim = loop.kind == LoopKind::outer_rim;
  return choice;
}

std::vector<LoopChoice> choose_loops(const SurfaceModel& model, const std::vector<BoundaryLoop>& loops,
                                     const LoopSelection& selection) {
  const std::map<std::size_t, std::optional<SeamContinuity>> named = named_loops(model, loops, selection);
  std::vector<LoopChoice> choices(loops.size());
  for (std::size_t k = 0; k < loops.size(); ++k) {
    LoopChoice& choice = choices[k];
    if (named.empty()) {
      choice = choose_unnamed(loops[k], selection);
      choice.continuity = selection.continuity;
      continue;
    }
    const auto own = named.find(k);
    choice.why_not = own != named.end() ? reason_to_leave(loops[k], selection, true) : not_selected();
    if (own != named.end()) choice.continuity = own->second;
    choice.fill = choice.why_not.empty();
    choice.is_outer_rim = loops[k].kind == LoopKind::outer_rim;
  }
  leave_largest(loops, selection.all_but_largest, choices);
  return choices;
}

}  // namespace loopmend
