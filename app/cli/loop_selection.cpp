#include "loop_selection.h"

#include <charconv>
#include <set>
#include <sstream>

namespace loopmend {

namespace {

std::string count_of_loops(const std::vector<BoundaryLoop>& loops) {
  if (loops.empty()) return "the surface is closed: it has no boundary loops";
  if (loops.size() == 1) return "the mesh has one loop, number 1";
  return "the mesh has " + std::to_string(loops.size()) + " loops, numbers 1 to " + std::to_string(loops.size());
}

int parse_number(const std::string& text) {
  int value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size())
    throw UsageError("--loops takes 'all' or numbers such as 1,3, not '" + text + "'");
  return value;
}

/// Indices into `loops` that are named on the command line; empty when none is.
std::set<std::size_t> named_loops(const SurfaceModel& model, const std::vector<BoundaryLoop>& loops,
                                  const FillCommand& command) {
  std::set<std::size_t> named;
  if (command.loops != "all") {
    std::istringstream list(command.loops);
    for (std::string item; std::getline(list, item, ',');) {
      const int number = parse_number(item);
      if (number < 1 || number > static_cast<int>(loops.size()))
        throw UsageError("there is no loop " + std::to_string(number) + ": " + count_of_loops(loops) +
                         ". 'loopmend info' lists them");
      named.insert(static_cast<std::size_t>(number - 1));
    }
    if (named.empty()) throw UsageError("--loops names no loop. It takes 'all' or numbers such as 1,3");
  }
  for (int vertex : command.at_vertices) {
    if (vertex < 0 || vertex >= static_cast<int>(model.soup.points.size()))
      throw UsageError("there is no vertex " + std::to_string(vertex) + ": the mesh has " +
                       std::to_string(model.soup.points.size()) + ", numbered from 0");
    const std::size_t before = named.size();
    bool found = false;
    for (std::size_t k = 0; k < loops.size(); ++k)
      for (int v : loops[k].vertices)
        if (model.soup_vertex[v] == vertex) {
          named.insert(k);
          found = true;
        }
    if (!found && named.size() == before)
      throw UsageError("vertex " + std::to_string(vertex) + " lies on no boundary loop");
  }
  return named;
}

std::string reason_to_leave(const BoundaryLoop& loop, const FillCommand& command, bool named, bool any_named) {
  if (any_named && !named) return "not selected";
  if (!named && loop.kind == LoopKind::outer_rim && command.outer_rim == FillCommand::OuterRim::leave)
    return "outer rim of an open sheet: left open (--include-outer-rim fills it)";
  if (!named && loop.kind == LoopKind::cut) return "no hole: runs along an edge with more than two faces";
  if (!named && loop.kind == LoopKind::crack) return "crack: nothing is missing, its sides are only not joined";
  if (command.max_edges && loop.edges() > *command.max_edges)
    return "has more than " + std::to_string(*command.max_edges) + " edges (--max-edges)";
  if (command.max_diameter && loop.diameter > *command.max_diameter) return "is wider than --max-diameter";
  return "";
}

}  // namespace

std::vector<LoopChoice> choose_loops(const SurfaceModel& model, const std::vector<BoundaryLoop>& loops,
                                     const FillCommand& command) {
  const std::set<std::size_t> named = named_loops(model, loops, command);
  std::vector<LoopChoice> choices(loops.size());
  for (std::size_t k = 0; k < loops.size(); ++k) {
    choices[k].why_not = reason_to_leave(loops[k], command, named.count(k) > 0, !named.empty());
    choices[k].fill = choices[k].why_not.empty();
  }
  return choices;
}

}  // namespace loopmend
