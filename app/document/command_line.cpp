// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/command_line.h"

#include "document/labels.h"
#include "document/shell_words.h"
#include "filling/find_rings.h"
#include "pipeline/edge_preview.h"
#include "pipeline/fill_holes.h"

#include <QCoreApplication>

#include <algorithm>

namespace loopmend {
namespace {

/// Whether `--loops` may name the continuity of this recipe behind a number.
bool takes_shapes(const PatchRecipe& recipe) {
  return !recipe.runs.empty() && recipe.runs.back().flow == FlowKind::mmcvf &&
         recipe.runs.back().mode == EvolutionMode::steady;
}

/// The options of `loopmend fill` for a recipe; only the last run where there are several. Without the continuity where --loops may
/// name it.
/// @param loops  of its patch
QString options_of(const PatchRecipe& recipe, const OpenedScan& scan, const std::vector<BoundaryLoop>& loops) {
  QString text;
  if (recipe.density != 1) text += QStringLiteral(" --density ") + shell::exact(recipe.density);
  if (recipe.runs.empty()) return text + QStringLiteral(" --flow none");
  const RunRecipe& run = recipe.runs.back();
  text += QStringLiteral(" --flow ") + shell::word(run.flow);
  if (run.mode == EvolutionMode::steps) text += QStringLiteral(" --mode steps --sigma ") + shell::exact(run.sigma);
  if (run.mode == EvolutionMode::steady)
    text += shell::boundary_options(run.boundary, takes_shapes(recipe) ? SeamContinuity::curvature : run.continuity) +
            shell::relief_options(run.relief) +
            shell::edges_options(run.edges, edits_at(*scan.model, loops, run.edge_edits));
  if (run.mirror == RunRecipe::Mirror::found) text += QStringLiteral(" --mirror");
  if (run.mirror == RunRecipe::Mirror::placed) {
    QStringList numbers;
    for (const Vec3* v : {&run.mirror_plane.point, &run.mirror_plane.normal})
      for (double x : *v) numbers << shell::exact(x);
    text += QStringLiteral(" --mirror-plane ") + numbers.join(QLatin1Char(','));
  }
  if (run.mode == EvolutionMode::steps || run.end == RunRecipe::End::after_steps)
    text += QStringLiteral(" --steps ") + QString::number(run.steps);
  return text;
}

bool is_exact(const PatchRecipe& recipe) {
  return recipe.runs.size() <= 1 && (recipe.runs.empty() || recipe.runs.front().end != RunRecipe::End::unnamed);
}

/// A vertex of the file that lies on this loop alone; −1 when there is none.
int own_vertex(const OpenedScan& scan, const BoundaryLoop& loop) {
  for (int v : loop.vertices) {
    const int vertex = scan.model->soup_vertex[v];
    const auto through = std::count_if(scan.loops.begin(), scan.loops.end(), [&](const BoundaryLoop& other) {
      return std::any_of(other.vertices.begin(), other.vertices.end(),
                         [&](int w) { return scan.model->soup_vertex[w] == vertex; });
    });
    if (through == 1) return vertex;
  }
  return -1;
}

class ScanCommands {
 public:
  ScanCommands(const Document& document, int scan) : document_(document), scan_(*document.scan(scan)), index_(scan) {}

  void add(const OpenPatch& patch, QStringList& remarks) {
    const PatchRecipe& recipe = patch.state->recipe;
    std::vector<BoundaryLoop> own_loops;
    for (int loop : patch.loops) own_loops.push_back(document_.loop(loop));
    QString options = options_of(recipe, scan_, own_loops);
    // The command joins islands and walls where it is not asked for something else.
    if (recipe.start == PatchRecipe::Start::holes && may_be_joined(own_loops))
      options += QStringLiteral(" --islands cover");
    auto& loops =
        by_options_[options][takes_shapes(recipe) ? recipe.runs.back().continuity : SeamContinuity::curvature];
    loops.insert(patch.loops.begin(), patch.loops.end());
    const QString name = labels::sentence(labels::holes(document_, {patch.loops.begin(), patch.loops.end()}));
    if (patch.state->status == PatchStatus::invalid)
      remarks << QCoreApplication::translate("loopmend::ScanCommands",
                                             "%1: the patch cuts the surface; the command would leave it open.")
                     .arg(name);
    if (scan_.from == ScanOrigin::made)
      remarks
          << QCoreApplication::translate(
                 "loopmend::ScanCommands",
                 "%1 was made in the window: export it as surface.ply, without patches, before you use the command.")
                 .arg(scan_.name);
    if (is_exact(recipe)) return;
    remarks << QCoreApplication::translate(
                   "loopmend::ScanCommands",
                   "%1 took several runs, or was stopped halfway through one; the command repeats the last run only.")
                   .arg(name);
  }

