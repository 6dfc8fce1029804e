// SPDX-License-Identifier: GPL-3.0-or-later
// What became of the holes of a scene, as a page for people.
#pragma once

#include "document/document.h"

#include <QImage>
#include <QString>
#include <QStringList>

#include <memory>
#include <vector>

namespace loopmend {

struct FillReport {
  /// A hole with a patch.
  struct Hole {
    int loop = 0;
    QString name;       ///< "Hole 3"
    QString verdict;    ///< "good", "look", "bad", or the state of a patch without a verdict
    QString color;      ///< of the verdict, "#2f855a"
    QStringList lines;  ///< sentences: what to look at first, then size, seam, likely error, what was added
    QImage picture;     ///< null: there is none
  };
  QString title;
  /// How much the patches add is measured as the page is made, not in the window's thread.
  std::vector<std::shared_ptr<const SurfaceModel>> models;
  std::vector<Points> laid;  ///< of each model
  std::vector<PatchStatePtr> patches;
  QStringList facts;  ///< more sentences on the whole scene
  std::vector<Hole> holes;
  QStringList open;     ///< sentences, one for each loop without a patch
  QString command;      ///< that repeats the patches; empty: there is none
  QStringList remarks;  ///< what the command does not repeat
};

/// Holes that a person should look at come first: bad, look, not judged, good; among these the largest. Pictures are empty.
FillReport fill_report(const Document& document);

enum class PictureLinks {
  within,  ///< the page needs no other file
  named    ///< "picture:N" for the hole at place N, where other programs than a browser look for it
};
/// Understood by browsers and by QTextDocument. Takes a while for large scans.
QString html_of(const FillReport& report, PictureLinks links);

}  // namespace loopmend
