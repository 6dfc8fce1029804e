// SPDX-License-Identifier: GPL-3.0-or-later
// Which pieces of the scans, and which patches, are hidden from the picture. Nothing else heeds it: what is hidden is filled,
// checked and exported like the rest.
#pragma once

#include "document/document.h"

#include <QObject>

#include <set>

namespace loopmend {

/// A piece of a scan of the document.
struct PieceId {
  int scan = 0;
  int piece = 0;  ///< index into ScanPieces::list
  auto operator<=>(const PieceId&) const = default;
};

class SceneVisibility : public QObject {
  Q_OBJECT

 public:
  explicit SceneVisibility(const Document& document, QObject* parent = nullptr);

  enum class Visible { shown, hidden };

  /// How many pieces the scan has; at least one.
  int piece_count(int scan) const;
  PieceId piece_of_loop(int loop) const;
  bool is_hidden(const PieceId& piece) const { return hidden_.contains(piece); }
  bool is_hidden_loop(int loop) const { return is_hidden(piece_of_loop(loop)); }
  /// By itself, or with all the pieces that it closes holes of.
  bool is_hidden_patch(const OpenPatch& patch) const;
  /// A vertex of the scan's view.
  bool is_hidden_vertex(int scan, int vertex) const;
  /// Of what is in the scene now.
  bool hides_pieces_of(int scan) const;
  int hidden_count() const;

  void set_pieces(const std::set<PieceId>& pieces, Visible visible);
  void set_patches(const std::set<int>& ids, Visible visible);
  /// Everything else is hidden; the patches of these pieces are shown.
  void isolate(const std::set<PieceId>& pieces);
  void show_all();

 Q_SIGNALS:
  void changed();

 private:
  void follow_scans();
  void hide_heirs(int scan);

  const Document& document_;
  std::set<PieceId> hidden_;
  std::set<int> hidden_patches_;
  std::set<int> known_scans_;
};

}  // namespace loopmend
