// SPDX-License-Identifier: GPL-3.0-or-later
// Runs user requests as jobs, and applies their results to the document.
#pragma once

#include "document/document.h"
#include "document/session.h"
#include "document/undo_history.h"
#include "jobs/document_run.h"
#include "jobs/export_scene.h"
#include "jobs/fill_run.h"
#include "jobs/load_scan.h"
#include "jobs/step_patches.h"
#include "jobs/task_runner.h"
#include "repair/plane_cut.h"
#include "repair/repair_surface.h"

#include <QElapsedTimer>
#include <QObject>
#include <QStringList>

#include <deque>
#include <functional>
#include <map>
#include <optional>
#include <set>

namespace loopmend {

enum class Activity { idle, opening, filling, stepping, running, solving, pausing, writing };

/// How a run of a flow ended: `stopped` by a person, or by a fault at one patch or more.
enum class RunEnd { complete, stopped };

enum class OpenMode {
  replace,  ///< another scene
  add,      ///< into the scene; can be undone
};

/// What is done to a scan before it is filled, as by the options of `loopmend fill`.
enum class ScanRepair {
  trim,           ///< --trim-boundary 3: bad triangles at the boundaries of these holes are removed
  trim_crossing,  ///< --trim-crossing: there, only those that run through the surface
  stitch,         ///< --stitch: boundaries that nearly coincide are zipped, all over the scan
  prepare,        ///< --auto: the scan is stitched, repaired and trimmed where it needs that
  repair,         ///< --repair: the scan becomes an oriented manifold
  bridge,         ///< --bridge A,B: a strip parts a hole into two, or joins two
  erase,          ///< faces that were painted go
  base,           ///< --base N:D: a straight wall leads from a loop to a plane below the surface
  plane_cut,  ///< --cut-plane: one side of a plane goes, with what it has of patches; all patches are joined to the scan
  part,       ///< what hangs at a boundary by a vertex alone becomes an island
  turn_around,  ///< what looks inward looks outward; where nothing does, as --turn-around, every face looks the other way
};

struct DefectPlaces;
struct RepairedScan;
struct ScanRepairTask;

/// What a repair would cost beside what it does: asked before it is done.
struct RepairQuestion {
  QString done;                             ///< of the scans, in words
  int patches = 0;                          ///< that would be lost
  std::size_t loops_before = 0, loops = 0;  ///< boundary loops of the scans
  std::function<void()> apply;
  QString proposal{};                            ///< what would be done, in words
  std::shared_ptr<const DefectPlaces> places{};  ///< what would change, with a proposal
};

/// How holes are filled.
struct FillChoice {
  double density = 1;  ///< InitialPatchOptions::density
  FillOptions::Islands islands = FillOptions::Islands::join;
  bool operator==(const FillChoice&) const = default;
};

/// How a hole that has just been made is filled and smoothed.
struct FillAndSmooth {
  FillChoice choice;
  EvolutionOptions options;
};

/// A part of a hole: between two vertices of its boundary (soup points), on the side of a third.
struct HolePart {
  int scan = 0;
  int from = 0, to = 0;
  int beside = 0;
};

/// A session to be opened.
struct SessionFile {
  QString path;
  QString shown_as;  ///< what the scene is called where it is a copy that survived a crash; empty: `path` itself
  std::map<QString, QString> moved;  ///< scans that are not where the session names them, and where they are now
};

class FillController : public QObject {
  Q_OBJECT

 public:
  FillController(Document& document, UndoHistory& undo, QObject* parent = nullptr);

  Activity activity() const { return activity_; }
  bool busy() const { return activity_ != Activity::idle; }
  /// Whether the curvature of a large scan is being computed, beside other work: its holes can be filled meanwhile.
  bool computing_curvature() const { return curvature_job_ != nullptr; }
  /// What work on patches of this scan shares.
  ScanContextPtr context_of(int scan);

  void open(const QStringList& paths, OpenMode mode);
  void open_sample();
  void close_scan(int scan);
  /// A surface that was made comes, in place of these scans and their patches; can be undone.
  void replace_scans(const std::vector<int>& gone, const OpenedScanPtr& come, const QString& text);
  /// Surfaces that were made, as another scene. Nothing of it counts as work.
  void open_made(const std::vector<OpenedScanPtr>& scans);
  /// Where a scan of it is not found, scan_missing() is emitted and nothing changes.
  void open_session(const SessionFile& session);
  void save_session(const QString& path, KeepScans keep = KeepScans::outside);
  /// All scans and patches as one mesh; the format follows the extension. Patches that cut are left out unless accepted.
  void export_to(const QString& path, const ExportChoice& choice = {});

