// The one place where a wish of the person becomes a job, and a job's outcome becomes a change of the document.
#pragma once

#include "document/document.h"
#include "jobs/evolve_patches.h"
#include "jobs/fill_holes.h"
#include "jobs/snapshot_mailbox.h"
#include "jobs/task_runner.h"

#include <QElapsedTimer>
#include <QObject>
#include <QUndoStack>

#include <set>

namespace loopmend {

enum class Activity { idle, opening, filling, stepping, running, solving, pausing, exporting };

class Workbench : public QObject {
  Q_OBJECT

 public:
  Workbench(Document& document, QUndoStack& undo, QObject* parent = nullptr);
  ~Workbench() override;

  Activity activity() const { return activity_; }
  bool busy() const { return activity_ != Activity::idle; }

  void open(const QString& path);
  void open_sample();
  /// Loops that have a patch already are passed over.
  void fill(const std::set<int>& loops, double density);
  void evolve(const std::set<int>& patch_ids, FlowKind flow, double sigma, Pace pace);
  void pause();
  /// Comes back at once; what was accepted so far stays and can be undone.
  void cancel();
  /// The format follows the extension.
  void export_to(const QString& path);
  /// For the end of the program. @returns whether every worker has ended.
  bool shut_down(std::chrono::milliseconds at_most);

 Q_SIGNALS:
  void activity_changed();
  void stage_changed(const QString& words);
  void progress_changed(int done, int total);  ///< total 0: not known
  void preview_ready(std::shared_ptr<const SurfaceShape> shape);
  void preview_dropped();
  void failed(const QString& words);
  void notice(const QString& words);
  void said(const QString& words);

 private:
  JobPtr begin(Activity activity, const QString& stage);
  void end();
  void load(const QString& path, const QString& stage);
  void on_opened(OpenedScan scan, qint64 milliseconds);
  void on_open_failed(const QString& words);
  void on_filled(FillResult result, const std::set<int>& wanted, qint64 milliseconds);
  void on_evolved(const EvolveResult& result);
  void take_snapshots();
  void record_run();

  Document& document_;
  QUndoStack& undo_;
  TaskRunner tasks_;
  Activity activity_ = Activity::idle;
  JobPtr job_;
  QElapsedTimer clock_;
  std::shared_ptr<SnapshotMailbox> mailbox_;
  std::map<int, EvolutionSession> sessions_;
  std::map<int, PatchStatePtr> run_start_;
  QString run_name_;
};

}  // namespace loopmend
