// What is open: one scan, its loops, the patches made so far. Changes come through the undo commands and the workbench.
#pragma once

#include "document/patch_state.h"
#include "io/read_mesh.h"
#include "mesh/boundary_loops.h"

#include <QObject>
#include <QString>

#include <map>
#include <memory>
#include <set>
#include <string>
#include <vector>

namespace loopmend {

/// A scan as the worker prepared it. Never changes once it is open; `shape` and `range` come again with H.
struct OpenedScan {
  QString path;
  ImportReport import;
  std::shared_ptr<const SurfaceModel> model;
  std::vector<BoundaryLoop> loops;
  Vec3 origin = Vec3::Zero();
  std::shared_ptr<const SurfaceShape> shape;
};

enum class HoleState { open, left_out, filled, running, stepped, converged, failed };

class Document : public QObject {
  Q_OBJECT

 public:
  using QObject::QObject;

  bool has_scan() const { return scan_ != nullptr; }
  const OpenedScan& scan() const { return *scan_; }
  const std::vector<BoundaryLoop>& loops() const;
  const std::vector<OpenPatch>& patches() const { return patches_; }
  const OpenPatch* patch(int id) const;
  const OpenPatch* patch_of(int loop) const;

  HoleState state(int loop) const;
  /// Why it failed, or what the engine has to say; may be empty.
  QString message(int loop) const;
  /// Can be filled at all: a hole, or a loop that touches itself. Rims and cuts are left out unless selected by hand.
  bool fillable(int loop) const;

  /// Replaces everything.
  void open(OpenedScan scan);
  void set_shape(std::shared_ptr<const SurfaceShape> shape);
  int next_patch_id() { return next_id_++; }
  void add_patches(const std::vector<OpenPatch>& patches);
  void remove_patches(const std::vector<int>& ids);
  /// New states by patch id. Says patch_moved() for each, and holes_changed() once if a state's name or words changed.
  void set_states(const std::map<int, PatchStatePtr>& states);
  void set_running(const std::set<int>& ids);
  void set_failures(const std::map<int, std::string>& words_by_loop);

 Q_SIGNALS:
  void opened();
  void shape_changed();
  void patches_changed();
  void patch_moved(int id);
  void holes_changed();  ///< some hole's state() or message() is another

 private:
  std::unique_ptr<OpenedScan> scan_;
  void index_patches();

  std::vector<OpenPatch> patches_;
  std::map<int, std::size_t> patch_by_id_, patch_by_loop_;
  std::set<int> running_;
  std::map<int, std::string> failures_;
  int next_id_ = 1;
};

}  // namespace loopmend
