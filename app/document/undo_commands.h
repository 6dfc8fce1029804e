// The undoable changes of a document.
#pragma once

#include "document/document.h"

#include <QUndoCommand>

namespace loopmend {

/// Patches appear; undo takes them away again.
class FillCommand : public QUndoCommand {
 public:
  FillCommand(Document& document, std::vector<OpenPatch> patches, const QString& text);
  void undo() override;
  void redo() override;

 private:
  Document& document_;
  std::vector<OpenPatch> patches_;
};

/// A flow took patches from one state to another.
class EvolveCommand : public QUndoCommand {
 public:
  struct Change {
    int id = 0;
    PatchStatePtr before, after;
  };
  EvolveCommand(Document& document, std::vector<Change> changes, const QString& text);
  void undo() override;
  void redo() override;

 private:
  Document& document_;
  std::vector<Change> changes_;
};

}  // namespace loopmend