  QString text() const {
    const bool sample = scan_.from == ScanOrigin::sample;
    const QString file = shell::file_of(scan_);
    QStringList lines;
    if (sample) lines << QStringLiteral("loopmend sample -o sample.ply");
    // No command overwrites its input: each step has a file of its own.
    QString input = file;
    std::size_t step = 0;
    const std::vector<Step> all = steps();
    for (const Step& now : all) {
      const bool last = ++step == all.size();
      const QString ending = last ? QStringLiteral("-filled.ply") : QStringLiteral("-filled-%1.ply").arg(step);
      const QString output = shell::beside(file, ending);
      // Numbers change when loops are filled; vertices of the input keep theirs.
      const QString which = input == file ? by_number(now.shapes) : by_vertex(now.shapes);
      lines << QStringLiteral("loopmend fill ") + shell::quoted(input) + QStringLiteral(" -o ") +
                   shell::quoted(output) + which + now.options;
      input = output;
    }
    return lines.join(QLatin1Char('\n'));
  }

 private:
  bool may_be_joined(const std::vector<BoundaryLoop>& own) const {
    if (!holes_with_islands(*scan_.model, own).empty()) return true;
    std::vector<BoundaryLoop> all;
    for (int k = 0; k < document_.loop_count(); ++k)
      if (document_.scan_of(k) == index_) all.push_back(document_.loop(k));
    std::set<int> numbers;
    for (const BoundaryLoop& loop : own) numbers.insert(loop.number);
    return std::ranges::any_of(find_missing_faces(*scan_.model, all, {}), [&](const std::vector<int>& face) {
      return std::ranges::any_of(face,
                                 [&](int k) { return numbers.contains(all[static_cast<std::size_t>(k)].number); });
    });
  }

  using Shapes = std::map<int, SeamContinuity>;  ///< by loop
  struct Step {
    QString options;
    Shapes shapes;
  };

  /// One step where --loops can name all shapes, else one for each.
  std::vector<Step> steps() const {
    std::vector<Step> all;
    for (const auto& [options, by_shape] : by_options_) {
      if (by_options_.size() == 1) all.push_back({options, {}});
      for (const auto& [shape, loops] : by_shape) {
        if (by_options_.size() > 1)
          all.push_back({options + shell::boundary_options(BoundaryTrust::automatic, shape), {}});
        for (int loop : loops) all.back().shapes.emplace(loop, shape);
      }
    }
    return all;
  }

  QString by_number(const Shapes& loops) const {
    bool all = true;
    for (int loop = document_.first_loop_of(index_); loop < document_.loop_count(); ++loop) {
      if (document_.scan_of(loop) != index_) break;
      all = all && loops.contains(loop) == (document_.loop(loop).kind == LoopKind::hole);
    }
    const bool names_shapes = by_options_.size() == 1;
    const SeamContinuity first = loops.begin()->second;
    const bool are_alike = std::all_of(loops.begin(), loops.end(), [&](const auto& of) { return of.second == first; });
    if (all && (are_alike || !names_shapes))
      return names_shapes ? shell::boundary_options(BoundaryTrust::automatic, first) : QString();
    QStringList numbers;
    for (const auto& [loop, shape] : loops)
      numbers << QString::number(document_.loop(loop).number) + (names_shapes ? shell::loop_shape(shape) : QString());
    return QStringLiteral(" --loops ") + numbers.join(QLatin1Char(','));
  }

  QString by_vertex(const Shapes& loops) const {
    QStringList vertices;
    for (const auto& [loop, shape] : loops)
      if (const int v = own_vertex(scan_, document_.loop(loop)); v >= 0) vertices << QString::number(v);
    return QStringLiteral(" --at-vertex ") + vertices.join(QLatin1Char(','));
  }

  const Document& document_;
  const OpenedScan& scan_;
  int index_;
  std::map<QString, std::map<SeamContinuity, std::set<int>>> by_options_;
};

}  // namespace

CommandLine command_line(const Document& document, const std::set<int>& patch_ids) {
  CommandLine result;
  std::map<int, ScanCommands> scans;
  for (int id : patch_ids) {
    const OpenPatch* patch = document.patch(id);
    if (!patch) continue;
    scans.try_emplace(patch->scan, document, patch->scan).first->second.add(*patch, result.remarks);
  }
  result.remarks.removeDuplicates();  // one on the scan holds for all of its patches
  QStringList lines;
  for (const auto& [index, commands] : scans) lines << commands.text();
  result.text = lines.join(QLatin1Char('\n'));
  return result;
}

}  // namespace loopmend
