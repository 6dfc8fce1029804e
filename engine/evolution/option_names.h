// SPDX-License-Identifier: GPL-3.0-or-later
// The names of what a person chooses: on the command line, in Python, in reports and sessions.
#pragma once

#include "evolution/evolution.h"

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace loopmend {

template <class T>
struct Named {
  const char* name;
  T value;
};

inline constexpr std::array<Named<FlowKind>, 4> flow_names{
    {{"mmcvf", FlowKind::mmcvf}, {"wf", FlowKind::wf}, {"sdf", FlowKind::sdf}, {"mcf", FlowKind::mcf}}};
inline constexpr std::array<Named<EvolutionMode>, 2> mode_names{
    {{"steady", EvolutionMode::steady}, {"steps", EvolutionMode::steps}}};
inline constexpr std::array<Named<SolverKind>, 3> solver_names{
    {{"auto", SolverKind::automatic}, {"direct", SolverKind::direct}, {"gmres", SolverKind::gmres}}};
inline constexpr std::array<Named<BoundaryTrust>, 3> boundary_names{
    {{"auto", BoundaryTrust::automatic}, {"exact", BoundaryTrust::exact}, {"robust", BoundaryTrust::robust}}};
inline constexpr std::array<Named<SeamContinuity>, 3> continuity_names{{{"position", SeamContinuity::position},
                                                                        {"tangent", SeamContinuity::tangent},
                                                                        {"curvature", SeamContinuity::curvature}}};
inline constexpr std::array<Named<ReliefChoice::Kind>, 2> relief_names{
    {{"smooth", ReliefChoice::Kind::smooth}, {"continued", ReliefChoice::Kind::continued}}};
inline constexpr std::array<Named<SharpEdges>, 2> edges_names{
    {{"auto", SharpEdges::continued}, {"round", SharpEdges::rounded}}};

/// Nothing for a name that is not in the table.
template <class T, std::size_t n>
std::optional<T> value_named(const std::array<Named<T>, n>& table, std::string_view name) {
  for (const Named<T>& entry : table)
    if (name == entry.name) return entry.value;
  return std::nullopt;
}

/// "" for a value that is not in the table.
template <class T, std::size_t n>
const char* name_of(const std::array<Named<T>, n>& table, T value) {
  for (const Named<T>& entry : table)
    if (value == entry.value) return entry.name;
  return "";
}

template <class T, std::size_t n>
std::vector<std::string> names_in(const std::array<Named<T>, n>& table) {
  std::vector<std::string> names;
  for (const Named<T>& entry : table) names.emplace_back(entry.name);
  return names;
}

}  // namespace loopmend
