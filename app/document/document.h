// SPDX-License-Identifier: GPL-3.0-or-later
// What is open: scans, their loops, the patches made so far. Changes come through the undo commands and the controller.
#pragma once

#include "document/length_unit.h"
#include "document/opened_scan.h"
#include "document/patch_state.h"

#include <QObject>

#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace loopmend {

enum class HoleState {
  open,
  left_out,
  filled,
  running,
  stepped,
  converged,
  early_stop,
  stalled,
  cutting,
  accepted,
  failed,
  faired,
  look,  ///< sound; a person should look at it
  bad    ///< has a hard fault
};

/// Whether the outer rim of an open sheet counts as something to fill.
enum class OuterRims { leave, include };

/// Scans and loops are named by indices that stay the same as long as the scene lives, also while a scan is taken away.
class Document : public QObject {
  Q_OBJECT

 public:
  using QObject::QObject;

  bool has_scan() const;
  /// Those with patches, a chosen unit or chosen shapes, or that were made here: what would be lost without saving.
  std::vector<int> scans_with_work() const;
  bool has_work() const;
  /// Indices of the scans that are there.
  std::vector<int> scans() const;
  /// Null when it was taken away.
  std::shared_ptr<const OpenedScan> scan(int index) const;
  /// The first one. There must be one.
  const OpenedScan& first_scan() const;
  /// What positions in the scene are relative to: the same for all scans.
  const Vec3& origin() const { return origin_; }

  const std::vector<BoundaryLoop>& loops() const { return loops_; }
  int loop_count() const { return static_cast<int>(loops_.size()); }
  const BoundaryLoop& loop(int index) const { return loops_[index]; }
  int scan_of(int loop) const { return scan_of_loop_[loop]; }
  int first_loop_of(int scan) const { return slots_[scan].first_loop; }
  /// Whether the loop's scan is there.
  bool present(int loop) const;

  const std::vector<OpenPatch>& patches() const { return patches_; }
  const OpenPatch* patch(int id) const;
  const OpenPatch* patch_of(int loop) const;

  HoleState state(int loop) const;
  /// Why it failed, or what else the engine has to say, may be empty.
  Message message(int loop) const;
  /// On the part of its patch; null where there is no patch, or nothing has judged it.
  const Verdict* verdict(int loop) const;
  /// Mesh units; not known where there is no patch, or no estimate.
  ExpectedDeviation deviation(int loop) const;
  /// Whether a person should look at it: a fault, a doubt, or a hole that could not be filled.
  bool to_look_at(int loop) const;
  /// A hole, or a loop that touches itself; the outer rim when it is included. Others are left out unless selected.
  bool fillable(int loop) const;
  OuterRims outer_rims() const { return outer_rims_; }
  void set_outer_rims(OuterRims rule);

  /// Takes everything away, for good.
  void clear();
  /// Everything goes until bring_back(), or for good with clear(): another scene is drawn already.
  void set_aside();
  void bring_back();
  /// @returns its index.
  int add_scan(std::shared_ptr<OpenedScan> scan);
  void take_scan(int index);
  void put_scan(int index, std::shared_ptr<OpenedScan> scan);
  std::shared_ptr<OpenedScan> held_scan(int index) const { return slots_[index].scan; }
  void set_shape(int scan, SurfaceShapePtr shape);

  /// As chosen, else as the scan's file has it; empty: not known.
  std::string unit(int scan) const;
  /// That of all scans; empty where they disagree or one is not known.
  std::string unit() const;
  /// By scan, those that a person has chosen.
  const std::map<int, std::string>& chosen_units() const { return units_; }
  void set_chosen_units(const std::map<int, std::string>& units);

  /// What a person says of sharp edges across the holes of a scan; of the scan as it is, not kept in sessions.
  const EdgeEdits& edge_edits(int scan) const;
  void set_edge_edits(int scan, EdgeEdits edits);
  /// In which holes of a scan are filled by a copy of the other side, where that fits; not kept in sessions.
  std::optional<MirrorPlane> mirror_plane(int scan) const;
  void set_mirror_plane(int scan, const std::optional<MirrorPlane>& plane);

  /// How the patches of loops meet the scan, where that was chosen for the loop itself; by loop.
  const std::map<int, SeamContinuity>& chosen_shapes() const { return shapes_; }
  std::optional<SeamContinuity> chosen_shape(int loop) const;
  void set_chosen_shapes(const std::map<int, SeamContinuity>& shapes);

  int next_patch_id() { return next_id_++; }
  /// Patches by these ids go, those in `now` come or are shown again.
  void replace(const std::vector<int>& gone, const std::vector<OpenPatch>& now);
  /// New states by patch id. Says patch_moved() for each, and holes_changed() once if a state's name or words changed.
  void set_states(const std::map<int, PatchStatePtr>& states);
  void set_timeline(int id, TimelinePtr timeline);
  void set_running(const std::set<int>& ids);
  bool is_running(int patch_id) const { return running_.contains(patch_id); }
  void add_failures(const std::map<int, Message>& by_loop);
  void forget_failures(const std::set<int>& loops);

 Q_SIGNALS:
  void opened();         ///< another scene: everything is new
  void scans_changed();  ///< a scan came or went
  void shape_changed(int scan);
  void patches_changed();
  void patch_moved(int id);
  void running_changed();  ///< which patches is_running() names
  void timeline_changed(int id);
  void units_changed();
  void edge_edits_changed();
  void holes_changed();  ///< some hole's state() or message() is another, or what is fillable()

 private:
  struct Slot {
    std::shared_ptr<OpenedScan> scan;
    int first_loop = 0;
  };
  /// What was set aside.
  struct Aside {
    std::vector<Slot> slots;
    std::vector<BoundaryLoop> loops;
    std::vector<int> scan_of_loop;
    Vec3 origin = Vec3::Zero();
    std::vector<OpenPatch> patches;
    std::map<int, Message> failures;
    std::map<int, std::string> units;
    std::map<int, EdgeEdits> edge_edits;
    std::map<int, MirrorPlane> mirror_planes;
    std::map<int, SeamContinuity> shapes;
  };
  void index_patches();
  void swap_with(Aside& other);

  std::optional<Aside> aside_;
  std::vector<Slot> slots_;
  std::vector<BoundaryLoop> loops_;
  std::vector<int> scan_of_loop_;
  Vec3 origin_ = Vec3::Zero();
  std::vector<OpenPatch> patches_;
  std::map<int, std::size_t> patch_by_id_, patch_by_loop_;
  std::set<int> running_;
  std::map<int, Message> failures_;
  std::map<int, std::string> units_;
  std::map<int, EdgeEdits> edge_edits_;
  std::map<int, MirrorPlane> mirror_planes_;
  std::map<int, SeamContinuity> shapes_;
  OuterRims outer_rims_ = OuterRims::leave;
  int next_id_ = 1;
};

}  // namespace loopmend
