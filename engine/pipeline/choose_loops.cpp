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

std::string count_of_loops(const std::vector<BoundaryLoop>& loops) {
  if (loops.empty()) return "the surface is closed: it has no boundary loops";
  if (loops.size() == 1) return "the mesh has one loop, number 1";
  return "the mesh has " + std::to_string(loops.size()) + " loops, numbers 1 to " + std::to_string(loops.size());
}

/// Between commas; blanks around them are allowed. @throws InvalidArgument where there is nothing.
std::vector<std::string> items_of(const std::string& text, const std::string& option) {
  std::vector<std::string> items;
  std::istringstream list(text);
  for (std::string item; std::getline(list, item, ',');) {
    const auto first = item.find_first_not_of(" \t");
    items.push_back(first == std::string::npos ? "" : item.substr(first, item.find_last_not_of(" \t") - first + 1));
  }
  if (items.empty()) throw InvalidArgument(option + " names nothing. It takes whole numbers such as 1,3");
  return items;
}

/// @param text  of the whole list
int number_of(std::string_view item, const std::string& text, const std::string& option) {
  int value = 0;
  const auto [end, error] = std::from_chars(item.data(), item.data() + item.size(), value);
  if (item.empty() || error != std::errc() || end != item.data() + item.size())
    throw InvalidArgument(option + " takes whole numbers such as 1,3, not '" + text + "'");
  return value;
}

SeamContinuity continuity_of(const std::string& word) {
  if (word == "flat") return SeamContinuity::position;
  if (word == "tangent") return SeamContinuity::tangent;
  if (word == "smooth") return SeamContinuity::curvature;
  throw InvalidArgument("--loops takes flat, tangent or smooth behind a number, as in 3:flat, not '" + word + "'");
}

/// Loops through a vertex of the input. @throws InvalidArgument when there is none.
void add_loops_at(const SurfaceModel& model, const std::vector<BoundaryLoop>& loops, int vertex,
                  std::map<std::size_t, std::optional<SeamContinuity>>& named) {
  const std::string name = "vertex " + std::to_string(vertex);
  if (vertex < 0 || vertex >= static_cast<int>(model.soup.points.size()))
    throw InvalidArgument("there is no " + name + ": the mesh has " + std::to_string(model.soup.points.size()) +
                          ", numbered from 0");
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
    const Triangle& t = model.soup.triangles[static_cast<std::size_t>(f)];
    used = used || std::find(t.begin(), t.end(), vertex) != t.end();
  });
  throw InvalidArgument(name + (used ? " lies on no boundary loop" : " belongs to no face"));
}

/// Indices into `loops` that are named, each with the continuity that is named for it; empty when none is.
std::map<std::size_t, std::optional<SeamContinuity>> named_loops(const SurfaceModel& model,
                                                                 const std::vector<BoundaryLoop>& loops,
                                                                 const LoopSelection& selection) {
  std::map<std::size_t, std::optional<SeamContinuity>> named;
  for (const auto& [number, continuity] : selection.numbers) {
    if (number < 1 || number > static_cast<int>(loops.size()))
      throw InvalidArgument("there is no loop " + std::to_string(number) + ": " + count_of_loops(loops) +
                            ". 'loopmend info' lists them");
    named[static_cast<std::size_t>(number - 1)] = continuity;
  }
  for (const int vertex : selection.at_vertices) add_loops_at(model, loops, vertex, named);
  return named;
}

/// Why a loop that is not named cannot be filled; empty where it can.
std::string why_no_hole(const BoundaryLoop& loop, LoopSelection::OuterRim outer_rim) {
  if (loop.kind == LoopKind::cut) return "no hole: runs where the surface had to be cut";
  if (loop.kind == LoopKind::crack && loop.coincident < loop.edges())
    return "crack: a face at the same place covers it already";
  if (loop.kind == LoopKind::crack) return "crack: nothing is missing, its sides are only not joined";
  if (loop.kind == LoopKind::outer_rim && outer_rim == LoopSelection::OuterRim::leave && loop.coincident > 0)
    return "boundary that coincides with another along " + std::to_string(loop.coincident) +
           " edges: the mesh is split there";
  return "";
}

/// What may help where why_no_hole() has a reason.
LoopChoice::Cure cure_of(const BoundaryLoop& loop) {
  if (loop.kind == LoopKind::cut) return LoopChoice::Cure::repair;
  const bool covered = loop.kind == LoopKind::crack && loop.coincident < loop.edges();
  return covered ? LoopChoice::Cure::none : LoopChoice::Cure::stitch;
}

/// Why a loop is left that could be filled; empty where it is not left.
std::string reason_to_leave(const BoundaryLoop& loop, const LoopSelection& selection, bool named) {
  if (!named && loop.kind == LoopKind::outer_rim && selection.outer_rim == LoopSelection::OuterRim::leave)
    return "outer rim of an open sheet, since " + why_outer_rim(loop) + ": left open (--include-outer-rim fills it)";
  if (selection.max_edges && loop.edges() > *selection.max_edges)
    return "has more than " + std::to_string(*selection.max_edges) + " edges (--max-edges)";
  if (selection.max_diameter && loop.diameter > *selection.max_diameter) return "is wider than --max-diameter";
  return "";
}

/// The first so many of the loops, which begin with the largest, that are holes or outer rims are left.
void leave_largest(const std::vector<BoundaryLoop>& loops, int count, std::vector<LoopChoice>& choices) {
  for (std::size_t k = 0; k < loops.size() && count > 0; ++k) {
    if (loops[k].kind != LoopKind::hole && loops[k].kind != LoopKind::outer_rim) continue;
    --count;
    if (!std::exchange(choices[k].fill, false)) continue;
    choices[k].why_not = "is one of the largest loops (--all-but-largest)";
  }
}

}  // namespace

std::map<int, std::optional<SeamContinuity>> loop_numbers_of(const std::string& text) {
  std::map<int, std::optional<SeamContinuity>> numbers;
  if (text == "all") return numbers;
  for (const std::string& item : items_of(text, "--loops")) {
    const std::size_t colon = item.find(':');
    std::optional<SeamContinuity>& shape = numbers[number_of(std::string_view(item).substr(0, colon), text, "--loops")];
    if (colon != std::string::npos) shape = continuity_of(item.substr(colon + 1));
  }
  return numbers;
}

std::vector<int> vertex_numbers_of(const std::string& text) {
  std::vector<int> vertices;
  for (const std::string& item : items_of(text, "--at-vertex"))
    vertices.push_back(number_of(item, text, "--at-vertex"));
  return vertices;
}

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
      continue;
    }
    const auto own = named.find(k);
    choice.why_not = own != named.end() ? reason_to_leave(loops[k], selection, true) : "not selected";
    if (own != named.end()) choice.continuity = own->second;
    choice.fill = choice.why_not.empty();
    choice.is_outer_rim = loops[k].kind == LoopKind::outer_rim;
  }
  leave_largest(loops, selection.all_but_largest, choices);
  return choices;
}

}  // namespace loopmend
