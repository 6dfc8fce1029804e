// SPDX-License-Identifier: GPL-3.0-or-later
// Several flows from one start, side by side, each on its own thread. The window hears of the newest state of each.
#pragma once

#include "jobs/task_runner.h"
#include "pipeline/compare.h"
#include "scene/surface_shape.h"

#include <QObject>
#include <QString>

#include <filesystem>
#include <memory>
#include <optional>
#include <vector>

namespace loopmend {

/// Where a race begins.
struct ComparisonSource {
  QString title;                                   ///< "Holes 1 and 3 of bunny.ply"
  std::function<Patch(const CancelToken&)> start;  ///< called on a worker; may throw Error in words
  SurfaceShapePtr neighborhood;                    ///< without what the patch replaces; null where there are none
  Vec3 origin = Vec3::Zero();                      ///< of `neighborhood`
};

/// The present state of one flow. Immutable.
struct ComparedRun : PatchResult {
  enum class Stage { start, moving, ended, stopped } stage = Stage::start;
  EvolutionOptions options;  ///< that led here
  PatchEnergies energies;
  double wide_jump = 0;  ///< NaN until the flow has ended
  std::vector<ProfilePoint> profile;
  std::vector<double> distances;  ///< of the free vertices from another surface, signed; empty: not measured
  SurfaceShapePtr shape;
};
using ComparedRunPtr = std::shared_ptr<const ComparedRun>;

/// What the distances of all runs are measured from.
struct DistanceFrom {
  enum class Kind { flow, start, mesh } kind = Kind::flow;
  FlowKind flow = FlowKind::mmcvf;
  std::filesystem::path mesh{};
  bool operator==(const DistanceFrom&) const = default;
};

/// A point of a run's curves.
struct ComparisonPoint {
  int step = 0;
  PatchEnergies energies;
};

class ComparisonController : public QObject {
  Q_OBJECT

 public:
  explicit ComparisonController(ComparisonSource source, QObject* parent = nullptr);

  enum class Stage { preparing, ready, running, failed };
  Stage stage() const { return stage_; }
  const QString& title() const { return source_.title; }

  int flow_runs() const { return static_cast<int>(flows_.size()); }
  FlowKind flow(int flow_run) const { return flows_[flow_run]; }
  /// Two to four flows, none twice. What was reached is forgotten. Nothing happens while they run.
  void set_flows(const std::vector<FlowKind>& flows);

  /// All runs from the start. @param base  its flow does not count.
  void run(const EvolutionOptions& base);
  /// At once; each run keeps the newest state that was seen.
  void stop();

  /// Null before the start is there.
  const ComparedRunPtr& start() const { return start_; }
  /// Of the neighborhood, those near the patch; may be null.
  const SurfaceShapePtr& neighborhood() const { return neighborhood_; }
  /// The start until the run moves.
  const ComparedRunPtr& flow_run(int flow_run) const { return newest_[flow_run]; }
  const std::vector<ComparisonPoint>& curve(int flow_run) const { return curves_[flow_run]; }
  /// What `loopmend compare` would tell; once every run has ended.
  const std::optional<FlowComparison>& comparison() const { return comparison_; }
  /// Distances are measured whenever no flow runs. Empty: not at all.
  void measure_from(const std::optional<DistanceFrom>& from);
  bool is_measuring() const { return measuring_ != nullptr; }
  bool shut_down(std::chrono::milliseconds at_most);

 Q_SIGNALS:
  void stage_changed();
  void flow_run_moved(int flow_run);
  void measured();  ///< every run, and the start, may have other distances
  void failed(const QString& words);

 private:
  struct Post;
  class FlowRun;
  void prepare();
  void forget_results();
  void take_news(const std::shared_ptr<Post>& post);
  void end(const std::shared_ptr<Post>& post);
  void measure();
  void drop_distances();

  ComparisonSource source_;
  Stage stage_ = Stage::preparing;
  std::vector<FlowKind> flows_{FlowKind::mcf, FlowKind::sdf, FlowKind::wf, FlowKind::mmcvf};
  SurfaceShapePtr neighborhood_;
  ComparedRunPtr start_;
  std::vector<ComparedRunPtr> newest_;
  std::vector<std::vector<ComparisonPoint>> curves_;
  std::optional<FlowComparison> comparison_;
  std::optional<DistanceFrom> from_;
  JobPtr job_, measuring_;
  TaskRunner tasks_{Yielding::as_it_can};
};

}  // namespace loopmend