  /// Loops that have a patch already are passed over.
  void fill(const std::set<int>& loops, const FillChoice& choice);
  /// Computes what fill() would do and shows it as a ghost. A later call replaces the earlier one.
  void preview_fill(const std::set<int>& loops, const FillChoice& choice);
  void drop_fill_preview();
  /// Each scan that has one of these loops, or all scans where there are none, is replaced by a repaired one without patches; can
  /// be undone. A trim or a stitch is proposed first. Where there is nothing to repair, a notice says so.
  void repair_scans(ScanRepair what, const std::set<int>& loops);
  /// ScanRepair::repair of these defects, in all scans.
  void repair(const std::set<Defect>& defects);
  /// ScanRepair::turn_around of one scan.
  void turn_around(int scan);
  /// A strip between these soup points of a scan; as with_bridge() of the engine.
  void bridge(int scan, int soup_a, int soup_b);
  /// A base under a loop of the document; as with_base() of the engine.
  void build_base(int loop, double distance);
  /// One side of a plane goes, and the section is closed; patches become a part of the scan.
  void cut_by_plane(int scan, const CutPlane& plane);
  /// A bridge, and one of the two holes that it makes filled and smoothed: one change for undo.
  void fill_part(const HolePart& part, const FillAndSmooth& how);
  /// Takes away all faces with a corner at one of these points: of the scan's soup, its patches' own after them. With `then`,
  /// the holes that this makes are filled and smoothed: one change for undo.
  void erase(int scan, const std::vector<int>& points, const std::optional<FillAndSmooth>& then);
  void evolve(const std::set<int>& patch_ids, EvolutionOptions options, Pace pace);
  /// Fills the loops, then takes their patches and these others to the steady state: one change for undo.
  void fill_and_smooth(const std::set<int>& loops, const std::set<int>& patch_ids, const FillChoice& choice,
                       const EvolutionOptions& options);
  void pause();
  /// Comes back at once; what was accepted so far stays and can be undone.
  void cancel();

  /// A patch that was made elsewhere comes into its loops, in place of what is there; tested for cuts first.
  void adopt(OpenPatch patch);
  /// How these loops are closed when they are filled next, whatever the options are; empty: as the options say.
  void choose_shape(const std::set<int>& loops, const std::optional<SeamContinuity>& shape);
  /// What all lengths are measured in; empty: not known. Nothing is converted.
  void choose_unit(const std::string& unit);
  void set_acceptance(const std::set<int>& patch_ids, Acceptance acceptance);
  void reject(const std::set<int>& patch_ids);
  /// Shows the state at this place of each patch's timeline; end_scrub() makes it a change that can be undone.
  void scrub_to(const std::set<int>& patch_ids, std::size_t place);
  void end_scrub();

  /// How the scene is looked at, for sessions.
  void set_view_source(ViewSource view) { view_ = std::move(view); }
  void set_timeline_budget(std::size_t bytes) { timeline_budget_ = bytes; }
  /// For the end of the program. @returns whether every worker has ended.
  bool shut_down(std::chrono::milliseconds at_most);

 Q_SIGNALS:
  void activity_changed();
  void stage_changed(const QString& words);
  void done_so_far(const QString& words);      ///< while a scan is repaired; empty: nothing yet
  void progress_changed(int done, int total);  ///< total 0: not known
  void share_done(double share);               ///< of the work, 0..1; only where it is known
  void seconds_left(double seconds);           ///< an estimate where no share is known
  void flow_ended(RunEnd end);
  void preview_ready(SurfaceShapePtr shape);
  void preview_dropped();
  void ghosts_changed(std::vector<SurfaceShapePtr> ghosts);
  /// The largest of the holes that were to be filled has its patch, from which a flow may follow; at the end, those among them
  /// that are to be looked at first.
  void filled(const std::set<int>& loops);
  /// Patches would be lost, or many holes made; without an answer nothing changes.
  void repair_questioned(const RepairQuestion& question);
  /// A trim or a stitch is computed; without an answer nothing changes.
  void repair_proposed(const RepairQuestion& question);
  void repaired(const QString& words);  ///< what was done to scans
  /// Why a repair changed nothing of a scan, or of any.
  void nothing_repaired(const QString& words);
  void left_open(const QString& words);  ///< holes that could not be filled
  void failed(const QString& words);
  void notice(const QString& words);
  void logged(const QString& words);
  void holes_made(const std::set<int>& loops);  ///< by erasing or bridging: what a person has in mind now
  void file_opened(const QString& path);        ///< a scan or a session
  void session_saved(const QString& path);      ///< or restored from there
  void scan_missing(const SessionFile& session, const QString& scan);  ///< the place that the session names
  void view_restored(const SessionView& view);

