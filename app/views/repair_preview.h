// SPDX-License-Identifier: GPL-3.0-or-later
// What a trim or a stitch would change, marked in the view, and the question whether it shall.
#pragma once

#include "jobs/fill_controller.h"

#include <QObject>

namespace loopmend {

class Banner;
class Document;
class MeshView;

class RepairPreview : public QObject {
  Q_OBJECT

 public:
  RepairPreview(const Document& document, Banner& banner, MeshView& view, QObject* parent);

  void show(const RepairQuestion& question);

 private:
  /// Flies to a place of it, and asks.
  void show_place(const RepairQuestion& question, std::size_t at);
  /// The question is answered, or another message has taken its place, or the scene is another one.
  void drop();

  Banner& banner_;
  MeshView& view_;
  QString asked_;  ///< what the banner says of it; empty: nothing is asked
};

}  // namespace loopmend
