// SPDX-License-Identifier: GPL-3.0-or-later
// What a person sees of a patch: sound or not, and what to look at. How the solver ended is no part of it.
#pragma once

#include "analysis/seam_report.h"
#include "core/message.h"
#include "core/notice.h"
#include "mesh/patch.h"
#include "mesh/validity.h"
#include "pipeline/expected_deviation.h"
#include "pipeline/flat_cut.h"
#include "pipeline/proportion.h"

#include <algorithm>
#include <optional>
#include <vector>

namespace loopmend {

enum class Grade {
  good,
  look,  ///< sound; a person should look at one thing
  bad,   ///< has a hard fault: folds, crosses, tears its seam, or is a bubble
};

/// The word of reports.
const char* to_string(Grade grade);

/// The part of a patch that one loop bounds.
struct Verdict {
  Grade grade = Grade::good;
  std::vector<Notice> findings;  ///< the most serious first; empty where it is good
  /// Bend of the seam that 8 % of its edges, at least two, have or exceed. Nothing where an edge belongs there: at the base of a
  /// bust, at the end of a tube, with position alone.
  std::optional<double> crease_deg = 0;
  double height = 0;      ///< over the loop's best plane, beyond the loop itself, in loop diameters
  int crossings = 0;      ///< places where it intersects the surface or itself
  int folds = 0;          ///< edges bent by more than 150°
  Proportion proportion;  ///< to the initial patch

  bool operator==(const Verdict&) const = default;
  /// "a crease of 50° along 12 edges of the seam"; empty where it is good.
  Message message() const { return findings.empty() ? Message() : message_of(findings.front()); }
};

/// Where a loop lies. Patch frame.
struct LoopPlace {
  Vec3 center = Vec3::Zero(), axis = Vec3::Zero();
  double diameter = 0;
  double own_height = 0;   ///< of the loop over its best plane, in diameters
  double ball_height = 0;  ///< of a ball through the loop that leaves the scan without a crease, in diameters
};

/// Adds a finding; the verdict is at least as grave.
void add_finding(Verdict& verdict, Grade grade, Notice finding);

/// Judges patches of the same loops.
class Judge {
 public:
  enum class Creases { unwanted, asked_for };

  /// @param initial  patch of the loops before any flow; must outlive the judge.
  /// @param ends     of each loop of the patch; empty where the loops bound no holes: heights are not judged then.
  /// @param creases  `asked_for`: position alone was asked for at the seam.
  Judge(const Patch& initial, std::vector<LoopEnd> ends, Creases creases);

  /// The same judge for patches that bend on purpose; how high they rise is meant, too. @param edges of their loops
  /// that they crease, per loop and edge, from place i to i + 1. @param sharpest_deg largest bend within them that is
  /// no fold
  Judge expecting_creases(std::vector<std::vector<char>> edges, double sharpest_deg) const;
  /// The same judge for patches on the surface that was there: however large and high, they are no bubbles.
  Judge expecting_known_surface() const;

  /// @param validity  of the patch against scan and itself, with intersections per loop.
  /// @param seams     of the patch, one for each loop.
  /// @returns one verdict for each loop of the patch.
  std::vector<Verdict> operator()(const Patch& patch, const Validity& validity,
                                  const std::vector<SeamReport>& seams) const;
  /// Of the initial patch, one for each loop.
  const std::vector<SeamReport>& initial_seams() const { return initial_seams_; }

 private:
  void judge_seam(std::size_t loop, const std::vector<double>& bends, double most_at_seam, Verdict& verdict) const;
  void judge_curvature(std::size_t loop, const std::vector<SeamReport>& seams, Verdict& verdict) const;
  void judge_height(std::size_t loop, Verdict& verdict) const;
  /// Edges inside the patch of one loop that bend too much.
  struct BentEdges {
    int count = 0;
    double length = 0, mean = 0;  ///< patch frame; degrees
  };
  void judge_inside(std::size_t loop, const BentEdges& bent, Verdict& verdict) const;
  bool expects_crease(std::size_t loop, std::size_t edge) const {
    return loop < expected_creases_.size() && edge < expected_creases_[loop].size() && expected_creases_[loop][edge];
  }
  bool ends_at(std::size_t loop) const { return loop < ends_.size() && ends_[loop] != LoopEnd::runs_on; }

  const Patch& initial_;
  std::vector<LoopEnd> ends_;
  Creases creases_;
  std::vector<LoopPlace> places_;
  std::vector<std::vector<char>> expected_creases_;  ///< per loop and edge; empty: none
  std::vector<std::vector<double>> initial_bends_;   ///< degrees, per loop and edge
  std::vector<SeamReport> initial_seams_;
  bool is_known_surface_ = false;
  double fold_deg_;  ///< an edge that is bent by more is folded
};

/// Bends of the edges of a seam, degrees.
struct SeamBend {
  double largest = 0, crease = 0;  ///< of one edge; as Verdict::crease_deg
};

/// Of a patch of a few triangles: nothing where a bend is larger than a Judge leaves without a finding, or an edge of the patch is a fold.
std::optional<SeamBend> bend_without_finding(const Patch& patch);

/// Adds to the verdicts of the patch's loops where the surface that was there is likely far.
void judge_deviation(const Patch& patch, const DeviationEstimate& deviation, std::vector<Verdict>& verdicts);

/// Of a patch that joins islands to a hole, its first loop: adds a finding to the hole's verdict where the islands make
/// it rise far beyond a ball through the loop, as debris of the scan does.
void judge_islands(const Patch& patch, std::vector<Verdict>& verdicts);

/// The worst of them; good where there are none.
Grade worst(const std::vector<Verdict>& verdicts);

/// How serious the hard faults of some verdicts are, the worst first: less is better.
struct Faults {
  int crossings = 0, domes = 0, folds = 0;  ///< of all loops; domes over flat loops
  int bad = 0;                              ///< loops with any fault

  auto operator<=>(const Faults&) const = default;
};
Faults faults(const std::vector<Verdict>& verdicts);

}  // namespace loopmend
