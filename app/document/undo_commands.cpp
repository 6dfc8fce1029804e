#include "document/undo_commands.h"

namespace loopmend {

FillCommand::FillCommand(Document& document, std::vector<OpenPatch> patches, const QString& text)
    : QUndoCommand(text),
      document_(document),
      patches_(std::move(patches)) {}

void FillCommand::redo() { document_.add_patches(patches_); }

void FillCommand::undo() {
  std::vector<int> ids;
  for (const OpenPatch& patch : patches_) ids.push_back(patch.id);
  document_.remove_patches(ids);
}

EvolveCommand::EvolveCommand(Document& document, std::vector<Change> changes, const QString& text)
    : QUndoCommand(text),
      document_(document),
      changes_(std::move(changes)) {}

void EvolveCommand::redo() {
  std::map<int, PatchStatePtr> states;
  for (const Change& change : changes_) states[change.id] = change.after;
  document_.set_states(states);
}

void EvolveCommand::undo() {
  std::map<int, PatchStatePtr> states;
  for (const Change& change : changes_) states[change.id] = change.before;
  document_.set_states(states);
}

}  // namespace loopmend