 private:
  struct Restored;
  struct FillPreview {
    std::set<int> loops;
    FillChoice choice;
    PatchRuns runs;
    FillOutcome outcome;
  };
  /// Loops to be filled and, where there is a flow, patches that it takes to the steady state with them.
  struct FillRequest {
    std::set<int> loops;
    FillChoice choice{};
    std::set<int> patch_ids{};
    std::optional<EvolutionOptions> flow{};
    Pace pace = Pace::steady;
    PatchChange::Joining joining = PatchChange::Joining::none;
  };

  bool is_done(const OpenPatch& patch, const EvolutionOptions& flow) const;
  /// A flow, or its place, is no other shape where that was chosen for the loop.
  EvolutionOptions flow_at(int loop, EvolutionOptions flow) const;
  /// Whether a patch is made afresh rather than moved on: no flow has moved it, or it was made in another shape.
  bool starts_anew(const OpenPatch& patch, const std::optional<EvolutionOptions>& flow) const;
  /// Leaves what cannot be filled, or moved, out of the request.
  FillRun fill_run(FillRequest& request);
  void add_other_patches(int scan, FillTask& task) const;
  void start_fill(FillRequest request);
  void start_steps(const std::set<int>& patch_ids, EvolutionOptions options, Pace pace);
  JobPtr begin_run(Activity activity, const QString& stage, const std::set<int>& loops, PatchChange::Joining joining);
  JobPtr begin(Activity activity, const QString& stage);
  void end();
  void report_failure(const QString& words);
  /// The job has failed.
  void give_up(const QString& text);
  void run_repair(ScanRepair what, std::vector<ScanRepairTask> tasks, const std::optional<FillAndSmooth>& then = {});
  void show_repair_step(const QString& title, const RepairStep& step);
  void show_share(double share);
  struct Repairs {
    std::vector<RepairedScan> scans;
    std::shared_ptr<const DefectPlaces> places;  ///< where it is shown before it is done
  };
  void on_repaired(const Repairs& repairs, ScanRepair what, const std::optional<FillAndSmooth>& then);
  void apply_repaired(const std::vector<RepairedScan>& all, ScanRepair what, const std::optional<FillAndSmooth>& then);
  /// @returns its loops that are to be filled.
  std::set<int> take_repaired(const RepairedScan& repaired);
  void keep_unit(const std::vector<int>& gone, int come);
  void keep_shapes(int gone, int come);
  void load(const QStringList& paths, OpenMode mode, const QString& stage);
  /// The former scene comes back.
  void drop_preview();
  int on_opened(const OpenedScanPtr& scan, OpenMode mode);
  void show_color(const OpenedScanPtr& scan, SurfaceShapePtr shape);
  void add_curvature(const OpenedScanPtr& scan, const JobPtr& job);
  void compute_next_curvature();
  void cancel_curvature();
  Restored restore(const SessionFile& file, const JobPtr& job) const;
  void on_restored(Restored restored, const QString& path, const QString& shown_as);
  void on_judged(OpenPatch patch, PatchStatePtr state);
  void on_exported(const ExportResult& result, const QString& path, ExportChoice::Content content);
  void show_running();
  void take_records();
  void on_run_ended(const FillOutcome& outcome);
  void announce_first_to_look_at(const std::set<int>& loops);
  void note_time(const std::set<int>& loops, double seconds);
  void say_outcome(const FillOutcome& outcome);
  void record_run();
  void log_run(const std::vector<PatchChange::Pair>& changes);
  QString run_words(const PatchState* before, const OpenPatch& now) const;
  void push(std::vector<PatchChange::Pair> pairs, const QString& text,
            PatchChange::Joining joining = PatchChange::Joining::none);

  Document& document_;
  UndoHistory& undo_;
  WriteTurns writing_;
  TaskRunner tasks_;
  Activity activity_ = Activity::idle;
  JobPtr job_;
  JobPtr preview_job_;
  JobPtr curvature_job_;
  std::deque<OpenedScanPtr> without_curvature_;  ///< large scans whose turn has not come
  std::shared_ptr<FillPreview> preview_;
  QElapsedTimer clock_;
  std::shared_ptr<RunRecorder> recorder_;
  std::optional<DocumentRun> run_;
  std::set<int> run_loops_,
      fill_loops_,       ///< of these, those to be filled
      announced_later_;  ///< of the present run; of these, new ones until the largest has its patch
  std::map<int, EvolutionSession> sessions_;
  std::map<int, ScanContextPtr> scan_contexts_;
  std::map<int, OpenPatch> scrub_start_;
  QString run_name_;
  PatchChange::Joining run_joining_ = PatchChange::Joining::none;
  ViewSource view_;
  double seconds_per_vertex_;  ///< of the last large patch
  std::size_t timeline_budget_ = std::size_t{256} << 20;
};

}  // namespace loopmend
