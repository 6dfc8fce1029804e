// SPDX-License-Identifier: GPL-3.0-or-later
#include "verdict.h"

#include <string>

namespace loopmend {

nlohmann::ordered_json verdict_json(const Watertightness& surface) {
  nlohmann::ordered_json json = {{"ready_to_print", surface.printable()},
                                 {"against_it", faults(surface)},
                                 {"pieces", surface.pieces},
                                 {"open_boundaries", surface.open_boundaries},
                                 {"open_edges", surface.open_edges},
                                 {"touching_edges", surface.touching_edges},
                                 {"non_manifold_edges", surface.non_manifold_edges},
                                 {"reversed_edges", surface.reversed_edges},
                                 {"intersecting_pairs", surface.intersections}};
  json["volume"] = surface.encloses() ? nlohmann::ordered_json(surface.volume) : nlohmann::ordered_json();
  return json;
}

void print_verdict(std::FILE* out, const Watertightness& surface) {
  if (surface.printable()) {
    std::fprintf(out, "Ready to print: yes, a volume of %.6g cubic mesh units.\n", surface.volume);
    return;
  }
  std::string why;
  for (const std::string& fault : faults(surface)) why += (why.empty() ? "" : ", ") + fault;
  std::fprintf(out, "Ready to print: no, because of %s.\n", why.c_str());
  if (surface.encloses() && surface.pieces > 1 && surface.intersections > 0)
    std::fprintf(out, "Where closed bodies overlap, fill --union makes one of them.\n");
}

}  // namespace loopmend
