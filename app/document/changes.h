// SPDX-License-Identifier: GPL-3.0-or-later
// The undoable changes of a document. Each knows how much memory only it may hold, and can let go of it.
#pragma once

#include "document/document.h"

#include <QUndoCommand>

#include <optional>

namespace loopmend {

class Change : public QUndoCommand {
 public:
  using QUndoCommand::QUndoCommand;
  /// Bytes that this change may keep alive, without what `seen` holds already; adds to `seen`.
  virtual std::size_t held_bytes(std::set<const void*>& seen) const = 0;
  /// After this it can no longer be undone or redone.
  virtual void forget() = 0;
  virtual bool forgotten() const = 0;
};

/// Patches came, went, moved, or were accepted.
class PatchChange : public Change {
 public:
  struct Pair {
    std::optional<OpenPatch> before, after;
  };
  /// Whether it is taken back together with the patch change before it.
  enum class Joining { none, previous };
  PatchChange(Document& document, std::vector<Pair> pairs, const QString& text, Joining joining = Joining::none);
  void undo() override;
  void redo() override;
  int id() const override { return 1; }
  bool mergeWith(const QUndoCommand* next) override;
  std::size_t held_bytes(std::set<const void*>& seen) const override;
  void forget() override { pairs_.clear(); }
  bool forgotten() const override { return pairs_.empty(); }
  Joining joining() const { return joining_; }
  /// The same change again, to be a part of another.
  std::unique_ptr<PatchChange> copy() const { return std::make_unique<PatchChange>(document_, pairs_, text()); }

 private:
  enum class Direction { back, forth };
  void go(Direction direction);

  Document& document_;
  std::vector<Pair> pairs_;
  Joining joining_;
};

/// A scan came or went.
class ScanChange : public Change {
 public:
  std::size_t held_bytes(std::set<const void*>& seen) const override;
  void forget() override { held_.reset(); }
  bool forgotten() const override { return held_ == nullptr; }

 protected:
  ScanChange(Document& document, int scan, const QString& text);

  Document& document_;
  int scan_;
  std::shared_ptr<OpenedScan> held_;
};

/// A scan was added to the scene.
class AddScan : public ScanChange {
 public:
  /// The scan is in the document already; redo() puts it there again after an undo().
  AddScan(Document& document, int scan, const QString& text) : ScanChange(document, scan, text) {}
  void undo() override { document_.take_scan(scan_); }
  void redo() override;
};

/// A scan was taken away, with the patches in its holes.
class CloseScan : public ScanChange {
 public:
  CloseScan(Document& document, int scan, const QString& text);
  void undo() override;
  void redo() override;

 private:
  std::vector<OpenPatch> patches_;
};

/// What the lengths of scans are measured in.
class ChooseUnits : public Change {
 public:
  /// @param after  by scan
  ChooseUnits(Document& document, std::map<int, std::string> after, const QString& text);
  void undo() override { document_.set_chosen_units(before_); }
  void redo() override { document_.set_chosen_units(after_); }
  std::size_t held_bytes(std::set<const void*>&) const override { return 0; }
  void forget() override { forgotten_ = true; }
  bool forgotten() const override { return forgotten_; }

 private:
  Document& document_;
  std::map<int, std::string> before_, after_;
  bool forgotten_ = false;
};

/// How the patches of loops meet the scan.
class ChooseShapes : public Change {
 public:
  /// @param after  by loop
  ChooseShapes(Document& document, std::map<int, SeamContinuity> after, const QString& text);
  void undo() override { document_.set_chosen_shapes(before_); }
  void redo() override { document_.set_chosen_shapes(after_); }
  std::size_t held_bytes(std::set<const void*>&) const override { return 0; }
  void forget() override { forgotten_ = true; }
  bool forgotten() const override { return forgotten_; }

 private:
  Document& document_;
  std::map<int, SeamContinuity> before_, after_;
  bool forgotten_ = false;
};

/// Several changes that are one for the person: done in their order, undone backwards. Takes up patch changes that are joined to it.
class ChangeGroup : public Change {
 public:
  ChangeGroup(std::vector<std::unique_ptr<Change>> parts, const QString& text);
  void undo() override;
  void redo() override;
  int id() const override { return 1; }
  bool mergeWith(const QUndoCommand* next) override;
  std::size_t held_bytes(std::set<const void*>& seen) const override;
  void forget() override;
  bool forgotten() const override;

 private:
  std::vector<std::unique_ptr<Change>> parts_;
};

}  // namespace loopmend
